"""The motion of a cage as a time series, for plots and files."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from analytic.brief import Brief
from analytic.cage.motion import CageMotion
from analytic.errors import require_packages, require_positive
from analytic.scene import Array

AXES = ("x", "y", "z")  # of the fixed frame; z is the bearing's axis


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
        require_packages("a dataset", "xarray")
        import xarray  # takes a second to import

        described: dict[str, tuple[tuple[str, ...], str, str]] = {
            "ball_angle": (("time",), "rad", "angle through which the balls have gone round the bearing"),
            "centre": (("time", "direction"), "m", "place of the cage's centre, from the centre of the bearing"),
            "velocity": (("time", "direction"), "m/s", "velocity of the cage's centre"),
            "axis": (("time", "direction"), "1", "axis of the cage, of length 1: it tilts"),
            "angular_velocity": (("time", "direction"), "rad/s", "angular velocity of the cage"),
            "offset": (
                ("time", "ball", "direction"),
                "m",
                "place of each ball's centre, from the centre of its pocket",
            ),
            "force": (("time", "ball", "direction"), "N", "force of each ball on the cage, normal force and friction"),
            "slip_power": (("time",), "W", "power of friction in the pockets, mean since the previous instant"),
            "max_force": (("time",), "N", "largest normal force of one contact since the previous instant"),
        }
        return xarray.Dataset(
            {
                name: (dimensions, getattr(self, name), {"units": unit, "long_name": meaning})
                for name, (dimensions, unit, meaning) in described.items()
            },
            coords={
                "time": (("time",), self.time, {"units": "s", "long_name": "time since the beginning"}),
                "direction": ("direction", list(AXES), {"long_name": "fixed frame; z is the bearing's axis"}),
                "ball": (
                    "ball",
                    np.arange(self.force.shape[1]),
                    {"long_name": "ball i begins at azimuth 2 pi i/Z"},
                ),
            },
        )


def recorded_motion(motion: CageMotion, *, duration: float, samples: int) -> CageSeries:
    """A motion as it goes on, at n equidistant instants.

    duration : s, > 0;  samples : n, >= 1
    Raises MotionError if the motion diverges.
    """
    require_positive(duration=duration, samples=samples)
    rows: list[tuple[Any, ...]] = []
    for _ in range(samples):
        passed = motion.advance(duration / samples)
        rows.append(
            (
                motion.time,
                motion.ball_angle,
                motion.centre,
                motion.velocity,
                motion.orientation[:, 2],
                motion.angular_velocity,
                motion.offsets,
                motion.forces(),
                passed.slip_power,
                passed.max_force,
            )
        )
    columns = [np.array(column) for column in zip(*rows, strict=True)]
    return CageSeries(**{part.name: column for part, column in zip(fields(CageSeries), columns, strict=True)})
