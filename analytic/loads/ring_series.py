"""Rings of many operating points at rest: their balls' loads, and refusal of loads that drive balls out of a groove."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection, FactorNumbers, factor_fields
from analytic.contact.hertz import HertzContact, HertzNumbers
from analytic.errors import ConvergenceError, InputError
from analytic.loads.ball_balance import Grooves, grooves_of
from analytic.loads.numbers import bearing_numbers
from analytic.loads.ring_balance import GrooveTravel, Row, Weight, groove_travel, placed_balls
from analytic.loads.ring_rounds import (
    BEYOND_GROOVE,
    BY_LOAD,
    BY_PLACE,
    LOOSE_BALL,
    LOOSE_RING,
    MOST_ROUNDS,
    OPEN,
    ROUND,
    Beyond,
    RingNumbers,
    beyond_groove,
    settle_ruled_rings,
)
from analytic.loads.state import RING_STATE, TILTS
from analytic.loads.turning import RuledTurning
from analytic.numerics.newton import MOST_STEPS
from analytic.numerics.records import Record, Records, as_record, record_of
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
    ball_weight: Weight = (0.0, 0.0, 0.0)  # of each ball along x, y and z of the shaft, N
    rows: tuple[Row, ...] = (Row(),)

    @cached_property
    def travel(self) -> GrooveTravel:
        return groove_travel(self.bearing, self.rows)

    @cached_property
    def grooves(self) -> Grooves:
        return grooves_of(self.bearing, self.play)

    def displaced(self, place: Array) -> tuple[Array, Array]:
        """(n, Z) radial and axial displacement of the inner groove at each ball, m; place : (n, 5), m"""
        radial, axial = np.moveaxis(self.travel.travel, 1, 0)
        return place @ radial.T, place @ axial.T + self.travel.offset


def ring_numbers(bearing: Bearing, contact_angle: ContactAngle) -> RingNumbers:
    """A ring of one row of balls; a given contact angle has no play, and the ring is not solved for then.

    Raises InputError as bearing_numbers does.
    """
    numbers = bearing_numbers(bearing, contact_angle)
    return RingNumbers(numbers, grooves_of(bearing, _known(numbers.play)), _known(numbers.free_angle))


def weight_of_ball(bearing: Bearing, down: tuple[float, float, float] | None) -> Weight:
    """Along x, y and z, N; down : direction of gravity, of length 1; None: left out."""
    x, y, z = bearing.ball_mass * STANDARD_GRAVITY * np.array(down or (0.0, 0.0, 0.0))
    return float(x), float(y), float(z)


def _known(number: float) -> float:
    return 0.0 if np.isnan(number) else number


@dataclass(frozen=True, kw_only=True, eq=False)
class RingsAtRest:
    """n rings in equilibrium, with Z balls in all rows."""

    load: Array  # (n, 5) that balances the balls, N, moments over R: given, or what holds the tilts
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


def settled_rings(
    ring: RowsOfBalls, load: Array, *, angle: float, place: Array | None = None, tilts: Array | None = None
) -> RingsAtRest:
    """The rings at rest under loads (n, 5), N (moments over R).

    angle : near which the contact angles are, rad;  place : (n, 5) to begin at, where balls touch; None: by the load
    tilts : (n, 2) about x and y at which the rings are held, without moments, m (times R); None: they are free
    Raises ConvergenceError where a ball, a ring or the rounds do not settle, and InputError where a ball leaves its
    groove (an angle beyond pi/2).
    """
    turning, count = ring.turning, len(load)
    numbers = record_of(RingNumbers(bearing_numbers(ring.bearing), ring.grooves, float(angle)))
    rings = np.zeros(count, RING_STATE)
    rings["load"], rings["place"] = load, 0.0 if place is None else place
    if tilts is not None:
        rings["held"], rings["place"][:, -TILTS:] = TILTS, tilts
    balls = np.repeat(placed_balls(ring.bearing, ring.rows, ring.ball_weight)[None], count, axis=0)
    correct_balls(balls, factors_of(ring.correction))
    ends, inertia = np.zeros(count, ROUND), (bool(turning.centrifugal), bool(turning.gyroscopic))
    speed, start = np.array(turning.inner_speed, dtype=np.float64), BY_LOAD if place is None else BY_PLACE
    settle_ruled_rings(numbers, speed, inertia, rings, balls, ends, start)
    if ends["end"].any():
        worst = int(np.argmax(ends["end"]))
        raise unsettled_ring(ring.bearing, ring.grooves, float(speed[worst]), rings[worst], balls[worst], ends[worst])
    if tilts is not None:
        rings["load"][:, -TILTS:] = rings["gradient"][:, -TILTS:]
    return RingsAtRest(
        load=rings["load"],
        place=rings["place"],
        tangent=rings["tangent"],
        residual=ends["left"],
        steps=ends["steps"],
        force=balls["force"] + balls["friction"],
        inner_load=balls["load"][..., 0],
        outer_load=balls["load"][..., 1],
        inner_angle=balls["angle"][..., 0],
        outer_angle=balls["angle"][..., 1],
        inner=HertzContact(**{name: balls["inner_unit"][name] for name in HertzNumbers._fields}),
        outer=HertzContact(**{name: balls["outer_unit"][name] for name in HertzNumbers._fields}),
        centrifugal_force=balls["turning"]["centrifugal"],
        gyroscopic_moment=balls["turning"]["gyroscopic"],
    )


def correct_balls(balls: Records, factors: Array) -> None:
    """Write the factors on Hertz's contacts; balls : (n, Z);  factors : (n or 1, 2, 4, Z or 1)"""
    for race, side in enumerate(("inner_factors", "outer_factors")):
        for place, name in enumerate(FactorNumbers._fields):
            balls[side][name] = factors[:, race, place]


