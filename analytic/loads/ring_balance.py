"""Rows of balls on one rigid inner part with five freedoms: the place of least energy for held stiffness and forces.

A row is a bearing on its shaft. A single ring has one row, a pair of bearings two. `analytic.loads.ring` says what the
freedoms and the angles are; `analytic.loads.ball_balance` settles each ball, and `analytic.loads.ring_rounds` lets
stiffness and forces follow the angles. Forces of a ring are N; moments are over the arm R, tilts times R.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import HertzNumbers
from analytic.loads.ball_balance import Grooves, Tangent, settled_ball
from analytic.numerics.compilation import compiled
from analytic.numerics.newton import MOST_STEPS, is_too_long, newton_step
from analytic.scene import Array, Bearing

# Of the load and the largest ball load: Newton's quadratic steps reach it at once, and rounding is a thousandth of it.
TOLERANCE = 1e-12
# Of a displacement, in the balls' stiffness: what rounding of the ring's place leaves as force.
PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps
# Of A0, likewise: the place of a ball under a force of its own is computed from the grooves' centres.
BALL_ROUND_OFF = 16 * np.finfo(np.float64).eps
# Of the balls' loads times A0, whose rounding moves them, or times the way of a load that no bearing survives.
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps
LEAST_BALLS = 3  # of a row that hold a ring in all five freedoms
FREEDOMS = 5
APPROACH = HertzNumbers._fields.index("approach")


@dataclass(frozen=True, kw_only=True)
class Row:
    """A row of balls on the shaft; in its own frame thrust along z loads it."""

    side: int = 1  # -1: its z points against that of the shaft
    position: float = 0.0  # of the circle of its inner groove centres along the shaft's z, m
    offset: float = 0.0  # of its inner groove along its own z where the shaft is not displaced, m


class GrooveTravel(NamedTuple):
    """How the inner groove at each of Z balls follows the five freedoms of the inner part."""

    arm: float  # R, m
    azimuth: Array  # (Z,) rad
    offset: Array  # (Z,) along z where nothing is displaced, m
    travel: Array  # (Z, 2, 5) radial and axial, by each freedom; tilts times R


class BallRows(NamedTuple):
    """The balls of all rows as their ring sees them."""

    grooves: Grooves
    offset: Array  # (Z,) as GrooveTravel has them
    travel: Array  # (Z, 2, 5)
    weight: Array  # (Z, 2) radial and axial, N


class RingPoint(NamedTuple):
    """A ring at one operating point: what a round holds, and then the balls at its place; races are inner and outer."""

    unit: Array  # (2, 5, Z) contacts under 1 N, with the fields of HertzNumbers
    turning: Array  # (4, Z) what acts on the balls because they turn, as ForcesOfTurning
    own: Array  # (Z, 2) force of the ball's own, N
    friction: Array  # (Z, 2) of the ball on the inner groove, N
    ring_force: Array  # (5,) load and friction of the balls
    place: Array  # (5,) m
    tangent: Array  # (5, 5) second derivative of the energy, N/m
    force: Array  # (Z, 2) of the contact on the inner groove, N
    load: Array  # (2, Z) Q, N
    angle: Array  # (2, Z) al, rad
    moved: Array  # (Z, 2) balls by their own force, m; a start


class RingWork(NamedTuple):
    """Arrays to work in, which one ring after the other may use."""

    arm: Array  # (2, Z, 2) as BallBalance has them, m
    own: Array  # (Z, 2) of the next round
    gradient: Array  # (5,)
    step: Array  # (5,)
    origin: Array  # (5,) place from which a step goes
    factor: Array  # (5, 5)


class Balance(NamedTuple):
    """How a ring at a place is in balance."""

    energy: float  # J
    energy_rounding: float  # J
    left: float  # largest unbalanced force, N; of a ball where one did not settle
    tolerance: float  # on it, N
    longest_step: float  # m
    has_loose_ball: bool  # which did not settle


def groove_travel(bearing: Bearing, rows: tuple[Row, ...] = (Row(),)) -> GrooveTravel:
    """The travel of the grooves; fewer than three balls in a row hold z alone."""
    arm = bearing.inner.bottom_radius + bearing.inner.groove_radius
    around = 2 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
    azimuth = np.tile(around, len(rows))
    side, position, offset = (
        np.repeat([getattr(row, name) for row in rows], bearing.ball_count) for name in ("side", "position", "offset")
    )
    cosine, sine, zero = np.cos(azimuth), np.sin(azimuth), np.zeros(azimuth.size)
    away = position / arm
    radial = np.stack([zero, cosine, sine, -away * sine, away * cosine])
    axial = side * np.stack([zero + 1, zero, zero, sine, -cosine])
    if bearing.ball_count < LEAST_BALLS:
        radial[1:], axial[1:] = 0.0, 0.0
    return GrooveTravel(arm, azimuth, offset, np.stack([radial.T, axial.T], axis=1))


def ring_points(count: int, balls: int) -> RingPoint:
    """Arrays for n points, with an axis for them in front."""
    return RingPoint(
        unit=np.zeros((count, 2, 5, balls)),
        turning=np.zeros((count, 4, balls)),
        own=np.zeros((count, balls, 2)),
        friction=np.zeros((count, balls, 2)),
        ring_force=np.zeros((count, FREEDOMS)),
        place=np.zeros((count, FREEDOMS)),
        tangent=np.zeros((count, FREEDOMS, FREEDOMS)),
        force=np.zeros((count, balls, 2)),
        load=np.zeros((count, 2, balls)),
        angle=np.zeros((count, 2, balls)),
        moved=np.zeros((count, balls, 2)),
    )


@compiled
def point_of(points: RingPoint, i: int) -> RingPoint:
    """One of n points."""
    return RingPoint(
        points.unit[i],
        points.turning[i],
        points.own[i],
        points.friction[i],
        points.ring_force[i],
        points.place[i],
        points.tangent[i],
        points.force[i],
        points.load[i],
        points.angle[i],
        points.moved[i],
    )


def ring_work(balls: int) -> RingWork:
    return RingWork(
        arm=np.zeros((2, balls, 2)),
        own=np.zeros((balls, 2)),
        gradient=np.zeros(FREEDOMS),
        step=np.zeros(FREEDOMS),
        origin=np.zeros(FREEDOMS),
        factor=np.zeros((FREEDOMS, FREEDOMS)),
    )


@compiled
def add_stiffness(tangent: Array, of_ball: Tangent, travel: Array) -> None:
    """Add a ball's tangent, N/m, to the lower half of that of the ring, (5, 5); travel : (2, 5) of its groove."""
    radial, mixed, axial = of_ball
    for i in range(FREEDOMS):
        along_radial = travel[0, i] * radial + travel[1, i] * mixed
        along_axial = travel[0, i] * mixed + travel[1, i] * axial
        for k in range(i + 1):
            tangent[i, k] += along_radial * travel[0, k] + along_axial * travel[1, k]


