"""A point whose balls turn freely: loads, rotation and friction settle together.

Traction turns the balls and pushes them across their grooves, loads and angles follow, and where there is oil its film
follows these. Each pass has the laws of traction of the last one, until the torque stays. A level of nodes begins where
the coarser one has settled, by way of as many nodes across as it has itself; both differences show its error, and where
that is not allowed, the next level follows.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import loaded_hertz
from analytic.free_ball.kernel import turn_ball
from analytic.free_ball.rounds import ROUGHLY_STEADY, SKIDS, STEADY, settle_free_ring, settle_free_thrust
from analytic.free_ball.turning import (
    ACCURACY,
    ENOUGH,
    FreeNodes,
    FreeNumbers,
    angles_in_grooves,
    free_motion,
    hold_law,
    orbit_at,
    roll_by_rule,
)
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.ring_rounds import SETTLED, RingNumbers, Round
from analytic.loads.thrust_ball import in_groove
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record, Records
from analytic.oil.race_resistance import RaceResistance, ResistedContact, resisted_contact
from analytic.oil.unloaded_ball import more_in_clearance
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Array

FIRST = 3e-2  # residual of the rotation, over all friction, that is enough for the first round
SAME = 3e-7  # relative, of the torque between two passes of one quadrature: no start can be told from another
ROUGHLY_SAME = 1e-5  # likewise of a level that another one follows
OF_ALLOWED = 10_000.0  # allowed error of sliding over the change between two passes that is enough
MOST_PASSES = 60  # 2 to 5 are usual; 25 of one quadrature where friction all but wedges light balls


class FreeModel(NamedTuple):
    """A scene with free balls, without its operating points."""

    ring: RingNumbers
    resistance: RaceResistance
    rolls_off: bool  # whether balls without load roll in the oil of their clearance
    cubics: Array  # splines of the gap laws
    free: FreeNumbers
    quadratures: Records  # (k,) of `state.QUADRATURE`, as `rotation.free_quadratures` has them
    scratch: Record  # of `state.SCRATCH`


class FreeAccuracy(NamedTuple):
    """How accurately the balls of a point settle."""

    level: int  # of nodes, from 0: the coarsest one, with which the next is compared
    # Error of sliding, relative to the whole torque, beyond which the next level follows; infinite: the level alone
    allowed: float


class FreeEnd(NamedTuple):
    """How a point with free balls ends; torques are about the bearing axis, of all balls, N m."""

    round: Round  # the last one; not SETTLED: there is no torque
    torque: float  # by what counts of sliding
    spin: float  # part of it
    error: float  # of the torque, by the nodes
    residual: float  # of the equilibrium, relative


@compiled
def settle_freely(
    model: FreeModel,
    speed: float,
    oil: OilNumbers,
    ring: Record,
    balls: Records,
    contacts: Records,
    wanted: FreeAccuracy,
    is_ring: bool,
) -> FreeEnd:
    """Passes until the torque changes no more than it may; writes ring, balls and contacts.

    speed : w, rad/s;  oil : at its temperature
    balls : (m,), loaded by rule without the gyroscopic moment, which no friction may hold there; one for all that are
        alike
    is_ring : whether they are balanced on a ring
    The balls begin by rule, or at the start that they hold where ring.passes is not 0. That of the next point is
    written.
    """
    bearing, count, known = model.ring.bearing, len(balls), ring.passes
    for j in range(count):
        ball = balls[j]
        for race in range(2):
            ball.ruled_angle[race], ball.ruled_load[race] = ball.angle[race], ball.load[race]
        _begin(model, ball, known > 0)
    torque = spin = whole = before = coarser = largest = error = 0.0
    finest, end = len(model.quadratures) - 1, Round(SETTLED, 0, 0.0, 0.0)
    level, is_alone = max(known - 1, wanted.level), wanted.allowed == np.inf
    same = SAME if is_alone else max(SAME, wanted.allowed / OF_ALLOWED)
    # Numbers of quadratures: a level has an odd one, the next even one has twice its nodes across.
    first = 1 + 2 * level if is_alone else min(1 + 2 * level, finest - 2)
    for number in range(first, finest + 1):
        is_level = number % 2 == 1 and (number > first or is_alone)
        for repeats in range(MOST_PASSES):
            steady = ROUGHLY_STEADY if repeats == 0 else STEADY
            end, other = _one_pass(model, speed, oil, ring, balls, contacts, number, steady, is_ring)
            if end.end != SETTLED:
                break
            before = whole
            torque, spin = _slid(bearing, balls, contacts)
            whole = torque + other
            if number % 2 == 0:  # its laws are those of the level before it: oil follows nodes little
                break
            change = max(largest, abs(whole - coarser)) if number > first else 0.0
            ends = is_level and (number == finest or 2.0 * change <= wanted.allowed * whole)
            if repeats > 0 and abs(whole - before) <= (same if ends else max(same, ROUGHLY_SAME)) * whole:
                break
        if end.end != SETTLED:
            break
        largest = max(largest, abs(whole - coarser)) if number > first else 0.0
        coarser = whole
        if is_level:
            level, error = number // 2, 2.0 * largest
            if error <= wanted.allowed * whole:
                break
            largest = 0.0
        for j in range(count):
            balls[j].given[0] = np.nan  # the next one begins on coarse nodes
    ring.passes = 0
    if end.end == SETTLED:
        ring.passes = 1 + level
        for j in range(count):
            _leave(model, balls[j])
    loads = 0.0
    for i in range(5):
        loads += abs(ring.load[i])
    return FreeEnd(end, torque, spin, error, end.left / loads if is_ring else end.left)


@compiled
def _slid(bearing: BearingNumbers, balls: Records, contacts: Records) -> tuple[float, float]:
    """Torque by sliding, and its part by spin, N m; writes how the balls move."""
    torque = spin = 0.0
    alike = bearing.ball_count / len(balls)
    for j in range(len(balls)):
        ball = balls[j]
        put_motion(ball, free_motion(bearing.ball_radius, angles_of(ball), ball.orbit_radius, ball.velocity))
        for race in range(2):
            torque += alike * contacts[j, race].power
            spin += alike * contacts[j, race].spin_power
    return torque, spin


@compiled
def _one_pass(
    model: FreeModel,
    speed: float,
    oil: OilNumbers,
    ring: Record,
    balls: Records,
    contacts: Records,
    number: int,
    steady: float,
    is_ring: bool,
) -> tuple[Round, float]:
    """Loads and rotation with the laws of traction of the last pass; how it ends, and all torque but sliding, N m.

    number : of the quadrature;  steady : relative change of the forces on a ball that ends the rounds
    """
    bearing, count, other = model.ring.bearing, len(balls), 0.0
    for j in range(count):
        ball = balls[j]
        other += bearing.ball_count / count * _hold_laws(model, speed, oil, ball, contacts[j])
        for k in range(3):
            ball.gave[k] = ball.left[k] = np.nan
    fine = model.quadratures[number]
    nodes = FreeNodes(model.quadratures[0], fine, FIRST, steady, model.scratch)
    if is_ring:
        end = settle_free_ring(model.ring, model.free, speed, ring, balls, contacts, nodes)
    else:
        end = settle_free_thrust(bearing, model.free, speed, ring.load[0], balls[0], contacts[0], nodes)
    for j in range(count):
        ball = balls[j]
        left = ball.residual
        if not left <= ACCURACY:
            left = turn_ball(contacts[j], ball, fine, ACCURACY, model.scratch)
        if end.end == SETTLED and not left <= ENOUGH:
            end = Round(SKIDS, end.steps, left, ENOUGH)
        ball.residual = left
    return end, other


@compiled
def angles_of(ball: Record) -> tuple[float, float]:
    """al_i, al_o, rad."""
    return ball.angle[0], ball.angle[1]


@compiled
def put_motion(ball: Record, found: BallMotion) -> None:
    """Write how a ball moves, per unit ring speed."""
    motion = ball.motion
    motion.inner_radius, motion.outer_radius = found.inner_radius, found.outer_radius
    motion.cage_speed, motion.ball_speed = found.cage_speed, found.ball_speed
    motion.inner_entrainment, motion.outer_entrainment = found.inner_entrainment, found.outer_entrainment
    motion.inner_rolling_rate, motion.outer_rolling_rate = found.inner_rolling_rate, found.outer_rolling_rate
    motion.spin_difference, motion.pitch = found.spin_difference, found.pitch


@compiled
def _begin(model: FreeModel, ball: Record, is_known: bool) -> None:
    """Let a ball, which is loaded by rule, begin by rule or at a start that it holds."""
    bearing, velocity = model.ring.bearing, ball.velocity
    if not is_known:
        velocity[0] = ball.given[0] = np.nan
        put_motion(ball, ruled_motion(bearing, 1.0, ball.angle[0], ball.angle[1]))
        return
    for k in range(3):
        ball.given[k] = ball.start_forces[k]
    for race in range(2):
        ball.angle[race] = in_groove(ball.angle[race] + ball.start_angle[race])
        ball.load[race] *= ball.start_load[race]
    orbit, angles = orbit_at(bearing, model.free, ball), angles_in_grooves(ball)
    roll_by_rule(bearing, angles, orbit, velocity)
    for k in range(4):
        velocity[k] += ball.start_velocity[k]
    put_motion(ball, free_motion(bearing.ball_radius, angles, orbit, velocity))


@compiled
def _leave(model: FreeModel, ball: Record) -> None:
    """Write how a ball settled as a start."""
    for race in range(2):
        ball.start_angle[race] = ball.angle[race] - ball.ruled_angle[race]
        ball.start_load[race] = ball.load[race] / ball.ruled_load[race] if ball.ruled_load[race] > 0.0 else 1.0
    roll_by_rule(model.ring.bearing, angles_in_grooves(ball), ball.orbit_radius, ball.start_velocity)
    for k in range(4):
        ball.start_velocity[k] = ball.velocity[k] - ball.start_velocity[k]
    for k in range(3):
        ball.start_forces[k] = ball.given[k]


@compiled
def _hold_laws(model: FreeModel, speed: float, oil: OilNumbers, ball: Record, contacts: Records) -> float:
    """Write the laws of traction of a ball; returns its torque by all but sliding, N m."""
    resisted = _hold_law(model, speed, oil, ball, contacts, 0), _hold_law(model, speed, oil, ball, contacts, 1)
    other = 0.0
    for each in resisted:
        other += each.rolling_torque + each.hysteresis_torque
    if model.rolls_off and min(ball.load[0], ball.load[1]) == 0.0:
        other += more_in_clearance(model.ring, model.resistance, oil, speed, ball, resisted)
    return other


@compiled
def _hold_law(
    model: FreeModel, speed: float, oil: OilNumbers, ball: Record, contacts: Records, race: int
) -> ResistedContact:
    bearing, motion, load = model.ring.bearing, ball.motion, ball.load[race]
    angle = in_groove(ball.angle[race])
    unit, numbers = (ball.inner_unit, bearing.inner) if race == 0 else (ball.outer_unit, bearing.outer)
    rate = motion.inner_rolling_rate if race == 0 else motion.outer_rolling_rate
    entrainment = motion.inner_entrainment if race == 0 else motion.outer_entrainment
    contact = contact_under(numbers, unit, angle, load, rate, entrainment)
    peak = loaded_hertz(unit, load).peak_pressure
    resisted = resisted_contact(model.resistance, model.cubics, oil, race, contact, peak, speed)
    hold_law(contacts[race], resisted.law, speed)
    return resisted
