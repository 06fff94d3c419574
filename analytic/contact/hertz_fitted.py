"""Hertz point contact by the fitted formulas of text books: no elliptic integral, no iteration.

Assumptions, axes and signs are those of `analytic.contact.hertz`.
Source: [Brewe1977], with the elongation of [Hamrock1983], as many text books print them.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.hertz import HertzContact, contact_arguments
from analytic.scene import Array

# Curvature ratios, and for each a bound on the relative error: 5 to 33 % above the errors observed near it.
RATIOS = (1.0, 1.3, 2.0, 3.0, 8.0, 14.0, 30.0, 36.0, 100.0, 1e3, 1e4, 1e5)
ERRORS = (0.0, 0.0165, 0.026, 0.029, 0.0285, 0.026, 0.0155, 0.0135, 0.0445, 0.138, 0.302, 0.52)


def hertz_contact_fitted(
    *, curvature_x: ArrayLike, curvature_y: ArrayLike, load: ArrayLike, modulus: ArrayLike
) -> HertzContact:
    """Size, pressure and approach of an elliptic contact, to a few per cent; arguments as hertz_contact.

    With alpha the larger over the smaller curvature and R = 1/(curvature_x + curvature_y):
        k = alpha^(2/pi),  E = 1 + (pi/2 - 1)/alpha,  K = pi/2 + (pi/2 - 1) ln alpha
        major^3 = 3 k^2 E Q R/(pi E*),  minor = major/k
        p0 = 3 Q/(2 pi major minor),  delta = 3 Q K/(2 pi E* major)
    Errors in per cent against hertz_contact, at curvature ratios from 1 (exact) to 100: minor semi-axis -1.1 to +1.2,
    major -2.7 to +2.1, peak pressure -1.1 to +1.7, approach -4.2 to +2.7, stiffness -4.0 to +6.5.
    Raises InputError as hertz_contact does.
    """
    rolling, transverse, force, stiff = contact_arguments(
        curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus
    )
    ratio = np.maximum(rolling, transverse) / np.minimum(rolling, transverse)
    elongation = ratio ** (2 / np.pi)
    integral_e = 1 + (np.pi / 2 - 1) / ratio
    integral_k = np.pi / 2 + (np.pi / 2 - 1) * np.log(ratio)

    # Sizes at unit load times powers of the load: the stiffness stays finite and there is no 0/0 at zero load.
    root = np.cbrt(force)
    major = np.cbrt(3 * elongation**2 * integral_e / (np.pi * stiff * (rolling + transverse)))
    minor = major / elongation
    approach = 3 * integral_k / (2 * np.pi * stiff * major)
    x_is_minor = rolling >= transverse
    return HertzContact(
        semi_axis_x=root * np.where(x_is_minor, minor, major),
        semi_axis_y=root * np.where(x_is_minor, major, minor),
        peak_pressure=root * 3 / (2 * np.pi * major * minor),
        approach=root**2 * approach,
        stiffness=approach**-1.5,
    )


def fitted_error(*, curvature_x: ArrayLike, curvature_y: ArrayLike) -> Array:
    """Bound on the relative error of semi-axes, peak pressure and approach of `hertz_contact_fitted`; broadcasts.

    The bound depends on the ratio of the curvatures alone. It is an envelope of the errors against hertz_contact,
    linear in ln(ratio) between the knots. Beyond a ratio of 1e5 it is infinite: the fits were not compared there.
    """
    ratio = np.maximum(curvature_x, curvature_y) / np.minimum(curvature_x, curvature_y)
    return np.interp(np.log(ratio), np.log(RATIOS), ERRORS, right=np.inf)
