"""The greatest stresses under a contact, by Hertz's closed forms and by finite elements: where fatigue begins."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.contact.subsurface import subsurface_maximum
from fembearing.compare.contact.discrepancy import ContactSolution
from fembearing.compare.contact.uncertainty import FINEST, LEAST
from fembearing.fem.subsurface import Array, Side, SubsurfaceStress, subsurface_stress

STRESSES = ("max_shear", "max_von_mises")  # each with its "_depth"
NAMES: tuple[str, ...] = ("max_shear", "max_shear_depth", "max_von_mises", "max_von_mises_depth")
# A maximum is flat: meshes put it too near the surface or too deep, and two may agree by chance. How far off depths are
# on the third level and the fourth, validation/benchmarks/subsurface.py measures.
LEAST_DEPTH = 5e-3  # minor semi-axes


@dataclass(frozen=True, kw_only=True)
class SubsurfaceComparison:
    """Maxima on the contact's axis in one body, keyed by `NAMES`: Pa, and their depths, m."""

    side: Side  # "upper" the ball, "lower" the race or seat
    hertz: dict[str, float]
    fe: dict[str, float]  # on the finest mesh
    uncertainty: dict[str, float]  # half-widths, Pa and m: a depth may be 0, and no share of that

    def discrepancy(self, name: str) -> float | None:
        """Production over reference minus one; None for a depth where either has its maximum on the surface."""
        if 0.0 in (self.hertz[name], self.fe[name]):
            return None
        return self.hertz[name] / self.fe[name] - 1

    def exceeds(self, name: str) -> bool:
        """Whether production is outside the interval of the reference."""
        return abs(self.hertz[name] - self.fe[name]) > self.uncertainty[name]

    def to_json(self) -> dict[str, Any]:
        """Plain types, SI; discrepancies relative, uncertainties in Pa and m."""
        return {
            "side": self.side,
            "fe": self.fe,
            "uncertainty": self.uncertainty,
            "hertz": self.hertz,
            "discrepancy": {name: self.discrepancy(name) for name in NAMES},
            "exceeds_uncertainty": {name: self.exceeds(name) for name in NAMES},
        }


def compare_subsurface(solution: ContactSolution, *, side: Side = "lower") -> SubsurfaceComparison:
    """Both sides of the greatest shear and von Mises stress; solves one body of the last two meshes once more.

    The uncertainty of a stress is the last change, or 0.03 % where that is more; that of a depth the last change, or
    0.5 % of the minor semi-axis, or the way to another maximum which may be the greater one as far as the stresses are
    certain. The far boundary adds what it does to the peak pressure, and to depths what it does to the minor semi-axis.
    Raises InputError for half a contact, see `subsurface_stress`.
    """
    noun, hertz = solution.contact, solution.hertz
    material = noun.race_material if side == "lower" else noun.ball_material
    closed = subsurface_maximum(
        peak_pressure=hertz.peak_pressure,
        semi_axis_x=hertz.semi_axis_rolling,
        semi_axis_y=hertz.semi_axis_transverse,
        poisson_ratio=material.poisson_ratio,
    )
    coarse, fine = (subsurface_stress(mesh, side=side) for mesh in solution.meshes[-2:])
    before, found = _maxima(coarse), _maxima(fine)
    minor = min(("semi_axis_rolling", "semi_axis_transverse"), key=lambda name: getattr(solution.reference, name))
    boundary = {name: solution.estimates[name].domain for name in (minor, "peak_pressure")}
    uncertainty = {}
    for name, curve in zip(STRESSES, (fine.max_shear, fine.von_mises), strict=True):
        depth = f"{name}_depth"
        change = {each: abs(found[each] - before[each]) for each in (name, depth)}
        off = max(change[name], LEAST * found[name]) + (FINEST + boundary["peak_pressure"]) * found[name]
        tops = _tops(fine.depth, curve, least=found[name] - 2 * off)  # each of the two may be off
        away = float(np.abs(tops - found[depth]).max(initial=0.0))
        least = LEAST_DEPTH * getattr(solution.reference, minor)
        uncertainty |= {name: off, depth: max(change[depth], away, least) + boundary[minor] * found[depth]}
    return SubsurfaceComparison(
        side=side,
        hertz={name: float(getattr(closed, name)) for name in NAMES},
        fe=found,
        uncertainty=uncertainty,
    )


def _maxima(found: SubsurfaceStress) -> dict[str, float]:
    values = (
        found.greatest_shear,
        found.greatest_shear_depth,
        found.greatest_von_mises,
        found.greatest_von_mises_depth,
    )
    return dict(zip(NAMES, values, strict=True))


def _tops(depth: Array, values: Array, *, least: float) -> Array:
    """Depths of a curve's local maxima of `least` or more, the ends among them."""
    walled = np.concatenate([[-np.inf], values, [-np.inf]])
    is_top = (values >= walled[:-2]) & (values >= walled[2:]) & (values >= least)
    return depth[is_top]
