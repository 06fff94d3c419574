"""What accuracy costs, as tables for a terminal or a pipe of 80 characters."""

from rich.console import Console

from analytic.words import percent_of
from fembearing.report.phrases import capital, choices_line, short_name, shown
from fembearing.report.terminal.table import table_of
from fembearing.verify.cost.scene_cost import Cost

HEADS = ("", "method", "error", "bound", "seconds", "spread", "first", "GiB")


def print_cost(out: Console, cost: Cost) -> None:
    """Print each ladder with error, bound, time and memory; an arrow marks the method that the tolerance takes."""
    for ladder in cost.ladders:
        title = capital(ladder.quantity)
        if ladder.absent is not None:
            out.print(f"{title}: does not apply: {ladder.absent}.\n", markup=False)
            continue
        table = table_of(HEADS, title=title, left=("", "method"), fixed=HEADS)
        for method in ladder.methods:
            table.add_row(
                ">" if method.chosen else "",
                short_name(method.name),
                "failed" if method.failed else shown(method.error, ".2g", 100, " %", absent="reference"),
                shown(method.bound, ".2g", 100, " %", absent=""),
                shown(method.seconds, ".2g", absent=""),
                shown(method.spread, ".1g", absent=""),
                shown(method.warm_up, ".1g", absent=""),
                shown(method.memory, ".2f", 2**-30, absent=""),
            )
        out.print(table)
        for method in ladder.methods:
            if method.failed:
                out.print(f"{method.name} failed: {method.failed}", markup=False)
        out.print(f"Price of the next digit: {choices_line(ladder)}.")
        out.print(f"Reference: {ladder.reference}.\n", style="dim")
    machine = cost.provenance
    versions = ", ".join(f"{name} {version}" for name, version in machine.versions.items() if version)
    out.print(
        f">: the cheapest method that is known to be within the tolerance, {percent_of(cost.tolerance)}. Bound: on "
        "the error, known before the reference is. Seconds: median of the repeats; first: the call before them; GiB: "
        f"resident memory at most while it ran. {cost.cost.seconds:.0f} s in all.\n{machine.processor}, "
        f"{machine.cores} cores, {machine.platform}, Python {machine.python}; {versions}."
    )
