"""How many measured points lie in the stated intervals: python validation/intervals/run.py

Every interval is that of the model as it is, with the spreads that it states; nothing is recentred on what it is tested
on. A measured point is compared with the model's interval widened by the stated scatter of the measurement. The
interval of 95 % is an honest one where some 95 % of the points lie in it; far fewer say that it is too narrow, and that
all of them do says little where the points are few or share their errors, as those of one oil on one rig do.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.oil.variation import COVERAGE
from analytic.prediction.prediction import predict
from analytic.scene import Array
from validation.film import run as film
from validation.measured import run as measured
from validation.study import out, run, show

SEEN = "its spread was chosen with these films in view"
ONE_RIG = "the spread of rolling was judged with these torques known, and is centred at the formula"


@dataclass(frozen=True, kw_only=True)
class Coverage:
    """Measured points of one source against an interval of 95 %."""

    source: str
    what: str
    interval: str  # what it is made of
    below: Array  # (n,) bool, measured below the interval
    above: Array
    note: str

    @property
    def row(self) -> tuple[object, ...]:
        below, above = int(self.below.sum()), int(self.above.sum())
        inside = f"{self.below.size - below - above} of {self.below.size}"
        return self.source, self.what, self.interval, inside, below, above


def coverages() -> Iterator[Coverage]:
    """Of every source."""
    yield from films()
    yield from torques()


def films() -> Iterator[Coverage]:
    """Films of one oil on a glass disc [Wittek], by the formula alone and with its inputs and the scatter."""
    found = film.compare()
    ratio = np.log(found.measured / found.computed)
    formula = COVERAGE * FORMULA_UNCERTAINTY * np.ones_like(ratio)
    inputs = COVERAGE * found.input_uncertainty / found.computed
    scatter = COVERAGE * found.measurement_uncertainty / found.measured
    fast = found.judged
    for rows, what in ((fast, f"films from {film.LEAST_SPEED:g} m/s"), (~fast, "slower films")):
        for name, half in (
            ("film formula", formula),
            ("film formula, scatter", np.hypot(formula, scatter)),
            ("film formula, inputs, scatter", np.sqrt(formula**2 + inputs**2 + scatter**2)),
        ):
            yield Coverage(
                source="[Wittek]",
                what=what,
                interval=name,
                below=(ratio < -half)[rows],
                above=(ratio > half)[rows],
                note=SEEN,
            )


def torques() -> Iterator[Coverage]:
    """Torques of three balls between washers [Balan2015]: the mean of the spin-downs at each speed."""
    for diameter in measured.RIGS:
        rig = measured.compare(diameter)
        interval = predict(rig.scene).total
        wide = COVERAGE * rig.measurement
        for name, half in (("inputs and formulas", np.zeros_like(wide)), ("inputs and formulas, scatter", wide)):
            yield Coverage(
                source="[Balan2015]",
                what=f"torque, balls of {diameter:g} mm",
                interval=name,
                below=rig.measured < interval.low - half,
                above=rig.measured > interval.high + half,
                note=ONE_RIG,
            )


def main() -> None:
    found = list(coverages())
    heads = ("source", "measured", "interval of 95 %", "inside", "below", "above")
    show(heads, (each.row for each in found))
    for line in dict.fromkeys(f"{each.source}: {each.note}." for each in found):
        out.print(line)
    out.print("No measured torque of a whole bearing with complete conditions was found, so none is in this table.")


if __name__ == "__main__":
    run(main)
