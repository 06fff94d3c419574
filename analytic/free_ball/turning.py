"""A free ball in one round of an equilibrium, compiled: how it turns at its place, and what then acts on it.

Friction moves the contact angles, and these the friction; the centrifugal force moves the loads, and these drive the
ball round. Rounds alone converge slowly, or swing for ever where the inner race hardly presses a ball: the errors of
the last two give each ball a secant [Anderson1965].
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import HertzNumbers, loaded_hertz
from analytic.free_ball.kernel import turn_ball
from analytic.free_ball.layout import (
    ACROSS,
    BALL_RADIUS,
    BOUNDARY,
    CONTACT,
    FLEXIBILITY,
    INERTIA,
    LOAD,
    NORMAL_R,
    NORMAL_Z,
    ORBIT_RADIUS,
    RADIUS,
    RING,
    ROLLING,
    TRANSVERSE,
)
from analytic.free_ball.strips import Quadrature
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.loads.turning import ForcesOfTurning
from analytic.numerics.compilation import compiled
from analytic.scene import Array

ACCURACY = 1e-10  # of the residual force, over all friction of the ball
ENOUGH = 1e-7  # likewise, where round-off of stiff surfaces leaves no better
ROUGH = 1e-2  # likewise, on coarse nodes, for a start
MOST_MIXED, LEAST_MIXED = 0.9, 0.2  # of a secant's step, and of the error that a step has to remove at least


class FreeNumbers(NamedTuple):
    """What free balls see of their bearing besides its numbers."""

    orbit: float  # radius of the circle on which the outer groove's centre of curvature lies, m
    flexibility: tuple[float, float]  # L/a of inner and outer contact, 1/Pa
    centrifugal: bool  # whether the force counts
    gyroscopic: bool  # whether the moment counts


class BallRows(NamedTuple):
    """m free balls of one point; races are inner and outer."""

    velocity: Array  # (m, 4) v of `analytic.free_ball.rotation`, m per unit ring speed; NaN: not known
    contacts: Array  # (m, 2, CONTACT), with the laws of traction that a pass holds
    bodies: Array  # (m, BALL)
    outcomes: Array  # (m, 2, OUTCOME)
    motion: Array  # (m, 10) as `BallMotion`
    # Centrifugal force, and friction on both races, N: what the last round had, what came of it, and the difference
    given: Array  # (m, 3)
    gave: Array
    left: Array
    residual: Array  # (m,) of the rotation, over all friction


class FreeNodes(NamedTuple):
    """Of the quadratures of a pass, and how far its rounds go."""

    coarse: Quadrature  # for a start
    fine: Quadrature
    accuracy: float  # of the residual force of this round, or of the first one, over all friction of the ball
    steady: float  # relative, of the forces on a ball from one round to the next


class PlacedBall(NamedTuple):
    """A ball between its races in one round."""

    angles: tuple[float, float]  # al_i, al_o, rad, in [-pi/2, pi/2]
    loads: tuple[float, float]  # Q_i, Q_o, N
    inner: HertzNumbers  # under 1 N
    outer: HertzNumbers


@compiled
def turned(
    bearing: BearingNumbers,
    free: FreeNumbers,
    speed: float,
    placed: PlacedBall,
    balls: BallRows,
    j: int,
    nodes: FreeNodes,
) -> ForcesOfTurning:
    """What acts on ball j once it turns steadily, from where it turned last; writes its row.

    speed : w, rad/s
    """
    body, velocity, orbit = balls.bodies[j], balls.velocity[j], orbit_at(bearing, free, placed)
    inertia = 0.4 * bearing.ball_mass
    body[BALL_RADIUS], body[ORBIT_RADIUS] = bearing.ball_radius, orbit
    body[INERTIA] = inertia * speed**2 if free.gyroscopic else 0.0
    for race in range(2):
        unit, side = (placed.inner, -1.0) if race == 0 else (placed.outer, 1.0)
        hertz, row = loaded_hertz(unit, placed.loads[race]), balls.contacts[j, race]
        row[LOAD], row[ROLLING], row[TRANSVERSE] = placed.loads[race], hertz.semi_axis_x, hertz.semi_axis_y
        row[RADIUS] = bearing.inner.deformed_radius if race == 0 else bearing.outer.deformed_radius
        row[NORMAL_R], row[NORMAL_Z] = side * np.cos(placed.angles[race]), side * np.sin(placed.angles[race])
        row[RING], row[FLEXIBILITY] = 1.0 - race, free.flexibility[race]
    if np.isnan(velocity[0]):
        roll_by_rule(bearing, placed.angles, orbit, velocity)
    if np.isnan(balls.given[j, 0]):  # of this pass
        turn_ball(balls.contacts[j], body, velocity, nodes.coarse, ROUGH, balls.outcomes[j])
    balls.residual[j] = turn_ball(balls.contacts[j], body, velocity, nodes.fine, nodes.accuracy, balls.outcomes[j])
    rate = velocity[0] / orbit
    centrifugal = bearing.ball_mass * orbit * (rate * speed) ** 2 if free.centrifugal else 0.0
    _mix(balls, j, (centrifugal, balls.outcomes[j, 0, ACROSS], balls.outcomes[j, 1, ACROSS]))
    moment = inertia * bearing.ball_radius * speed**2 * rate * velocity[2] if free.gyroscopic else 0.0
    return ForcesOfTurning(balls.given[j, 0], balls.given[j, 1], balls.given[j, 2], moment)


@compiled
def orbit_at(bearing: BearingNumbers, free: FreeNumbers, placed: PlacedBall) -> float:
    """Radius of the ball's orbit, m."""
    outer_reach = bearing.outer.groove_radius - bearing.ball_radius
    outer_reach += placed.outer.approach * np.cbrt(placed.loads[1]) ** 2
    return free.orbit + outer_reach * np.cos(placed.angles[1])


