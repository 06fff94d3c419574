"""Micro-slip of one contact by equations 2 to 7 of [Paper] exactly as printed, to show the effect of their misprints.

This is not a model; `analytic.sliding.long_ellipse.microslip_moments` is. A scene selects it with
[friction] microslip = "as_printed". The paper prints three cases. In the first and the last the names M_z (spin) and
M_r (rolling) are exchanged, and the first lacks its bracket of 0.322285. So both moments jump where the spin-to-roll
ratio is 0 and where it is 1/2.
Source: [Paper] equations 2 to 7. It does not print how the pure-rolling lines follow from the ratio; here they leave no
net force.
"""

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import NotNegative, Positive, formula
from analytic.sliding.long_ellipse import FULL_SPIN, Slip, half_distance, spin_to_roll


@formula
def as_printed_moments(
    friction_force: NotNegative, semi_axis_transverse: NotNegative, ball_radius: Positive, spin_to_roll: NotNegative
) -> tuple[float, float]:
    """(M_z, M_r), N m, under their names in the paper.

    friction_force : mu F_n, N, >= 0;  semi_axis_transverse : b, m, >= 0
    ball_radius : r_b, m, > 0, as equation 11 uses it; the corrected form has the radius of the contact surface instead
    spin_to_roll : eps, >= 0; the paper does not treat negative ones
        eps = 0:        M_z = mu F_n b^2/(4 r_b),  M_r = 0                                            (2, 3)
        0 < eps < 1/2:  M_z = (3/4) mu F_n b [g1^2 (1 - g1^2/2) - g2^2 (1 - g2^2/2)]                  (4)
                        M_r = mu F_n b^2/(4 r_b) [2/5 + g1^3 (1 - 3 g1^2/5) - g2^3 (1 - 3 g2^2/5)]    (5)
        eps >= 1/2:     M_z = 0,  M_r = 0.375 mu F_n b                                                (6, 7)
    """
    pull = friction_force * semi_axis_transverse
    curved = pull * semi_axis_transverse / (4 * ball_radius)
    if spin_to_roll == 0.0:
        return curved, 0.0
    if spin_to_roll >= FULL_SPIN:
        return 0.0, 0.375 * pull
    d = half_distance(spin_to_roll)
    g1, g2 = -spin_to_roll - d, -spin_to_roll + d
    spin_bracket = g1**2 * (1 - g1**2 / 2) - g2**2 * (1 - g2**2 / 2)
    roll_bracket = 2 / 5 + g1**3 * (1 - 3 * g1**2 / 5) - g2**3 * (1 - 3 * g2**2 / 5)
    return 0.75 * pull * spin_bracket, curved * roll_bracket


@compiled
def as_printed_slip(contact: ContactNumbers, slip: Slip, ball_radius: float) -> Slip:
    """The slip with the printed moments at its own spin and coefficient; ball_radius : r_b, m, > 0.

    Equations 10 and 11 then give spin = M_z,i |w_s,i|/w + M_z,o |w_s,o|/w and conformity = M_r,i w_roll,i/w + M_r,o
    w_roll,o/w for one ball. The paper does not say which contact has the M_z of equation 10, so each moment is
    multiplied by the spin of its own contact. Where no misprint applies, the torque differs from the derived one only
    by the ball's radius in place of that of the contact surface.
    """
    ratio = abs(spin_to_roll(contact, slip.spin_rate))
    force = slip.coefficient * contact.load
    spin, roll = as_printed_moments(force, contact.semi_axis_transverse, ball_radius, ratio)
    return Slip(slip.spin_rate, np.copysign(spin, slip.spin_rate), roll, slip.coefficient, slip.slip_speed, slip.creep)
