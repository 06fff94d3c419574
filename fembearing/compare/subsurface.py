"""The greatest stresses under a contact, by Hertz's closed forms and by finite elements: where fatigue begins."""

from dataclasses import dataclass
from typing import Any

from analytic.subsurface import subsurface_maximum
from fembearing.compare.discrepancy import ContactSolution
from fembearing.compare.uncertainty import FINEST, LEAST
from fembearing.fem.subsurface import Side, subsurface_stress

NAMES = ("max_shear", "max_shear_depth", "max_von_mises", "max_von_mises_depth")


@dataclass(frozen=True, kw_only=True)
class SubsurfaceComparison:
    """Maxima on the contact's axis in one body, keyed by `NAMES`: Pa, and their depths, m."""

    side: Side  # "upper" the ball, "lower" the race or seat
    hertz: dict[str, float]
    fe: dict[str, float]  # on the finest mesh
    uncertainty: dict[str, float]  # relative half-widths, from the last two meshes and the far boundary

    def discrepancy(self, name: str) -> float:
        """Production over reference minus one."""
        return self.hertz[name] / self.fe[name] - 1

    def to_json(self) -> dict[str, Any]:
        return {
            "side": self.side,
            "fe": self.fe,
            "uncertainty": self.uncertainty,
            "hertz": self.hertz,
            "discrepancy": {name: self.discrepancy(name) for name in NAMES},
        }


def compare_subsurface(solution: ContactSolution, *, side: Side = "lower") -> SubsurfaceComparison:
    """Both sides of the greatest shear and von Mises stress; solves one body of the last two meshes once more.

    The uncertainty is the last change, or 0.03 % where that is more; the far boundary adds what it does to the peak
    pressure, and to depths what it does to the minor semi-axis.
    """
    noun, hertz = solution.contact, solution.hertz
    material = noun.race_material if side == "lower" else noun.ball_material
    closed = subsurface_maximum(
        peak_pressure=hertz.peak_pressure,
        semi_axis_x=hertz.semi_axis_rolling,
        semi_axis_y=hertz.semi_axis_transverse,
        poisson_ratio=material.poisson_ratio,
    )
    coarse, fine = (_maxima(solution, mesh=number, side=side) for number in (-2, -1))
    minor = min(("semi_axis_rolling", "semi_axis_transverse"), key=lambda name: getattr(solution.reference, name))
    domain = {name: solution.estimates[minor if "depth" in name else "peak_pressure"].domain for name in NAMES}
    return SubsurfaceComparison(
        side=side,
        hertz={name: float(getattr(closed, name)) for name in NAMES},
        fe=fine,
        uncertainty={name: max(abs(coarse[name] / fine[name] - 1), LEAST) + FINEST + domain[name] for name in NAMES},
    )


def _maxima(solution: ContactSolution, *, mesh: int, side: Side) -> dict[str, float]:
    found = subsurface_stress(solution.meshes[mesh], side=side)
    values = (
        found.greatest_shear,
        found.greatest_shear_depth,
        found.greatest_von_mises,
        found.greatest_von_mises_depth,
    )
    return dict(zip(NAMES, values, strict=True))
