"""The finite-element reference of a contact on plain levels: three or more, which are extrapolated.

They take the idealisation, a sheet, which bends, and a contact that ends at its shoulder or within 5 % of it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

from analytic.progress import Progress, silent
from analytic.scene import Contact
from analytic.words import about
from fembearing.check.comparison import could_be_decided
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.meshed_region import far_boundary, measured
from fembearing.fem.pixel_contact import PixelSolution
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.grid_convergence import FINEST, HALF, LEAST, UNSTEADY, Estimate, estimate, mesh_allowed
from fembearing.mesh.recipe import Recipe

Estimates = dict[str, Estimate]
# Levels of the compliance of the pair, which takes the error of half spaces on the same cells off; or plain levels
Refinement = Literal["pair", "levels"]

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
# Time of a level with N unknowns: set-up, cells, and the factorisation with its many right-hand sides, s; only their
# ratios matter. They were fitted to 24 solves of six random contacts on one machine.
FIXED, EACH, EACH_SQUARED = 0.1, 14e-6, 7.7e-10


@dataclass(frozen=True, kw_only=True, eq=False)
class Reference:
    """Meshes from coarse to fine, and each quantity with its uncertainty."""

    meshes: tuple[MeshSolution, ...]
    estimates: Estimates
    shoulder: Estimates  # keyed by the names of `ShoulderLoad`; empty where the contact ends before the shoulder
    refinement: Refinement


class Wanted(NamedTuple):
    """What the reference of a contact must reach."""

    recipe: Recipe
    accuracy: float  # of the quantities, relative half-width
    quantities: Sequence[str] = COMPARED  # names of those that must reach it
    tolerance: float | None = None  # of a verdict on Hertz that a finer mesh shall decide, relative; None: no verdict
    judged: Sequence[str] = tuple(FORMAL_ORDERS)  # names of the quantities that it is on
    progress: Progress = silent

    def leaves_undecided(self, contact: Contact, estimates: Estimates) -> bool:
        """Whether a finer mesh could decide a verdict although the accuracy is reached."""
        if self.tolerance is None:
            return False
        hertz = vars(hertz_quantities(contact))
        return any(could_be_decided(hertz[name], estimates[name], tolerance=self.tolerance) for name in self.judged)

    def is_met(self, mesh: MeshSolution | PixelSolution, estimates: Estimates) -> bool:
        """Whether the accuracy is reached and no verdict is open; at a shoulder, where Hertz is not judged, none is."""
        accurate = all(
            estimates[name].mesh <= mesh_allowed(self.accuracy, domain=estimates[name].domain)
            for name in self.quantities
        )
        return accurate and (mesh.shoulder is not None or not self.leaves_undecided(mesh.contact, estimates))


def predicted_seconds(level: int, *, known: MeshSolution) -> float:
    """Seconds to mesh and solve one level of a recipe; the machine's speed is that of the known solution.

    known : the largest mesh solved so far of the same contact and recipe
    The unknowns of a tensor grid refined in all directions grow as the cube of its level.
    """
    before, after = (
        FIXED + EACH * unknowns + EACH_SQUARED * unknowns**2
        for unknowns in (known.unknowns, known.unknowns * (level / known.level) ** 3)
    )
    return known.seconds * after / before


def solve_by_levels(contact: Contact, wanted: Wanted) -> Reference:
    """Solve `contact` on three plain levels or more.

    The first two levels predict the level that reaches the accuracy; where it does not, finer ones follow.
    """
    recipe, progress = wanted.recipe, wanted.progress
    progress(0.0, f"{contact.pair}: size of the contact")
    second = fitted_solution(contact, recipe=recipe)
    progress(0.2, f"{contact.pair}: far boundary")
    boundary = far_boundary(second, recipe=recipe)
    first = solve_on_mesh(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
    meshes, estimates = [first, second], {}
    allowed = {name: mesh_allowed(wanted.accuracy, domain=boundary[name].domain) for name in wanted.quantities}
    predicted = _predicted_level(meshes, recipe=recipe, allowed=allowed)
    finer = [level for level in recipe.levels if level >= predicted]
    for number, level in enumerate(finer):
        expected = about(predicted_seconds(level, known=meshes[-1]))
        progress(0.3 + 0.7 * number / len(finer), f"{contact.pair}: level {level}, {expected}")
        meshes.append(solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=second.pair.semi_axes))
        estimates = {name: replace(part, **vars(boundary[name])) for name, part in estimates_of(meshes).items()}
        if wanted.is_met(second, estimates):
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
