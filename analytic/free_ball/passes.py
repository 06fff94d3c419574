"""A point whose balls turn freely: loads, rotation and friction settle together.

Traction turns the balls and pushes them across their grooves, loads and angles follow, and where there is oil its film
follows these. Each pass has the laws of traction of the last one, and more nodes. The change of the torque between two
passes is what is left of both errors.
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

# Times the change from one quadrature to the next: what is left of it, where the error falls at least as fast as the
# nodes lie closer. Films follow loads with small powers, and settle faster.
SAFETY = 2.0
# Errors change sign with the load, and two quadratures may agree by chance: the change before then says more. What is
# left was at most a ninth of that, and these shares of sliding and of the whole torque, in 270 drawn scenes with and
# without creep (validation/adversary/run.py, seeds from 20000). The first quadrature is only a start.
LEFT_OF_LAST = 0.25
LEAST = (np.inf, 0.025, 0.004, 0.001, 0.0004)
LEAST_OF_WHOLE = (np.inf, 5e-4, 2e-5, 5e-6, 2e-6)
FIRST = 3e-2  # residual of the rotation, over all friction, that is enough for the first round
# Likewise for every round of a rough pass: the torque errs as much as a force is lacking.
NEARLY = 3e-4
SAME = 3e-7  # relative, of the torque between two passes of one quadrature: no start can be told from another
MOST_PASSES = 60  # 2 to 5 are usual; 25 of one quadrature where friction all but wedges light balls


class FreeModel(NamedTuple):
    """A scene with free balls, without its operating points."""

    ring: RingNumbers
    resistance: RaceResistance
    rolls_off: bool  # whether balls without load roll in the oil of their clearance
    cubics: Array  # splines of the gap laws
    free: FreeNumbers
    quadratures: Records  # (k,) of `state.QUADRATURE`: a coarse one, and that of each pass


class FreeAccuracy(NamedTuple):
    """How accurately the balls of a point settle."""

    allowed: float  # error of sliding, relative to the whole torque, where the quadratures are refined
    passes: int  # number of the quadrature; 0: the first that is accurate enough, or that of a known start
    nearly: bool  # one rough pass is enough from a known start: the torque errs by some 1e-3
    spin_alone: bool  # conformity does not count, and the part by spin errs by more than both together


class FreeEnd(NamedTuple):
    """How a point with free balls ends; torques are about the bearing axis, of all balls, N m."""

    round: Round  # the last one; not SETTLED: there is no torque
    torque: float  # by what counts of sliding
    spin: float  # part of it
    error: float  # of the torque


@compiled
def settle_freely(
    model: FreeModel,
    speed: float,
    oil: OilNumbers,
    ring: Record,
    balls: Records,
    contacts: Records,
    wanted: FreeAccuracy,
    is_ring: bool | None,
) -> FreeEnd:
    """Passes until the torque changes no more than it may; writes ring, balls and contacts.

    speed : w, rad/s;  oil : at its temperature
    balls : (m,), loaded by rule without the gyroscopic moment, which no friction may hold there; one for all that are
        alike
    is_ring : whether they are balanced on a ring; None: they are not, and no ring is compiled
    The balls begin by rule, or at the start that they hold where ring.passes is not 0. That of the next point is
    written.
    """
    bearing, count, known = model.ring.bearing, len(balls), ring.passes
    by_rule = np.empty((count, 4))
    for j in range(count):
        ball = balls[j]
        for race in range(2):
            by_rule[j, race], by_rule[j, 2 + race] = ball.angle[race], ball.load[race]
        _begin(model, ball, known > 0)
    torque = spin = whole = before = error = last_change = decided = 0.0
    judges = refines = alone = wanted.passes == 0 and known == 0
    number = wanted.passes if wanted.passes > 0 else max(known, 1)
    nearly, last, end = wanted.nearly and known > 0, len(model.quadratures) - 1, Round(SETTLED, 0, 0.0, 0.0)
    for repeats in range(MOST_PASSES):
        end, other = _one_pass(model, speed, oil, ring, balls, contacts, number, nearly, is_ring)
        if end.end != SETTLED:
            break
        before = whole
        torque, spin = _slid(bearing, balls, contacts, wanted.spin_alone)
        whole = torque + other
        if nearly:
            break
        least = LEAST[number - 1] * torque + LEAST_OF_WHOLE[number - 1] * whole
        if refines:
            if number > 1:
                change = abs(whole - before)
                error, last_change = max(SAFETY * change, LEFT_OF_LAST * last_change, least), change
            if number == last or (number > 1 and error <= wanted.allowed * whole):
                # The same quadrature again, until it holds the laws of its own loads and speeds.
                refines, decided = False, whole
                continue
        else:
            if repeats == 0 or abs(whole - before) > SAME * whole:
                continue
            if not judges or (alone and abs(whole - decided) <= error):
                break
            # It settles far from where its error was estimated: a second quadrature that settles shows the error.
            error = max(SAFETY * abs(whole - decided), least)
            if error <= wanted.allowed * whole or (number == last and not alone):
                break
            alone, decided = False, whole
        number += 1 if number < last else -1
        for j in range(count):
            balls[j].given[0] = np.nan  # the next quadrature begins on the nodes of this one
    if judges and abs(whole - before) > SAME * whole:  # the passes have ended before it settles
        error = max(error, SAFETY * abs(whole - decided))
    ring.passes = 0
    if end.end == SETTLED:
        ring.passes = number
        for j in range(count):
            _leave(model, balls[j], by_rule[j])
    return FreeEnd(end, torque, spin, error)


@compiled
def _slid(bearing: BearingNumbers, balls: Records, contacts: Records, spin_alone: bool) -> tuple[float, float]:
    """Torque by what counts of sliding, and its part by spin, N m; writes how the balls move."""
    torque = spin = 0.0
    alike = bearing.ball_count / len(balls)
    for j in range(len(balls)):
        ball = balls[j]
        put_motion(ball, free_motion(bearing.ball_radius, angles_of(ball), ball.orbit_radius, ball.velocity))
        for race in range(2):
            by_spin = contacts[j, race].spin_power
            torque += alike * (by_spin if spin_alone else contacts[j, race].power)
            spin += alike * by_spin
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
    nearly: bool,
    is_ring: bool | None,
) -> tuple[Round, float]:
    """Loads and rotation with the laws of traction of the last pass; how it ends, and all torque but sliding, N m."""
    bearing, count, other = model.ring.bearing, len(balls), 0.0
    for j in range(count):
        ball = balls[j]
        other += bearing.ball_count / count * _hold_laws(model, speed, oil, ball, contacts[j])
        for k in range(3):
            ball.gave[k] = ball.left[k] = np.nan
    fine, accuracy = model.quadratures[number], NEARLY if nearly else ACCURACY
    steady = ROUGHLY_STEADY if nearly or number == 1 else STEADY
    nodes = FreeNodes(model.quadratures[number - 1], fine, NEARLY if nearly else FIRST, steady)
    if is_ring is not None and is_ring:
        end = settle_free_ring(model.ring, model.free, speed, ring, balls, contacts, nodes)
    else:
        end = settle_free_thrust(bearing, model.free, speed, ring.load[0], balls[0], contacts[0], nodes)
    for j in range(count):
        ball = balls[j]
        left = ball.residual
        if not left <= accuracy:
            left = turn_ball(contacts[j], ball, fine, accuracy)
        if end.end == SETTLED and not left <= max(ENOUGH, accuracy):
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
def _leave(model: FreeModel, ball: Record, by_rule: Array) -> None:
    """Write how a ball settled as a start; by_rule : (4,) both angles and both loads by rule."""
    for race in range(2):
        ball.start_angle[race] = ball.angle[race] - by_rule[race]
        ball.start_load[race] = ball.load[race] / by_rule[2 + race] if by_rule[2 + race] > 0.0 else 1.0
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
