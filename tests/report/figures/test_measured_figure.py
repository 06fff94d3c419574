"""Measured torques in a figure: points, bars and bands are where the rows are."""

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.container import ErrorbarContainer

from fembearing.quantities import METRIC
from fembearing.report.figures.measured import axis_of, caption_of, measured_figure, measured_plot
from fembearing.report.report import Report
from tests.report.figures.figure_reader import require_legible
from tests.report.measured_rows import TWO, comparison, row


@pytest.mark.parametrize(
    ("changes", "label", "values", "curves"),
    [
        ([{}, {}], "row", [1, 2], ["computed"]),
        ([{}, {"inner_speed": 15 * np.pi}], "inner speed, rpm", [600, 450], ["computed"]),
        ([{}, {"axial_load": 300.0}], "axial load, N", [700, 300], ["computed"]),
        ([{}, {"temperature": 323.15}], "temperature of the oil, degC", [60, 50], ["computed"]),
        (
            [{}, {"inner_speed": 15 * np.pi}, {"axial_load": 300.0}],
            "inner speed, rpm",
            [600, 450, 600],
            ["computed, 700 N", "computed, 300 N"],
        ),
    ],
)
def test_the_figure_is_over_the_first_quantity_that_varies(
    changes: list[dict[str, float]], label: str, values: list[float], curves: list[str]
) -> None:
    axis = axis_of([row(**each) for each in changes], METRIC)
    assert axis.label == label
    np.testing.assert_allclose(axis.values, values, rtol=1e-12)  # of a unit
    assert [*axis.curves] == curves
    for places in axis.curves.values():
        assert list(axis.values[places]) == sorted(axis.values[places])


def drawn(panel: Axes) -> dict[str, tuple[list[float], list[float]]]:
    """Places of the points of a panel, by their mark."""
    lines = [(str(line.get_marker()), np.asarray(line.get_xydata())) for line in panel.lines]
    return {mark: (xy[:, 0].tolist(), xy[:, 1].tolist()) for mark, xy in lines if mark in ("o", "D") and xy.size}


def test_points_bars_and_bands_are_where_the_rows_are() -> None:
    report = cast(Report, SimpleNamespace(measured=TWO, units=METRIC))
    figure, caption = measured_plot(report)
    assert figure is not None
    assert "1 of 2 points miss" in caption
    above, below = figure.axes
    band = above.collections[0].get_paths()[0].vertices
    assert {round(float(y), 9) for y in np.asarray(band)[:, 1]} == {41.0, 62.0}  # N mm, of the computed torque alone
    assert drawn(above) == {"o": ([pytest.approx(900)], [40.0]), "D": ([pytest.approx(600)], [40.0])}
    assert drawn(below) == {mark: (speeds, [pytest.approx(25.0)]) for mark, (speeds, _) in drawn(above).items()}
    for panel, middle, half in ((above, 40, 1.96 * 2), (below, 25, 1.96 * 9)):
        drawn_bars = [each.get_segments() for each in panel.collections if isinstance(each, LineCollection)]
        ends = [np.sort(np.asarray(segment)[:, 1]) for segments in drawn_bars for segment in segments if len(segment)]
        np.testing.assert_allclose(ends, 2 * [(middle - half, middle + half)], rtol=1e-3)  # 1.96 has three digits
    assert measured_plot(cast(Report, SimpleNamespace(measured=None, units=METRIC))) == (None, "")
    require_legible(figure)


def test_more_curves_than_colours_are_drawn_as_points() -> None:
    rows = [row(axial_load=100.0 * number, inner_speed=speed) for number in range(2, 9) for speed in (30.0, 60.0)]
    figure = measured_figure(comparison(*rows))
    words = [text.get_text() for text in figure.legends[0].get_texts()]
    assert words == ["computed, 95 %", "measured, missed"]


def test_a_row_alone_on_its_curve_has_a_bar_and_several_have_a_band() -> None:
    """Two loads: one at two speeds, the other at one."""
    rows = [row(), row(inner_speed=30.0), row(axial_load=300.0)]
    figure = measured_figure(comparison(*rows))
    above = figure.axes[0]
    bands = [each for each in above.collections if isinstance(each, PolyCollection)]
    assert len(bands) == 1
    words = [text.get_text() for text in figure.legends[0].get_texts()]
    assert words[:2] == ["computed, 700 N, 95 %", "computed, 300 N, 95 %"]
    (bar,) = (each for each in above.containers if str(each.get_label()).startswith("computed, 300 N"))
    assert isinstance(bar, ErrorbarContainer)
    (segment,) = bar.lines[2][0].get_segments()
    np.testing.assert_allclose(np.asarray(segment)[:, 1], [41, 62], rtol=1e-9)  # N mm, of the computed torque


def test_four_curves_have_a_colour_each_and_five_have_one() -> None:
    for count, colours in ((4, 4), (5, 1)):
        rows = [
            row(axial_load=100.0 * number, inner_speed=speed)
            for number in range(2, 2 + count)
            for speed in (30.0, 60.0)
        ]
        axis = axis_of(rows, METRIC)
        assert len({axis.colour(curve) for curve in axis.curves}) == colours
        assert axis.many == (count == 5)


def test_speeds_over_a_decade_are_on_a_logarithmic_scale() -> None:
    for fast, scale in ((200.0, "linear"), (400.0, "log")):
        figure = measured_figure(comparison(row(inner_speed=30.0), row(inner_speed=fast)))
        assert {panel.get_xscale() for panel in figure.axes} == {scale}
        assert figure.axes[0].get_ylim()[0] == 0


def test_a_caption_counts_what_is_missed() -> None:
    assert "no point misses" in caption_of(comparison(row(verdict="inside"), row(verdict="inside")))
    assert "2 of 3 points miss" in caption_of(
        comparison(row(verdict="inside"), row(verdict="model too low"), row(verdict="model too high"))
    )
