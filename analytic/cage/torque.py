"""What the cage adds to the torque of a bearing: a closed form of a cage at rest on its balls, or its motion.

The closed form costs nothing. The motion takes seconds a point, so that it is for scenes that tell from where it starts
(`cage.start`) and whose cage could whirl, and by that could cost more than the tolerance; or that have it on.
"""

from dataclasses import dataclass

import numpy as np

from analytic.cage.motion import STEPS_PER_CONTACT
from analytic.cage.pocket import half_clearance, pocket_stiffness
from analytic.cage.pocket_friction import PocketFriction, friction_in_pocket
from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.steady import (
    DrivenCage,
    LandGuidance,
    braked_torque,
    rest_torque,
    whirl_bound,
    whirl_force,
    whirl_speed,
)
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.effects.bounds import STANDARD_GRAVITY, whirl_number
from analytic.effects.ledger import Ledger
from analytic.loads.balls import LoadedBalls
from analytic.scene import Array, Bearing, Cage, Operation, Scene

PULL = {
    "across": (0.0, -STANDARD_GRAVITY, 0.0),
    "along": (0.0, 0.0, -STANDARD_GRAVITY),
    "off": (0.0, 0.0, 0.0),
}
# s of motion that are simulated unasked, start-up and all seeds counted: some ten minutes in steps as usual
LONGEST = 500.0
CAGE_KEYS = ("mean_force", "max_force", "interval", "duration", "state", "signed_moment")


@dataclass(frozen=True, kw_only=True, eq=False)
class CagePart:
    """What the cage adds at each operating point, (n,)."""

    torque: Array  # N m
    friction_coefficient: Array  # of ball on pocket
    mean_force: Array  # sum of the normal forces in all pockets, N
    signed_moment: Array  # of the balls on the cage about the axis: what drag takes, or land gives, N m
    driven: tuple[DrivenCage | None, ...]  # what moved; None: at rest, by the closed form
    motion: tuple[CageStatistics | None, ...]  # how; likewise
    warnings: tuple[str, ...]
    provenance: str  # rungs of motion, stiffness and friction

    @property
    def half_interval(self) -> Array:
        """Half-width at 95 % of the mean torque that the motion gives, N m; 0 of a closed form."""
        ends = [(0.0, 0.0) if m is None else m.torque_interval for m in self.motion]
        return np.array([(high - low) / 2 for low, high in ends])

    def at(self, point: int) -> dict[str, object]:
        """CAGE_KEYS of one operating point in plain Python; None where a closed form has no such thing."""
        found = self.motion[point]
        if found is None:
            values = (float(self.mean_force[point]), None, None, 0.0, "rest", float(self.signed_moment[point]))
        else:
            intervals = {"torque": list(found.torque_interval), "max_force": list(found.max_force_interval)}
            forces = (found.mean_force, found.max_force, intervals, found.duration)
            values = (*forces, found.state, found.signed_moment)
        return dict(zip(CAGE_KEYS, values, strict=True))


