"""Rows of balls on one rigid inner part with five freedoms: the place where all forces balance.

A row is a bearing on its shaft. A single ring has one row, a pair of bearings two. `analytic.loads.ring` says what the
freedoms and the angles are; `analytic.loads.ball_balance` settles each ball.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import HertzContact
from analytic.errors import ConvergenceError, InputError
from analytic.loads.ball_balance import BallBalance, settled_ball
from analytic.loads.race_contacts import unit_contacts
from analytic.loads.turning import PlacedBalls, Turning
from analytic.numerics.newton import ConvexState, least_energy
from analytic.numerics.rows import merged, part_of
from analytic.scene import Array, Bearing
from analytic.words import angle_of, length_of, speed_of

# Of the load and the largest ball load: Newton's quadratic steps reach it at once, and rounding is a thousandth of it.
TOLERANCE = 1e-12
# Of a displacement, in the balls' stiffness: what rounding of the ring's place leaves as force.
PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps
# Of A0, likewise: the place of a ball under a force of its own is computed from the grooves' centres.
BALL_ROUND_OFF = 16 * np.finfo(np.float64).eps
# Of the balls' loads times A0, whose rounding moves them, or times the way of a load that no bearing survives.
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps
# Contact stiffness, centrifugal and friction force follow the angles: 3 or 4 rounds at rest, about 10 at high speed.
MOST_ROUNDS = 200
STEADYING = 30  # rounds, after which forces move halfway: some swing to and fro with the angles
LEAST_BALLS = 3  # of a row that hold a ring in all five freedoms


@dataclass(frozen=True, kw_only=True)
class Row:
    """A row of balls on the shaft; in its own frame thrust along z loads it."""

    side: int = 1  # -1: its z points against that of the shaft
    position: float = 0.0  # of the circle of its inner groove centres along the shaft's z, m
    offset: float = 0.0  # of its inner groove along its own z where the shaft is not displaced, m


@dataclass(frozen=True, kw_only=True, eq=False)
class HeldBalls:
    """What one round of Newton's method holds, for n points and Z balls of all rows."""

    ring_force: Array  # (n, 5) load and friction of the balls, N (moments over R)
    inner: HertzContact  # (n, Z) under 1 N
    outer: HertzContact
    ball_force: Array  # (n, Z, 2) on the ball, N
    friction: Array  # (n, Z, 2) across the inner groove, on the ball, N
    centrifugal_force: Array  # (n, Z) N
    gyroscopic_moment: Array  # (n, Z) N m


@dataclass(frozen=True, kw_only=True, eq=False)
class RingState(ConvexState):
    """n rings at a place, m (tilts times R), with the forces there."""

    held: HeldBalls
    balls: BallBalance  # (n, Z)


class GrooveTravel(NamedTuple):
    """How the inner groove at each of Z balls follows the five freedoms of the inner part."""

    arm: float  # R, m
    azimuth: Array  # (Z,) rad
    offset: Array  # (Z,) along z where nothing is displaced, m
    travel: Array  # (Z, 2, 5) radial and axial, by each freedom; tilts times R


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


