"""How many measured points lie in the stated intervals: python validation/intervals/run.py

Every interval is that of the model as it is, with the spreads that it states; nothing is recentred on what it is tested
on. A measured point is compared with the model's interval widened by the stated scatter of the measurement. The
interval of 95 % is an honest one where some 95 % of the points lie in it; far fewer say that it is too narrow, and that
all of them do says little where the points are few or share their errors, as those of one oil on one rig do.
"""

from collections.abc import Iterator

import numpy as np

from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.oil.variation import COVERAGE
from analytic.prediction.prediction import predict
from analytic.scene import Array
from validation.film import run as film
from validation.measured import run as measured
from validation.study import out, run, show

NOTES = (
    "[Wittek]: its spread was chosen with these films in view.",
    "[Balan2015]: the spread of rolling was judged with these torques known, and is centred at the formula.",
    "No measured torque of a whole bearing with complete conditions was found, so none is in this table.",
)


def counts(theirs: Array, low: Array, high: Array) -> tuple[str, int, int]:
    """Points inside an interval, below and above."""
    below, above = int(np.sum(theirs < low)), int(np.sum(theirs > high))
    return f"{theirs.size - below - above} of {theirs.size}", below, above


def films() -> Iterator[tuple[object, ...]]:
    """Films of one oil on a glass disc [Wittek], by the formula alone and with its inputs and the scatter."""
    found = film.compare()
    ratio, fast = np.log(found.measured / found.computed), found.judged
    formula = COVERAGE * FORMULA_UNCERTAINTY * np.ones_like(ratio)
    inputs = COVERAGE * found.input_uncertainty / found.computed
    scatter = COVERAGE * found.measurement_uncertainty / found.measured
    for rows, what in ((fast, f"films from {film.LEAST_SPEED:g} m/s"), (~fast, "slower films")):
        for name, half in (
            ("film formula", formula),
            ("film formula, scatter", np.hypot(formula, scatter)),
            ("film formula, inputs, scatter", np.sqrt(formula**2 + inputs**2 + scatter**2)),
        ):
            yield "[Wittek]", what, name, *counts(ratio[rows], -half[rows], half[rows])


def torques() -> Iterator[tuple[object, ...]]:
    """Torques of three balls between washers [Balan2015]: the mean of the spin-downs at each speed."""
    for diameter in measured.RIGS:
        rig = measured.compare(diameter)
        interval, scatter = predict(rig.scene).total, COVERAGE * rig.measurement
        for name, wider in (("inputs and formulas", 0.0), ("inputs and formulas, scatter", scatter)):
            inside = counts(rig.measured, interval.low - wider, interval.high + wider)
            yield "[Balan2015]", f"torque, balls of {diameter:g} mm", name, *inside


def main() -> None:
    show(("source", "measured", "interval of 95 %", "inside", "below", "above"), [*films(), *torques()])
    for line in NOTES:
        out.print(line)


if __name__ == "__main__":
    run(main)
