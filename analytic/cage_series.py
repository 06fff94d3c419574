"""A cage's motion as a series in time, for plots and for files."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.cage import DrivenCage
from analytic.cage_motion import CageMotion
from analytic.errors import InputError, require_positive
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
    force: Array  # (n, Z, 3) of each ball on the cage, N
    slip_power: Array  # (n,) of friction in the pockets, mean since the instant before, W
    max_force: Array  # (n,) largest normal force of one contact since then, N

    def to_dataset(self) -> Any:
        """An xarray.Dataset with the units as attributes; its to_netcdf writes it.

        Raises InputError where xarray is not installed.
        """
        try:
            import xarray  # pyright: ignore[reportMissingImports]
        except ImportError as problem:
            raise InputError(
                "a dataset of the cage's motion needs xarray, which is not installed: pip install 'fembearing[series]'"
            ) from problem
        described: dict[str, tuple[tuple[str, ...], str]] = {
            "ball_angle": (("time",), "rad"),
            "centre": (("time", "direction"), "m"),
            "velocity": (("time", "direction"), "m/s"),
            "axis": (("time", "direction"), "1"),
            "angular_velocity": (("time", "direction"), "rad/s"),
            "force": (("time", "ball", "direction"), "N"),
            "slip_power": (("time",), "W"),
            "max_force": (("time",), "N"),
        }
        return xarray.Dataset(
            {
                name: (dimensions, getattr(self, name), {"units": unit})
                for name, (dimensions, unit) in described.items()
            },
            coords={
                "time": (("time",), self.time, {"units": "s"}),
                "direction": list(AXES),
                "ball": np.arange(self.force.shape[1]),
            },
        )


def recorded_motion(
    cage: DrivenCage, *, start: CageStart, duration: float, samples: int, ramp: float = 0.0, seed: int | None = None
) -> CageSeries:
    """A motion from its beginning, at equal distances in time.

    duration : s, > 0;  samples : n, >= 1;  ramp, seed : as `CageMotion`
    Raises MotionError where it comes apart.
    """
    require_positive(duration=duration, samples=samples)
    motion = CageMotion(cage, begin=start, seed=seed, ramp=ramp)
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
                motion.forces(),
                passed.slip_power,
                passed.max_force,
            )
        )
    names = ("time", "ball_angle", "centre", "velocity", "axis", "angular_velocity", "force", "slip_power", "max_force")
    return CageSeries(**{name: np.array(column) for name, column in zip(names, zip(*rows, strict=True), strict=True)})
