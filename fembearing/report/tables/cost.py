"""What accuracy costs: error, bound and price of each method."""

from collections.abc import Iterator, Sequence

from fembearing.check.cost.ladder import Ladder
from fembearing.report.phrases import capital, choices_line, short_name, shown
from fembearing.report.tables.table import Group, Head, Row, Table

HEADS = (
    Head("method", "name"),
    *(
        Head(name, fixed=True, wide=name == "spread")
        for name in ("error", "bound", "seconds", "spread", "first", "GiB")
    ),
    Head("unknowns", wide=True),
)
NOTE = (
    ">: the cheapest method known to be within the tolerance. FE: finite elements. Bound: on the error, known without "
    "the reference. Seconds: median of the repeats; first: the call before them; GiB: largest resident memory."
)


def cost_table(ladders: Sequence[Ladder]) -> Table:
    """A group for each quantity, a row for each method."""
    groups = [Group(list(_rows(ladder)), capital(ladder.quantity), list(_notes(ladder))) for ladder in ladders]
    return Table("Methods", HEADS, groups, [NOTE])


def _rows(ladder: Ladder) -> Iterator[Row]:
    for method in ladder.methods:
        yield [
            f"{'> ' if method.chosen else ''}{short_name(method.name)}",
            "failed" if method.failed else shown(method.error, ".2g", 100, " %", absent="reference"),
            shown(method.bound, ".2g", 100, " %", absent=""),
            shown(method.seconds, ".2g", absent=""),
            shown(method.spread, ".1g", absent=""),
            shown(method.warm_up, ".1g", absent=""),
            shown(method.memory, ".2f", 2**-30, absent=""),
            str(method.unknowns or ""),
        ]


def _notes(ladder: Ladder) -> Iterator[str]:
    if ladder.absent is not None:
        yield f"Does not apply: {ladder.absent}."
        return
    yield from (f"{method.name} failed: {method.failed}" for method in ladder.methods if method.failed)
    yield f"Price of the next digit: {choices_line(ladder)}."
    yield f"Reference: {ladder.reference}."
