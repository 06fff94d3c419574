"""Friction of an oil between rolling discs, to compare with a traction test."""

from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.oil.traction import oil_shear_stress
from analytic.oil.viscosity import oil_numbers
from analytic.scene import Array, Lubricant
from analytic.scenefile.parts import lubricant

NODES = 48  # of Gauss in the contact; half as many change the coefficient by less than 1e-5


def traction_coefficient(
    oil: Lubricant | str,
    *,
    pressure: ArrayLike,
    speed: ArrayLike,
    slip: ArrayLike,
    film: ArrayLike,
    temperature: float,
    contact: Literal["line", "point"] = "point",
) -> Array:
    """Traction coefficient of smooth rolling contacts, as twin discs or a ball on a disc measure it.

    Parameters
    ----------
    oil : Lubricant or str
        Or its name in the catalog, as "ISO VG 46".
    pressure : array_like
        Hertz pressure, the largest in the contact, Pa, > 0.
    speed : array_like
        Rolling speed, the mean of both surfaces, m/s, > 0.
    slip : array_like
        Slide-roll ratio, sliding speed over rolling speed, dimensionless; traction has its sign.
    film : array_like
        Film thickness in the contact, m, > 0.
    temperature : float
        Of the oil in the contact, K.
    contact : {"point", "line"}
        Whether the pressure is a semi-ellipsoid or the semi-ellipse of a line contact.

    Returns
    -------
    ndarray
        Tangential over normal force, dimensionless, of the shape to which the arguments broadcast.

    Raises
    ------
    InputError
        An argument is out of its range, the shapes do not fit, or the oil is unknown.

    Notes
    -----
    The stress of `analytic.oil.traction.oil_shear_stress` at the pressure of each point, over the contact. Asperities,
    elastic creep and the heat of sliding within the film are left out: compare at lambda above 3 and at slip beyond
    that of the steep rise; heating lowers the measured traction at fast sliding. Source of the law: [Arana2019].
    """
    require_positive(pressure=pressure, speed=speed, film=film)
    require_non_negative(slip=np.abs(slip))
    if contact not in ("line", "point"):
        raise InputError(f'contact must be "point" or "line", got {contact!r}')
    known = lubricant(oil, temperature=temperature) if isinstance(oil, str) else replace(oil, temperature=temperature)
    root, weight = np.polynomial.legendre.leggauss(NODES)
    angle, weight = (root + 1) * np.pi / 4, weight * np.pi / 4
    share = np.cos(angle)  # of the Hertz pressure, at the distance sin(angle) from the middle
    area = share * weight if contact == "line" else 2 * share * np.sin(angle) * weight
    peak, rolling, ratio, thickness = (np.asarray(each, float)[..., None] for each in (pressure, speed, slip, film))
    stress = oil_shear_stress(oil_numbers(known), peak * share, np.abs(ratio) * rolling, thickness)
    return np.sign(slip) * (stress @ area) / (np.asarray(pressure) * (share @ area))
