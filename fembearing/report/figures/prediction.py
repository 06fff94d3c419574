"""What the 95 % interval of the torque is made of, and the inputs that make it."""

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.figures.style import BLACK, BLUE, ORANGE, SKY, WIDTH, lettered
from analytic.prediction.rows import PredictedPoint, PredictionRows
from fembearing.quantities import Units
from fembearing.report.phrases import MADE_OF, explained_words, input_name, loads_of, present_loads, speed_words
from fembearing.report.report import Report

MOST = 8  # inputs that are drawn
ROW, HEADS = 0.14, 1.15  # inches: of a bar with its name, and of all that stands above and below
LEAST = 0.005  # total index of an input that is drawn


def prediction_plot(document: Report) -> tuple[Figure | None, str]:
    """The figure of the torque's interval, and its caption; no words where no interval was asked for."""
    prediction = None if document.torque is None else document.torque.prediction
    if prediction is None:
        return None, ""
    return interval_figure(prediction, document.units), (
        "Above: the 95 % interval of the total, and the intervals from the numerical uncertainty, the inputs and the "
        "formulas alone; line: computed torque. Each speed has its own scale. The parts do not add up. "
        "Below: share of each input in the variance of the total, alone (dark) and with interactions (light), with two "
        "standard errors. "
        f"{prediction.samples} samples, seed {prediction.seed}. {explained_words(prediction)}"
    )


def interval_figure(prediction: PredictionRows, units: Units) -> Figure:
    """What the interval is made of, and the inputs; a column for the slowest and one for the fastest point."""
    points = prediction.ends
    drawn = [
        place for place in prediction.ranked[:MOST] if max(point.indices.total[place] for point in points) >= LEAST
    ]
    parts = list(points[0].made_of)
    figure = Figure(figsize=(WIDTH, HEADS + ROW * (len(parts) + 1 + len(drawn))), layout="constrained")
    ratios = (len(parts) + 2, len(drawn) + 1)
    panels = figure.subplots(2, len(points), squeeze=False, sharey="row", height_ratios=ratios)
    for column, point in zip(panels.T, points, strict=True):
        _ends(column[0], point, parts, units)
        _indices(column[1], point, drawn)
        loads = loads_of(point, present_loads(prediction.points), units)
        column[1].sharex(panels[1, 0])
        column[0].set_title(f"{speed_words(point.inner_speed, units)}, {loads}")
    names = [MADE_OF.get(name, name) for name in ("total", *parts)]
    inputs = [input_name(prediction.inputs[place].key) for place in drawn]
    for panel, rows in zip(panels[:, 0], (names, inputs), strict=True):
        panel.set_yticks(range(len(rows)), rows)
        panel.invert_yaxis()
    return lettered(figure)


def _ends(panel: Axes, point: PredictedPoint, parts: list[str], units: Units) -> None:
    """A bar from end to end for the whole and for each part."""
    ends = [[point.total.low, point.total.high], *(point.made_of[name] for name in parts)]
    factor = units.torque.factor
    for row, (low, high) in enumerate(ends):
        panel.barh(row, (high - low) * factor, 0.6, left=low * factor, color=BLUE if row == 0 else SKY)
    panel.use_sticky_edges = False
    panel.margins(x=0.05)
    panel.axvline(point.nominal * factor, color=BLACK, linewidth=0.8)
    panel.set_xlabel(f"total torque, {units.torque.name}")
    panel.grid(alpha=0.3, axis="x")


def _indices(panel: Axes, point: PredictedPoint, drawn: list[int]) -> None:
    """Two bars for each input."""
    for row, place in enumerate(drawn):
        error = 200 * point.indices.total_error[place]
        panel.barh(row, 100 * point.indices.total[place], 0.7, color=ORANGE, alpha=0.5, xerr=error)
        panel.barh(row, 100 * point.indices.first[place], 0.4, color=ORANGE)
    panel.set_xlabel("share of the variance, %")
    panel.grid(alpha=0.3, axis="x")
