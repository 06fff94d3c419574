"""How large an effect can be that is left out, from load and kinematics alone.

Each is a closed form that costs nothing: a ratio to what is computed, or a torque. Infinite where nothing opposes it.
All arguments are magnitudes and broadcast.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_non_negative, require_positive
from analytic.scene import Array

STANDARD_GRAVITY = 9.80665  # m/s^2


def whirl_number(
    *, ball_speed: ArrayLike, ball_radius: ArrayLike, clearance: ArrayLike, gravity: ArrayLike = STANDARD_GRAVITY
) -> Array:
    """(w_b r)^2/(g nabla): centrifugal over gravitational force of a cage that rolls round in its pockets.

    ball_speed : w_b, rad/s, >= 0;  ball_radius : r, m, >= 0
    clearance : D_p - D_b, pocket less ball diameter, m, > 0; nabla is half of it;  gravity : g, m/s^2, >= 0
    Below 1 the cage cannot whirl and rests on its balls.
    """
    require_positive(clearance=clearance)
    require_non_negative(ball_speed=ball_speed, ball_radius=ball_radius, gravity=gravity)
    rim = np.asarray(ball_speed) * np.asarray(ball_radius)
    return _ratio(rim**2, np.asarray(gravity) * np.asarray(clearance) / 2)


def cage_rest_torque(
    *,
    friction_coefficient: ArrayLike,
    cage_mass: ArrayLike,
    ball_rate: ArrayLike,
    ball_radius: ArrayLike,
    gravity: ArrayLike = STANDARD_GRAVITY,
) -> Array:
    """mu m g (w_b/w) r, N m: torque of a cage whose whole weight rests on turning balls, slip power over ring speed.

    friction_coefficient : mu;  cage_mass : m, kg;  ball_rate : w_b/w;  ball_radius : r, m;  gravity : g, across the
        axis, m/s^2; all >= 0
    """
    require_non_negative(
        friction_coefficient=friction_coefficient,
        cage_mass=cage_mass,
        ball_rate=ball_rate,
        ball_radius=ball_radius,
        gravity=gravity,
    )
    friction = np.asarray(friction_coefficient) * np.asarray(cage_mass) * np.asarray(gravity)
    return np.asarray(friction * np.asarray(ball_rate) * np.asarray(ball_radius))


def _ratio(part: ArrayLike, whole: ArrayLike) -> Array:
    """0 where there is no part, infinite where there is one and no whole."""
    part, whole = np.broadcast_arrays(np.asarray(part, dtype=np.float64), np.asarray(whole, dtype=np.float64))
    return np.divide(part, whole, out=np.where(part > 0, np.inf, 0.0), where=whole > 0)
