"""Interpolation in a table: exact for the polynomials that it is made of, and straight lines as NumPy draws them."""

import numpy as np
import pytest

from fembearing.formats.interpolation import CUBIC, LINEAR, interpolated

AXES = np.array([0.0, 0.3, 1.1, 2.0, 3.7, 4.1]), np.array([-2.0, 0.5, 0.9, 3.0]), np.array([7.0])


@pytest.mark.parametrize(("order", "degree"), [(LINEAR, 1), (CUBIC, 3)])
def test_a_polynomial_of_each_axis_comes_back(order: int, degree: int) -> None:
    rng = np.random.default_rng(7)
    first, second = (rng.normal(size=degree + 1) for _ in range(2))

    def law(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.polyval(first, x) * np.polyval(second, y)

    table = law(*np.meshgrid(*AXES[:2], indexing="ij"))[..., None]
    points = [rng.uniform(axis[0], axis[-1], 50) for axis in AXES]
    found = interpolated(AXES, table, points, order=order)
    np.testing.assert_allclose(found, law(points[0], points[1]), rtol=1e-9, atol=1e-9)  # rounding of products


def test_two_nodes_make_straight_lines_and_nodes_keep_their_value() -> None:
    values = np.array([3.0, -1.0, 2.2, 5.0, 4.0, 0.7])
    at = np.concatenate([np.linspace(0.0, 4.1, 37), AXES[0]])
    np.testing.assert_allclose(
        interpolated(AXES[:1], values, [at], order=LINEAR), np.interp(at, AXES[0], values), rtol=1e-13, atol=1e-14
    )
    np.testing.assert_allclose(interpolated(AXES[:1], values, [AXES[0]], order=CUBIC), values, rtol=1e-14)
