"""What the cage adds to the torque of a bearing: by the closed form of a cage at rest on its balls, or by its motion.

`analytic.effects.cage` decides between the two.
"""

from dataclasses import dataclass

import numpy as np

from analytic.cage.pocket import PocketShape, pocket_shape, pocket_stiffness
from analytic.cage.pocket_friction import PocketFriction, friction_in_pocket
from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.steady import (
    STANDARD_GRAVITY,
    DrivenCage,
    LandGuidance,
    braked_torque,
    rest_torque,
    sliding_torque,
    whirl_force,
    whirl_speed,
)
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.loads.balls import LoadedBalls
from analytic.scene import Array, Bearing, Cage, Scene

GRAVITY = {
    "across": (0.0, -STANDARD_GRAVITY, 0.0),
    "along": (0.0, 0.0, -STANDARD_GRAVITY),
    "off": (0.0, 0.0, 0.0),
}
CAGE_KEYS = ("mean_force", "max_force", "interval", "duration", "state", "signed_moment")


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

    def pocket_friction(self, scene: Scene, force: Array) -> PocketFriction:
        """Friction of the balls when their normal forces add up to `force`, (n,), N, > 0."""
        surface_speed = self.ball_speed * self.bearing.ball_radius
        return friction_in_pocket(scene, load=force / self.bearing.ball_count, surface_speed=surface_speed)


