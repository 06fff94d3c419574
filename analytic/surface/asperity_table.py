"""The rough contact of `analytic.surface.asperity` as splines, for one surface at very many film thicknesses.

Let t be the film thickness above the mean of the summits in standard deviations. The share of summits higher than t is
known in closed form. Its logarithm is subtracted from those of pressure and area, and the rest is tabulated. The rest
is nearly linear in asinh(t) at both ends of the table. It is extrapolated there as a straight line, which is its limit.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.special import log_ndtr

from analytic.errors import InputError, require_positive
from analytic.scene import Array
from analytic.surface.asperity import PLASTIC_RATIO, first_yield, summit_integrals
from analytic.surface.moments import Summits
from analytic.words import length_of

REACH = 16.0  # of the table in asinh(t): |t| to 4e6 standard deviations
STEP = 0.0125  # in asinh(t)
KINK_REACH, KINK_STEP = 9.0, 0.06  # in t, around where the highest summits reach w_1 and w_2


@dataclass(frozen=True, eq=False)
class Cubic:
    """A cubic spline for few x at a time: a call of SciPy's spline would take longer than the rest of the solution."""

    inner: Array  # knots without the ends; the first and the last piece extrapolate
    left: Array  # left knot of each piece
    coefficients: Array  # (4, pieces), highest power first

    @classmethod
    def through(cls, x: Array, y: Array) -> "Cubic":
        from scipy.interpolate import CubicSpline  # a fifth of a second to import, only for rough surfaces

        spline = CubicSpline(x, y)
        return cls(x[1:-1], x[:-1], np.asarray(spline.c))

    def __call__(self, x: Array) -> tuple[Array, Array]:
        """Value and slope."""
        piece = self.inner.searchsorted(x)
        c3, c2, c1, c0 = self.coefficients[:, piece]
        d = x - self.left[piece]
        return ((c3 * d + c2) * d + c1) * d + c0, (3 * c3 * d + 2 * c2) * d + c1


@dataclass(frozen=True, kw_only=True, eq=False)
class AsperityTable:
    """Pressure and area of one rough surface; build it with `tabulated_asperities`."""

    summits: Summits
    log_scale: float  # ln of pi R_a density sigma_s H, Pa
    log_area_scale: float  # ln of pi R_a density sigma_s
    pressure_spline: Cubic  # of asinh(t)
    area_spline: Cubic  # of asinh(t)
    height_spline: Cubic  # asinh(t) over asinh(ln p - log_scale), which is straight where t is large

    def log_pressure(self, film_thickness: Array) -> Array:
        """ln of p_a in Pa, also where p_a itself underflows to 0; film_thickness : m, any finite number."""
        t = (film_thickness - self.summits.mean_height) / self.summits.height_deviation
        return self.log_scale + log_ndtr(-t) + self.pressure_spline(np.arcsinh(t))[0]

    def separation(self, log_pressure: Array) -> tuple[Array, Array]:
        """The inverse of log_pressure: h, m, and its derivative by ln p_a."""
        q = log_pressure - self.log_scale
        y = np.arcsinh(q)
        v, slope = self.height_spline(y)
        slope = self.summits.height_deviation * np.cosh(v) * slope / np.hypot(1.0, q)
        return self.summits.mean_height + self.summits.height_deviation * np.sinh(v), slope

    def area_fraction(self, film_thickness: Array) -> Array:
        """Real over nominal area, at most 1; film_thickness : m, any finite number."""
        t = (film_thickness - self.summits.mean_height) / self.summits.height_deviation
        return np.exp(np.minimum(self.log_area_scale + log_ndtr(-t) + self.area_spline(np.arcsinh(t))[0], 0.0))


@lru_cache(maxsize=64)
def tabulated_asperities(*, summits: Summits, modulus: float, hardness: float) -> AsperityTable:
    """Splines of asperity_contact with a relative error of 1e-8 up to w_1 = 1000 sigma_s.

    summits : of one rough surface, numbers;  modulus : E*, Pa, > 0;  hardness : H, of the softer body, Pa, > 0
    Raises InputError for a smooth or nearly smooth surface, which has no such table.
    """
    require_positive(
        density=summits.density,
        radius=summits.radius,
        height_deviation=summits.height_deviation,
    )
    if np.ndim(summits.density) or np.ndim(summits.radius) or np.ndim(summits.height_deviation):
        raise InputError("summits must be those of one surface, numbers: make a table for each surface")
    deviation = float(summits.height_deviation)
    yielding = float(first_yield(summits.radius, modulus, hardness)) / deviation
    kinks = np.array([[-yielding], [-PLASTIC_RATIO * yielding]]) + np.arange(-KINK_REACH, KINK_REACH, KINK_STEP)
    v = np.unique(np.concatenate([np.arange(-REACH, REACH, STEP), np.arcsinh(kinks).ravel()]))
    v = v[np.diff(v, prepend=-np.inf) > 1e-6]  # one of two knots that nearly coincide
    t = np.sinh(v)
    load, area, _ = summit_integrals(t, np.full_like(t, yielding))
    if not (np.all(load > 0) and np.all(area > 0)):  # the loads of nearly flat summits underflow
        raise InputError(
            f"summits of radius {length_of(float(summits.radius))} whose heights deviate by {length_of(deviation)} are "
            "all but flat: give a rougher surface, or an rms_roughness of 0"
        )
    higher, scaled = log_ndtr(-t), np.maximum(t, 0.0) ** 2 / 2
    log_load, log_area = np.log(load) - scaled, np.log(area) - scaled
    log_area_scale = float(np.log(np.pi * summits.radius * summits.density * deviation))
    return AsperityTable(
        summits=summits,
        log_scale=log_area_scale + float(np.log(hardness)),
        log_area_scale=log_area_scale,
        pressure_spline=Cubic.through(v, log_load - higher),
        area_spline=Cubic.through(v, log_area - higher),
        height_spline=Cubic.through(np.arcsinh(log_load[::-1]), v[::-1]),
    )
