"""Stresses under the centre of a Hertzian contact, and their maxima: where rolling-contact fatigue begins.

Assumes as Hertz does a half space under the pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2), without friction. x and y follow
the semi-axes, z points into the body from the contact's centre. A stress is positive in tension. On the z axis x, y and
z are the principal directions.
Source: derived here from Boussinesq's potentials of the semi-ellipsoidal layer, in the integrals of [Carlson1995].
[Johnson1985] section 4.2(c) and [Hills] tabulate the same stresses.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import elliprd

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array

# Both maxima lie within 0.8 minor semi-axes. The scan goes twice as deep, in steps fine enough to separate two maxima.
DEEPEST = 2.0  # minor semi-axes
STEPS = 64
GOLDEN = (np.sqrt(5) - 1) / 2
SECTIONS = 40  # each keeps 0.62 of the bracket: 40 reduce 1/16 to the square root of round-off; a maximum shows no more


@dataclass(frozen=True, kw_only=True, eq=False)
class AxisStress:
    """The principal stresses on the axis; every field has the broadcast shape of the arguments."""

    sigma_x: Array  # in the direction of rolling, Pa
    sigma_y: Array  # transverse, Pa
    sigma_z: Array  # in the direction of the load, Pa

    @property
    def max_shear(self) -> Array:
        """Tresca's (sigma_1 - sigma_3)/2, Pa, with the largest and the least of the three stresses."""
        stress = np.array([self.sigma_x, self.sigma_y, self.sigma_z])
        return (stress.max(axis=0) - stress.min(axis=0)) / 2

    @property
    def von_mises(self) -> Array:
        """sqrt(((sx - sy)^2 + (sy - sz)^2 + (sz - sx)^2)/2), Pa."""
        x, y, z = self.sigma_x, self.sigma_y, self.sigma_z
        return np.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2)


@dataclass(frozen=True, kw_only=True, eq=False)
class SubsurfaceMaximum:
    """The largest stresses on the axis and their depths; every field has the broadcast shape of the arguments."""

    max_shear: Array  # (sigma_1 - sigma_3)/2, Pa
    max_shear_depth: Array  # m
    max_von_mises: Array  # Pa
    max_von_mises_depth: Array  # m


def subsurface_maximum(
    *, peak_pressure: ArrayLike, semi_axis_x: ArrayLike, semi_axis_y: ArrayLike, poisson_ratio: ArrayLike
) -> SubsurfaceMaximum:
    """The largest shear and von Mises stress on the axis, and their depths; all arguments broadcast.

    peak_pressure : p0, Pa, >= 0
    semi_axis_x, semi_axis_y : a, b, m, > 0; either may be the longer
    poisson_ratio : nu, -1 to 0.5

    At nu = 0.3 the largest shear is 0.310 p0 at 0.481 a under a circle, and 0.300 p0 at 0.786 minor semi-axes under a
    line. Under a line with nu below 0.24 the shear between the directions of load and length is the larger one and lies
    nearer the surface. With nu below 0.19 the von Mises stress is largest on the surface, at depth 0.
    Stresses are exact to round-off, depths to 1e-7 of the minor semi-axis, because a maximum is flat.
    Stresses off the axis are not computed; those at the edge of the ellipse may be larger.
    Raises InputError if an argument is out of range, not finite, or if shapes do not broadcast.
    """
    p0, a, b, ratio = _arguments(
        peak_pressure=peak_pressure, semi_axis_x=semi_axis_x, semi_axis_y=semi_axis_y, poisson_ratio=poisson_ratio
    )
    minor = np.minimum(a, b)
    one = np.ones_like(p0)

    def at(depth: Array) -> AxisStress:
        return axis_stress(
            depth=depth, peak_pressure=one, semi_axis_x=a / minor, semi_axis_y=b / minor, poisson_ratio=ratio
        )

    shear, shear_depth = _largest(lambda depth: at(depth).max_shear, one)
    mises, mises_depth = _largest(lambda depth: at(depth).von_mises, one)
    return SubsurfaceMaximum(
        max_shear=p0 * shear,
        max_shear_depth=minor * shear_depth,
        max_von_mises=p0 * mises,
        max_von_mises_depth=minor * mises_depth,
    )


