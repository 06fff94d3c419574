"""A point whose balls turn freely, compiled: loads, rotation and friction settle together.

Traction turns the balls and pushes them across their grooves, loads and angles follow, and where there is oil its film
follows these. Each pass has the laws of traction of the last one, and more nodes. The change of the torque between two
passes is what is left of both errors.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.contact.hertz import loaded_hertz
from analytic.free_ball.kernel import add_law_powers, turn_ball
from analytic.free_ball.layout import ORBIT_RADIUS, POWER, SPIN_POWER
from analytic.free_ball.rounds import ROUGHLY_STEADY, SKIDS, STEADY, placed_ball, settle_free_ring, settle_free_thrust
from analytic.free_ball.strips import Quadrature
from analytic.free_ball.turning import (
    ACCURACY,
    ENOUGH,
    BallRows,
    FreeNodes,
    FreeNumbers,
    free_motion,
    hold_law,
    orbit_at,
    roll_by_rule,
)
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.race_contacts import contacts_of_ball
from analytic.loads.ring_balance import RingPoint, RingWork, point_of
from analytic.loads.ring_rounds import BY_LOAD, SETTLED, RingLoad, RingLoads, RingNumbers, Round, load_of
from analytic.loads.ruled_point import load_by_rule
from analytic.loads.thrust_ball import in_groove
from analytic.loads.turning import TurningRule
from analytic.numerics.compilation import compiled
from analytic.oil.race_resistance import RaceResistance, resisted_contact
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Array

# Times the change from one quadrature to the next: what is left of it, where the error falls at least as fast as the
# nodes lie closer. Films follow loads with small powers, and settle faster.
SAFETY = 2.0
# Errors change sign with the load, and two quadratures may agree by chance. These are errors of each, relative, that
# 99 % of 2300 points do not exceed, of drawn bearings, loads of 10 to 2000 N and friction of 0.01 to 0.16. The first
# quadrature is only a start.
LEAST = (np.inf, 0.01, 0.003, 0.0007, 0.0003)
FIRST = 3e-2  # residual of the rotation, over all friction, that is enough for the first round
# Likewise for every round from a start that is known: the torque errs as much as a force is lacking.
NEARLY = 3e-4


class FreeSettings(NamedTuple):
    """How the balls of a scene turn freely."""

    free: FreeNumbers
    quadratures: tuple[Quadrature, ...]  # a coarse one, and that of each pass


class FreeModel(NamedTuple):
    """A scene with free balls, without its operating points."""

    ring: RingNumbers
    resistance: RaceResistance
    settings: FreeSettings


class FreeStart(NamedTuple):
    """How m balls settled beside what the rule gives them: a start for a point with nearly the same numbers."""

    last: NDArray[np.int64]  # (1,) number of the pass in which they settled; 0: not known, the balls begin by rule
    velocity: Array  # (m, 4) over that by rule, m per unit ring speed
    angle: Array  # (2, m) over that by rule, rad
    load: Array  # (2, m) factor on that by rule
    forces: Array  # (m, 3) as `BallRows` gives them, N


class FreeSpace(NamedTuple):
    """Arrays of a point, or of n with an axis for them in front; of one ball where all are alike."""

    point: RingPoint
    balls: BallRows
    start: FreeStart


class FreeEnd(NamedTuple):
    """How a point with free balls ends; torques are about the bearing axis, of all balls, N m."""

    round: Round  # the last one; not SETTLED: there is no torque
    torque: float  # by sliding
    spin: float  # part of it
    error: float  # of the torque


@compiled
def settle_freely(
    model: FreeModel, load: RingLoad, oil: OilNumbers, space: FreeSpace, work: RingWork | None, allowed: float
) -> FreeEnd:
    """Passes with more and more nodes, until the torque changes no more than it may; writes the arrays of the point.

    oil : at its temperature;  work : None: all balls are alike, and no ring is compiled
    allowed : error, relative to the whole torque
    The balls begin by rule, without the gyroscopic moment: no friction may hold it there. A start that is known takes
    one pass, whose quadrature was enough for it; that of the next point is written.
    """
    point, balls, bearing, start = space.point, space.balls, model.ring.bearing, space.start
    free, quadratures, count = model.settings.free, model.settings.quadratures, len(balls.velocity)
    alike = bearing.ball_count / count
    rule = TurningRule(load.rule.inner_speed, load.rule.centrifugal, False)
    end = load_by_rule(model.ring, RingLoad(load.force, rule, load.factors), point, work, BY_LOAD)
    if end.end != SETTLED:
        return FreeEnd(end, np.nan, np.nan, np.nan)
    known, angle, loaded = start.last[0], point.angle.copy(), point.load.copy()
    for j in range(count):
        if known > 0:
            _begin(model, space, j)
        else:
            balls.velocity[j] = np.nan
            _put_motion(balls, j, ruled_motion(bearing, 1.0, point.angle[0, j], point.angle[1, j]))
    torque = spin = whole = error = 0.0
    last = 0
    for number in range(max(known, 1), len(quadratures)):
        last, other = number, 0.0
        for j in range(count):
            other += alike * _hold_laws(model, load.rule.inner_speed, oil, space, j)
        balls.given[:] = balls.gave[:] = balls.left[:] = np.nan
        fine, first, steady, accuracy = quadratures[number], FIRST, STEADY if number > 1 else ROUGHLY_STEADY, ACCURACY
        if known > 0:
            first, steady, accuracy = NEARLY, ROUGHLY_STEADY, NEARLY
            for j in range(count):
                for k in range(3):
                    balls.given[j, k] = start.forces[j, k]
        nodes = FreeNodes(quadratures[number - 1], fine, first, steady)
        if work is not None:
            end = settle_free_ring(model.ring, free, load, point, work, balls, nodes)
        else:
            end = settle_free_thrust(bearing, free, load, point, balls, nodes)
        for j in range(count):
            velocity, outcomes, left = balls.velocity[j], balls.outcomes[j], balls.residual[j]
            if not left <= accuracy:
                left = turn_ball(balls.contacts[j], balls.bodies[j], velocity, fine, accuracy, outcomes)
            if end.end == SETTLED and not left <= max(ENOUGH, accuracy):
                end = Round(SKIDS, end.steps, left, ENOUGH)
            balls.residual[j] = left
        if end.end != SETTLED:
            break
        before, torque, spin = whole, 0.0, 0.0
        for j in range(count):
            angles = (point.angle[0, j], point.angle[1, j])
            orbit, velocity = balls.bodies[j, ORBIT_RADIUS], balls.velocity[j]
            _put_motion(balls, j, free_motion(bearing.ball_radius, angles, orbit, velocity))
            for race in range(2):
                torque += alike * balls.outcomes[j, race, POWER]
                spin += alike * balls.outcomes[j, race, SPIN_POWER]
        whole = torque + other
        if known > 0:
            break
        if number > 1:
            error = max(SAFETY * abs(whole - before), LEAST[number - 1] * torque)
            if error <= allowed * whole:
                break
    if end.end == SETTLED:
        start.last[0] = last
        for j in range(count):
            _leave(model, space, j, angle, loaded)
    return FreeEnd(end, torque, spin, error)


@compiled
def settle_thrust_points(
    model: FreeModel, loads: RingLoads, oil: OilNumbers, space: FreeSpace, allowed: Array, ends: Array
) -> None:
    """`settle_freely` of n points whose balls are all alike, up to the first that does not settle.

    allowed : (n,);  ends : (n, 7) end, steps, left and tolerance of the last round, torque, spin, error
    """
    _settle_points(model, loads, oil, space, None, allowed, ends)


@compiled
def settle_ring_points(
    model: FreeModel,
    loads: RingLoads,
    oil: OilNumbers,
    space: FreeSpace,
    work: RingWork,
    allowed: Array,
    ends: Array,
) -> None:
    """The same where every ball has its own load; each is compiled where it is needed."""
    _settle_points(model, loads, oil, space, work, allowed, ends)


@compiled
def _settle_points(
    model: FreeModel,
    loads: RingLoads,
    oil: OilNumbers,
    space: FreeSpace,
    work: RingWork | None,
    allowed: Array,
    ends: Array,
) -> None:
    for i in range(len(allowed)):
        balls = rows_of_point(space.balls, i)
        one = FreeSpace(point_of(space.point, i), balls, start_of_point(space.start, i))
        end = settle_freely(model, load_of(loads, i), oil, one, work, allowed[i])
        last = end.round
        ends[i, 0], ends[i, 1], ends[i, 2], ends[i, 3] = last.end, last.steps, last.left, last.tolerance
        ends[i, 4], ends[i, 5], ends[i, 6] = end.torque, end.spin, end.error
        if last.end != SETTLED:
            return


@compiled
def write_law_powers(quadratures: tuple[Quadrature, ...], space: FreeSpace) -> None:
    """Write what the law of traction loses at n points that have settled."""
    for i in range(len(space.start.last)):
        balls, fine = rows_of_point(space.balls, i), quadratures[space.start.last[i, 0]]
        for j in range(len(balls.velocity)):
            add_law_powers(balls.contacts[j], balls.bodies[j], balls.velocity[j], fine, balls.outcomes[j])


@compiled
def rows_of_point(rows: BallRows, i: int) -> BallRows:
    """One of n points."""
    return BallRows(
        rows.velocity[i],
        rows.contacts[i],
        rows.bodies[i],
        rows.outcomes[i],
        rows.motion[i],
        rows.given[i],
        rows.gave[i],
        rows.left[i],
        rows.residual[i],
    )


@compiled
def start_of_point(start: FreeStart, i: int) -> FreeStart:
    """One of n points."""
    return FreeStart(start.last[i], start.velocity[i], start.angle[i], start.load[i], start.forces[i])


@compiled
def motion_of(balls: BallRows, j: int) -> BallMotion:
    """Of ball j, per unit ring speed."""
    m = balls.motion[j]
    return BallMotion(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8], m[9])


def no_start(count: int, balls: int) -> FreeStart:
    """Of n points whose balls begin by rule."""
    return FreeStart(
        last=np.zeros((count, 1), dtype=np.int64),
        velocity=np.zeros((count, balls, 4)),
        angle=np.zeros((count, 2, balls)),
        load=np.ones((count, 2, balls)),
        forces=np.zeros((count, balls, 3)),
    )


@compiled
def _put_motion(balls: BallRows, j: int, motion: BallMotion) -> None:
    for k in range(10):
        balls.motion[j, k] = motion[k]


@compiled
def _begin(model: FreeModel, space: FreeSpace, j: int) -> None:
    """Let ball j, which is loaded by rule, begin at a start that is known."""
    point, balls, start, bearing = space.point, space.balls, space.start, model.ring.bearing
    for race in range(2):
        point.angle[race, j] = in_groove(point.angle[race, j] + start.angle[race, j])
        point.load[race, j] *= start.load[race, j]
    placed = placed_ball(point, j)
    orbit = orbit_at(bearing, model.settings.free, placed)
    roll_by_rule(bearing, placed.angles, orbit, balls.velocity[j])
    balls.velocity[j] += start.velocity[j]
    _put_motion(balls, j, free_motion(bearing.ball_radius, placed.angles, orbit, balls.velocity[j]))


@compiled
def _leave(model: FreeModel, space: FreeSpace, j: int, angle: Array, load: Array) -> None:
    """Write how ball j settled as a start; angle, load : (2, m) by rule."""
    point, balls, start = space.point, space.balls, space.start
    for race in range(2):
        start.angle[race, j] = point.angle[race, j] - angle[race, j]
        start.load[race, j] = point.load[race, j] / load[race, j] if load[race, j] > 0.0 else 1.0
    orbit = balls.bodies[j, ORBIT_RADIUS]
    roll_by_rule(model.ring.bearing, placed_ball(point, j).angles, orbit, start.velocity[j])
    start.velocity[j] = balls.velocity[j] - start.velocity[j]
    start.forces[j] = balls.given[j]


@compiled
def _hold_laws(model: FreeModel, speed: float, oil: OilNumbers, space: FreeSpace, j: int) -> float:
    """Write the laws of traction of ball j; returns its torque by all but sliding, N m."""
    placed = placed_ball(space.point, j)
    units = (placed.inner, placed.outer)
    contacts = contacts_of_ball(model.ring.bearing, placed.angles, placed.loads, units, motion_of(space.balls, j))
    other = 0.0
    for race in range(2):
        peak = loaded_hertz(units[race], placed.loads[race]).peak_pressure
        resisted = resisted_contact(model.resistance, oil, race, contacts[race], peak, speed)
        hold_law(space.balls.contacts[j, race], resisted.law, speed)
        other += resisted.rolling_torque + resisted.hysteresis_torque
    return other
