"""The interval in document, terminal and figure: what is shown is what was computed."""

import json
from dataclasses import dataclass
from io import StringIO
from typing import Any, ClassVar

import pytest
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from pydantic import TypeAdapter, ValidationError
from rich.console import Console

from analytic.prediction.rows import PredictionRows
from fembearing.quantities import METRIC
from fembearing.report.figures.prediction import interval_figure
from fembearing.report.tables.prediction import interval_table, shares_table
from fembearing.report.terminal.table import show
from tests.report.figures.figure_reader import require_legible


def point(speed: float, nominal: float, totals: list[float]) -> dict[str, Any]:
    ends = {"low": 0.6 * nominal, "median": nominal, "high": 1.9 * nominal, "low_error": 2e-4, "high_error": 7e-4}
    return {
        "inner_speed": speed,
        "axial_load": 640.0,
        "radial_load": 0.0,
        "moment": 0.0,
        "nominal": nominal,
        "total": ends,
        "parts": {"race": ends},
        "made_of": {
            "numerical": [0.98 * nominal, 1.03 * nominal],
            "input": [0.7 * nominal, 1.5 * nominal],
            "model": [0.8 * nominal, 1.4 * nominal],
            "model.film": [0.9 * nominal, 1.1 * nominal],
        },
        "indices": {
            "first": [0.11, 0.55, 0.0],
            "total": totals,
            "first_error": [0.01, 0.02, 0.001],
            "total_error": [0.03, 0.04, 0.002],
        },
        "explained": 0.97,
    }


@dataclass(frozen=True)
class Whole:
    """As a report reads them: strictly."""

    __pydantic_config__: ClassVar = {"strict": True, "extra": "forbid", "allow_inf_nan": False}
    rows: PredictionRows


def prediction_of(content: dict[str, Any]) -> PredictionRows:
    return TypeAdapter(Whole).validate_json(json.dumps({"rows": content})).rows


def content() -> dict[str, Any]:
    made = {"value": 1.5, "deviation": 0.2, "source": "judgement", "floor": 0.0}
    return {
        "covered": 0.95,
        "points": [point(10.0, 0.021, [0.14, 0.61, 0.0]), point(50.0, 0.034, [0.44, 0.31, 0.001])],
        "inputs": [
            made | {"key": "lubricant.viscosity", "unit": "Pa*s", "kind": "input"},
            made | {"key": "model.film", "unit": "", "kind": "model"},
            made | {"key": "numerical", "unit": "", "kind": "numerical"},
        ],
        "not_varied": ["the moon"],
        "samples": 300,
        "failed": 2,
        "reasons": ["a ball fell out (2 times)"],
        "seed": 77,
        "seconds": 12.0,
        "evaluation_seconds": 22.0,
    }


def printed(prediction: PredictionRows) -> str:
    out = StringIO()
    for table in (interval_table(prediction, range(2)), shares_table(prediction)):
        show(Console(file=out, width=80), table)
    return out.getvalue()


def rectangles(panel: Axes) -> list[Rectangle]:
    return [patch for patch in panel.patches if isinstance(patch, Rectangle)]


def test_the_terminal_shows_ends_parts_inputs_and_failures() -> None:
    said = printed(prediction_of(content()))
    assert max(map(len, said.splitlines())) <= 80
    rows = [line.split() for line in said.splitlines()]
    assert ["1", "21.00", "12.6-39.9", "0.2,", "0.7", "20.6-21.6", "14.7-31.5", "16.8-29.4"] in rows
    words = " ".join(said.split())
    for word in (
        "film formula 55 +- 2 61 +- 4 55 +- 2 31 +- 4",
        "95 % interval by 300 Latin hypercube samples, seed 77, in 12 s",
        "the standard error of an end is at most 1.8 %",  # 7e-4 of 1.9 x 0.021
        "2 of 300 samples have no torque and are left out: a ball fell out (2 times).",
        "Not included: the moon.",
        "explains 97 % or more of the variance; the rest is attributed to no input",
        "film formula 18.9-23.1 and 30.6-37.4",
    ):
        assert word in words, word


def test_shares_of_a_regression_that_predicts_nothing_are_said_to_be_unknown() -> None:
    """Left-out predictions can miss by more than the mean does: their share of the variance is then below 0."""
    failed = content()
    failed["points"][1]["explained"] = -1600.7
    words = " ".join(printed(prediction_of(failed)).split())
    assert "explains 0 % or more of the variance: the ranking of the inputs is not known" in words


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
