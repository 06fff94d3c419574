"""One motion of a scene's cage, kept instant by instant: the first of those whose statistics stand in the torque."""

import json
import shlex
from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np
from annotated_types import MinLen

from analytic.brief import Brief
from analytic.cage.motion import CageMotion
from analytic.cage.series import CageSeries, recorded_motion
from analytic.cage.statistics import CageStatistics, State
from analytic.cage.steady import DrivenCage, whirl_speed
from analytic.result import FrictionTorque
from analytic.rows import NotNegative, Positive, Two
from analytic.scene import CageStart, Scene
from fembearing.provenance import provenance_of

INSTANTS_A_TURN = 40  # of a cage that whirls: a circle is drawn round
FEWEST, MOST = 1000, 20000  # instants
SEED = 0
DIRECTIONS = 180  # in which the edge of the cage's room is computed


Numbers = Annotated[tuple[float, ...], MinLen(1)]
Places = Annotated[tuple[Two, ...], MinLen(1)]


@dataclass(frozen=True, kw_only=True)
class Room:
    """Where the centre of the cage can be, m."""

    size: Positive
    middle: Two
    edge: Places


@dataclass(frozen=True, kw_only=True)
class Orbit:
    """Places of the centre of the cage, m."""

    joined: bool  # whether neighbours in a list are so in time too
    start_up: Places
    measured: Places


@dataclass(frozen=True, kw_only=True)
class Forces:
    """Forces of balls on the cage over time."""

    time: Numbers  # s
    largest: Numbers  # of one ball, N
    sum: Numbers  # over all balls, N


@dataclass(frozen=True, kw_only=True)
class Exceedance:
    """How often each force is exceeded."""

    force: tuple[Positive, ...]  # N, rising
    share: tuple[Positive, ...]  # of all instants


@dataclass(frozen=True, kw_only=True)
class DrawnMotion:
    """One motion of a cage, as it is drawn; intervals at 95 %."""

    point: int  # number of the operating point, from 1
    inner_speed: float  # rad/s
    bearing: str
    state: State
    start: CageStart
    start_up: Positive  # that no statistics count, s
    torque: float  # N m
    torque_interval: Two  # N m
    max_force: NotNegative  # N
    max_force_interval: Two  # N
    block: float  # s
    block_maxima: Numbers  # N
    gravity: tuple[float, float, float]  # m/s^2
    room: Room
    orbit: Orbit
    forces: Forces
    exceedance: Exceedance


@dataclass(frozen=True, kw_only=True, eq=False)
class CageRecord(Brief):
    """A cage that moved at one operating point."""

    scene: Scene
    point: int  # number of the operating point, from 1
    cage: DrivenCage
    statistics: CageStatistics  # of all seeds
    series: CageSeries  # of one seed, from its beginning
    start_up: float  # that no statistics count, s

    @property
    def measured(self) -> np.ndarray:
        """(n,) whether an instant comes after the start-up, dimensionless."""
        return self.series.time > self.start_up

    def drawn(self, *, most: int | None = None) -> DrawnMotion:
        """Orbit and forces of this motion, and the statistics of all seeds, for a figure.

        Parameters
        ----------
        most : int, optional
            Number of instants of the orbit and of the forces; a force is then the greatest of those that it stands for.
            None: all of them.

        Returns
        -------
        DrawnMotion
            SI.
        """
        series, statistics, after = self.series, self.statistics, self.measured
        angle = np.linspace(0, 2 * np.pi, 1 + DIRECTIONS)
        directions = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
        way = np.array([self.cage.free_path(direction) for direction in directions])
        edge = self.cage.middle + way[:, None] * directions
        places = [_evenly(series.centre[part, :2], most) for part in (~after, after)]
        total = np.linalg.norm(series.force, axis=2).sum(axis=1)
        force, share = exceedance(series.max_force[after], most)
        shared = ("state", "start", "torque", "torque_interval", "max_force", "max_force_interval", "block")
        return DrawnMotion(
            point=self.point,
            inner_speed=self.cage.ring_speed,
            bearing=self.scene.bearing.name,
            start_up=self.start_up,
            **{name: getattr(statistics, name) for name in shared},
            block_maxima=tuple(statistics.block_maxima),
            gravity=self.cage.gravity,
            room=Room(
                size=self.cage.half_clearance,
                middle=tuple(self.cage.middle[:2].tolist()),
                edge=tuple(map(tuple, edge[:, :2].tolist())),
            ),
            orbit=Orbit(
                joined=most is None,
                start_up=tuple(map(tuple, places[0].tolist())),
                measured=tuple(map(tuple, places[1].tolist())),
            ),
            forces=Forces(
                time=tuple(_evenly(series.time, most).tolist()),
                largest=tuple(_greatest(series.max_force, most).tolist()),
                sum=tuple(_greatest(total, most).tolist()),
            ),
            exceedance=Exceedance(force=tuple(force.tolist()), share=tuple(share.tolist())),
        )

    def to_dataset(self) -> Any:
        """The series as an xarray.Dataset with its provenance."""
        dataset = self.series.to_dataset()
        origin = provenance_of(self.scene)
        dataset.attrs = {
            "title": f"motion of the cage of {self.scene.bearing.name}, operating point {self.point}",
            "scene": self.scene.name,
            "scene_content": json.dumps(origin.scene_content),
            "scene_sha256": origin.scene_sha256,
            "history": f"{origin.date}: {shlex.join(origin.command)}",
            "versions": json.dumps(origin.versions),
            "units": "SI; each variable has its own",
            "inner_speed_rad_per_s": self.cage.ring_speed,
            "room_m": self.cage.half_clearance,
            "start": self.statistics.start,
            "seed": SEED,
            "start_up_s": self.start_up,
            "state_of_all_seeds": self.statistics.state,
        }
        return dataset