def cage_friction(
    scene: Scene, balls: LoadedBalls, operation: Operation, ledger: Ledger, *, race: Array
) -> CagePart | None:
    """Decides `cage` and `cage_dynamics`, and computes what is called for; None without a cage.

    operation : every array (n,);  race : torque of the races, (n,), N m, that the bound on the motion is compared with
    Raises InputError for a pocket without room for its ball, MotionError where a motion comes apart.
    """
    cage = scene.cage
    if cage is None:
        ledger.decide("cage")
        ledger.decide("cage_dynamics")
        return None
    bearing, speed = scene.bearing, np.abs(operation.inner_speed)
    room, _ = half_clearance(
        ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, pocket_depth=cage.pocket_depth
    )
    if not ledger.decide("cage"):
        ledger.settle("cage_dynamics", on=False, reason="the cage is left out")
        return None
    rate = balls.motion.ball_speed.mean(axis=1)
    orbit = balls.motion.cage_speed.mean(axis=1) * speed
    angle = np.abs(balls.contact_angle.mean(axis=(0, 2)))
    pull = float(np.linalg.norm(PULL[cage.gravity]))
    whirl = whirl_speed(ball_speed=rate * speed, ball_radius=bearing.ball_radius, contact_angle=0.0, room=room)
    thrown = whirl_force(cage_mass=cage.mass, whirl=whirl, orbit_speed=orbit, room=room)
    moves = _moves(scene, ledger, thrown, rate=rate, speed=speed, room=room, pull=pull, race=race)
    weight = np.full(speed.shape, cage.mass * max(pull, 1e-3 * STANDARD_GRAVITY))
    friction = friction_in_pocket(
        scene,
        load=(np.maximum(thrown, weight) if moves else weight) / bearing.ball_count,
        surface_speed=rate * speed * bearing.ball_radius,
    )
    mu, hanging = friction.coefficient, np.full(speed.shape, cage.mass * pull)
    if cage.gravity == "along":  # it lies on its balls where they turn least
        sliding = rate * np.sin(angle)
        resting = whirl_bound(
            friction_coefficient=mu, force=hanging, ball_rate=sliding, ball_radius=bearing.ball_radius
        )
    else:
        hanging = hanging / np.sqrt(1 + mu**2)
        resting = rest_torque(
            friction_coefficient=mu,
            cage_mass=cage.mass,
            ball_rate=rate,
            ball_radius=bearing.ball_radius,
            contact_angle=angle,
            gravity=pull,
        )
    resting = resting + braked_torque(
        drag=cage.drag,
        friction_coefficient=mu,
        cage_rate=balls.motion.cage_speed.mean(axis=1),
        orbit_speed=orbit,
        pitch_radius=bearing.pitch_diameter / 2,
        ball_speed=rate * speed,
        ball_radius=bearing.ball_radius,
    )
    hanging = hanging + cage.drag * orbit / (bearing.pitch_diameter / 2)
    pushed = cage.drag * orbit * np.sign(operation.inner_speed)
    driven: list[DrivenCage | None] = [None] * speed.size
    found: list[CageStatistics | None] = [None] * speed.size
    if moves:
        assert cage.start is not None
        turning = np.sign(operation.inner_speed)
        for point in np.flatnonzero(speed):  # at standstill the closed form is the limit
            sign = float(turning[point])
            moving = driven_cage(
                bearing,
                cage,
                friction_coefficient=float(mu[point]),
                inner_speed=float(operation.inner_speed[point]),
                orbit_speed=sign * float(orbit[point]),
                ball_speed=sign * float(rate[point] * speed[point]),
                contact_angle=float(angle[point]),
            )
            driven[point] = moving
            found[point] = measured_motion(
                moving,
                start=cage.start,
                seeds=cage.seeds,
                duration=cage.duration,
                steps_per_contact=cage.steps_per_contact,
            )
    return CagePart(
        torque=np.array([rest if m is None else m.torque for m, rest in zip(found, resting, strict=True)]),
        friction_coefficient=mu,
        mean_force=np.array([rest if m is None else m.mean_force for m, rest in zip(found, hanging, strict=True)]),
        signed_moment=np.array([drag if m is None else m.signed_moment for m, drag in zip(found, pushed, strict=True)]),
        driven=tuple(driven),
        motion=tuple(found),
        warnings=friction.warnings + _bistable(found, operation),
        provenance=_told(cage, friction, moves=moves),
    )


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
    """The cage of a bearing as its motion takes it, at one operating point; the outer ring stands still.

    friction_coefficient : mu of ball on pocket;  inner_speed : w, rad/s;  orbit_speed : w_c, ball_speed : w_b, with the
        sign of w, rad/s;  contact_angle : al, rad
    """
    room, centre_offset = half_clearance(
        ball_diameter=bearing.ball_diameter, pocket_diameter=cage.pocket_diameter, pocket_depth=cage.pocket_depth
    )
    return DrivenCage(
        mass=cage.mass,
        ball_count=bearing.ball_count,
        ball_radius=bearing.ball_radius,
        pitch_radius=bearing.pitch_diameter / 2,
        room=room,
        centre_offset=centre_offset,
        pocket_axis=cage.pocket_axis,
        stiffness=_stiffness(bearing, cage),
        restitution=cage.restitution,
        friction_coefficient=friction_coefficient,
        orbit_speed=orbit_speed,
        ball_speed=ball_speed,
        contact_angle=contact_angle,
        ring_speed=inner_speed,
        gravity=PULL[cage.gravity],
        drag=cage.drag,
        ball_lead=cage.ball_lead,
        land=_land(bearing, cage, inner_speed),
    )


