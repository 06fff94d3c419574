"""What the cage adds to the torque of a bearing: by the closed form of a cage at rest on its balls, or by its motion.

A cage moves where the scene says how its motion starts and it could whirl; balls and cage move together where the cage
needs more grip than the races have, or balls lead farther than the pockets leave free. A cage whose pockets are too
tight for balls that lead has a closed form of its own.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.brief import Brief
from analytic.cage.drive import (
    GRAVITY,
    LARGEST_GRIP,
    SQUEEZE_SPREAD,
    CageDrive,
    pocket_shape_of,
    pocket_stiffness_of,
    resting_cage,
    sheet_softness_of,
    used_share,
)
from analytic.cage.pocket import PocketFriction
from analytic.cage.raceways import Raceways
from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.steady import (
    DrivenCage,
    DrivingBalls,
    LandGuidance,
    resting_load,
    resting_torque,
    sliding_torque,
    whirl_number,
)
from analytic.columns import OF_MOTION, Point, rows_of
from analytic.contact.geometry import known_half_widths
from analytic.numerics.elements import mapped
from analytic.rows import Two
from analytic.scene import Array, Bearing, Cage, Scene
from analytic.words import length_of, percent_of, speed_of, torque_of

GRIP = ("ball_lead", "grip_share", "grip_number", "race_excess")


@dataclass(frozen=True, kw_only=True, eq=False)
class CagePart(Brief):
    """What the cage adds at each operating point, (n,)."""

    torque: Array  # N m
    friction_coefficient: Array  # of ball on pocket
    mean_force: Array  # sum of the normal forces in all pockets, N
    signed_moment: Array  # of the balls on the cage about the axis, balanced by drag and land, N m
    ball_lead: Array  # A: how far balls lead on one side of the bearing and lag on the other, m
    is_squeezed: NDArray[np.bool_]  # whether that is more than the pockets leave free
    grip_share: (
        Array  # of what the races of all balls carry along the orbit: how much the mean force uses; NaN: unknown
    )
    grip_number: Array  # rho: the same of a whirl, by the ball with the least grip; NaN: unknown
    race_excess: Array  # part of `torque` that the races lose more because the cage drags the balls, N m; NaN: unknown
    driven: tuple[DrivenCage | None, ...]  # the cage that moved; None: by a closed form
    motion: tuple[CageStatistics | None, ...]  # its motion; likewise
    races: tuple[Raceways | None, ...]  # on which the balls moved freely; None: their motion was given
    warnings: tuple[str, ...]  # one line each
    provenance: str  # methods of motion, stiffness and friction

    @property
    def used_grip(self) -> Array:
        """(n,) share of what the races carry that the cage uses; NaN: unknown.

        A cage at rest hardly touches its balls. Where it moves otherwise on given balls, it may whirl, and the number
        of the whirl counts.
        """
        return np.where(self.is_moving_given_balls, self.grip_number, self.grip_share)

    @property
    def is_moving_given_balls(self) -> NDArray[np.bool_]:
        """(n,) whether the cage moves, and not at rest on its balls, whose own motion is given."""
        return np.isnan(self.race_excess) & ~np.isin(self._measured("state", "rest"), "rest")

    @property
    def half_interval(self) -> Array:
        """Half width of the interval of the mean torque at 95 %, N m; 0 for the closed form."""
        ends = [((0.0, 0.0),) * 2 if m is None else (m.torque_interval, m.race_excess_interval) for m in self.motion]
        return np.array([sum(high - low for low, high in each) / 2 for each in ends])

    def at(self, points: NDArray[np.intp]) -> "CagePart":
        """The same at some operating points.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        CagePart
            With arrays (k,).
        """
        kept = {name: value[points] for name, value in vars(self).items() if isinstance(value, np.ndarray)}
        series = ("driven", "motion", "races")
        return replace(self, **kept, **{name: tuple(getattr(self, name)[p] for p in points) for name in series})

    def columns(self) -> dict[str, NDArray[Any]]:
        """The values of OF_CAGE, (n,) or (n, 2), SI; NaN where a closed form has no such value."""
        squeezed = np.where(self.is_squeezed, "squeezed", "rest")
        return {
            "mean_force": self.mean_force,
            "max_force": self._measured("max_force"),
            "interval/torque": self._measured("torque_interval", (np.nan, np.nan)),
            "interval/max_force": self._measured("max_force_interval", (np.nan, np.nan)),
            "duration": self._measured("duration", 0.0),
            "state": np.where(self.has_moved, self._measured("state", ""), squeezed),
            "signed_moment": self.signed_moment,
            "whirl_speed": self._measured("whirl_speed"),
            "wobble": self._measured("wobble"),
            **{name: getattr(self, name) for name in GRIP},
        }

    @property
    def rows(self) -> tuple[Point, ...]:
        """A row for each operating point, by the names of `columns`."""
        return rows_of(self.columns())

    def motion_columns(self) -> dict[str, NDArray[Any]]:
        """The values of OF_MOTION, (n,), SI; NaN or None where no cage moved."""
        return {name: self._measured(name, np.nan if column.unit else None) for name, column in OF_MOTION.items()}

    @property
    def has_moved(self) -> NDArray[np.bool_]:
        """(n,) whether there is a motion."""
        return np.array([motion is not None for motion in self.motion])

    def _measured(self, name: str, unknown: Any = np.nan) -> NDArray[Any]:
        """(n, ...) a number or word of the motions, "other/torque" of another start; `unknown` where there is none."""
        found: list[Any] = [*self.motion]
        for part in name.split("/"):
            found = [None if each is None else getattr(each, part) for each in found]
        given = [unknown if each is None else each for each in found]
        return np.array(given, dtype=object if unknown is None else None)


@dataclass(frozen=True, kw_only=True)
class CageMoves:
    """Which motions of a cage are computed at n operating points, and why."""

    given: NDArray[np.bool_]  # (n,) where the cage moves on balls whose motion is given
    freely: NDArray[np.bool_]  # (n,) where balls and cage move together
    reasons: Mapping[str, str]  # of the effects `cage_dynamics` and `ball_dynamics`, where they have their input

    def on(self, name: str) -> bool:
        """Whether an effect of `reasons` is computed at any point."""
        return bool((self.given if name == "cage_dynamics" else self.freely).any())


LEAST_WHIRL = 1.0  # of the whirl number: a cage cannot whirl below
LEAST_FORCE = 1e-9  # N: at standstill too, no film is computed without a load


def cage_moves(scene: Scene, drive: CageDrive | None) -> CageMoves:
    """Where the cage of a scene moves; drive : None for a scene without a cage."""
    points = scene.operation.as_series().inner_speed
    nowhere = np.zeros(points.shape, dtype=bool)
    is_off = scene.effects.get("cage") == "off" or scene.bearing.kind == "thrust"
    if is_off or drive is None or drive.cage.start is None:
        return CageMoves(given=nowhere, freely=nowhere, reasons={})
    turns, squeezed = drive.inner_speed != 0, drive.is_squeezed
    whirl = whirl_number(
        ball_speed=drive.ball_speed,
        ball_radius=drive.bearing.ball_radius,
        half_clearance=drive.shape.half_clearance,
        gravity=drive.gravity,
    )
    choice, free_choice = (scene.effects.get(name, "auto") for name in ("cage_dynamics", "ball_dynamics"))
    may = turns & ~squeezed & (choice != "off")
    given = may & ((whirl >= LEAST_WHIRL) | (choice == "on"))
    mu = drive.pocket_friction(scene, np.maximum(drive.whirling_force, LEAST_FORCE)).coefficient
    slides = turns & (squeezed | (given & drive.slides(mu)))
    freely = turns & (slides | (free_choice == "on")) & (free_choice != "off")
    if drive.friction_coefficient is None:
        freely = nowhere
    most = float(np.max(whirl, initial=0.0))
    number = float(np.max(drive.grip_number(mu)))
    lead = float(np.max(np.abs(drive.grip.ball_lead)))
    tight = f"ball lead up to {length_of(lead)}, free clearance of the pockets {length_of(drive.room)}"
    return CageMoves(
        given=given & ~freely,
        freely=freely,
        reasons={
            "cage_dynamics": f"{tight}: the balls squeeze the cage"
            if squeezed.all()
            else f"whirl number {most:.3g} at most, no whirl below {LEAST_WHIRL:g}",
            "ball_dynamics": tight
            if squeezed.any()
            else f"grip number {number:.3g} at most, balls slide above {LARGEST_GRIP:g}",
        },
    )


def cage_friction(scene: Scene, drive: CageDrive, moves: CageMoves) -> CagePart:
    """Torque and forces of the cage, with what the races lose more because of it.

    moves : where it is by a motion from `cage.start`; elsewhere by a closed form
    Raises InputError for races or a ball without grip, MotionError if a motion diverges.
    """
    if not drive.cage.gives_way:
        drive.grip.require_grip(drive.inner_speed)
    points = drive.inner_speed.size
    weight, squeezing = resting_force(drive), _by_squeezing(drive, np.zeros(points))[1]
    whirling = np.where(moves.given | moves.freely, drive.whirling_force, 0.0)
    pressed = np.maximum(np.maximum(whirling, weight), squeezing)
    friction = drive.pocket_friction(scene, pressed)
    torque, force = _by_closed_form(drive, friction.coefficient)
    moment = drive.cage.drag * drive.orbit_speed * np.sign(drive.inner_speed)
    driven: list[DrivenCage | None] = [None] * points
    motion: list[CageStatistics | None] = [None] * points
    excess = np.full(points, np.nan)
    freely, given = moves.freely, moves.given  # at standstill the closed form is the limit
    races = tuple(drive.races(scene, point) if free else None for point, free in enumerate(freely))
    for point in map(int, np.flatnonzero(given | freely)):
        driven[point], moved = _moved(drive, point, float(friction.coefficient[point]), races[point])
        motion[point] = moved
        if races[point] is not None:
            excess[point] = moved.race_excess_torque
    own = np.array([rest if m is None else m.torque for m, rest in zip(motion, torque, strict=True)])
    moved_torque = own + np.nan_to_num(excess)
    part = CagePart(
        torque=moved_torque,
        race_excess=excess,
        friction_coefficient=friction.coefficient,
        mean_force=np.array([rest if m is None else m.mean_force for m, rest in zip(motion, force, strict=True)]),
        signed_moment=np.array(
            [drag if m is None else m.signed_moment for m, drag in zip(motion, moment, strict=True)]
        ),
        ball_lead=drive.grip.ball_lead,
        is_squeezed=drive.is_squeezed & ~freely,
        grip_share=np.full(points, np.nan),
        grip_number=drive.grip_number(friction.coefficient),
        driven=tuple(driven),
        motion=tuple(motion),
        races=races,
        warnings=friction.warnings
        + _bistable(motion, drive.inner_speed)
        + _squeezed(drive, drive.is_squeezed & ~freely),
        provenance=_provenance(drive, friction, moves),
    )
    return _with_grip(part, drive)


def _with_grip(part: CagePart, drive: CageDrive) -> CagePart:
    """The part with what it uses of the races' grip, and a warning where that is too much for given balls."""
    carried = drive.grip.carried(part.friction_coefficient)
    if carried is not None:
        part = replace(part, grip_share=used_share(part.mean_force, drive.grip.alike * carried.sum(axis=1)))
    used = part.used_grip
    past = (used > LARGEST_GRIP) | (part.is_moving_given_balls & np.isnan(used))
    slides = (not drive.cage.gives_way) & np.isnan(part.race_excess) & ~part.is_squeezed & past
    if not np.any(slides):
        return part
    worst = int(np.argmax(np.where(slides, np.nan_to_num(used), -1.0)))
    return replace(part, warnings=(*part.warnings, _sliding_balls(drive, worst, float(used[worst]))))


