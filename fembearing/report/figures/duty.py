"""A duty cycle over time: torque with its 95 % interval above, power below."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.figures.style import BLUE, GREY, LETTERS, RED, WIDTH, lettered
from analytic.prediction.duty import DutyCycle, DutyStep
from analytic.scene import Array
from analytic.units import METRIC, Units

HEIGHT = 4.2  # inches
MINUTES, HOURS = 600.0, 36_000.0  # s from which time is shown in minutes and in hours


def duty_figure(cycle: DutyCycle, units: Units = METRIC) -> Figure:
    """Steps of torque and power over time, with the mean of each."""
    steps = cycle.steps
    name, second = (
        ("h", 3600.0) if cycle.duration >= HOURS else ("min", 60.0) if cycle.duration >= MINUTES else ("s", 1.0)
    )
    ends = np.concatenate([[0.0], np.cumsum([step.duration for step in steps])]) / second
    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1.6, 1.0))
    torque, factor = np.array([step.torque.value for step in steps]), units.torque.factor
    if cycle.energy.low is not None:
        low, high = (np.array([_end(step, end) for step in steps]) for end in ("low", "high"))
        above.stairs(factor * high, ends, baseline=factor * low, fill=True, color=BLUE, alpha=0.2, label="95 %")
    _stairs(above, ends, factor * torque, factor * cycle.mean_torque.value, "torque")
    above.set_ylabel(f"friction torque, {units.torque.name}")
    _stairs(below, ends, np.array([step.power for step in steps]), cycle.mean_power.value, "power")
    below.set_ylabel("power, W")
    below.set_xlabel(f"time, {name}")
    return lettered(figure)


def _end(step: DutyStep, end: str) -> float:
    return getattr(step.torque, end) or 0.0


def _stairs(panel: Axes, ends: Array, values: Array, mean: float, name: str) -> None:
    """Values between their ends, and the mean as a line."""
    panel.stairs(values, ends, baseline=None, color=BLUE, label=name)
    panel.axhline(mean, color=RED, linewidth=0.8, linestyle="--", label=f"mean {name}")
    panel.set_ylim(0, None)
    panel.grid(alpha=0.3, color=GREY)
    panel.legend(frameon=False, fontsize=LETTERS, loc="best")
