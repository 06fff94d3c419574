"""How balls turn between their races, and the forces that come with it: what an equilibrium of loads needs to know.

`RuledTurning` has closed kinematics: the axis of a ball follows a rule, and friction across the grooves carries the
gyroscopic moment, on each race in proportion to its load. `analytic.free_ball` finds the axis by mechanics instead.
Directions across the grooves: t_i = (sin al_i, -cos al_i) and t_o = (-sin al_o, cos al_o), radial and axial.
"""

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from analytic.contact.hertz import HertzContact
from analytic.loads.inertia import force_and_moment
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.scene import Array, Bearing


@dataclass(frozen=True, kw_only=True, eq=False)
class PlacedBalls:
    """Balls between their races in one round of an equilibrium; arrays (k, ...) of one shape, contacts too."""

    points: NDArray[np.intp]  # (k,) the operating points that the rows belong to
    inner_angle: Array  # al_i, rad, in [-pi/2, pi/2]
    outer_angle: Array  # al_o
    inner_load: Array  # Q_i, N
    outer_load: Array  # Q_o
    inner: HertzContact  # under 1 N
    outer: HertzContact


@dataclass(frozen=True, kw_only=True, eq=False)
class TurningForces:
    """What acts on the balls because they turn; arrays of the balls' shape."""

    centrifugal: Array  # F_c, outward, N
    inner_friction: Array  # F_t,i of the inner race along t_i, N
    outer_friction: Array  # F_t,o of the outer race along t_o, N
    gyroscopic: Array  # M_g that friction carries, N m, with the sign of the contact angle


class Turning(Protocol):
    """How the balls of n operating points turn."""

    accuracy: float  # relative, of the forces: rounds of an equilibrium need not go below

    def forces(self, balls: PlacedBalls) -> TurningForces: ...

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        """Speeds per unit ring speed of balls at their angles, (n, ...)."""
        ...


@dataclass(frozen=True, kw_only=True, eq=False)
class RuledTurning:
    """By closed kinematics at the pitch of outer control."""

    bearing: Bearing
    inner_speed: Array  # (n,) w, rad/s, of any sign; the outer ring stands still
    centrifugal: bool
    gyroscopic: bool
    accuracy = 0.0  # closed forms

    def forces(self, balls: PlacedBalls) -> TurningForces:
        speed = self.inner_speed[balls.points]
        if not ((self.centrifugal or self.gyroscopic) and speed.any()):
            nothing = np.zeros_like(balls.inner_angle)
            return TurningForces(
                centrifugal=nothing, inner_friction=nothing, outer_friction=nothing, gyroscopic=nothing
            )
        force, moment = force_and_moment(
            self.bearing,
            inner_speed=speed.reshape(-1, *(1,) * (balls.inner_angle.ndim - 1)),
            inner_angle=balls.inner_angle,
            outer_angle=balls.outer_angle,
        )
        moment = self.gyroscopic * moment
        both = balls.inner_load + balls.outer_load
        per_load = -np.divide(moment / self.bearing.ball_radius, both, out=np.zeros_like(both), where=both > 0)
        return TurningForces(
            centrifugal=self.centrifugal * force,
            inner_friction=per_load * balls.inner_load,
            outer_friction=per_load * balls.outer_load,
            gyroscopic=moment,
        )

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        return ball_kinematics(
            inner_speed=1.0,
            inner_angle=inner_angle,
            outer_angle=outer_angle,
            pitch_diameter=self.bearing.pitch_diameter,
            ball_diameter=self.bearing.ball_diameter,
        )
