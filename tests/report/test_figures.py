"""The plots by the points that are drawn, against a result made by hand: see `made` in conftest.py."""

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from fembearing.compare.validation import Validation
from fembearing.report.figures import convergence_figure


def line_of(axes: Axes, label: str) -> Line2D:
    (found,) = (line for line in axes.get_lines() if line.get_label() == label)
    return found


def check_points(line: Line2D, x: list[float], y: list[float]) -> None:
    np.testing.assert_allclose(np.asarray(line.get_xdata(), dtype=float), x, rtol=1e-12)
    np.testing.assert_allclose(np.asarray(line.get_ydata(), dtype=float), y, rtol=1e-10)  # differences of near values


@pytest.fixture(scope="module")
def panels(made: Validation) -> dict[str, Axes]:
    return {axes.get_title(): axes for axes in convergence_figure(made.to_json()).axes}


def test_meshes_with_an_order_are_drawn_by_their_distance_from_the_limit(panels: dict[str, Axes]) -> None:
    inner = line_of(panels["approach"], "ball on inner race")
    check_points(
        inner, [1200, 9500, 31000], [82.5 / 5.225, 16.5 / 5.225, 27.5 / 5.225]
    )  # 4.4, 5.06 and 5.5 against 5.225, %
    assert inner.get_linestyle() == "-"
    outer = line_of(panels["peak pressure"], "ball on outer race")
    check_points(outer, [1300, 8700, 29000], [15 / 1.6, 5 / 1.6, 2 / 1.6])


def test_meshes_without_an_order_are_drawn_by_their_distance_from_the_finest(panels: dict[str, Axes]) -> None:
    line = line_of(panels["stiffness"], "ball on inner race")
    check_points(line, [1200, 9500], [30, 10])  # 32.5 and 27.5 against 25
    assert line.get_linestyle() == "--"


def test_every_contact_is_in_every_panel(panels: dict[str, Axes]) -> None:
    del panels[""]  # of the legend
    assert set(panels) == {"approach", "semi-axis a", "semi-axis b", "peak pressure", "stiffness"}
    for axes in panels.values():
        assert len(axes.get_lines()) == 4
        assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
