"""What accuracy costs, as tables for a terminal or a pipe of 80 characters."""

from rich.console import Console
from rich.table import Table

from fembearing.compare.cost.scene_cost import Cost
from fembearing.provenance import provenance_of
from fembearing.report.phrases import PLAIN, capital, choices_line, short_name


def print_cost(out: Console, cost: Cost) -> None:
    """Print each ladder with error, bound, time and memory; an arrow marks the method that the tolerance takes."""
    for ladder in cost.ladders:
        title = capital(ladder.quantity)
        if ladder.absent is not None:
            out.print(f"{title}: does not apply: {ladder.absent}.\n", markup=False)
            continue
        table = Table(title=title, **PLAIN)
        for head in ("", "rung", "error", "bound", "seconds", "spread", "first", "GiB"):
            table.add_column(head, justify="left" if head in ("", "rung") else "right", no_wrap=True)
        for rung in ladder.rungs:
            table.add_row(
                ">" if rung.chosen else "",
                short_name(rung.name),
                "failed" if rung.failed else "reference" if rung.error is None else f"{100 * rung.error:.2g} %",
                "" if rung.bound is None else f"{100 * rung.bound:.2g} %",
                "" if rung.seconds is None else f"{rung.seconds:.2g}",
                "" if rung.spread is None else f"{rung.spread:.1g}",
                "" if rung.warm_up is None else f"{rung.warm_up:.1g}",
                "" if rung.memory is None else f"{rung.memory / 2**30:.2f}",
            )
        out.print(table)
        for rung in ladder.rungs:
            if rung.failed:
                out.print(f"{rung.name} failed: {rung.failed}", markup=False)
        out.print(f"Price of the next digit: {choices_line(ladder)}.")
        out.print(f"Reference: {ladder.reference}.\n", style="dim")
    machine = provenance_of(cost.scene)
    versions = ", ".join(f"{name} {version}" for name, version in machine["versions"].items() if version)
    out.print(
        f">: the cheapest rung that is known to be within the tolerance, {cost.tolerance:g}. Bound: on the error, "
        "known before the reference is. Seconds: median of the repeats; first: the call before them; GiB: resident "
        f"memory at most while it ran. {cost.seconds:.0f} s in all.\n"
        f"{machine['processor']}, {machine['cores']} cores, {machine['platform']}, Python {machine['python']}; "
        f"{versions}."
    )
