"""The tornado by its bars, of a document made by hand."""

import json
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.patches import Rectangle
from pydantic import TypeAdapter

from analytic.units import METRIC
from fembearing.check.sensitivity import Sensitivity
from fembearing.report.figures.sensitivity import sensitivity_plot
from fembearing.report.report import Report
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import require_legible


def given(name: str, unit: str, ends: tuple[float, float, float], **changes: Any) -> dict[str, Any]:
    low, value, high = ends
    return {
        "name": name,
        "unit": unit,
        "low": low,
        "value": value,
        "high": high,
        "source": "a table",
        "refused": [],
    } | changes


def document_of(outputs: list[dict[str, Any]], inputs: list[dict[str, Any]]) -> Report:
    """A document with nothing but its sensitivity."""
    found = TypeAdapter(Sensitivity).validate_json(json.dumps({"outputs": outputs, "inputs": inputs}))
    return cast(Report, SimpleNamespace(sensitivity=found, units=METRIC))


@pytest.fixture
def inputs() -> list[dict[str, Any]]:
    return [
        given("bearing.modulus", "Pa", (180e9, 200e9, 230e9), change_low=[0.07, 0.05], change_high=[-0.04, -0.03]),
        given("bearing.roughness", "m", (0.2e-6, 0.3e-6, 0.5e-6), change_low=[0.01, -0.02], change_high=[0.03, 0.015]),
        given(
            "bearing.groove",
            "1",
            (0.498, 0.503, 0.508),
            change_low=None,
            change_high=[0.02, 0.025],
            refused=["0.498: no"],
        ),
        given("bearing.shear", "1", (0.05, 0.06, 0.07), change_low=[0.0, 0.0], change_high=[1e-9, 0.0]),
    ]


@pytest.fixture
def document(inputs: list[dict[str, Any]]) -> Report:
    outputs = [
        {
            "quantity": "total_torque",
            "pair": None,
            "inner_speed": speed * np.pi / 30,
            "axial_load": 700.0,
            "radial_load": 0.0,
            "moment": 0.0,
            "value": value,
        }
        for speed, value in ((100, 21.5e-3), (900, 44e-3))
    ]
    return document_of(outputs, inputs)


def bars_of(panel: Axes) -> list[tuple[float, float]]:
    """Row and length of each bar."""
    bars = [patch for patch in panel.patches if isinstance(patch, Rectangle)]
    return [(round(bar.get_y() + bar.get_height() / 2, 2), bar.get_width()) for bar in bars]


def test_bars_reach_to_the_changes_in_per_cent(document: Report) -> None:
    figure, caption = sensitivity_plot(document)
    slow, fast = present(figure).axes
    # Row by row, low before high; two on one side stand one above the other.
    np.testing.assert_allclose(bars_of(slow), [(0, 7), (0, -4), (0.82, 1), (1.18, 3), (2, 2)], atol=1e-12)
    np.testing.assert_allclose(bars_of(fast), [(0, 5), (0, -3), (1, -2), (1, 1.5), (2, 2.5)], atol=1e-12)
    assert [slow.get_title(), fast.get_title()] == [
        "100 rpm, 700 N axial:\n21.5 N mm",
        "900 rpm, 700 N axial:\n44 N mm",
    ]
    assert fast.get_xlabel() == "change of the total torque, %"
    assert [text.get_text() for text in slow.get_yticklabels()] == [
        "modulus, 200 GPa",
        "roughness, 0.3 um",
        "groove, 0.503",
    ]
    assert [text.get_text() for text in slow.texts] == ["180 GPa", "230 GPa", "0.2 um", "0.5 um", "0.508"]
    assert "shear" in caption  # moves nothing
    require_legible(present(figure))
    assert "groove, 0.498: no" in caption


def test_pressures_name_their_race(inputs: list[dict[str, Any]]) -> None:
    nowhere = dict.fromkeys(("inner_speed", "axial_load", "radial_load", "moment"))
    output = {"quantity": "peak_pressure", "pair": "outer", "value": 1.67e9} | nowhere
    one = [each | {name: each[name] and each[name][:1] for name in ("change_low", "change_high")} for each in inputs]
    figure, _ = sensitivity_plot(document_of([output], one))
    (panel,) = present(figure).axes
    assert panel.get_title() == "ball on outer race: 1.67 GPa"
    assert panel.get_xlabel() == "change of the peak pressure, %"


def test_a_figure_grows_with_its_inputs_and_draws_at_most_twelve(document: Report) -> None:
    usual = document.sensitivity
    assert usual is not None
    heights = []
    for count, drawn in ((3, 3), (12, 12), (14, 12)):
        inputs = tuple(
            replace(usual.inputs[0], name=f"bearing.input_{number}", change_low=(-0.2 / (number + 1),) * 2)
            for number in range(count)
        )
        many = cast(Report, SimpleNamespace(sensitivity=replace(usual, inputs=inputs), units=METRIC))
        figure, caption = sensitivity_plot(many)
        panel = present(figure).axes[0]
        assert len(panel.get_yticks()) == drawn
        low, high = panel.get_ylim()
        assert low - (drawn - 1) == pytest.approx(-high, rel=1e-9)  # as much room above as below
        assert low > high  # the first one on top
        heights.append(present(figure).get_figheight())
        assert ("Smaller changes: input 12, input 13." in caption) == (count == 14)
    assert heights[1] - heights[0] == pytest.approx(9 * 0.30, rel=1e-9)
    assert heights[2] == heights[1]


def test_a_change_of_less_than_a_millionth_is_named_alone(document: Report) -> None:
    usual = document.sensitivity
    assert usual is not None
    for swing, drawn in ((1.1e-6, True), (0.9e-6, False)):
        still = replace(usual.inputs[0], name="bearing.still", change_low=(swing, 0.0), change_high=(0.0, -swing))
        changed = cast(
            Report, SimpleNamespace(sensitivity=replace(usual, inputs=(usual.inputs[0], still)), units=METRIC)
        )
        figure, caption = sensitivity_plot(changed)
        names = [text.get_text().partition(",")[0] for text in present(figure).axes[0].get_yticklabels()]
        assert ("still" in names) == drawn
        assert ("Changes below 1e-4 %: still." in caption) != drawn


def test_a_radial_load_stands_with_its_point(inputs: list[dict[str, Any]]) -> None:
    point = {"quantity": "total_torque", "pair": None, "inner_speed": 31.0, "axial_load": 0.0, "moment": 0.0}
    outputs = [point | {"radial_load": 1500.0, "value": 21.5e-3}, point | {"radial_load": 2500.0, "value": 33e-3}]
    figure, _ = sensitivity_plot(document_of(outputs, inputs))
    assert "0 N axial, 1500 N radial:\n21.5 N mm" in present(figure).axes[0].get_title()
