"""Loads and angles of all balls: every ball is to be seen, and angles that are alike look alike."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.projections.polar import PolarAxes

from fembearing.report.figures.ring import LEAST_SPAN, ring_plot
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import as_document, points_of, require_legible

AZIMUTH = [0.3, 1.7, 3.9]  # rad


def document(angles: list[float | None]) -> Any:
    balls = {
        "azimuth": AZIMUTH,
        "inner_load": [210.0, 0.0, 95.0],
        "outer_load": [212.0, 1.5, 97.0],
        "inner_angle": angles,
        "outer_angle": angles,
    }
    point = {"inner_speed": 31.0, "axial_load": 100.0, "radial_load": 200.0, "moment": 0.0, "ring": {"balls": balls}}
    return as_document({"torque": {"points": [point]}})


@pytest.mark.parametrize("angles", [[0.21, None, 0.17], [0.21, 0.21 + 2e-9, None]])
def test_every_angle_is_within_a_panel_that_hides_round_off(angles: list[float | None]) -> None:
    figure, _ = ring_plot(document(angles))
    _, panel = present(figure).axes
    low, high = panel.get_ylim()
    known = np.degrees([each for each in angles if each is not None])
    assert low < known.min()
    assert known.max() < high
    spread = known.max() - known.min()
    # No wider than that for angles that are alike; others fill their panel but for its margins of a twentieth.
    assert high - low == pytest.approx(max(LEAST_SPAN, 1.1 * spread), rel=1e-6)  # of the angles' round-off
    assert low + high == pytest.approx(known.min() + known.max(), rel=1e-9)


def test_every_load_is_within_the_circle() -> None:
    figure, _ = ring_plot(document([0.21, None, 0.17]))
    polar, _ = present(figure).axes
    outer = polar.get_lines()[1]
    np.testing.assert_allclose(np.asarray(outer.get_ydata()), [212.0, 1.5, 97.0, 212.0], rtol=1e-12)
    assert 212.0 < polar.get_ylim()[1] < 300.0
    ticks = np.asarray(polar.get_yticks())
    assert np.all((ticks > 0) & (ticks < polar.get_ylim()[1]))
    assert ticks.size >= 2
    require_legible(present(figure))


def test_lines_around_the_ring_are_closed_and_angles_stand_at_their_balls() -> None:
    figure, caption = ring_plot(document([0.21, None, 0.17]))
    polar, angles = present(figure).axes
    for line, race in zip(polar.get_lines(), ("inner", "outer"), strict=True):
        places = points_of(line)
        np.testing.assert_allclose(places[:, 0], [*AZIMUTH, AZIMUTH[0] + 2 * np.pi], rtol=1e-12)  # once round
        assert line.get_label() == f"{race} race"
    for line in angles.get_lines():
        np.testing.assert_allclose(points_of(line)[:, 0], np.degrees(AZIMUTH), rtol=1e-12)
        np.testing.assert_allclose(points_of(line)[[0, 2], 1], np.degrees([0.21, 0.17]), rtol=1e-12)
        assert np.isnan(points_of(line)[1, 1])
    low, high = angles.get_xlim()
    assert low < 0 < 360 <= high
    assert angles.get_xticks().tolist() == [0, 90, 180, 270, 360]
    np.testing.assert_allclose(np.degrees(polar.get_xticks()), [0, 90, 180, 270], rtol=1e-12)
    assert "Load of every ball, N" in caption
    assert isinstance(polar, PolarAxes)
    assert polar.get_rlabel_position() == pytest.approx(135, rel=1e-9)  # between two lines of the grid


def test_the_first_and_the_last_point_stand_side_by_side_and_one_stands_alone() -> None:
    for count, shown in ((1, 1), (2, 2), (4, 2)):
        found = document([0.21, None, 0.17])
        (point,) = found.torque.points
        found.torque.points = [
            SimpleNamespace(**vars(point) | {"inner_speed": 30.0 + 10 * number}) for number in range(count)
        ]
        figure, _ = ring_plot(found)
        titles = [panel.get_title().splitlines()[0] for panel in present(figure).axes]
        speeds = [f"{(30.0 + 10 * number) * 30 / np.pi:.5g} rpm" for number in (0, count - 1)][:shown]
        assert titles == [title for title in speeds for _ in range(2)]
        columns = [present(panel.get_subplotspec()).colspan.start for panel in present(figure).axes]
        assert columns == ([0, 1] if shown == 1 else [0, 2, 1, 3])  # loads first, then angles


def test_each_load_has_a_line_so_that_the_titles_of_two_points_stand_apart() -> None:
    found = document([0.21, None, 0.17])
    (point,) = found.torque.points
    loads = {"inner_speed": 1260.0, "axial_load": 1450.0, "radial_load": -2350.0, "moment": 0.75}
    found.torque.points = [point, SimpleNamespace(**vars(point) | loads)]
    figure = present(ring_plot(found)[0])
    assert figure.axes[2].get_title() == "12032 rpm\n1450 N axial\n-2350 N radial\n750 N mm moment"
    require_legible(figure)


def test_balls_without_a_load_and_pairs_of_bearings_are_no_fault() -> None:
    found = document([None, None, None])
    (point,) = found.torque.points
    point.ring.balls.inner_load = point.ring.balls.outer_load = [0.0, 0.0, 0.0]
    polar, _ = present(ring_plot(found)[0]).axes
    assert polar.get_ylim()[1] > 0
    point.ring = None
    assert ring_plot(found) == (None, "Pair of bearings: ring and balls of each bearing are available from Python.")
    found.torque = None
    figure, words = ring_plot(found)
    assert figure is None
    assert "No torque" in words
