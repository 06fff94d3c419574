"""The finite-element reference of a contact: refined until the accuracy is reached, then extrapolated."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace

from analytic.scene import Contact
from fembearing.compare.contact.grid_convergence import FINEST, HALF, LEAST, UNSTEADY, Estimate, estimate
from fembearing.compare.contact.mesh_seconds import about, predicted_seconds
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.footprint import is_symmetric
from fembearing.mesh.recipe import Recipe
from fembearing.progress import Progress

Estimates = dict[str, Estimate]

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
# The effect of the far boundary falls with this power of the block's size: tests/compare/contact/test_discrepancy.py
# predicts a block 2.5 times as large from one 1.5 times as large. A pocket's seat is a cavity, not a half space: its
# approach grows with the logarithm of the size, without a limit.
FADING = 2.0
UNLIMITED_IN_A_SEAT = ("approach", "stiffness")
# The effect of the true sides, on the second level, differs from that on the third by at most this share of the largest
# effect of all quantities: 0.28 and less on three contacts with shoulders 1.3 to 1.75 semi-axes away.
SIDES_LEFT = 0.6
# Bound on that effect over (b/r)^2 b/s, where s is the distance of the nearer shoulder; below a tenth of the least
# uncertainty claimed it is not computed.
SIDES_BOUND, SIDES_LEAST = 0.1, 0.1 * FINEST


@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """Meshes from coarse to fine, and each quantity with its uncertainty."""

    meshes: tuple[MeshSolution, ...]
    estimates: Estimates
    shoulder: Estimates  # keyed by the names of `ShoulderLoad`; empty where the contact ends before the shoulder


def solve_reference(
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
    boundary = _far_boundary(second, recipe=recipe)
    if has_sides(second, recipe=recipe):
        whole = solve_on_mesh(contact, recipe=recipe, level=second.level, semi_axes=second.pair.semi_axes, whole=True)
        boundary = with_sides(boundary, second, whole)
    first = solve_on_mesh(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
    meshes, estimates = [first, second], {}
    allowed = {name: max(accuracy - boundary[name].domain, boundary[name].domain / 2) for name in quantities}
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
        meshes=tuple(meshes), estimates={name: estimates[name] for name in FORMAL_ORDERS}, shoulder=shoulder
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


def measured(mesh: MeshSolution) -> dict[str, float]:
    """All quantities of a solved mesh, with those at its shoulder."""
    return asdict(mesh.quantities) | ({} if mesh.shoulder is None else asdict(mesh.shoulder))


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


@dataclass(frozen=True, kw_only=True)
class Boundary:
    """The fields of an `Estimate` that the meshed region sets: its size, and that it is symmetric."""

    beyond: float = 0.0
    sides: float = 0.0
    domain: float = 0.0


def _far_boundary(mesh: MeshSolution, *, recipe: Recipe) -> dict[str, Boundary]:
    """The remaining effect of a block's far boundary on each quantity.

    It is 0 for half spaces: their far boundary is given the displacement of the half space, exact to the second moments
    of the pressure. It is 0 for a sheet, which has no such boundary.
    """
    if not has_boundary(mesh, recipe=recipe):
        return dict.fromkeys(measured(mesh), Boundary())
    larger = solve_on_mesh(
        mesh.contact, recipe=recipe, level=mesh.level, semi_axes=mesh.pair.semi_axes, extended=True, upper=mesh.upper
    )
    return boundary_effect(mesh, larger)


def has_sides(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether a quarter stands for a contact whose sides differ, by more than a tenth of the least uncertainty."""
    if mesh.pair.footprint.half or is_symmetric(mesh.contact) or recipe.geometry != "real":
        return False
    transverse = mesh.pair.semi_axes[1]
    return (
        SIDES_BOUND * (transverse / mesh.contact.ball_radius) ** 2 * transverse
        > SIDES_LEAST * mesh.contact.nearer_shoulder
    )


def with_sides(boundary: dict[str, Boundary], mesh: MeshSolution, whole: MeshSolution) -> dict[str, Boundary]:
    """The same with the effect of the true sides, from half of the contact on the cells of a quarter.

    Shoulders and lands of both sides change the contact by less than 0.3 %, and to first order each by itself.
    """
    quarter, half = measured(mesh), measured(whole)
    sides = {name: half[name] / value - 1 for name, value in quarter.items()}
    left = SIDES_LEFT * max(map(abs, sides.values()))
    return {name: replace(part, sides=sides[name], domain=part.domain + left) for name, part in boundary.items()}


def has_boundary(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether the lower body ends in a prescribed displacement that is only approximate."""
    return recipe.geometry != "hertzian" and mesh.pair.lower.far.size > 0


def boundary_effect(mesh: MeshSolution, larger: MeshSolution) -> dict[str, Boundary]:
    """The effect of the far boundary on each quantity, from a larger block with more cells all round.

    The larger block shows a part of the effect. The rest follows from the power with which it falls, and half of the
    whole stays as uncertainty. The approach into a seat is not corrected; its uncertainty assumes an effect that falls
    as one over the size.
    """
    size, further = (float(part.pair.lower.mesh.doflocs[0].max()) for part in (mesh, larger))
    before, after = measured(mesh), measured(larger)
    effects = {}
    for name, value in before.items():
        change = after[name] / value - 1 if value else 0.0
        if mesh.contact.pair == "pocket" and name in UNLIMITED_IN_A_SEAT:
            effects[name] = Boundary(domain=abs(change) / (1 - size / further))
        else:
            whole = change / (1 - (size / further) ** FADING)
            effects[name] = Boundary(beyond=whole, domain=abs(whole) / 2)
    return effects