class RowsOfBalls:
    """The balls seen from the inner part: how far the groove at each ball travels, and which force that takes."""

    def __init__(
        self,
        bearing: Bearing,
        play: float,
        correction: ContactCorrection,
        turning: Turning,
        *,
        ball_weight: tuple[float, float, float] = (0.0, 0.0, 0.0),
        rows: tuple[Row, ...] = (Row(),),
    ) -> None:
        self.bearing, self.play, self.correction, self.turning = bearing, play, correction, turning
        geometry = groove_travel(bearing, rows)
        self.arm, self.azimuth, self.offset, self.travel = geometry
        self.radial, self.axial = self.travel[:, 0].T, self.travel[:, 1].T  # (5, Z): u_r and u_a of each freedom
        cosine, sine = np.cos(self.azimuth), np.sin(self.azimuth)
        side = np.repeat([row.side for row in rows], bearing.ball_count)
        x, y, z = ball_weight
        self.weight = np.stack([x * cosine + y * sine, side * z], axis=-1)  # (Z, 2): radial and axial, N

    def held(
        self,
        load: Array,
        points: NDArray[np.intp],
        *,
        angles: tuple[Array, Array],
        loads: tuple[Array, Array],
    ) -> HeldBalls:
        """Contact stiffness, inertia, friction and weight of balls at their angles and loads, each (n, Z).

        points : the operating points that these balls belong to
        """
        inner, outer = unit_contacts(
            self.bearing,
            inner_angle=_in_groove(angles[0]),
            outer_angle=_in_groove(angles[1]),
            correction=self.correction.mapped(lambda array: array[points]),
        )
        # Before it settles a ball may leave its groove.
        inner_angle, outer_angle = (np.clip(angle, -np.pi / 2, np.pi / 2) for angle in angles)
        forces = self.turning.forces(
            PlacedBalls(
                points=points,
                inner_angle=inner_angle,
                outer_angle=outer_angle,
                inner_load=loads[0],
                outer_load=loads[1],
                inner=inner,
                outer=outer,
            )
        )
        across_inner = np.stack([np.sin(angles[0]), -np.cos(angles[0])], axis=-1)  # t_i
        across_outer = np.stack([-np.sin(angles[1]), np.cos(angles[1])], axis=-1)  # t_o
        at_inner = forces.inner_friction[..., None] * across_inner
        at_outer = forces.outer_friction[..., None] * across_outer
        outward = np.stack([forces.centrifugal, np.zeros_like(forces.centrifugal)], axis=-1)
        return HeldBalls(
            inner=inner,
            outer=outer,
            ball_force=outward + at_inner + at_outer + self.weight,
            friction=at_inner,
            ring_force=load - self.resultant(at_inner),
            centrifugal_force=forces.centrifugal,
            gyroscopic_moment=forces.gyroscopic,
        )

    def resultant(self, force: Array) -> Array:
        """(n, 5) of the balls' forces (n, Z, 2) on the inner grooves."""
        return np.reshape(force, (len(force), -1)) @ self.travel.reshape(-1, 5)

    def at(self, place: Array, held: HeldBalls) -> RingState:
        """The rings at a place, with their balls settled."""
        balls = settled_ball(
            self.bearing,
            play=self.play,
            radial=place @ self.radial,
            axial=place @ self.axial + self.offset,
            inner_stiffness=held.inner.stiffness,
            outer_stiffness=held.outer.stiffness,
            ball_force=held.ball_force,
        )
        rows = self.travel.reshape(-1, 5)
        tangent = rows.T @ (balls.tangent @ self.travel).reshape(len(place), -1, 5)
        forces = np.max(np.abs(held.ring_force), axis=-1) + np.max(balls.outer_load, axis=-1)
        distance = self.bearing.groove_centre_distance
        pushed = np.any(held.ball_force, axis=(-2, -1)) * distance
        reach = np.max(np.abs(place), axis=-1) + np.max(np.abs(self.offset))
        longest = np.maximum(distance, reach)
        rounding = PLACE_ROUND_OFF * reach * np.trace(tangent, axis1=-2, axis2=-1)
        if pushed.any():
            contacts = 1.5 * np.sum(np.cbrt(held.inner.stiffness**2 * balls.inner_load), axis=-1)  # dQ/d delta, N/m
            rounding = rounding + BALL_ROUND_OFF * pushed * contacts
        return RingState(
            place=place,
            held=held,
            balls=balls,
            energy=np.sum(balls.energy, axis=-1) - np.sum(held.ring_force * place, axis=-1),
            gradient=self.resultant(balls.force) - held.ring_force,
            tangent=tangent,
            tolerance=TOLERANCE * forces + rounding,
            energy_rounding=ENERGY_ROUND_OFF * longest * np.sum(balls.outer_load, axis=-1),
            longest_step=longest,
        )

    def settled(self, place: Array, held: HeldBalls) -> tuple[RingState, NDArray[np.intp]]:
        """The rings where the energy of what is held is least, and Newton's steps to there, (n,)."""
        return least_energy(
            lambda trial, state: self.at(trial, state.held),
            self.at(place, held),
            problem="the ring's equilibrium",
            remedy="Check the loads, the speed, the clearance and the materials for a slipped unit.",
        )


