"""What the 95 % interval of the torque is made of, and the inputs that make it."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.figures.style import BLACK, BLUE, ORANGE, SKY, WIDTH, lettered
from analytic.prediction.prediction import Prediction
from analytic.units import Units, speed_words
from fembearing.report.phrases import input_name
from fembearing.report.report import Report
from fembearing.report.sections.points import loads_of, present_loads
from fembearing.report.sections.prediction import MADE_OF, explained_words

MOST = 8  # inputs that are drawn
ROW, HEADS = 0.14, 1.15  # inches: of a bar with its name, and of all that stands above and below
LEAST = 0.005  # total index of an input that is drawn


def prediction_plot(document: Report) -> tuple[Figure | None, str]:
    """The figure of the torque's interval, and its caption; no words where no interval was asked for."""
    prediction = None if document.solved is None else document.solved.prediction
    if prediction is None:
        return None, ""
    return interval_figure(prediction, document.units), (
        "Above: the 95 % interval of the total, and the intervals from the numerical uncertainty, the inputs and the "
        "formulas alone; line: computed torque. Each speed has its own scale. The parts do not add up. "
        "Below: share of each input in the variance of the total, alone (dark) and with interactions (light), with two "
        "standard errors. "
        f"{prediction.samples} samples, seed {prediction.seed}. {explained_words(prediction)}"
    )


def interval_figure(prediction: Prediction, units: Units) -> Figure:
    """What the interval is made of, and the inputs; a column for the slowest and one for the fastest point."""
    points, nominal = prediction.ends, prediction.nominal
    largest = prediction.indices.total[:, points].max(axis=1)
    drawn = [place for place in np.argsort(-largest, kind="stable").tolist()[:MOST] if largest[place] >= LEAST]
    parts = list(prediction.made_of)
    figure = Figure(figsize=(WIDTH, HEADS + ROW * (len(parts) + 1 + len(drawn))), layout="constrained")
    ratios = (len(parts) + 2, len(drawn) + 1)
    panels = figure.subplots(2, len(points), squeeze=False, sharey="row", height_ratios=ratios)
    for column, point in zip(panels.T, points, strict=True):
        _ends(column[0], prediction, point, units)
        _indices(column[1], prediction, point, drawn)
        loads = loads_of(nominal.rows[point], present_loads(nominal.rows), units)
        column[1].sharex(panels[1, 0])
        column[0].set_title(f"{speed_words(float(nominal.inner_speed[point]), units)}, {loads}")
    names = [MADE_OF.get(name, name) for name in ("total", *parts)]
    inputs = [input_name(prediction.inputs[place].key) for place in drawn]
    for panel, rows in zip(panels[:, 0], (names, inputs), strict=True):
        panel.set_yticks(range(len(rows)), rows)
        panel.invert_yaxis()
    return lettered(figure)


def _ends(panel: Axes, prediction: Prediction, point: int, units: Units) -> None:
    """A bar from end to end for the whole and for each part."""
    every = [prediction.total.ends, *prediction.made_of.values()]
    ends = [(low[point], high[point]) for low, high in every]
    factor = units.torque.factor
    for row, (low, high) in enumerate(ends):
        panel.barh(row, (high - low) * factor, 0.6, left=low * factor, color=BLUE if row == 0 else SKY)
    panel.use_sticky_edges = False
    panel.margins(x=0.05)
    panel.axvline(prediction.nominal.torque.total[point] * factor, color=BLACK, linewidth=0.8)
    panel.set_xlabel(f"total torque, {units.torque.name}")
    panel.grid(alpha=0.3, axis="x")


def _indices(panel: Axes, prediction: Prediction, point: int, drawn: list[int]) -> None:
    """Two bars for each input."""
    found = prediction.indices
    for row, place in enumerate(drawn):
        error = 200 * found.total_error[place, point]
        panel.barh(row, 100 * found.total[place, point], 0.7, color=ORANGE, alpha=0.5, xerr=error)
        panel.barh(row, 100 * found.first[place, point], 0.4, color=ORANGE)
    panel.set_xlabel("share of the variance, %")
    panel.grid(alpha=0.3, axis="x")
