"""What operating points are drawn over, and the scales of axes."""

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.figures.series_axis import MOST_TICKS, SeriesAxis, axis_of
from analytic.figures.style import scaled
from analytic.units import INCH_POUND, METRIC, Units
from tests.report.figures.figure_reader import require_legible

RPM = np.pi / 30


def series(*points: tuple[float, float], units: Units = METRIC) -> SeriesAxis:
    """At these speeds, rpm, and axial loads, N."""
    speeds, loads = np.array(points).T
    nothing = np.zeros(speeds.size)
    columns = {"inner_speed": speeds * RPM, "axial_load": loads, "radial_load": nothing, "moment": nothing}
    return axis_of(columns, units)


def over_speeds(*speeds: float) -> SeriesAxis:
    return series(*((speed, 700.0) for speed in speeds))


def panel_with(axis: SeriesAxis) -> Axes:
    panel = Figure(figsize=(4.6, 4.6), layout="constrained").subplots()
    panel.plot(axis.values, axis.values)
    axis.apply(panel)
    return panel


def test_points_and_their_columns_stand_in_the_order_of_the_size_of_their_speed() -> None:
    axis = over_speeds(-500.0, 100.0, 300.0)
    np.testing.assert_allclose(axis.values, [100, 300, 500], rtol=1e-12)
    np.testing.assert_allclose(axis.columns["inner_speed"] / RPM, [100, 300, -500], rtol=1e-12)
    assert axis.order.tolist() == [1, 2, 0]
    assert (axis.over, axis.label) == ("inner_speed", "inner speed, rpm")
    assert not over_speeds(100.0, -100.0, 300.0).joined  # two at one place


def test_a_series_of_loads_is_over_the_load_in_the_units_that_are_shown() -> None:
    axis = series((200.0, 900.0), (200.0, 300.0), units=INCH_POUND)
    np.testing.assert_allclose(axis.values, np.array([300, 900]) / 4.4482216152605, rtol=1e-12)
    assert axis.label == "axial load, lbf"


def test_names_have_what_differs_and_the_title_what_is_the_same() -> None:
    for points, names, fixed in (
        ([(100.0, 700.0), (300.0, 900.0)], ["100 rpm, 700 N axial", "300 rpm, 900 N axial"], ""),
        ([(100.0, 700.0), (100.0, 900.0), (100.0, 700.0)], ["700 N axial", "900 N axial", "700 N axial"], "100 rpm"),
        ([(100.0, 700.0), (300.0, 700.0), (100.0, 700.0)], ["100 rpm", "300 rpm", "100 rpm"], "700 N axial"),
        ([(100.0, 700.0), (100.0, 700.0)], ["700 N axial", "700 N axial"], "700 N axial, 100 rpm"),
    ):
        axis = series(*points)
        assert (axis.names, axis.fixed) == (names, fixed)


def test_few_values_are_the_ticks_of_a_logarithmic_axis_and_many_or_near_ones_are_not() -> None:
    for values, own in (
        (np.geomspace(37.0, 4300.0, MOST_TICKS), True),
        (np.geomspace(37.0, 4300.0, MOST_TICKS + 1), False),
        ([10.0, 950.0, 1000.0], False),
    ):
        panel = panel_with(over_speeds(*values))
        ticks = np.asarray(panel.get_xticks())
        assert (ticks.size == len(values) and np.allclose(ticks, values, rtol=1e-9)) == own
    require_legible(panel.figure)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(
    ("values", "scale"),
    [
        ((2.0, 19.9), "linear"),
        ((2.0, 20.0), "log"),
        ((2.0, 20.1, np.nan), "log"),
        ((0.0, 700.0), "linear"),
        ((-2.0, 700.0), "linear"),
        ((np.nan, np.inf), "linear"),
    ],
)
@pytest.mark.parametrize("axis", ["x", "y"])
def test_values_above_0_over_a_decade_are_on_a_logarithmic_scale(
    values: tuple[float, ...], scale: str, axis: str
) -> None:
    panel = Figure().subplots()
    panel.plot([1.0, 3.0], [1.0, 3.0])
    scaled(panel, np.array(values), axis=axis)
    found = {"x": panel.get_xscale(), "y": panel.get_yscale()}
    assert found == {"x": "linear", "y": "linear"} | {axis: scale}
