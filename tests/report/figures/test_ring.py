"""Loads and angles of all balls: every ball is to be seen, and angles that are alike look alike."""

from typing import Any

import numpy as np
import pytest

from fembearing.report.figures.ring import LEAST_SPAN, ring_plot
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import as_document, require_legible

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
    assert high - low >= LEAST_SPAN * (1 - 1e-12)  # round-off


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
