"""The verdicts on a result: comparison with finite elements, numerical accuracy, physical limits."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal

from analytic.verdicts import NumericalCheck, PhysicalCheck
from fembearing.verify.contact.verdict import Verdict

Physical = Literal["pass", "fail", "unknown"]
Overall = Literal["pass", "fail", "undecided"]
FAILS, IS_OPEN = ("fail", "outside validity"), ("undecided", "not reached", "unknown")


@dataclass(frozen=True, kw_only=True)
class Verdicts:
    """The verdicts on one result, which are never mixed."""

    numerical: NumericalCheck | None  # None: there is no torque
    physical: Sequence[PhysicalCheck]
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

    def to_json(self) -> dict[str, Any]:
        """Numerical and physical verdicts with their numbers, as plain types, SI."""
        return {
            "numerical": None if self.numerical is None else self.numerical.to_json(),
            "physical": [asdict(check) for check in self.physical],
        }

    def summary(self) -> dict[str, str | None]:
        """One word for each kind of verdict, and one for all."""
        return {
            "comparison": self.comparison,
            "numerical": None if self.numerical is None else self.numerical.verdict,
            "physical": self.worst_physical,
            "overall": self.overall,
        }
