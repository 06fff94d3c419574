"""The form of every table for a terminal."""

from collections.abc import Collection, Iterable

from rich.box import SIMPLE_HEAD
from rich.table import Table


def table_of(
    heads: Iterable[str], *, title: str | None = None, left: Collection[str] = (), fixed: Collection[str] = ()
) -> Table:
    """A table without a frame, its numbers to the right.

    left : heads of columns of words;  fixed : heads of columns whose lines are not broken
    """
    table = Table(
        title=title, title_justify="left", box=SIMPLE_HEAD, padding=(0, 1, 0, 0), pad_edge=False, show_edge=False
    )
    for head in heads:
        table.add_column(head, justify="left" if head in left else "right", no_wrap=head in fixed)
    return table
