"""Friction of a ball on both races for a terminal of 80 characters."""

from rich.console import Console

from fembearing.report.tables.creep import creep_notes, creep_tables
from fembearing.report.terminal.table import printed
from fembearing.verify.creep.scene_creep import CreepNumbers


def print_creep(out: Console, creep: CreepNumbers) -> None:
    """Print each quantity by formula, production and reference."""
    for table in creep_tables(creep):
        out.print(printed(table))
        out.print()
    out.print("\n".join(creep_notes(creep)) + "\n", style="dim", markup=False)
