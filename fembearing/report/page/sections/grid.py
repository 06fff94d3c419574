"""A table of the page: heads, and rows of text, which one template shows."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

Row = Sequence[str]


class Head(NamedTuple):
    """The head of a column."""

    text: str
    kind: Literal["number", "text", "name", "verdict"] = "number"  # a name is not broken into lines


class Group(NamedTuple):
    """Rows under a heading of their own; without one, those of the whole table."""

    rows: Sequence[Row]
    title: str = ""


class Grid(NamedTuple):
    """A table. The first cell of a row names it."""

    label: str  # for those who hear the page; empty: the heading above says it
    heads: Sequence[Head]
    groups: Sequence[Group]


def grid_of(label: str, heads: Sequence[Head], rows: Sequence[Row]) -> Grid:
    """A table of one group."""
    return Grid(label, heads, [Group(rows)])
