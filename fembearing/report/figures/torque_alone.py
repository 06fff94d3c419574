"""The friction torque by effect in a narrow figure of its own, whose letters stay legible on a telephone.

Over speed or load where that alone varies; else a bar for each operating point, and for one point a bar for each part.
"""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.result import TorquePoint
from analytic.scene import Array
from fembearing.quantities import METRIC, QUANTITIES, RPM
from fembearing.report.figures.series_axis import SeriesAxis, axis_of
from fembearing.report.figures.style import BLACK
from fembearing.report.figures.torque import PARTS, draw_parts
from fembearing.report.phrases import LOADS, loads_of
from fembearing.verify.torque.scene_torque import SceneTorque

TORQUE = QUANTITIES["torque"]
NM = TORQUE.shown.factor
WIDTH = 4.6  # inches: letters of 10 points are 12 pixels high where the figure is 390 pixels wide
BAR = 0.32  # inches of height for a bar with its name
MOST_NAMES = 24  # of bars
ROOM = 1.25  # of the longest bar: for the number beside it
SMALL = 1e-3  # of the total: a smaller part has one digit
DARK = "0.25"


def figure_of_torque(result: SceneTorque) -> Figure:
    """The figure of a torque at all of its operating points."""
    points = result.friction.rows
    bearings = "" if result.friction.pair is None else "two "
    name = f"{bearings}{result.scene.bearing.name}"
    if len(points) == 1:
        return _one_point(points[0], name)
    axis = axis_of(points, METRIC)
    return _over(axis, name) if axis.joined else _bars(axis, name)


def _over(axis: SeriesAxis, name: str) -> Figure:
    """Parts stacked over speed or load."""
    figure = Figure(figsize=(WIDTH, 4.4), layout="constrained")
    panel = figure.subplots()
    draw_parts(panel, axis)
    total, half = _total(axis)
    panel.plot(axis.values, total, "-" + axis.mark, color=BLACK, markersize=4, label="total")
    for index, sign in enumerate((-1, 1)):
        label = "_" if index else "its uncertainty"
        panel.plot(axis.values, total * (1 + sign * half), "--", color=BLACK, linewidth=0.8, label=label)
    axis.apply(panel)
    panel.set_ylabel(TORQUE.heading)
    panel.set_ylim(0, None)
    panel.grid(alpha=0.3)
    _finish(figure, panel, f"{name}, {axis.fixed}")
    return figure


def _bars(axis: SeriesAxis, name: str) -> Figure:
    """A bar of parts for each operating point, the first one on top."""
    count = len(axis.points)
    figure = Figure(figsize=(WIDTH, 1.8 + BAR * min(count, MOST_NAMES)), layout="constrained")
    panel = figure.subplots()
    place, before = np.arange(count), np.zeros(count)
    for part, (words, colour) in PARTS.items():
        values = axis.of("torque", part)
        if values is not None:
            panel.barh(place, NM * values, 0.7, left=before, color=colour, alpha=0.75, label=words)
            before = before + NM * values
    total, half = _total(axis)
    look = {"fmt": "o", "color": BLACK, "capsize": 3, "markersize": 4}
    panel.errorbar(total, place, xerr=total * half, label="total, uncertainty", **look)
    step = -(-count // MOST_NAMES)
    panel.set_yticks(place[::step], axis.names[::step], fontsize=9)
    panel.set_ylim(count - 0.4, -0.6)
    panel.set_xlim(0, None)
    panel.set_xlabel(TORQUE.heading)
    panel.grid(alpha=0.3, axis="x")
    _finish(figure, panel, ", ".join([name, *([axis.fixed] if axis.fixed else [])]))
    return figure


def _one_point(point: TorquePoint, name: str) -> Figure:
    """A bar for each part and one for the total, each with its number."""
    parts = [(words, colour, getattr(point.torque, part)) for part, (words, colour) in PARTS.items()]
    rows = [row for row in parts if row[2] is not None] + [("total", DARK, point.torque.total)]
    figure = Figure(figsize=(WIDTH, 1.5 + BAR * len(rows)), layout="constrained")
    panel = figure.subplots()
    place = np.arange(len(rows))
    values = NM * np.array([row[2] for row in rows])
    panel.barh(place, values, 0.7, color=[row[1] for row in rows])
    for number, value in enumerate(values):
        words = f"{value:.4g}" if value >= SMALL * values[-1] or value == 0 else f"{value:.1g}"
        panel.annotate(words, (value, number), xytext=(4, 0), textcoords="offset points", va="center", fontsize=9)
    panel.set_yticks(place, [row[0] for row in rows])
    panel.invert_yaxis()
    panel.set_xlim(0, ROOM * values.max() or 1.0)
    panel.set_xlabel(TORQUE.heading)
    panel.grid(alpha=0.3, axis="x")
    panel.set_axisbelow(True)
    loads = loads_of(point, [load for load in LOADS if getattr(point, load)] or ["axial_load"])
    title = f"{name}, {loads}, {RPM.written(point.inner_speed, '.4g')}"
    figure.suptitle(f"{title}\n{_uncertainty(point)}", fontsize=10, wrap=True)
    return figure


def _uncertainty(point: TorquePoint) -> str:
    """How uncertain the total is, in words."""
    numerical, model = point.uncertainty.numerical, point.uncertainty.model
    words = "numerical uncertainty unknown" if numerical is None else f"$\\pm$ {100 * numerical:.2g} % numerical"
    return words if model is None else f"{words}, $\\pm$ {100 * model:.2g} % by the formulas"


def _total(axis: SeriesAxis) -> tuple[Array, Array]:
    """(n,) each: the total as it is shown, and its uncertainty, relative, as far as it is known."""
    total = axis.of("torque", "total")
    assert total is not None  # the total is always there
    parts = [axis.of("uncertainty", name) for name in ("numerical", "model")]
    return NM * total, np.sum([part for part in parts if part is not None], axis=0) * np.ones_like(total)


def _finish(figure: Figure, panel: Axes, title: str) -> None:
    """Title above and legend below, where no data are."""
    figure.suptitle(title, fontsize=10, wrap=True)
    handles, words = panel.get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=2, frameon=False, fontsize=9)
