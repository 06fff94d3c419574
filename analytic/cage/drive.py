"""A cage as its balls drive it: their speeds, their lead, and the grip of the races.

A cage drives and brakes its balls only as far as the races hold them along the orbit. Two races share the force N of
the cage on a ball, and the friction mu_c N in the pocket loads one of them and relieves the other.
Under a radial load or a moment the contact angle changes with the azimuth, and with it the speed of the orbit: balls
lead on one side of the bearing and lag on the other. The cage gives way by half of that. Where its pockets are too
tight for the rest, it presses on all balls and drags them along by creep.
Balls whose motion is given are right as long as the cage uses little of the grip. Beyond LARGEST_GRIP balls slide, the
whirl breaks down or the torque of the races rises several-fold, and only a motion of balls and cage together shows it.
Source: derived here.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.cage.pocket import PocketFriction, PocketShape, friction_in_pocket, pocket_shape, pocket_stiffness
from analytic.cage.raceways import Raceways, ring_raceways, thrust_raceways
from analytic.cage.steady import RestingCage, lead_room, whirl_force, whirl_speed
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.numerics.records import Records
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, Cage, Scene
from analytic.words import speed_of

# Of the grip number. Below, motions of balls and cage together give the forces of given balls within 2 %; beyond, balls
# slide at the peaks of the force.
LARGEST_GRIP = 0.9
# Of the torque of squeezed balls. Marched motions with creep that saturates have 0.62 to 1.32 of their forces (some of
# them in tests/analytic/cage/test_grip.py), but only a rigid cage is squeezed so: one that bends, or whose pockets are
# longer along the orbit, may rest. The whole of it is therefore uncertain.
SQUEEZE_SPREAD = 1.0
ANGLE_TOLERANCE = 1e-12  # of beta: Newton's last step reaches it at once
# Of a right angle: where the first root is looked for. Roots nearer to each other than a step, 7 %, are missed.
SEARCHED = np.geomspace(1e-12, 1.0, 400)
SQUEEZE = Sought("the angle of squeezed balls did not converge", "rad", "check the pocket's stiffness")
LEAST_LOAD = 1e-300  # N: keeps a race without load from a division by 0

GRAVITY = {
    "across": (0.0, -STANDARD_GRAVITY, 0.0),
    "along": (0.0, 0.0, -STANDARD_GRAVITY),
    "off": (0.0, 0.0, 0.0),
}


def carried_force(*, inner_grip: ArrayLike, outer_grip: ArrayLike, pocket_friction: ArrayLike) -> Array:
    """N = min(2 mu Q_i/(1 + mu_c), 2 mu Q_o/|1 - mu_c|), N: what a cage can brake a ball with; all broadcast.

    inner_grip, outer_grip : mu Q_i, mu Q_o, the friction of each race, N, >= 0;  pocket_friction : mu_c, >= 0
    The pocket's friction mu_c N turns against the ball's rotation. So the inner race holds N (1 + mu_c)/2 and the outer
    one N (1 - mu_c)/2; at mu_c = 1 the outer race holds nothing, and beyond it pushes the other way. For a cage that
    drives a ball the races change places: exchange the first two arguments.
    Left out: the radial part of the force, which changes Q. It counts once N exceeds Q/2.
    """
    require_non_negative(inner_grip=inner_grip, outer_grip=outer_grip, pocket_friction=pocket_friction)
    inner, outer, mu = np.broadcast_arrays(np.asarray(inner_grip), np.asarray(outer_grip), np.asarray(pocket_friction))
    relieved = np.abs(1 - mu)
    by_outer = np.divide(2 * outer, relieved, out=np.full(mu.shape, np.inf), where=relieved > 0)
    return np.minimum(2 * inner / (1 + mu), by_outer)


def grip_number(*, whirl_force: ArrayLike, ball_count: ArrayLike, carried_force: ArrayLike) -> Array:
    """rho = m (w_b r/nabla + w_c)^2 nabla/(Z N): the whirl's force over what the races carry; all broadcast.

    whirl_force : m (w_b r/nabla + w_c)^2 nabla of `analytic.cage.steady.whirl_force`, N, >= 0;  ball_count : Z, > 0
    carried_force : N of the weakest ball in either direction, 2 mu min(Q)/(1 + mu_c), N, >= 0
    The force on a ball of a whirling cage brakes and drives it in turn. Infinite where a ball has no grip.
    Regimes, of motions of balls and cage together that start in whirl: below 0.9 the balls hold their motion; up to 1.7
    the whirl lasts and balls slide at the peaks; up to 3 it breaks down within tens of milliseconds; further beyond it
    dies into rattling or rest.
    """
    require_non_negative(whirl_force=whirl_force, carried_force=carried_force)
    require_positive(ball_count=ball_count)
    return used_share(whirl_force, np.asarray(ball_count) * np.asarray(carried_force))


def used_share(force: ArrayLike, available: ArrayLike) -> Array:
    """force/available; infinite where nothing is available for a force, 0 without a force."""
    used, limit = np.broadcast_arrays(np.asarray(force, dtype=np.float64), np.asarray(available, dtype=np.float64))
    return np.divide(used, limit, out=np.where(used > 0, np.inf, 0.0), where=limit > 0)


def ball_lead(orbit_rate: ArrayLike, *, pitch_radius: float) -> Array:
    """A, m, signed: balls at the azimuth psi lead an even orbit by A sin(psi), or lag behind it; (...).

    orbit_rate : (..., Z) w_c of the balls at psi_j = 2 pi j/Z over any speed, > 0;  pitch_radius : r_m, m
    A ball that passes psi with w_c(psi) is ahead by r_m times the integral of 1 - W/w_c over psi; W is its mean speed.
    A is the size of the first harmonic of that integral, with the sign of its part in sin(psi).
    Where the contact angle is al + a cos(psi), with g = D/d_m, this is
        A = r_m g sin(al) a/(1 - g cos al)
    The higher harmonics are 1 % of it under a radial load as large as the thrust, less under smaller loads.
    One column stands for balls that are alike: they do not lead.
    """
    require_positive(orbit_rate=orbit_rate, pitch_radius=pitch_radius)
    time = 1 / np.asarray(orbit_rate, dtype=np.float64)
    balls = time.shape[-1]
    turned = np.exp(2j * np.pi * np.arange(balls) / balls)
    wave = 2 * np.sum(time * turned, axis=-1) / np.sum(time, axis=-1)
    lead = -pitch_radius * np.copysign(np.abs(wave), wave.real)
    return np.asarray(lead if balls > 1 else np.zeros_like(lead))


def squeeze_force(
    *,
    ball_lead: ArrayLike,
    room: ArrayLike,
    pocket_friction: ArrayLike,
    pocket_stiffness: ArrayLike,
    sheet_softness: ArrayLike = 0.0,
    creep_stiffness: ArrayLike,
    outer_radius: ArrayLike,
) -> Array:
    """N = 2 G a b C11 |A| sin(beta)/R_o, N, of each ball: pockets too tight for balls that lead; all broadcast.

        2 nabla + 2 (N/K_pb)^(2/3) + 2 N/k = |A| (cos(beta) + mu_c sin(beta))
    In stiff pockets without friction this is N = 2 G a b C11 sqrt(A^2 - (2 nabla)^2)/R_o.
    ball_lead : A, m;  room : 2 nabla, the lead that the pockets leave free, m, > 0;  0 where |A| <= 2 nabla
    pocket_friction : mu_c;  pocket_stiffness : K_pb, N/m^1.5, > 0;  sheet_softness : 1/k, m/N
    creep_stiffness : G a b C11, N, of a race, > 0, see `race_grip`;  outer_radius : R_o, m, > 0
    The cage holds each ball nabla + (N/K_pb)^(2/3) + N/k off the middle of its pocket, in directions that turn twice as
    fast as the azimuth, so that all press alike. The cage has gone off the axis of the load by the angle beta; along
    the orbit act N sin(psi + beta) and mu_c N cos(psi + beta), and the races let a ball creep at this force times
    u/(2 G a b C11). In the steady motion creep takes from the lead what the pockets do not leave. This holds at any
    speed, as creep and conflict are both in proportion to it. The angle takes some radians of the orbit to grow.
    With friction and stiff pockets there can be three angles. The angle grows from 0 at the rate -surplus/(2 nabla), so
    the first one is that of balls that were not squeezed before, and the force is that of the first.
    Valid for a rigid cage and small creep, N below half of `carried_force`, which limits N.
    """
    require_positive(
        room=room,
        pocket_stiffness=pocket_stiffness,
        creep_stiffness=creep_stiffness,
        outer_radius=outer_radius,
    )
    require_non_negative(pocket_friction=pocket_friction, sheet_softness=sheet_softness)
    lead, free, mu, pocket, sheet, creep = np.broadcast_arrays(
        np.abs(np.asarray(ball_lead, dtype=np.float64)),
        np.asarray(room, dtype=np.float64),
        np.asarray(pocket_friction, dtype=np.float64),
        np.asarray(pocket_stiffness, dtype=np.float64),
        np.asarray(sheet_softness, dtype=np.float64),
        2 * np.asarray(creep_stiffness) / np.asarray(outer_radius),
    )
    softness = 2 * (creep * lead / pocket) ** (2 / 3)  # m, of the lead, at beta = pi/2
    bending = 2 * creep * lead * sheet  # m, likewise

    def surplus(beta: Array) -> tuple[Array, Array]:
        """Over the lead, of what pockets and compliance leave, with its slope."""
        sine, cosine = np.sin(beta), np.cos(beta)
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = softness * (2 / 3) * cosine / np.cbrt(sine) + bending * cosine + lead * (sine - mu * cosine)
        return free + softness * np.cbrt(sine) ** 2 + bending * sine - lead * (cosine + mu * sine), slope

    angles = np.multiply.outer(SEARCHED, np.where(lead > free, np.pi / 2, 0.0))
    passed = surplus(angles)[0] >= 0
    passed[-1] = True  # beyond a friction of 1 the last angle is the end
    first = passed.argmax(axis=0)[None]
    low, high = (np.take_along_axis(angles, np.maximum(first - k, 0), 0)[0] for k in (1, 0))
    beta = bracketed_root(
        surplus,
        start=(low + high) / 2,
        low=np.where(first[0] > 0, low, 0.0),
        high=high,
        relative=ANGLE_TOLERANCE,
        sought=SQUEEZE,
    )
    return creep * lead * np.sin(beta)


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceGrip:
    """How the races hold the balls along their orbit, at n operating points for m balls in columns."""

    friction: Array | None  # (2, n, m) mu Q of each contact, N; None: the friction of the races is not known
    alike: int  # balls that each column stands for
    ball_lead: Array  # (n,) A, m
    creep_stiffness: Array  # (n,) G a b C11, mean over balls and races, N
    outer_radius: Array  # (n,) R_o, m

    def carried(self, pocket_friction: Array) -> Array | None:
        """(n, m) N: what each ball carries in either direction; pocket_friction : mu_c, (n,)."""
        if self.friction is None:
            return None
        (inner, outer), mu = self.friction, pocket_friction[:, None]
        braked = carried_force(inner_grip=inner, outer_grip=outer, pocket_friction=mu)
        return np.minimum(braked, carried_force(inner_grip=outer, outer_grip=inner, pocket_friction=mu))

    def require_grip(self, inner_speed: Array) -> None:
        """Raise InputError for races or a ball that cannot drive a cage; inner_speed : w, (n,), rad/s."""
        if self.friction is None:
            return
        if not np.any(self.friction):
            raise InputError(
                "races with a friction of 0 drive no cage: balls then neither roll nor push it; give [friction] "
                'coefficient above 0, usual are 0.05 to 0.12, or effects.cage = "off"'
            )
        free = (self.friction.max(axis=0) == 0) & (inner_speed != 0)[:, None]
        if np.any(free):
            point, ball = (int(index) for index in np.argwhere(free)[0])
            raise InputError(
                f"ball {ball + 1} of {free.shape[1]} has a load of 0 N on both races at "
                f"{speed_of(inner_speed[point])}: nothing turns it, and it cannot drive the cage; leave "
                'effects.centrifugal on "auto", raise operation.axial_load, or give effects.cage = "off"'
            )


def on_races(of_balls: Array) -> Array:
    """(2, n, m) of each race from (n, m, 2)."""
    return np.moveaxis(of_balls, -1, 0)


def race_grip(bearing: Bearing, balls: Records, friction_coefficient: Array | float | None) -> RaceGrip:
    """The grip of loaded balls.

    balls : (n, m) of `analytic.solve.records.BALL`;  friction_coefficient : mu of each race contact, (2, n, m) or one
    Creep along rolling has G C11 = pi^2 G/(4 (1 - nu)), the limit of a long ellipse: pi^2 E*/4 for like bodies.
    """
    modulus = [contact_modulus(bearing.ball_material, groove.material) for groove in (bearing.inner, bearing.outer)]
    along, across = (on_races(balls[f"semi_axis_{name}"]).copy() for name in ("rolling", "transverse"))
    stiffness, friction = np.pi**2 / 4 * np.reshape(modulus, (2, 1, 1)) * along * across, None
    if friction_coefficient is not None:
        load = on_races(balls["load"])
        friction = np.where(load > 0, friction_coefficient * load, 0.0)
    return RaceGrip(
        friction=friction,
        alike=bearing.ball_count // balls.shape[1],
        ball_lead=ball_lead(balls["motion"]["cage_speed"], pitch_radius=bearing.pitch_diameter / 2),
        creep_stiffness=stiffness.mean(axis=(0, 2)),
        outer_radius=balls["motion"]["outer_radius"].mean(axis=1),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class CageDrive:
    """A cage and how its balls drive it at each operating point: means over balls and races, (n,)."""

    bearing: Bearing
    cage: Cage
    shape: PocketShape
    inner_speed: Array  # w, rad/s, of any sign
    orbit_rate: Array  # w_c/w
    ball_rate: Array  # w_b/w, of each ball about its own axis relative to the orbit
    contact_angle: Array  # al, magnitude, rad
    grip: RaceGrip  # of the races on the balls
    balls: Records  # (n, m) of `analytic.solve.records.BALL`
    friction_coefficient: Array | float | None  # mu of each race contact, (2, n, m) or one; None: not known

    @property
    def orbit_speed(self) -> Array:
        """|w_c|, rad/s."""
        return self.orbit_rate * np.abs(self.inner_speed)

    @property
    def ball_speed(self) -> Array:
        """|w_b|, rad/s."""
        return self.ball_rate * np.abs(self.inner_speed)

    @property
    def gravity(self) -> float:
        """g, magnitude, m/s^2."""
        return float(np.linalg.norm(GRAVITY[self.cage.gravity]))

    @property
    def whirling_force(self) -> Array:
        """Sum of the normal forces of all balls if the cage whirls, N."""
        speed, clearance = self.ball_speed, self.shape.half_clearance
        whirl = whirl_speed(
            ball_speed=speed, ball_radius=self.bearing.ball_radius, contact_angle=0.0, half_clearance=clearance
        )
        mass = self.cage.mass
        return whirl_force(cage_mass=mass, whirl=whirl, orbit_speed=self.orbit_speed, half_clearance=clearance)

    @cached_property
    def room(self) -> float:
        """Lead of the balls that the pockets leave free, m."""
        return resting_cage(self.bearing, self.cage).room

    @property
    def is_squeezed(self) -> NDArray[np.bool_]:
        """(n,) whether balls lead farther than the pockets leave free."""
        return np.abs(self.grip.ball_lead) >= self.room

    def grip_number(self, friction_coefficient: Array) -> Array:
        """(n,) rho of a whirl, see `analytic.cage.drive`; NaN where friction of the races or pockets are not known.

        friction_coefficient : mu_c, of ball on pocket, (n,)
        """
        carried = None if self.cage.gives_way else self.grip.carried(friction_coefficient)
        if carried is None:
            return np.full(self.inner_speed.shape, np.nan)
        return grip_number(
            whirl_force=self.whirling_force, ball_count=self.bearing.ball_count, carried_force=carried.min(axis=1)
        )

    def squeezing_force(self, friction_coefficient: Array) -> Array:
        """(n, m) N: of each ball on a cage whose pockets are too tight for balls that lead; 0 where there is room."""
        force = squeeze_force(
            ball_lead=self.grip.ball_lead,
            room=self.room,
            pocket_friction=friction_coefficient,
            pocket_stiffness=pocket_stiffness_of(self.bearing, self.cage),
            sheet_softness=sheet_softness_of(self.cage),
            creep_stiffness=self.grip.creep_stiffness,
            outer_radius=self.grip.outer_radius,
        )
        carried = self.grip.carried(friction_coefficient)
        return force[:, None] if carried is None else np.minimum(force[:, None], carried)

    def slides(self, friction_coefficient: Array) -> NDArray[np.bool_]:
        """(n,) whether a whirl would use more of the races' grip than given balls have; mu_c, (n,)."""
        return self.grip_number(friction_coefficient) > LARGEST_GRIP

    def races(self, scene: Scene, point: int) -> Raceways:
        """Both races of one operating point, for balls that move freely; friction : mean over the balls by load.

        Errors as those of `analytic.cage.raceways`.
        """
        balls, load = self.balls[point], on_races(self.balls["load"])[:, point]
        given = 0.0 if self.friction_coefficient is None else self.friction_coefficient
        mu = np.broadcast_to(given, (2, *self.balls.shape))
        inner, outer = np.sum(mu[:, point] * load, axis=1) / np.maximum(load.sum(axis=1), LEAST_LOAD)
        friction, speed = (float(inner), float(outer)), float(self.inner_speed[point])
        if balls.size == 1:
            return thrust_raceways(self.bearing, balls, inner_speed=speed, friction=friction)
        whole = scene.operation.as_series()
        operation = whole.at(np.array([point]))
        return ring_raceways(self.bearing, scene.contact_angle, operation, friction=friction)

    def pocket_friction(self, scene: Scene, force: Array) -> PocketFriction:
        """Friction of the balls when their normal forces add up to `force`, (n,), N, > 0."""
        surface_speed = self.ball_speed * self.bearing.ball_radius
        return friction_in_pocket(scene, load=force / self.bearing.ball_count, surface_speed=surface_speed)


