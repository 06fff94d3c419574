"""The rounds of a ring's equilibrium, in which contact stiffness, inertia and friction follow the contact angles.

Each round holds what the angles and loads of the last one give, and settles the ring by `analytic.loads.ring_balance`;
the last one has nothing to do. Balls that turn freely have rounds of their own (`analytic.free_ball.rounds`).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import FactorNumbers, corrected
from analytic.contact.geometry import RaceNumbers, rolling_curvature
from analytic.contact.hertz import HertzNumbers, unit_hertz
from analytic.loads.numbers import BearingNumbers
from analytic.loads.ring_balance import APPROACH, FREEDOMS, BallRows, RingPoint, RingWork, point_of, settle_ring
from analytic.loads.turning import TurningRule, ruled_forces
from analytic.numerics.compilation import compiled
from analytic.numerics.newton import MOST_STEPS
from analytic.scene import Array

# Contact stiffness, centrifugal and friction force follow the angles: 3 or 4 rounds at rest, about 10 at high speed.
MOST_ROUNDS = 200
STEADYING = 30  # rounds, after which forces move halfway: some swing to and fro with the angles
# Of a ball's own force, over the largest: what is left where centrifugal force, weight and friction of another ball
# cancel. Such a remainder presses nothing, and would lead a ball along its race for ever.
FORCE_ROUND_OFF = 64 * np.finfo(np.float64).eps
SETTLED, OPEN, LOOSE_BALL, LOOSE_RING, BEYOND_GROOVE = range(5)
BY_LOAD, BY_PLACE, BY_POINT = range(3)  # from where a point begins: from its load, its place, or all that it holds


class RingNumbers(NamedTuple):
    """A ring with its rows of balls, in numbers."""

    bearing: BearingNumbers
    rows: BallRows
    angle: float  # near which the contact angles are, rad


class RingLoad(NamedTuple):
    """What acts on the ring at one operating point."""

    force: Array  # (5,) load, N (moments over R)
    rule: TurningRule  # how the balls turn
    factors: Array  # (2, 4, Z) or (2, 4, 1) on Hertz's contacts, with the fields of FactorNumbers


class RingLoads(NamedTuple):
    """`RingLoad` of n operating points."""

    force: Array  # (n, 5)
    inner_speed: Array  # (n,) rad/s
    inertia: tuple[bool, bool]  # whether centrifugal force and gyroscopic moment count
    factors: Array  # (n, 2, 4, Z), or axes of 1 for n and Z


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
def _unit_hertz_at(race: RaceNumbers, angle: float) -> HertzNumbers:
    return unit_hertz(rolling_curvature(race, angle), race.curvature_transverse, race.modulus)


@compiled
def hold_contacts(ring: RingNumbers, factors: Array, point: RingPoint) -> None:
    """Write the contacts under 1 N at the balls' angles."""
    last = factors.shape[2] - 1
    for race in range(2):
        numbers, angle = ring.bearing.inner if race == 0 else ring.bearing.outer, point.angle[race, 0]
        hertz = _unit_hertz_at(numbers, angle)
        for j in range(len(point.own)):
            if point.angle[race, j] != angle:  # under a radial load alone all angles are 0
                angle = point.angle[race, j]
                hertz = _unit_hertz_at(numbers, angle)
            f = factors[race, :, min(j, last)]
            unit = corrected(hertz, FactorNumbers(f[0], f[1], f[2], f[3]))
            for k in range(len(unit)):
                point.unit[race, k, j] = unit[k]


@compiled
def _hold_ruled_forces(ring: RingNumbers, rule: TurningRule, point: RingPoint) -> None:
    """Write what acts on balls that turn by rule."""
    most = np.pi / 2  # before it settles a ball may leave its groove
    for j in range(len(point.own)):
        angles = min(max(point.angle[0, j], -most), most), min(max(point.angle[1, j], -most), most)
        forces = ruled_forces(ring.bearing, rule, angles, (point.load[0, j], point.load[1, j]))
        for k in range(len(forces)):
            point.turning[k, j] = forces[k]