def record_cage(scene: Scene, friction: FrictionTorque, point: int) -> CageRecord | None:
    """Run the motion of one operating point, from 0, once more; None where the cage did not move.

    friction : friction_torque(scene)
    Raises MotionError for a motion that comes apart.
    """
    part, noun = friction.cage, scene.cage
    if part is None or noun is None:
        return None
    cage, statistics = part.driven[point], part.motion[point]
    if cage is None or statistics is None:
        return None
    whirl = whirl_speed(
        ball_speed=cage.ball_speed,
        ball_radius=cage.ball_radius,
        contact_angle=0.0,
        half_clearance=cage.half_clearance,
    )
    turns = 2 * noun.duration * abs(float(whirl) + cage.orbit_speed) / (2 * np.pi)
    start = {
        "begin": statistics.start,
        "seed": SEED,
        "ramp": noun.duration,
        "steps_per_contact": noun.steps_per_contact,
    }
    motion = CageMotion(cage, part.races[point], **start)
    return CageRecord(
        scene=scene,
        point=point + 1,
        cage=cage,
        statistics=statistics,
        series=recorded_motion(
            motion,
            duration=2 * noun.duration,
            samples=int(np.clip(np.ceil(INSTANTS_A_TURN * turns), FEWEST, MOST)),
        ),
        start_up=noun.duration,
    )


def exceedance(force: np.ndarray, most: int | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Forces above 0, rising, and the share of all that no smaller one lies above, (n,) each; the rarest are kept.

    force : (m,) N;  most : of them; None: all
    """
    rising = np.sort(force[force > 0])
    count = np.arange(rising.size, 0, -1)
    if most is not None and rising.size > most:
        kept = np.unique(np.geomspace(1, rising.size, most).round().astype(np.intp))  # from the end
        rising, count = rising[rising.size - kept][::-1], kept[::-1]
    return rising, count / force.size


def _step(size: int, most: int | None) -> int:
    return 1 if most is None else max(1, -(-size // most))


def _evenly(values: np.ndarray, most: int | None) -> np.ndarray:
    """Every so many, the last among them."""
    return values[:: -_step(len(values), most)][::-1]


def _greatest(values: np.ndarray, most: int | None) -> np.ndarray:
    """Of each group of neighbours, counted from the end."""
    step = _step(values.size, most)
    starts = np.arange(values.size % step or step, values.size, step)
    return np.maximum.reduceat(values, np.concatenate([[0], starts]).astype(np.intp))
