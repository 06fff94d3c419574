"""Five freedoms of the inner ring: every ball takes its own load and contact angle on each race.

The outer ring is fixed. The inner ring is loaded and displaced along the bearing axis z, along x and y, and tilted
about x and y, right-handed. The rings are rigid apart from the contacts, tilts are small. Displacement, load and moment
refer to the centre of the circle on which the inner groove's centre of curvature lies. Its radius is
R = bottom_radius + groove_radius: a tilt about it moves each groove along the axis. Ball j sits at the azimuth
psi_j = 2 pi j/Z, from x towards y. A groove reaches equally far to both sides.

With the contacts' stiffness held, the energy of the ring is convex in its place. There is no second equilibrium, and
with three balls or more there is always one. The loads of the balls are unique. The place is not where the loaded balls
leave a freedom, as in a bearing with clearance that hangs on one ball: it is then one of the possible places.
Source: [Jones1960] and [Harris2007b] sections 1 and 3: derived here from energy and Euler's equation of a ball.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import HertzContact, loaded_contact
from analytic.errors import ConvergenceError, InputError, require_finite, require_positive
from analytic.loads.ball_balance import BallBalance, settled_ball
from analytic.loads.race_contacts import unit_contacts
from analytic.loads.thrust import play_and_free_angle
from analytic.loads.turning import PlacedBalls, RuledTurning, Turning
from analytic.numerics.newton import ConvexState, least_energy
from analytic.numerics.rows import merged, part_of
from analytic.scene import Array, Bearing, ContactAngle

# Of the load and the largest ball load: Newton's quadratic steps reach it at once, and rounding is a thousandth of it.
TOLERANCE = 1e-12
# Of a displacement, in the balls' stiffness: what rounding of the ring's place leaves as force.
PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps
# Of A0, likewise: the place of a ball under a force of its own is computed from the grooves' centres.
BALL_ROUND_OFF = 16 * np.finfo(np.float64).eps
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps  # of the balls' loads times A0, whose rounding moves them
# Contact stiffness, centrifugal and friction force follow the angles: 3 or 4 rounds at rest, about 10 at high speed.
MOST_ROUNDS = 200
STEADYING = 30  # rounds, after which forces move halfway: some swing to and fro with the angles
LEAST_BALLS = 3  # that hold a ring in all five freedoms


@dataclass(frozen=True, kw_only=True, eq=False)
class RingEquilibrium:
    """Balls and ring under load; (...) is the broadcast shape of the loads and the speed, Z the number of balls."""

    free_angle: float | None  # al0, rad; None for a preloaded bearing
    azimuth: Array  # (Z,) psi, rad
    displacement: Array  # (..., 5) axial, x, y, m; tilt about x, about y, rad; from concentric rings, grooves in line
    stiffness: Array  # (..., 5, 5) dF/d displacement with each contact's K held, N/m, N, N m
    inner_load: Array  # (..., Z) Q_i, N
    outer_load: Array  # (..., Z) Q_o, N
    inner_angle: Array  # (..., Z) al_i, rad, negative where the ball is pressed towards -z
    outer_angle: Array  # (..., Z) al_o, rad
    inner: HertzContact  # (..., Z)
    outer: HertzContact  # (..., Z)
    centrifugal_force: Array  # (..., Z) F_c, N
    gyroscopic_moment: Array  # (..., Z) M_g, N m, with the sign of the contact angle
    residual: Array  # (...) largest unbalanced force, or moment over R, N
    iterations: NDArray[np.intp]  # (...) Newton steps


def ring_equilibrium(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike = 0.0,
    radial_load_x: ArrayLike = 0.0,
    radial_load_y: ArrayLike = 0.0,
    moment_x: ArrayLike = 0.0,
    moment_y: ArrayLike = 0.0,
    inner_speed: ArrayLike = 0.0,
    turning: Turning | None = None,
    ball_weight: tuple[float, float, float] = (0.0, 0.0, 0.0),
    correction: ContactCorrection | None = None,
) -> RingEquilibrium:
    """Ball loads, contact angles and ring displacement under any load; loads and speed broadcast to (...).

    axial_load, radial_load_x, radial_load_y : N;  moment_x, moment_y : about x and y, N m; any sign
    inner_speed : rad/s
    turning : what acts on the balls because they turn, for the points in their flat order; None: centrifugal force and
        gyroscopic moment by closed kinematics
    ball_weight : of each ball along x, y and z, N; the cage carries its part along the orbit
    contact_angle : rule "solved"; free, where given, replaces the clearance by A0 (1 - cos al0)
    correction : factors on Hertz's contacts, each a number or (..., Z); None leaves them as they are

    Each ball settles between groove centres that are V = (A0 cos al0 + u_r, u_a) apart
    (analytic.loads.ball_balance), with
        u_r = x cos psi + y sin psi,  u_a = z + R (t_x sin psi - t_y cos psi)
    and the load is the sum of the ball forces. K of a contact is Hertz's at its own angle, and its force acts along the
    normal. The work of a K that changes with the angle, (2/5)(delta/A0) d ln K/d al of the force, is left out.
    Centrifugal force F_c and friction across the grooves F_t come from `turning`, with loads and angles of the last
    round; by closed kinematics (analytic.loads.turning) at the cage speed w_m, the ball speed w_b and the pitch B
        F_c = m (d_m/2) w_m^2,  M_g = (m D^2/10) w_b w_m sin B
    and friction carries M_g, on each race in proportion to its load.
    Without load on a bearing with clearance nothing touches, and the ring is left in the middle of its play.
    Fewer than three balls carry thrust alone: the other freedoms of the ring are then held, with stiffness 0.
    Raises InputError for a number that is not finite, the rule `given`, a radial load or moment on fewer than three
    balls, a load that drives a ball out of its groove (an angle beyond pi/2), and as thrust_equilibrium does for the
    bearing; ConvergenceError where the iteration stops short.
    """
    given = {
        "axial_load": axial_load,
        "radial_load_x": radial_load_x,
        "radial_load_y": radial_load_y,
        "moment_x": moment_x,
        "moment_y": moment_y,
        "inner_speed": inner_speed,
    }
    require_finite(**given)
    require_positive(ball_count=bearing.ball_count)
    if contact_angle.rule == "given":
        raise InputError(
            "the rule 'given' holds the contact angle that a ring equilibrium solves for: use the rule 'solved'"
        )
    play, free = play_and_free_angle(bearing, contact_angle)
    arrays = np.broadcast_arrays(*(np.asarray(value, dtype=np.float64) for value in given.values()))
    shape, (axial, x, y, about_x, about_y, speed) = arrays[0].shape, (array.ravel() for array in arrays)
    factors = (correction or ContactCorrection()).mapped(lambda array: array.reshape(-1, bearing.ball_count))
    require_finite(ball_weight=ball_weight)
    if turning is None:
        turning = RuledTurning(bearing=bearing, inner_speed=speed, centrifugal=True, gyroscopic=True)
    ring = _Ring(bearing, play, factors, turning, ball_weight)
    load = np.stack([axial, x, y, about_x / ring.arm, about_y / ring.arm], axis=-1)
    if bearing.ball_count < LEAST_BALLS and np.any(load[:, 1:]):
        raise InputError(
            f"ball_count = {bearing.ball_count} carries thrust alone: a radial load or a moment needs at least "
            f"{LEAST_BALLS} balls"
        )
    state, steps = _equilibrium(ring, load, angle=free or 0.0)
    balls, held = state.balls, state.held
    angle = np.where(balls.inner_load > 0, np.abs(balls.inner_angle), 0.0)
    if np.any(angle > np.pi / 2):
        point, ball = np.unravel_index(np.argmax(angle), angle.shape)
        # Inertia makes the angle larger on the inner race and smaller on the outer one. Without it both would be about
        # their mean.
        by_speed = angle[point, ball] + np.abs(balls.outer_angle[point, ball]) < np.pi
        cause = f"the speed, {speed[point]:.5g} rad/s," if by_speed else "the load"
        raise InputError(
            f"{cause} drives a ball {angle[point, ball]:.3f} rad out of its groove, past pi/2: no contact bears it, "
            f"lower the {'speed' if by_speed else 'load'}"
        )
    inner, outer = (
        loaded_contact(contact, load=load)
        for contact, load in ((held.inner, balls.inner_load), (held.outer, balls.outer_load))
    )
    unit = np.array([1.0, 1.0, 1.0, ring.arm, ring.arm])
    each, whole = (*shape, bearing.ball_count), (*shape, 5)
    return RingEquilibrium(
        free_angle=free,
        azimuth=ring.azimuth,
        displacement=(state.place / unit).reshape(whole),
        stiffness=(state.tangent * np.outer(unit, unit)).reshape(*whole, 5),
        inner_load=balls.inner_load.reshape(each),
        outer_load=balls.outer_load.reshape(each),
        inner_angle=balls.inner_angle.reshape(each),
        outer_angle=balls.outer_angle.reshape(each),
        inner=inner.reshape(each),
        outer=outer.reshape(each),
        centrifugal_force=held.centrifugal_force.reshape(each),
        gyroscopic_moment=held.gyroscopic_moment.reshape(each),
        residual=state.residual.reshape(shape),
        iterations=steps.reshape(shape),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class _Held:
    """What one round of Newton's method holds, for n points and Z balls."""

    ring_force: Array  # (n, 5) load and friction of the balls, N (moments over R)
    inner: HertzContact  # (n, Z) under 1 N
    outer: HertzContact
    ball_force: Array  # (n, Z, 2) on the ball, N
    centrifugal_force: Array  # (n, Z) N
    gyroscopic_moment: Array  # (n, Z) N m


