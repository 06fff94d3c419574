"""Sliding without integrals over the contacts: torque per newton of friction, and how wrong a mean stress can be.

For decisions before anything slides. Arrays (2, n, m): races, operating points, balls.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.hertz import elliptic_integrals
from analytic.contact.rolling_contact import RollingContact
from analytic.loads.balls import LoadedBalls
from analytic.numerics.compilation import compiled, rows_of
from analytic.scene import Array, Lubricant
from analytic.sliding.long_ellipse import microslip_moments

EVEN_STRESS = 0.182  # error of a mean stress, relative to the true power, where the stress does not follow the pressure
# The same for sinh traction, for decisions before anything slides. The largest observed errors are 0.87, at a few N in
# thin oil that pressure thickens steeply, and 0.69 on the scenes of the benchmark.
MOST_UNEVEN = 0.9
# Times E(m) - 1; the largest observed factor is 1.11, for any shape, with both contacts together.
BELOW_FULL_SPIN = 1.15
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
    a, b = balls.contact.semi_axis_x, balls.contact.semi_axis_y
    (shorter,), shape = rows_of(np.minimum(np.divide(a, b, out=np.zeros_like(b), where=b > 0), 1.0))
    return BELOW_FULL_SPIN * _over_a_line(shorter).reshape(shape)


@compiled
def _over_a_line(ratio: Array) -> Array:
    """E(m) - 1 = K - m D - 1 at m = 1 - ratio^2: 0 at 0, the line."""
    excess = np.zeros_like(ratio)
    for i in range(ratio.size):
        if ratio[i] > 0.0:
            integral, share = elliptic_integrals(ratio[i] ** 2)
            excess[i] = integral * (1 - (1 - ratio[i] ** 2) * share) - 1
    return excess


def creep_numbers(
    contacts: RollingContact, *, friction_coefficient: ArrayLike, entrainment_speed: ArrayLike, spin_rate: ArrayLike
) -> tuple[Array, Array]:
    """(K by conformity, K by spin): slip at a contact's end over the slip s_c at which elastic creep saturates.

    contacts : with pressures by Hertz;  friction_coefficient : mu, >= 0;  entrainment_speed : u/w, m
    spin_rate : w_s/w;  all broadcast
        s_c = 32 mu p0 u/(3 pi^2 E*),  K = w_roll b^2/(2 R s_c),  K = w_s b/s_c
    Both are infinite without friction. Elastic creep changes the torque by sliding by about 1/K and 3/K.
    Source: derived here, from the flexibility of a long ellipse [Kalker1982].
    """
    peak = 1.5 * contacts.mean_pressure
    saturated = (
        32 / (3 * np.pi**2) * np.asarray(friction_coefficient) * peak * np.asarray(entrainment_speed) / contacts.modulus
    )
    b = np.asarray(contacts.semi_axis_transverse)
    rolled = np.asarray(contacts.rolling_rate) * b**2 / (2 * np.asarray(contacts.deformed_radius))
    spun = np.asarray(spin_rate) * b
    shape = np.broadcast_shapes(saturated.shape, rolled.shape, spun.shape)
    infinite = np.full(shape, np.inf)
    by_conformity = np.divide(rolled, saturated, out=infinite.copy(), where=saturated > 0)
    return by_conformity, np.divide(spun, saturated, out=infinite, where=saturated > 0)
