"""Two half spaces pressed together over a paraboloidal gap: the ellipse in which they touch, and their approach.

The gap is curvature_x x^2/2 + curvature_y y^2/2. Under the pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2) of a load Q,

    curvature_x = Q/(pi E*) R_D(0, b^2, a^2),   curvature_y = Q/(pi E*) R_D(0, a^2, b^2)
    approach = 3 Q/(2 pi E*) R_F(0, a^2, b^2)

with Carlson's integrals R_D and R_F, in which no direction is the longer one and a circle is no special case.
Source: [Johnson1985] section 4.2, whose integrals over the potential of an ellipsoid are those of [Carlson1995].
"""

import math

import numpy as np
from scipy.special import elliprd, elliprf

from analytic.scene import Array, Contact, Material
from fembearing.fem.measure import Quantities

# Slope of the logarithm of the ratio of curvatures over that of the axis ratio: 1.5 at a circle, up to 2 at a line.
# With the mean each step leaves a seventh of the error or less; all of them leave round-off.
SLOPE, STEPS = 1.75, 20


def plane_strain_modulus(material: Material) -> float:
    """E/(1 - nu^2), Pa."""
    return material.youngs_modulus / (1 - material.poisson_ratio**2)


def contact_modulus(contact: Contact) -> float:
    """E*, Pa, of both bodies: 1/E* is the sum of (1 - nu^2)/E."""
    return 1 / (1 / plane_strain_modulus(contact.ball_material) + 1 / plane_strain_modulus(contact.race_material))


def curvatures_under(semi_axes: tuple[float, float], *, load: float, modulus: float) -> tuple[float, float]:
    """Relative curvatures in x and y, 1/m, of the gap that a load closes in an ellipse of given semi-axes, m.

    load : of the whole ellipse, N
    modulus : E*, Pa
    """
    a, b = semi_axes
    scale = load / (math.pi * modulus)
    return scale * float(elliprd(0, b**2, a**2)), scale * float(elliprd(0, a**2, b**2))


def approach_under(semi_axes: tuple[float, float], *, load: float, modulus: float) -> float:
    """Approach of the far fields, m, under a load with an ellipse of given semi-axes; arguments as above."""
    a, b = semi_axes
    return 3 * load / (2 * math.pi * modulus) * float(elliprf(0, a**2, b**2))


def exact_quantities(semi_axes: tuple[float, float], *, load: float, modulus: float) -> Quantities:
    """All quantities of two half spaces under a load with an ellipse of given semi-axes; arguments as above."""
    approach = approach_under(semi_axes, load=load, modulus=modulus)
    return Quantities(
        semi_axis_rolling=semi_axes[0],
        semi_axis_transverse=semi_axes[1],
        peak_pressure=3 * load / (2 * math.pi * semi_axes[0] * semi_axes[1]),
        approach=approach,
        stiffness=load / approach**1.5,
    )


def hertz_ellipse(curvatures: tuple[float, float], *, load: float, modulus: float) -> tuple[float, float]:
    """Semi-axes in x and y, m, of the ellipse in which a load closes a gap of given relative curvatures, 1/m, positive.

    load, modulus : as above
    The axis ratio b/a depends on the ratio of curvatures alone; it lies between 1 and that ratio.
    """
    x, y = curvatures
    ratio = 1.0
    for _ in range(STEPS):
        there = curvatures_under((1.0, ratio), load=1.0, modulus=1.0)
        ratio *= (x / y * there[1] / there[0]) ** (1 / SLOPE)
    unit, _ = curvatures_under((1.0, ratio), load=load, modulus=modulus)
    a = (unit / x) ** (1 / 3)  # curvatures fall with the cube of the size
    return a, ratio * a


def pressed_rectangle(x: Array, y: Array, *, half_sides: tuple[float, float]) -> Array:
    """Displacement at (x, y) times pi E*, for a unit force spread evenly over a rectangle about the origin.

    x, y : any one shape;  half_sides : of the rectangle, in the same unit of length
    Returns values per that unit of length. Source: Love's solution, [Johnson1985] section 3.3.
    """
    half_x, half_y = half_sides
    total: Array = np.zeros(np.broadcast_shapes(x.shape, y.shape))
    for sign_x in (1, -1):
        for sign_y in (1, -1):
            corner_x, corner_y = x + sign_x * half_x, y + sign_y * half_y
            part = corner_x * np.arcsinh(corner_y / np.abs(corner_x)) + corner_y * np.arcsinh(
                corner_x / np.abs(corner_y)
            )
            total += sign_x * sign_y * part
    return total / (4 * half_x * half_y)