def cage_drive(bearing: Bearing, cage: Cage, balls: LoadedBalls, inner_speed: Array) -> CageDrive:
    """The cage as these balls drive it; inner_speed : w, (n,), rad/s.

    Raises InputError for a pocket without clearance for its ball.
    """
    return CageDrive(
        bearing=bearing,
        cage=cage,
        shape=_pocket_shape(bearing, cage),
        inner_speed=inner_speed,
        orbit_rate=balls.motion.cage_speed.mean(axis=1),
        ball_rate=balls.motion.ball_speed.mean(axis=1),
        contact_angle=np.abs(balls.contact_angle.mean(axis=(0, 2))),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class CagePart:
    """What the cage adds at each operating point, (n,)."""

    torque: Array  # N m
    friction_coefficient: Array  # of ball on pocket
    mean_force: Array  # sum of the normal forces in all pockets, N
    signed_moment: Array  # of the balls on the cage about the axis, balanced by drag and land, N m
    driven: tuple[DrivenCage | None, ...]  # the cage that moved; None: at rest, by the closed form
    motion: tuple[CageStatistics | None, ...]  # its motion; likewise
    warnings: tuple[str, ...]
    provenance: str  # methods of motion, stiffness and friction

    @property
    def half_interval(self) -> Array:
        """Half width of the interval of the mean torque at 95 %, N m; 0 for the closed form."""
        ends = [(0.0, 0.0) if m is None else m.torque_interval for m in self.motion]
        return np.array([(high - low) / 2 for low, high in ends])

    def at(self, point: int) -> dict[str, object]:
        """CAGE_KEYS of one operating point as plain Python; None where a closed form has no such value."""
        motion = self.motion[point]
        if motion is None:
            values = (float(self.mean_force[point]), None, None, 0.0, "rest", float(self.signed_moment[point]))
        else:
            intervals = {"torque": list(motion.torque_interval), "max_force": list(motion.max_force_interval)}
            forces = (motion.mean_force, motion.max_force, intervals, motion.duration)
            values = (*forces, motion.state, motion.signed_moment)
        return dict(zip(CAGE_KEYS, values, strict=True))


def cage_friction(scene: Scene, drive: CageDrive, *, moves: bool) -> CagePart:
    """Torque and forces of the cage.

    moves : by its motion from `cage.start`, where the bearing turns; else by the closed form at rest
    Raises MotionError if a motion diverges.
    """
    cage, points = drive.cage, drive.inner_speed.size
    weight = np.full(points, cage.mass * max(drive.gravity, 1e-3 * STANDARD_GRAVITY))  # > 0: a film needs a load
    friction = drive.pocket_friction(scene, np.maximum(drive.whirling_force, weight) if moves else weight)
    torque, force = _at_rest(drive, friction.coefficient)
    moment = cage.drag * drive.orbit_speed * np.sign(drive.inner_speed)
    driven: list[DrivenCage | None] = [None] * points
    motion: list[CageStatistics | None] = [None] * points
    if moves:
        for point in map(int, np.flatnonzero(drive.inner_speed)):  # at standstill the closed form is the limit
            driven[point], motion[point] = _moved(drive, point, float(friction.coefficient[point]))
    return CagePart(
        torque=np.array([rest if m is None else m.torque for m, rest in zip(motion, torque, strict=True)]),
        friction_coefficient=friction.coefficient,
        mean_force=np.array([rest if m is None else m.mean_force for m, rest in zip(motion, force, strict=True)]),
        signed_moment=np.array(
            [drag if m is None else m.signed_moment for m, drag in zip(motion, moment, strict=True)]
        ),
        driven=tuple(driven),
        motion=tuple(motion),
        warnings=friction.warnings + _bistable(motion, drive.inner_speed),
        provenance=_provenance(cage, friction, moves=moves),
    )


def _at_rest(drive: CageDrive, friction_coefficient: Array) -> tuple[Array, Array]:
    """Torque, N m, and sum of the normal forces, N, of a cage that rests on its balls."""
    bearing, cage, mu = drive.bearing, drive.cage, friction_coefficient
    weight = np.full(mu.shape, cage.mass * drive.gravity)
    if cage.gravity == "along":  # the cage lies on its balls where their surfaces are slowest
        torque = sliding_torque(
            friction_coefficient=mu,
            force=weight,
            ball_rate=drive.ball_rate * np.sin(drive.contact_angle),
            ball_radius=bearing.ball_radius,
        )
    else:
        torque = rest_torque(
            friction_coefficient=mu,
            cage_mass=cage.mass,
            ball_rate=drive.ball_rate,
            ball_radius=bearing.ball_radius,
            contact_angle=drive.contact_angle,
            gravity=drive.gravity,
        )
        weight = weight / np.sqrt(1 + mu**2)
    braked = braked_torque(
        drag=cage.drag,
        friction_coefficient=mu,
        cage_rate=drive.orbit_rate,
        orbit_speed=drive.orbit_speed,
        pitch_radius=bearing.pitch_diameter / 2,
        ball_speed=drive.ball_speed,
        ball_radius=bearing.ball_radius,
    )
    return torque + braked, weight + cage.drag * drive.orbit_speed / (bearing.pitch_diameter / 2)


def _moved(drive: CageDrive, point: int, friction_coefficient: float) -> tuple[DrivenCage, CageStatistics]:
    cage, speed = drive.cage, float(drive.inner_speed[point])
    assert cage.start is not None  # else no motion is called for
    driven = driven_cage(
        drive.bearing,
        cage,
        friction_coefficient=friction_coefficient,
        inner_speed=speed,
        orbit_speed=float(np.copysign(drive.orbit_speed[point], speed)),
        ball_speed=float(np.copysign(drive.ball_speed[point], speed)),
        contact_angle=float(drive.contact_angle[point]),
    )
    motion = measured_motion(
        driven,
        start=cage.start,
        seeds=cage.seeds,
        duration=cage.duration,
        steps_per_contact=cage.steps_per_contact,
    )
    return driven, motion


def driven_cage(
    bearing: Bearing,
    cage: Cage,
    *,
    friction_coefficient: float,
    inner_speed: float,
    orbit_speed: float,
    ball_speed: float,
    contact_angle: float,
) -> DrivenCage:
    """The cage of a bearing at one operating point, ready to move; the outer ring stands still.

    friction_coefficient : mu of ball on pocket;  inner_speed : w, rad/s;  contact_angle : al, rad
    orbit_speed : w_c, ball_speed : w_b, with the sign of w, rad/s
    """
    shape = _pocket_shape(bearing, cage)
    return DrivenCage(
        mass=cage.mass,
        ball_count=bearing.ball_count,
        ball_radius=bearing.ball_radius,
        pitch_radius=bearing.pitch_diameter / 2,
        half_clearance=shape.half_clearance,
        centre_offset=shape.centre_offset,
        pocket_axis=cage.pocket_axis,
        stiffness=_stiffness(bearing, cage),
        restitution=cage.restitution,
        friction_coefficient=friction_coefficient,
        orbit_speed=orbit_speed,
        ball_speed=ball_speed,
        contact_angle=contact_angle,
        ring_speed=inner_speed,
        gravity=GRAVITY[cage.gravity],
        drag=cage.drag,
        ball_lead=cage.ball_lead,
        land=_land(bearing, cage, inner_speed),
    )


def _pocket_shape(bearing: Bearing, cage: Cage) -> PocketShape:
    return pocket_shape(
        ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, pocket_depth=cage.pocket_depth
    )


def _stiffness(bearing: Bearing, cage: Cage) -> float:
    if cage.pocket_stiffness is not None:
        return cage.pocket_stiffness
    pocket = pocket_contact(bearing, cage, load=0.0)
    modulus = contact_modulus(pocket.ball_material, pocket.race_material)
    return float(
        pocket_stiffness(ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, modulus=modulus)
    )


def _land(bearing: Bearing, cage: Cage, inner_speed: float) -> LandGuidance | None:
    if cage.land is None:
        return None
    outside = cage.land.ring == "outer"
    groove = bearing.outer if outside else bearing.inner
    height = groove.groove_radius - np.sqrt(groove.groove_radius**2 - groove.shoulder_half_width**2)
    return LandGuidance(
        radius=float(groove.bottom_radius + (-height if outside else height)),
        half_clearance=cage.land.clearance / 2,
        outside=outside,
        speed=0.0 if outside else inner_speed,
        half_width=cage.land.width / 2,
    )


def _bistable(motions: list[CageStatistics | None], inner_speed: Array) -> tuple[str, ...]:
    """A warning for the first operating point at which another start leads to another state."""
    for point, motion in enumerate(motions):
        if motion is not None and motion.other is not None and motion.other.state != motion.state:
            other = motion.other
            return (
                f"the cage has more than one steady motion: at {inner_speed[point]:.4g} rad/s cage.start = "
                f'"{motion.start}" leads to {motion.state}, {motion.torque:.3g} N m, and "{other.start}" to '
                f"{other.state}, {other.torque:.3g} N m; the start that the scene gives decides",
            )
    return ()


def _provenance(cage: Cage, friction: PocketFriction, *, moves: bool) -> str:
    if not moves:
        left_out = [
            key for key, given in (("land", cage.land is not None), ("ball_lead", cage.ball_lead != 0)) if given
        ]
        without = f", without {' and '.join(left_out)}" if left_out else ""
        return f"closed form at rest{without}, friction by {friction.source}"
    stiffness = "Hertz" if cage.pocket_stiffness is None else "given approach"
    steps = f"{cage.steps_per_contact} steps a contact"
    return f'motion from "{cage.start}", {steps}, pocket stiffness by {stiffness}, friction by {friction.source}'
