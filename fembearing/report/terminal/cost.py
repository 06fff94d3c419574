"""What accuracy costs, for a terminal or a pipe of 80 characters."""

from rich.console import Console

from analytic.words import percent_of
from fembearing.check.cost.scene_cost import Cost
from fembearing.report.tables.cost import cost_table
from fembearing.report.terminal.table import show


def print_cost(out: Console, cost: Cost) -> None:
    """Print each ladder with error, bound, time and memory, and the machine."""
    show(out, cost_table(cost.ladders))
    machine = cost.provenance
    versions = ", ".join(f"{name} {version}" for name, version in machine.versions.items() if version)
    out.print(
        f"Tolerance {percent_of(cost.tolerance)}, {cost.cost.seconds:.0f} s in all.\n{machine.processor}, "
        f"{machine.cores} cores, {machine.platform}, Python {machine.python}; {versions}.",
        markup=False,
    )
