"""The tail of the standard normal distribution, compiled; numbers in and out.

phi and Q are the density and the share above t. Near t = 0 they follow from erfc; far above, from the series in 1/t^2
[DLMF] 7.12.1, where a difference would cancel.
"""

from math import erfc

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.elements import formula

FAR = 10.0  # from here on the terms of the series fall below round-off
TERMS = 22
LOG_PEAK = -0.5 * np.log(2 * np.pi)  # ln phi(0)


@compiled
def _left_by_series(t: float) -> float:
    """1/t^2 - 3/t^4 + 15/t^6 - ..."""
    inverse, rest = 1.0 / (t * t), 1.0
    for n in range(TERMS, 0, -1):
        rest = 1.0 - (2 * n + 1) * inverse * rest
    return inverse * rest


@compiled
def mills_ratio(t: float) -> float:
    """Q(t)/phi(t), Mills' ratio, at t >= 0."""
    if t > FAR:
        return (1.0 - _left_by_series(t)) / t
    x = t / np.sqrt(2.0)
    high = np.floor(16.0 * x) / 16.0  # its square is exact: that of x would lose digits
    return np.sqrt(np.pi / 2) * np.exp(high * high) * np.exp((x - high) * (x + high)) * erfc(x)


@compiled
def mean_excess(t: float) -> float:
    """1 - t Q(t)/phi(t) at t >= 0: the mean of max(z - t, 0) over phi(t), with z normally distributed."""
    return _left_by_series(t) if t > FAR else 1.0 - t * mills_ratio(t)


@formula
def log_upper_tail(t: float) -> float:
    """ln Q(t) for any t."""
    if t < 0.0:
        return np.log1p(-erfc(-t / np.sqrt(2.0)) / 2.0)
    return LOG_PEAK - t * t / 2.0 + np.log(mills_ratio(t))
