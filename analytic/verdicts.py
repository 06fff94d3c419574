"""Whether a friction torque is solved accurately, and whether the bearing is within the limits of its physics.

The two say different things and are never mixed: a torque that is solved to the last digit may be that of a race that
yields. What the scene does not have, as a cage or oil, is not checked, and does not pass.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal

import numpy as np
from annotated_types import Ge, MinLen
from numpy.typing import ArrayLike

from analytic.cage.drive import LARGEST_GRIP
from analytic.contact.geometry import RACES, USUAL_SHOULDERS
from analytic.limits import MOST_CUT, MOST_STARVED, STATIC_LIMIT
from analytic.result import FrictionTorque
from analytic.rows import NotNegative, Positive
from analytic.scene import Array
from analytic.words import percent_of

LARGEST_TILT = 3e-3  # rad: the upper end of what is allowed in deep groove bearings [RBC]; Inventor has 6 arc minutes
MOST_FRICTION = 1.0  # of what friction can hold at most: beyond, the surfaces slide
YIELDS = (
    "Above the static limit of ISO 76 for steel the dent exceeds 1e-4 of the ball diameter, and the contact is not "
    "elastic."
)
CUT = (
    "Share of a contact's load by Hertz beyond the shoulder of the race; the rest of the contact carries it at a "
    "higher pressure."
)
UNKNOWN_SHOULDER = (
    f"Shoulder not known: share for a low one, {USUAL_SHOULDERS[0]:g} ball diameters high; give shoulder_height."
)
SKIDS = (
    "Rolling force of the oil over the friction of the driving race, for contacts that slide as fast as they roll; "
    "above the limit the balls skid."
)
LETS_GO = (
    "Gyroscopic moment of a ball over the largest friction moment of both races, for contacts that slide as fast as "
    "they roll; above the limit the ball turns across its grooves."
)
GRIP = (
    "Share of the grip of the races that the cage force uses (of a whirl: by the weakest ball); above the limit balls "
    "slide, and the forces for given balls do not hold."
)
STARVES = (
    "Minus the logarithm of SKF's replenishment factor, the share of rolling that starvation leaves; above the limit "
    "less than half is left, and the interval reaches from the starved to the flooded torque: give "
    "lubricant.starvation_degree."
)
LEANS = (
    "Catalogues allow 0.5 to 3 mrad (2 to 10 arc minutes) in deep groove bearings, by size, "
    "clearance and load: hold the ring straight, or lower the moment."
)
UNKNOWN_GRIP = 'Friction of the races not computed, grip not known: set effects.spin to "auto".'


@dataclass(frozen=True, kw_only=True)
class PhysicalCheck:
    """One number against its limit, at the operating point where it is worst."""

    name: Literal["peak_pressure", "shoulder", "sliding", "gyroscopic_hold", "cage_force", "tilt", "replenishment"]
    where: Literal["inner race", "outer race", "ball", "cage", "ring", "oil"]  # what it is of
    point: Annotated[int, Ge(0)]  # number of the operating point, from 0
    value: float | None  # in the unit of the limit; None: infinite or not known
    limit: float  # Pa, rad, or a share
    unit: Literal["Pa", "rad", "1"]  # of value and limit
    verdict: Literal["pass", "fail", "unknown"]  # whether the limit holds
    note: str  # in words; empty: nothing to add


@dataclass(frozen=True, kw_only=True)
class NumericalCheck:
    """The numerical uncertainty of the torque against the tolerance, both relative, at the worst operating point."""

    verdict: Literal["pass", "not reached"]
    uncertainty: NotNegative
    tolerance: Positive


def numerical_check(friction: FrictionTorque, *, tolerance: float) -> NumericalCheck:
    """Whether every operating point is solved within the tolerance, relative."""
    worst = float(np.max(friction.numerical_uncertainty, initial=0.0))
    return NumericalCheck(
        verdict="pass" if worst <= tolerance else "not reached", uncertainty=worst, tolerance=tolerance
    )


def physical_checks(friction: FrictionTorque) -> tuple[PhysicalCheck, ...]:
    """Every physical limit that the torque's scene can reach, each at its worst operating point.

    Parameters
    ----------
    friction : FrictionTorque
        Of any scene.

    Returns
    -------
    tuple of PhysicalCheck
        Value and limit of each check, in its unit: see Notes. What the scene does not have is not checked.

    Notes
    -----
    peak_pressure
        Pa, on each race, against the static limit of 4.2 GPa of [ISO76].
    shoulder
        Share of a contact's load that is cut off on each race, against 0.1; "unknown" where the shoulders are not known
        and low ones would cut off more.
    sliding
        Rolling force of the oil over the friction of each race, against 1; only where rolling and sliding are computed.
    gyroscopic_hold
        Gyroscopic moment over what friction holds, against 1, of balls with a tenth of the heaviest load or more; only
        where balls turn and slide.
    cage_force
        Share of the races' grip that the cage uses, against 0.9; only with a cage.
    tilt
        Of the inner ring against the outer one, rad, against 0.003 [RBC]; only where it is not held straight.
    replenishment
        -ln of SKF's replenishment factor, against ln 2; "unknown" above it; only where this factor starves the inlets.
    """
    return tuple(_checks(friction))


def pressure_check(race: str, peak_pressure: ArrayLike) -> PhysicalCheck:
    """The peak pressure on a race, Pa, of one or more operating points, against the static limit."""
    return _check("peak_pressure", f"{race} race", np.atleast_1d(peak_pressure), STATIC_LIMIT, YIELDS)


def _checks(friction: FrictionTorque) -> Iterator[PhysicalCheck]:
    numbers = friction.limits
    for race, values in zip(RACES, numbers.peak_pressure, strict=True):
        yield pressure_check(race, values)
    for race, values, is_known in zip(RACES, numbers.cut_off, numbers.knows_shoulder, strict=True):
        note = CUT if is_known else f"{CUT} {UNKNOWN_SHOULDER}"
        yield _check("shoulder", f"{race} race", values, MOST_CUT, note, is_known=bool(is_known))
    if numbers.sliding_number is not None:
        for race, values in zip(RACES, numbers.sliding_number, strict=True):
            yield _check("sliding", f"{race} race", values, MOST_FRICTION, SKIDS)
    if numbers.gyroscopic_hold is not None:
        yield _check("gyroscopic_hold", "ball", numbers.gyroscopic_hold, MOST_FRICTION, LETS_GO)
    if numbers.cage_grip is not None:
        note = UNKNOWN_GRIP if np.isnan(numbers.cage_grip).any() else GRIP
        yield _check("cage_force", "cage", numbers.cage_grip, LARGEST_GRIP, note)
    if numbers.tilt is not None:
        yield _check("tilt", "ring", numbers.tilt, LARGEST_TILT, LEANS)
    if numbers.replenishment is not None:
        yield _check("replenishment", "oil", numbers.replenishment, MOST_STARVED, STARVES, is_known=False)


def _check(name: Any, where: Any, values: Array, limit: float, note: str, *, is_known: bool = True) -> PhysicalCheck:
    """values : (n,); NaN: not known;  is_known : whether a value above the limit is certain to fail"""
    point = int(np.argmax(np.where(np.isnan(values), -np.inf, values)))
    worst = float(values[point])
    verdict = "unknown" if np.isnan(values).any() else "pass"
    if worst > limit:
        verdict = "fail" if is_known else "unknown"
    return PhysicalCheck(
        name=name,
        where=where,
        point=point,
        value=worst if np.isfinite(worst) else None,
        limit=limit,
        unit="Pa" if name == "peak_pressure" else "rad" if name == "tilt" else "1",
        verdict=verdict,
        note=note,
    )


# On a production value against its reference.
Verdict = Literal["pass", "fail", "undecided", "outside validity"]
Physical = Literal["pass", "fail", "unknown"]
PHYSICAL_ORDER: tuple[Physical, ...] = ("fail", "unknown", "pass")  # the worst first
Overall = Literal["pass", "fail", "undecided"]
FAILS, IS_OPEN = ("fail", "outside validity"), ("undecided", "not reached", "unknown")
Compared = Literal["contacts", "film", "friction"]  # with a numerical reference
COMPARED: dict[Compared, dict[Verdict, str]] = {  # why a comparison does not pass
    "contacts": {
        "fail": "Hertz differs from finite elements by more than the tolerance",
        "outside validity": "a contact is outside the validity of Hertz",
        "undecided": "a contact is undecided by finite elements",
    },
    "film": {
        "fail": "film or rolling force differs from the numerical one by more than its stated error",
        "undecided": "film or rolling force is undecided by the numerical one",
    },
    "friction": {
        "fail": "numerical friction changes the torque by more than the tolerance",
        "undecided": "the friction of a ball is undecided by the numerical one",
    },
}
PHYSICAL = {
    "peak_pressure": "the peak pressure exceeds the static limit",
    "shoulder": "a shoulder cuts the contact off",
    "sliding": "the rolling force of the oil exceeds the driving friction",
    "gyroscopic_hold": "the gyroscopic moment of a ball exceeds the friction moment",
    "cage_force": "the force of the cage exceeds the grip of the races",
    "tilt": "the inner ring tilts farther than catalogues allow",
    "replenishment": "starved to flooded: the oil returns slowly, and at a start it lies in the races",
}


@dataclass(frozen=True, kw_only=True)
class Verdicts:
    """The verdicts on one result, which are never mixed."""

    numerical: NumericalCheck | None  # None: there is no torque
    physical: Annotated[tuple[PhysicalCheck, ...], MinLen(1)]
    compared: Mapping[Compared, Verdict] = field(default_factory=dict)  # the worst of each; of a torque alone none

    @property
    def comparison(self) -> Verdict | None:
        """The most serious verdict on what was compared; None: nothing was."""
        order: tuple[Verdict, ...] = ("fail", "outside validity", "undecided", "pass")
        return min(self.compared.values(), key=order.index, default=None)

    @property
    def worst_physical(self) -> Physical:
        """The most serious of the physical verdicts."""
        verdicts: list[Physical] = [check.verdict for check in self.physical]
        return min(verdicts, key=PHYSICAL_ORDER.index)

    @property
    def overall(self) -> Overall:
        """ "fail" where a comparison or a physical limit fails, "pass" where all hold, else "undecided"."""
        each = (self.comparison, None if self.numerical is None else self.numerical.verdict, self.worst_physical)
        if any(verdict in FAILS for verdict in each):
            return "fail"
        return "undecided" if any(verdict in IS_OPEN for verdict in each) else "pass"

    @property
    def reason(self) -> str:
        """Why the overall verdict is what it is, in words."""
        return "; ".join(dict.fromkeys(self._reasons()))

    def _reasons(self) -> Iterator[str]:
        if self.overall == "pass":
            solved = [*self.compared, *([] if self.numerical is None else ["solver error"])]
            named = " and ".join(filter(None, (", ".join(solved[:-1]), *solved[-1:])))
            yield f"{named} within the tolerance, no physical limit exceeded"
            return
        which = FAILS if self.overall == "fail" else IS_OPEN
        yield from (COMPARED[name][verdict] for name, verdict in self.compared.items() if verdict in which)
        numerical = self.numerical
        if numerical is not None and numerical.verdict in which:
            error = percent_of(numerical.uncertainty, 2)
            yield f"the solver error is {error}, tolerance {percent_of(numerical.tolerance, 2)}"
        for check in self.physical:
            if check.verdict in which:
                limit = f"a physical limit is not known: {check.name.replace('_', ' ')}"
                known = check.verdict == "fail" or check.name == "replenishment"  # a value too uncertain to fail
                yield f"{PHYSICAL[check.name] if known else limit} ({check.where})"

    @property
    def summary(self) -> "Summary":
        """One word for each kind of verdict, and one for all."""
        return Summary(
            comparison=self.comparison,
            numerical=None if self.numerical is None else self.numerical.verdict,
            physical=self.worst_physical,
            overall=self.overall,
            reason=self.reason,
        )


@dataclass(frozen=True, kw_only=True)
class Summary:
    """One word for each kind of verdict, and one for all."""

    comparison: Verdict | None  # of contacts, film and friction; None: nothing was compared
    numerical: Literal["pass", "not reached"] | None  # None: there is no torque
    physical: Physical
    overall: Overall
    reason: str  # of the overall verdict

    @property
    def words(self) -> str:
        """All in a line."""
        each = {"comparison": self.comparison, "numerical": self.numerical, "physical": self.physical}
        return f"{self.overall}: {', '.join(f'{name} {word}' for name, word in each.items() if word is not None)}"
