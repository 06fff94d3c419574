"""The sections of a document as tables and lines of text for a terminal or a pipe of 80 characters."""

from collections.abc import Iterable

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.padding import Padding
from rich.table import Table as Printed

from fembearing.report.document import Bullets, Section, Table, Text

MANY = 11  # columns; more stand close together, to fit a screen of 80 characters


def print_sections(out: Console, sections: Iterable[Section]) -> None:
    """Print the blocks one below the other; the labels of the tables take the place of the titles."""
    for section in sections:
        for block in section.blocks:
            match block:
                case Table():
                    _show(out, block)
                case Text(wide=False):
                    out.print(f"{block.verdict}: {block.words}" if block.verdict else block.words, markup=False)
                case Bullets(wide=False):
                    if block.title:
                        out.print(block.title, markup=False)
                    for item in block.sentences:
                        out.print(Padding(escape(item), (0, 0, 0, 2)))
                    out.print()


def _show(out: Console, table: Table) -> None:
    """Print a table with its notes; each group as a table, as a terminal has no cell over several columns."""
    blank = [""] if len(table.groups) > 1 else []
    for group in table.groups:
        out.print(group.title or table.label, style="italic", markup=False)
        if group.rows:
            out.print(_printed(table._replace(groups=[group])))
        _tell(out, *group.notes, *blank)
    _tell(out, *table.notes, "")


def _tell(out: Console, *notes: str) -> None:
    """Print sentences, each on lines of its own."""
    for note in notes:
        out.print(note, style="dim", markup=False)


def _printed(table: Table) -> Printed:
    """The rows for a terminal of 80 characters, without wide columns."""
    heads = [(place, head) for place, head in enumerate(table.heads) if not head.wide]
    shown = Printed(box=SIMPLE_HEAD, padding=(0, int(len(heads) <= MANY), 0, 0), pad_edge=False, show_edge=False)
    for _, head in heads:
        whole = head.fixed or head.kind in ("name", "verdict")
        justify = "right" if head.kind == "number" else "left"
        shown.add_column(escape(head.short or head.text), justify=justify, no_wrap=whole)
    for group in table.groups:
        for row in group.rows:
            shown.add_row(*(escape(row[place]) for place, _ in heads))
    return shown
