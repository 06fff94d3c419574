"""The mean gap of truncated surfaces: what overlaps is cut off, and the rest keeps its shape.

Two rough surfaces whose mean planes are d apart leave the mean gap <max(d - z, 0)>, where z are the heights of both
together, Gaussian with the standard deviation sigma. The oil that the inlet lets in fills this gap; d may be negative.
The pressure at d is that of independent summits (`analytic.surface.asperity`).
Source: the average gap of [Patir1978].
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.numerics.compilation import compiled
from analytic.numerics.cubic import Pieces, monotone_cubic
from analytic.numerics.elements import mapped
from analytic.numerics.normal_distribution import LOG_PEAK, mean_excess, mills_ratio
from analytic.scene import Array
from analytic.surface.asperity_table import AsperityTable, SummitNumbers, separation_of, summit_area

INVERSE = -np.sinh(np.linspace(np.arcsinh(700.0), -np.arcsinh(5.0), 60))  # ln p over the tables' scale


class TruncatedNumbers(NamedTuple):
    """A `TruncatedGap` in numbers, for compiled formulas; the splines are in its cubics."""

    summits: SummitNumbers
    deviation: float  # sigma, m
    inverse: Pieces  # ln p over ln of the mean gap, roughly


@compiled
def log_gap_at(separation: float) -> tuple[float, float]:
    """ln[phi(x) + x Phi(x)] and its derivative, at x = d/sigma; phi, Phi : normal density and distribution."""
    x = separation
    if x < 0.0:  # both divided by phi
        excess = mean_excess(-x)
        return np.log(excess) + LOG_PEAK - x * x / 2.0, mills_ratio(-x) / excess
    density = np.exp(LOG_PEAK - x * x / 2.0)
    below = 1.0 - density * mills_ratio(x)
    gap = density + x * below
    return np.log(gap), below / gap


@compiled
def truncated_log_gap(cubics: Array, law: TruncatedNumbers, log_pressure: float) -> tuple[float, float]:
    """ln of the mean gap in m, and its derivative by ln p; log_pressure : ln of the asperities' pressure in Pa."""
    separation, slope = separation_of(cubics, law.summits, log_pressure)
    log_gap, steepness = log_gap_at(separation / law.deviation)
    return np.log(law.deviation) + log_gap, steepness * slope / law.deviation


@compiled
def truncated_area(cubics: Array, law: TruncatedNumbers, log_pressure: float) -> float:
    """Real over nominal area, 0 to 1."""
    return summit_area(cubics, law.summits, separation_of(cubics, law.summits, log_pressure)[0])


@dataclass(frozen=True, kw_only=True, eq=False)
class TruncatedGap:
    """The gap law of truncated surfaces whose summits deform independently."""

    asperities: AsperityTable
    deviation: float  # sigma, of the heights of both surfaces, m

    @cached_property
    def splines(self) -> tuple[Array, TruncatedNumbers]:
        """Cubics and numbers; the pressures of the inverse are some that the law itself gives."""
        own, log_pressure = self.asperities.cubics, self.asperities.numbers.log_scale + INVERSE
        inverse = Pieces(len(own), len(own) + INVERSE.size - 1)
        numbers = TruncatedNumbers(self.asperities.numbers, self.deviation, inverse)
        log_gap = mapped(partial(truncated_log_gap, own, numbers), log_pressure)[0]
        return np.concatenate([own, monotone_cubic(log_gap[::-1], log_pressure[::-1])]), numbers

    @property
    def cubics(self) -> Array:
        return self.splines[0]

    @property
    def numbers(self) -> TruncatedNumbers:
        return self.splines[1]

    def log_gap(self, log_pressure: ArrayLike) -> tuple[Array, Array]:
        """ln of the mean gap in m, and its derivative by ln p; log_pressure : ln of the asperities' pressure in Pa."""
        value, slope = mapped(partial(truncated_log_gap, *self.splines), log_pressure)
        return value, slope

    def area_fraction(self, log_pressure: ArrayLike) -> Array:
        """Real over nominal area, 0 to 1."""
        return mapped(partial(truncated_area, *self.splines), log_pressure)


@lru_cache(maxsize=64)
def truncated_law(asperities: AsperityTable, deviation: float) -> TruncatedGap:
    """The law of a surface, whose splines are made once; arguments as the fields."""
    return TruncatedGap(asperities=asperities, deviation=deviation)


def log_mean_gap(separation: ArrayLike) -> tuple[Array, Array]:
    """ln[phi(x) + x Phi(x)] and its derivative, for any finite x; phi, Phi : normal density and distribution.

    separation : x = d/sigma, of the mean planes. The result is ln of <max(x - z, 0)> for a standard normal z, in
    logarithms throughout: the gap itself falls below the smallest number at x = -38.
    """
    value, slope = mapped(log_gap_at, separation)
    return value, slope
