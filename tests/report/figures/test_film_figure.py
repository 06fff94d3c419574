"""Pressure and film of a lubricated contact: what the maps and the line of rolling show, in either system of units."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.contour import ContourSet
from matplotlib.patches import Ellipse

from fembearing.quantities import INCH_POUND, METRIC, Units
from fembearing.report.figures.film import LEVELS, THICKEST, film_figure
from tests.report.figures.figure_reader import require_legible

A, B, PEAK = 0.13e-3, 0.71e-3, 1.7e9  # m, m, Pa
CENTRAL, THINNEST = 0.31e-6, 0.19e-6  # m


def solved() -> Any:
    """Hertz's pressure, and a film that grows outside of its ellipse."""
    x, y = np.linspace(-2.3 * A, 1.7 * A, 41), np.linspace(0.02 * B, 1.8 * B, 19)
    outside = (x[:, None] / A) ** 2 + (y[None, :] / B) ** 2
    contact = SimpleNamespace(semi_axes=(A, B), peak_pressure=PEAK)
    solution = SimpleNamespace(
        x=x, y=y, contact=contact, pressure=PEAK * np.sqrt(np.clip(1 - outside, 0, None)), film=CENTRAL * (1 + outside)
    )
    films = {"central_film": CENTRAL, "minimum_film": THINNEST}
    found = {name: SimpleNamespace(reference=value) for name, value in films.items()}
    numbers = SimpleNamespace(quantities=found)
    return SimpleNamespace(solution=solution, numbers=numbers)


@pytest.mark.parametrize("units", [METRIC, INCH_POUND], ids=["metric", "inch"])
def test_the_maps_show_the_ellipse_of_hertz_and_its_surroundings(units: Units) -> None:
    figure = film_figure(solved(), units)
    maps = [axes for axes in figure.axes if any(isinstance(patch, Ellipse) for patch in axes.patches)]
    assert len(maps) == 2
    ends = [
        (0.0, PEAK * units.pressure.factor),
        (0.9 * THINNEST * units.small_length.factor, THICKEST * CENTRAL * units.small_length.factor),
    ]
    for panel, (least, most) in zip(maps, ends, strict=True):
        (colours,) = (part for part in panel.get_children() if isinstance(part, ContourSet))
        np.testing.assert_allclose(
            np.asarray(colours.levels)[[0, -1]], [least, most], rtol=0.01
        )  # the first row is off the centre
    require_legible(figure)
    for panel in maps:
        (ellipse,) = (patch for patch in panel.patches if isinstance(patch, Ellipse))
        assert (ellipse.width, ellipse.height) == pytest.approx((2, 2 * B * units.length.factor))
        for (low, high), semi_axis in ((panel.get_xlim(), 1.0), (panel.get_ylim(), B * units.length.factor)):
            assert -low == pytest.approx(high)
            assert 1.2 * semi_axis < high < 1.8 * semi_axis  # the horseshoe is seen, and the map is not empty
        assert units.length.name in panel.get_ylabel()


@pytest.mark.parametrize("units", [METRIC, INCH_POUND], ids=["metric", "inch"])
def test_pressure_and_film_along_rolling_are_within_their_scales(units: Units) -> None:
    figure = film_figure(solved(), units)

    def panel_of(label: str) -> Axes:
        return next(each for each in figure.axes if label in [line.get_label() for line in each.get_lines()])

    for label, highest, unit in (("pressure", PEAK, units.pressure), ("film", CENTRAL, units.small_length)):
        panel = panel_of(label)
        line = next(line for line in panel.get_lines() if line.get_label() == label)
        values = np.asarray(line.get_ydata(), dtype=float)
        shown = np.abs(np.asarray(line.get_xdata(), dtype=float)) < 0.9
        assert panel.get_ylim()[0] == 0
        assert values[shown].max() < panel.get_ylim()[1]
        middle = values[np.argmin(np.abs(np.asarray(line.get_xdata(), dtype=float)))]
        assert middle == pytest.approx(highest * unit.factor, rel=0.01)  # the first row is 0.02 b beside the centre
        assert unit.name in panel.get_ylabel()


def test_maps_have_so_many_even_steps_of_colour() -> None:
    for panel in film_figure(solved()).axes:
        for colours in (part for part in panel.get_children() if isinstance(part, ContourSet)):
            levels = np.asarray(colours.levels)
            assert levels.size == LEVELS + 1
            np.testing.assert_allclose(np.diff(levels), levels[1] - levels[0], rtol=1e-9)


def test_lines_along_rolling_are_over_semi_axes() -> None:
    figure = film_figure(solved())
    lines = {
        str(line.get_label()): np.asarray(line.get_xydata(), dtype=float)
        for axes in figure.axes
        for line in axes.get_lines()
    }
    for name in ("pressure", "film"):
        np.testing.assert_allclose(lines[name][[0, -1], 0], [-2.3, 1.7], rtol=1e-12)
    hertz = lines["Hertz's pressure"]
    np.testing.assert_allclose(hertz[:, 0] ** 2 + (hertz[:, 1] / (1e-9 * PEAK)) ** 2, 1, rtol=1e-9)
    assert (hertz[0, 0], hertz[-1, 0]) == (-1, 1)
    panel = next(axes for axes in figure.axes if "pressure" in [line.get_label() for line in axes.get_lines()])
    assert panel.get_xlim()[0] < -1.5 < 1 < panel.get_xlim()[1]
    assert 1e-9 * PEAK < panel.get_ylim()[1] < 2e-9 * PEAK
    other = next(axes for axes in figure.axes if "film" in [line.get_label() for line in axes.get_lines()])
    assert 2e6 * CENTRAL < other.get_ylim()[1] < 6e6 * CENTRAL  # below the pressure, which has a scale of its own
