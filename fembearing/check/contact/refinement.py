"""The finite-element reference of a contact, by the cheapest way that holds: twins of half spaces, or plain levels.

What a twin leaves of a mesh's error falls faster than the error itself: it is a tenth of the error on the first level
and a hundredth on the second. The corrected values of the last two levels are extrapolated.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

from analytic.progress import Progress, silent
from analytic.scene import Contact
from analytic.words import about
from fembearing.check.comparison import could_be_decided
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.meshed_region import (
    FARTHER_LEFT,
    FARTHER_LEFT_ON_SECOND,
    STIFFNESS,
    Boundary,
    boundary_effect_with_twin,
    each_side,
    far_boundary,
    has_sides,
    measured,
    sides_farther,
    with_sides,
)
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.pixel_contact import PixelSolution
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.fem.twin import TwinSolution, twin_on_level
from fembearing.grid_convergence import FINEST, HALF, LEAST, UNSTEADY, Estimate, estimate, mesh_allowed, observed_order
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
# Time of a level with N unknowns: set-up, cells, and the factorisation with its many right-hand sides, s; only their
# ratios matter. They were fitted to 24 solves of six random contacts on one machine.
FIXED, EACH, EACH_SQUARED = 0.1, 14e-6, 7.7e-10

# Chosen on the calibration contacts of validation/intervals/twin.py, which tests them on others. ORDER: power of the
# cell size with which the error falls that a twin leaves, and those of two quantities that differ.
ORDER, ORDERS = 4.0, {"semi_axis_transverse": 5.0, "approach": 3.0}
# In bodies of true shape the error of the approach is that of their twin times 1 + SHAPED (c/r)^2, with the larger
# semi-axis c and the ball's radius r.
SHAPED = 0.8
# Uncertainty of meshes with a twin: LEAST_WITH_TWIN, CURVED times (c/r)^2 and the largest error that the twin shows,
# and LEFT times the largest extrapolation of a quantity. UNSTEADY_PRESSURE is added for the peak pressure, which has no
# steady order.
LEAST_WITH_TWIN, CURVED, LEFT, UNSTEADY_PRESSURE = 1.5e-4, 0.3, 1.0, 1e-4


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


def solve_reference(contact: Contact, wanted: Wanted) -> Reference:
    """Solve `contact` on as many levels of the recipe as the accuracy needs.

    Contacts of true shape have a twin on each level. Plain levels follow where the twin does not hold: for the
    idealisation, which would be its own twin, for a sheet, which bends, and where a shoulder cuts the contact off.
    `Reference.refinement` says which was used.
    """
    by_twin = solve_by_twin(contact, wanted) if wanted.recipe.geometry == "real" else None
    return by_twin or solve_by_levels(contact, wanted)


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
    if has_sides(second, recipe=recipe):
        farther = sides_farther(contact, recipe=recipe, level=recipe.levels[0], semi_axes=second.pair.semi_axes)
        boundary = with_sides(boundary, second, *each_side(second, recipe=recipe), farther=farther)
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


def solve_by_twin(contact: Contact, wanted: Wanted) -> Reference | None:
    """Solve `contact` on two levels or more, each with its twin.

    The effects of far boundary and lands come from the first level, and from the second where that is not certain
    enough.
    None where a twin says nothing: the contact is cut off by a shoulder, or far from the ellipse expected.
    """
    recipe, progress = wanted.recipe, wanted.progress
    progress(0.0, f"{contact.pair}: size of the contact")
    coarse = twin_on_level(
        contact, recipe=recipe, level=recipe.levels[0], start=expected_semi_axes(contact, geometry="real")
    )
    if coarse is None:
        return None
    solutions, both, boundary, on_first, estimates = [coarse], (), {}, True, {}

    def region(on: TwinSolution, *, left: float) -> dict[str, Boundary]:
        """The effect of far boundary and true sides; left : share of the lands' that stays as uncertainty."""
        far = boundary_effect_with_twin(on, recipe=recipe)
        if not both:
            return far
        farther = sides_farther(contact, recipe=recipe, level=on.mesh.level, semi_axes=on.mesh.pair.semi_axes)
        return with_sides(far, solutions[1].mesh, *both, farther=farther, left=left)

    def estimated() -> Estimates:
        return {name: replace(part, **vars(boundary[name])) for name, part in estimates_with_twin(solutions).items()}

    finer = recipe.levels[1:]
    for number, level in enumerate(finer):
        expected = about(predicted_seconds(level, known=solutions[-1].mesh))
        progress(0.1 + 0.9 * number / len(finer), f"{contact.pair}: level {level}, {expected}")
        solution = twin_on_level(contact, recipe=recipe, level=level, start=solutions[-1].ellipse)
        if solution is None:
            return None
        solutions.append(solution)
        if not boundary:
            progress(0.2, f"{contact.pair}: far boundary")
            both = each_side(solution.mesh, recipe=recipe) if has_sides(solution.mesh, recipe=recipe) else ()
            boundary = region(coarse, left=FARTHER_LEFT)
        estimates = estimated()
        rough = any(estimates[name].total > wanted.accuracy for name in wanted.quantities)
        if on_first and (rough or wanted.leaves_undecided(contact, estimates)):
            boundary, on_first = region(solutions[1], left=FARTHER_LEFT_ON_SECOND), False
            estimates = estimated()
        if wanted.is_met(solution.mesh, estimates):
            break
    return Reference(
        meshes=tuple(solution.mesh for solution in solutions), estimates=estimates, shoulder={}, refinement="twin"
    )


