"""How large an effect can be that is left out, from load and kinematics alone.

Each is a closed form that costs nothing: a ratio to what is computed, or a torque. Infinite where nothing opposes it.
All arguments are magnitudes and broadcast.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.scene import Array


def load_distribution_ratio(
    *,
    axial_load: ArrayLike,
    radial_load: ArrayLike,
    moment: ArrayLike,
    contact_angle: ArrayLike,
    pitch_diameter: ArrayLike,
) -> Array:
    """(Fr tan(al) + 2 M/d_m)/Fa: how unequal radial load and moment make balls that thrust loads alike.

    axial_load, radial_load : Fa, Fr, N;  moment : M, N m;  contact_angle : al, under the thrust, rad, 0 to pi/2
    pitch_diameter : d_m, m, > 0
    """
    require_positive(pitch_diameter=pitch_diameter)
    require_non_negative(axial_load=axial_load, radial_load=radial_load, moment=moment, contact_angle=contact_angle)
    other = np.asarray(radial_load) * np.tan(contact_angle) + 2 * np.asarray(moment) / np.asarray(pitch_diameter)
    return _ratio(other, axial_load)


def centrifugal_ratio(
    *, ball_mass: ArrayLike, pitch_diameter: ArrayLike, cage_speed: ArrayLike, load: ArrayLike
) -> Array:
    """m_b r_m w_c^2/Q: centrifugal force of a ball over its load on the race.

    ball_mass : m_b, kg;  pitch_diameter : d_m = 2 r_m, m;  cage_speed : w_c, rad/s;  load : Q, N; all >= 0
    """
    require_non_negative(ball_mass=ball_mass, pitch_diameter=pitch_diameter, cage_speed=cage_speed, load=load)
    force = np.asarray(ball_mass) * np.asarray(pitch_diameter) / 2 * np.asarray(cage_speed) ** 2
    return _ratio(force, load)


def gyroscopic_pull(
    *,
    ball_mass: ArrayLike,
    ball_radius: ArrayLike,
    ball_speed: ArrayLike,
    cage_speed: ArrayLike,
    contact_angle: ArrayLike,
    load: ArrayLike,
) -> Array:
    """J w_b w_c cos(al)/(r Q): the axial pull of the friction that holds the gyroscopic moment, over a ball's thrust.

    ball_mass : m_b, kg;  ball_radius : r, m, > 0; J = (2/5) m_b r^2;  ball_speed, cage_speed : w_b, w_c, rad/s
    contact_angle : al, rad, 0 to pi/2;  load : Q, N; all >= 0
    The moment J w_b w_c sin(al) takes a force across the groove of that over r, whose axial part cos(al) adds to the
    thrust Q sin(al). It moves loads and angles; whether the ball slides is `gyroscopic_slip_ratio`.
    """
    require_positive(ball_radius=ball_radius)
    require_non_negative(
        ball_mass=ball_mass, ball_speed=ball_speed, cage_speed=cage_speed, contact_angle=contact_angle, load=load
    )
    inertia = 2 / 5 * np.asarray(ball_mass) * np.asarray(ball_radius) ** 2
    moment = inertia * np.asarray(ball_speed) * np.asarray(cage_speed)
    return _ratio(moment * np.cos(contact_angle) / np.asarray(ball_radius), load)


def gyroscopic_slip_ratio(
    *,
    ball_mass: ArrayLike,
    ball_radius: ArrayLike,
    ball_speed: ArrayLike,
    cage_speed: ArrayLike,
    contact_angle: ArrayLike,
    friction_force: ArrayLike,
) -> Array:
    """J w_b w_c sin(al)/(r F): gyroscopic moment of a ball over what friction across both grooves can hold.

    ball_mass : m_b, kg;  ball_radius : r, m; J = (2/5) m_b r^2;  ball_speed, cage_speed : w_b, w_c, rad/s
    contact_angle : al, the angle of w_b to the bearing axis, rad, 0 to pi/2
    friction_force : F, the sum of mu Q over both races, N; all >= 0
    The moment is about the direction of rolling, so that friction across the grooves carries it with the arm r; above 1
    the ball turns about that axis too. With the arm 3/8 b of spin's friction it would be some ten times as large.
    """
    require_non_negative(friction_force=friction_force)
    moment = _gyroscopic_moment(ball_mass, ball_radius, ball_speed, cage_speed, contact_angle)
    return _ratio(moment, np.asarray(friction_force) * np.asarray(ball_radius))


def _gyroscopic_moment(
    ball_mass: ArrayLike, ball_radius: ArrayLike, ball_speed: ArrayLike, cage_speed: ArrayLike, contact_angle: ArrayLike
) -> Array:
    """J w_b w_c sin(al), N m."""
    require_non_negative(
        ball_mass=ball_mass,
        ball_radius=ball_radius,
        ball_speed=ball_speed,
        cage_speed=cage_speed,
        contact_angle=contact_angle,
    )
    if np.any(np.asarray(contact_angle) > np.pi / 2):
        raise InputError(
            f"contact_angle must be at most pi/2 rad, got {float(np.max(contact_angle))!r}; is it in degrees?"
        )
    inertia = 2 / 5 * np.asarray(ball_mass) * np.asarray(ball_radius) ** 2
    return inertia * np.asarray(ball_speed) * np.asarray(cage_speed) * np.sin(np.asarray(contact_angle))


def _ratio(part: ArrayLike, whole: ArrayLike) -> Array:
    """0 where there is no part, infinite where there is one and no whole."""
    part, whole = np.broadcast_arrays(np.asarray(part, dtype=np.float64), np.asarray(whole, dtype=np.float64))
    return np.divide(part, whole, out=np.where(part > 0, np.inf, 0.0), where=whole > 0)
