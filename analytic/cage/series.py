"""A cage's motion as a series in time, for plots and for files."""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from analytic.cage.motion import STEPS_PER_CONTACT, CageMotion
from analytic.cage.steady import DrivenCage
from analytic.errors import require_positive
from analytic.scene import Array, CageStart

AXES = ("x", "y", "z")  # of the fixed frame; z is the bearing's axis


@dataclass(frozen=True, kw_only=True, eq=False)
class CageSeries:
    """n instants of one motion in the fixed frame, Z balls."""

    time: Array  # (n,) s
    ball_angle: Array  # (n,) rad, how far the balls have gone round
    centre: Array  # (n, 3) m
    velocity: Array  # (n, 3) m/s
    axis: Array  # (n, 3) of the cage, of length 1: it tilts
    angular_velocity: Array  # (n, 3) rad/s
    offset: Array  # (n, Z, 3) of each ball's centre from its pocket's, m
    force: Array  # (n, Z, 3) of each ball on the cage, N
    slip_power: Array  # (n,) of friction in the pockets, mean since the instant before, W
    max_force: Array  # (n,) largest normal force of one contact since then, N

    def to_dataset(self) -> Any:
        """An xarray.Dataset with units and meanings as attributes; its to_netcdf writes it."""
        import xarray  # on demand: it takes a second

        described: dict[str, tuple[tuple[str, ...], str, str]] = {
            "ball_angle": (("time",), "rad", "how far the balls have gone round the bearing"),
            "centre": (("time", "direction"), "m", "place of the cage's centre, from the bearing's"),
            "velocity": (("time", "direction"), "m/s", "velocity of the cage's centre"),
            "axis": (("time", "direction"), "1", "axis of the cage, of length 1: it tilts"),
            "angular_velocity": (("time", "direction"), "rad/s", "angular velocity of the cage"),
            "offset": (("time", "ball", "direction"), "m", "place of each ball's centre, from its pocket's"),
            "force": (("time", "ball", "direction"), "N", "force of each ball on the cage, normal force and friction"),
            "slip_power": (("time",), "W", "power of friction in the pockets, mean since the instant before"),
            "max_force": (("time",), "N", "largest normal force of one contact since the instant before"),
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


def recorded_motion(
    cage: DrivenCage,
    *,
    start: CageStart,
    duration: float,
    samples: int,
    ramp: float = 0.0,
    seed: int | None = None,
    steps_per_contact: float = STEPS_PER_CONTACT,
) -> CageSeries:
    """A motion from its beginning, at equal distances in time.

    duration : s, > 0;  samples : n, >= 1;  ramp, seed, steps_per_contact : as `CageMotion`
    Raises MotionError where it comes apart.
    """
    require_positive(duration=duration, samples=samples)
    motion = CageMotion(cage, begin=start, seed=seed, ramp=ramp, steps_per_contact=steps_per_contact)
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