@compiled
def roll_by_rule(bearing: BearingNumbers, angles: tuple[float, float], orbit: float, velocity: Array) -> None:
    """Write the velocity of a ball that rolls under outer control."""
    motion = ruled_motion(bearing, 1.0, angles[0], angles[1])
    velocity[0], velocity[1] = orbit * motion.cage_speed, 0.0
    velocity[2] = bearing.ball_radius * motion.ball_speed * np.sin(motion.pitch)
    velocity[3] = bearing.ball_radius * (motion.cage_speed - motion.ball_speed * np.cos(motion.pitch))


@compiled
def _mix(balls: BallRows, j: int, now: tuple[float, float, float]) -> None:
    """Write the forces on ball j for the next round; now : those that came of the last one, N."""
    given, gave, left = balls.given[j], balls.gave[j], balls.left[j]
    product = size = error = 0.0
    for k in range(3):
        change = now[k] - given[k] - left[k]
        product += (now[k] - given[k]) * change
        size += change * change
        error += (now[k] - given[k]) ** 2
    share = min(max(product / size, -MOST_MIXED), MOST_MIXED) if size > 0.0 else 0.0  # NaN in the first two rounds
    step = 0.0
    for k in range(3):
        step += (now[k] - share * (now[k] - gave[k]) - given[k]) ** 2
    # A step far shorter than the error would pass for the end of the rounds.
    mixes = step > LEAST_MIXED**2 * error and now[0] - share * (now[0] - gave[0]) >= 0.0
    for k in range(3):
        mixed = now[k] - share * (now[k] - gave[k]) if mixes else now[k]
        left[k] = now[k] - given[k]
        given[k], gave[k] = mixed, now[k]


@compiled
def free_motion(radius: float, angles: tuple[float, float], orbit: float, velocity: Array) -> BallMotion:
    """Speeds per unit ring speed of a ball; radius : r, m;  orbit : radius of its orbit, m."""
    orbit_rate = velocity[0] / orbit
    outward, axial = velocity[2] / radius, velocity[3] / radius - orbit_rate  # relative to the orbit
    inner = _rates(radius, orbit, (-np.cos(angles[0]), -np.sin(angles[0])), (outward, axial), 1.0 - orbit_rate)
    outer = _rates(radius, orbit, (np.cos(angles[1]), np.sin(angles[1])), (outward, axial), -orbit_rate)
    return BallMotion(
        orbit - radius * np.cos(angles[0]),
        orbit + radius * np.cos(angles[1]),
        orbit_rate,
        np.sqrt((velocity[1] / radius) ** 2 + outward**2 + axial**2),
        inner[0],
        outer[0],
        inner[1],
        outer[1],
        abs(inner[2] + outer[2]),
        np.arctan2(outward, -axial),
    )


@compiled
def _rates(
    radius: float, orbit: float, normal: tuple[float, float], turns: tuple[float, float], passes: float
) -> tuple[float, float, float]:
    """Entrainment, m, rolling rate and spin on a race, per unit ring speed.

    normal : out of the ball, radial and axial;  turns : of the ball, relative to its orbit, outward and axial
    passes : rate of the race, relative to the orbit
    """
    turn = turns[1] * normal[0] - turns[0] * normal[1]
    spin = turns[0] * normal[0] + turns[1] * normal[1]
    entrainment = abs(radius * turn + passes * (orbit + radius * normal[0])) / 2
    return entrainment, abs(turn - passes * normal[0]), spin - passes * normal[1]


@compiled
def hold_law(row: Array, law: tuple[float, ...], speed: float) -> None:
    """Write the law of traction of a contact; law : `PointLaw`;  speed : w, rad/s."""
    for k in range(8):
        row[BOUNDARY + k] = law[k]
    row[BOUNDARY + 4] = np.inf if law[4] == np.inf else law[4] * abs(speed)


def ball_rows(count: tuple[int, ...]) -> BallRows:
    """Arrays for balls, with axes of points in front of that of the balls."""
    return BallRows(
        velocity=np.full((*count, 4), np.nan),
        contacts=np.zeros((*count, 2, CONTACT)),
        bodies=np.zeros((*count, 3)),
        outcomes=np.zeros((*count, 2, 7)),
        motion=np.zeros((*count, 10)),
        given=np.full((*count, 3), np.nan),
        gave=np.full((*count, 3), np.nan),
        left=np.full((*count, 3), np.nan),
        residual=np.zeros(count),
    )