@compiled
def mirror(tangent: Array) -> None:
    """Write the upper half of a symmetric matrix from its lower one."""
    for i in range(len(tangent)):
        for k in range(i):
            tangent[k, i] = tangent[i, k]


@compiled
def _balance_at(rows: BallRows, point: RingPoint, work: RingWork) -> Balance:
    """The balance of a ring at its place, with its balls settled; writes their forces and the tangent."""
    distance, travel = rows.grooves.distance, rows.travel
    place, tangent, gradient = point.place, point.tangent, work.gradient
    energy = stiffness = heaviest = most = reach = trace = all_loads = farthest = left = 0.0
    has_own_force = False
    for i in range(FREEDOMS):
        gradient[i] = -point.ring_force[i]
        energy -= point.ring_force[i] * place[i]
        most, reach = max(most, abs(point.ring_force[i])), max(reach, abs(place[i]))
        for k in range(i + 1):
            tangent[i, k] = 0.0
    for j in range(len(travel)):
        radial, axial = 0.0, rows.offset[j]
        for i in range(FREEDOMS):
            radial += travel[j, 0, i] * place[i]
            axial += travel[j, 1, i] * place[i]
        softness, own = (point.unit[0, APPROACH, j], point.unit[1, APPROACH, j]), (point.own[j, 0], point.own[j, 1])
        ball = settled_ball(rows.grooves, (radial, axial), softness, own, (point.moved[j, 0], point.moved[j, 1]))
        if not ball.left <= ball.tolerance:
            return Balance(energy, 0.0, ball.left, ball.tolerance, distance, True)
        for k in range(2):
            point.force[j, k], point.moved[j, k] = ball.force[k], ball.moved[k]
            work.arm[0, j, k], work.arm[1, j, k] = ball.inner_arm[k], ball.outer_arm[k]
        point.load[0, j], point.load[1, j] = ball.inner_load, ball.outer_load
        for i in range(FREEDOMS):
            gradient[i] += travel[j, 0, i] * ball.force[0] + travel[j, 1, i] * ball.force[1]
        add_stiffness(tangent, ball.tangent, travel[j])
        energy += ball.energy
        all_loads += ball.outer_load
        heaviest, farthest = max(heaviest, ball.outer_load), max(farthest, abs(rows.offset[j]))
        if own[0] != 0.0 or own[1] != 0.0:
            has_own_force = True
        stiffness += 1.5 * np.cbrt(ball.inner_load) / softness[0]  # dQ/d delta, N/m
    for i in range(FREEDOMS):
        left = max(left, abs(gradient[i]))
        trace += tangent[i, i]
    mirror(tangent)
    longest = max(distance, reach + farthest)
    rounding = PLACE_ROUND_OFF * (reach + farthest) * trace
    if has_own_force:
        rounding += BALL_ROUND_OFF * distance * stiffness
    return Balance(
        energy=energy,
        energy_rounding=ENERGY_ROUND_OFF * longest * all_loads,
        left=np.nan if np.isnan(energy) else left,
        tolerance=TOLERANCE * (most + heaviest) + rounding,
        longest_step=longest,
        has_loose_ball=False,
    )


@compiled
def settle_ring(rows: BallRows, point: RingPoint, work: RingWork) -> tuple[Balance, int]:
    """Move a ring to the place of least energy of what is held; the balance there, and Newton's steps to it."""
    place, origin, step = point.place, work.origin, work.step
    now = _balance_at(rows, point, work)
    steps = 0
    while now.left > now.tolerance and steps < MOST_STEPS and not now.has_loose_ball:
        promised = newton_step(point.tangent, work.gradient, now.longest_step, work.factor, step)
        for i in range(FREEDOMS):
            origin[i] = place[i]
        energy, rounding, share = now.energy, now.energy_rounding, 1.0
        while True:
            for i in range(FREEDOMS):
                place[i] = origin[i] + share * step[i]
            now = _balance_at(rows, point, work)
            if not is_too_long(energy, now.energy, share * promised, rounding):
                break
            share /= 2
        steps += 1
    return now, steps
