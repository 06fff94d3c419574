"""The interval in figure and document: both show the computed numbers."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import Rectangle
from pydantic import ValidationError

from fembearing.quantities import METRIC
from fembearing.report.figures.prediction import interval_figure, prediction_plot
from fembearing.report.report import Report
from tests.report.figures.figure_reader import require_legible
from tests.report.prediction_rows import content, prediction_of


def rectangles(panel: Axes) -> list[Rectangle]:
    return [patch for patch in panel.patches if isinstance(patch, Rectangle)]


def test_the_figure_has_the_ends_of_every_part_and_the_indices_of_the_inputs_that_matter() -> None:
    figure = interval_figure(prediction_of(content()), METRIC)
    panels = figure.axes
    assert len(panels) == 4
    slow, fast, slow_indices, _ = panels
    bars = [(bar.get_x(), bar.get_x() + bar.get_width()) for bar in rectangles(slow)]
    wanted = [(0.6, 1.9), (0.98, 1.03), (0.7, 1.5), (0.8, 1.4), (0.9, 1.1)]
    assert bars == [pytest.approx((21 * low, 21 * high)) for low, high in wanted]
    assert "rpm" in fast.get_title()
    names = [label.get_text() for label in slow_indices.get_yticklabels()]
    assert names == ["film formula", "viscosity"]  # the numerical one is below half a per cent at both points
    widths = [bar.get_width() for bar in rectangles(slow_indices)]
    assert widths == pytest.approx([61, 55, 14, 11])
    require_legible(figure)


def test_indices_of_other_inputs_are_refused() -> None:
    damaged = content()
    damaged["points"][1]["indices"]["total"] = [0.1]
    with pytest.raises(ValidationError, match="indices of other than its 3 inputs"):
        prediction_of(damaged)
    with pytest.raises(ValidationError, match="unexpected_keyword_argument"):
        prediction_of(content() | {"mood": "good"})


def test_inputs_are_ranked_by_their_largest_index_at_either_end() -> None:
    assert prediction_of(content()).ranked == [1, 0, 2]  # 0.61, 0.44 and 0.001


def bars_in(panel: Axes) -> list[LineCollection]:
    return [part for part in panel.collections if isinstance(part, LineCollection)]


def with_inputs(indices: list[float]) -> Any:
    """So many inputs, with these total indices at both points."""
    rows = prediction_of(content())
    inputs = tuple(replace(rows.inputs[0], key=f"bearing.part_{number}") for number in range(len(indices)))
    values = tuple(indices)
    points = tuple(
        replace(
            point,
            indices=replace(point.indices, first=values, total=values, first_error=values, total_error=values),
        )
        for point in rows.points
    )
    return replace(rows, inputs=inputs, points=points)


def test_at_most_eight_inputs_are_drawn_and_none_below_half_a_per_cent() -> None:
    heights = {}
    for indices, drawn in (
        ([0.9 - 0.01 * number for number in range(8)], 8),
        ([0.9 - 0.01 * number for number in range(9)], 8),
        ([0.5, 0.0051, 0.0049], 2),
    ):
        figure = interval_figure(with_inputs(indices), METRIC)
        names = [label.get_text() for label in figure.axes[2].get_yticklabels()]
        assert names == [f"part {number}" for number in range(drawn)]
        heights[drawn] = figure.get_figheight()
    assert heights[8] - heights[2] == pytest.approx(6 * 0.14, rel=1e-9)


def test_errors_of_indices_are_two_standard_errors_and_the_torque_is_a_line() -> None:
    figure = interval_figure(prediction_of(content()), METRIC)
    _, _, slow, fast = figure.axes
    for panel, errors in ((slow, (0.034, 0.03)), (fast, (0.034, 0.03))):
        ends = [np.asarray(line)[:, 0] for part in bars_in(panel) for line in part.get_segments()]
        assert [np.ptp(each) for each in ends] == pytest.approx([4 * 100 * error for error in errors], rel=1e-9)
    for panel, nominal in zip(figure.axes[:2], (21.0, 34.0), strict=True):
        (line,) = panel.get_lines()
        assert np.asarray(line.get_xdata()).tolist() == pytest.approx([nominal, nominal], rel=1e-12)
        low, high = panel.get_xlim()
        assert low < 0.6 * nominal
        assert high > 1.9 * nominal


def test_a_report_without_an_interval_has_no_figure_of_it() -> None:
    for torque in (None, SimpleNamespace(prediction=None)):
        assert prediction_plot(cast(Report, SimpleNamespace(torque=torque, units=METRIC))) == (None, "")
    rows = prediction_of(content())
    known = cast(Report, SimpleNamespace(torque=SimpleNamespace(prediction=rows), units=METRIC))
    figure, caption = prediction_plot(known)
    assert figure is not None
    assert "300 samples, seed 77." in caption
