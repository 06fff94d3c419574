"""How balls turn between their races, and the forces that come with it: what an equilibrium of loads needs to know.

By rule the axis of a ball has the pitch of outer control, and friction across the grooves carries the gyroscopic
moment, on each race in proportion to its load and at most as large as that. `analytic.free_ball` finds the axis by
mechanics instead.
Directions across the grooves: t_i = (sin al_i, -cos al_i) and t_o = (-sin al_o, cos al_o), radial and axial.
"""

from typing import NamedTuple

from analytic.loads.inertia import inertia_of_ball
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled


class Inertia(NamedTuple):
    """What counts of a ball's inertia."""

    centrifugal: bool = True  # force
    gyroscopic: bool = True  # moment


WHOLE_INERTIA = Inertia()


class TurningRule(NamedTuple):
    """How a ball turns by closed kinematics, in numbers."""

    inner_speed: float  # w, rad/s, of any sign; the outer ring stands still
    centrifugal: bool  # whether its force counts
    gyroscopic: bool  # whether its moment counts


class ForcesOfTurning(NamedTuple):
    """What acts on a ball because it turns, N and N m."""

    centrifugal: float  # F_c, outward
    inner_friction: float  # F_t,i of the inner race along t_i
    outer_friction: float  # F_t,o of the outer race along t_o
    gyroscopic: float  # M_g that friction carries, with the sign of the contact angle


@compiled
def ruled_forces(
    bearing: BearingNumbers, rule: TurningRule, angles: tuple[float, float], loads: tuple[float, float]
) -> ForcesOfTurning:
    """What acts on a ball that turns at the pitch of outer control.

    angles : al_i, al_o, rad, in [-pi/2, pi/2];  loads : Q_i, Q_o, N
    """
    if rule.inner_speed == 0 or not (rule.centrifugal or rule.gyroscopic):
        return ForcesOfTurning(0.0, 0.0, 0.0, 0.0)
    force, moment = inertia_of_ball(bearing, rule.inner_speed, angles[0], angles[1])
    if not rule.gyroscopic:
        moment = 0.0
    pressing = max(loads[0] + loads[1], abs(moment) / bearing.ball_radius)  # a lighter ball slips
    per_load = -moment / bearing.ball_radius / pressing if pressing > 0 else 0.0
    return ForcesOfTurning(force if rule.centrifugal else 0.0, per_load * loads[0], per_load * loads[1], moment)
