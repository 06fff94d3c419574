"""The displacement of a half space far from a load: what a block of finite size is held by.

Half space at depth > 0, load pushing into it; the flanks of a groove lie a little above its surface, where the same
formulas hold as long as they keep off the load's axis. A fixed far face would be stiff by per cents at forty
contact radii; this one is exact to the moments of the pressure.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.scene import Material

Array = NDArray[np.float64]


def point_load(x: Array, y: Array, depth: Array, *, material: Material) -> Array:
    """Displacement under a unit load at the origin, (3, ...), m/N; the third component points into the body.

    Source: Boussinesq; K. L. Johnson, Contact Mechanics (1985), section 3.2.
    """
    ratio = material.poisson_ratio
    scale = (1 + ratio) / (2 * np.pi * material.youngs_modulus)
    distance = np.sqrt(x**2 + y**2 + depth**2)
    sideways = scale * (depth / distance**3 - (1 - 2 * ratio) / (distance * (distance + depth)))
    inwards = scale * (depth**2 / distance**3 + 2 * (1 - ratio) / distance)
    return np.array([sideways * x, sideways * y, inwards])


def pressed_ellipse(
    x: Array,
    y: Array,
    depth: Array,
    *,
    semi_axes: tuple[float, float],
    room: tuple[float, float] = (np.inf, np.inf),
    material: Material,
) -> Array:
    """Displacement under a unit load spread as sqrt(1 - x^2/a^2 - y^2/b^2), (3, ...), m/N.

    room : the load ends at y = -room[0] and at y = room[1], m, where the ellipse goes on
    The pressure is replaced by 32 point loads with the same moments: four Gauss points along the
    radius times eight angles. Only points outside the ellipse are meant.
    """
    if np.isfinite(room).any():
        return _pressed_cut_ellipse(x, y, depth, semi_axes=semi_axes, room=room, material=material)
    points, weights = np.polynomial.legendre.leggauss(4)
    height, weights = (points + 1) / 2, weights / 2  # height = sqrt(1 - rho^2) makes the integrand a polynomial
    displacement = np.zeros((3, *np.shape(x)))
    for rho, weight in zip(np.sqrt(1 - height**2), 3 * weights * height**2, strict=True):
        for angle in (np.arange(8) + 0.5) * np.pi / 4:
            shift_x, shift_y = semi_axes[0] * rho * np.cos(angle), semi_axes[1] * rho * np.sin(angle)
            displacement += weight / 8 * point_load(x - shift_x, y - shift_y, depth, material=material)
    return displacement


def _pressed_cut_ellipse(
    x: Array, y: Array, depth: Array, *, semi_axes: tuple[float, float], room: tuple[float, float], material: Material
) -> Array:
    """The same where the ellipse is cut off: eight Gauss points across, four of Chebyshev's second kind along x."""
    low, high = (min(1.0, end / semi_axes[1]) for end in room)
    points, weights = np.polynomial.legendre.leggauss(8)
    across = ((high + low) * points + high - low) / 2
    weights = weights * (1 - across**2)  # the line load of an ellipse
    angle = np.arange(1, 5) * np.pi / 5
    displacement = np.zeros((3, *np.shape(x)))
    for place, weight in zip(across, weights / weights.sum(), strict=True):
        reach = semi_axes[0] * np.sqrt(1 - place**2)
        for along, share in zip(np.cos(angle), np.sin(angle) ** 2 / 2.5, strict=True):
            displacement += (
                weight * share * point_load(x - reach * along, y - semi_axes[1] * place, depth, material=material)
            )
    return displacement
