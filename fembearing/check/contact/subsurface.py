"""The greatest stresses under a contact, where fatigue begins: by Hertz's closed forms and by finite elements."""

from dataclasses import dataclass, replace

import numpy as np

from analytic.contact.subsurface import subsurface_maximum
from fembearing.check.comparison import Comparison, compared
from fembearing.check.contact.solution import ContactSolution
from fembearing.fem.subsurface import Array, Side, SubsurfaceStress, subsurface_stress
from fembearing.grid_convergence import FINEST, LEAST, UNSTEADY

STRESSES = ("max_shear", "max_von_mises")  # each with its "_depth"
NAMES: tuple[str, ...] = ("max_shear", "max_shear_depth", "max_von_mises", "max_von_mises_depth")
# A maximum is flat: its depth on a mesh is uncertain, and two meshes may agree by chance. The error of depths on the
# third and fourth level is measured by validation/benchmarks/subsurface.py.
LEAST_DEPTH = 5e-3  # minor semi-axes
COUNTED_RATIO = 1.5  # of cell sizes, from the second level to the third: over a larger one a change counts less


@dataclass(frozen=True, kw_only=True)
class SubsurfaceComparison:
    """Maxima on the contact's axis in one body by Hertz and on the finest mesh, keyed by `NAMES`: Pa, and depths, m."""

    side: Side  # "upper": the ball; "lower": the race or seat
    quantities: dict[str, Comparison]


def compare_subsurface(solution: ContactSolution, *, side: Side = "lower") -> SubsurfaceComparison:
    """Compare the greatest shear and von Mises stress; solves one body of the last two meshes again.

    The uncertainty of a stress is the last change, or 0.03 % if that is larger. From the first level to the second
    cells shrink more than between later ones; that change counts as if they shrank by a third, at order 3. The
    uncertainty of a depth is the largest of the last change, 0.5 % of the minor semi-axis, and the distance to another
    maximum that may be the greater one within the uncertainty of the stresses. The effect of the far boundary on the
    peak pressure is added to stresses, that on the minor semi-axis to depths. Raises InputError for half a contact, see
    `subsurface_stress`.
    """
    contact, hertz, reference = solution.contact, solution.numbers.hertz, solution.numbers.reference
    material = contact.race_material if side == "lower" else contact.ball_material
    closed = subsurface_maximum(
        peak_pressure=hertz.peak_pressure,
        semi_axis_x=hertz.semi_axis_rolling,
        semi_axis_y=hertz.semi_axis_transverse,
        poisson_ratio=material.poisson_ratio,
    )
    coarse, fine = (subsurface_stress(mesh, side=side) for mesh in solution.meshes[-2:])
    before, maxima = _maxima(coarse), _maxima(fine)
    ratio = solution.meshes[-1].level / solution.meshes[-2].level
    step = min(1.0, (COUNTED_RATIO**UNSTEADY - 1) / (ratio**UNSTEADY - 1))
    minor = min(("semi_axis_rolling", "semi_axis_transverse"), key=lambda name: getattr(reference, name))
    boundary = {name: solution.numbers.estimates[name].domain for name in (minor, "peak_pressure")}
    uncertainty = {}
    for name, curve in zip(STRESSES, (fine.max_shear, fine.von_mises), strict=True):
        depth = f"{name}_depth"
        change = {each: step * abs(maxima[each] - before[each]) for each in (name, depth)}
        off = max(change[name], LEAST * maxima[name]) + (FINEST + boundary["peak_pressure"]) * maxima[name]
        tops = _tops(fine.depth, curve, least=maxima[name] - 2 * off)  # each of the two may be off
        away = float(np.abs(tops - maxima[depth]).max(initial=0.0))
        least = LEAST_DEPTH * getattr(reference, minor)
        uncertainty |= {name: off, depth: max(change[depth], away, least) + boundary[minor] * maxima[depth]}
    found = {name: compared(float(getattr(closed, name)), maxima[name], uncertainty[name]) for name in NAMES}
    on_surface = {name: replace(each, discrepancy=None) for name, each in found.items() if each.production == 0}
    return SubsurfaceComparison(side=side, quantities=found | on_surface)


def _maxima(stress: SubsurfaceStress) -> dict[str, float]:
    return {name: getattr(stress, name.replace("max", "greatest")) for name in NAMES}


def _tops(depth: Array, values: Array, *, least: float) -> Array:
    """Depths of a curve's local maxima of `least` or more, its ends included."""
    walled = np.concatenate([[-np.inf], values, [-np.inf]])
    is_top = (values >= walled[:-2]) & (values >= walled[2:]) & (values >= least)
    return depth[is_top]