def cage_drive(
    scene: Scene, balls: Records, friction_coefficient: Array | float | None, inner_speed: Array
) -> CageDrive:
    """The cage of a scene as these balls drive it.

    balls : (n, m) of `analytic.solve.records.BALL`;  inner_speed : w, (n,), rad/s
    friction_coefficient : mu of each race contact, (2, n, m) or one; None: not known
    Raises InputError for a scene without a cage, or a pocket without clearance for its ball.
    """
    bearing, cage = scene.bearing, scene.cage
    if cage is None:
        raise InputError("the scene has no [cage] to drive: add an empty table [cage] for the catalog's")
    motion, angle = balls["motion"], balls["angle"]
    side = np.where(angle.sum(axis=-1) < 0, -1.0, 1.0)  # a ball that is pressed the other way drives the cage alike
    return CageDrive(
        bearing=bearing,
        cage=cage,
        shape=pocket_shape_of(bearing, cage),
        inner_speed=inner_speed,
        orbit_rate=motion["cage_speed"].mean(axis=1),
        ball_rate=motion["ball_speed"].mean(axis=1),
        contact_angle=np.abs((side * on_races(angle)).mean(axis=(0, 2))),
        grip=race_grip(bearing, balls, friction_coefficient),
        balls=balls,
        friction_coefficient=friction_coefficient,
    )


