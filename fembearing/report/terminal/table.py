"""The form of every table for a terminal."""

from rich.box import SIMPLE_HEAD
from rich.console import Console
from rich.markup import escape
from rich.table import Table as Printed

from fembearing.report.tables.table import Table

MANY = 11  # columns; more stand close together, to fit a screen of 80 characters


def show(out: Console, table: Table) -> None:
    """Print a table with its notes; each group as a table, as a terminal has no cell over several columns."""
    blank = [""] if len(table.groups) > 1 else []
    for group in table.groups:
        out.print(group.title or table.label, style="italic", markup=False)
        if group.rows:
            out.print(printed(Table("", table.heads, [group])))
        _tell(out, *group.notes, *blank)
    _tell(out, *table.notes, "")


def _tell(out: Console, *notes: str) -> None:
    """Print sentences, each on lines of its own."""
    for note in notes:
        out.print(note, style="dim", markup=False)


def printed(table: Table) -> Printed:
    """A table for a terminal of 80 characters, without its wide columns."""
    heads = [(place, head) for place, head in enumerate(table.heads) if not head.wide]
    shown = Printed(
        title=escape(table.label),
        title_justify="left",
        box=SIMPLE_HEAD,
        padding=(0, int(len(heads) <= MANY), 0, 0),
        pad_edge=False,
        show_edge=False,
    )
    for _, head in heads:
        whole = head.fixed or head.kind in ("name", "verdict")
        justify = "right" if head.kind == "number" else "left"
        shown.add_column(escape(head.short or head.text), justify=justify, no_wrap=whole)
    for group in table.groups:
        for row in group.rows:
            shown.add_row(*(escape(row[place]) for place, _ in heads))
    return shown
