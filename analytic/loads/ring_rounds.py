"""The rounds of a ring's equilibrium, in which contact stiffness, inertia and friction follow the contact angles.

Each round holds what the angles and loads of the last one give, and settles the ring by `analytic.loads.ring_balance`;
the last one has nothing to do. Balls that turn freely have rounds of their own (`analytic.free_ball.rounds`).
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.factors import corrected
from analytic.contact.geometry import rolling_curvature
from analytic.contact.hertz import unit_hertz
from analytic.loads.ball_balance import Grooves
from analytic.loads.numbers import BearingNumbers
from analytic.loads.race_contacts import put_unit
from analytic.loads.ring_balance import settle_ring
from analytic.loads.state import BALL_STATE, FREEDOMS, RING_STATE
from analytic.loads.turning import ForcesOfTurning, TurningRule, ruled_forces
from analytic.numerics.compilation import compiled
from analytic.numerics.machine_code import entry
from analytic.numerics.newton import MOST_STEPS
from analytic.numerics.records import Record, Records, dtype_of
from analytic.numerics.root import cube_root
from analytic.scene import Array

# Contact stiffness, centrifugal and friction force follow the angles: 3 or 4 rounds at rest, about 10 at high speed. A
# ball whose own forces nearly cancel takes hundreds.
MOST_ROUNDS = 400
# Rounds, after which forces move halfway, and after as many again half of that: some swing to and fro with the angles,
# the more the less is left of a ball's own forces. Those of free balls keep to halfway: wedged ones would not arrive.
STEADYING = 30
MOST_HALVINGS = 4
FLOATS = 1e-5  # of the heaviest ball's load: a change of forces that is enough in the last round
# Of a ball's own force, over the largest: what is left where centrifugal force, weight and friction of another ball
# cancel. Such a remainder presses nothing, and would lead a ball along its race for ever.
FORCE_ROUND_OFF = 64 * np.finfo(np.float64).eps
SETTLED, OPEN, LOOSE_BALL, LOOSE_RING, BEYOND_GROOVE = range(5)
BY_LOAD, BY_PLACE, BY_POINT = range(3)  # from where a point begins: from its load, its place, or all that it holds


class RingNumbers(NamedTuple):
    """A ring in numbers."""

    bearing: BearingNumbers
    grooves: Grooves
    angle: float  # near which the contact angles are, rad


class Round(NamedTuple):
    """How the rounds of a point end."""

    end: int  # SETTLED, BEYOND_GROOVE, or what has not settled: LOOSE_BALL, LOOSE_RING or, OPEN, the forces held
    steps: int  # of Newton's method
    left: float  # residual of what has not settled, N; else of the ring
    tolerance: float  # on it


class Beyond(NamedTuple):
    """The ball that lies farthest beyond its groove."""

    angle: float  # magnitude of its contact angle, rad; 0: no ball does
    moved: float  # largest radial displacement of the rings, m
    is_by_load: bool  # whether the load moved it there, else the speed


@compiled
def hold_contacts(bearing: BearingNumbers, balls: Records) -> None:
    """Write the contacts under 1 N at the balls' angles."""
    for race in range(2):
        numbers, angle = bearing.inner if race == 0 else bearing.outer, np.nan
        hertz = unit_hertz(1.0, 1.0, 1.0)
        for j in range(len(balls)):
            ball = balls[j]
            if ball.angle[race] != angle:  # under a radial load alone all angles are 0
                angle = ball.angle[race]
                hertz = unit_hertz(rolling_curvature(numbers, angle), numbers.curvature_transverse, numbers.modulus)
            if race == 0:
                put_unit(ball.inner_unit, corrected(hertz, ball.inner_factors))
            else:
                put_unit(ball.outer_unit, corrected(hertz, ball.outer_factors))


@compiled
def put_turning(ball: Record, forces: ForcesOfTurning) -> None:
    """Write what acts on a ball because it turns."""
    ball.turning.centrifugal, ball.turning.gyroscopic = forces.centrifugal, forces.gyroscopic
    ball.turning.inner_friction, ball.turning.outer_friction = forces.inner_friction, forces.outer_friction


@compiled
def _hold_ruled_forces(bearing: BearingNumbers, rule: TurningRule, balls: Records) -> None:
    """Write what acts on balls that turn by rule."""
    most = np.pi / 2  # before it settles a ball may leave its groove
    for j in range(len(balls)):
        ball = balls[j]
        angles = min(max(ball.angle[0], -most), most), min(max(ball.angle[1], -most), most)
        put_turning(ball, ruled_forces(bearing, rule, angles, (ball.load[0], ball.load[1])))


