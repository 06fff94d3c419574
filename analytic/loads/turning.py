"""How balls turn between their races, and the forces that come with it: what an equilibrium of loads needs to know.

`RuledTurning` has closed kinematics: the axis of a ball follows a rule, and friction across the grooves carries the
gyroscopic moment, on each race in proportion to its load and at most as large as that. `analytic.free_ball` finds the
axis by mechanics instead.
Directions across the grooves: t_i = (sin al_i, -cos al_i) and t_o = (-sin al_o, cos al_o), radial and axial.
"""

from dataclasses import dataclass
from typing import NamedTuple

from analytic.loads.inertia import inertia_of_ball
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled
from analytic.scene import Array, Bearing


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


@dataclass(frozen=True, kw_only=True, eq=False)
class RuledTurning:
    """Balls that turn by closed kinematics, at the pitch of outer control."""

    bearing: Bearing
    inner_speed: Array  # (n,) w, rad/s, of any sign; the outer ring stands still
    centrifugal: bool  # whether the force counts
    gyroscopic: bool  # whether the moment counts

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        """The speeds of the balls for 1 rad/s of the inner ring.

        Parameters
        ----------
        inner_angle, outer_angle : ndarray
            Contact angles, rad, (n, m), in [-pi/2, pi/2].

        Returns
        -------
        BallKinematics
            Speeds over that of the inner ring, each (n, m).

        Notes
        -----
        Source: [Harris2007]; `analytic.loads.kinematics.ball_kinematics` has the formulas.
        """
        return ball_kinematics(
            inner_speed=1.0,
            inner_angle=inner_angle,
            outer_angle=outer_angle,
            pitch_diameter=self.bearing.pitch_diameter,
            ball_diameter=self.bearing.ball_diameter,
        )
