"""A motion as a time series: its quantities agree with each other and with the file."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import xarray

from analytic.cage.motion import CageMotion
from analytic.cage.series import recorded_motion
from tests.analytic.cage.specimens import CAGE, cage_on, races_under_thrust

SEVEN = replace(CAGE, ball_count=7, orbit_speed=21.0, ball_speed=123.0)


def test_velocities_are_derivatives_of_places() -> None:
    """The cage whirls with a period of 1.3 ms."""
    series = recorded_motion(CageMotion(SEVEN, begin="whirl"), duration=2e-3, samples=400)
    step = np.diff(series.time)
    np.testing.assert_allclose(step.sum() + step[0], 2e-3, rtol=0.05)  # in whole steps of the motion
    moved = np.diff(series.centre, axis=0) / step[:, None]
    mean = (series.velocity[1:] + series.velocity[:-1]) / 2
    np.testing.assert_allclose(moved, mean, atol=0.01 * np.abs(series.velocity).max())  # the trapezoidal rule
    np.testing.assert_allclose(series.ball_angle, 21 * series.time, rtol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(series.axis, axis=1), 1, rtol=1e-12)
    pushed = np.diff(series.velocity, axis=0) * SEVEN.mass / step[:, None] + [0, SEVEN.mass * 9.80665, 0]
    forces = series.force.sum(axis=1)
    np.testing.assert_allclose(pushed.mean(axis=0), forces.mean(axis=0), atol=0.02 * np.abs(forces).max())
    assert series.force.shape == (400, 7, 3)
    assert np.all(series.max_force >= 0)


def test_the_file_has_series_and_units(tmp_path: Path) -> None:
    """Written as netCDF and read again."""
    series = recorded_motion(CageMotion(SEVEN, begin="sudden"), duration=2e-4, samples=5)
    series.to_dataset().to_netcdf(tmp_path / "series.nc", engine="netcdf4")
    read = xarray.load_dataset(tmp_path / "series.nc", engine="netcdf4")
    assert dict(read.sizes) == {"time": 5, "direction": 3, "ball": 7}
    assert read["direction"].values.tolist() == ["x", "y", "z"]
    units = {name: str(read[name].attrs["units"]) for name in read.variables if name != "direction"}
    assert (units["centre"], units["angular_velocity"], units["slip_power"]) == ("m", "rad/s", "W")
    assert all(read[name].attrs["long_name"] for name in read.variables)
    for name, values in vars(series).items():
        np.testing.assert_array_equal(read[name].values, values)
    falling = read["velocity"].sel(direction="y")  # free fall from the middle, before the first contact
    np.testing.assert_allclose(falling, -9.80665 * read["time"], rtol=1e-6)
    assert float(abs(read["velocity"].sel(direction="x")).max()) < 1e-12


def test_free_balls_are_recorded_with_their_own_places() -> None:
    """They orbit at the speed that their races give them, and their offsets are those of the motion at its end."""
    races = races_under_thrust()
    motion = CageMotion(cage_on(races), races, begin="rest")
    series = recorded_motion(motion, duration=1e-3, samples=50)
    speed = races.alone.orbit_speed
    np.testing.assert_allclose(
        series.ball_angle, speed * series.time, rtol=1e-3
    )  # the cage at rest brakes them a little
    np.testing.assert_array_equal(series.offset[-1], motion.offsets)