@compiled
def _hold_forces(ring: Record, balls: Records, share: float) -> float:
    """Write the forces on ring and balls, and return by how much the largest component changes, N.

    share : of the way from the last forces to those that `turning` gives
    """
    ring_force = ring.gradient
    for i in range(FREEDOMS):
        ring_force[i] = ring.load[i]
    largest = change = 0.0
    for j in range(len(balls)):
        ball = balls[j]
        inner, outer = ball.angle[0], ball.angle[1]
        at_inner, at_outer = ball.turning.inner_friction, ball.turning.outer_friction
        friction = (at_inner * np.sin(inner), -at_inner * np.cos(inner))
        own = ball.next_own
        own[0] = ball.turning.centrifugal + friction[0] - at_outer * np.sin(outer) + ball.weight[0]
        own[1] = friction[1] + at_outer * np.cos(outer) + ball.weight[1]
        ball.friction[0], ball.friction[1] = friction
        for i in range(FREEDOMS):
            ring_force[i] -= ball.travel[0, i] * friction[0] + ball.travel[1, i] * friction[1]
        largest = max(largest, own[0] ** 2 + own[1] ** 2)
    for j in range(len(balls)):
        ball = balls[j]
        own = ball.next_own
        is_remainder = own[0] ** 2 + own[1] ** 2 <= FORCE_ROUND_OFF**2 * largest
        for k in range(2):
            now = 0.0 if is_remainder else own[k]
            step = now - ball.own[k]
            ball.own[k] = now if share == 1 else ball.own[k] + share * step
            change = max(change, share * abs(step))
    for i in range(FREEDOMS):
        step = ring_force[i] - ring.force[i]
        ring.force[i] = ring_force[i] if share == 1 else ring.force[i] + share * step
        change = max(change, share * abs(step))
    return change


