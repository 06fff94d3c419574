"""Interpolation in a table: exact for products of straight lines, and along one axis as NumPy has it."""

import numpy as np

from fembearing.formats.interpolation import interpolated

AXES = np.array([0.0, 0.3, 1.1, 2.0, 3.7, 4.1]), np.array([-2.0, 0.5, 0.9, 3.0]), np.array([7.0])


def test_a_product_of_straight_lines_comes_back() -> None:
    def law(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return (2.3 - 0.7 * x) * (0.4 + 1.9 * y)

    rng = np.random.default_rng(7)
    table = law(*np.meshgrid(*AXES[:2], indexing="ij"))[..., None]
    points = [rng.uniform(axis[0], axis[-1], 50) for axis in AXES]
    np.testing.assert_allclose(interpolated(AXES, table, points), law(*points[:2]), rtol=1e-12, atol=1e-13)  # rounding


def test_one_axis_is_that_of_numpy() -> None:
    values = np.array([3.0, -1.0, 2.2, 5.0, 4.0, 0.7])
    at = np.concatenate([np.linspace(0.0, 4.1, 37), AXES[0]])
    right = np.interp(at, AXES[0], values)
    np.testing.assert_allclose(interpolated(AXES[:1], values, [at]), right, rtol=1e-13, atol=1e-14)  # rounding
