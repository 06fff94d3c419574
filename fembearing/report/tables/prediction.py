"""The 95 % interval of a torque, what it is made of, and the inputs that make it."""

from collections.abc import Sequence

from analytic.prediction.rows import PredictionRows
from fembearing.quantities import METRIC, Units
from fembearing.report.phrases import MADE_OF, between, digits, explained_words, input_name, interval_words, speed_words
from fembearing.report.tables.table import Head, Table, table_of
from fembearing.report.torque import TorqueRecord

MOST_INPUTS = 8
PARTS = {"numerical": "numerical", "input": "inputs", "model": "formulas"}


def prediction_tables(torque: TorqueRecord, places: Sequence[int], units: Units = METRIC) -> list[Table]:
    """The interval at those of the points that have a torque, and what makes it; none without an interval."""
    if torque.prediction is None:
        return []
    known = set(torque.computed)
    shown = [place for place in places if place in known]
    return [interval_table(torque.prediction, shown, units), shares_table(torque.prediction, units)]


def interval_table(prediction: PredictionRows, places: Sequence[int], units: Units = METRIC) -> Table:
    """The interval at each point, and the interval of each part alone; places : of the points that are shown."""
    torque = units.torque
    heads = [Head("#"), *(Head(name, fixed=True) for name in ("total", "95 %")), *map(Head, ("+-", *PARTS.values()))]
    rows = []
    for place in places:
        point = prediction.points[place]
        rows.append(
            [
                str(place + 1),
                digits(point.nominal, torque.factor, 4),
                between(point.total.ends, torque),
                f"{torque.number(point.total.low_error):.1g}, {torque.number(point.total.high_error):.1g}",
                *(between(point.made_of.get(kind), torque) for kind in PARTS),
            ]
        )
    ends = prediction.ends
    formulas = [
        f"{MADE_OF[name].removeprefix('of them: ')} "
        f"{' and '.join(between(point.made_of[name], torque) for point in ends)}"
        for name in ends[0].made_of
        if name.startswith("model.")
    ]
    notes = ["+-: standard errors of both ends. Numerical, inputs, formulas: the interval of each alone."]
    notes += [f"Of the formulas, each alone, {torque.name}: {'; '.join(formulas)}."] if formulas else []
    return table_of(f"95 % interval of the total, {torque.name}", heads, rows, [*notes, interval_words(prediction)])


def shares_table(prediction: PredictionRows, units: Units = METRIC) -> Table:
    """The inputs that make the interval, at its slowest and its fastest point."""
    ends = prediction.ends
    speeds = [speed_words(point.inner_speed, units) for point in ends]
    heads = [Head("input", "name"), *(Head(f"{words}, {speed}") for speed in speeds for words in ("alone", "in all"))]
    shares = [
        (getattr(point.indices, kind), getattr(point.indices, f"{kind}_error"))
        for point in ends
        for kind in ("first", "total")
    ]
    rows = [
        [
            input_name(prediction.inputs[place].key),
            *(f"{100 * index[place]:.0f} +- {100 * error[place]:.1g}" for index, error in shares),
        ]
        for place in prediction.ranked[:MOST_INPUTS]
    ]
    note = f"In all: with interactions. +-: standard errors. {explained_words(prediction)}"
    return table_of("Share of each input in the variance of the total, %", heads, rows, [note])
