"""Micro-slip of one contact by equations 2 to 7 of [Paper] exactly as printed, to show the effect of their misprints.

This is not a model; `analytic.sliding.long_ellipse.microslip_moments` is. A scene selects it with
[friction] microslip = "as_printed". The paper prints three cases. In the first and the last the names M_z (spin) and
M_r (rolling) are exchanged, and the first lacks its bracket of 0.322285. So both moments jump where the spin-to-roll
ratio is 0 and where it is 1/2.
Source: [Paper] equations 2 to 7. It does not print how the pure-rolling lines follow from the ratio; here they leave no
net force.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import Pair
from analytic.errors import require_non_negative, require_positive
from analytic.scene import Array
from analytic.sliding.long_ellipse import (
    FULL_SPIN,
    MicroslipTorque,
    pure_rolling_lines,
    spin_to_roll_ratio,
)


def as_printed_moments(
    *,
    friction_force: ArrayLike,
    semi_axis_transverse: ArrayLike,
    ball_radius: ArrayLike,
    spin_to_roll: ArrayLike,
) -> tuple[Array, Array]:
    """(M_z, M_r), N m, under their names in the paper; the arguments broadcast.

    friction_force : mu F_n, N, >= 0;  semi_axis_transverse : b, m, >= 0
    ball_radius : r_b, m, > 0, as equation 11 uses it; the corrected form has the radius of the contact surface instead
    spin_to_roll : eps, >= 0; the paper does not treat negative ones
        eps = 0:        M_z = mu F_n b^2/(4 r_b),  M_r = 0                                            (2, 3)
        0 < eps < 1/2:  M_z = (3/4) mu F_n b [g1^2 (1 - g1^2/2) - g2^2 (1 - g2^2/2)]                  (4)
                        M_r = mu F_n b^2/(4 r_b) [2/5 + g1^3 (1 - 3 g1^2/5) - g2^3 (1 - 3 g2^2/5)]    (5)
        eps >= 1/2:     M_z = 0,  M_r = 0.375 mu F_n b                                                (6, 7)
    """
    require_non_negative(
        friction_force=friction_force,
        semi_axis_transverse=semi_axis_transverse,
        spin_to_roll=spin_to_roll,
    )
    require_positive(ball_radius=ball_radius)
    ratio, half_length = np.asarray(spin_to_roll, dtype=np.float64), np.asarray(semi_axis_transverse)
    pull = np.asarray(friction_force) * half_length  # mu F_n b
    curved = pull * half_length / (4 * np.asarray(ball_radius))
    g1, g2 = pure_rolling_lines(np.minimum(ratio, FULL_SPIN))  # beyond it the lines are not used
    spin_bracket = g1**2 * (1 - g1**2 / 2) - g2**2 * (1 - g2**2 / 2)
    roll_bracket = 2 / 5 + g1**3 * (1 - 3 * g1**2 / 5) - g2**3 * (1 - 3 * g2**2 / 5)
    printed_z = np.where(ratio == 0, curved, np.where(ratio < FULL_SPIN, 0.75 * pull * spin_bracket, 0.0))
    printed_r = np.where(ratio == 0, 0.0, np.where(ratio < FULL_SPIN, curved * roll_bracket, 0.375 * pull))
    return printed_z, printed_r


def as_printed_torque(
    contacts: Pair,
    *,
    friction_force: tuple[ArrayLike, ArrayLike],
    spin_rates: tuple[ArrayLike, ArrayLike],
    ball_radius: ArrayLike,
) -> MicroslipTorque:
    """Torque of one ball from its slip on both races with the printed moments, N m; all fields and arguments broadcast.

    contacts : on the inner and the outer race;  friction_force : mu Q on both, N, >= 0
    spin_rates : w_s/w on both, of either sign, from `long_ellipse.microslip_torque`
    ball_radius : r_b, m, > 0
        spin = M_z,i |w_s,i|/w + M_z,o |w_s,o|/w,  conformity = M_r,i w_roll,i/w + M_r,o w_roll,o/w
    These are equations 10 and 11 for one ball. The paper does not say which contact has the M_z of equation 10, so each
    moment is multiplied by the spin of its own contact. Where no misprint applies, the torque differs from the derived
    one only by the ball's radius in place of that of the contact surface.
    Raises InputError for a ball_radius that is not positive.
    """
    inner_rate, outer_rate = (np.asarray(rate, dtype=np.float64) for rate in spin_rates)
    (inner_spin, inner_roll), (outer_spin, outer_roll) = (
        as_printed_moments(
            friction_force=force,
            semi_axis_transverse=contact.semi_axis_transverse,
            ball_radius=ball_radius,
            spin_to_roll=spin_to_roll_ratio(contact, spin_rate=np.abs(rate)),
        )
        for contact, force, rate in zip(contacts, friction_force, (inner_rate, outer_rate), strict=True)
    )
    return MicroslipTorque.of(
        contacts,
        spin_rates=(inner_rate, outer_rate),
        spin_moments=(np.copysign(inner_spin, inner_rate), np.copysign(outer_spin, outer_rate)),
        rolling_moments=(inner_roll, outer_roll),
    )
