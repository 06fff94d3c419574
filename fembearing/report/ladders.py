"""What accuracy costs, as a picture that reads at a glance and as a table for other programs."""

import csv
from collections.abc import Sequence
from io import StringIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from fembearing.compare.ladder import Ladder, Rung
from fembearing.report.wording import short_name

LEAST, MOST = 1e-4, 500.0  # %: what is nearer to the reference, or farther off, is drawn here
COLUMNS = (
    *("name", "error", "bound", "seconds", "spread", "repeats", "warm_up", "predicted", "memory", "unknowns"),
    *("chosen", "failed"),
)
WIDE, HIGH = 3.6, 3.4  # inches, of a panel
LINE = 9.0  # points from one name to the next at least
UNITS = {"seconds": (1.0, "time, s"), "memory": (2.0**-30, "memory, GiB")}


def cost_figure(ladders: Sequence[Ladder], *, tolerance: float) -> Figure:
    """A panel for each quantity: error of each rung against its median time, and below against its memory.

    A bar reaches from the error to its bound. The reference is hollow and stands at its own bound; the chosen rung has
    a ring. Memory is drawn where it was measured. All panels of a row share their axes.
    """
    shown = [ladder for ladder in ladders if ladder.rungs]
    rows = [price for price in UNITS if any(getattr(rung, price) for ladder in shown for rung in ladder.rungs)]
    figure = Figure(figsize=(WIDE * max(len(shown), 1) + 0.6, HIGH * max(len(rows), 1)), layout="constrained")
    panels = figure.subplots(max(len(rows), 1), max(len(shown), 1), squeeze=False, sharex="row", sharey=True)
    for row, price in zip(panels, rows, strict=False):
        for panel, ladder in zip(row, shown, strict=True):
            _panel(panel, ladder, price, tolerance=tolerance)
            panel.set_xlabel(UNITS[price][1])
        row[0].set(xscale="log", yscale="log", ylabel="error, %", ylim=(LEAST / 3, MOST))
        row[0].text(
            *(0.98, 100 * tolerance * 1.15, f"tolerance {100 * tolerance:.3g} %"),
            transform=row[0].get_yaxis_transform(),
            color="red",
            fontsize=7,
            ha="right",
        )
        taken = [place[0] for ladder in shown for rung in ladder.rungs if (place := _place(rung, price))]
        low, high = 10 ** np.floor(np.log10(min(taken))), 10 ** np.floor(np.log10(max(taken)) + 1)
        row[0].set_xlim(low, high)
        for panel, ladder in zip(row, shown, strict=True):
            panel.xaxis.set_minor_formatter(NullFormatter())
            if price == rows[0]:
                panel.set_title(f"{ladder.quantity[0].upper()}{ladder.quantity[1:]}", fontsize=10)
                _name(panel, ladder, price, middle=(low * high) ** 0.5)
    return figure


def _panel(panel: Axes, ladder: Ladder, price: str, *, tolerance: float) -> None:
    """One ladder over what its rungs take: seconds, or memory."""
    panel.axhline(100 * tolerance, color="red", linestyle=":", label="tolerance")
    drawn = [(rung, *place) for rung in ladder.rungs if (place := _place(rung, price))]
    compared = [(x, y) for rung, x, y in drawn if rung.error is not None]
    x, y = np.transpose(compared or np.empty((0, 2)))
    (line,) = panel.plot(x, y, "o-", label=ladder.quantity, markersize=5, linewidth=1)
    colour = line.get_color()
    for rung, x, y in drawn:
        if rung.error is None:
            panel.plot([x], [y], "o", color=colour, markersize=5, markerfacecolor="white")
        elif rung.bound is not None:
            panel.plot([x, x], [y, _height(rung.bound)], "-_", color=colour, alpha=0.6, linewidth=1, markevery=[1])
        if rung.chosen:
            panel.plot([x], [y], "o", color=colour, markersize=11, markerfacecolor="none")
    panel.grid(alpha=0.3)
    panel.tick_params(labelsize=8)


def _name(panel: Axes, ladder: Ladder, price: str, *, middle: float) -> None:
    """Names beside their rungs, towards the middle of the panel, pushed apart where they would overlap.

    Curves fall: names stand above and right of cheap rungs, below and left of dear ones.
    """
    per_decade = 72 * 0.75 * HIGH / np.log10(3 * MOST / LEAST)  # points, about
    drawn = [(rung, *place) for rung in ladder.rungs if (place := _place(rung, price))]
    for cheap, up in ((True, 1), (False, -1)):
        last = -np.inf
        for rung, x, y in sorted(
            (each for each in drawn if (each[1] < middle) == cheap), key=lambda each: up * each[2]
        ):
            there = up * per_decade * np.log10(y)
            last = max(there + (3 if cheap else 10), last + LINE)
            panel.annotate(
                short_name(rung.name),
                (x, y),
                xytext=(6 * up, up * (last - there)),
                textcoords="offset points",
                ha="left" if cheap else "right",
                fontsize=7,
            )


def _place(rung: Rung, price: str) -> tuple[float, float] | None:
    """Where a rung is drawn: its price, and its error in per cent, the reference's bound; None if it is not known."""
    taken, known = getattr(rung, price), rung.bound if rung.error is None else rung.error
    return None if taken is None or known is None else (UNITS[price][0] * taken, _height(known))


def _height(error: float) -> float:
    return min(max(100 * error, LEAST), MOST)


def cost_table(ladders: Sequence[Ladder]) -> str:
    """Every rung as a line of comma-separated values, SI, errors relative; an absent ladder with its reason."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("quantity", "reference", *COLUMNS))
    for ladder in ladders:
        for rung in ladder.rungs:
            writer.writerow((ladder.quantity, ladder.reference, *(getattr(rung, column) for column in COLUMNS)))
        if ladder.absent is not None:
            writer.writerow((ladder.quantity, f"absent: {ladder.absent}", *("" for _ in COLUMNS)))
    return text.getvalue()
