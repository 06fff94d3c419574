"""The figure of a torque alone: by its operating points a series or bars, and for one point a bar for each part."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import parse_scene
from fembearing.quantities import METRIC
from fembearing.report.figures.series_axis import axis_of
from fembearing.report.figures.torque import PARTS, Beside, beside_of
from fembearing.report.figures.torque_alone import BAR, MOST_NAMES, _bars, _one_point, figure_of_torque
from fembearing.report.tables.torque import RESIDUE
from fembearing.report.torque import torque_record
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


def point_of(**parts: float | None) -> Any:
    """A torque of these parts, N m, at 300 rpm."""
    torque = dict.fromkeys(PARTS) | parts
    total = sum(value for value in parts.values() if value is not None)
    return SimpleNamespace(
        inner_speed=10 * np.pi,
        axial_load=0.0,
        radial_load=700.0,
        moment=0.0,
        torque=SimpleNamespace(**torque, total=total),
        uncertainty=SimpleNamespace(numerical=0.0123, model=None),
    )


def beside(low: float = np.nan, high: float = np.nan, **makers: tuple[float, float]) -> Beside:
    return Beside(
        interval=np.array([[low], [high]]), makers={name: np.array([[a], [b]]) for name, (a, b) in makers.items()}
    )


def test_a_small_part_has_one_digit_and_a_residue_is_0() -> None:
    parts = {"spin": 0.02 * RESIDUE / 2, "rolling": 8e-6, "cage": 25e-6, "hysteresis": 0.02}
    (panel,) = _one_point(point_of(**parts), "6205", beside(), METRIC).axes
    names = [label.get_text() for label in panel.get_yticklabels()]
    numbers = dict(zip(names, [text.get_text() for text in panel.texts], strict=True))
    assert numbers["spin"] == "0"
    assert numbers[PARTS["rolling"][0]] == "0.008"
    assert numbers["cage"] == "0.025"  # above a thousandth of the total
    assert numbers["hysteresis"] == "20"
    assert panel.get_xlim() == (0, pytest.approx(1.5 * 1e3 * sum(parts.values()), rel=1e-12))


def test_makers_have_both_of_their_ends_or_one_number() -> None:
    found = beside(0.018, 0.031, SKF=(0.022, 0.022), Palmgren=(0.017, 0.044), Nobody=(np.nan, 0.02))
    (panel,) = _one_point(point_of(rolling=0.02), "6205", found, METRIC).axes
    names = [label.get_text() for label in panel.get_yticklabels()]
    assert names == [PARTS["rolling"][0], "total", "SKF, formula", "Palmgren, formula"]
    assert [text.get_text() for text in panel.texts] == ["20", "20", "22", "17-44"]
    lines = [np.asarray(line.get_xydata()).tolist() for line in panel.get_lines() if line.get_marker() == "|"]
    assert [[22.0, 2.0], [22.0, 2.0]] in lines
    assert [[17.0, 3.0], [44.0, 3.0]] in lines
    assert panel.get_xlim()[1] == pytest.approx(1.5 * 44, rel=1e-12)


def test_the_title_has_the_interval_or_what_is_known_of_the_uncertainty() -> None:
    point = point_of(rolling=0.02)
    known = _one_point(point, "6205", beside(0.018, 0.031), METRIC)
    assert known.get_suptitle() == "6205, 700 N radial, 300 rpm\n95 % interval 18-31 N mm"
    assert _one_point(point, "6205", beside(), METRIC).get_suptitle().endswith("$\\pm$ 1.2 % numerical")
    point.uncertainty = SimpleNamespace(numerical=None, model=0.034)
    words = _one_point(point, "6205", beside(), METRIC).get_suptitle()
    assert words.endswith("numerical uncertainty unknown, $\\pm$ 3.4 % by the formulas")
    still = _one_point(point_of(rolling=0.0), "6205", beside(), METRIC).axes[0]
    assert still.get_xlim() == (0, 1)


def test_a_figure_is_as_high_as_its_bars_and_names_at_most_so_many() -> None:
    one, three = (
        _one_point(point_of(**parts), "6205", beside(), METRIC).get_figheight()
        for parts in ({"rolling": 0.02}, {"rolling": 0.02, "spin": 0.01, "cage": 0.01})
    )
    assert three - one == pytest.approx(2 * BAR, rel=1e-9)
    for count, step in ((MOST_NAMES, 1), (MOST_NAMES + 1, 2)):
        points: Any = [
            SimpleNamespace(**vars(point_of(rolling=0.02)) | {"inner_speed": 1.0 + number % 3, "radial_load": number})
            for number in range(count)
        ]
        axis = axis_of(points, METRIC)
        nothing = Beside(interval=np.full((2, count), np.nan), makers={})
        figure = _bars(axis, "6205", nothing)
        (panel,) = figure.axes
        assert panel.get_yticks().tolist() == list(range(0, count, step))
        low, high = panel.get_ylim()
        assert low == pytest.approx(count - 1 - high, rel=1e-9)  # the first one on top, as much room at both ends
        assert figure.get_figheight() == pytest.approx(2.1 + BAR * MOST_NAMES, rel=1e-9)
