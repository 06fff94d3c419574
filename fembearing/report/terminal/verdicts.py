"""The numerical and the physical verdicts for a terminal or a pipe of 80 characters."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rich.console import Console

from fembearing.report.phrases import CHECKS, capital, numerical_words
from fembearing.report.tables.verdicts import POINT, physical_table
from fembearing.report.terminal.table import printed

if TYPE_CHECKING:
    from analytic.verdicts import NumericalCheck, PhysicalCheck


def print_physical(out: Console, checks: "Sequence[PhysicalCheck]") -> None:
    """Each number with its limit, at the operating point where it is worst; why it does not pass below the table."""
    out.print(printed(physical_table(checks)))
    for note in dict.fromkeys(f"{capital(CHECKS[c.name])}: {c.note}" for c in checks if c.verdict != "pass"):
        out.print(note, markup=False)
    out.print(f"{POINT}\n", style="dim")


def print_notes(out: Console, notes: Iterable[str]) -> None:
    """What is said beside the torque and not judged."""
    for note in notes:
        out.print(note, markup=False)


def print_numerical(out: Console, check: "NumericalCheck | None") -> None:
    """Whether the torque is solved within the tolerance; nothing without a torque."""
    if check is not None:
        out.print(numerical_words(check), markup=False)
