"""Lubricated contacts of given Moes numbers, for the tests of the numerical film."""

from typing import Any

from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import Paraboloid
from fembearing.fem.half_space import hertz_ellipse

STEEL, RADIUS = 1.14e11, 9.5e-3  # E*, Pa; R_x, m


def moes(
    loading: float,
    thickening: float,
    ellipticity: float = 1.0,
    *,
    ahead: float = 8.49,
    viscosity: float = 0.059,
    pressure_viscosity: float = 2e-8,
    modulus: float = STEEL,
    radius: float = RADIUS,
    **oil: Any,
) -> LubricatedContact:
    """A contact of given M, L and lambda, whose oil reaches `ahead` semi-axes a, and as far to the side in the gap.

    Without thickening, L = 0, the speed is a usual one and the oil has no pressure-viscosity.
    """
    relative = (thickening / (pressure_viscosity * 2 * modulus)) ** 4 if thickening else 1e-11
    load = loading * relative**0.75 * 2 * modulus * radius**2
    a, b = hertz_ellipse((1 / radius, ellipticity / radius), load=load, modulus=modulus)
    reach = ahead * a
    return LubricatedContact(
        load=load,
        modulus=modulus,
        shape=Paraboloid(rolling_radius=radius, transverse_radius=radius / ellipticity),
        speed=relative * modulus * radius / viscosity,
        oil=Oil(viscosity=viscosity, pressure_viscosity=pressure_viscosity if thickening else 0.0, **oil),
        reach=Reach(ahead=reach, behind=reach, side=max(reach / ellipticity**0.5, 1.5 * b)),
    )
