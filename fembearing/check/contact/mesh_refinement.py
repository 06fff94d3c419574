"""A contact on plain levels of a recipe: refined until the accuracy is reached, then extrapolated."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from analytic.progress import Progress
from analytic.scene import Contact
from fembearing.check.contact.mesh_seconds import about, predicted_seconds
from fembearing.check.contact.meshed_region import (
    each_side,
    far_boundary,
    has_sides,
    measured,
    sides_farther,
    with_sides,
)
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.grid_convergence import FINEST, HALF, LEAST, UNSTEADY, Estimate, estimate, mesh_allowed
from fembearing.mesh.recipe import Recipe

Estimates = dict[str, Estimate]
# How the error of the meshes was removed: by twins of half spaces on the same cells, or by extrapolation alone
Refinement = Literal["twin", "levels"]

# A quantity's error falls with this power of the cell size: the approach is an energy and has twice the order of
# quadratic cells; semi-axes have order 3 on cells that follow the edge. Peak pressure has no steady order.
FORMAL_ORDERS: dict[str, float | None] = {
    "semi_axis_rolling": 3.0,
    "semi_axis_transverse": 3.0,
    "peak_pressure": None,
    "approach": 4.0,
    "stiffness": 4.0,
}
COMPARED = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")  # stiffness follows from the last
# Relative: the edge of the strip next to a shoulder cuts through cells. The third level differs from boundary elements
# by 2.6 % at most, over three shoulders (validation/benchmarks/calibrations.py).
STRIP_LEAST = 0.03
# A level costs about a quarter of the next, whose interval also needs it: it is skipped only where its predicted
# uncertainty exceeds the limit by more than this factor. The prediction is up to twice too large for the peak pressure,
# whose error changes sign.
WORTH_A_TRY = 2.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """Meshes from coarse to fine, and each quantity with its uncertainty."""

    meshes: tuple[MeshSolution, ...]
    estimates: Estimates
    shoulder: Estimates  # keyed by the names of `ShoulderLoad`; empty where the contact ends before the shoulder
    refinement: Refinement


def solve_by_levels(
    contact: Contact,
    *,
    recipe: Recipe,
    accuracy: float,
    quantities: Sequence[str] = COMPARED,
    undecided: Callable[[Estimates], bool] = lambda _: False,
    progress: Progress,
) -> Reference:
    """Solve `contact` on three levels of `recipe` or more.

    accuracy : required of the quantities, relative half-width
    quantities : names of those that must reach the accuracy
    undecided : whether a finer mesh is needed although the accuracy is reached
    The first two levels predict the level that reaches the accuracy; where it does not, finer ones follow.
    """
    progress(0.0, f"{contact.pair}: size of the contact")
    second = fitted_solution(contact, recipe=recipe)
    progress(0.2, f"{contact.pair}: far boundary")
    boundary = far_boundary(second, recipe=recipe)
    if has_sides(second, recipe=recipe):
        farther = sides_farther(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
        boundary = with_sides(boundary, second, *each_side(second, recipe=recipe), farther=farther)
    first = solve_on_mesh(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
    meshes, estimates = [first, second], {}
    allowed = {name: mesh_allowed(accuracy, domain=boundary[name].domain) for name in quantities}
    predicted = _predicted_level(meshes, recipe=recipe, allowed=allowed)
    finer = [level for level in recipe.levels if level >= predicted]
    for number, level in enumerate(finer):
        expected = about(predicted_seconds(level, known=meshes[-1]))
        progress(0.3 + 0.7 * number / len(finer), f"{contact.pair}: level {level}, {expected}")
        meshes.append(solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=second.pair.semi_axes))
        estimates = {name: replace(part, **vars(boundary[name])) for name, part in estimates_of(meshes).items()}
        accurate = all(estimates[name].mesh <= limit for name, limit in allowed.items())
        if accurate and (second.shoulder is not None or not undecided(estimates)):
            break
    shoulder = {name: part for name, part in estimates.items() if name not in FORMAL_ORDERS}
    return Reference(
        meshes=tuple(meshes),
        estimates={name: estimates[name] for name in FORMAL_ORDERS},
        shoulder=shoulder,
        refinement="levels",
    )


def estimates_of(meshes: Sequence[MeshSolution]) -> Estimates:
    """Each quantity from two meshes or more, coarse to fine, without the effect of the far boundary.

    At a shoulder that cuts the contact off the pressure is singular: no order of convergence is assumed.
    """
    sizes = [1 / mesh.level for mesh in meshes]
    table = [measured(mesh) for mesh in meshes]
    singular = meshes[-1].shoulder is not None
    estimates = {}
    for name in table[-1]:
        values = [row[name] for row in table]
        if not any(values):  # the centroid between two shoulders
            part = Estimate(values=tuple(values), order=None, richardson=None, mesh=0.0)
        else:
            order = None if singular else FORMAL_ORDERS[name]
            part = estimate(values, sizes, formal_order=order, singular=singular)
        estimates[name] = replace(part, mesh=max(part.mesh, STRIP_LEAST)) if name.startswith("strip") else part
    return estimates


def _predicted_level(meshes: Sequence[MeshSolution], *, recipe: Recipe, allowed: dict[str, float]) -> int:
    """The coarsest level from the third on that may reach the allowed mesh uncertainties; otherwise the finest."""
    coarse, fine = meshes
    if fine.shoulder is not None:  # no order is known to predict with
        return recipe.levels[2]
    for level in recipe.levels[2:-1]:
        for name, limit in allowed.items():
            formal = FORMAL_ORDERS[name]
            order = formal or UNSTEADY
            change = abs(getattr(coarse.quantities, name) / getattr(fine.quantities, name) - 1)
            error = change / ((fine.level / coarse.level) ** order - 1) * (fine.level / level) ** order
            if (HALF * error if formal else error + LEAST) + FINEST > WORTH_A_TRY * limit:
                break
        else:
            return level
    return recipe.levels[-1]
