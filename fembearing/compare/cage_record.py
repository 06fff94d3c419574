"""One motion of a scene's cage, kept instant by instant: the first of those whose statistics stand in the torque."""

import json
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.cage import DrivenCage, whirl_speed
from analytic.cage_series import CageSeries, recorded_motion
from analytic.cage_statistics import CageStatistics
from analytic.scene import Scene
from fembearing.compare.provenance import provenance_of
from fembearing.compare.scene_torque import SceneTorque

INSTANTS_A_TURN = 40  # of a cage that whirls: a circle is drawn round
FEWEST, MOST = 1000, 20000  # instants
SEED = 0


@dataclass(frozen=True, kw_only=True, eq=False)
class CageRecord:
    """A cage that moved at one operating point."""

    scene: Scene
    point: int  # from 1
    cage: DrivenCage
    statistics: CageStatistics  # of all seeds
    series: CageSeries  # of one seed, from its beginning
    start_up: float  # that no statistics count, s

    @property
    def measured(self) -> np.ndarray:
        """(n,) instants after the start-up."""
        return self.series.time > self.start_up

    def to_dataset(self) -> Any:
        """The series as an xarray.Dataset that tells where it comes from."""
        found = self.series.to_dataset()
        origin = provenance_of(self.scene)
        found.attrs = {
            "title": f"motion of the cage of {self.scene.bearing.name}, operating point {self.point}",
            "scene": self.scene.name,
            "scene_content": json.dumps(origin["scene_content"]),
            "scene_sha256": origin["scene_sha256"],
            "history": f"{origin['date']}: {' '.join(origin['command'])}",
            "versions": json.dumps(origin["versions"]),
            "units": "SI; each variable has its own",
            "inner_speed_rad_per_s": self.cage.ring_speed,
            "room_m": self.cage.room,
            "start": self.statistics.start,
            "seed": SEED,
            "start_up_s": self.start_up,
            "state_of_all_seeds": self.statistics.state,
        }
        return found


def record_cage(result: SceneTorque, point: int) -> CageRecord | None:
    """Run the motion of one operating point, from 0, once more; None where the cage did not move.

    Raises MotionError where it comes apart.
    """
    part, noun = result.found.cage, result.scene.cage
    if part is None or noun is None:
        return None
    cage, statistics = part.driven[point], part.motion[point]
    if cage is None or statistics is None:
        return None
    whirl = whirl_speed(ball_speed=cage.ball_speed, ball_radius=cage.ball_radius, contact_angle=0.0, room=cage.room)
    turns = 2 * noun.duration * abs(float(whirl) + cage.orbit_speed) / (2 * np.pi)
    return CageRecord(
        scene=result.scene,
        point=point + 1,
        cage=cage,
        statistics=statistics,
        series=recorded_motion(
            cage,
            start=statistics.start,
            duration=2 * noun.duration,
            samples=int(np.clip(np.ceil(INSTANTS_A_TURN * turns), FEWEST, MOST)),
            ramp=noun.duration,
            seed=SEED,
            steps_per_contact=noun.steps_per_contact,
        ),
        start_up=noun.duration,
    )
