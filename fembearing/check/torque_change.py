"""What finite-element contacts change in the friction torque, beside the contacts that the production model has.

The races' torque is computed twice, with the production's own contacts and with those of finite elements, by the same
effects and methods. The difference is added to the production's total. The cage is in neither: contacts on the races do
not move it.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.finite_geometry import RaceCorrections
from analytic.effects import CAGE_OFF
from analytic.loads.finite_geometry import corrections_of
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from fembearing.check.comparison import ShownVerdict, worst
from fembearing.check.contact.scene_contact import balls_of
from fembearing.check.contact.solution import ContactSolution

SAME_LOAD = 0.01  # relative: the ratios change with the load's power 1/3 to 2/3, so by a hundredth of themselves
FACTORS = ("semi_axis_rolling", "semi_axis_transverse", "approach")
ROUND_OFF = 1e-12  # rad, or of the torque by the races
OF_RACES = ("race", "spin", "conformity", "hysteresis", "rolling")
FITTED = "Production takes Hertz's contacts with the fit for finite geometry: the change is the error of that fit."
NOT_FITTED = (
    "Production takes Hertz's contacts without the fit for finite geometry: the change is the whole effect of the true "
    "shapes."
)


@dataclass(frozen=True, kw_only=True, eq=False)
class FittedChange(Brief):
    """The torque with contacts corrected for finite geometry, at every operating point."""

    torque: FrictionTorque  # of the races
    relative: Array  # (n,) of the production's total; NaN where the correction does not reach
    uncertainty: Array  # (n,) of that change, from the factors' uncertainties, 95 %
    warnings: tuple[str, ...]  # where a contact is outside the range of the fit


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueChange(Brief):
    """The torque of the production, and again with finite-element semi-axes and approach on the races."""

    production: FrictionTorque  # of the whole bearing
    own: FrictionTorque  # of the races, with the production's contacts
    corrected: FrictionTorque  # of the races, with those of finite elements
    # From the contacts' numerical uncertainties: of each part's relative change, and of the corrected contact angle,
    # relative; parts that were left out have none.
    uncertainties: dict[str, float]
    fitted: FittedChange | None  # None: the production's contacts have the fit already, or there are two bearings
    verdict: ShownVerdict  # the worst of both contacts: beyond "pass" the change stands on contacts that did not pass

    @property
    def uncertainty(self) -> float:
        """Of the relative change of the total."""
        return self.uncertainties["total"]

    @property
    def note(self) -> str:
        """Why the production differs from finite elements by construction."""
        of_pair = self.production.pair is not None and not self.production.is_on("finite_geometry")
        return NOT_FITTED if of_pair or self.fitted is not None else FITTED

    @property
    def is_solved(self) -> np.ndarray:
        """(n,) whether a point has the ball load that was solved, dimensionless: elsewhere the change is unknown."""
        load = self.own.ball_load
        return load >= (1 - SAME_LOAD) * load.max()

    @property
    def contact_angle(self) -> Array:
        """(n,) by finite elements, rad, NaN where no contact was solved at its load."""
        return np.where(self.is_solved, self.corrected.contact_angle, np.nan)

    @property
    def total(self) -> Array:
        """(n,) the production's total and the change, N m, NaN where no contact was solved at its load."""
        return np.where(self.is_solved, _total(self.production, self.own, self.corrected), np.nan)

    def relative(self, part: str) -> Array | None:
        """Change of a part of the torque over that part, of the total over the production's.

        Parameters
        ----------
        part : str
            A field of `TorqueParts`, or "total".

        Returns
        -------
        ndarray, shape (n,), or None
            Relative; NaN where no contact was solved, None where the part was left out.
        """
        if part == "total":
            return _change(self.total, self.production.torque.total)
        before, after = getattr(self.own.torque, part), getattr(self.corrected.torque, part)
        if before is None:
            return None
        return np.where(self.is_solved, _change(after, before), np.nan)


