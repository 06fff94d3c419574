"""A document: sections of blocks. The terminal and the page render the same ones."""

from collections.abc import Sequence
from typing import NamedTuple

from fembearing.report.tables.table import Table


class Text(NamedTuple):
    """A sentence or more."""

    words: str
    verdict: str = ""  # a word that stands out before them
    wide: bool = False  # on a page alone


class Bullets(NamedTuple):
    """Sentences, one below the other."""

    sentences: Sequence[str]
    title: str = ""


class Drawing(NamedTuple):
    """A plot or a picture, which a page alone has."""

    source: str  # a data address
    caption: str


Block = Table | Text | Bullets | Drawing


class Section(NamedTuple):
    """What is said of one topic."""

    title: str
    blocks: Sequence[Block]
