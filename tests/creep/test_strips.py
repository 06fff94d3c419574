"""Strips over an ellipse, and where a row of constant tractions begins and ends."""

import numpy as np
from scipy.integrate import dblquad
from scipy.linalg import toeplitz

from fembearing.creep.strips import LEAD, TRAIL, ellipse_strips, hertz_pressure
from tests.creep.bodies import LOAD, ROLLING, TRANSVERSE, race_strips


def test_a_row_of_constant_tractions_sticks_over_its_length_but_for_the_ends() -> None:
    """Plane strain: a stuck row has t = sqrt(ahead/behind), so force and centroid give both ends."""
    cells = 320
    steps = np.arange(-cells, cells + 1.0)
    sides = steps[:, None] + np.array([-0.5, 0.5])
    logs = sides * np.log(np.abs(sides))
    moved = logs[:, 0] - logs[:, 1]  # displacement by one rectangle, but for a factor and a constant
    slip = moved[:-1] - moved[1:]
    middle = cells
    matrix = toeplitz(np.append(slip[middle:], 0.0)[:cells], slip[middle - np.arange(cells)])
    traction = np.linalg.solve(matrix, np.ones(cells))
    length, centroid = 2 * traction.sum(), np.average(np.arange(cells) + 0.5, weights=traction)
    rear = centroid - length / 4
    # Rows of 160 and 640 differ by 1e-5.
    np.testing.assert_allclose([rear, rear + length - cells], [TRAIL, LEAD], atol=2e-5)


def test_rectangles_carry_the_load_and_its_second_moments() -> None:
    strips = race_strips(31, 17, sides=(-3.1e-4, 4.2e-4))
    pressure = hertz_pressure(strips, load=LOAD)
    weights = pressure * strips.area
    np.testing.assert_allclose(weights.sum(), LOAD, rtol=1e-13)  # round-off
    # Hertz: int x^2 p dA = Q a^2/5. Of the size of a rectangle squared, 1/31^2 and 1/17^2.
    np.testing.assert_allclose(np.sum(weights * strips.x**2), LOAD * ROLLING**2 / 5, rtol=1.5e-2)
    np.testing.assert_allclose(np.sum(weights * strips.y**2), LOAD * TRANSVERSE**2 / 5, rtol=5e-3)


def test_a_strip_carries_its_part_of_the_load() -> None:
    strips = race_strips(9, 6)
    weights = np.sum(hertz_pressure(strips, load=LOAD) * strips.area, axis=1)
    peak = 1.5 * LOAD / (np.pi * ROLLING * TRANSVERSE)

    def pressure(x: float, y: float) -> float:
        return peak * np.sqrt(max(1 - (x / ROLLING) ** 2 - (y / TRANSVERSE) ** 2, 0.0))

    low, high = strips.middle[2] - strips.width[2] / 2, strips.middle[2] + strips.width[2] / 2
    expected, _ = dblquad(pressure, low, high, -ROLLING, ROLLING, epsrel=1e-6)
    np.testing.assert_allclose(weights[2], expected, rtol=1e-5)  # of the quadrature


def test_two_strips_meet_where_slip_turns_round_inside_the_ellipse() -> None:
    sides = (-1.7e-4, 2.9e-4, 1.3 * TRANSVERSE)
    strips = ellipse_strips(semi_axis_rolling=ROLLING, semi_axis_transverse=TRANSVERSE, count=13, cells=4, sides=sides)
    borders = strips.middle + strips.width / 2
    for side in sides[:2]:
        assert np.min(np.abs(borders - side)) < 1e-12  # round-off
    np.testing.assert_allclose(strips.width.sum(), 2 * TRANSVERSE, rtol=1e-12)
    assert strips.middle.size == 13
    assert np.all(strips.width > 0)


def test_a_strip_reaches_as_far_as_the_root_mean_square_of_its_ellipse() -> None:
    strips = race_strips(7, 3)
    for number in (0, 3, 5):
        y = strips.middle[number] + strips.width[number] * (np.arange(2000) + 0.5 - 1000) / 2000
        square = ROLLING**2 * np.mean(1 - (y / TRANSVERSE) ** 2)
        np.testing.assert_allclose([-strips.rear[number], strips.front[number]], square**0.5, rtol=1e-6)  # 2000 steps
