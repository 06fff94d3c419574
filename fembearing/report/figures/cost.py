"""What accuracy costs, as a picture that reads at a glance."""

import re
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from analytic.figures.style import BLUE, LETTERS, WIDTH, lettered
from fembearing.check.cost.ladder import Ladder, Method
from fembearing.report.phrases import capital
from fembearing.report.sections.cost import short_name

LEAST, MOST = 1e-4, 500.0  # %: what is nearer to the reference, or farther off, is drawn here
ON_A_PAGE = 4  # panels
HIGH, LINE, AROUND = 1.7, 0.15, 0.8  # inches: of a panel, of a line of the key below it, and around both
ROOM = 5.0  # before the shortest time and beyond the longest, for the number beside a point
SIDES = np.array([(-1, -1), (1, 1), (-1, 1), (1, -1)])  # of a point, where its number may stand
BESIDE = 11.0  # pixels, from a point to the middle of its number
UNITS = {"seconds": (1.0, "time, s"), "memory": (2.0**-30, "memory, GiB")}


def cost_figures(ladders: Sequence[Ladder], *, tolerance: float, most: int = ON_A_PAGE) -> list[Figure]:
    """A panel for each quantity, error of each method against its median time, and one for the memory of all of them.

    most : panels in a figure
    A bar reaches from the error to its bound. The reference is hollow and stands at its own bound. A ring marks the
    chosen method. A line joins what one method gives on finer meshes or more points. Memory is drawn where it was
    measured. All panels share the error's scale, those of time the time's.
    """
    shown = [ladder for ladder in ladders if ladder.methods]
    sized = [ladder for ladder in shown if any(method.memory for method in ladder.methods)]
    times = [place[0] for ladder in shown for method in ladder.methods if (place := _place(method, "seconds"))]
    low, high = min(times, default=1.0) / ROOM, max(times, default=1.0) * ROOM
    contents = [*shown, *([None] if sized else [])]  # None: memory
    figures = []
    for part in (contents[first : first + most] for first in range(0, len(contents), most)):
        lines = [1 + len(sized) if ladder is None else len(ladder.methods) for ladder in part]
        figure, places = _empty(lines, WIDTH if most <= ON_A_PAGE else 1.5 * WIDTH)
        for ladder, (panel, key) in zip(part, places, strict=True):
            panel.set(yscale="log", ylim=(LEAST / 10, MOST))
            panel.axhline(100 * tolerance, color="red", linestyle=":", label="tolerance")
            panel.grid(alpha=0.3)
            if ladder is None:
                _draw_memory(panel, key, sized)
                continue
            panel.set(title=capital(ladder.quantity), xlabel=UNITS["seconds"][1], xscale="log", xlim=(low, high))
            panel.xaxis.set_major_locator(LogLocator(numticks=6))
            panel.xaxis.set_minor_formatter(NullFormatter())
            _draw(panel, ladder, "seconds", BLUE)
            _number(panel, key, ladder)
        figures.append(lettered(figure))
    return figures


def _empty(lines: Sequence[int], width: float) -> tuple[Figure, list[tuple[Axes, Axes]]]:
    """A figure, inches wide, with panels in rows, each with the place of a key of so many lines below it."""
    columns = 2 if len(lines) == ON_A_PAGE else min(3, len(lines))
    rows = [max(lines[first : first + columns]) for first in range(0, len(lines), columns)]
    heights = [height for count in rows for height in (HIGH, LINE * count)]
    figure = Figure(figsize=(width, sum(heights) + AROUND * len(rows)), layout="constrained")
    grid = figure.add_gridspec(2 * len(rows), columns, height_ratios=heights)
    places = []
    for row, column in (divmod(place, columns) for place in range(len(lines))):
        panel, key = figure.add_subplot(grid[2 * row, column]), figure.add_subplot(grid[2 * row + 1, column])
        panel.set_ylabel("" if column else "error, %")
        key.axis("off")
        places.append((panel, key))
    return figure, places


def _draw_memory(panel: Axes, key: Axes, ladders: Sequence[Ladder]) -> None:
    """All ladders that know theirs, each in a colour."""
    for number, ladder in enumerate(ladders):
        _draw(panel, ladder, "memory", f"C{number}")
    most = max(method.memory or 0 for ladder in ladders for method in ladder.methods)
    panel.set(title="Memory", xlabel=UNITS["memory"][1], xlim=(0, 1.1 * UNITS["memory"][0] * most))
    handles = panel.get_legend_handles_labels()
    legend = key.legend(*handles, loc="upper left", fontsize=LETTERS, frameon=False, borderpad=0, labelspacing=0.2)
    legend.set_in_layout(False)


def _number(panel: Axes, key: Axes, ladder: Ladder) -> None:
    """Methods by number, with the names below the panel: names beside the points would lie on each other."""
    shown = [(number, method) for number, method in enumerate(ladder.methods, 1) if _place(method, "seconds")]
    places = [_place(method, "seconds") or (0.0, 0.0) for _, method in shown]
    taken = [*panel.transData.transform(places)] if places else []
    for (number, _), place, point in zip(shown, places, [*taken], strict=True):
        far = [min(np.linalg.norm(point + BESIDE * side - other) for other in taken) for side in SIDES]
        right, up = SIDES[np.argmax(far)]
        taken.append(point + BESIDE * SIDES[np.argmax(far)])
        panel.annotate(
            f"{number}",
            place,
            xytext=(4 * right, 3 * up),
            textcoords="offset points",
            ha="left" if right > 0 else "right",
            va="bottom" if up > 0 else "top",
            fontsize=LETTERS,
        )
    names = (f"{number} {short_name(method.name)}" for number, method in shown)
    key.text(0, 1, "\n".join(names), va="top", fontsize=LETTERS).set_in_layout(False)


def _draw(panel: Axes, ladder: Ladder, price: str, colour: str) -> None:
    """One ladder over what its methods take: seconds, or memory."""
    drawn = [(method, *place) for method in ladder.methods if (place := _place(method, price))]
    families: dict[str, list[tuple[float, float]]] = {}  # a name without its numbers: one discretisation
    for method, x, y in drawn:
        if method.error is not None:
            families.setdefault(re.sub(r"\d+", "#", method.name), []).append((x, y))
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


def _place(method: Method, price: str) -> tuple[float, float] | None:
    """Where a method is drawn: its price, and its error in per cent, the reference's bound; None if it is not known."""
    taken, known = getattr(method, price), method.bound if method.error is None else method.error
    return None if taken is None or known is None else (UNITS[price][0] * taken, _height(known))


def _height(error: float) -> float:
    return min(max(100 * error, LEAST), MOST)