def unsettled_ring(
    bearing: Bearing, grooves: Grooves, speed: float, ring: Record, balls: Records, end: Record
) -> ConvergenceError | InputError:
    """The error of a ring that has not settled; speed : rad/s;  balls : (Z,);  end : of ROUND"""
    if end["end"] == BEYOND_GROOVE:
        weight = bearing.ball_mass * STANDARD_GRAVITY if np.any(balls["weight"]) else 0.0
        beyond, outward = beyond_groove(grooves, as_record(ring), balls), float(balls["turning"]["centrifugal"].max())
        if not beyond.is_by_load and weight > outward:
            return InputError(
                f"the weight of a ball, {weight:.3g} N, drives it {angle_of(beyond.angle)} along its groove, past "
                f'90 deg, under {np.max(np.abs(ring["load"])):.3g} N: raise the load, or give effects.weight = "off"'
            )
        return _left_groove(bearing, ring["load"], weight * len(balls), speed, beyond)
    problem, iterations, remedy = LOOSE[int(end["end"])]
    if end["end"] == OPEN and np.any(balls["weight"]):
        remedy = 'Change the speed, or give effects.weight = "off": a ball\'s weight and inertia all but cancel.'
    return ConvergenceError(
        iterations=iterations,
        residual=float(end["left"]),
        tolerance=float(end["tolerance"]),
        problem=problem,
        remedy=remedy,
    )


def _left_groove(bearing: Bearing, load: Array, weight: float, speed: float, beyond: Beyond) -> InputError:
    """The error of a point whose ball has left its groove; load : (5,);  weight : of all balls, N"""
    if beyond.is_by_load and weight > np.max(np.abs(load)):
        return InputError(
            f"the weight of the balls, {weight:.3g} N, moves the rings by {length_of(beyond.moved, '.2g')}, and "
            "balls leave their grooves: take stiffer materials"
        )
    if beyond.is_by_load:
        return InputError(
            f"the {_load_words(load, bearing)} moves the rings by {length_of(beyond.moved, '.2g')}, and balls leave "
            "their grooves: lower the load"
        )
    return InputError(
        f"the speed, {speed_of(speed)}, moves a ball {angle_of(beyond.angle)} out of its groove, past 90 deg, without "
        "contact: lower the speed"
    )


def factors_of(correction: ContactCorrection) -> Array:
    """(n, 2, 4, Z) with axes of 1 where all points or all balls have the same factors; one of (n,) is of all balls."""
    given = [np.asarray(value) for side in (correction.inner, correction.outer) for value in factor_fields(side)]
    each = (value if value.ndim > 1 else value.reshape(-1, 1) for value in given)
    together = np.stack(np.broadcast_arrays(*each), axis=1)
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
