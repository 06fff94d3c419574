"""The verdicts on a result: comparison with finite elements, numerical accuracy, physical limits."""

from dataclasses import dataclass
from typing import Annotated, Literal

from annotated_types import MinLen

from analytic.verdicts import NumericalCheck, PhysicalCheck
from fembearing.verify.contact.verdict import Verdict

Physical = Literal["pass", "fail", "unknown"]
Overall = Literal["pass", "fail", "undecided"]
FAILS, IS_OPEN = ("fail", "outside validity"), ("undecided", "not reached", "unknown")


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
    def summary(self) -> "Summary":
        """One word for each kind of verdict, and one for all."""
        return Summary(
            comparison=self.comparison,
            numerical=None if self.numerical is None else self.numerical.verdict,
            physical=self.worst_physical,
            overall=self.overall,
        )


@dataclass(frozen=True, kw_only=True)
class Summary:
    """One word for each kind of verdict, and one for all."""

    comparison: Verdict | None  # None: nothing was compared
    numerical: Literal["pass", "not reached"] | None  # None: there is no torque
    physical: Physical
    overall: Overall

    @property
    def words(self) -> str:
        """All in a line."""
        each = {"comparison": self.comparison, "numerical": self.numerical, "physical": self.physical}
        return f"{self.overall}: {', '.join(f'{name} {word}' for name, word in each.items() if word is not None)}"