def change_of_torque(
    scene: Scene, production: FrictionTorque, *, inner: ContactSolution, outer: ContactSolution
) -> TorqueChange:
    """Torque of a scene when the finite-element a, b, delta and with it K replace those of the production's contacts.

    production : friction_torque(scene)
    The ratios of finite elements to Hertz are known at one ball load, the largest. The change is given there alone.
    Where balls are loaded unequally, all balls take the ratios of the heaviest one; for the others these are too large.
    So do those of both bearings of a pair.
    The correction for finite geometry depends on the load of each ball, so its change is given at each operating point.
    Raises InputError as friction_torque does.
    """
    races = replace(scene, effects={**scene.effects, **CAGE_OFF})

    def corrected(scene: Scene, *, up_inner: str = "", up_outer: str = "") -> FrictionTorque:
        """With the contacts of finite elements, and one factor of either race moved up by its uncertainty."""
        both = ContactCorrection(inner=factors(inner, up=up_inner), outer=factors(outer, up=up_outer))
        return friction_torque(scene, correction=both)

    own, found = friction_torque(races), corrected(races)
    solved = int(np.argmax(own.ball_load))
    others = float(production.torque.total[solved] - own.torque.race[solved])  # parts that no contact changes, N m
    there = replace(races, operation=races.operation.as_series().at(np.array([solved])))

    def outcome(**up: str) -> dict[str, float]:
        """What depends on the contacts, at the point that was solved: N m, and the angle in rad."""
        torque = corrected(there, **up)
        parts = {name: getattr(torque.torque, name) for name in OF_RACES}
        parts |= {"total": others + torque.torque.race, "contact_angle": torque.contact_angle}
        return {name: float(part[0]) for name, part in parts.items() if part is not None}

    expected = outcome()
    spread = dict.fromkeys(expected, 0.0)
    for name in FACTORS:  # one input at a time, moved by its whole uncertainty; added: they may hang together
        for moved in (outcome(up_inner=name), outcome(up_outer=name)):
            for part, value in moved.items():
                least = ROUND_OFF * (1.0 if part == "contact_angle" else abs(expected["race"]))
                if abs(value - expected[part]) > least:  # a part that is 0 either way is sure
                    spread[part] += abs(value / expected[part] - 1)
    return TorqueChange(
        production=production,
        own=own,
        corrected=found,
        uncertainties=spread,
        fitted=_fitted(races, production, own)
        if production.pair is None and not production.is_on("finite_geometry")
        else None,
        verdict=worst((inner.numbers.verdict, outer.numbers.verdict)),
    )


def _total(production: FrictionTorque, own: FrictionTorque, other: FrictionTorque) -> Array:
    """(n,) the production's total, less what its own contacts make of the races, with what others make of them."""
    return production.torque.total + (other.torque.race - own.torque.race)


def _fitted(races: Scene, production: FrictionTorque, own: FrictionTorque) -> FittedChange:
    corrections = corrections_of(races.bearing, balls_of(races))
    torque = friction_torque(races, correction=corrections.correction)
    total = _total(production, own, torque)
    spread = np.zeros_like(own.ball_load)
    for name in FACTORS:
        for correction in _moved(corrections, name):
            moved = friction_torque(races, correction=correction)
            spread += np.abs(_change(_total(production, own, moved), total))
    covered = np.reshape(corrections.inner.covered & corrections.outer.covered, (own.ball_load.size, -1)).all(axis=1)
    return FittedChange(
        torque=torque,
        relative=np.where(covered, _change(total, production.torque.total), np.nan),
        uncertainty=np.where(covered, spread, np.nan),
        warnings=corrections.warnings,
    )


def _moved(corrections: RaceCorrections, name: str) -> Iterator[ContactCorrection]:
    """With one factor of one race moved up by its uncertainty."""
    for race, side in (("inner", corrections.inner), ("outer", corrections.outer)):
        up = getattr(side.factors, name) * (1 + np.nan_to_num(side.uncertainty[name]))
        yield replace(corrections.correction, **{race: side.factors._replace(**{name: up})})


def _change(after: Array, before: Array) -> Array:
    """Relative; none of what is 0."""
    return np.divide(after, before, out=np.ones_like(before), where=before != 0) - 1


def factors(solution: ContactSolution, *, up: str = "") -> ContactFactors:
    """Finite elements over Hertz; the one named by `up` moved up by its uncertainty."""
    found = solution.numbers.quantities

    def over_hertz(name: str) -> float:
        each = found[name]
        return (1 + each.uncertainty / each.reference if name == up else 1) / (1 + each.difference)

    return ContactFactors(**{name: over_hertz(name) for name in FACTORS})
