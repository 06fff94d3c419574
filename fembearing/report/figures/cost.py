"""What accuracy costs, as a picture that reads at a glance and as a table for other programs."""

import csv
import re
from collections.abc import Sequence
from io import StringIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

from analytic.figures.style import BLUE, LETTERS, SIDE_BY_SIDE, WIDTH, lettered
from fembearing.check.cost.ladder import Ladder, Method
from fembearing.report.phrases import capital, short_name

LEAST, MOST = 1e-4, 500.0  # %: what is nearer to the reference, or farther off, is drawn here
COLUMNS = (
    *("name", "error", "bound", "seconds", "spread", "repeats", "warm_up", "predicted", "memory", "unknowns"),
    *("chosen", "failed"),
)
HIGH = 3.2  # inches, of a panel with its key
ROOM = 5.0  # before the shortest time and beyond the longest, for the number beside a point
BELOW = -0.2  # of a panel's height: where its key begins, under the name of the axis
UNITS = {"seconds": (1.0, "time, s"), "memory": (2.0**-30, "memory, GiB")}


def cost_figures(ladders: Sequence[Ladder], *, tolerance: float, most: int = SIDE_BY_SIDE) -> list[Figure]:
    """A panel for each quantity, error of each method against its median time, and one for the memory of all of them.

    most : panels in a figure
    A bar reaches from the error to its bound. The reference is hollow and stands at its own bound. A ring marks the
    chosen method. A line joins what one method gives on finer meshes or more points. Memory is drawn where it was
    measured. All panels share the error's scale, those of time the time's.
    """
    shown = [ladder for ladder in ladders if ladder.methods]
    with_memory = [ladder for ladder in shown if any(method.memory for method in ladder.methods)]
    count = len(shown) + bool(with_memory)
    figures = [_empty(min(most, count - first)) for first in range(0, count, most)]
    panels = [panel for figure in figures for panel in figure.axes]
    times = [place[0] for ladder in shown for method in ladder.methods if (place := _place(method, "seconds"))]
    low, high = min(times, default=1.0) / ROOM, max(times, default=1.0) * ROOM
    for panel in panels:
        panel.set(xscale="log", yscale="log", ylim=(LEAST / 3, MOST), xlabel=UNITS["seconds"][1], xlim=(low, high))
        panel.axhline(100 * tolerance, color="red", linestyle=":", label="tolerance")
        panel.xaxis.set_major_locator(LogLocator(numticks=4))
        panel.xaxis.set_minor_formatter(NullFormatter())
        panel.grid(alpha=0.3)
    for panel, ladder in zip(panels, shown, strict=False):
        panel.set_title(capital(ladder.quantity).replace(" of the ", "\nof the "))
        _draw(panel, ladder, "seconds", BLUE)
        _number(panel, ladder)
    if with_memory:
        sizes = [place[0] for ladder in with_memory for method in ladder.methods if (place := _place(method, "memory"))]
        panels[-1].set(xlabel=UNITS["memory"][1], xscale="linear", xlim=(0, 1.1 * max(sizes)))
        panels[-1].set_title("Memory")
        for number, ladder in enumerate(with_memory):
            _draw(panels[-1], ladder, "memory", f"C{number}")
        panels[-1].legend(loc="upper left", bbox_to_anchor=(0.0, BELOW), fontsize=LETTERS, frameon=False, borderpad=0)
    return [lettered(figure) for figure in figures]


def _empty(count: int) -> Figure:
    """A figure with so many panels, side by side as they fit."""
    rows = -(-count // SIDE_BY_SIDE)
    columns = -(-count // rows)
    figure = Figure(figsize=(WIDTH, HIGH * rows), layout="constrained")
    for place in range(count):
        panel = figure.add_subplot(rows, columns, 1 + place)
        panel.set_ylabel("" if place % columns else "error, %")
    return figure


def _draw(panel: Axes, ladder: Ladder, price: str, colour: str) -> None:
    """One ladder over what its methods take: seconds, or memory."""
    drawn = [(method, *place) for method in ladder.methods if (place := _place(method, price))]
    families: dict[str, list[tuple[float, float]]] = {}
    for method, x, y in drawn:
        if method.error is not None:
            families.setdefault(_family(method), []).append((x, y))
    for number, places in enumerate(families.values()):
        label = "_" if number else ladder.quantity
        panel.plot(*np.transpose(places), "o-", color=colour, label=label, markersize=5, linewidth=1)
    for method, x, y in drawn:
        if method.error is None:
            panel.plot([x], [y], "o", color=colour, markersize=5, markerfacecolor="white")
        elif method.bound is not None:
            panel.plot([x, x], [y, _height(method.bound)], "-_", color=colour, alpha=0.6, linewidth=1, markevery=[1])
        if method.chosen:
            panel.plot([x], [y], "o", color=colour, markersize=11, markerfacecolor="none")


def _number(panel: Axes, ladder: Ladder) -> None:
    """Methods by number, with the names below the panel: names beside the points would lie on each other."""
    key = []
    for number, method in enumerate(ladder.methods, start=1):
        place = _place(method, "seconds")
        if place is None:
            continue
        above = method.error is None  # the reference often stands on the last method
        panel.annotate(
            f"{number}",
            *(place, (4, 3) if above else (-4, -4)),
            textcoords="offset points",
            ha="left" if above else "right",
            va="bottom" if above else "top",
            fontsize=LETTERS,
        )
        key.append(Line2D([], [], linestyle="none", label=f"{number} {short_name(method.name)}"))
    panel.legend(
        handles=key,
        loc="upper left",
        bbox_to_anchor=(0.0, BELOW),
        ncols=1,
        fontsize=LETTERS,
        frameon=False,
        handlelength=0,
        handletextpad=0,
        borderpad=0,
    )


def _family(method: Method) -> str:
    """What methods that differ by the fineness of one discretisation have in common: the name without its numbers."""
    return re.sub(r"\d+", "#", method.name)


def _place(method: Method, price: str) -> tuple[float, float] | None:
    """Where a method is drawn: its price, and its error in per cent, the reference's bound; None if it is not known."""
    taken, known = getattr(method, price), method.bound if method.error is None else method.error
    return None if taken is None or known is None else (UNITS[price][0] * taken, _height(known))


def _height(error: float) -> float:
    return min(max(100 * error, LEAST), MOST)


def cost_table(ladders: Sequence[Ladder]) -> str:
    """Every method as a line of comma-separated values, SI, errors relative; an absent ladder with its reason."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("quantity", "reference", *COLUMNS))
    for ladder in ladders:
        for method in ladder.methods:
            writer.writerow((ladder.quantity, ladder.reference, *(getattr(method, column) for column in COLUMNS)))
        if ladder.absent is not None:
            writer.writerow((ladder.quantity, f"absent: {ladder.absent}", *("" for _ in COLUMNS)))
    return text.getvalue()
