"""Summits of a rough surface pressed against a plane: elastic, elastoplastic and plastic.

Each summit is a sphere of radius R_a that deforms by w independently of the others. With
w_1 = (3 pi k H/(4 E*))^2 R_a, k = 0.4, w_2 = 54 w_1, and t = (w - w_1)/(w_2 - w_1):
    w < w_1:   A = pi R_a w,                      F = (4/3) E* R_a^(1/2) w^(3/2)
    between:   A = pi R_a w (1 - 2 t^3 + 3 t^2),  F = A H [1 - (1 - k)(ln w_2 - ln w)/(ln w_2 - ln w_1)]
    w >= w_2:  A = 2 pi R_a w,                    F = A H
Let z be the height of a summit above the mean of the summits, Gaussian, and d = h - mean_height. A nominal area carries
    p(h) = density * integral from d to infinity of F(z - d) phi(z) dz
and its real area is given by the same integral of A. The film thickness h separates the mean planes of both surfaces.
Source: [Zhao2000]; in the elastic limit [Greenwood1966].

Splines have both for one surface at very many film thicknesses. Let t be the film thickness above the mean of the
summits in standard deviations. The share of summits higher than t is known in closed form. Its logarithm is subtracted
from those of pressure and area, and the rest is tabulated. The rest is nearly linear in asinh(t) at both ends of the
table. It is extrapolated there as a straight line, which is its limit.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_positive
from analytic.numerics.cubic import Pieces, cubic_at, smooth_cubic, together
from analytic.numerics.elements import formula
from analytic.numerics.normal_distribution import log_upper_tail
from analytic.scene import Array, Material, Surface
from analytic.surface.moments import Summits
from analytic.words import length_of

YIELD_SHARE = 0.4  # k: the mean pressure at first yield is k H
PLASTIC_RATIO = 54.0  # w_2/w_1

# The integrals are over y = w/sigma_s >= 0 with the weight phi(t + y), t = d/sigma_s. They start BACK standard
# deviations before the centre of the weight and end REACH after it; for t > 0 they end where the weight is
# exp(-REACH^2/2) of its value at y = 0. The rest is 2e-9 of the whole. In v = sqrt(y) the elastic force is a power and
# the logarithm between w_1 and w_2 is smooth, so Gauss-Legendre with 30 points per regime has no larger error (see the
# tests).
BACK, REACH = 6.2, 7.0
NODES, WEIGHTS = np.polynomial.legendre.leggauss(30)
BLOCK = 1024  # elements at a time, so that the tables stay in the cache of the processor
TABLE_REACH = 16.0  # of the table in asinh(t): |t| to 4e6 standard deviations
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
    """Splines of pressure and area, (rows, 5), and numbers, with a relative error of 1e-8 up to w_1 = 1000 sigma_s.

    summits : of one rough surface, numbers;  modulus : E*, Pa, > 0;  hardness : H, of the softer body, Pa, > 0
    Raises InputError for a smooth or nearly smooth surface, which has no such table.
    """
    require_positive(density=summits.density, radius=summits.radius, height_deviation=summits.height_deviation)
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
    v = np.unique(np.concatenate([np.arange(-TABLE_REACH, TABLE_REACH, STEP), np.arcsinh(kinks).ravel()]))
    v = v[np.diff(v, prepend=-np.inf) > 1e-6]  # one of two knots that nearly coincide
    t = np.sinh(v)
    load, area = summit_integrals(t, np.full_like(t, yielding))
    higher, scaled = log_upper_tail(t), np.maximum(t, 0.0) ** 2 / 2
    log_load, log_area = np.log(load) - scaled, np.log(area) - scaled
    falling = np.arcsinh(log_load)
    log_area_scale = float(np.log(np.pi * summits.radius * summits.density * deviation))
    cubics, (pressure_pieces, area_pieces, height_pieces) = together(
        smooth_cubic(v, log_load - higher), smooth_cubic(v, log_area - higher), smooth_cubic(falling[::-1], v[::-1])
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


def softer_hardness(surface: Surface, first: Material, second: Material) -> float:
    """Hardness H at which the summits of two bodies yield, Pa: that of the scene, or that of the softer material.

    Raises InputError if neither the scene nor one of the materials has a hardness.
    """
    if surface.hardness is not None:
        require_positive(**{"surface.hardness": surface.hardness})
        return surface.hardness
    known = []
    for material in (first, second):
        if material.hardness is None:
            raise InputError(
                f"surface.hardness is missing, and {material.name} has none: give one, for bearing steel about 7.8 GPa"
            )
        require_positive(hardness=material.hardness)
        known.append(material.hardness)
    return min(known)


def first_yield(radius: ArrayLike, modulus: ArrayLike, hardness: ArrayLike) -> Array:
    """Interference w_1 at which a summit starts to yield, m; the arguments broadcast.

    radius : R_a, m;  modulus : E*, Pa, > 0;  hardness : H, Pa, > 0
    """
    require_positive(modulus=modulus, hardness=hardness)
    strain = 3 * np.pi * YIELD_SHARE * np.asarray(hardness, dtype=np.float64) / (4 * np.asarray(modulus))
    return strain**2 * np.asarray(radius)


def _elastic(ratio: Array) -> tuple[Array | float, Array | float]:
    """Mean pressure over H, and area over pi R_a w, at w/w_1 below 1."""
    return YIELD_SHARE * np.sqrt(ratio), 1.0


def _elastoplastic(ratio: Array) -> tuple[Array | float, Array | float]:
    """The same at w/w_1 between 1 and 54."""
    between = (ratio - 1) / (PLASTIC_RATIO - 1)
    missing = 1 - np.log(ratio) / np.log(PLASTIC_RATIO)
    return 1 - (1 - YIELD_SHARE) * missing, 1 + between**2 * (3 - 2 * between)


def _plastic(_ratio: Array) -> tuple[Array | float, Array | float]:
    """The same at w/w_1 above 54."""
    return 1.0, 2.0


REGIMES = ((0.0, 1.0, _elastic), (1.0, PLASTIC_RATIO, _elastoplastic), (PLASTIC_RATIO, np.inf, _plastic))


def summit_integrals(t: Array, yielding: Array) -> Array:
    """(2, n) integrals over y >= 0 of y f g phi and of y g phi at t + y, times exp(t^2/2) where t > 0.

    t, yielding : (n,), w_1/sigma_s
    f is the mean pressure over H and g the area over pi R_a w, by REGIMES.
    """
    results = np.empty((2, t.size))
    for start in range(0, t.size, BLOCK):
        part = slice(start, start + BLOCK)
        results[:, part] = _block(t[part], yielding[part])
    return results


def _block(t: Array, yielding: Array) -> Array:
    above = np.maximum(t, 0.0)
    low = np.maximum(-t - BACK, 0.0)
    high = np.hypot(above, REACH) - t  # where t y + y^2/2 = REACH^2/2 for t > 0
    total = np.zeros((2, t.size))
    for first, last, law in REGIMES:
        left, right = (np.sqrt(np.clip(edge * yielding, low, high)) for edge in (first, last))
        here = np.flatnonzero(right > left)
        if here.size == 0:
            continue
        half = (right[here] - left[here]) / 2
        v = left[here] + half * (1 + NODES[:, None])
        y = v * v
        x = t[here] + y
        # phi(x), or phi(x) exp(t^2/2) where t > 0: neither factor underflows before their product does.
        weight = np.exp(-(x - above[here]) * (x + above[here]) / 2) * (v * y * (half * np.sqrt(2 / np.pi)))
        pressure, growth = law(y / yielding[here])
        weight *= growth
        total[0, here] += WEIGHTS @ (weight * pressure)
        total[1, here] += WEIGHTS @ weight
    return total
