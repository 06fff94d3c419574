"""What the contact discrepancies do to the race torque: the number an engineer acts on."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.correction import ContactCorrection, ContactFactors
from analytic.scene import Scene
from analytic.torque import FrictionTorque, friction_torque
from fembearing.compare.discrepancy import ContactSolution

FACTORS = ("semi_axis_rolling", "semi_axis_transverse", "approach")
PARTS = ("total", "race", "spin", "conformity", "hysteresis")


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueChange:
    """The production torque with Hertz's contacts, and again with finite-element semi-axes and approach."""

    hertz: FrictionTorque
    corrected: FrictionTorque
    uncertainty: float  # of the relative change of the total, from the contacts' numerical uncertainties

    def relative(self, part: str) -> np.ndarray | None:
        """Corrected over Hertz minus one at each operating point; None where the part was left out."""
        before, after = getattr(self.hertz.torque, part), getattr(self.corrected.torque, part)
        return None if before is None else np.divide(after, before, out=np.ones_like(before), where=before != 0) - 1

    def to_json(self) -> dict[str, Any]:
        """Lists over the operating points; SI, changes relative."""
        changes = {part: self.relative(part) for part in PARTS}
        return {
            "contact_angle": {
                "hertz": self.hertz.contact_angle.tolist(),
                "corrected": self.corrected.contact_angle.tolist(),
            },
            "torque": {
                "hertz": self.hertz.torque.total.tolist(),
                "corrected": self.corrected.torque.total.tolist(),
            },
            "change": {part: None if change is None else change.tolist() for part, change in changes.items()},
            "uncertainty": self.uncertainty,
        }


def change_of_torque(scene: Scene, *, inner: ContactSolution, outer: ContactSolution) -> TorqueChange:
    """Race torque of a scene when the finite-element a, b, delta and with it K replace Hertz's.

    The ratios of finite elements to Hertz are taken at the solved load and used over the whole series.
    Raises InputError if the scene gives no friction coefficient.
    """
    corrected = _corrected(scene, factors(inner), factors(outer))
    spread = 0.0  # one input moved at a time, by its whole uncertainty; added, since nothing says they are independent
    for name in FACTORS:
        for moved in (
            _corrected(scene, factors(inner, up=name), factors(outer)),
            _corrected(scene, factors(inner), factors(outer, up=name)),
        ):
            spread += float(np.max(np.abs(moved.torque.total / corrected.torque.total - 1)))
    return TorqueChange(hertz=friction_torque(scene), corrected=corrected, uncertainty=spread)


def factors(solution: ContactSolution, *, up: str = "") -> ContactFactors:
    """Finite elements over Hertz; the one named by `up` moved up by its uncertainty."""
    return ContactFactors(
        **{
            name: (1 + solution.estimates[name].total if name == up else 1) / (1 + solution.discrepancy[name])
            for name in FACTORS
        }
    )


def _corrected(scene: Scene, inner: ContactFactors, outer: ContactFactors) -> FrictionTorque:
    return friction_torque(scene, correction=ContactCorrection(inner=inner, outer=outer))