def resting_cage(bearing: Bearing, cage: Cage) -> RestingCage:
    """Raises InputError for a pocket without clearance for its ball."""
    shape = pocket_shape_of(bearing, cage)
    return RestingCage(
        mass=float(cage.mass),
        gravity=float(np.linalg.norm(GRAVITY[cage.gravity])),
        lies_along=cage.gravity == "along",
        drag=float(cage.drag),
        room=np.inf
        if cage.gives_way
        else lead_room(
            half_clearance=shape.half_clearance,
            centre_offset=shape.centre_offset,
            land_half_clearance=np.inf if cage.land is None else cage.land.clearance / 2,
        ),
        ball_count=bearing.ball_count,
        ball_radius=bearing.ball_radius,
        pitch_radius=bearing.pitch_diameter / 2,
    )


def pocket_shape_of(bearing: Bearing, cage: Cage) -> PocketShape:
    """Raises InputError for a pocket without clearance for its ball."""
    return pocket_shape(
        ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, pocket_depth=cage.pocket_depth
    )


def sheet_softness_of(cage: Cage) -> float:
    """1/k, m/N, of the sheet in series with the contact; 0: rigid."""
    return 0.0 if cage.sheet_stiffness is None else 1 / cage.sheet_stiffness


def pocket_stiffness_of(bearing: Bearing, cage: Cage) -> float:
    """K_pb, N/m^1.5: as the cage gives it, else by Hertz."""
    if cage.pocket_stiffness is not None:
        return cage.pocket_stiffness
    pocket = pocket_contact(bearing, cage, load=0.0)
    modulus = contact_modulus(pocket.ball_material, pocket.race_material)
    return pocket_stiffness(ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, modulus=modulus)
