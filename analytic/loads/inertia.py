"""Inertia of the balls: centrifugal force and gyroscopic moment.

The speeds of a ball come from `analytic.loads.kinematics`.
"""

import numpy as np

from analytic.loads.kinematics import ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled


@compiled
def outward_force(ball_mass: float, pitch_diameter: float, cage_speed: float) -> float:
    """F_c = m (d_m/2) w_m^2, outward, N.

    ball_mass : m, kg;  pitch_diameter : d_m, m;  cage_speed : w_m, rad/s, any sign
    """
    return ball_mass * pitch_diameter / 2 * cage_speed**2


@compiled
def moment_of_turned_axis(
    ball_mass: float, ball_diameter: float, ball_speed: float, cage_speed: float, axis_angle: float
) -> float:
    """M_g = J w_b w_m sin(axis_angle), J = m D^2/10, about the direction of rolling, N m.

    ball_mass : m, kg;  ball_diameter : D, m;  ball_speed, cage_speed : w_b, w_m, rad/s, any sign
    axis_angle : of w_b to the bearing axis, rad, any sign
    """
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
