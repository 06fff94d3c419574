"""Rings of many operating points at rest: their balls' loads, and refusal of loads that drive balls out of a groove."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from analytic.contact.factors import ContactCorrection
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
from analytic.loads.state import RING_STATE, TILTS, correct_balls, factors_of
from analytic.loads.turning import WHOLE_INERTIA, Inertia
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
    speed: Array  # (n,) of the inner part, rad/s
    inertia: Inertia = WHOLE_INERTIA
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


class SettledRings(NamedTuple):
    """n rings in equilibrium, with Z balls in all rows."""

    rings: Records  # (n,) of `state.RING_STATE`; the load of freedoms that are held is what holds them
    balls: Records  # (n, Z) of `state.BALL_STATE`
    ends: Records  # (n,) of `ring_rounds.ROUND`


def settled_rings(
    ring: RowsOfBalls, load: Array, *, angle: float, place: Array | None = None, tilts: Array | None = None
) -> SettledRings:
    """The rings at rest under loads (n, 5), N (moments over R).

    angle : near which the contact angles are, rad;  place : (n, 5) to begin at, where balls touch; None: by the load
    tilts : (n, 2) about x and y at which the rings are held, without moments, m (times R); None: they are free
    Raises ConvergenceError where a ball, a ring or the rounds do not settle, and InputError where a ball leaves its
    groove (an angle beyond pi/2).
    """
    count = len(load)
    numbers = record_of(RingNumbers(bearing_numbers(ring.bearing), ring.grooves, float(angle)))
    rings = np.zeros(count, RING_STATE)
    rings["load"], rings["place"] = load, 0.0 if place is None else place
    if tilts is not None:
        rings["held"], rings["place"][:, -TILTS:] = TILTS, tilts
    balls = np.repeat(placed_balls(ring.bearing, ring.rows, ring.ball_weight)[None], count, axis=0)
    correct_balls(balls, factors_of(ring.correction))
    ends, start = np.zeros(count, ROUND), BY_LOAD if place is None else BY_PLACE
    settle_ruled_rings(numbers, np.array(ring.speed, dtype=np.float64), ring.inertia, rings, balls, ends, start)
    if ends["end"].any():
        worst = int(np.argmax(ends["end"]))
        speed = float(ring.speed[worst])
        raise unsettled_ring(ring.bearing, ring.grooves, speed, rings[worst], balls[worst], ends[worst])
    if tilts is not None:
        rings["load"][:, -TILTS:] = rings["gradient"][:, -TILTS:]
    return SettledRings(rings, balls, ends)


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
