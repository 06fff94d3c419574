"""The sections of a document as tables and lines of text for a terminal or a pipe of 80 characters."""

from collections.abc import Iterable

from rich.console import Console
from rich.markup import escape
from rich.padding import Padding

from fembearing.report.document import Bullets, Section, Text
from fembearing.report.tables.table import Table
from fembearing.report.terminal.table import show


def print_sections(out: Console, sections: Iterable[Section]) -> None:
    """Print the blocks one below the other; the labels of the tables take the place of the titles."""
    for section in sections:
        for block in section.blocks:
            match block:
                case Table():
                    show(out, block)
                case Text(wide=False):
                    out.print(f"{block.verdict}: {block.words}" if block.verdict else block.words, markup=False)
                case Bullets():
                    out.print(block.title, markup=False)
                    for item in block.sentences:
                        out.print(Padding(escape(item), (0, 0, 0, 2)))
                    out.print()
