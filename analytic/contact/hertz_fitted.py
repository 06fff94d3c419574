"""Hertz point contact by the fitted formulas of text books: no elliptic integral, no iteration.

Assumptions, axes and signs are those of `analytic.contact.hertz`.
Source: [Brewe1977], with the elongation of [Hamrock1983], as many text books print them.
"""

import numpy as np

from analytic.contact.hertz import HertzContact
from analytic.numerics.elements import NotNegative, Positive, formula

# Curvature ratios, and for each a bound on the relative error: 5 to 33 % above the errors observed near it.
RATIOS = np.array([1.0, 1.3, 2.0, 3.0, 8.0, 14.0, 30.0, 36.0, 100.0, 1e3, 1e4, 1e5])
ERRORS = np.array([0.0, 0.0165, 0.026, 0.029, 0.0285, 0.026, 0.0155, 0.0135, 0.0445, 0.138, 0.302, 0.52])


@formula
def hertz_contact_fitted(
    curvature_x: Positive, curvature_y: Positive, load: NotNegative, modulus: Positive
) -> HertzContact:
    """Size, pressure and approach of an elliptic contact, to a few per cent; arguments as hertz_contact.

    With alpha the larger over the smaller curvature and R = 1/(curvature_x + curvature_y):
        k = alpha^(2/pi),  E = 1 + (pi/2 - 1)/alpha,  K = pi/2 + (pi/2 - 1) ln alpha
        major^3 = 3 k^2 E Q R/(pi E*),  minor = major/k
        p0 = 3 Q/(2 pi major minor),  delta = 3 Q K/(2 pi E* major)
    Errors in per cent against hertz_contact, at curvature ratios from 1 (exact) to 100: minor semi-axis -1.1 to +1.2,
    major -2.7 to +2.1, peak pressure -1.1 to +1.7, approach -4.2 to +2.7, stiffness -4.0 to +6.5.
    """
    ratio = max(curvature_x, curvature_y) / min(curvature_x, curvature_y)
    elongation = ratio ** (2 / np.pi)
    integral_e = 1 + (np.pi / 2 - 1) / ratio
    integral_k = np.pi / 2 + (np.pi / 2 - 1) * np.log(ratio)
    # Sizes at unit load times powers of the load: the stiffness stays finite and there is no 0/0 at zero load.
    root = np.cbrt(load)
    major = np.cbrt(3 * elongation**2 * integral_e / (np.pi * modulus * (curvature_x + curvature_y)))
    minor = major / elongation
    approach = 3 * integral_k / (2 * np.pi * modulus * major)
    x_is_minor = curvature_x >= curvature_y
    return HertzContact(
        root * (minor if x_is_minor else major),
        root * (major if x_is_minor else minor),
        root * 3 / (2 * np.pi * major * minor),
        root**2 * approach,
        approach**-1.5,
    )


@formula
def fitted_error(curvature_x: Positive, curvature_y: Positive) -> float:
    """Bound on the relative error of semi-axes, peak pressure and approach of `hertz_contact_fitted`.

    The bound depends on the ratio of the curvatures alone. It is an envelope of the errors against hertz_contact,
    linear in ln(ratio) between the knots. Beyond a ratio of 1e5 it is infinite: the fits were not compared there.
    """
    ratio = max(curvature_x, curvature_y) / min(curvature_x, curvature_y)
    return np.interp(np.log(ratio), np.log(RATIOS), ERRORS) if ratio <= RATIOS[-1] else np.inf
