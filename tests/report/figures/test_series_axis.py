"""What operating points are drawn over: the quantity that varies alone, with its ticks and scale; else by number."""

from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.rows import OperatingPoint
from fembearing.quantities import METRIC
from fembearing.report.figures.series_axis import MOST_TICKS, SeriesAxis, axis_of
from fembearing.report.figures.style import MANY

RPM = np.pi / 30


def series(*points: tuple[float, float]) -> Any:
    """At these speeds, rpm, and axial loads, N."""
    return [
        OperatingPoint(inner_speed=speed * RPM, axial_load=load, radial_load=0.0, moment=0.0) for speed, load in points
    ]


def over_speeds(*speeds: float) -> SeriesAxis:
    return axis_of(series(*((speed, 700.0) for speed in speeds)), METRIC)


def panel_with(axis: SeriesAxis) -> Axes:
    panel = Figure().subplots()
    panel.plot(axis.values, axis.values)
    axis.apply(panel)
    return panel


def test_many_points_on_a_line_have_no_marks_and_points_by_themselves_always_have() -> None:
    for count, mark in ((MANY, "o"), (MANY + 1, "")):
        assert over_speeds(*range(100, 100 + count)).mark == mark
    apart = axis_of(series(*((100.0 + number // 2, 700.0 + number) for number in range(MANY + 1))), METRIC)
    assert (apart.joined, apart.mark) == (False, "o")


def test_points_stand_in_the_order_of_the_size_of_their_speed() -> None:
    axis = over_speeds(-500.0, 100.0, 300.0)
    np.testing.assert_allclose(axis.values, [100, 300, 500], rtol=1e-12)
    assert axis.order == [1, 2, 0]
    assert axis.over == "inner_speed"
    assert not over_speeds(100.0, -100.0, 300.0).joined  # two at one place


def test_names_have_what_differs_and_the_title_what_is_the_same() -> None:
    mixed = axis_of(series((100.0, 700.0), (300.0, 900.0)), METRIC)
    assert mixed.names == ["100 rpm, 700 N axial", "300 rpm, 900 N axial"]
    assert mixed.fixed == ""
    loads = axis_of(series((100.0, 700.0), (100.0, 900.0), (100.0, 700.0)), METRIC)
    assert loads.names == ["700 N axial", "900 N axial", "700 N axial"]
    assert loads.fixed == "100 rpm"
    speeds = axis_of(series((100.0, 700.0), (300.0, 700.0), (100.0, 700.0)), METRIC)
    assert speeds.names == ["100 rpm", "300 rpm", "100 rpm"]
    assert speeds.fixed == "700 N axial"
    alike = axis_of(series((100.0, 700.0), (100.0, 700.0)), METRIC)
    assert alike.names == ["700 N axial", "700 N axial"]
    assert alike.fixed == "700 N axial, 100 rpm"


@pytest.mark.parametrize(
    ("speeds", "scale"),
    [
        ((100.0, 300.0, 1000.0), "linear"),  # a decade
        ((100.0, 300.0, 1001.0), "log"),
        ((0.0, 300.0, 9000.0), "linear"),
    ],
)
def test_more_than_a_decade_is_logarithmic_unless_it_begins_at_0(speeds: tuple[float, ...], scale: str) -> None:
    assert panel_with(over_speeds(*speeds)).get_xscale() == scale


def test_few_values_are_the_ticks_of_a_logarithmic_axis_and_many_are_not() -> None:
    for count, own in ((MOST_TICKS, True), (MOST_TICKS + 1, False)):
        axis = over_speeds(*np.geomspace(37.0, 4300.0, count))
        ticks = np.asarray(panel_with(axis).get_xticks())
        assert (ticks.size == count and np.allclose(ticks, axis.values, rtol=1e-9)) == own


def test_points_by_themselves_are_named_at_most_eight_times_and_fill_their_panel() -> None:
    for count, step in ((MOST_TICKS, 1), (MOST_TICKS + 1, 2), (3 * MOST_TICKS, 3)):
        axis = axis_of(series(*((100.0 + number, 700.0 + number) for number in range(count))), METRIC)
        panel = panel_with(axis)
        assert panel.get_xticks().tolist() == list(range(0, count, step))
        assert [text.get_text() for text in panel.get_xticklabels()] == axis.names[::step]
        low, high = panel.get_xlim()
        assert -1 < low < 0
        assert high - (count - 1) == pytest.approx(-low, rel=1e-9)  # as much room at both ends
