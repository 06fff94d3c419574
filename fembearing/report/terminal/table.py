"""The form of every table for a terminal."""

from collections.abc import Collection, Iterable

from rich.box import SIMPLE_HEAD
from rich.markup import escape
from rich.table import Table as Printed

from fembearing.report.tables.table import Table


def printed(table: Table) -> Printed:
    """A table for a terminal of 80 characters, without its wide columns."""
    heads = [(place, head) for place, head in enumerate(table.heads) if not head.wide]
    shown = table_of([], title=table.label)
    for _, head in heads:
        whole = head.fixed or head.kind in ("name", "verdict")
        shown.add_column(head.text, justify="right" if head.kind == "number" else "left", no_wrap=whole)
    for group in table.groups:
        for row in group.rows:
            shown.add_row(*(escape(row[place]) for place, _ in heads))
    return shown


def table_of(
    heads: Iterable[str], *, title: str | None = None, left: Collection[str] = (), fixed: Collection[str] = ()
) -> Printed:
    """A table without a frame, its numbers to the right.

    left : heads of columns of words;  fixed : heads of columns whose lines are not broken
    """
    table = Printed(
        title=title, title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False, show_edge=False
    )
    for head in heads:
        table.add_column(head, justify="left" if head in left else "right", no_wrap=head in fixed)
    return table
