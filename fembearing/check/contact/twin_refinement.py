"""A contact of true shape from two levels or more, each corrected by its twin of half spaces.

What a twin leaves of a mesh's error falls faster than the error itself: it is a tenth of the error on the first level
and a hundredth on the second. The corrected values of the last two levels are extrapolated.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

from analytic.progress import Progress
from analytic.scene import Contact
from fembearing.check.contact.mesh_refinement import COMPARED, FORMAL_ORDERS, Estimates, Reference
from fembearing.check.contact.mesh_seconds import about, predicted_seconds
from fembearing.check.contact.meshed_region import (
    Boundary,
    boundary_effect_with_twin,
    each_side,
    has_sides,
    sides_farther,
    with_sides,
)
from fembearing.check.contact.uncertainty import FARTHER_LEFT, FARTHER_LEFT_ON_SECOND, with_twin
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.twin import TwinSolution, twin_on_level
from fembearing.grid_convergence import Estimate, mesh_allowed, observed_order
from fembearing.mesh.recipe import Recipe

# Chosen on the calibration contacts of validation/intervals/twin.py, which tests them on others. ORDER: power of the
# cell size with which the error falls that a twin leaves, and those of two quantities that differ.
ORDER, ORDERS = 4.0, {"semi_axis_transverse": 5.0, "approach": 3.0}
# In bodies of true shape the error of the approach is that of their twin times 1 + SHAPED (c/r)^2, with the larger
# semi-axis c and the ball's radius r.
SHAPED = 0.8


def solve_by_twin(
    contact: Contact,
    *,
    recipe: Recipe,
    accuracy: float,
    quantities: Sequence[str],
    undecided: Callable[[Estimates], bool],
    progress: Progress,
) -> Reference | None:
    """Solve `contact` on two levels of `recipe` or more, each with its twin; arguments as those of `solve_reference`.

    The effects of far boundary and lands come from the first level, and from the second where that is not certain
    enough.
    None where a twin says nothing: the contact is cut off by a shoulder, or far from the ellipse expected.
    """
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
        if on_first and (any(estimates[name].total > accuracy for name in quantities) or undecided(estimates)):
            boundary, on_first = region(solutions[1], left=FARTHER_LEFT_ON_SECOND), False
            estimates = estimated()
        accurate = all(
            estimates[name].mesh <= mesh_allowed(accuracy, domain=estimates[name].domain) for name in quantities
        )
        if accurate and not undecided(estimates):
            break
    return Reference(
        meshes=tuple(solution.mesh for solution in solutions), estimates=estimates, shoulder={}, refinement="twin"
    )


def estimates_with_twin(solutions: Sequence[TwinSolution]) -> Estimates:
    """Each quantity from two levels or more, coarse to fine, without the effect of the far boundary."""
    before, last = solutions[-2:]
    shape = (max(last.mesh.pair.semi_axes) / last.mesh.contact.ball_radius) ** 2
    ratio = last.mesh.level / before.mesh.level
    limits, steps = {}, []
    for name in COMPARED:
        value = last.corrected[name]
        change = value - before.corrected[name]
        limits[name] = value + change / (ratio ** ORDERS.get(name, ORDER) - 1)
        steps.append(abs(change / value) / (ratio**ORDER - 1))
    limits["approach"] *= 1 + SHAPED * shape * (last.factors.approach - 1)
    limits["stiffness"] = last.mesh.contact.load / limits["approach"] ** 1.5
    shown = max(abs(getattr(last.factors, name) - 1) for name in COMPARED)
    mesh = with_twin(shape=shape, shown=shown, step=max(steps))
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
