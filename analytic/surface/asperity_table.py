"""The rough contact of `analytic.surface.asperity` as splines, for one surface at very many film thicknesses.

Let t be the film thickness above the mean of the summits in standard deviations. The share of summits higher than t is
known in closed form. Its logarithm is subtracted from those of pressure and area, and the rest is tabulated. The rest
is nearly linear in asinh(t) at both ends of the table. It is extrapolated there as a straight line, which is its limit.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np

from analytic.errors import InputError, require_positive
from analytic.numerics.cubic import Pieces, cubic_at, smooth_cubic, together
from analytic.numerics.elements import formula
from analytic.numerics.normal_distribution import log_upper_tail
from analytic.scene import Array
from analytic.surface.asperity import PLASTIC_RATIO, first_yield, summit_integrals
from analytic.surface.moments import Summits
from analytic.words import length_of

REACH = 16.0  # of the table in asinh(t): |t| to 4e6 standard deviations
STEP = 0.0125  # in asinh(t)
KINK_REACH, KINK_STEP = 9.0, 0.06  # in t, around where the highest summits reach w_1 and w_2


class SummitNumbers(NamedTuple):
    """Pressure and area of one rough surface; the splines are in an array that formulas take beside."""

    mean_height: float  # of the summits, m
    height_deviation: float  # of the summits, m
    log_scale: float  # ln of pi R_a density sigma_s H, Pa
    log_area_scale: float  # ln of pi R_a density sigma_s
    pressure: Pieces  # of asinh(t)
    area: Pieces  # of asinh(t)
    height: Pieces  # asinh(t) over asinh(ln p - log_scale), which is straight where t is large


@formula
def log_pressure_at(cubics: Array, table: SummitNumbers, film_thickness: float) -> float:
    """ln of p_a in Pa, also where p_a itself underflows to 0; film_thickness : m, any finite number."""
    t = (film_thickness - table.mean_height) / table.height_deviation
    return table.log_scale + log_upper_tail(t) + cubic_at(cubics, table.pressure, np.arcsinh(t))[0]


@formula
def separation_of(cubics: Array, table: SummitNumbers, log_pressure: float) -> tuple[float, float]:
    """The inverse of log_pressure_at: h, m, and its derivative by ln p_a."""
    q = log_pressure - table.log_scale
    v, slope = cubic_at(cubics, table.height, np.arcsinh(q))
    deviation = table.height_deviation
    return table.mean_height + deviation * np.sinh(v), deviation * np.cosh(v) * slope / np.hypot(1.0, q)


@formula
def summit_area(cubics: Array, table: SummitNumbers, film_thickness: float) -> float:
    """Real over nominal area, at most 1; film_thickness : m, any finite number."""
    t = (film_thickness - table.mean_height) / table.height_deviation
    log_area = table.log_area_scale + log_upper_tail(t) + cubic_at(cubics, table.area, np.arcsinh(t))[0]
    return np.exp(min(log_area, 0.0))


@lru_cache(maxsize=64)
def tabulated_asperities(*, summits: Summits, modulus: float, hardness: float) -> tuple[Array, SummitNumbers]:
    """Splines of asperity_contact, (rows, 5) and numbers, with a relative error of 1e-8 up to w_1 = 1000 sigma_s.

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
    if not np.spacing(PLASTIC_RATIO * yielding) <= KINK_STEP:  # round-off of t hides where summits yield; inf: NaN
        raise InputError(
            f"summits of radius {length_of(float(summits.radius))} whose heights deviate by {length_of(deviation)} are "
            "all but flat: give a rougher surface, or an rms_roughness of 0"
        )
    kinks = np.array([[-yielding], [-PLASTIC_RATIO * yielding]]) + np.arange(-KINK_REACH, KINK_REACH, KINK_STEP)
    v = np.unique(np.concatenate([np.arange(-REACH, REACH, STEP), np.arcsinh(kinks).ravel()]))
    v = v[np.diff(v, prepend=-np.inf) > 1e-6]  # one of two knots that nearly coincide
    t = np.sinh(v)
    load, area, _ = summit_integrals(t, np.full_like(t, yielding))
    higher, scaled = log_upper_tail(t), np.maximum(t, 0.0) ** 2 / 2
    log_load, log_area = np.log(load) - scaled, np.log(area) - scaled
    falling = np.arcsinh(log_load)
    log_area_scale = float(np.log(np.pi * summits.radius * summits.density * deviation))
    cubics, (pressure_pieces, area_pieces, height_pieces) = together(
        smooth_cubic(v, log_load - higher),
        smooth_cubic(v, log_area - higher),
        smooth_cubic(falling[::-1], v[::-1]),
    )
    return cubics, SummitNumbers(
        mean_height=float(summits.mean_height),
        height_deviation=deviation,
        log_scale=log_area_scale + float(np.log(hardness)),
        log_area_scale=log_area_scale,
        pressure=pressure_pieces,
        area=area_pieces,
        height=height_pieces,
    )
