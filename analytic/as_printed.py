"""Micro-slip of one contact by the paper's equations 2 to 7 exactly as printed, to show what their misprints do.

Never a model: `analytic.race.microslip_moments` is. Printed are three cases, and in the first and the last of them the
names M_z (spin) and M_r (rolling) are exchanged, and the first lacks its bracket of 0.322285. So both moments jump
where the spin-to-roll ratio is 0 and where it is 1/2.
Source: "Effect of Surface Roughness on the Friction Moment in a Ball Bearing", equations 2 to 7. It does not print how
the pure-rolling lines follow from the ratio; here they leave no net force.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_non_negative, require_positive
from analytic.race import FULL_SPIN, pure_rolling_lines
from analytic.scene import Array


def as_printed_moments(
    *,
    friction_coefficient: ArrayLike,
    load: ArrayLike,
    semi_axis_transverse: ArrayLike,
    ball_radius: ArrayLike,
    spin_to_roll: ArrayLike,
) -> tuple[Array, Array]:
    """(M_z, M_r), N m, by the names that the paper gives them; the arguments broadcast.

    friction_coefficient : mu, >= 0;  load : F_n, N, >= 0;  semi_axis_transverse : b, m, >= 0
    ball_radius : r_b, m, > 0, as equation 11 uses it; the corrected form has the radius of the contact surface here
    spin_to_roll : eps, >= 0: the paper says nothing of negative ones
        eps = 0:        M_z = mu F_n b^2/(4 r_b),  M_r = 0                                            (2, 3)
        0 < eps < 1/2:  M_z = (3/4) mu F_n b [g1^2 (1 - g1^2/2) - g2^2 (1 - g2^2/2)]                  (4)
                        M_r = mu F_n b^2/(4 r_b) [2/5 + g1^3 (1 - 3 g1^2/5) - g2^3 (1 - 3 g2^2/5)]    (5)
        eps >= 1/2:     M_z = 0,  M_r = 0.375 mu F_n b                                                (6, 7)
    """
    require_non_negative(
        friction_coefficient=friction_coefficient,
        load=load,
        semi_axis_transverse=semi_axis_transverse,
        spin_to_roll=spin_to_roll,
    )
    require_positive(ball_radius=ball_radius)
    ratio, half_length = np.asarray(spin_to_roll, dtype=np.float64), np.asarray(semi_axis_transverse)
    pull = np.asarray(friction_coefficient) * np.asarray(load) * half_length  # mu F_n b
    curved = pull * half_length / (4 * np.asarray(ball_radius))
    g1, g2 = pure_rolling_lines(ratio)
    spin_bracket = g1**2 * (1 - g1**2 / 2) - g2**2 * (1 - g2**2 / 2)
    roll_bracket = 2 / 5 + g1**3 * (1 - 3 * g1**2 / 5) - g2**3 * (1 - 3 * g2**2 / 5)
    printed_z = np.where(ratio == 0, curved, np.where(ratio < FULL_SPIN, 0.75 * pull * spin_bracket, 0.0))
    printed_r = np.where(ratio == 0, 0.0, np.where(ratio < FULL_SPIN, curved * roll_bracket, 0.375 * pull))
    return printed_z, printed_r