def _moves(
    scene: Scene, ledger: Ledger, thrown: Array, *, rate: Array, speed: Array, room: float, pull: float, race: Array
) -> bool:
    """Whether the scene calls for the motion."""
    cage, bearing, asked = scene.cage, scene.bearing, scene.effects.get("cage_dynamics", "auto")
    assert cage is not None
    number = whirl_number(ball_speed=rate * speed, ball_radius=bearing.ball_radius, clearance=2 * room, gravity=pull)
    most = float(np.max(number, initial=0.0))
    if asked == "auto" and most < 1:
        reason = f"the cage cannot whirl: whirl number {most:.3g} at most, below 1; it rests, by the closed form"
        ledger.settle("cage_dynamics", on=False, share=np.zeros_like(speed), reason=reason)
        return False
    thrown = np.maximum(thrown, 1e-9)  # N: at standstill no film is asked for without a load
    friction = friction_in_pocket(
        scene, load=thrown / bearing.ball_count, surface_speed=speed * rate * bearing.ball_radius
    )
    bound = whirl_bound(
        friction_coefficient=friction.coefficient, force=thrown, ball_rate=rate, ball_radius=bearing.ball_radius
    )
    bound = np.where(number < 1, 0.0, bound)
    share = np.divide(bound, race, out=np.where(bound > 0, np.inf, 0.0), where=race > 0)
    lacks = None
    if cage.start is None:
        lacks = (
            f"cage.start is not given, and with a whirl number of 1 or more, here up to {most:.3g}, a cage rests or "
            'whirls by how it started: give "rest", "ramp", "sudden" or "whirl"'
        )
    points = np.count_nonzero(speed)
    simulated = 2 * cage.duration * (cage.seeds + 1) * points  # start-up and measured time; the last of another start
    longest = LONGEST * STEPS_PER_CONTACT / cage.steps_per_contact
    if asked == "auto" and lacks is None and simulated > longest:
        lacks = (
            f"{points} points take {simulated:.3g} s of motion, and beyond {longest:.3g} s at {cage.steps_per_contact} "
            "steps a contact it is not computed unasked: give fewer points, seeds or steps, a shorter duration, or "
            'effects.cage_dynamics = "on"'
        )
    return ledger.decide("cage_dynamics", bound=share, lacks=lacks)


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
        room=cage.land.clearance / 2,
        outside=outside,
        speed=0.0 if outside else inner_speed,
        half_width=cage.land.width / 2,
    )


def _bistable(found: list[CageStatistics | None], operation: Operation) -> tuple[str, ...]:
    """One warning, of the first operating point at which another start leads elsewhere."""
    for point, motion in enumerate(found):
        if motion is not None and motion.other is not None and motion.other.state != motion.state:
            other = motion.other
            return (
                f"the cage has more than one steady motion: at {operation.inner_speed[point]:.4g} rad/s cage.start = "
                f'"{motion.start}" leads to {motion.state}, {motion.torque:.3g} N m, and "{other.start}" to '
                f"{other.state}, {other.torque:.3g} N m; the start that the scene gives decides",
            )
    return ()


def _told(cage: Cage, friction: PocketFriction, *, moves: bool) -> str:
    if not moves:
        held = [key for key, given in (("land", cage.land is not None), ("ball_lead", cage.ball_lead != 0)) if given]
        without = f", without {' and '.join(held)}" if held else ""
        return f"closed form at rest{without}, friction by {friction.source}"
    stiffness = "Hertz" if cage.pocket_stiffness is None else "given approach"
    steps = f"{cage.steps_per_contact} steps a contact"
    return f'motion from "{cage.start}", {steps}, pocket stiffness by {stiffness}, friction by {friction.source}'
