import numpy as np
import pytest
from mpmath import mp

from analytic.numerics.exponentials import exponential, roughly_log


@pytest.mark.parametrize("y", [0.0, 3e-9, -0.2, 0.34657, 0.3466, 5.1, -41.7, 300.3, -690.2, 699.4])
def test_the_exponential_in_40_digits(y: float) -> None:
    with mp.workdps(40):
        exact = mp.exp(mp.mpf(y))
        assert float(abs(exponential(y) - exact) / exact) < 1e-14  # roundings of the series and of the reduction


@pytest.mark.parametrize("x", [1e-300, 3e-9, 0.7, 1.0, 1.3, 1.999, 2.0, 12.7, 4.1e17, 1e300])
def test_the_rough_logarithm_is_near(x: float) -> None:
    assert roughly_log(x) == pytest.approx(np.log(x), rel=0, abs=0.0062)  # the parabola's largest distance


def test_the_rough_logarithm_has_no_step_at_powers_of_two() -> None:
    below, above = roughly_log(np.nextafter(8.0, 0.0)), roughly_log(8.0)
    assert above == pytest.approx(below, rel=1e-13)
