"""A table: heads, rows of text, and notes. The terminal renders it by `terminal.table`, the page by `macros.html`."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

Row = Sequence[str]


class Head(NamedTuple):
    """The head of a column."""

    text: str
    kind: Literal["number", "text", "name", "verdict"] = "number"  # neither name nor verdict is broken into lines
    fixed: bool = False  # whether the lines of its numbers are not broken in a terminal either
    wide: bool = False  # on a page alone: a terminal of 80 characters has no room for it
    short: str = ""  # what stands in a terminal in place of the text


class Group(NamedTuple):
    """Rows under a heading of their own; without one, those of the whole table."""

    rows: Sequence[Row]
    title: str = ""
    notes: Sequence[str] = ()  # sentences below these rows


class Table(NamedTuple):
    """A table. The first cell of a row names it."""

    label: str  # its title in a terminal, and for those who hear a page
    heads: Sequence[Head]
    groups: Sequence[Group]
    notes: Sequence[str] = ()  # sentences below it


def table_of(label: str, heads: Sequence[Head], rows: Sequence[Row], notes: Sequence[str] = ()) -> Table:
    """A table of one group."""
    return Table(label, heads, [Group(rows)], notes)
