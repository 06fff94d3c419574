"""The figure of a torque alone: by its operating points a series or bars, and for one point a bar for each part."""

import numpy as np
import pytest
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

from analytic.scenefile.read import parse_scene
from fembearing.report.figures.torque import beside_of
from fembearing.report.figures.torque_alone import figure_of_torque
from fembearing.report.torque import torque_record
from fembearing.verify.torque.scene_torque import torque_of_scene
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import bars_of, require_legible


def test_one_point_has_a_bar_for_each_part_with_its_number() -> None:
    result = torque_of_scene(parse_scene(changed(SPEEDS, '"300 rpm"', OILED), origin="here"))
    figure = figure_of_torque(result)
    (panel,) = figure.axes
    names = [label.get_text() for label in panel.get_yticklabels()]
    parts = [part for part in vars(result.friction.torque).values() if part is not None]
    total = names.index("total")
    assert total < len(parts)
    makers = beside_of(torque_record(result)).makers
    assert names[total + 1 :] == [f"{maker}, formula" for maker in makers]
    widths = [patch.get_width() for patch in panel.patches]  # pyright: ignore[reportAttributeAccessIssue]
    assert widths[-1] == pytest.approx(1e3 * result.friction.torque.total[0], rel=1e-12)  # N mm
    assert np.sum(widths[:-1]) == pytest.approx(widths[-1], rel=1e-9)  # round-off of the sum
    numbers = [each.get_text() for each in panel.texts]
    assert numbers[total] == f"{widths[-1]:.4g}"
    (low, high) = 1e3 * np.array(present(torque_record(result).interval[0]))
    (container,) = panel.containers[1:]
    (segment,) = container.lines[2][0].get_segments()  # pyright: ignore[reportAttributeAccessIssue]
    np.testing.assert_allclose(segment[:, 0], [low, high], rtol=1e-9)  # differences of near values
    right = [each.xy[0] for each in panel.texts if isinstance(each, Annotation)]
    np.testing.assert_allclose(right[:total], widths[:total], rtol=1e-12)  # a number stands at the end of its bar,
    assert right[total] == pytest.approx(high, rel=1e-12)  # that of the total beyond its interval
    assert panel.get_xlim()[1] > max(right)
    require_legible(figure)


def test_points_at_several_speeds_are_a_line_over_speed() -> None:
    result = torque_of_scene(parse_scene(changed(SPEEDS, '["300 rpm", "700 rpm"]', OILED), origin="here"))
    (panel,) = figure_of_torque(result).axes
    assert "speed" in panel.get_xlabel()
    (total,) = (line for line in panel.lines if line.get_label() == "total")
    np.testing.assert_allclose(np.asarray(total.get_ydata()), 1e3 * result.friction.torque.total, rtol=1e-12)


def test_points_that_no_line_joins_have_bars_that_add_up_to_their_totals() -> None:
    """Speed and load change from point to point."""
    text = changed(SPEEDS, '["300 rpm", "700 rpm"]', OILED)
    result = torque_of_scene(parse_scene(changed('"700 N"', '["900 N", "400 N"]', text), origin="here"))
    figure = figure_of_torque(result)
    (panel,) = figure.axes
    ends = np.zeros(2)
    for patch in panel.patches:
        assert isinstance(patch, Rectangle)
        row = round(patch.get_y() + patch.get_height() / 2)
        assert patch.get_x() == pytest.approx(ends[row], rel=1e-12)
        ends[row] += patch.get_width()
    np.testing.assert_allclose(ends, 1e3 * result.friction.torque.total, rtol=1e-9)  # N mm
    interval = 1e3 * np.array([present(each) for each in torque_record(result).interval])
    np.testing.assert_allclose(bars_of(panel, "total, 95 % interval", axis=0), interval, rtol=1e-9)
    require_legible(figure)
