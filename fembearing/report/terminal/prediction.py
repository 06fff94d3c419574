"""The 95 % interval of a torque as tables for a terminal."""

from collections.abc import Mapping, Sequence

from rich.console import Console

from analytic.prediction.rows import PredictionRows
from fembearing.quantities import NEWTON_MILLIMETRE, RPM
from fembearing.report.phrases import MADE_OF, explained_words, input_name, interval_at, interval_words
from fembearing.report.terminal.table import table_of

NM = NEWTON_MILLIMETRE.factor
MOST_INPUTS = 8


def print_prediction(out: Console, prediction: PredictionRows, points: Mapping[int, int]) -> None:
    """Print the interval, what it is made of, and the inputs that make it; points : place and number of each."""
    heads = ("#", "total", "95 %", "+-", "numerical", "inputs", "formulas")
    table = table_of(heads, title=f"95 % interval of the total, {NEWTON_MILLIMETRE.name}", fixed=heads[:3])
    for place, number in points.items():
        point = prediction.points[place]
        total, made = point.total, point.made_of
        table.add_row(
            str(number),
            f"{point.nominal * NM:.4g}",
            interval_at(point),
            f"{total.low_error * NM:.1g}, {total.high_error * NM:.1g}",
            *(_between(made.get(kind)) for kind in ("numerical", "input", "model")),
        )
    out.print(table)
    out.print("+-: standard errors of both ends. Numerical, inputs, formulas: the interval of each alone.", style="dim")
    ends = prediction.ends
    speeds = [RPM.written(point.inner_speed, ".4g") for point in ends]
    heads = [f"{words}, {speed}" for speed in speeds for words in ("alone", "in all")]
    ranked = table_of(("input", *heads), title="Share of each input in the variance of the total, %", left=("input",))
    for place in prediction.ranked[:MOST_INPUTS]:
        ranked.add_row(
            input_name(prediction.inputs[place].key),
            *(
                _share(getattr(point.indices, kind)[place], getattr(point.indices, f"{kind}_error")[place])
                for point in ends
                for kind in ("first", "total")
            ),
        )
    out.print(ranked)
    out.print(f"In all: with its products with others. +-: standard errors. {explained_words(prediction)}", style="dim")
    formulas = [
        f"{MADE_OF[name].removeprefix('of them: ')} {' and '.join(_between(point.made_of[name]) for point in ends)}"
        for name in ends[0].made_of
        if name.startswith("model.")
    ]
    if formulas:
        out.print(f"Of the formulas, each alone, {NEWTON_MILLIMETRE.name}: {'; '.join(formulas)}.", markup=False)
    out.print(f"{interval_words(prediction)}\n", style="dim", markup=False)


def _between(ends: Sequence[float] | None) -> str:
    return "-" if ends is None else "-".join(f"{end * NM:.3g}" for end in ends)


def _share(index: float, error: float) -> str:
    return f"{100 * index:.0f} +- {100 * error:.1g}"
