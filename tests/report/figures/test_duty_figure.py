"""A duty cycle over time: steps where they begin and end, in a unit of time that a reader would choose."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.patches import StepPatch

from fembearing.quantities import INCH_POUND, METRIC, Units
from fembearing.report.figures.duty import duty_figure
from tests.report.figures.figure_reader import line_of, points_of, require_legible

DURATIONS = np.array([20.0, 50.0, 30.0])  # s
TORQUES, POWERS = np.array([5e-3, 8e-3, 3e-3]), np.array([0.7, 1.9, 0.4])  # N m, W


def cycle(*, times: float = 1.0, known: bool = True) -> Any:
    """Three steps, the second without an interval; the whole cycle has one where it is known."""
    steps = []
    for number, (duration, torque, power) in enumerate(zip(times * DURATIONS, TORQUES, POWERS, strict=True)):
        low, high = (0.8 * torque, 1.3 * torque) if number != 1 else (None, None)
        value = SimpleNamespace(value=torque, low=low, high=high)
        steps.append(SimpleNamespace(duration=duration, torque=value, power=power))
    return SimpleNamespace(
        steps=steps,
        duration=times * DURATIONS.sum(),
        energy=SimpleNamespace(low=0.02 if known else None),
        mean_torque=SimpleNamespace(value=6e-3),
        mean_power=SimpleNamespace(value=1.1),
    )


def stairs_of(panel: Axes, label: str) -> Any:
    (found,) = (each for each in panel.patches if isinstance(each, StepPatch) and each.get_label() == label)
    return found.get_data()


@pytest.mark.parametrize("units", [METRIC, INCH_POUND], ids=["metric", "inch"])
def test_steps_of_torque_and_power_stand_over_their_own_time_with_their_means(units: Units) -> None:
    figure = duty_figure(cycle(), units)
    above, below = figure.axes
    for panel, label, values, mean in (
        (above, "torque", units.torque.factor * TORQUES, units.torque.factor * 6e-3),
        (below, "power", POWERS, 1.1),
    ):
        data = stairs_of(panel, label)
        np.testing.assert_allclose(data.edges, [0, 20, 70, 100], rtol=1e-12)
        np.testing.assert_allclose(data.values, values, rtol=1e-12)
        np.testing.assert_allclose(points_of(line_of(panel, f"mean {label}"))[:, 1], mean, rtol=1e-12)
        assert panel.get_ylim()[0] == 0
        assert panel.get_ylim()[1] > values.max()
    band = stairs_of(above, "95 %")
    np.testing.assert_allclose(band.values, units.torque.factor * 1.3 * TORQUES * [1, 0, 1], rtol=1e-12)
    np.testing.assert_allclose(band.baseline, units.torque.factor * 0.8 * TORQUES * [1, 0, 1], rtol=1e-12)
    assert (above.get_ylabel(), below.get_ylabel()) == (f"friction torque, {units.torque.name}", "power, W")
    require_legible(figure)


def test_a_cycle_without_an_interval_has_no_band() -> None:
    above = duty_figure(cycle(known=False)).axes[0]
    assert [each.get_label() for each in above.patches] == ["torque"]


@pytest.mark.parametrize(
    ("times", "name", "end"),
    [(5.99, "s", 599.0), (6.0, "min", 10.0), (359.0, "min", 598.333333), (360.0, "h", 10.0)],
)
def test_time_is_in_seconds_in_minutes_from_ten_on_and_in_hours_from_ten_on(
    times: float, name: str, end: float
) -> None:
    below = duty_figure(cycle(times=times)).axes[1]
    assert below.get_xlabel() == f"time, {name}"
    assert stairs_of(below, "power").edges[-1] == pytest.approx(end, rel=1e-8)