def estimates_with_twin(solutions: Sequence[TwinSolution]) -> Estimates:
    """Each quantity from two levels or more, coarse to fine, without the effect of the far boundary."""
    before, last = solutions[-2:]
    shape = (max(last.mesh.pair.semi_axes) / last.mesh.contact.ball_radius) ** 2
    limits, mesh = extrapolated(
        before.corrected,
        last.corrected,
        finer=last.mesh.level / before.mesh.level,
        load=last.mesh.contact.load,
        curved=SHAPED * shape * (last.factors.approach - 1),
        left=CURVED * shape * max(abs(getattr(last.factors, name) - 1) for name in COMPARED),
    )
    sizes = [1 / solution.mesh.level for solution in solutions]
    estimates = {}
    for name in FORMAL_ORDERS:
        values = tuple(getattr(solution.mesh.quantities, name) for solution in solutions)
        estimates[name] = Estimate(
            values=values,
            order=observed_order(values[-3:], sizes[-3:]) if len(values) > 2 else None,
            richardson=limits[name],
            mesh=mesh[name],
            corrected=tuple(solution.corrected[name] for solution in solutions),
        )
    return estimates


def extrapolated(
    before: dict[str, float], last: dict[str, float], *, finer: float, load: float, curved: float, left: float
) -> tuple[dict[str, float], dict[str, float]]:
    """Each quantity for vanishing cells, and its relative uncertainty, from corrected meshes or pixels of two levels.

    finer : ratio of their cell sizes;  load : N
    curved, left : relative, what the shape of the bodies adds to the approach, and to the uncertainty
    """
    change = {name: last[name] - before[name] for name in COMPARED}
    limits = {name: last[name] + part / (finer ** ORDERS.get(name, ORDER) - 1) for name, part in change.items()}
    limits["approach"] *= 1 + curved
    limits["stiffness"] = load / limits["approach"] ** 1.5
    step = max(abs(part / last[name]) for name, part in change.items()) / (finer**ORDER - 1)
    uncertainty = LEAST_WITH_TWIN + left + LEFT * step
    mesh = {name: uncertainty * (STIFFNESS if name == "stiffness" else 1.0) for name in FORMAL_ORDERS}
    mesh["peak_pressure"] += UNSTEADY_PRESSURE
    return limits, mesh
