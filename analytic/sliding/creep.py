"""How much of the sliding elastic creep of the surfaces can change, before any of it is solved for."""

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.oil.traction import PointLaw, mean_force
from analytic.sliding.long_ellipse import half_distance, rolling_moment

# Change of the torque by sliding that elastic creep makes, over 1/K of spin and of conformity. With one flexibility it
# was 4.0 and 0.8 at most in 150 scenes with angles of 0.05 to 0.75 rad and friction of 0.005 to 0.3. With two it is up
# to 1.4 times that in the six points of docs/balls.md.
PER_SPIN_CREEP, PER_ROLL_CREEP = 6.3, 1.4
MOST_SHARE = 1e9


@compiled
def creep_numbers(contact: ContactNumbers, friction: float, spin_rate: float) -> tuple[float, float]:
    """(K by conformity, K by spin): slip at a contact's end over the slip s_c at which elastic creep saturates.

    friction : mu Q, N;  spin_rate : |w_s|/w
        s_c = 32 mu p0 u/(3 pi^2 E*),  K = w_roll b^2/(2 R s_c),  K = w_s b/s_c
    Both are infinite without friction. Elastic creep changes the torque by sliding by about 1/K and 3/K.
    Source: derived here, from the flexibility of a long ellipse [Kalker1982].
    """
    a, b = contact.semi_axis_rolling, contact.semi_axis_transverse
    peak = 1.5 / (np.pi * a * b)  # of 1 N
    saturated = 32 / (3 * np.pi**2) * friction * peak * contact.entrainment / contact.modulus
    if not saturated > 0.0:
        return np.inf, np.inf
    return contact.rolling_rate * b**2 / (2 * contact.deformed_radius) / saturated, spin_rate * b / saturated


@compiled
def creep_share(contact: ContactNumbers, law: PointLaw, ring_speed: float, spin_rate: float) -> float:
    """Estimate of the share of sliding that creep changes on one contact; infinite from 1 on, 0 without load.

    ring_speed : |w|, rad/s;  spin_rate : |w_s,i - w_s,o|/w
    The friction is the larger one of a contact that only rolls and of one that takes all spin.
    """
    if not contact.load > 0.0:
        return 0.0
    b = contact.semi_axis_transverse
    rolls = b**2 / contact.deformed_radius * rolling_moment(0.0, half_distance(0.0)) * contact.rolling_rate
    friction = mean_force(law, contact, ring_speed * rolls)
    friction = max(friction, mean_force(law, contact, ring_speed * (rolls + 3 / 8 * b * spin_rate)))
    sliding, spinning = creep_numbers(contact, friction, spin_rate)
    share = (PER_SPIN_CREEP / spinning if spinning > 0.0 else np.inf) + PER_ROLL_CREEP / sliding
    share = min(share, MOST_SHARE)
    return np.inf if share >= 1.0 else share
