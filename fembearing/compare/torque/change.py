"""What finite-element contacts change in the friction torque: Hertz's contacts against those of finite elements."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.finite_geometry import RaceCorrections
from analytic.effects.table import CHOSEN
from analytic.loads.finite_geometry import corrections_of
from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.torque import friction_torque
from fembearing.compare.contact.discrepancy import ContactSolution
from fembearing.compare.contact.scene_contact import balls_of
from fembearing.compare.contact.verdict import Verdict, worst
from fembearing.plain_types import plain

SAME_LOAD = 0.01  # relative: the ratios change with the load's power 1/3 to 2/3, so by a hundredth of themselves
FACTORS = ("semi_axis_rolling", "semi_axis_transverse", "approach")
LEFT_OUT = ("finite_geometry", "cage_dynamics")  # in both torques: see NOTE
NOTE = (
    "Both torques differ by the contacts on the races alone. The fit for finite geometry and any motion of the cage "
    "are left out of them, so neither has to equal the total above."
)
PARTS = ("total", "race", "spin", "conformity", "hysteresis", "rolling")


@dataclass(frozen=True, kw_only=True, eq=False)
class FittedChange(Brief):
    """The torque with contacts corrected for finite geometry, at every operating point."""

    torque: FrictionTorque
    relative: np.ndarray  # (n,) over Hertz's, less one; NaN where the correction does not reach
    uncertainty: np.ndarray  # (n,) of that change, from the factors' uncertainties, 95 %
    warnings: tuple[str, ...]

    @property
    def contact_angle(self) -> np.ndarray:
        """(n,) rad, NaN where the correction does not reach."""
        return np.where(np.isnan(self.relative), np.nan, self.torque.contact_angle)

    @property
    def total(self) -> np.ndarray:
        """(n,) N m, NaN where the correction does not reach."""
        return np.where(np.isnan(self.relative), np.nan, self.torque.torque.total)

    def to_json(self) -> dict[str, Any]:
        """Lists over the operating points; SI, change and uncertainty relative; None where it does not reach."""
        return plain(
            {
                "contact_angle": self.contact_angle,
                "torque": self.total,
                "change": self.relative,
                "uncertainty": self.uncertainty,
            }
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueChange(Brief):
    """The torque with Hertz's contacts, and again with finite-element semi-axes and approach.

    Both leave out the effects of LEFT_OUT, so that neither is the total that the production model gives.
    """

    hertz: FrictionTorque
    corrected: FrictionTorque
    # From the contacts' numerical uncertainties: of each part's relative change, and of the corrected contact angle,
    # relative; parts that were left out have none.
    uncertainties: dict[str, float]
    fitted: FittedChange
    verdict: Verdict  # the worst of both contacts: beyond "pass" the change stands on contacts that did not pass

    @property
    def uncertainty(self) -> float:
        """Of the relative change of the total."""
        return self.uncertainties["total"]

    @property
    def is_solved(self) -> np.ndarray:
        """(n,) operating points at the ball load that was solved: elsewhere nothing is known of the change."""
        load = self.hertz.ball_load
        return load >= (1 - SAME_LOAD) * load.max()

    @property
    def contact_angle(self) -> np.ndarray:
        """(n,) by finite elements, rad, NaN where no contact was solved at its load."""
        return np.where(self.is_solved, self.corrected.contact_angle, np.nan)

    @property
    def total(self) -> np.ndarray:
        """(n,) by finite elements, N m, NaN where no contact was solved at its load."""
        return np.where(self.is_solved, self.corrected.torque.total, np.nan)

    def relative(self, part: str) -> np.ndarray | None:
        """Corrected over Hertz minus one at each operating point, NaN where no contact was solved at its load.

        None where the part was left out.
        """
        before, after = getattr(self.hertz.torque, part), getattr(self.corrected.torque, part)
        if before is None:
            return None
        return np.where(self.is_solved, _change(after, before), np.nan)

    def to_json(self) -> dict[str, Any]:
        """Lists over the operating points; SI, changes relative."""
        return {
            "contact_angle": plain({"hertz": self.hertz.contact_angle, "corrected": self.contact_angle}),
            "torque": plain({"hertz": self.hertz.torque.total, "corrected": self.total}),
            "change": plain({part: self.relative(part) for part in PARTS}),
            "uncertainty": self.uncertainty,
            "uncertainties": self.uncertainties,
            "finite_geometry": self.fitted.to_json(),
            "verdict": self.verdict,
            "note": NOTE,
        }


def change_of_torque(scene: Scene, *, inner: ContactSolution, outer: ContactSolution) -> TorqueChange:
    """Torque of a scene when the finite-element a, b, delta and with it K replace Hertz's.

    The ratios of finite elements to Hertz are known at one ball load, the largest. The change is given there alone.
    Where balls are loaded unequally, all balls take the ratios of the heaviest one; for the others these are too large.
    The correction for finite geometry depends on the load of each ball, so its change is given at each operating point.
    Raises InputError as friction_torque does.
    """
    reduced = replace(scene, effects={**scene.effects, **dict.fromkeys(LEFT_OUT, "off")})
    hertz = friction_torque(reduced)
    scene = replace(scene, effects={effect.name: effect.decision for effect in hertz.effects if effect.name in CHOSEN})
    corrected = _corrected(scene, factors(inner), factors(outer))
    solved = int(np.argmax(hertz.ball_load))
    expected = _outcome(corrected, solved)
    spread = dict.fromkeys(expected, 0.0)
    for name in FACTORS:  # one input at a time, moved by its whole uncertainty; added: they may hang together
        for moved in (
            _corrected(scene, factors(inner, up=name), factors(outer)),
            _corrected(scene, factors(inner), factors(outer, up=name)),
        ):
            for part, value in _outcome(moved, solved).items():
                if value != expected[part]:  # a part that is 0 either way is sure
                    spread[part] += abs(value / expected[part] - 1)
    return TorqueChange(
        hertz=hertz,
        corrected=corrected,
        uncertainties=spread,
        fitted=_fitted(scene, hertz),
        verdict=worst((inner.verdict, outer.verdict)),
    )


def _outcome(torque: FrictionTorque, point: int) -> dict[str, float]:
    """What depends on the contacts, at one operating point: N m, and the angle in rad."""
    parts = {name: getattr(torque.torque, name) for name in PARTS}
    known = {name: float(part[point]) for name, part in parts.items() if part is not None}
    return known | {"contact_angle": float(torque.contact_angle[point])}


def _fitted(scene: Scene, hertz: FrictionTorque) -> FittedChange:
    balls = balls_of(scene)
    corrections = corrections_of(scene.bearing, balls)
    torque = friction_torque(scene, correction=corrections.correction)
    spread = np.zeros_like(hertz.ball_load)
    for name in FACTORS:
        for correction in _moved(corrections, name):
            moved = friction_torque(scene, correction=correction)
            spread += np.abs(_change(moved.torque.total, torque.torque.total))
    covered = np.reshape(corrections.inner.covered & corrections.outer.covered, (hertz.ball_load.size, -1)).all(axis=1)
    return FittedChange(
        torque=torque,
        relative=np.where(covered, _change(torque.torque.total, hertz.torque.total), np.nan),
        uncertainty=np.where(covered, spread, np.nan),
        warnings=corrections.warnings,
    )


def _moved(corrections: RaceCorrections, name: str) -> Iterator[ContactCorrection]:
    """With one factor of one race moved up by its uncertainty."""
    for race, side in (("inner", corrections.inner), ("outer", corrections.outer)):
        up = getattr(side.factors, name) * (1 + np.nan_to_num(side.uncertainty[name]))
        yield replace(corrections.correction, **{race: replace(side.factors, **{name: up})})


def _change(after: np.ndarray, before: np.ndarray) -> np.ndarray:
    """Relative; none of what is 0."""
    return np.divide(after, before, out=np.ones_like(before), where=before != 0) - 1


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
