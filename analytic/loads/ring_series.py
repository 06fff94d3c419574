"""Rings of many operating points at rest: their balls' loads, and refusal of loads that drive balls out of a groove."""

from dataclasses import dataclass
from functools import cached_property
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection, factor_fields
from analytic.contact.hertz import HertzContact, HertzNumbers
from analytic.errors import ConvergenceError, InputError
from analytic.loads.ball_balance import grooves_of
from analytic.loads.numbers import bearing_numbers
from analytic.loads.ring_balance import (
    BallRows,
    GrooveTravel,
    RingPoint,
    Row,
    groove_travel,
    point_of,
    ring_points,
    ring_work,
)
from analytic.loads.ring_rounds import (
    BEYOND_GROOVE,
    BY_LOAD,
    BY_PLACE,
    LOOSE_BALL,
    LOOSE_RING,
    MOST_ROUNDS,
    OPEN,
    Beyond,
    RingLoads,
    RingNumbers,
    Rounds,
    beyond_groove,
    rounds_of,
    settle_ruled_rings,
)
from analytic.loads.turning import RuledTurning
from analytic.numerics.newton import MOST_STEPS
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle
from analytic.words import angle_of, length_of, speed_of

# What did not settle, the limit of its iterations, and a remedy
LOOSE = {
    LOOSE_BALL: ("a ball between its races", MOST_STEPS, "Check the speed and the ball's mass for a slipped unit."),
    LOOSE_RING: (
        "the ring's equilibrium",
        MOST_STEPS,
        "Check the loads, the speed, the clearance and the materials for a slipped unit.",
    ),
    OPEN: (
        "the balls' own forces in the ring's equilibrium",
        MOST_ROUNDS,
        "Raise the load or lower the speed: the gyroscopic moment needs more friction than the balance has.",
    ),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class RowsOfBalls:
    """Rows of balls on one inner part, at n operating points."""

    bearing: Bearing
    play: float  # m, as Grooves has it
    correction: ContactCorrection  # numbers, or (n, Z) for the balls of all rows
    turning: RuledTurning
    speed: Array  # (n,) of the inner part, rad/s
    ball_weight: tuple[float, float, float] = (0.0, 0.0, 0.0)  # of each ball along x, y and z of the shaft, N
    rows: tuple[Row, ...] = (Row(),)

    @cached_property
    def travel(self) -> GrooveTravel:
        return groove_travel(self.bearing, self.rows)

    @cached_property
    def numbers(self) -> BallRows:
        _, azimuth, offset, travel = self.travel
        side = np.repeat([row.side for row in self.rows], self.bearing.ball_count)
        x, y, z = self.ball_weight
        weight = np.stack([x * np.cos(azimuth) + y * np.sin(azimuth), side * z], axis=-1)
        return BallRows(grooves_of(self.bearing, self.play), offset, travel, weight)

    def displaced(self, place: Array) -> tuple[Array, Array]:
        """(n, Z) radial and axial displacement of the inner groove at each ball, m; place : (n, 5), m"""
        radial, axial = np.moveaxis(self.travel.travel, 1, 0)
        return place @ radial.T, place @ axial.T + self.travel.offset


def ring_numbers(
    bearing: Bearing, contact_angle: ContactAngle, *, down: tuple[float, float, float] | None
) -> tuple[RingNumbers, float]:
    """One row of balls, and the arm R of its inner groove centres, m.

    down : direction of the balls' weight, of length 1; None: left out
    A given contact angle has no play; the ring is not solved for then. Raises InputError as bearing_numbers does.
    """
    numbers, still = bearing_numbers(bearing, contact_angle), np.zeros(1)
    x, y, z = bearing.ball_mass * STANDARD_GRAVITY * np.array(down or (0.0, 0.0, 0.0))
    rows = RowsOfBalls(
        bearing=bearing,
        play=_known(numbers.play),
        correction=ContactCorrection(),
        turning=RuledTurning(bearing=bearing, inner_speed=still, centrifugal=False, gyroscopic=False),
        speed=still,
        ball_weight=(float(x), float(y), float(z)),
    )
    return RingNumbers(numbers, rows.numbers, _known(numbers.free_angle)), rows.travel.arm


def _known(number: float) -> float:
    return 0.0 if np.isnan(number) else number


@dataclass(frozen=True, kw_only=True, eq=False)
class RingsAtRest:
    """n rings in equilibrium, with Z balls in all rows."""

    place: Array  # (n, 5) m, tilts times R
    tangent: Array  # (n, 5, 5) N/m
    residual: Array  # (n,) largest unbalanced force, N
    steps: NDArray[np.int64]  # (n,) of Newton's method
    force: Array  # (n, Z, 2) of each ball on the inner groove, by contact and friction, N
    inner_load: Array  # (n, Z) N
    outer_load: Array
    inner_angle: Array  # (n, Z) rad
    outer_angle: Array
    inner: HertzContact  # (n, Z) under 1 N
    outer: HertzContact
    centrifugal_force: Array  # (n, Z) N
    gyroscopic_moment: Array  # (n, Z) N m


def settled_rings(ring: RowsOfBalls, load: Array, *, angle: float, place: Array | None = None) -> RingsAtRest:
    """The rings at rest under loads (n, 5), N (moments over R).

    angle : near which the contact angles are, rad;  place : (n, 5) to begin at, where balls touch; None: by the load
    Raises ConvergenceError where a ball, a ring or the rounds do not settle, and InputError where a ball leaves its
    groove (an angle beyond pi/2).
    """
    turning, count, balls = ring.turning, len(load), len(ring.travel.travel)
    numbers = RingNumbers(bearing_numbers(ring.bearing), ring.numbers, float(angle))
    points, rounds, start = ring_points(count, balls), rounds_of(count), BY_LOAD if place is None else BY_PLACE
    points.place[:] = 0.0 if place is None else place
    loads = RingLoads(
        force=np.array(load, dtype=np.float64),
        inner_speed=np.array(turning.inner_speed, dtype=np.float64),
        inertia=(bool(turning.centrifugal), bool(turning.gyroscopic)),
        factors=factors_of(ring.correction),
    )
    settle_ruled_rings(numbers, loads, points, ring_work(balls), rounds, start)
    require_settled(ring.bearing, ring.numbers, ring.speed, loads, points, rounds)
    inner, outer = _contacts(points.unit)
    return RingsAtRest(
        place=points.place,
        tangent=points.tangent,
        residual=rounds.left,
        steps=rounds.steps,
        force=points.force + points.friction,
        inner_load=points.load[:, 0],
        outer_load=points.load[:, 1],
        inner_angle=points.angle[:, 0],
        outer_angle=points.angle[:, 1],
        inner=inner,
        outer=outer,
        centrifugal_force=points.turning[:, 0],
        gyroscopic_moment=points.turning[:, 3],
    )


def _contacts(unit: Array) -> tuple[HertzContact, HertzContact]:
    """On inner and outer race, from (n, 2, 5, Z)."""
    inner, outer = (dict(zip(HertzNumbers._fields, np.moveaxis(unit[:, race], 1, 0), strict=True)) for race in (0, 1))
    return HertzContact(**inner), HertzContact(**outer)


def require_settled(
    bearing: Bearing, rows: BallRows, speed: Array, loads: RingLoads, points: RingPoint, rounds: Rounds
) -> None:
    """Raise ConvergenceError or InputError for the worst of n points, see `settled_rings`; speed : (n,)"""
    if not rounds.end.any():
        return
    worst = int(np.argmax(rounds.end))
    if rounds.end[worst] == BEYOND_GROOVE:
        weight = bearing.ball_mass * STANDARD_GRAVITY * len(rows.weight) if np.any(rows.weight) else 0.0
        beyond = beyond_groove(rows, point_of(points, worst))
        _refuse(bearing, loads.force[worst], weight, float(speed[worst]), beyond)
    problem, iterations, remedy = LOOSE[int(rounds.end[worst])]
    left, tolerance = float(rounds.left[worst]), float(rounds.tolerance[worst])
    raise ConvergenceError(iterations=iterations, residual=left, tolerance=tolerance, problem=problem, remedy=remedy)


def _refuse(bearing: Bearing, load: Array, weight: float, speed: float, beyond: Beyond) -> NoReturn:
    """Raise InputError for a point whose ball has left its groove; load : (5,);  weight : of all balls, N"""
    if beyond.is_by_load and weight > np.max(np.abs(load)):
        raise InputError(
            f"the weight of the balls, {weight:.3g} N, moves the rings by {length_of(beyond.moved, '.2g')}, and "
            "balls leave their grooves: take stiffer materials"
        )
    if beyond.is_by_load:
        raise InputError(
            f"the {_load_words(load, bearing)} moves the rings by {length_of(beyond.moved, '.2g')}, and balls leave "
            "their grooves: lower the load"
        )
    raise InputError(
        f"the speed, {speed_of(speed)}, drives a ball {angle_of(beyond.angle)} out of its groove, past 90 deg: no "
        "contact bears it, lower the speed"
    )


def factors_of(correction: ContactCorrection) -> Array:
    """(n, 2, 4, Z) with axes of 1 where all points or all balls have the same factors."""
    given = [np.asarray(value) for side in (correction.inner, correction.outer) for value in factor_fields(side)]
    together = np.stack(np.broadcast_arrays(*(value.reshape(value.shape or (1, 1)) for value in given)), axis=1)
    return np.array(together.reshape(len(together), 2, 4, -1), dtype=np.float64)


def _load_words(load: Array, bearing: Bearing) -> str:
    """The load of a point, (5,), and how many times the static load rating of the bearing it is."""
    arm = groove_travel(bearing).arm
    axial, radial, moment = np.abs(load[0]), np.hypot(load[1], load[2]), np.hypot(load[3], load[4]) * arm
    parts = (("axial load", axial, "kN"), ("radial load", radial, "kN"), ("moment", moment, "kN m"))
    named = " and ".join(f"{name} of {value / 1e3:.4g} {unit}" for name, value, unit in parts if value > 0) or "preload"
    rating, largest = bearing.static_load_rating, max(axial, radial)
    if rating is None or largest <= rating:
        return named
    return f"{named}, {largest / rating:.2g} times the static load rating C0 = {rating / 1e3:.4g} kN,"