def _sliding_balls(drive: CageDrive, point: int, used: float) -> str:
    where = f"at {speed_of(drive.inner_speed[point])}"
    if np.isnan(used):
        return (
            f"grip of the races {where} not known: friction of the races not computed; set effects.spin and "
            'effects.conformity to "auto"'
        )
    return (
        f"the cage uses {percent_of(used)} of the grip of the races {where}, limit {percent_of(LARGEST_GRIP)}: balls "
        "slide, forces for given balls do not hold, and the torque of the races rises; raise the load, or lower the "
        "speed or the mass of the cage"
    )


def _by_closed_form(drive: CageDrive, friction_coefficient: Array) -> tuple[Array, Array]:
    """Torque, N m, and sum of the normal forces, N, of a cage at rest, or squeezed by balls that lead too far."""
    cage = resting_cage(drive.bearing, drive.cage)

    def at_rest(orbit_rate: float, ball_rate: float, contact_angle: float, mu: float, speed: float) -> Two:
        return resting_torque(cage, DrivingBalls(orbit_rate, ball_rate, contact_angle), mu, speed)

    driving = drive.orbit_rate, drive.ball_rate, drive.contact_angle
    torque, force = mapped(at_rest, *driving, friction_coefficient, drive.inner_speed)
    squeezed, squeezing = _by_squeezing(drive, friction_coefficient)
    return torque + squeezed, force + squeezing


