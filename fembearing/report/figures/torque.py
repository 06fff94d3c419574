"""The friction torque over the operating points, split by effect, with its 95 % interval and the makers' formulas."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.scene import Array
from fembearing.quantities import QUANTITIES
from fembearing.report.figures.series_axis import SeriesAxis, axis_of
from fembearing.report.figures.style import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    LETTERS,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    WIDTH,
    YELLOW,
    lettered,
)
from fembearing.report.torque import TorqueRecord

if TYPE_CHECKING:  # charts in a browser take the parts alone
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from fembearing.report.report import Report

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
BAR = 0.6  # width
HIGH = 3.4  # inches
NO_TORQUE = "No torque: the scene has neither a friction coefficient nor both lubricant and surface."
INTERVAL, UNCERTAINTY = "95 % interval", "its uncertainty"


@dataclass(frozen=True, kw_only=True, eq=False)
class Beside:
    """What stands beside the torque of each operating point, in the order of the points; N m, NaN: not known."""

    interval: Array  # (2, n) both ends
    makers: Mapping[str, Array]  # (2, n) least and greatest of the formulas of each maker

    @property
    def has_interval(self) -> bool:
        """Whether any point has one."""
        return bool(np.isfinite(self.interval).any())

    def along(self, axis: SeriesAxis) -> "Beside":
        """The same in the order and in the unit of an axis."""
        factor = axis.units.torque.factor
        makers = {name: factor * values[:, axis.order] for name, values in self.makers.items()}
        return Beside(interval=factor * self.interval[:, axis.order], makers=makers)


def beside_of(record: TorqueRecord) -> Beside:
    """What a record has beside the torque, at the points that have one."""
    places = range(len(record.points)) if not record.left_out else record.computed
    ends = [record.interval[place] or (np.nan, np.nan) for place in places]
    makers: dict[str, list[Array]] = {}
    for name, series in record.catalogue_band.values.items():  # a maker may have two constants: "Palmgren, z = 0.0004"
        values = np.array([np.nan if series[place] is None else series[place] for place in places], dtype=float)
        if np.isfinite(values).any():
            makers.setdefault(name.partition(",")[0], []).append(values)
    return Beside(
        interval=np.array(ends, dtype=float).T,
        makers={name: np.array([np.min(series, axis=0), np.max(series, axis=0)]) for name, series in makers.items()},
    )


def torque_plot(document: "Report") -> "tuple[Figure | None, str]":
    """Parts stacked up to the total, with its interval and the makers' formulas."""
    if document.torque is None:
        return None, NO_TORQUE
    if len(document.torque.points) == 1:
        return None, ""  # a table says it
    axis = axis_of(document.torque.points, document.units)
    beside = beside_of(document.torque).along(axis)
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, HIGH), layout="constrained")
    panel = figure.subplots()
    draw_parts(panel, axis)
    known = draw_total(panel, axis, beside)
    draw_makers(panel, axis, beside)
    axis.apply(panel)
    panel.set_ylabel(QUANTITIES["torque"].in_units(document.units).heading)
    panel.set_title(axis.fixed)
    panel.set_ylim(0, None)
    panel.grid(alpha=0.3)
    handles, words = panel.get_legend_handles_labels()
    figure.legend(handles, words, loc="outside right upper", frameon=False, fontsize=LETTERS)
    caption = f"Stacked parts of the torque; upper edge: total. {known}"
    caption += " The part of the cage includes its motion." if document.cage_records else ""
    if beside.makers:
        caption += f" Red: {', '.join(beside.makers)}, the makers' formulas for an open bearing of this size."
    return lettered(figure), caption


def draw_parts(panel: "Axes", axis: SeriesAxis) -> None:
    """Draw the parts, stacked."""
    below = np.zeros(axis.values.size)
    for name, (words, colour) in PARTS.items():
        part = axis.of("torque", name)
        if part is None:
            continue
        above = below + axis.units.torque.factor * part
        if axis.joined:
            panel.fill_between(axis.values, below, above, color=colour, alpha=0.75, linewidth=0, label=words)
        else:
            panel.bar(axis.values, above - below, BAR, bottom=below, color=colour, alpha=0.75, label=words)
        below = above


def total_of(axis: SeriesAxis, beside: Beside) -> tuple[Array, Array]:
    """(n,) the total as it is shown, and (2, n) the ends of its interval, else of its uncertainty as far as known."""
    total = axis.of("torque", "total")
    assert total is not None  # the total is always there
    total = axis.units.torque.factor * total
    if beside.has_interval:
        return total, beside.interval
    parts = [part for name in ("numerical", "model") if (part := axis.of("uncertainty", name)) is not None]
    half = np.sum(parts, axis=0) * np.ones_like(total)
    return total, np.array([total * (1 - half), total * (1 + half)])


def draw_total(panel: "Axes", axis: SeriesAxis, beside: Beside) -> str:
    """Draw the total with its interval; a sentence on what is drawn.

    beside : along the axis
    """
    total, ends = total_of(axis, beside)
    words = INTERVAL if beside.has_interval else UNCERTAINTY
    if axis.joined:
        for number, edge in enumerate(ends):
            label = "_" if number else words
            panel.plot(axis.values, edge, "--", color=BLACK, linewidth=0.8, label=label)
        panel.plot(axis.values, total, "-" + axis.mark, color=BLACK, markersize=4, label="total")
    else:
        apart = np.maximum([total - ends[0], ends[1] - total], 0.0)  # skewed ends may cross
        look: dict[str, Any] = {"fmt": "o", "color": BLACK, "capsize": 4, "markersize": 4}
        panel.errorbar(axis.values, total, apart, label=f"total, {words.removeprefix('its ')}", **look)
    drawn = "Dashed" if axis.joined else "Bars"
    if beside.has_interval:
        return f"{drawn}: its 95 % interval from solver, inputs and formulas."
    known = {"numerical": "numerical", "model": "of the model's formulas at 95 %"}
    named = [known[name] for name in known if axis.of("uncertainty", name) is not None]
    return f"{drawn}: its uncertainty, {' and '.join(named) or 'not known'}."


def draw_makers(panel: "Axes", axis: SeriesAxis, beside: Beside) -> None:
    """Draw what the formulas of each maker give; beside : along the axis."""
    for name, (low, high) in beside.makers.items():
        line, mark = MAKERS.get(name, ("--", "x"))
        if axis.joined:
            panel.plot(axis.values, high, line, color=OF_MAKERS, linewidth=1.1, label=name)
            if np.nanmax(high - low) > 0:
                panel.plot(axis.values, low, line, color=OF_MAKERS, linewidth=1.1, label="_")
                panel.fill_between(axis.values, low, high, color=OF_MAKERS, alpha=0.12, linewidth=0)
        else:
            place = axis.values + BAR / 2 + 0.08
            panel.vlines(place, low, high, color=OF_MAKERS, linewidth=1)
            panel.plot(place, high, mark, color=OF_MAKERS, markersize=4, label=name)
            panel.plot(place, low, mark, color=OF_MAKERS, markersize=4, label="_")
