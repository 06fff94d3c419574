"""The races as free balls feel them: load, direction, width and creep of each contact over a turn of the balls.

The rings hold the balls as in `analytic.loads`; the place of the rings does not follow the motion of balls and cage. A
ball that its pocket presses moves between its races until all forces balance, at once. Across the races that is true:
it takes sqrt(m/k), some 5 us with their stiffness k. Along the grooves a ball moves more slowly, so the turn of a
contact's normal is limited (`LARGEST_TURN`).
Traction grows with slip as in `analytic.cage.race_law`, with the creep
    s_c = u 8 mu p0/(3 C11 G) = u (32/(3 pi^2)) mu p0/E*,  C11 = pi^2/(4 (1 - nu)),
that of a long ellipse, the same along the groove and across it. u is the rolling speed, p0 the peak pressure.
Source: [Kalker1982] and [Polach2005] for the law; the derivatives by the pocket's force are derived here.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact
from analytic.contact.rolling_contact import deformed_radius
from analytic.errors import InputError, SingularError, require_finite, require_non_negative
from analytic.loads.balls import LoadedBalls, LoadEffects
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.turning import RuledTurning
from analytic.scene import Array, Bearing, ContactAngle, Operation

if TYPE_CHECKING:
    from analytic.cage.race_law import RaceLaw

LEAST_CREEP = 1e-4  # m/s, added to s_c: without it a ball at standstill would meet dry friction with a jump
AZIMUTHS = 144  # at least, of a turn: straight lines between them are within 1e-3 of the loads
STEPS = 2880  # of a ball's turn without a cage
SETTLING = tuple(10.0**power for power in range(-6, 1))  # s: steps of a ball that comes to a steady speed
SETTLING_STEPS = 20  # of each length
PATH = 8  # columns of a path: angle, four speeds, work of the ring, slip, grip


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceContacts:
    """A ball on both races, inner and outer in front, at n azimuths from the x axis on, evenly over a turn."""

    load: Array  # (2, n) Q, N, >= 0
    contact_angle: Array  # (2, n) al, rad, with its sign
    contact: HertzContact  # (2, n)


@dataclass(frozen=True, kw_only=True, eq=False)
class AloneBall:
    """A ball on its races without a cage, over a turn; n azimuths."""

    orbit_speed: float  # mean over time, rad/s
    lead: float  # amplitude A of a lead A sin(psi) over a steady orbit, m
    speeds: Array  # (n, 4) at the azimuths: r_m w_c, r w_phi, r w_rho, r w_z, m/s
    slip_power: Array  # (n,) lost in both contacts, W
    grip: float  # largest traction along the orbit over its limit


@dataclass(frozen=True, kw_only=True, eq=False)
class Races:
    """Both races of a bearing at one operating point; the outer ring stands still.

    Raises InputError if neither race has friction, or if a ball is pressed on neither race.
    """

    bearing: Bearing
    contacts: RaceContacts
    friction: tuple[float, float]  # mu, coefficient of the inner and of the outer race
    inner_speed: float  # w, rad/s

    def __post_init__(self) -> None:
        require_finite(inner_speed=self.inner_speed)
        require_non_negative(friction=self.friction)
        if not max(self.friction) > 0:
            raise InputError(
                f"friction of the races {self.friction!r} drives no ball, and so no cage: give a coefficient above 0 "
                "at one race at least"
            )
        pressed = self.contacts.load.max(axis=0)
        if not pressed.min() > 0:
            azimuth = 360 * int(pressed.argmin()) / pressed.size
            raise InputError(
                f"a ball at {azimuth:.0f} degrees from the radial load is pressed by {pressed.min():.3g} N: it needs "
                "more than 0 N on one race to follow it; raise the axial load, or include the centrifugal force"
            )

    @cached_property
    def table(self) -> Array:
        """(n, 2, FIELDS) numbers of the compiled loop, SI, but for the slip power without a cage."""
        from analytic.cage import race_law as column

        bearing, contacts = self.bearing, self.contacts
        load, angle = contacts.load, contacts.contact_angle
        grooves = (bearing.inner, bearing.outer)
        modulus = np.reshape([contact_modulus(bearing.ball_material, groove.material) for groove in grooves], (2, 1))
        unit = _under_unit_load(bearing, contacts, modulus)
        moving = ball_kinematics(
            inner_speed=self.inner_speed,
            inner_angle=angle[0],
            outer_angle=angle[1],
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball_diameter,
        )
        speed, friction = np.abs(moving.entrainment_speed), np.reshape(self.friction, (2, 1))
        by_force = _by_force(bearing, contacts)
        outward = np.array([[-1.0], [1.0]])  # the inner race is on the inside of the ball
        table = np.zeros((load.shape[1], 2, column.FIELDS))
        table[..., column.LOAD] = load.T
        table[..., column.NORMAL_RHO] = (outward * np.cos(angle)).T
        table[..., column.NORMAL_Z] = (outward * np.sin(angle)).T
        table[..., column.WIDTH] = unit.semi_axis_y.T / bearing.ball_radius
        table[..., column.CREEP] = (32 / (3 * np.pi**2) * friction * unit.peak_pressure / modulus * speed).T
        table[..., column.LOAD_BY_RHO : column.ANGLE_BY_Z + 1] = by_force.transpose(1, 0, 2)
        return table

    @property
    def limits(self) -> Array:
        """(2, n) N: mu Q, the largest traction."""
        return np.reshape(self.friction, (2, 1)) * self.contacts.load

    def law(self) -> "RaceLaw":
        """Constants of the compiled loop."""
        from analytic.cage.race_law import RaceLaw

        bearing = self.bearing
        hollow = [
            bearing.ball_radius
            / (2 * float(deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter)))
            for groove in (bearing.inner, bearing.outer)
        ]
        return RaceLaw(
            ball_mass=bearing.ball_mass,
            ball_radius=bearing.ball_radius,
            pitch_radius=bearing.pitch_diameter / 2,
            ring_speed=self.inner_speed,
            inner_friction=self.friction[0],
            outer_friction=self.friction[1],
            inner_hollow=hollow[0],
            outer_hollow=hollow[1],
            least_creep=LEAST_CREEP,
        )

    @cached_property
    def alone(self) -> AloneBall:
        """A ball without a cage; raises SingularError if its speeds do not settle."""
        from analytic.cage.free_kernel import ANGLE

        points = self.table.shape[0]
        ball = self._rolling()
        if points == 1:
            path = ball[None]
            for step in SETTLING:
                path = self._gone_round(ball, SETTLING_STEPS, step)
            return AloneBall(
                orbit_speed=path[-1, 1] * 2 / self.bearing.pitch_diameter,
                lead=0.0,
                speeds=path[-1:, 1:5],
                slip_power=path[-1:, 6] / SETTLING[-1],
                grip=path[-1, 7],
            )
        radius = self.bearing.pitch_diameter / 2
        step = 2 * np.pi * radius / abs(ball[1]) / STEPS
        self._gone_round(ball, STEPS, step)  # from rolling to what the loads make of it
        begin, sign = ball[ANGLE], np.sign(self.inner_speed)
        path = self._gone_round(ball, STEPS + STEPS // 10, step)
        angle, time = sign * (path[:, 0] - begin), step * np.arange(1, len(path) + 1)
        period = float(np.interp(2 * np.pi, angle, time))
        turn = time <= period
        azimuth = 2 * np.pi * np.arange(points) / points

        def at(values: Array) -> Array:
            return np.interp(azimuth, path[turn, 0] % (2 * np.pi), values[turn], period=2 * np.pi)

        even = 2 * np.pi * np.arange(1, STEPS) / STEPS  # of a ball at the mean speed
        ahead = np.interp(even / (2 * np.pi) * period, time, angle) - even
        return AloneBall(
            orbit_speed=float(sign * 2 * np.pi / period),
            lead=float(2 * np.mean(ahead * np.sin(even + sign * begin)) * radius),
            speeds=np.stack([at(path[:, 1 + speed]) for speed in range(4)], axis=1),
            slip_power=at(path[:, 6] / step),
            grip=float(path[turn, 7].max()),
        )

    def _rolling(self) -> Array:
        """A ball at the azimuth 0 that rolls."""
        angle = self.contacts.contact_angle[:, 0]
        bearing = self.bearing
        moving = ball_kinematics(
            inner_speed=self.inner_speed,
            inner_angle=angle[0],
            outer_angle=angle[1],
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball_diameter,
        )
        radius, pitch = bearing.ball_radius, float(moving.pitch)
        along, turning = float(moving.cage_speed), float(moving.ball_speed)
        return np.array(
            [
                0.0,
                bearing.pitch_diameter / 2 * along,
                0.0,
                radius * turning * np.sin(pitch),
                radius * (along - turning * np.cos(pitch)),
                0.0,
            ]
        )

    def _gone_round(self, ball: Array, steps: int, step: float) -> Array:
        from analytic.cage.free_kernel import go_round

        path = np.empty((steps, PATH))
        done = go_round(self.law(), self.table, ball, path, step)
        if done < steps:
            raise SingularError(
                problem=f"the speeds of a ball on its races did not settle at step {done} of {steps} without a cage",
                remedy="Check the friction coefficients of the races, the loads and the speed for a slipped unit",
            )
        return path


def thrust_races(
    bearing: Bearing, balls: LoadedBalls, *, point: int, inner_speed: float, friction: tuple[float, float]
) -> Races:
    """Races under balls that are all alike, by `thrust_balls`.

    point : the operating point of the balls;  inner_speed : w there, rad/s;  friction : mu of inner and outer race
    """
    if balls.method != "thrust":
        raise InputError(
            f"balls by the method {balls.method!r} differ over a turn: take `ring_races`, which has their azimuths"
        )
    return Races(
        bearing=bearing,
        contacts=RaceContacts(
            load=balls.load[:, point],
            contact_angle=balls.contact_angle[:, point],
            contact=HertzContact(**{name: value[:, point] for name, value in vars(balls.contact).items()}),
        ),
        friction=friction,
        inner_speed=inner_speed,
    )


def ring_races(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    effects: LoadEffects,
    *,
    friction: tuple[float, float],
) -> Races:
    """Races under balls that differ over a turn, by `ring_equilibrium`; its errors.

    operation : one operating point
    The balls go round evenly spaced, so that a ball at one azimuth always finds the others at the same places: the ring
    is solved at several places of the set within its spacing.
    """
    count = bearing.ball_count
    turns = -(-AZIMUTHS // count)
    ahead = 2 * np.pi * np.arange(turns) / (turns * count)
    force, moment, speed = (
        float(np.squeeze(value)) for value in (operation.radial_load, operation.moment, operation.inner_speed)
    )
    ring = ring_equilibrium(  # in directions that turn with the balls
        bearing,
        contact_angle,
        axial_load=float(np.squeeze(operation.axial_load)),
        radial_load_x=force * np.cos(ahead),
        radial_load_y=-force * np.sin(ahead),
        moment_x=moment * np.sin(ahead),
        moment_y=moment * np.cos(ahead),
        inner_speed=speed,
        turning=RuledTurning(
            bearing=bearing,
            inner_speed=np.full(turns, speed),
            centrifugal=effects.centrifugal,
            gyroscopic=effects.gyroscopic,
        ),
    )

    def over_turn(inner: Array, outer: Array) -> Array:
        return np.stack([inner.T.ravel(), outer.T.ravel()])

    return Races(
        bearing=bearing,
        contacts=RaceContacts(
            load=over_turn(ring.inner_load, ring.outer_load),
            contact_angle=over_turn(ring.inner_angle, ring.outer_angle),
            contact=HertzContact(
                **{name: over_turn(getattr(ring.inner, name), getattr(ring.outer, name)) for name in vars(ring.inner)}
            ),
        ),
        friction=friction,
        inner_speed=speed,
    )


def _under_unit_load(bearing: Bearing, contacts: RaceContacts, modulus: Array) -> HertzContact:
    """Contacts under 1 N, (2, n): semi-axes and pressure go with the cube root of the load."""
    curvatures = [
        race_curvatures(bearing, race, contact_angle=np.abs(angle))
        for race, angle in zip(RACES, contacts.contact_angle, strict=True)
    ]
    rolling, transverse = (np.stack(values) for values in zip(*curvatures, strict=True))
    free = hertz_contact(curvature_x=rolling, curvature_y=transverse, load=1.0, modulus=modulus)
    root = np.cbrt(contacts.load)
    return HertzContact(
        **{
            name: np.divide(getattr(contacts.contact, name), root, out=getattr(free, name).copy(), where=root > 0)
            for name in vars(free)
        }
    )


def _by_force(bearing: Bearing, contacts: RaceContacts) -> Array:
    """(2, n, 4): how a radial and an axial force on the ball change the load, N/N, and turn the normal, rad/N.

    The ball sits between two springs whose far ends, the centres of the grooves, stand still; V = al or Q/(length) are
    those of `analytic.loads.ball_balance`.
    """
    load, angle, contact = contacts.load, contacts.contact_angle, contacts.contact
    free = np.reshape([groove.groove_radius - bearing.ball_radius for groove in (bearing.inner, bearing.outer)], (2, 1))
    length = free + contact.approach
    stiffness = 1.5 * np.divide(load, contact.approach, out=np.zeros_like(load), where=load > 0)
    normal = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    across = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
    springs = (
        stiffness[..., None, None] * normal[..., :, None] * normal[..., None, :]
        + (load / length)[..., None, None] * across[..., :, None] * across[..., None, :]
    )
    moved = np.linalg.inv(springs.sum(axis=0))  # (n, 2, 2): of the ball by a force
    away = np.array([-1.0, 1.0])[:, None, None]  # the ball moves away from the inner groove's contact
    by_load = away * stiffness[..., None] * np.einsum("rni,nij->rnj", normal, moved)
    by_angle = away / length[..., None] * np.einsum("rni,nij->rnj", across, moved)
    return np.concatenate([by_load, by_angle], axis=-1)
