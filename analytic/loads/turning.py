"""How balls turn between their races, and the forces that come with it: what an equilibrium of loads needs to know.

`RuledTurning` has closed kinematics: the axis of a ball follows a rule, and friction across the grooves carries the
gyroscopic moment, on each race in proportion to its load. `analytic.free_ball` finds the axis by mechanics instead.
Directions across the grooves: t_i = (sin al_i, -cos al_i) and t_o = (-sin al_o, cos al_o), radial and axial.
"""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from analytic.contact.hertz import HertzContact
from analytic.loads.inertia import inertia_of_ball
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.numbers import BearingNumbers, bearing_numbers
from analytic.numerics.compilation import compiled, rows_of
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


class TurningRule(NamedTuple):
    """How a ball turns by closed kinematics, in numbers."""

    inner_speed: float  # w, rad/s, of any sign; the outer ring stands still
    centrifugal: bool  # whether its force counts
    gyroscopic: bool  # whether its moment counts


class ForcesOfTurning(NamedTuple):
    """`TurningForces` on one ball in numbers, for compiled formulas."""

    centrifugal: float
    inner_friction: float
    outer_friction: float
    gyroscopic: float


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
    both = loads[0] + loads[1]
    per_load = -moment / bearing.ball_radius / both if both > 0 else 0.0
    return ForcesOfTurning(force if rule.centrifugal else 0.0, per_load * loads[0], per_load * loads[1], moment)


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
        speed = self.inner_speed[balls.points].reshape(-1, *(1,) * (balls.inner_angle.ndim - 1))
        rows, shape = rows_of(speed, balls.inner_angle, balls.outer_angle, balls.inner_load, balls.outer_load)
        forces = _ruled_forces(bearing_numbers(self.bearing), rows, self.centrifugal, self.gyroscopic)
        return TurningForces(**dict(zip(ForcesOfTurning._fields, forces.reshape(-1, *shape), strict=True)))

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        return ball_kinematics(
            inner_speed=1.0,
            inner_angle=inner_angle,
            outer_angle=outer_angle,
            pitch_diameter=self.bearing.pitch_diameter,
            ball_diameter=self.bearing.ball_diameter,
        )


@compiled
def _ruled_forces(bearing: BearingNumbers, rows: Array, centrifugal: bool, gyroscopic: bool) -> Array:
    forces = np.empty((4, rows.shape[1]))
    for i in range(rows.shape[1]):
        rule = TurningRule(rows[0, i], centrifugal, gyroscopic)
        of_ball = ruled_forces(bearing, rule, (rows[1, i], rows[2, i]), (rows[3, i], rows[4, i]))
        for k in range(4):
            forces[k, i] = of_ball[k]
    return forces