def resting_force(drive: CageDrive) -> Array:
    """(n,) N, sum of the normal forces of a cage at rest, without friction."""
    cage = resting_cage(drive.bearing, drive.cage)
    return np.full(drive.inner_speed.size, drive.bearing.ball_count * resting_load(cage))


def _by_squeezing(drive: CageDrive, friction_coefficient: Array) -> tuple[Array, Array]:
    """Torque, N m, and sum of the normal forces, N, of balls that squeeze the cage."""
    if not np.any(drive.is_squeezed):
        return np.zeros_like(friction_coefficient), np.zeros_like(friction_coefficient)
    force = drive.grip.alike * drive.squeezing_force(friction_coefficient).sum(axis=1)
    torque = sliding_torque(
        friction_coefficient=friction_coefficient,
        force=force,
        ball_rate=drive.ball_rate,
        ball_radius=drive.bearing.ball_radius,
    )
    return torque, force


def _moved(
    drive: CageDrive, point: int, friction_coefficient: float, races: Raceways | None
) -> tuple[DrivenCage, CageStatistics]:
    cage, speed = drive.cage, float(drive.inner_speed[point])
    assert cage.start is not None  # else no motion is called for
    level = driven_cage(
        drive.bearing,
        cage,
        friction_coefficient=friction_coefficient,
        inner_speed=speed,
        orbit_speed=float(np.copysign(drive.orbit_speed[point], speed)),
        ball_speed=float(np.copysign(drive.ball_speed[point], speed)),
        contact_angle=float(drive.contact_angle[point]),
    )
    driven = level if races is not None else replace(level, ball_lead=float(drive.grip.ball_lead[point]))
    motion = measured_motion(
        driven,
        races=races,
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
    shape = pocket_shape_of(bearing, cage)
    return DrivenCage(
        mass=cage.mass,
        ball_count=bearing.ball_count,
        ball_radius=bearing.ball_radius,
        pitch_radius=bearing.pitch_diameter / 2,
        half_clearance=shape.half_clearance,
        centre_offset=shape.centre_offset,
        pocket_axis=cage.pocket_axis,
        stiffness=pocket_stiffness_of(bearing, cage),
        sheet_softness=sheet_softness_of(cage),
        restitution=cage.restitution,
        friction_coefficient=friction_coefficient,
        orbit_speed=orbit_speed,
        ball_speed=ball_speed,
        contact_angle=contact_angle,
        ring_speed=inner_speed,
        gravity=GRAVITY[cage.gravity],
        drag=cage.drag,
        land=_land(bearing, cage, inner_speed),
    )


def _land(bearing: Bearing, cage: Cage, inner_speed: float) -> LandGuidance | None:
    if cage.land is None:
        return None
    outside = cage.land.ring == "outer"
    groove = bearing.outer if outside else bearing.inner
    half_width = max(known_half_widths(bearing, cage.land.ring))  # the higher shoulder is next to the cage
    height = groove.groove_radius - np.sqrt(groove.groove_radius**2 - half_width**2)
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
                f"the cage has more than one steady motion: at {speed_of(inner_speed[point])} cage.start = "
                f'"{motion.start}" leads to {motion.state}, {torque_of(motion.torque)}, and "{other.start}" to '
                f"{other.state}, {torque_of(other.torque)}; the start in the scene decides",
            )
    return ()