@dataclass(frozen=True, kw_only=True, eq=False)
class _State(ConvexState):
    """n rings at a place, m (tilts times R), with the forces there."""

    held: _Held
    balls: BallBalance  # (n, Z)


class _Ring:
    """The bearing seen from its inner ring: how far the groove at each ball travels, and which force that takes."""

    def __init__(
        self,
        bearing: Bearing,
        play: float,
        correction: ContactCorrection,
        turning: Turning,
        ball_weight: tuple[float, float, float],
    ) -> None:
        self.bearing, self.play, self.correction, self.turning = bearing, play, correction, turning
        self.arm = bearing.inner.bottom_radius + bearing.inner.groove_radius  # R, m
        self.azimuth = 2 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
        cosine, sine, zero = np.cos(self.azimuth), np.sin(self.azimuth), np.zeros(bearing.ball_count)
        self.radial = np.stack([zero, cosine, sine, zero, zero])  # (5, Z): u_r of each freedom
        self.axial = np.stack([zero + 1, zero, zero, sine, -cosine])  # (5, Z): u_a
        if bearing.ball_count < LEAST_BALLS:
            self.radial[1:], self.axial[1:] = 0.0, 0.0
        self.travel = np.stack([self.radial.T, self.axial.T], axis=1)  # (Z, 2, 5)
        x, y, z = ball_weight
        self.weight = np.stack([x * cosine + y * sine, z + zero], axis=-1)  # (Z, 2): radial and axial, N

    def held(
        self,
        load: Array,
        points: NDArray[np.intp],
        *,
        angles: tuple[Array, Array],
        loads: tuple[Array, Array],
    ) -> _Held:
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
        return _Held(
            inner=inner,
            outer=outer,
            ball_force=outward + at_inner + at_outer + self.weight,
            ring_force=load - self.resultant(at_inner),
            centrifugal_force=forces.centrifugal,
            gyroscopic_moment=forces.gyroscopic,
        )

    def resultant(self, force: Array) -> Array:
        """(n, 5) of the balls' forces (n, Z, 2) on the inner grooves."""
        return np.reshape(force, (len(force), -1)) @ self.travel.reshape(-1, 5)

    def at(self, place: Array, held: _Held) -> _State:
        """The rings at a place, with their balls settled."""
        balls = settled_ball(
            self.bearing,
            play=self.play,
            radial=place @ self.radial,
            axial=place @ self.axial,
            inner_stiffness=held.inner.stiffness,
            outer_stiffness=held.outer.stiffness,
            ball_force=held.ball_force,
        )
        rows = self.travel.reshape(-1, 5)
        tangent = rows.T @ (balls.tangent @ self.travel).reshape(len(place), -1, 5)
        forces = np.max(np.abs(held.ring_force), axis=-1) + np.max(balls.outer_load, axis=-1)
        distance = self.bearing.groove_centre_distance
        pushed = np.any(held.ball_force, axis=(-2, -1)) * distance
        rounding = PLACE_ROUND_OFF * np.max(np.abs(place), axis=-1) * np.trace(tangent, axis1=-2, axis2=-1)
        if pushed.any():
            contacts = 1.5 * np.sum(np.cbrt(held.inner.stiffness**2 * balls.inner_load), axis=-1)  # dQ/d delta, N/m
            rounding = rounding + BALL_ROUND_OFF * pushed * contacts
        return _State(
            place=place,
            held=held,
            balls=balls,
            energy=np.sum(balls.energy, axis=-1) - np.sum(held.ring_force * place, axis=-1),
            gradient=self.resultant(balls.force) - held.ring_force,
            tangent=tangent,
            tolerance=TOLERANCE * forces + rounding,
            energy_rounding=ENERGY_ROUND_OFF * distance * np.sum(balls.outer_load, axis=-1),
            longest_step=np.maximum(distance, np.max(np.abs(place), axis=-1)),
        )

    def settled(self, place: Array, held: _Held) -> tuple[_State, NDArray[np.intp]]:
        """The rings where the energy of what is held is least, and Newton's steps to there, (n,)."""
        return least_energy(
            lambda trial, state: self.at(trial, state.held),
            self.at(place, held),
            problem="the ring's equilibrium",
            remedy="Check the loads, the speed, the clearance and the materials for a slipped unit.",
        )


def _equilibrium(ring: _Ring, load: Array, *, angle: float) -> tuple[_State, NDArray[np.intp]]:
    """Rounds of Newton's method until one has nothing to do; each holds what the angles of the last one give."""
    angles, active = np.full((len(load), ring.bearing.ball_count), angle), np.arange(len(load))
    nothing = np.zeros_like(angles)
    held = ring.held(load, active, angles=(angles, angles), loads=(nothing, nothing))
    state, steps = ring.settled(_start(ring, load, held), held)
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


def _start(ring: _Ring, load: Array, held: _Held) -> Array:
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