@compiled
def _place_by_load(grooves: Grooves, ring: Record, balls: Records) -> None:
    """Write a place where balls touch.

    It is the displacement by each part of the load if one ball took it, with the largest part in full.
    """
    play, distance, force = grooves.play, grooves.distance, ring.load
    parts = (abs(force[0]), np.hypot(force[1], force[2]), np.hypot(force[3], force[4]))
    largest = max(max(parts[0], parts[1]), parts[2])
    softness = balls[0].inner_unit.approach + balls[0].outer_unit.approach
    for i in range(FREEDOMS - ring.held):
        part = parts[(i + 1) // 2]
        if part > 0:
            approach = softness * cube_root(part) ** 2
            if i == 1 or i == 2:
                reach = approach + max(play, 0.0)
            else:
                reach = np.sqrt(max((approach + play) * (2 * distance + approach - play), 0.0))
            ring.place[i] = force[i] / largest * reach
        else:
            ring.place[i] = 0.0


@compiled
def begin_rounds(ring: Record, balls: Records) -> None:
    """Let all forces change in the first round."""
    for i in range(FREEDOMS):
        ring.force[i] = np.inf
    for j in range(len(balls)):
        balls[j].own[0] = balls[j].own[1] = np.inf


@compiled
def _begin(numbers: RingNumbers, ring: Record, balls: Records, start: int) -> None:
    """Write the contacts that a point begins with, and what it does not yet hold; all forces are then to change."""
    if start != BY_POINT:
        begin_rounds(ring, balls)
        for j in range(len(balls)):
            ball = balls[j]
            ball.angle[0] = ball.angle[1] = numbers.angle
            ball.load[0] = ball.load[1] = ball.moved[0] = ball.moved[1] = 0.0
    hold_contacts(numbers.bearing, balls)
    if start == BY_LOAD:
        _place_by_load(numbers.grooves, ring, balls)


@compiled
def beyond_groove(grooves: Grooves, ring: Record, balls: Records) -> Beyond:
    """A ball of a settled ring that no groove bears any more, because its contact angle is beyond pi/2."""
    distance, play = grooves.distance, grooves.play
    farthest, moved, has_passed = np.pi / 2, 0.0, False
    for j in range(len(balls)):
        ball, radial = balls[j], 0.0
        for i in range(FREEDOMS):
            radial += ball.travel[0, i] * ring.place[i]
        moved = max(moved, abs(radial))
        passed = distance - play + radial < 0  # the centres of the grooves, each other; no inertia of balls does that
        for race in range(2):
            angle = abs(ball.angle[race])
            if angle > farthest and (passed or ball.load[race] > 0):
                farthest, has_passed = angle, passed
    if farthest == np.pi / 2:
        return Beyond(0.0, moved, False)
    # A move by that much is the load's, whatever inertia adds.
    return Beyond(farthest, moved, has_passed or moved > max(play, 0.0) + distance / 2)


@compiled
def settle_round(grooves: Grooves, ring: Record, balls: Records, number: int, accuracy: float) -> Round:
    """One round, for which contacts and turning are written.

    number : of the round, from 0;  accuracy : relative, of the forces that turning gives; 0: they are exact
    """
    halvings = min(number // STEADYING, MOST_HALVINGS if accuracy == 0 else 1)
    change, heaviest = _hold_forces(ring, balls, 0.5**halvings), 0.0
    for j in range(len(balls)):
        heaviest = max(heaviest, balls[j].load[1])
    balance, steps = settle_ring(grooves, ring, balls)
    for j in range(len(balls)):
        ball = balls[j]
        ball.angle[0] = np.arctan2(ball.inner_arm[1], ball.inner_arm[0])
        ball.angle[1] = np.arctan2(ball.outer_arm[1], ball.outer_arm[0])
    if balance.has_loose_ball:
        return Round(LOOSE_BALL, steps, balance.left, balance.tolerance)
    if steps == MOST_STEPS or np.isnan(balance.left):
        return Round(LOOSE_RING, steps, balance.left, balance.tolerance)
    # The ring does not notice the force of a ball that floats or is wedged: that has to settle too.
    enough = max(balance.tolerance, accuracy * heaviest)
    # A ball whose forces all but cancel floats, and swings for ever by what no torque shows.
    if accuracy == 0 and number == MOST_ROUNDS:
        enough = max(enough, FLOATS * heaviest)
    # A step turns contacts, and the next round shows by how much that changes the forces. On the edge of a contact the
    # steps never end: after many rounds a small change is enough.
    if change > enough or (steps > 0 and accuracy == 0 and number <= STEADYING):
        return Round(OPEN, steps, change, enough)
    end = BEYOND_GROOVE if beyond_groove(grooves, ring, balls).angle > 0 else SETTLED
    return Round(end, steps, balance.left, balance.tolerance)


@compiled
def settle_ruled_ring(numbers: RingNumbers, rule: TurningRule, ring: Record, balls: Records, start: int) -> Round:
    """All rounds of a point whose balls turn by rule; writes ring and balls.

    ring.load : N;  start : BY_LOAD; BY_PLACE, where the ring has a place with balls that touch; or BY_POINT, where it
        has settled under nearly the same load or factors. The equilibrium does not depend on it.
    """
    _begin(numbers, ring, balls, start)
    end, steps = Round(OPEN, 0, 0.0, 0.0), 0
    for number in range(MOST_ROUNDS + 1):
        if number > 0:
            hold_contacts(numbers.bearing, balls)
        _hold_ruled_forces(numbers.bearing, rule, balls)
        end = settle_round(numbers.grooves, ring, balls, number, 0.0)
        steps += end.steps
        if end.end != OPEN:
            break
    return Round(end.end, steps, end.left, end.tolerance)


ROUND = np.dtype([("end", "i8"), ("steps", "i8"), ("left", "f8"), ("tolerance", "f8")])  # `Round` as a record


@entry(
    lambda: {
        "numbers": dtype_of(RingNumbers),
        "speed": 1,
        "inertia": (bool, bool),
        "rings": (RING_STATE, 1),
        "balls": (BALL_STATE, 2),
        "ends": (ROUND, 1),
        "start": int,
    }
)
def settle_ruled_rings(
    numbers: RingNumbers,
    speed: Array,
    inertia: tuple[bool, bool],
    rings: Records,
    balls: Records,
    ends: Records,
    start: int,
) -> None:
    """`settle_ruled_ring` of n points, up to the first that does not settle.

    speed : w, (n,), rad/s;  inertia : whether centrifugal force and gyroscopic moment count
    rings : (n,);  balls : (n, Z);  ends : (n,) of ROUND
    """
    for i in range(len(rings)):
        rule = TurningRule(speed[i], inertia[0], inertia[1])
        end = settle_ruled_ring(numbers, rule, rings[i], balls[i], start)
        ends[i].end, ends[i].steps, ends[i].left, ends[i].tolerance = end.end, end.steps, end.left, end.tolerance
        if end.end != SETTLED:
            return