def axis_stress(
    *, depth: Array, peak_pressure: Array, semi_axis_x: Array, semi_axis_y: Array, poisson_ratio: Array
) -> AxisStress:
    """Stresses on the axis of an elliptic contact; all arguments broadcast and are not checked.

    depth : z, m, >= 0;  peak_pressure : p0, Pa, >= 0;  semi_axis_x, semi_axis_y : a, b, m, > 0; either may be longer
    poisson_ratio : nu of the body, -1 to 0.5
    With A = sqrt(a^2 + z^2), B = sqrt(b^2 + z^2), Jx = 2/3 R_D(B^2, z^2, A^2) and Jy = 2/3 R_D(A^2, z^2, B^2):
        sigma_x = p0 a b (z Jx + nu z Jy - 2 nu/(A B) - (1 - 2 nu)/(A (A + B)))
        sigma_y = p0 a b (z Jy + nu z Jx - 2 nu/(A B) - (1 - 2 nu)/(B (A + B)))
        sigma_z = -p0 a b/(A B)
    The circle needs no special case. Long ellipses tend to the line contact of plane strain.
    The errors are a few roundings of sigma_z.
    """
    ratio = poisson_ratio
    minor = np.minimum(semi_axis_x, semi_axis_y)  # unit of length: Carlson's integrals of squares of um would underflow
    z, a, b = depth / minor, semi_axis_x / minor, semi_axis_y / minor
    aa, bb = np.hypot(a, z), np.hypot(b, z)
    x_part = 2 / 3 * z * elliprd(bb**2, z**2, aa**2)
    y_part = 2 / 3 * z * elliprd(aa**2, z**2, bb**2)
    volume = 2 * ratio / (aa * bb)
    spread = (1 - 2 * ratio) / (aa + bb)
    scale = peak_pressure * a * b
    return AxisStress(
        sigma_x=scale * (x_part + ratio * y_part - volume - spread / aa),
        sigma_y=scale * (y_part + ratio * x_part - volume - spread / bb),
        sigma_z=-scale / (aa * bb),
    )


def _largest(measure: Callable[[Array], Array], one: Array) -> tuple[Array, Array]:
    """The largest value over depths 0 to DEEPEST, and its depth: a scan, then golden sections about its best depth."""
    best, place = measure(0 * one), 0 * one
    for depth in np.linspace(0, DEEPEST, STEPS + 1)[1:]:
        value = measure(depth * one)
        place = np.where(value > best, depth, place)
        best = np.maximum(value, best)
    low, high = np.maximum(place - DEEPEST / STEPS, 0.0), place + DEEPEST / STEPS
    for _ in range(SECTIONS):
        inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        outwards = measure(outer) > measure(inner)
        low, high = np.where(outwards, inner, low), np.where(outwards, high, outer)
    middle = (low + high) / 2
    value = measure(middle)
    return np.maximum(value, best), np.where(value > best, middle, place)  # a maximum on the surface is the scan's


def _arguments(**given: ArrayLike) -> list[Array]:
    """The arguments as arrays of one shape, in their order."""
    require_non_negative(peak_pressure=given["peak_pressure"])
    require_positive(semi_axis_x=given["semi_axis_x"], semi_axis_y=given["semi_axis_y"])
    require_finite(poisson_ratio=given["poisson_ratio"])
    ratio = np.asarray(given["poisson_ratio"], dtype=np.float64)
    if np.any((ratio < -1) | (ratio > 0.5)):
        raise InputError(
            f"poisson_ratio must lie in [-1, 0.5], got {ratio.min():g} to {ratio.max():g}; metals have about 0.3"
        )
    arrays = [np.asarray(value, dtype=np.float64) for value in given.values()]
    try:
        return list(np.broadcast_arrays(*arrays))
    except ValueError as problem:
        shapes = ", ".join(str(value.shape) for value in arrays)
        raise InputError(f"{', '.join(given)} have shapes {shapes}: give equal lengths") from problem
