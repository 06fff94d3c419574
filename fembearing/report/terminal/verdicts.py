"""The numerical and the physical verdicts for a terminal or a pipe of 80 characters."""

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from rich.console import Console

from fembearing.report.phrases import CHECKS, capital, limit_of, numerical_words, worst_of
from fembearing.report.terminal.table import table_of

if TYPE_CHECKING:  # pydantic's models: only a report pays for them
    from analytic.verdicts import NumericalCheck, PhysicalCheck


def print_physical(out: Console, checks: "Sequence[PhysicalCheck] | Sequence[PhysicalCheck]") -> None:
    """Each number with its limit, at the operating point where it is worst; why it does not pass below the table."""
    words = ("check", "where", "verdict")
    table = table_of(
        ("check", "where", "#", "worst", "limit", "verdict"), title="Physical limits", left=words, fixed=words
    )
    for check in checks:
        table.add_row(
            CHECKS[check.name],
            check.where,
            str(check.point + 1),
            worst_of(check),
            limit_of(check.limit, check.unit),
            check.verdict,
        )
    out.print(table)
    for note in dict.fromkeys(f"{capital(CHECKS[c.name])}: {c.note}" for c in checks if c.verdict != "pass"):
        out.print(note, markup=False)
    out.print("#: the operating point where it is worst. What the scene does not have is not checked.\n", style="dim")


def print_notes(out: Console, notes: Iterable[str]) -> None:
    """What is said beside the torque and not judged."""
    for note in notes:
        out.print(note, markup=False)


def print_numerical(out: Console, check: "NumericalCheck | None") -> None:
    """Whether the torque is solved within the tolerance; nothing without a torque."""
    if check is not None:
        out.print(numerical_words(check), markup=False)
