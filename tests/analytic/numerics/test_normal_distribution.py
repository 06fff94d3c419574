"""The tail of the normal distribution in 60 digits, from far below to far above."""

import mpmath
import numpy as np
import pytest
from scipy.special import log_ndtr

from analytic.numerics.normal_distribution import FAR, log_upper_tail, mean_excess, mills_ratio

AROUND = FAR * (1 + np.array([-1e-9, 0.0, 1e-9]))
ABOVE = np.concatenate([[0.0], np.linspace(0.13, 14.0, 90), np.geomspace(1e-12, 1e7, 40), AROUND])


@pytest.mark.parametrize("t", ABOVE)
def test_above_the_mean_in_60_digits(t: float) -> None:
    with mpmath.workdps(60):
        at = mpmath.mpf(float(t))
        upper, density = mpmath.erfc(at / mpmath.sqrt(2)) / 2, mpmath.exp(-(at**2) / 2) / mpmath.sqrt(2 * mpmath.pi)
        ratio, excess, log_upper = upper / density, 1 - at * upper / density, mpmath.log(upper)
    np.testing.assert_allclose(mills_ratio(t), float(ratio), rtol=1e-15)  # some roundings
    np.testing.assert_allclose(mean_excess(t), float(excess), rtol=1e-13)  # the difference leaves 1/t^2, 0.01 at FAR
    np.testing.assert_allclose(log_upper_tail(t), float(log_upper), rtol=1e-15)


def test_below_the_mean() -> None:
    """By SciPy's own function; erfc of either loses t^2 roundings, some 1400 of them at 37."""
    below = -np.concatenate([np.linspace(1e-9, 37.0, 300), [50.0, 1e9]])
    found = [log_upper_tail(t) for t in below]
    np.testing.assert_allclose(found, log_ndtr(-below), rtol=1e-12)