def settled_ring(
    ring: RowsOfBalls, load: Array, *, angle: float, place: Array | None = None
) -> tuple[RingState, NDArray[np.intp]]:
    """The rings at rest under loads (n, 5), N (moments over R), and Newton's steps, (n,).

    angle : near which the contact angles are, rad;  place : (n, 5) to begin at, where balls touch; None: by the load
    Rounds of Newton's method until one has nothing to do; each holds what the angles of the last one give.
    Raises ConvergenceError where the rounds do not settle.
    """
    angles, active = np.full((len(load), ring.azimuth.size), angle), np.arange(len(load))
    nothing = np.zeros_like(angles)
    held = ring.held(load, active, angles=(angles, angles), loads=(nothing, nothing))
    state, steps = ring.settled(_start(ring, load, held) if place is None else place, held)
    left = tolerance = 0.0  # N: change of the forces that a round holds
    for rounds in range(MOST_ROUNDS):
        balls = part_of(state.balls, active)
        held = ring.held(
            load[active],
            active,
            angles=(balls.inner_angle, balls.outer_angle),
            loads=(balls.inner_load, balls.outer_load),
        )
        last = part_of(state.held, active)
        if rounds >= STEADYING:
            held = replace(
                held,
                ball_force=(held.ball_force + last.ball_force) / 2,
                ring_force=(held.ring_force + last.ring_force) / 2,
            )
        again, more = ring.settled(state.place[active], held)
        # The ring does not notice the force of a ball that floats or is wedged: that has to settle too.
        change = np.maximum(
            np.abs(held.ball_force - last.ball_force).max(axis=(-2, -1)),
            np.abs(held.ring_force - last.ring_force).max(axis=-1),
        )
        accurate = np.maximum(again.tolerance, ring.turning.accuracy * np.max(balls.outer_load, axis=-1))
        state = merged(state, active, again)
        steps[active] += more
        active = active[((more > 0) & (ring.turning.accuracy == 0)) | (change > accurate)]
        if not len(active):
            return state, steps
        left, tolerance = float(np.max(change)), float(accurate[np.argmax(change)])
    remedy = "Raise the load or lower the speed: the gyroscopic moment needs more friction than the balance has."
    problem = "the balls' own forces in the ring's equilibrium"
    raise ConvergenceError(iterations=MOST_ROUNDS, residual=left, tolerance=tolerance, problem=problem, remedy=remedy)


def refuse_beyond_groove(ring: RowsOfBalls, state: RingState, load: Array, speed: Array) -> None:
    """Raise InputError where a ball has left its groove; load : (n, 5) as settled_ring has it;  speed : (n,), rad/s."""
    distance, radial = ring.bearing.groove_centre_distance, state.place @ ring.radial
    passed = distance - ring.play + radial < 0  # the centres of the grooves, each other; no inertia of balls does that
    angle = np.where((state.balls.inner_load > 0) | passed, np.abs(state.balls.inner_angle), 0.0)
    if np.any(angle > np.pi / 2):
        point, ball = np.unravel_index(np.argmax(angle), angle.shape)
        moved = np.max(np.abs(radial[point]))
        # A move by that much is the load's, whatever inertia adds.
        if passed[point, ball] or moved > max(ring.play, 0.0) + distance / 2:
            raise InputError(
                f"the {_load_words(load[point], ring)} moves the rings by {length_of(moved, '.2g')}, and balls leave "
                "their grooves: lower the load"
            )
        raise InputError(
            f"the speed, {speed_of(speed[point])}, drives a ball {angle_of(angle[point, ball])} out of its groove, "
            "past 90 deg: no contact bears it, lower the speed"
        )


def _load_words(load: Array, ring: RowsOfBalls) -> str:
    """The load of a point, (5,), and how many times the static load rating of the bearing it is."""
    axial, radial, moment = np.abs(load[0]), np.hypot(load[1], load[2]), np.hypot(load[3], load[4]) * ring.arm
    parts = (("axial load", axial, "kN"), ("radial load", radial, "kN"), ("moment", moment, "kN m"))
    named = " and ".join(f"{name} of {value / 1e3:.4g} {unit}" for name, value, unit in parts if value > 0) or "preload"
    rating, largest = ring.bearing.static_load_rating, max(axial, radial)
    if rating is None or largest <= rating:
        return named
    return f"{named}, {largest / rating:.2g} times the static load rating C0 = {rating / 1e3:.4g} kN,"


def _start(ring: RowsOfBalls, load: Array, held: HeldBalls) -> Array:
    """A place where balls touch: the displacement by each part of the load if one ball took it, the largest in full."""
    bearing, play = ring.bearing, ring.play
    parts = np.stack([np.abs(load[:, 0]), np.hypot(load[:, 1], load[:, 2]), np.hypot(load[:, 3], load[:, 4])])
    softness = held.inner.approach[:, 0] + held.outer.approach[:, 0]
    approach = softness * np.cbrt(parts) ** 2
    distance, share = bearing.groove_centre_distance, parts / np.maximum(np.max(parts, axis=0), 1e-300)
    along = np.sqrt(np.maximum((approach + play) * (2 * distance + approach - play), 0.0))
    reach = share * np.stack([along[0], approach[1] + max(play, 0.0), along[2]])
    towards = load / np.maximum(parts, 1e-300)[[0, 1, 1, 2, 2]].T
    return towards * reach[[0, 1, 1, 2, 2]].T


def _in_groove(angle: Array) -> Array:
    """The magnitude of the angle, at most pi/2: the groove's profile is symmetric and ends there."""
    return np.minimum(np.abs(angle), np.pi / 2)
