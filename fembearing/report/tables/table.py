"""A table: heads, rows of text, and notes. The terminal renders it by `terminal.table`, the page by `macros.html`."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

Row = Sequence[str]
NO_ANGLE = ("", "-", "0.00 (0.0000)")  # as `phrases.angle_cell` writes it


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


def without_zero_angles(table: Table) -> Table:
    """Without the columns of angles that are 0, or none, in every row."""
    rows = [row for group in table.groups for row in group.rows]
    kept = [
        number
        for number, head in enumerate(table.heads)
        if "angle" not in head.text or any(row[number] not in NO_ANGLE for row in rows)
    ]
    groups = [each._replace(rows=[[row[number] for number in kept] for row in each.rows]) for each in table.groups]
    return table._replace(heads=[table.heads[number] for number in kept], groups=groups)


def table_of(label: str, heads: Sequence[Head], rows: Sequence[Row], notes: Sequence[str] = ()) -> Table:
    """A table of one group."""
    return Table(label, heads, [Group(rows)], notes)
