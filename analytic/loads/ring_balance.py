"""Rows of balls on one rigid inner part with five freedoms: the place of least energy for held stiffness and forces.

A row is a bearing on its shaft. A single ring has one row, a pair of bearings two. `analytic.loads.ring` says what the
freedoms and the angles are; `analytic.loads.ball_balance` settles each ball, and `analytic.loads.ring_rounds` lets
stiffness and forces follow the angles. Forces of a ring are N; moments are over the arm R, tilts times R.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.errors import InputError
from analytic.loads.ball_balance import Grooves, Tangent, contact_tangent, in_series, settled_ball
from analytic.loads.state import FREEDOMS, ball_states
from analytic.numerics.compilation import compiled
from analytic.numerics.newton import MOST_STEPS, is_too_long, newton_step
from analytic.numerics.records import Record, Records
from analytic.numerics.root import cube_root
from analytic.scene import Array, Bearing

# Of the load and the largest ball load: Newton's quadratic steps reach it at once, and rounding is a thousandth of it.
TOLERANCE = 1e-12
# Of the ring's load, a judgement: a ball that all but leaves a race swings by less, which no torque shows.
UNLOADED = 1e-10
# Of a displacement, in the balls' stiffness: what rounding of the ring's place leaves as force.
PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps
# Of A0, likewise: the place of a ball under a force of its own is computed from the grooves' centres.
BALL_ROUND_OFF = 16 * np.finfo(np.float64).eps
# Of the balls' loads times A0, whose rounding moves them, or times the way of a load that no bearing survives.
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps
LEAST_BALLS = 3  # of a row that hold a ring in all five freedoms

Weight = tuple[float, float, float]


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


def require_enough_balls(bearing: Bearing) -> None:
    """Raise InputError for a row of balls that carries thrust alone."""
    if bearing.ball_count < LEAST_BALLS:
        raise InputError(
            f"ball_count = {bearing.ball_count} carries thrust alone: a radial load or a moment needs at least "
            f"{LEAST_BALLS} balls"
        )


def placed_balls(bearing: Bearing, rows: tuple[Row, ...] = (Row(),), weight: Weight = (0.0, 0.0, 0.0)) -> Records:
    """(Z,) `state.BALL_STATE` of the balls of all rows; weight : of each ball along x, y and z of the shaft, N."""
    _, azimuth, offset, travel = groove_travel(bearing, rows)
    side = np.repeat([row.side for row in rows], bearing.ball_count)
    balls = ball_states(azimuth.size)
    balls["offset"], balls["travel"] = offset, travel
    x, y, z = weight
    balls["weight"] = np.stack([x * np.cos(azimuth) + y * np.sin(azimuth), side * z], axis=-1)
    return balls


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
def _balance_at(grooves: Grooves, ring: Record, balls: Records) -> Balance:
    """The balance of a ring at its place, with its balls settled; writes their forces and the tangent."""
    distance, place, tangent, gradient = grooves.distance, ring.place, ring.tangent, ring.gradient
    energy = stiffness = heaviest = most = reach = trace = all_loads = farthest = left = 0.0
    has_own_force = False
    for i in range(FREEDOMS):
        gradient[i] = -ring.force[i]
        energy -= ring.force[i] * place[i]
        most, reach = max(most, abs(ring.force[i])), max(reach, abs(place[i]))
        for k in range(i + 1):
            tangent[i, k] = 0.0
    for j in range(len(balls)):
        ball = balls[j]
        travel, own = ball.travel, (ball.own[0], ball.own[1])
        radial, axial = 0.0, ball.offset
        for i in range(FREEDOMS):
            radial += travel[0, i] * place[i]
            axial += travel[1, i] * place[i]
        softness = (ball.inner_unit.approach, ball.outer_unit.approach)
        settled = settled_ball(grooves, (radial, axial), softness, own, (ball.moved[0], ball.moved[1]))
        if not settled.left <= max(settled.tolerance, UNLOADED * most):
            return Balance(energy, 0.0, settled.left, settled.tolerance, distance, True)
        for k in range(2):
            ball.force[k], ball.moved[k] = settled.force[k], settled.moved[k]
            ball.inner_arm[k], ball.outer_arm[k] = settled.inner_arm[k], settled.outer_arm[k]
        ball.load[0], ball.load[1] = settled.inner_load, settled.outer_load
        for i in range(FREEDOMS):
            gradient[i] += travel[0, i] * settled.force[0] + travel[1, i] * settled.force[1]
        add_stiffness(tangent, settled.tangent, travel)
        energy += settled.energy
        all_loads += settled.outer_load
        heaviest, farthest = max(heaviest, settled.outer_load), max(farthest, abs(ball.offset))
        if own[0] != 0.0 or own[1] != 0.0:
            has_own_force = True
        stiffness += 1.5 * cube_root(settled.inner_load) / softness[0]  # dQ/d delta, N/m
    for i in range(FREEDOMS):
        if i < FREEDOMS - ring.held:
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
def settle_ring(grooves: Grooves, ring: Record, balls: Records) -> tuple[Balance, int]:
    """Move a ring to the place of least energy of what is held; the balance there, and Newton's steps to it.

    Freedoms of the ring that are held keep their place, and the gradient is what holds them.
    """
    moving = FREEDOMS - ring.held
    place, origin, step = ring.place, ring.origin, ring.step[:moving]
    tangent, gradient, factor = ring.tangent[:moving, :moving], ring.gradient[:moving], ring.factor[:moving, :moving]
    now = _balance_at(grooves, ring, balls)
    steps = 0
    while now.left > now.tolerance and steps < MOST_STEPS and not now.has_loose_ball:
        promised = newton_step(tangent, gradient, now.longest_step, factor, step)
        for i in range(moving):
            origin[i] = place[i]
        energy, rounding, share = now.energy, now.energy_rounding, 1.0
        while True:
            for i in range(moving):
                place[i] = origin[i] + share * step[i]
            now = _balance_at(grooves, ring, balls)
            if not is_too_long(energy, now.energy, share * promised, rounding):
                break
            share /= 2
        steps += 1
    return now, steps


@compiled
def stiffness_of_rings(springs: Array, travel: Array) -> Array:
    """(n, 5, 5), N/m; springs : (4, n, 2, Z) stiffness along and across the normal, and the normal, of each contact"""
    stiffness = np.zeros((springs.shape[1], FREEDOMS, FREEDOMS))
    for i in range(len(stiffness)):
        for j in range(len(travel)):
            along, across, radial, axial = springs[:, i, :, j]
            inner = contact_tangent(along[0], across[0], (radial[0], axial[0]))
            outer = contact_tangent(along[1], across[1], (radial[1], axial[1]))
            add_stiffness(stiffness[i], in_series(inner, outer), travel[j])
        mirror(stiffness[i])
    return stiffness
