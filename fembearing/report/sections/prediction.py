"""The 95 % interval of a torque, what it is made of, and the inputs that make it."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from analytic.columns import MODEL_PARTS
from analytic.scene_torque import SceneTorque
from analytic.units import METRIC, Units, speed_words
from fembearing.report.document import Head, Table, table_of
from fembearing.report.phrases import between, digits, input_name

MADE_OF = {  # the parts of the 95 % interval
    "total": "all together",
    "numerical": "numerical alone",
    "input": "inputs alone",
    "model": "formulas alone",
    **{f"model.{name}": f"of them: {words}" for name, words in MODEL_PARTS.items()},
}
LEAST_EXPLAINED = 0.5  # share of the variance below which the shares of the inputs say nothing

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import
    from analytic.prediction.prediction import Prediction

MOST_INPUTS = 8
PARTS = {"numerical": "numerical", "input": "inputs", "model": "formulas"}


def prediction_tables(torque: SceneTorque, places: Sequence[int], units: Units = METRIC) -> list[Table]:
    """The interval at those of the points that have a torque, and what makes it; none without an interval."""
    if torque.prediction is None:
        return []
    numbers = torque.places.computed
    shown = {place: numbers.index(place) for place in places if place in numbers}
    return [interval_table(torque.prediction, shown, units), shares_table(torque.prediction, units)]


def interval_table(prediction: "Prediction", shown: Mapping[int, int], units: Units = METRIC) -> Table:
    """The interval at each point, and the interval of each part alone.

    shown : by the number of a point in the scene, that in the prediction
    """
    torque = units.torque
    heads = [Head("#"), *(Head(name, fixed=True) for name in ("total", "95 %")), *map(Head, ("+-", *PARTS.values()))]
    rows = []
    total = prediction.total
    for place, at in shown.items():
        alone = {kind: ends[:, at].tolist() for kind, ends in prediction.made_of.items()}
        rows.append(
            [
                str(place + 1),
                digits(float(prediction.nominal.torque.total[at]), torque.factor, 4),
                between((total.low[at], total.high[at]), torque),
                f"{torque.number(total.low_error[at]):.1g}, {torque.number(total.high_error[at]):.1g}",
                *(between(alone.get(kind), torque) for kind in PARTS),
            ]
        )
    ends = prediction.ends
    formulas = [
        f"{MADE_OF[name].removeprefix('of them: ')} "
        f"{' and '.join(between(prediction.made_of[name][:, at].tolist(), torque) for at in ends)}"
        for name in prediction.made_of
        if name.startswith("model.")
    ]
    notes = ["+-: standard errors of both ends. Numerical, inputs, formulas: the interval of each alone."]
    notes += [f"Of the formulas, each alone, {torque.name}: {'; '.join(formulas)}."] if formulas else []
    return table_of(f"95 % interval of the total, {torque.name}", heads, rows, [*notes, interval_words(prediction)])


def shares_table(prediction: "Prediction", units: Units = METRIC) -> Table:
    """The inputs that make the interval, at its slowest and its fastest point."""
    ends = prediction.ends
    speeds = [speed_words(float(prediction.nominal.inner_speed[at]), units) for at in ends]
    heads = [Head("input", "name"), *(Head(f"{words}, {speed}") for speed in speeds for words in ("alone", "in all"))]
    shares = [
        (getattr(prediction.indices, kind)[:, at], getattr(prediction.indices, f"{kind}_error")[:, at])
        for at in ends
        for kind in ("first", "total")
    ]
    rows = [
        [
            input_name(prediction.inputs[place].key),
            *(f"{100 * index[place]:.0f} +- {100 * error[place]:.1g}" for index, error in shares),
        ]
        for place in np.argsort(-prediction.indices.total[:, ends].max(axis=1), kind="stable").tolist()[:MOST_INPUTS]
    ]
    note = f"In all: with interactions. +-: standard errors. {explained_words(prediction)}"
    return table_of("Share of each input in the variance of the total, %", heads, rows, [note])


def explained_words(prediction: "Prediction") -> str:
    """How far to trust the shares of the inputs, in a sentence."""
    explained = max(0.0, float(np.nanmin(prediction.explained)))
    known = f"The regression for the shares explains {100 * explained:.0f} % or more of the variance"
    if explained < LEAST_EXPLAINED:
        return f"{known}: the ranking of the inputs is not known; use more samples or smaller spreads."
    return f"{known}; the rest is attributed to no input and not included in the standard errors."


def interval_words(prediction: "Prediction") -> str:
    """How the interval was computed and what it does not include, in sentences."""
    return (
        f"95 % interval by {prediction.samples} Latin hypercube samples, seed {prediction.seed}, in "
        f"{prediction.seconds:.0f} s; the standard error of an end is at most "
        f"{100 * prediction.total.largest_error:.2g} %. "
        f"{prediction.failures} Spreads are mostly judgement; --json and the report give their sources. Not included: "
        f"{'; '.join(prediction.not_varied)}."
    ).replace("  ", " ")
