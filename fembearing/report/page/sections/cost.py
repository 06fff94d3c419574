"""Error and time of each method."""

from collections.abc import Iterator

from fembearing.report.phrases import capital, shown
from fembearing.report.report import Report
from fembearing.report.tables.table import Group, Head, Row, Table
from fembearing.verify.cost.ladder import Ladder

HEADS = (
    Head("method", "text"),
    Head("error"),
    Head("bound"),
    Head("time, s"),
    Head("unknowns"),
    Head("note", "text"),
)


def cost_grid(document: Report) -> Table:
    """A group for each quantity, a row for each method."""
    return Table("methods", HEADS, [Group(list(_rows(ladder)), _title(ladder)) for ladder in document.cost.ladders])


def _title(ladder: Ladder) -> str:
    absent = f": does not apply: {ladder.absent}" if ladder.absent else ""
    return f"{capital(ladder.quantity)}{absent}"


def _rows(ladder: Ladder) -> Iterator[Row]:
    for method in ladder.methods:
        yield [
            method.name,
            "failed" if method.failed else shown(method.error, ".2g", 100, " %", absent="reference"),
            shown(method.bound, ".2g", 100, " %", absent=""),
            shown(method.seconds, ".2g", absent=""),
            str(method.unknowns or ""),
            "enough for the tolerance" if method.chosen else method.failed or "",
        ]
