"""The interval in figure and document: both show the computed numbers."""

import pytest
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from pydantic import ValidationError

from fembearing.quantities import METRIC
from fembearing.report.figures.prediction import interval_figure
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
