"""The mean gap of truncated surfaces: what overlaps is cut off, and the rest keeps its shape.

Two rough surfaces whose mean planes are d apart leave the mean gap <max(d - z, 0)>, where z are the heights of both
together, Gaussian with the standard deviation sigma. The oil that the inlet lets in fills this gap; d may be negative.
The pressure at d is that of independent summits (`analytic.surface.asperity`).
Source: the average gap of [Patir1978].
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from analytic.numerics.cubic import Pieces, monotone_cubic
from analytic.numerics.elements import formula
from analytic.numerics.normal_distribution import LOG_PEAK, mean_excess, mills_ratio
from analytic.scene import Array
from analytic.surface.asperity import SummitNumbers, separation_of, summit_area, tabulated_asperities
from analytic.surface.moments import Summits

INVERSE = -np.sinh(np.linspace(np.arcsinh(700.0), -np.arcsinh(5.0), 60))  # ln p over the tables' scale


class TruncatedNumbers(NamedTuple):
    """The gap law of truncated surfaces whose summits deform independently; the splines are in an array beside."""

    summits: SummitNumbers
    deviation: float  # sigma, of the heights of both surfaces, m
    inverse: Pieces  # ln p over ln of the mean gap, roughly


@formula
def log_mean_gap(separation: float) -> tuple[float, float]:
    """ln[phi(x) + x Phi(x)] and its derivative, for any finite x; phi, Phi : normal density and distribution.

    separation : x = d/sigma, of the mean planes. The result is ln of <max(x - z, 0)> for a standard normal z, in
    logarithms throughout: the gap itself falls below the smallest number at x = -38.
    """
    x = separation
    if x < 0.0:  # both divided by phi
        excess = mean_excess(-x)
        return np.log(excess) + LOG_PEAK - x * x / 2.0, mills_ratio(-x) / excess
    density = np.exp(LOG_PEAK - x * x / 2.0)
    below = 1.0 - density * mills_ratio(x)
    gap = density + x * below
    return np.log(gap), below / gap


@formula
def truncated_log_gap(cubics: Array, law: TruncatedNumbers, log_pressure: float) -> tuple[float, float]:
    """ln of the mean gap in m, and its derivative by ln p; log_pressure : ln of the asperities' pressure in Pa."""
    separation, slope = separation_of(cubics, law.summits, log_pressure)
    log_gap, steepness = log_mean_gap(separation / law.deviation)
    return np.log(law.deviation) + log_gap, steepness * slope / law.deviation


@formula
def truncated_area(cubics: Array, law: TruncatedNumbers, log_pressure: float) -> float:
    """Real over nominal area, 0 to 1."""
    return summit_area(cubics, law.summits, separation_of(cubics, law.summits, log_pressure)[0])


@lru_cache(maxsize=64)
def truncated_law(
    *, summits: Summits, modulus: float, hardness: float, deviation: float
) -> tuple[Array, TruncatedNumbers]:
    """Splines, (rows, 5), and numbers of a law; the pressures of the inverse are some that the law itself gives.

    deviation : sigma, m; the others and errors as `tabulated_asperities`
    """
    cubics, table = tabulated_asperities(summits=summits, modulus=modulus, hardness=hardness)
    numbers = TruncatedNumbers(table, deviation, Pieces(len(cubics), len(cubics) + INVERSE.size - 1))
    log_pressure = table.log_scale + INVERSE
    log_gap, _ = truncated_log_gap(cubics, numbers, log_pressure)
    return np.concatenate([cubics, monotone_cubic(log_gap[::-1], log_pressure[::-1])]), numbers
