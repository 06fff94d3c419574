"""Sliding without integrals over the contacts: torque per newton of friction, and how wrong a mean stress can be.

For decisions before anything slides. Arrays (2, n, m): races, operating points, balls.
"""

import numpy as np

from analytic.loads.balls import LoadedBalls
from analytic.numerics.compilation import compiled, rows_of
from analytic.scene import Array, Lubricant
from analytic.sliding.judge import error_of_long_ellipse
from analytic.sliding.long_ellipse import microslip_moments

EVEN_STRESS = 0.182  # error of a mean stress, relative to the true power, where the stress does not follow the pressure
# The same for sinh traction, for decisions before anything slides. The largest observed errors are 0.87, at a few N in
# thin oil that pressure thickens steeply, and 0.69 on the scenes of the benchmark.
MOST_UNEVEN = 0.9
SPIN_STIFFNESS = 0.9163  # d(M_spin/mu Q b)/d eps at eps = 0, its largest value; see analytic.sliding.long_ellipse


def rolling_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) torque by conformity without spin per N of friction force, m: 0.0806 b^2/R w_roll/w."""
    contacts = balls.contacts
    _, moment = microslip_moments(
        friction_force=1.0,
        semi_axis_transverse=contacts.semi_axis_transverse,
        deformed_radius=contacts.deformed_radius,
        spin_to_roll=0.0,
    )
    return moment * contacts.rolling_rate


def full_spin_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) 3/8 b w_s/w, m: torque per N of friction force on a race that takes all spin and does not roll."""
    return 3 / 8 * balls.contacts.semi_axis_transverse * np.abs(balls.motion.spin_difference)


def largest_spin_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) bound on the torque that all spin adds on one race per N of Coulomb friction, m.

    The spin moment grows from 0 to at most 3/8 mu Q b, and its slope is largest at 0. The slip power is the integral of
    the moment over the spin: at most 0.458 eps b w_s/w, and at most 3/8 b w_s/w.
    """
    spin = np.abs(balls.motion.spin_difference)
    ratio = spin * balls.contacts.deformed_radius / balls.contacts.rolling_rate  # eps b, m
    return np.minimum(SPIN_STIFFNESS / 2 * ratio * spin, full_spin_lever(balls))


def largest_error(balls: LoadedBalls, lubricant: Lubricant | None) -> Array:
    """(2, n, m) largest torque by sliding that was observed over that of mean stresses on a long ellipse, less 1."""
    uneven = {"eyring_sinh": MOST_UNEVEN, "eyring_constant": EVEN_STRESS}[lubricant.traction] if lubricant else 0.0
    return (1 + long_ellipse_error(balls)) / (1 - uneven) - 1


def long_ellipse_error(balls: LoadedBalls) -> Array:
    """(2, n, m) error of a long ellipse relative to the true power; at most that of a circle, also where a > b."""
    rows, shape = rows_of(balls.contact.semi_axis_x, balls.contact.semi_axis_y)
    return _errors(rows).reshape(shape)


@compiled
def _errors(rows: Array) -> Array:
    errors = np.empty(rows.shape[1])
    for i in range(errors.size):
        errors[i] = error_of_long_ellipse(rows[0, i], rows[1, i])
    return errors
