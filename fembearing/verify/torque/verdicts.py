"""The verdicts on a result: comparison with finite elements, numerical accuracy, physical limits."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Literal

from annotated_types import MinLen

from analytic.verdicts import NumericalCheck, PhysicalCheck
from analytic.words import percent_of
from fembearing.verify.contact.verdict import Verdict

Physical = Literal["pass", "fail", "unknown"]
Overall = Literal["pass", "fail", "undecided"]
FAILS, IS_OPEN = ("fail", "outside validity"), ("undecided", "not reached", "unknown")
COMPARISON = {
    "fail": "Hertz differs from finite elements by more than the tolerance",
    "outside validity": "a contact is outside the validity of Hertz",
    "undecided": "a contact is undecided by finite elements",
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
    comparison: Verdict | None = None  # of contacts against finite elements; None: nothing was compared

    @property
    def worst_physical(self) -> Physical:
        """The most serious of the physical verdicts."""
        verdicts: list[Physical] = [check.verdict for check in self.physical]
        return min(verdicts, key=("fail", "unknown", "pass").index)

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
            solved = {"contacts": self.comparison, "solver error": self.numerical}
            within = " and ".join(name for name, part in solved.items() if part is not None)
            yield f"{within} within the tolerance, no physical limit exceeded"
            return
        which = FAILS if self.overall == "fail" else IS_OPEN
        if self.comparison is not None and self.comparison in which:
            yield COMPARISON[self.comparison]
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

    comparison: Verdict | None  # None: nothing was compared
    numerical: Literal["pass", "not reached"] | None  # None: there is no torque
    physical: Physical
    overall: Overall
    reason: str  # of the overall verdict

    @property
    def words(self) -> str:
        """All in a line."""
        each = {"comparison": self.comparison, "numerical": self.numerical, "physical": self.physical}
        return f"{self.overall}: {', '.join(f'{name} {word}' for name, word in each.items() if word is not None)}"
