"""The friction torque by effect in a narrow figure of its own, whose letters stay legible on a telephone.

Over speed or load where that alone varies; else a bar for each operating point, and for one point a bar for each part.
Each has the 95 % interval and the makers' formulas.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.scene_torque import SceneTorque
from fembearing.quantities import QUANTITIES, SYSTEMS, Units
from fembearing.report.figures.series_axis import SeriesAxis, axis_of
from fembearing.report.figures.style import BLACK
from fembearing.report.figures.torque import (
    INTERVAL,
    MAKERS,
    OF_MAKERS,
    PARTS,
    UNCERTAINTY,
    Beside,
    beside_of,
    draw_makers,
    draw_parts,
    draw_total,
    total_of,
)
from fembearing.report.phrases import LOADS, between, loads_of, rounded, speed_words
from fembearing.report.tables.torque import RESIDUE
from fembearing.report.torque import torque_record

WIDTH = 4.6  # inches: letters of 10 points are 12 pixels high where the figure is 390 pixels wide
BAR = 0.32  # inches of height for a bar with its name
MOST_NAMES = 24  # of bars
ROOM = 1.5  # of the longest bar: for the number beside it
SMALL = 1e-3  # of the total: a smaller part has one digit
DARK = "0.25"


def figure_of_torque(result: SceneTorque) -> Figure:
    """The figure of a torque at all of its operating points."""
    points = result.friction.rows
    bearings = "" if result.friction.pair is None else "two "
    name = f"{bearings}{result.scene.bearing.name}"
    beside, units = beside_of(torque_record(result)), SYSTEMS[result.scene.report.units]
    if len(points) == 1:
        return _one_point(points[0], name, beside, units)
    axis = axis_of(points, units)
    return (_over if axis.joined else _bars)(axis, name, beside.along(axis))


def _over(axis: SeriesAxis, name: str, beside: Beside) -> Figure:
    """Parts stacked over speed or load."""
    figure = Figure(figsize=(WIDTH, 4.6), layout="constrained")
    panel = figure.subplots()
    draw_parts(panel, axis)
    draw_total(panel, axis, beside)
    draw_makers(panel, axis, beside)
    axis.apply(panel)
    panel.set_ylabel(_torque_heading(axis.units))
    panel.set_ylim(0, None)
    panel.grid(alpha=0.3)
    _finish(figure, panel, f"{name}, {axis.fixed}")
    return figure


def _bars(axis: SeriesAxis, name: str, beside: Beside) -> Figure:
    """A bar of parts for each operating point, the first one on top."""
    count, factor = len(axis.points), axis.units.torque.factor
    figure = Figure(figsize=(WIDTH, 2.1 + BAR * min(count, MOST_NAMES)), layout="constrained")
    panel = figure.subplots()
    place, before = np.arange(count), np.zeros(count)
    for part, (words, colour) in PARTS.items():
        values = axis.of("torque", part)
        if values is not None:
            panel.barh(place, factor * values, 0.7, left=before, color=colour, alpha=0.75, label=words)
            before = before + factor * values
    total, ends = total_of(axis, beside)
    apart = np.maximum([total - ends[0], ends[1] - total], 0.0)  # skewed ends may cross
    words = INTERVAL if beside.has_interval else UNCERTAINTY.removeprefix("its ")
    look = {"fmt": "o", "color": BLACK, "capsize": 3, "markersize": 4}
    panel.errorbar(total, place, xerr=apart, label=f"total, {words}", **look)
    for maker, (low, high) in beside.makers.items():
        panel.hlines(place + 0.4, low, high, color=OF_MAKERS, linewidth=1)
        for values, label in ((high, maker), (low, "_")):
            panel.plot(values, place + 0.4, MAKERS[maker][1], color=OF_MAKERS, markersize=3, label=label)
    step = -(-count // MOST_NAMES)
    panel.set_yticks(place[::step], axis.names[::step], fontsize=9)
    panel.set_ylim(count - 0.4, -0.6)
    panel.set_xlim(0, None)
    panel.set_xlabel(_torque_heading(axis.units))
    panel.grid(alpha=0.3, axis="x")
    _finish(figure, panel, ", ".join([name, *([axis.fixed] if axis.fixed else [])]))
    return figure


def _one_point(point: TorquePoint, name: str, beside: Beside, units: Units) -> Figure:
    """A bar for each part, one for the total with its interval, and one for each maker, each with its number."""
    torque, factor = units.torque, units.torque.factor
    parts = [(words, colour, getattr(point.torque, part)) for part, (words, colour) in PARTS.items()]
    rows = [(words, colour, factor * value) for words, colour, value in parts if value is not None]
    rows.append(("total", DARK, factor * point.torque.total))
    makers = [(maker, *(factor * values[:, 0])) for maker, values in beside.makers.items() if np.isfinite(values).all()]
    figure = Figure(figsize=(WIDTH, 1.5 + BAR * (len(rows) + len(makers))), layout="constrained")
    panel = figure.subplots()
    place, values = np.arange(len(rows)), np.array([row[2] for row in rows])
    panel.barh(place, values, 0.7, color=[row[1] for row in rows])
    ends = factor * beside.interval[:, 0]
    known = bool(np.isfinite(ends).all())
    if known:
        apart = np.maximum([[values[-1] - ends[0]], [ends[1] - values[-1]]], 0.0)
        panel.errorbar(values[-1:], place[-1:], xerr=apart, fmt="none", ecolor=BLACK, capsize=4, linewidth=1.3)
    for number, value in enumerate(values):
        shown = value if value > RESIDUE * values[-1] else 0.0
        words = f"{shown:.4g}" if shown >= SMALL * values[-1] or shown == 0 else f"{shown:.1g}"
        right = max(value, ends[1]) if known and number == len(values) - 1 else value
        panel.annotate(words, (right, number), xytext=(4, 0), textcoords="offset points", va="center", fontsize=9)
    for number, (_, low, high) in enumerate(makers, start=len(rows)):
        panel.plot([low, high], [number, number], "-|", color=OF_MAKERS, linewidth=3, markersize=8)
        words = "-".join(dict.fromkeys(rounded(end, 3) for end in (low, high)))
        panel.annotate(words, (high, number), xytext=(6, 0), textcoords="offset points", va="center", fontsize=9)
    names = [*(row[0] for row in rows), *(f"{maker}, formula" for maker, *_ in makers)]
    panel.set_yticks(np.arange(len(names)), names)
    panel.invert_yaxis()
    longest = max([*values, *(ends[1:] if known else ()), *(high for _, _, high in makers)])
    panel.set_xlim(0, ROOM * longest or 1.0)
    panel.set_xlabel(_torque_heading(units))
    panel.grid(alpha=0.3, axis="x")
    panel.set_axisbelow(True)
    loads = loads_of(point, [load for load in LOADS if getattr(point, load)] or ["axial_load"], units)
    title = f"{name}, {loads}, {speed_words(point.inner_speed, units)}"
    words = f"95 % interval {between((ends / factor).tolist(), torque)} {torque.name}" if known else _uncertainty(point)
    figure.suptitle(f"{title}\n{words}", fontsize=10, wrap=True)
    return figure


def _torque_heading(units: Units) -> str:
    return QUANTITIES["torque"].in_units(units).heading


def _uncertainty(point: TorquePoint) -> str:
    """How uncertain the total is, in words."""
    numerical, model = point.uncertainty.numerical, point.uncertainty.model
    words = "numerical uncertainty unknown" if numerical is None else f"$\\pm$ {100 * numerical:.2g} % numerical"
    return words if model is None else f"{words}, $\\pm$ {100 * model:.2g} % by the formulas"


def _finish(figure: Figure, panel: Axes, title: str) -> None:
    """Title above and legend below, where no data are."""
    figure.suptitle(title, fontsize=10, wrap=True)
    handles, words = panel.get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=2, frameon=False, fontsize=9)
