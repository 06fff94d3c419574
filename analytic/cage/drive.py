"""A cage as the balls of a scene drive it: their speeds, their lead and the grip of the races."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.cage.grip import LARGEST_GRIP, RaceGrip, grip_number, race_grip, squeeze_force
from analytic.cage.pocket import PocketFriction, PocketShape, friction_in_pocket, pocket_shape, pocket_stiffness
from analytic.cage.raceways import Raceways, ring_raceways, thrust_raceways
from analytic.cage.steady import STANDARD_GRAVITY, RestingCage, lead_room, whirl_force, whirl_speed
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, LoadEffects
from analytic.scene import Array, Bearing, Cage, Operation, Scene

LEAST_LOAD = 1e-300  # N: keeps a race without load from a division by 0

GRAVITY = {
    "across": (0.0, -STANDARD_GRAVITY, 0.0),
    "along": (0.0, 0.0, -STANDARD_GRAVITY),
    "off": (0.0, 0.0, 0.0),
}


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
    balls: LoadedBalls
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

    @property
    def room(self) -> float:
        """Lead of the balls that the pockets leave free, m."""
        return resting_cage(self.bearing, self.cage).room

    @property
    def is_squeezed(self) -> NDArray[np.bool_]:
        """(n,) whether balls lead farther than the pockets leave free."""
        return np.abs(self.grip.ball_lead) >= self.room

    def grip_number(self, friction_coefficient: Array) -> Array:
        """(n,) rho of a whirl, see `analytic.cage.grip`; NaN where the friction of the races is not known.

        friction_coefficient : mu_c, of ball on pocket, (n,)
        """
        carried = self.grip.carried(friction_coefficient)
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

        Errors as those of `analytic.cage.races`.
        """
        load = self.balls.load[:, point]
        given = 0.0 if self.friction_coefficient is None else self.friction_coefficient
        mu = np.broadcast_to(given, self.balls.load.shape)
        inner, outer = np.sum(mu[:, point] * load, axis=1) / np.maximum(load.sum(axis=1), LEAST_LOAD)
        friction, speed = (float(inner), float(outer)), float(self.inner_speed[point])
        if self.balls.method == "thrust":
            return thrust_raceways(self.bearing, self.balls, point=point, inner_speed=speed, friction=friction)
        whole = scene.operation.as_series()
        operation = Operation(**{name: values[[point]] for name, values in vars(whole).items()})
        return ring_raceways(self.bearing, scene.contact_angle, operation, LoadEffects(), friction=friction)

    def pocket_friction(self, scene: Scene, force: Array) -> PocketFriction:
        """Friction of the balls when their normal forces add up to `force`, (n,), N, > 0."""
        surface_speed = self.ball_speed * self.bearing.ball_radius
        return friction_in_pocket(scene, load=force / self.bearing.ball_count, surface_speed=surface_speed)


def cage_drive(
    scene: Scene, balls: LoadedBalls, friction_coefficient: Array | float | None, inner_speed: Array
) -> CageDrive:
    """The cage of a scene as these balls drive it.

    friction_coefficient : mu of each race contact, (2, n, m) or one; None: not known;  inner_speed : w, (n,), rad/s
    Raises InputError for a scene without a cage, or a pocket without clearance for its ball.
    """
    bearing, cage = scene.bearing, scene.cage
    if cage is None:
        raise InputError("the scene has no [cage] to drive: add an empty table [cage] for the catalog's")
    return CageDrive(
        bearing=bearing,
        cage=cage,
        shape=pocket_shape_of(bearing, cage),
        inner_speed=inner_speed,
        orbit_rate=balls.motion.cage_speed.mean(axis=1),
        ball_rate=balls.motion.ball_speed.mean(axis=1),
        contact_angle=np.abs(balls.contact_angle.mean(axis=(0, 2))),
        grip=race_grip(balls, friction_coefficient, pitch_radius=bearing.pitch_diameter / 2),
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
        room=lead_room(
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


def pocket_stiffness_of(bearing: Bearing, cage: Cage) -> float:
    """K_pb, N/m^1.5: as the cage gives it, else by Hertz."""
    if cage.pocket_stiffness is not None:
        return cage.pocket_stiffness
    pocket = pocket_contact(bearing, cage, load=0.0)
    modulus = contact_modulus(pocket.ball_material, pocket.race_material)
    return float(
        pocket_stiffness(ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, modulus=modulus)
    )
