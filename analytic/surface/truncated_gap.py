"""The mean gap of truncated surfaces: what overlaps is cut off, and the rest keeps its shape.

Two rough surfaces whose mean planes are d apart leave the mean gap <max(d - z, 0)>, where z are the heights of both
together, Gaussian with the standard deviation sigma. The oil that the inlet lets in fills this gap; d may be negative.
The pressure at d is that of independent summits (`analytic.surface.asperity`).
Source: the average gap of [Patir1978].
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import erfcx, log_ndtr

from analytic.scene import Array
from analytic.surface.asperity_table import AsperityTable

FAR = 100.0  # standard deviations: from here on the series below is exact, and 1 - t sqrt(pi/2) erfcx loses digits


@dataclass(frozen=True, kw_only=True, eq=False)
class TruncatedGap:
    """The gap law of truncated surfaces whose summits deform independently."""

    asperities: AsperityTable
    deviation: float  # sigma, of the heights of both surfaces, m

    def log_gap(self, log_pressure: Array) -> tuple[Array, Array]:
        """ln of the mean gap in m, and its derivative by ln p; log_pressure : ln of the asperities' pressure in Pa."""
        separation, slope = self.asperities.separation(log_pressure)
        log_gap, steepness = log_mean_gap(separation / self.deviation)
        return np.log(self.deviation) + log_gap, steepness * slope / self.deviation

    def area_fraction(self, log_pressure: Array) -> Array:
        """Real over nominal area, 0 to 1."""
        return self.asperities.area_fraction(self.asperities.separation(log_pressure)[0])


def log_mean_gap(separation: Array) -> tuple[Array, Array]:
    """ln[phi(x) + x Phi(x)] and its derivative, for any finite x; phi, Phi : normal density and distribution.

    separation : x = d/sigma, of the mean planes. The result is ln of <max(x - z, 0)> for a standard normal z, in
    logarithms throughout: the gap itself falls below the smallest number at x = -38.
    """
    x = np.asarray(separation, dtype=np.float64)
    t = np.maximum(-x, 0.0)
    near = np.minimum(t, FAR)
    inverse = 1 / np.maximum(t, FAR) ** 2
    over_density = np.where(  # of the left side, gap/phi
        t < FAR,
        np.log1p(-near * np.sqrt(np.pi / 2) * erfcx(near / np.sqrt(2))),
        np.log(inverse) + np.log1p(-inverse * (3 - inverse * (15 - 105 * inverse))),
    )
    right = np.maximum(x, 0.0)
    density, below = np.exp(-(right**2) / 2) / np.sqrt(2 * np.pi), np.exp(log_ndtr(right))
    gap = density + right * below
    left = over_density - x**2 / 2 - np.log(2 * np.pi) / 2
    # On the left Phi/phi over gap/phi: their logarithms cancel to 4 digits at x = -1e6.
    steepness = np.where(x < 0, np.sqrt(np.pi / 2) * erfcx(t / np.sqrt(2)) * np.exp(-over_density), below / gap)
    return np.where(x < 0, left, np.log(gap)), steepness
