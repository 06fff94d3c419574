"""A document: sections of blocks. The terminal and the page render the same ones."""

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


class Text(NamedTuple):
    """A sentence or more."""

    words: str
    verdict: str = ""  # a word that stands out before them
    wide: bool = False  # on a page alone
    quiet: bool = False  # a note, in smaller letters on a page


class Facts(NamedTuple):
    """Names, each with what is known of it; on a page alone."""

    rows: Sequence[tuple[str, str]]


class Bullets(NamedTuple):
    """Sentences, one below the other."""

    sentences: Sequence[str]
    title: str = ""
    wide: bool = False  # on a page alone


class Drawing(NamedTuple):
    """A plot or a picture, which a page alone has."""

    source: str  # a data address
    caption: str
    heading: str = ""
    width: int = 0  # of a plot on a screen, pixels; 0: a picture, as wide as there is room
    beside: bool = False  # whether another picture stands beside it


class View(NamedTuple):
    """A contact to turn in the browser, which a page alone has."""

    page: str
    caption: str
    heading: str


class Signing(NamedTuple):
    """Who signs a page; an empty name is left to fill in."""

    people: Sequence[tuple[str, str]]  # role and name


Block = Table | Text | Facts | Bullets | Drawing | View | Signing


class Section(NamedTuple):
    """What is said of one topic."""

    title: str
    blocks: Sequence[Block]
    is_appendix: bool = False


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