@compiled
def _hold_forces(rows: BallRows, force: Array, point: RingPoint, work: RingWork, share: float) -> float:
    """Write the forces on ring and balls, and return by how much the largest component changes, N.

    force : load on the ring;  share : of the way from the last forces to those that `turning` gives
    """
    ring_force, own = work.gradient, work.own
    for i in range(ring_force.size):
        ring_force[i] = force[i]
    largest = change = 0.0
    for j in range(len(own)):
        inner, outer = point.angle[0, j], point.angle[1, j]
        at_inner, at_outer = point.turning[1, j], point.turning[2, j]
        friction = (at_inner * np.sin(inner), -at_inner * np.cos(inner))
        own[j, 0] = point.turning[0, j] + friction[0] - at_outer * np.sin(outer) + rows.weight[j, 0]
        own[j, 1] = friction[1] + at_outer * np.cos(outer) + rows.weight[j, 1]
        point.friction[j, 0], point.friction[j, 1] = friction
        for i in range(FREEDOMS):
            ring_force[i] -= rows.travel[j, 0, i] * friction[0] + rows.travel[j, 1, i] * friction[1]
        largest = max(largest, own[j, 0] ** 2 + own[j, 1] ** 2)
    for j in range(len(own)):
        is_remainder = own[j, 0] ** 2 + own[j, 1] ** 2 <= FORCE_ROUND_OFF**2 * largest
        for k in range(2):
            now = 0.0 if is_remainder else own[j, k]
            step = now - point.own[j, k]
            point.own[j, k] = now if share == 1 else point.own[j, k] + share * step
            change = max(change, share * abs(step))
    for i in range(FREEDOMS):
        step = ring_force[i] - point.ring_force[i]
        point.ring_force[i] = ring_force[i] if share == 1 else point.ring_force[i] + share * step
        change = max(change, share * abs(step))
    return change


