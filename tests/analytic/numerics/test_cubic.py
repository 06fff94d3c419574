"""Cubic splines as tables against SciPy's own, within the knots and beyond."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline, PchipInterpolator

from analytic.numerics.cubic import cubic_at, monotone_cubic, smooth_cubic, together

X = np.cumsum(np.random.default_rng(5).uniform(0.03, 1.9, 41)) - 7.0
ANYWHERE = np.sort(np.concatenate([np.linspace(X[0] - 4, X[-1] + 4, 997), X]))


def test_a_smooth_spline_is_that_of_scipy() -> None:
    y = np.sin(1.3 * X) + 0.2 * X
    whole = CubicSpline(X, y)
    cubics, (_, pieces, _) = together(smooth_cubic(X, -y), smooth_cubic(X, y), smooth_cubic(X[:9], X[:9] ** 2))
    found = np.array([cubic_at(cubics, pieces, x) for x in ANYWHERE]).T
    np.testing.assert_allclose(found[0], whole(ANYWHERE), rtol=1e-12, atol=1e-12)  # round-off
    np.testing.assert_allclose(found[1], whole(ANYWHERE, 1), rtol=1e-11, atol=1e-11)
    assert np.isnan(cubic_at(cubics, pieces, np.nan)).all()


def test_a_monotone_spline_is_that_of_scipy_but_for_its_ends() -> None:
    y = np.cumsum(np.random.default_rng(8).uniform(-0.4, 1.0, 41))  # falls here and there, so that slopes are 0
    whole = PchipInterpolator(X, y)
    cubics, (pieces,) = together(monotone_cubic(X, y))
    inside = np.linspace(X[0], X[-1], 997)
    found = np.array([cubic_at(cubics, pieces, x) for x in inside]).T
    np.testing.assert_allclose(found[0], whole(inside), rtol=1e-12, atol=1e-12)  # round-off
    np.testing.assert_allclose(found[1], whole(inside, 1), rtol=1e-11, atol=1e-11)


@pytest.mark.parametrize(("y", "factor"), [([0.0, 0.2, 7.0, 7.4], 1 / 3), ([0.0, 0.2, -7.0, -6.6], 3.0)])
def test_an_end_slope_is_a_third_to_three_times_that_of_the_last_piece(y: list[float], factor: float) -> None:
    x = np.array([0.3, 1.1, 2.6, 3.9])  # parabolas through three points are steeper, or fall where the piece rises
    cubics, (pieces,) = together(monotone_cubic(x, np.array(y)))
    ends = cubic_at(cubics, pieces, x[0])[1], cubic_at(cubics, pieces, x[-1])[1]
    np.testing.assert_allclose(ends, [factor * 0.2 / 0.8, factor * 0.4 / 1.3], rtol=1e-12)
