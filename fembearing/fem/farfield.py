"""The displacement of a half space far from a load: it is prescribed on the far faces of a block of finite size.

The half space is depth > 0 and the load pushes into it. The flanks of a groove lie a little above its surface; the
formulas hold there too, away from the axis of the load. A fixed far face forty contact radii away would make the block
some per cent too stiff. This condition is exact up to the moments of the pressure that the point loads reproduce.
"""

import numpy as np

from analytic.scene import Array, Material


def point_load(x: Array, y: Array, depth: Array, *, material: Material) -> Array:
    """Displacement under a unit load at the origin, (3, ...), m/N; the third component points into the body.

    Source: the solution of Boussinesq, [Johnson1985] section 3.2.
    """
    ratio = material.poisson_ratio
    scale = (1 + ratio) / (2 * np.pi * material.youngs_modulus)
    distance = np.sqrt(x**2 + y**2 + depth**2)
    sideways = scale * (depth / distance**3 - (1 - 2 * ratio) / (distance * (distance + depth)))
    inwards = scale * (depth**2 / distance**3 + 2 * (1 - ratio) / distance)
    return np.array([sideways * x, sideways * y, inwards])


def tangential_point_load(x: Array, y: Array, depth: Array, *, material: Material) -> Array:
    """Displacement under a unit force along x at the origin, (3, ...), m/N; the third component points into the body.

    Source: the solution of Cerruti, [Johnson1985] section 3.6.
    """
    ratio = material.poisson_ratio
    scale = (1 + ratio) / (2 * np.pi * material.youngs_modulus)
    distance = np.sqrt(x**2 + y**2 + depth**2)
    reach = distance + depth
    bent = 1 / distance**3 - (1 - 2 * ratio) / (distance * reach**2)
    along = 1 / distance + (1 - 2 * ratio) / reach + bent * x**2
    inwards = x * (depth / distance**3 + (1 - 2 * ratio) / (distance * reach))
    return scale * np.array([along, bent * x * y, inwards])


def loaded_surface(place: Array, loaded: Array, force: Array, *, material: Material) -> Array:
    """Displacement of a half space under point forces on its surface.

    place : (3, n) x, y and depth, m, of places away from the forces;  loaded : (2, m) x and y of the forces, m
    force : (3, m, k) k sets of forces, N
    The displacement is (3, n, k), m; third components point into the body.
    """
    x, y = (place[axis][:, None] - loaded[axis] for axis in range(2))
    depth = np.broadcast_to(place[2][:, None], x.shape)
    by_y = tangential_point_load(y, x, depth, material=material)[[1, 0, 2]]
    each = tangential_point_load(x, y, depth, material=material), by_y, point_load(x, y, depth, material=material)
    return np.einsum("bapm,bmk->apk", np.array(each), force)


def pressed_ellipse(
    x: Array,
    y: Array,
    depth: Array,
    *,
    semi_axes: tuple[float, float],
    shoulders: tuple[float, float] = (np.inf, np.inf),
    material: Material,
) -> Array:
    """Displacement under a unit load spread as sqrt(1 - x^2/a^2 - y^2/b^2), (3, ...), m/N.

    shoulders : the load is cut off at y = -shoulders[0] and at y = shoulders[1], m; inf where it is not
    The pressure is replaced by 32 point loads with the same moments: four Gauss points along the radius times eight
    angles. Valid outside the ellipse only.
    """
    if np.isfinite(shoulders).any():
        return _pressed_cut_ellipse(x, y, depth, semi_axes=semi_axes, shoulders=shoulders, material=material)
    points, weights = np.polynomial.legendre.leggauss(4)
    height, weights = (points + 1) / 2, weights / 2  # height = sqrt(1 - rho^2) makes the integrand a polynomial
    displacement = np.zeros((3, *np.shape(x)))
    for rho, weight in zip(np.sqrt(1 - height**2), 3 * weights * height**2, strict=True):
        for angle in (np.arange(8) + 0.5) * np.pi / 4:
            shift_x, shift_y = semi_axes[0] * rho * np.cos(angle), semi_axes[1] * rho * np.sin(angle)
            displacement += weight / 8 * point_load(x - shift_x, y - shift_y, depth, material=material)
    return displacement


def _pressed_cut_ellipse(
    x: Array,
    y: Array,
    depth: Array,
    *,
    semi_axes: tuple[float, float],
    shoulders: tuple[float, float],
    material: Material,
) -> Array:
    """As `pressed_ellipse`, cut off: eight Gauss points along y, four Chebyshev points of the second kind along x."""
    low, high = (min(1.0, shoulder / semi_axes[1]) for shoulder in shoulders)
    points, weights = np.polynomial.legendre.leggauss(8)
    transverse = ((high + low) * points + high - low) / 2
    weights = weights * (1 - transverse**2)  # the line load of an ellipse
    angle = np.arange(1, 5) * np.pi / 5
    displacement = np.zeros((3, *np.shape(x)))
    for place, weight in zip(transverse, weights / weights.sum(), strict=True):
        width = semi_axes[0] * np.sqrt(1 - place**2)
        for rolling, share in zip(np.cos(angle), np.sin(angle) ** 2 / 2.5, strict=True):
            displacement += (
                weight * share * point_load(x - width * rolling, y - semi_axes[1] * place, depth, material=material)
            )
    return displacement
