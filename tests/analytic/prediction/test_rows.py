"""What a prediction says of its points as a whole, and the ends of an interval to first order."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.prediction.first_order import end_factors
from analytic.prediction.rows import Interval


def test_the_error_of_a_series_is_that_of_its_worst_end() -> None:
    ends = {"low": [2.0, -4.0, 0.0], "high": [5.0, 8.0, 3.0]}
    errors = {"low_error": [0.02, 0.4, 0.7], "high_error": [0.5, 0.08, 0.03]}
    series = Interval(median=np.ones(3), **{name: np.array(each) for name, each in (ends | errors).items()})
    assert series.largest_error == pytest.approx(0.1, rel=1e-12)
    assert replace(series, high_error=np.array([0.75, 0.08, 0.03])).largest_error == pytest.approx(0.15, rel=1e-12)
    assert series.ends == (series.low, series.high)


def test_independent_inputs_add_their_squares_at_the_end_that_they_move() -> None:
    """One moves both ends, one the upper end alone; what both ends of an input raise counts once."""
    base = np.array([2.0, 3.0])
    both = base * np.exp([[-0.3, -0.1], [0.3, 0.2]])
    up = base * np.exp([[0.4, 0.05], [0.1, 0.02]])
    expected = np.exp([[-0.3, -0.1], [0.5, np.hypot(0.2, 0.05)]])
    np.testing.assert_allclose(end_factors(base, [both, up]), expected, rtol=1e-12)
    np.testing.assert_allclose(end_factors(base, [both[::-1], up]), expected, rtol=1e-12)
    nothing = end_factors(np.array([0.0, 3.0]), [np.array([[0.0, 1.5], [1.0, 0.0]])])
    np.testing.assert_allclose(nothing, [[1.0, 0.5], [1.0, 1.0]], rtol=1e-12)
