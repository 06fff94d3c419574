"""The friction torque by effect, with its 95 % interval and the makers' formulas.

Over speed or load where that alone varies: stacked parts, and from a decade on lines on logarithmic axes. Else a bar
for each operating point, and for one point a bar for each part. The figure is narrow: its letters stay legible on a
telephone.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from analytic.errors import InputError, require_packages
from analytic.figures.series_axis import LOADS, SPEED, Columns, SeriesAxis, axis_of
from analytic.figures.style import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    YELLOW,
    give_title,
    plain_numbers,
)
from analytic.scene import Array
from analytic.units import Units, load_words, speed_words
from analytic.words import rounded

if TYPE_CHECKING:  # charts in a browser take the parts alone
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

PARTS = {  # from the bottom, with words for the legend
    "spin": ("spin", BLUE),
    "conformity": ("conformity slip", SKY),
    "hysteresis": ("hysteresis", GREEN),
    "rolling": ("rolling against the oil", ORANGE),
    "cage": ("cage", PURPLE),
    "oil": ("oil outside the contacts", YELLOW),
    "declared": ("declared: seals, drag", GREY),
}
MAKERS: Mapping[str, tuple[str, str]] = {"SKF": ("-", "s"), "Palmgren": (":", "v"), "ISO 15312": ("-.", "D")}
OF_MAKERS = RED  # line and mark of each, in one colour
INTERVAL, UNCERTAINTY = "95 % interval", "its uncertainty"
WIDTH, HIGH = 4.6, 4.6  # inches: letters of 10 points are 12 pixels high where the figure is 390 pixels wide
BAR = 0.32  # inches of height for a bar with its name
MOST_NAMES = 24  # of bars
ROOM = 1.5  # of the longest bar: for the number beside it
RESIDUE = 1e-6  # of the total: a smaller part is what is left of a balance of the balls, not a torque
SMALL = 1e-3  # of the total: a smaller part has one digit
LEAST_PART = 0.05  # of the least total: smaller parts do not stretch a logarithmic axis
BELOW = 0.7  # of the least that is drawn: where a logarithmic axis begins
DARK = "0.25"
LETTERS = 9  # points, of the legend and of numbers beside bars


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnTorque:
    """What a figure shows of a torque."""

    columns: Columns  # (n,) SI, by name; with interval_low and interval_high where an interval is known
    makers: Mapping[str, Array]  # (n,) N m, by the name of the formula; NaN where it does not hold
    title: str  # bearing, oil and temperature
    units: Units

    @property
    def known(self) -> "DrawnTorque":
        """The same at the points that have a torque. Raises InputError where none has one."""
        at = np.isfinite(self.columns["torque_total"])
        if not at.any():
            raise InputError("no operating point has a torque, so that there is no figure")
        columns, makers = ({name: values[at] for name, values in each.items()} for each in (self.columns, self.makers))
        return replace(self, columns=columns, makers=makers)

    @property
    def axis(self) -> SeriesAxis:
        """What the points are drawn over, with the columns in its order."""
        return axis_of(self.columns, self.units)

    @property
    def has_interval(self) -> bool:
        """Whether any point has one."""
        return bool(np.isfinite(self.columns.get("interval_low", np.nan)).any())

    @property
    def bands(self) -> dict[str, Array]:
        """(2, n) least and greatest torque of each maker, in the shown unit, along the axis.

        A maker may have two constants: "Palmgren, z = 0.0004", of which one bearing has some and another one others.
        """
        found: dict[str, list[Array]] = {}
        for name, values in self.makers.items():
            if np.isfinite(values).any():
                found.setdefault(name.partition(",")[0], []).append(values[self.axis.order])
        factor = self.units.torque.factor
        return {name: factor * np.array([np.fmin.reduce(each), np.fmax.reduce(each)]) for name, each in found.items()}

    @property
    def total(self) -> Array:
        """(n,) in the shown unit, along the axis."""
        return self.units.torque.factor * self.axis.columns["torque_total"]

    @property
    def ends(self) -> Array:
        """(2, n) of the interval, else of the uncertainty as far as it is known, in the shown unit, along the axis."""
        columns = self.axis.columns
        if self.has_interval:
            return self.units.torque.factor * np.array([columns["interval_low"], columns["interval_high"]])
        half = np.zeros_like(self.total)
        for name in ("uncertainty_numerical", "uncertainty_model"):
            half = half + np.nan_to_num(columns.get(name, np.zeros_like(half)), posinf=0.0)
        return np.array([self.total * (1 - half), self.total * (1 + half)])

    @property
    def parts(self) -> dict[str, tuple[str, Array]]:
        """Colour and torque, in the shown unit along the axis, of each part that is there, by its words."""
        axis, factor = self.axis, self.units.torque.factor
        found = {words: (colour, axis.of(f"torque_{part}")) for part, (words, colour) in PARTS.items()}
        return {words: (colour, factor * part) for words, (colour, part) in found.items() if part is not None}

    def seen_parts(self, least: float) -> dict[str, tuple[str, Array]]:
        """Those that exceed a share of the least total somewhere."""
        floor = least * self.total.min()
        return {words: each for words, each in self.parts.items() if np.nanmax(each[1]) > floor}

    @property
    def heading(self) -> str:
        """Of the axis of torques."""
        return f"friction torque, {self.units.torque.name}"


def torque_figure(drawn: DrawnTorque) -> "Figure":
    """The figure of a torque at all operating points that have one.

    Raises InputError where none has one, MissingPackageError without Matplotlib.
    """
    require_packages("a figure", "matplotlib")
    known = drawn.known
    if known.total.size == 1:
        return _one_point(known)
    if known.axis.joined:
        return _over(known)
    title = "\n".join(filter(None, [known.title, known.axis.fixed]))
    return bars_figure(known, known.axis.names, title)


def is_logarithmic(drawn: DrawnTorque) -> bool:
    """Whether both axes of the figure are logarithmic."""
    return drawn.axis.spans_a_decade and bool(np.all(drawn.total > 0))


def _over(drawn: DrawnTorque) -> "Figure":
    """Parts over speed or load: stacked up to the total, or lines on logarithmic axes."""
    figure, panel = panel_of(HIGH)
    axis, total = drawn.axis, drawn.total
    logarithmic = is_logarithmic(drawn)
    if logarithmic:
        for words, (colour, part) in drawn.seen_parts(LEAST_PART).items():
            panel.plot(axis.values, np.where(part > 0, part, np.nan), color=colour, linewidth=1.3, label=words)
    else:
        below = np.zeros_like(total)
        for words, (colour, part) in drawn.seen_parts(RESIDUE).items():
            panel.fill_between(axis.values, below, below + part, color=colour, alpha=0.75, linewidth=0, label=words)
            below = below + part
    words = INTERVAL if drawn.has_interval else UNCERTAINTY
    if logarithmic:
        panel.fill_between(axis.values, *drawn.ends, color=BLACK, alpha=0.15, linewidth=0, label=words)
    else:
        for number, edge in enumerate(drawn.ends):
            panel.plot(axis.values, edge, "--", color=BLACK, linewidth=0.8, label="_" if number else words)
    panel.plot(axis.values, total, "-" + axis.mark, color=BLACK, markersize=4, linewidth=2, label="total")
    for name, (low, high) in drawn.bands.items():
        line, _ = MAKERS.get(name, ("--", "x"))
        panel.plot(axis.values, high, line, color=OF_MAKERS, linewidth=1.1, label=name)
        if np.nanmax(high - low) > 0:
            panel.plot(axis.values, low, line, color=OF_MAKERS, linewidth=1.1, label="_")
            panel.fill_between(axis.values, low, high, color=OF_MAKERS, alpha=0.12, linewidth=0)
    axis.apply(panel)
    panel.set_ylabel(drawn.heading)
    panel.grid(alpha=0.3)
    if logarithmic:
        every = [total, *drawn.ends, *(end for band in drawn.bands.values() for end in band)]
        parts = [part[part >= LEAST_PART * total.min()] for _, part in drawn.parts.values()]
        logarithmic_torques(panel, np.concatenate([*every, *parts]))
    else:
        panel.set_ylim(0, None)
    finish(figure, f"{drawn.title}\n{axis.fixed}")
    return figure


def logarithmic_torques(panel: "Axes", values: Array) -> None:
    """Make the axis of torques logarithmic, with room below the least of the values."""
    panel.set_yscale("log")
    panel.set_ylim(BELOW * values[values > 0].min(), np.nanmax(values) / BELOW)
    plain_numbers(panel.yaxis)


def bars_figure(drawn: DrawnTorque, names: Sequence[str], title: str) -> "Figure":
    """A bar of parts for each operating point with its name, the first one on top."""
    count, lines = drawn.total.size, 1 + max(name.count("\n") for name in names)
    figure, panel = panel_of(2.1 + BAR * lines * min(count, MOST_NAMES))
    place, before = np.arange(count), np.zeros(count)
    for words, (colour, part) in drawn.seen_parts(RESIDUE).items():
        values = np.nan_to_num(part)
        panel.barh(place, values, 0.7, left=before, color=colour, alpha=0.75, label=words)
        before = before + values
    words = INTERVAL if drawn.has_interval else UNCERTAINTY.removeprefix("its ")
    look = {"fmt": "o", "color": BLACK, "capsize": 3, "markersize": 4}
    panel.errorbar(drawn.total, place, xerr=lengths(drawn), label=f"total, {words}", **look)
    for maker, (low, high) in drawn.bands.items():
        mark = MAKERS.get(maker, ("--", "x"))[1]
        panel.hlines(place + 0.4, low, high, color=OF_MAKERS, linewidth=1)
        for values, label in ((high, maker), (low, "_")):
            panel.plot(values, place + 0.4, mark, color=OF_MAKERS, markersize=3, label=label)
    step = -(-count // MOST_NAMES)
    panel.set_yticks(place[::step], names[::step], fontsize=LETTERS)
    panel.set_ylim(count - 0.4, -0.6)
    panel.set_xlim(0, None)
    panel.set_xlabel(drawn.heading)
    panel.grid(alpha=0.3, axis="x")
    finish(figure, title)
    return figure


def _one_point(drawn: DrawnTorque) -> "Figure":
    """A bar for each part, one for the total with its interval, and one for each maker, each with its number."""
    rows = [(words, colour, float(part[0])) for words, (colour, part) in drawn.parts.items()]
    rows.append(("total", DARK, float(drawn.total[0])))
    makers = [(maker, *map(float, band[:, 0])) for maker, band in drawn.bands.items() if np.isfinite(band).all()]
    figure, panel = panel_of(1.7 + BAR * (len(rows) + len(makers)))
    place, values = np.arange(len(rows)), np.array([row[2] for row in rows])
    panel.barh(place, values, 0.7, color=[row[1] for row in rows])
    end = values[-1]
    if drawn.has_interval:
        end = max(end, float(drawn.ends[1, 0]))
        look = {"fmt": "none", "ecolor": BLACK, "capsize": 4, "linewidth": 1.3}
        panel.errorbar(values[-1:], place[-1:], xerr=lengths(drawn), **look)
    beside = {"textcoords": "offset points", "va": "center", "fontsize": LETTERS}
    for number, value in enumerate(values):
        shown = value if value > RESIDUE * values[-1] else 0.0
        words = f"{shown:.4g}" if shown >= SMALL * values[-1] or shown == 0 else f"{shown:.1g}"
        panel.annotate(words, (end if number == len(values) - 1 else value, number), xytext=(4, 0), **beside)
    for number, (_, low, high) in enumerate(makers, start=len(rows)):
        panel.plot([low, high], [number, number], "-|", color=OF_MAKERS, linewidth=3, markersize=8)
        words = "-".join(dict.fromkeys(rounded(each, 3) for each in (low, high)))
        panel.annotate(words, (high, number), xytext=(6, 0), **beside)
    names = [*(row[0] for row in rows), *(f"{maker}, formula" for maker, *_ in makers)]
    panel.set_yticks(np.arange(len(names)), names)
    panel.invert_yaxis()
    panel.set_xlim(0, ROOM * max([*values, end, *(high for _, _, high in makers)]) or 1.0)
    panel.set_xlabel(drawn.heading)
    panel.grid(alpha=0.3, axis="x")
    panel.set_axisbelow(True)
    title = f"{drawn.title}\n{point_words(drawn)}\n{_how_exact(drawn)}"
    give_title(figure, title, fontsize=10)
    return figure


def point_words(drawn: DrawnTorque) -> str:
    """Loads and speed of the first operating point."""
    point = {name: float(drawn.columns[name][0]) for name in (*LOADS, SPEED)}
    loads = [name for name in LOADS if point[name]] or ["axial_load"]
    return ", ".join(
        [*(load_words(name, point[name], drawn.units) for name in loads), speed_words(point[SPEED], drawn.units)]
    )


def _how_exact(drawn: DrawnTorque) -> str:
    """The interval of one point, or how uncertain its total is, in words."""
    if drawn.has_interval:
        ends = "-".join(rounded(float(end), 3) for end in drawn.ends[:, 0])
        return f"95 % interval {ends} {drawn.units.torque.name}"
    numerical, model = (
        float(drawn.columns.get(f"uncertainty_{name}", np.array([np.nan]))[0]) for name in ("numerical", "model")
    )
    words = f"\u00b1 {100 * numerical:.2g} % numerical" if np.isfinite(numerical) else "numerical uncertainty unknown"
    return words if not np.isfinite(model) else f"{words}, \u00b1 {100 * model:.2g} % by the formulas"


def panel_of(high: float) -> "tuple[Figure, Axes]":
    """A narrow figure with one panel; high : inches"""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, high), layout="constrained")
    return figure, figure.subplots()


def lengths(drawn: DrawnTorque) -> Array:
    """(2, n) of the bars from the total to both ends; skewed ends may cross the total."""
    return np.maximum([drawn.total - drawn.ends[0], drawn.ends[1] - drawn.total], 0.0)


def finish(figure: "Figure", title: str, *, columns: int = 2) -> None:
    """Title above and legend below, where no data are."""
    give_title(figure, title, fontsize=10)
    handles, words = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=columns, frameon=False, fontsize=LETTERS)