@compiled
def _place_by_load(rows: BallRows, force: Array, point: RingPoint) -> None:
    """Write a place where balls touch.

    It is the displacement by each part of the load if one ball took it, with the largest part in full.
    """
    play, distance = rows.grooves.play, rows.grooves.distance
    parts = (abs(force[0]), np.hypot(force[1], force[2]), np.hypot(force[3], force[4]))
    largest, softness = max(max(parts[0], parts[1]), parts[2]), point.unit[0, APPROACH, 0] + point.unit[1, APPROACH, 0]
    for i in range(FREEDOMS):
        part = parts[(i + 1) // 2]
        if part > 0:
            approach = softness * np.cbrt(part) ** 2
            if i == 1 or i == 2:
                reach = approach + max(play, 0.0)
            else:
                reach = np.sqrt(max((approach + play) * (2 * distance + approach - play), 0.0))
            point.place[i] = force[i] / largest * reach
        else:
            point.place[i] = 0.0


@compiled
def _begin(ring: RingNumbers, load: RingLoad, point: RingPoint, start: int) -> None:
    """Write the contacts that a point begins with, and what it does not yet hold; all forces are then to change."""
    if start != BY_POINT:
        point.angle[:], point.load[:], point.moved[:] = ring.angle, 0.0, 0.0
        point.own[:], point.ring_force[:] = np.inf, np.inf
    hold_contacts(ring, load.factors, point)
    if start == BY_LOAD:
        _place_by_load(ring.rows, load.force, point)


@compiled
def beyond_groove(rows: BallRows, point: RingPoint) -> Beyond:
    """A ball of a settled ring that no groove bears any more, because its contact angle is beyond pi/2."""
    distance, play = rows.grooves.distance, rows.grooves.play
    farthest, moved, has_passed = np.pi / 2, 0.0, False
    for j in range(len(point.own)):
        radial = 0.0
        for i in range(FREEDOMS):
            radial += rows.travel[j, 0, i] * point.place[i]
        moved = max(moved, abs(radial))
        passed = distance - play + radial < 0  # the centres of the grooves, each other; no inertia of balls does that
        for race in range(2):
            angle = abs(point.angle[race, j])
            if angle > farthest and (passed or point.load[race, j] > 0):
                farthest, has_passed = angle, passed
    if farthest == np.pi / 2:
        return Beyond(0.0, moved, False)
    # A move by that much is the load's, whatever inertia adds.
    return Beyond(farthest, moved, has_passed or moved > max(play, 0.0) + distance / 2)


@compiled
def settle_round(rows: BallRows, force: Array, point: RingPoint, work: RingWork, number: int, accuracy: float) -> Round:
    """One round, for which contacts and turning are written.

    number : of the round, from 0;  accuracy : relative, of the forces that turning gives; 0: they are exact
    """
    change = _hold_forces(rows, force, point, work, 0.5 if number > STEADYING else 1.0)
    heaviest = np.max(point.load[1])
    balance, steps = settle_ring(rows, point, work)
    for race in range(2):
        for j in range(len(point.own)):
            point.angle[race, j] = np.arctan2(work.arm[race, j, 1], work.arm[race, j, 0])
    if balance.has_loose_ball:
        return Round(LOOSE_BALL, steps, balance.left, balance.tolerance)
    if steps == MOST_STEPS or np.isnan(balance.left):
        return Round(LOOSE_RING, steps, balance.left, balance.tolerance)
    # The ring does not notice the force of a ball that floats or is wedged: that has to settle too.
    enough = max(balance.tolerance, accuracy * heaviest)
    if change > enough or (steps > 0 and accuracy == 0):
        return Round(OPEN, steps, change, enough)
    end = BEYOND_GROOVE if beyond_groove(rows, point).angle > 0 else SETTLED
    return Round(end, steps, balance.left, balance.tolerance)


@compiled
def settle_ruled_ring(ring: RingNumbers, load: RingLoad, point: RingPoint, work: RingWork, start: int) -> Round:
    """All rounds of a point whose balls turn by rule; writes the point.

    start : BY_LOAD; BY_PLACE, where the point holds a place with balls that touch; or BY_POINT, where it has settled
        under nearly the same load or factors. The equilibrium does not depend on it.
    """
    _begin(ring, load, point, start)
    end, steps = Round(OPEN, 0, 0.0, 0.0), 0
    for number in range(MOST_ROUNDS + 1):
        if number > 0:
            hold_contacts(ring, load.factors, point)
        _hold_ruled_forces(ring, load.rule, point)
        end = settle_round(ring.rows, load.force, point, work, number, 0.0)
        steps += end.steps
        if end.end != OPEN:
            break
    return Round(end.end, steps, end.left, end.tolerance)


class Rounds(NamedTuple):
    """`Round` of n points."""

    end: NDArray[np.int64]
    steps: NDArray[np.int64]
    left: Array
    tolerance: Array


def rounds_of(count: int) -> Rounds:
    """Arrays for n points."""
    return Rounds(
        end=np.zeros(count, dtype=np.int64),
        steps=np.zeros(count, dtype=np.int64),
        left=np.zeros(count),
        tolerance=np.zeros(count),
    )


@compiled
def _note(rounds: Rounds, i: int, end: Round) -> None:
    rounds.end[i], rounds.left[i], rounds.tolerance[i] = end.end, end.left, end.tolerance
    rounds.steps[i] += end.steps


@compiled
def load_of(loads: RingLoads, i: int) -> RingLoad:
    """One of n points."""
    rule = TurningRule(loads.inner_speed[i], loads.inertia[0], loads.inertia[1])
    return RingLoad(loads.force[i], rule, loads.factors[min(i, len(loads.factors) - 1)])


@compiled
def settle_ruled_rings(
    ring: RingNumbers, loads: RingLoads, points: RingPoint, work: RingWork, rounds: Rounds, start: int
) -> None:
    """`settle_ruled_ring` of n points, up to the first that does not settle."""
    for i in range(len(loads.force)):
        end = settle_ruled_ring(ring, load_of(loads, i), point_of(points, i), work, start)
        _note(rounds, i, end)
        if end.end != SETTLED:
            return
