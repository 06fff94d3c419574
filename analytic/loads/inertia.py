"""Inertia of the balls: centrifugal force and gyroscopic moment, and how large they are beside the loads.

Arguments of the formulas broadcast. The speeds of a ball come from `analytic.loads.kinematics`.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_non_negative, require_positive
from analytic.loads.kinematics import ball_kinematics, ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.scene import Array, Bearing


@compiled
def outward_force(ball_mass: float, pitch_diameter: float, cage_speed: float) -> float:
    """F_c = m (d_m/2) w_m^2, N."""
    return ball_mass * pitch_diameter / 2 * cage_speed**2


@compiled
def moment_of_turned_axis(
    ball_mass: float, ball_diameter: float, ball_speed: float, cage_speed: float, axis_angle: float
) -> float:
    """M_g = J w_b w_m sin(axis_angle), J = m D^2/10, N m."""
    return ball_mass * ball_diameter**2 / 10 * ball_speed * cage_speed * np.sin(axis_angle)


@compiled
def inertia_of_ball(
    bearing: BearingNumbers, inner_speed: float, inner_angle: float, outer_angle: float
) -> tuple[float, float]:
    """(F_c, M_g) of a ball at its contact angles, N and N m; M_g has the sign of the ball's pitch.

    inner_speed : w, rad/s, any sign, the outer ring stands still
    inner_angle, outer_angle : al_i, al_o, rad, in [-pi/2, pi/2]
    """
    motion = ruled_motion(bearing, inner_speed, inner_angle, outer_angle)
    force = outward_force(bearing.ball_mass, bearing.pitch_diameter, motion.cage_speed)
    moment = moment_of_turned_axis(
        bearing.ball_mass, 2 * bearing.ball_radius, motion.ball_speed, motion.cage_speed, motion.pitch
    )
    return force, moment


def centrifugal_force(*, ball_mass: ArrayLike, pitch_diameter: ArrayLike, cage_speed: ArrayLike) -> Array:
    """F_c = m (d_m/2) w_m^2, outward, N.

    ball_mass : m, kg;  pitch_diameter : d_m, m;  cage_speed : w_m, rad/s, any sign
    """
    return mapped(outward_force, ball_mass, pitch_diameter, cage_speed)


def gyroscopic_moment(
    *,
    ball_mass: ArrayLike,
    ball_diameter: ArrayLike,
    ball_speed: ArrayLike,
    cage_speed: ArrayLike,
    axis_angle: ArrayLike,
) -> Array:
    """M_g = J w_b w_m sin(axis_angle), J = m D^2/10, about the direction of rolling, N m.

    ball_mass : m, kg;  ball_diameter : D, m;  ball_speed, cage_speed : w_b, w_m, rad/s, any sign
    axis_angle : of w_b to the bearing axis, rad, any sign
    """
    return mapped(moment_of_turned_axis, ball_mass, ball_diameter, ball_speed, cage_speed, axis_angle)


def centrifugal_ratio(
    *, ball_mass: ArrayLike, pitch_diameter: ArrayLike, cage_speed: ArrayLike, load: ArrayLike
) -> Array:
    """F_c/Q: centrifugal force of a ball over its load on the race; infinite without load.

    ball_mass : m, kg;  pitch_diameter : d_m, m;  cage_speed : w_m, rad/s;  load : Q, N; all >= 0
    """
    require_non_negative(ball_mass=ball_mass, pitch_diameter=pitch_diameter, cage_speed=cage_speed, load=load)
    return ratio(
        centrifugal_force(ball_mass=ball_mass, pitch_diameter=pitch_diameter, cage_speed=cage_speed), over=load
    )


def gyroscopic_pull(
    *,
    ball_mass: ArrayLike,
    ball_radius: ArrayLike,
    ball_speed: ArrayLike,
    cage_speed: ArrayLike,
    contact_angle: ArrayLike,
    load: ArrayLike,
) -> Array:
    """J w_b w_m cos(al)/(r Q): axial pull of the friction that holds the gyroscopic moment, over a ball's thrust.

    ball_mass : m, kg;  ball_radius : r, m, > 0;  ball_speed, cage_speed : w_b, w_m, rad/s
    contact_angle : al, rad, 0 to pi/2;  load : Q, N; all >= 0
    The moment is J w_b w_m sin(al) at most: a ball leans less. It needs a force across the groove of that over r. Its
    axial part, cos(al) of it, adds to the thrust Q sin(al). The pull changes loads and angles.
    """
    require_positive(ball_radius=ball_radius)
    require_non_negative(
        ball_mass=ball_mass, ball_speed=ball_speed, cage_speed=cage_speed, contact_angle=contact_angle, load=load
    )
    radius = np.asarray(ball_radius)
    upright = gyroscopic_moment(
        ball_mass=ball_mass,
        ball_diameter=2 * radius,
        ball_speed=ball_speed,
        cage_speed=cage_speed,
        axis_angle=np.pi / 2,
    )
    return ratio(upright * np.cos(contact_angle) / radius, over=load)


def inertia_ratios(bearing: Bearing, *, inner_speed: Array, contact_angle: Array, load: Array) -> tuple[Array, Array]:
    """(`centrifugal_ratio`, `gyroscopic_pull`) of a ball with one contact angle on both races, each (n,).

    inner_speed : w, rad/s, any sign, the outer ring stands still;  contact_angle : al, rad;  load : Q, N
    """
    motion = ball_kinematics(
        inner_speed=inner_speed,
        inner_angle=contact_angle,
        outer_angle=contact_angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    cage_speed = np.abs(motion.cage_speed)
    centrifugal = centrifugal_ratio(
        ball_mass=bearing.ball_mass, pitch_diameter=bearing.pitch_diameter, cage_speed=cage_speed, load=load
    )
    pull = gyroscopic_pull(
        ball_mass=bearing.ball_mass,
        ball_radius=bearing.ball_radius,
        ball_speed=np.abs(motion.ball_speed),
        cage_speed=cage_speed,
        contact_angle=contact_angle,
        load=load,
    )
    return centrifugal, pull


def ratio(part: ArrayLike, *, over: ArrayLike) -> Array:
    """part/over, both >= 0: 0 where the part is 0, infinite where only the part is not."""
    part, over = np.broadcast_arrays(np.asarray(part, dtype=np.float64), np.asarray(over, dtype=np.float64))
    return np.divide(part, over, out=np.where(part > 0, np.inf, 0.0), where=over > 0)
