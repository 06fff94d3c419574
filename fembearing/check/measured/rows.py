"""Measured torques beside the computed ones: error, uncertainty and verdict of each row, in the terms of [ASME2009].

E = S - D, the computed torque less the measured one, and u_val = sqrt(u_num^2 + u_input^2 + u_D^2) of standard
uncertainties: of the solver, by the inputs of the scene, of the measurement. The error of the formulas lies in
E +- 2 u_val with a chance of 95 %. The stated spread of the formulas is not in u_val, as E is what shows their error.

The verdict asks whether the stated 95 % interval of the torque is right, with that spread: of a measured torque it is
wider, by the uncertainty of the measurement. Solver, inputs and formulas have one interval by samples, and each of them
one by itself; u_num is half of the 95 % uncertainty of the solver, the others are the widths over 2 x 1.96.
"""

from dataclasses import dataclass
from math import hypot, sqrt
from statistics import NormalDist
from typing import TYPE_CHECKING, Literal

import numpy as np

from analytic.columns import COORDINATES
from analytic.rows import NotNegative, OperatingPoint, Positive
from analytic.scene import MeasuredTorque, Scene

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import
    from analytic.prediction.prediction import Prediction

COVERAGE = NormalDist().inv_cdf(0.975)  # standard uncertainties to a half-width of 95 %
Inside = Literal["inside", "model too low", "model too high"]


@dataclass(frozen=True, kw_only=True)
class MeasuredRow(OperatingPoint):
    """A measured torque beside the computed one; uncertainties are standard ones."""

    temperature: float | None  # of the oil, K; None: the scene has no oil
    measured: Positive  # D, N m
    computed: float  # S, N m, with the inputs as they are
    error: float  # E = S - D, N m
    numerical: NotNegative  # u_num, N m
    input: NotNegative  # u_input, N m
    measurement: NotNegative | None  # u_D, N m; None: the file does not say it
    validation: NotNegative  # u_val, N m, of those that are known
    formulas: NotNegative  # N m; it is in the interval, and not in u_val
    computed_low: float  # lower end of the 95 % interval of S, by solver, inputs and formulas, N m
    computed_high: float  # upper end, N m
    low: float  # lower end of the 95 % interval in which D should lie, that of S widened by u_D, N m
    high: float  # upper end, N m
    beyond: NotNegative  # distance of D from that interval, N m; 0 inside
    verdict: Inside

    @property
    def relative(self) -> float:
        """E/D."""
        return self.error / self.measured

    @property
    def resolved(self) -> bool:
        """Whether solver, inputs and measurement do not explain E: its size exceeds 1.96 u_val."""
        return abs(self.error) > COVERAGE * self.validation


def row_of(measured: MeasuredTorque, place: int, prediction: "Prediction", point: int, scene: Scene) -> MeasuredRow:
    """A row of the file at a point of its prediction."""
    total, nominal = prediction.total, prediction.nominal
    torque, computed = float(measured.torque[place]), float(nominal.torque.total[point])
    unsure = None if measured.uncertainty is None else float(measured.uncertainty[place])
    numerical = float(nominal.numerical_uncertainty[point]) / 2 * computed

    def alone(cause: str) -> float:
        ends = prediction.made_of.get(cause)
        return 0.0 if ends is None else float(np.ptp(ends[:, point])) / (2 * COVERAGE)

    ends = float(total.low[point]), float(total.high[point])
    middle, spread = float(total.median[point]), COVERAGE * (unsure or 0.0)
    low, high = middle - hypot(middle - ends[0], spread), middle + hypot(ends[1] - middle, spread)
    beyond = max(low - torque, torque - high, 0.0)
    outside: Inside = "model too low" if torque > high else "model too high"
    return MeasuredRow(
        **{name: float(getattr(nominal, name)[point]) for name in COORDINATES},
        temperature=None if scene.lubricant is None else scene.lubricant.temperature,
        measured=torque,
        computed=computed,
        error=computed - torque,
        numerical=numerical,
        input=alone("input"),
        measurement=unsure,
        validation=sqrt(sum((part or 0.0) ** 2 for part in (numerical, alone("input"), unsure))),
        formulas=alone("model"),
        computed_low=ends[0],
        computed_high=ends[1],
        low=low,
        high=high,
        beyond=beyond,
        verdict=outside if beyond > 0 else "inside",
    )
