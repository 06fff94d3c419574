"""The motion of a cage as a time series, for plots and files."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.brief import Brief
from analytic.cage.motion import CageMotion
from analytic.errors import require_positive
from analytic.labelled import Column, Labelled, dataset_of
from analytic.scene import Array

INSTANT, VECTOR, OF_BALLS = ("time",), ("time", "direction"), ("time", "ball", "direction")
COLUMNS = {
    "ball_angle": (INSTANT, Column("rad", "angle through which the balls have gone round the bearing")),
    "centre": (VECTOR, Column("m", "place of the cage's centre, from the centre of the bearing")),
    "velocity": (VECTOR, Column("m/s", "velocity of the cage's centre")),
    "axis": (VECTOR, Column("1", "axis of the cage, of length 1: it tilts")),
    "angular_velocity": (VECTOR, Column("rad/s", "angular velocity of the cage")),
    "offset": (OF_BALLS, Column("m", "place of each ball's centre, from the centre of its pocket")),
    "force": (OF_BALLS, Column("N", "force of each ball on the cage, normal force and friction")),
    "slip_power": (INSTANT, Column("W", "power of friction in the pockets, mean since the previous instant")),
    "max_force": (INSTANT, Column("N", "largest normal force of one contact since the previous instant")),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class CageSeries(Brief):
    """One motion at n instants in the fixed frame, with Z balls."""

    time: Array  # (n,) s
    ball_angle: Array  # (n,) rad, through which the balls have orbited
    centre: Array  # (n, 3) m
    velocity: Array  # (n, 3) m/s
    axis: Array  # (n, 3) direction of the axis of the cage, of length 1, dimensionless
    angular_velocity: Array  # (n, 3) rad/s
    offset: Array  # (n, Z, 3) from the centre of each pocket to that of its ball, m
    force: Array  # (n, Z, 3) of each ball on the cage, N
    slip_power: Array  # (n,) of friction in the pockets, mean since the previous instant, W
    max_force: Array  # (n,) largest normal force of one contact since the previous instant, N

    def to_dataset(self) -> Any:
        """An xarray.Dataset with units and meanings as attributes. Raises MissingPackageError without xarray."""
        numbers = np.arange(self.force.shape[1])
        return dataset_of(
            {name: Labelled(dimensions, getattr(self, name), column) for name, (dimensions, column) in COLUMNS.items()},
            coordinates={
                "time": Labelled(INSTANT, self.time, Column("s", "time since the beginning")),
                "direction": Labelled(("direction",), list("xyz"), Column("", "fixed frame; z is the bearing's axis")),
                "ball": Labelled(("ball",), numbers, Column("", "ball i begins at azimuth 2 pi i/Z")),
            },
            attributes={},
        )


def recorded_motion(motion: CageMotion, *, duration: float, samples: int) -> CageSeries:
    """A motion as it goes on, at n equidistant instants.

    duration : s, > 0;  samples : n, >= 1
    Raises MotionError if the motion diverges.
    """
    require_positive(duration=duration, samples=samples)
    rows: list[dict[str, Any]] = []
    for _ in range(samples):
        passed = motion.advance(duration / samples)
        row = {name: getattr(motion, name) for name in ("time", "ball_angle", "centre", "velocity", "angular_velocity")}
        row |= {"axis": motion.orientation[:, 2], "offset": motion.offsets, "force": motion.forces()}
        rows.append(row | {name: getattr(passed, name) for name in ("slip_power", "max_force")})
    return CageSeries(**{name: np.array([row[name] for row in rows]) for name in rows[0]})
