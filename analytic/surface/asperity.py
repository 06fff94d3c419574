"""Summits of a rough surface pressed against a plane: elastic, elastoplastic and plastic.

Each summit is a sphere of radius R_a that deforms by w independently of the others: by Hertz below w_1, with a fully
plastic imprint at the hardness above w_2 = 54 w_1, and in between with a pressure and an area that join both without a
jump. Let z be the height of a summit above the mean of the summits, Gaussian, and d = h - mean_height. A nominal area
carries
    p(h) = density * integral from d to infinity of F(z - d) phi(z) dz
and its real area is given by the same integral of A. The film thickness h separates the mean planes of both surfaces.
Source: [Zhao2000]; in the elastic limit [Greenwood1966].
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array, Material, Surface
from analytic.surface.moments import Summits

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


class Asperity(NamedTuple):
    """Contact of one summit; every field has the broadcast shape of the arguments."""

    load: Array  # F, N
    area: Array  # A, m^2


class AsperityContact(NamedTuple):
    """Contact of a nominal area; every field has the broadcast shape of the arguments."""

    pressure: Array  # p_a, load over the nominal area, Pa
    area_fraction: Array  # real over nominal area, at most 1
    pressure_slope: Array  # dp_a/dh, Pa/m, <= 0


def asperity_load(
    *, interference: ArrayLike, tip_radius: ArrayLike, modulus: ArrayLike, hardness: ArrayLike
) -> Asperity:
    """Load and area of one summit; the arguments broadcast.

    interference : w, m; at or below 0 the summit is free.  tip_radius : R_a, m, > 0
    modulus : E*, Pa, > 0;  hardness : H, of the softer body, Pa, > 0
    With w_1 = (3 pi k H/(4 E*))^2 R_a, k = 0.4, w_2 = 54 w_1, and t = (w - w_1)/(w_2 - w_1):
        w < w_1:   A = pi R_a w,                      F = (4/3) E* R_a^(1/2) w^(3/2)
        between:   A = pi R_a w (1 - 2 t^3 + 3 t^2),  F = A H [1 - (1 - k)(ln w_2 - ln w)/(ln w_2 - ln w_1)]
        w >= w_2:  A = 2 pi R_a w,                    F = A H
    """
    require_finite(interference=interference)
    require_positive(tip_radius=tip_radius)
    radius = np.asarray(tip_radius, dtype=np.float64)
    yielding = first_yield(radius, modulus, hardness)
    depth = np.maximum(interference, 0.0)
    ratio = depth / yielding
    pressure, growth = np.zeros(ratio.shape), np.zeros(ratio.shape)
    for first, last, law in REGIMES:
        here = (ratio >= first) & (ratio < last)
        pressure[here], growth[here] = law(ratio[here])
    area = np.pi * radius * depth * growth
    return Asperity(load=area * np.asarray(hardness) * pressure, area=area)


def asperity_contact(
    *, film_thickness: ArrayLike, summits: Summits, modulus: ArrayLike, hardness: ArrayLike
) -> AsperityContact:
    """Pressure and real area of the summits at a film thickness; the arguments and the fields of summits broadcast.

    film_thickness : h, m, finite, of any sign; far below 0 the summits are flattened independently of each other
    modulus : E*, Pa, > 0;  hardness : H, of the softer body, Pa, > 0
    Relative errors are below 1e-8, those of the slope below 1e-6. A smooth surface (height_deviation 0) carries nothing
    at h > 0 and is a wall at h <= 0: infinite pressure, area fraction 1, slope 0.
    """
    require_finite(film_thickness=film_thickness)
    t, yielding, scale, reference = _arguments(film_thickness, summits, modulus, hardness)
    load, area, slope = summit_integrals(t, yielding)
    decay = np.exp(-(np.maximum(t, 0.0) ** 2) / 2)
    rough = scale > 0
    height = np.broadcast_to(np.asarray(film_thickness, dtype=np.float64), t.shape)
    deviation = np.broadcast_to(np.asarray(summits.height_deviation, dtype=np.float64), t.shape)
    wall = ~rough & (height <= 0)
    per_metre = np.divide(scale * reference, deviation, out=np.zeros_like(t), where=rough)
    return AsperityContact(
        pressure=np.where(wall, np.inf, scale * reference * decay * load),
        area_fraction=np.where(wall, 1.0, np.minimum(scale * decay * area, 1.0)),
        pressure_slope=-per_metre * decay * slope,
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


def _arguments(
    separation: ArrayLike, summits: Summits, modulus: ArrayLike, hardness: ArrayLike
) -> tuple[Array, Array, Array, Array]:
    """(t at that separation, w_1/sigma_s, pi R_a density sigma_s, H) in one shape; the third is 0 if smooth."""
    require_non_negative(
        density=summits.density, height_deviation=summits.height_deviation, mean_height=summits.mean_height
    )
    deviation = np.asarray(summits.height_deviation, dtype=np.float64)
    rough = (deviation > 0) & (np.asarray(summits.density) > 0)
    radius = np.where(rough, summits.radius, 1.0)  # any: a smooth surface has flat tips, and no integral uses them
    require_positive(radius=radius)
    divisor = np.where(rough, deviation, 1.0)
    given = (
        (np.asarray(separation, dtype=np.float64) - summits.mean_height) / divisor,
        first_yield(radius, modulus, hardness) / divisor,
        np.where(rough, np.pi * radius * np.asarray(summits.density) * deviation, 0.0),
        hardness,
    )
    try:
        t, yielding, scale, reference = (np.array(part, dtype=np.float64) for part in np.broadcast_arrays(*given))
    except ValueError as problem:
        raise InputError(
            "the arguments of an asperity contact have shapes that do not fit: give equal lengths"
        ) from problem
    return t, yielding, scale, reference


def summit_integrals(t: Array, yielding: Array) -> tuple[Array, Array, Array]:
    """Integrals over y >= 0 of y f g phi, y g phi and x y f g phi at x = t + y, times exp(t^2/2) where t > 0.

    f is the mean pressure over H and g the area over pi R_a w, by REGIMES. Without the factor exp(t^2/2) the third
    integral is minus the derivative of the first by t.
    """
    results = np.empty((3, t.size))
    flat, limits = t.ravel(), yielding.ravel()
    for start in range(0, t.size, BLOCK):
        part = slice(start, start + BLOCK)
        results[:, part] = _block(flat[part], limits[part])
    load, area, slope = results.reshape(3, *t.shape)
    return load, area, slope


def _block(t: Array, yielding: Array) -> Array:
    above = np.maximum(t, 0.0)
    low = np.maximum(-t - BACK, 0.0)
    high = np.hypot(above, REACH) - t  # where t y + y^2/2 = REACH^2/2 for t > 0
    total = np.zeros((3, t.size))
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
        load = weight * pressure
        total[0, here] += WEIGHTS @ load
        total[1, here] += WEIGHTS @ weight
        total[2, here] += WEIGHTS @ (load * x)
    return total
