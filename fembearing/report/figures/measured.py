"""Measured torques beside the computed curve with its 95 % interval, and the error E beside its uncertainty."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.columns import COLUMNS
from analytic.figures.style import BLACK, BLUE, GREEN, GREY, LETTERS, ORANGE, PURPLE, RED, WIDTH, lettered, scaled
from analytic.figures.torque import logarithmic_torques
from analytic.scene import Array
from analytic.scenefile.measured import OPERATING
from analytic.units import METRIC, Units
from analytic.words import Unit
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.measured.rows import COVERAGE, MeasuredRow
from fembearing.report.report import Report

COLOURS = (BLUE, GREEN, ORANGE, PURPLE)  # of curves; more of them are drawn as points
HEIGHT = 4.8  # inches
TORQUES = ("computed", "computed_low", "computed_high", "measured")
NAMES = {"inner_speed": "inner speed", "temperature": "temperature of the oil"}


@dataclass(frozen=True, kw_only=True)
class Axis:
    """What the rows are drawn over."""

    label: str
    values: Array  # (n,) as shown
    curves: dict[str, list[int]]  # places of the rows along each curve, by what differs between curves

    @property
    def many(self) -> bool:
        """Whether there are more curves than colours."""
        return len(self.curves) > len(COLOURS)

    def colour(self, curve: str) -> str:
        """Of a curve; one of all where there are many."""
        return COLOURS[0 if self.many else [*self.curves].index(curve)]


def measured_plot(document: Report) -> tuple[Figure | None, str]:
    """The figure and its caption; no words where nothing was measured."""
    found = document.measured
    return (None, "") if found is None else (measured_figure(found, document.units), caption_of(found))


def caption_of(comparison: MeasuredComparison) -> str:
    """What to see in the figure."""
    missed = len(comparison.rows) - comparison.inside
    found = f"{missed} of {len(comparison.rows)} points miss" if missed else "no point misses"
    return (
        "Above: measured torques with bars of 1.96 u_D, and computed torque with its 95 % interval from solver, inputs "
        "and formulas. Diamonds: the distance exceeds band and bar together (root of the sum of squares); "
        f"{found}. Below: E, computed less measured over measured torque, with bars of 1.96 u_val from solver, inputs "
        "and measurement. A bar that does not reach 0 means an error of the formulas, if the stated uncertainties of "
        "inputs and measurement are right."
    )


def measured_figure(comparison: MeasuredComparison, units: Units = METRIC) -> Figure:
    """Torques above, errors below, over the first quantity that varies."""
    rows = comparison.rows
    axis = axis_of(rows, units)
    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1.6, 1.0))
    _torques(above, rows, axis, units.torque)
    _errors(below, rows, axis)
    scaled(below, axis.values, axis="x")
    if below.get_xscale() == "log":
        logarithmic_torques(above, units.torque.factor * np.concatenate([_of(rows, name) for name in TORQUES]))
    below.set_xlabel(axis.label)
    above.set_title(comparison.scene)
    for panel in (above, below):
        panel.grid(alpha=0.3)
    handles, words = above.get_legend_handles_labels()
    figure.legend(handles, words, loc="outside right upper", frameon=False, fontsize=LETTERS)
    return lettered(figure)


def axis_of(rows: Sequence[MeasuredRow], units: Units) -> Axis:
    """Over the speed or load with the most values, else the temperature; the others tell curves apart.

    Row by row where nothing varies.
    """
    shown = {name: COLUMNS[name].shown(units) for name in OPERATING[:-1]} | {"temperature": units.temperature}
    known = {name: [getattr(row, name) for row in rows] for name in OPERATING}
    varying = [name for name in OPERATING if len({*known[name]}) > 1]
    if not varying:
        return Axis(label="row", values=np.arange(1.0, len(rows) + 1), curves={"computed": [*range(len(rows))]})
    over = max(varying, key=lambda name: 0 if name == "temperature" else len({*known[name]}))
    others = [name for name in varying if name != over]
    values = np.array(known[over]) if over == "temperature" else np.abs(known[over])
    curves: dict[str, list[int]] = {}
    for place in np.argsort(values, kind="stable").tolist():
        words = ", ".join(shown[name].written(known[name][place], ".4g") for name in others)
        curves.setdefault(f"computed, {words}" if words else "computed", []).append(place)
    label = f"{NAMES.get(over, over.replace('_', ' '))}, {shown[over].name}"
    return Axis(label=label, values=shown[over].number(values), curves=curves)


def _torques(panel: Axes, rows: Sequence[MeasuredRow], axis: Axis, torque: Unit) -> None:
    """Every curve with its band, and the measured torques."""
    computed, low, high = (torque.factor * _of(rows, name) for name in ("computed", "computed_low", "computed_high"))
    for number, (words, places) in enumerate(axis.curves.items()):
        colour, x = axis.colour(words), axis.values[places]
        if axis.many or len(places) == 1:
            label = "_" if axis.many and number else "computed, 95 %" if axis.many else f"{words}, 95 %"
            ends = np.maximum([(computed - low)[places], (high - computed)[places]], 0.0)  # skewed ends may cross
            panel.errorbar(x, computed[places], ends, fmt="_", color=colour, alpha=0.6, label=label)
        else:
            panel.fill_between(x, low[places], high[places], color=colour, alpha=0.2, linewidth=0)
            panel.plot(x, computed[places], "-", color=colour, label=f"{words}, 95 %")
    _points(panel, rows, axis, torque.factor * _of(rows, "measured"), torque.factor * _of(rows, "measurement"))
    panel.set_ylabel(f"friction torque, {torque.name}")
    panel.set_ylim(0, None)


def _errors(panel: Axes, rows: Sequence[MeasuredRow], axis: Axis) -> None:
    """E of every row."""
    measured = _of(rows, "measured")
    _points(panel, rows, axis, 100 * _of(rows, "error") / measured, 100 * _of(rows, "validation") / measured)
    panel.axhline(0, color=GREY, linewidth=0.8)
    panel.set_ylabel("E, %")


def _points(panel: Axes, rows: Sequence[MeasuredRow], axis: Axis, y: Array, uncertainty: Array) -> None:
    """A point for each row with a bar of 95 %, in the colour of its curve; a diamond outside its interval."""
    several = len(axis.curves) > 1 and not axis.many
    for mark, words, inside, alone in (("o", "measured", True, BLACK), ("D", "measured, missed", False, RED)):
        look = {"fmt": mark, "markersize": 4, "capsize": 3, "linewidth": 1}
        for curve, places in axis.curves.items():
            own = [place for place in places if (rows[place].verdict == "inside") == inside]
            colour = axis.colour(curve) if several else alone
            panel.errorbar(axis.values[own], y[own], COVERAGE * uncertainty[own], color=colour, **look)
        if any((row.verdict == "inside") == inside for row in rows):
            panel.errorbar([], [], [], color=BLACK if several else alone, label=words, **look)


def _of(rows: Sequence[MeasuredRow], name: str) -> Array:
    """(n,) one number of every row, 0 where it is not known."""
    return np.array([getattr(row, name) or 0.0 for row in rows])