def _squeezed(drive: CageDrive, at: NDArray[np.bool_]) -> tuple[str, ...]:
    """A warning for pockets that are too tight for the lead of the balls; at : (n,) where that has a closed form."""
    if not np.any(at):
        return ()
    worst = int(np.argmax(np.where(at, np.abs(drive.grip.ball_lead), -1.0)))
    return (
        f"at {speed_of(drive.inner_speed[worst])} balls lead on one side of the bearing and lag on the other by "
        f"{length_of(abs(drive.grip.ball_lead[worst]))}, free clearance of the pockets {length_of(drive.room)}: the "
        f"balls squeeze the cage, and the torque is that of a rigid cage, +- {percent_of(SQUEEZE_SPREAD)}; wider "
        "pockets avoid this",
    )


def _provenance(drive: CageDrive, friction: PocketFriction, moves: CageMoves) -> str:
    freely, cage = moves.freely, drive.cage
    tight = int(np.count_nonzero(drive.is_squeezed & ~freely))
    squeezed = f", squeezed by balls that lead at {tight} of {drive.inner_speed.size} points" if tight else ""
    squeezed += f", with balls that move freely at {freely.sum()} of {freely.size} points" if freely.any() else ""
    if not moves.given.any() and not freely.any():
        land = ", without land" if cage.land is not None else ""
        return f"closed form at rest{land}{squeezed}, friction by {friction.source}"
    stiffness = "Hertz" if cage.pocket_stiffness is None else "given approach"
    if cage.sheet_stiffness is not None:
        stiffness += f" with a sheet of {cage.sheet_stiffness * 1e-6:.4g} N/um"
    steps = f"{cage.steps_per_contact} steps a contact"
    return (
        f'motion from "{cage.start}", {steps}, pocket stiffness by {stiffness}{squeezed}, friction by {friction.source}'
    )
