"""What a prediction says of its points as a whole, and the ends of an interval to first order."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.prediction.first_order import end_factors
from analytic.prediction.rows import Interval, PredictedPoint, PredictionRows, SobolIndices, largest_error
from analytic.prediction.sampling import Samples
from analytic.prediction.spreads import UncertainInput

INPUT = UncertainInput(key="lubricant.viscosity", kind="input", value=0.043, unit="Pa*s", deviation=0.003, source="so")


def interval(low: float = 2.0, high: float = 5.0, **errors: float) -> Interval[float]:
    return Interval(low=low, median=3.0, high=high, **({"low_error": 0.01, "high_error": 0.02} | errors))


def point(speed: float, nominal: float, total: tuple[float, ...] = (0.5, 0.3, 0.2), **changed: Any) -> PredictedPoint:
    known: dict[str, Any] = {
        "total": interval(),
        "parts": {},
        "made_of": {"input": (2.0, 5.0), "input.other": (2.1, 4.0)},
        "indices": SobolIndices(first=total, total=total, first_error=total, total_error=total),
        "explained": 0.9,
    }
    return PredictedPoint(
        inner_speed=speed, axial_load=310.0, radial_load=0.0, moment=0.0, nominal=nominal, **(known | changed)
    )


def rows(*points: PredictedPoint, **changed: Any) -> PredictionRows:
    known: dict[str, Any] = {
        "covered": 0.95,
        "inputs": (INPUT,) * 3,
        "not_varied": (),
        "samples": 256,
        "failed": 0,
        "reasons": (),
        "seed": 3,
        "seconds": 1.5,
        "evaluation_seconds": 2.5,
    }
    return PredictionRows(points=points, **(known | changed))


def test_the_ends_are_the_slowest_and_the_fastest_point() -> None:
    slow, fast, other = point(-2.0, 3.0), point(-90.0, 7.0), point(40.0, 5.0)
    lost = point(900.0, np.nan)
    assert rows(other, fast, slow, lost).ends == [slow, fast]
    twin = point(2.0, 4.0)
    assert rows(slow, twin, other).ends == [slow, other]  # of equal ones the first
    assert rows(slow, point(50.0, 3.0)).ends == [slow]
    assert rows(slow).ends == [slow]


def test_inputs_are_ranked_by_their_largest_index_at_the_ends() -> None:
    slow, fast = point(2.0, 3.0, (0.5, 0.3, 0.1)), point(90.0, 7.0, (0.1, 0.2, 0.6))
    middle = point(40.0, 5.0, (0.0, 0.9, 0.0))
    assert rows(slow, middle, fast).ranked == [2, 0, 1]


def test_the_largest_error_is_relative_to_its_end() -> None:
    assert rows(point(2.0, 3.0)).largest_error == pytest.approx(0.01 / 2.0)
    high = point(2.0, 3.0, total=(1.0, 0.0, 0.0))
    assert rows(replace(high, total=interval(high_error=0.2))).largest_error == pytest.approx(0.2 / 5.0)
    below = replace(high, total=interval(low=-2.0, low_error=0.3))
    assert rows(high, below).largest_error == pytest.approx(0.15)
    for end in (0.0, np.inf, np.nan):
        none = replace(high, total=interval(low=end, high=end, low_error=0.3, high_error=0.3))
        assert rows(none).largest_error == 0
    assert rows(none, high).largest_error == pytest.approx(0.005)


def test_what_is_explained_is_the_least_share_and_never_negative() -> None:
    points = [point(2.0, 3.0, explained=share) for share in (0.9, 0.7, np.nan)]
    assert rows(*points).explained == 0.7
    assert rows(*points, point(2.0, 3.0, explained=-0.4)).explained == 0


def test_failures_are_told_with_their_reasons() -> None:
    assert rows(point(2.0, 3.0)).failures == ""
    failed = rows(point(2.0, 3.0), failed=2, reasons=("no thrust (2 times)",))
    assert failed.failures == "2 of 256 samples have no torque and are left out: no thrust (2 times)."


def test_rows_that_do_not_belong_together_are_refused() -> None:
    with pytest.raises(ValueError, match="indices of other than its 2 inputs"):
        rows(point(2.0, 3.0), inputs=(INPUT,) * 2)
    mixed = SobolIndices(first=(0.1, 0.2, 0.3), total=(0.1, 0.2), first_error=(0.1, 0.2, 0.3), total_error=(0.1, 0.2))
    with pytest.raises(ValueError, match="indices of other"):
        rows(point(2.0, 3.0, indices=mixed))
    with pytest.raises(ValueError, match="unknown parts: guess"):
        rows(point(2.0, 3.0, made_of={"guess": (1.0, 2.0)}))
    with pytest.raises(ValueError, match="other parts at other points"):
        rows(point(2.0, 3.0), point(3.0, 4.0, made_of={"input": (1.0, 2.0)}))


def test_the_error_of_a_series_is_that_of_its_worst_end() -> None:
    ends = {"low": [2.0, -4.0, 0.0], "high": [5.0, 8.0, 3.0]}
    errors = {"low_error": [0.02, 0.4, 0.7], "high_error": [0.5, 0.08, 0.03]}
    series = Interval(median=np.ones(3), **{name: np.array(each) for name, each in (ends | errors).items()})
    assert largest_error(series) == pytest.approx(0.1, rel=1e-12)
    assert largest_error(replace(series, high_error=np.array([0.75, 0.08, 0.03]))) == pytest.approx(0.15, rel=1e-12)
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


def test_samples_together_have_both() -> None:
    one = Samples(scores=np.ones((3, 2)), torque=np.ones((3, 1, 4)), count=5, reasons=("a", "b"), seconds=1.5)
    other = Samples(scores=np.zeros((2, 2)), torque=np.zeros((2, 1, 4)), count=2, reasons=("b", "c"), seconds=2.0)
    both = one.together(other)
    assert (one.failed, other.failed, both.failed) == (2, 0, 2)
    assert (both.scores.shape, both.torque.shape, both.count) == ((5, 2), (5, 1, 4), 7)
    assert (both.reasons, both.seconds) == (("a", "b", "c"), 3.5)
