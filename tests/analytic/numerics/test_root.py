"""Many roots at once: exact ones, wrong slopes, flat pieces, none."""

import numpy as np
import pytest

from analytic.errors import ConvergenceError
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import Array

WORDS = Sought(problem="the test", unit="of x", remedy="Give a number.")
ROOTS = np.array([-3.7, -1e-9, 0.3, 2.0, 6.9])


def cubes(x: Array) -> tuple[Array, Array]:
    return (x - ROOTS) ** 3 + 0.1 * (x - ROOTS), 3 * (x - ROOTS) ** 2 + 0.1


@pytest.mark.parametrize("factor", [1.0, 0.7, -0.4, 0.0, np.nan, 1e-6])
def test_roots_whatever_the_slope(factor: float) -> None:
    calls = []

    def rising(x: Array) -> tuple[Array, Array]:
        calls.append(x)
        value, slope = cubes(x)
        return value, slope * factor

    start, ends = np.full(5, 5.5), (np.full(5, -9.0), np.full(5, 9.0))
    roots = bracketed_root(rising, start=start, low=ends[0], high=ends[1], relative=1e-13, absolute=1e-15, sought=WORDS)
    np.testing.assert_allclose(roots, ROOTS, rtol=1e-12, atol=1e-14)  # some steps beyond both tolerances
    assert all(np.all((x >= -9) & (x <= 9)) for x in calls)
    assert len(calls) < (25 if factor == 1 else 70)  # steps from afar shrink by 2/3; bisection takes 55


def test_values_of_zero_end_the_search_and_ends_without_a_change_of_sign_are_reached() -> None:
    zero = np.zeros(2)

    def step(x: Array) -> tuple[Array, Array]:
        return np.where(np.abs(x - 0.7) < 0.01, 0.0, np.sign(x - 0.7)), np.ones(2)

    roots = bracketed_root(step, start=zero + 0.2, low=zero, high=zero + 1, relative=1e-15, sought=WORDS)
    np.testing.assert_allclose(roots, 0.7, atol=0.01)
    always = bracketed_root(
        lambda x: (np.array([1.0, -1.0]), np.full_like(x, 1e-3)),
        start=zero + 0.2,
        low=zero,
        high=zero + 1,
        relative=1e-12,
        absolute=1e-12,
        sought=WORDS,
    )
    np.testing.assert_allclose(always, [0, 1], atol=1e-11)


def test_a_value_that_is_not_a_number_is_reported() -> None:
    with pytest.raises(ConvergenceError, match=r"the test did not converge in 200 iterations.*Give a number"):
        bracketed_root(
            lambda x: (x * np.nan, x),
            start=np.array([0.2]),
            low=np.array([0.0]),
            high=np.array([1.0]),
            relative=0.0,
            sought=WORDS,
        )
