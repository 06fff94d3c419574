"""A motion as a series in time: what it holds agrees with itself, and with the dataset that is made of it."""

import sys
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.cage import DrivenCage
from analytic.cage_series import recorded_motion
from analytic.errors import InputError

CAGE = DrivenCage(
    mass=6.58e-3,
    ball_count=7,
    ball_radius=3.97e-3,
    pitch_radius=19.505e-3,
    room=0.1e-3,
    stiffness=6.0e10,
    restitution=0.8,
    friction_coefficient=0.1,
    orbit_speed=21.0,
    ball_speed=123.0,
    contact_angle=0.18,
    ring_speed=52.36,
)


def test_velocities_are_how_places_change() -> None:
    """Between impacts; the cage whirls with a period of 1.3 ms."""
    found = recorded_motion(CAGE, start="whirl", duration=2e-3, samples=400)
    step = np.diff(found.time)
    np.testing.assert_allclose(step.sum() + step[0], 2e-3, rtol=0.05)  # whole steps of the motion
    moved = np.diff(found.centre, axis=0) / step[:, None]
    mean = (found.velocity[1:] + found.velocity[:-1]) / 2
    np.testing.assert_allclose(moved, mean, atol=0.01 * np.abs(found.velocity).max())  # the trapezoidal rule
    np.testing.assert_allclose(found.ball_angle, 21 * found.time, rtol=1e-9)
    np.testing.assert_allclose(np.linalg.norm(found.axis, axis=1), 1, rtol=1e-12)
    pushed = np.diff(found.velocity, axis=0) * CAGE.mass / step[:, None] + [0, CAGE.mass * 9.80665, 0]
    forces = found.force.sum(axis=1)
    np.testing.assert_allclose(pushed.mean(axis=0), forces.mean(axis=0), atol=0.02 * np.abs(forces).max())
    assert found.force.shape == (400, 7, 3)
    assert np.all(found.max_force >= 0)


def test_a_dataset_has_units(monkeypatch: pytest.MonkeyPatch) -> None:
    """Against a stand-in that keeps what it is given."""

    class Dataset:
        def __init__(self, variables: dict[str, Any], coords: dict[str, Any]) -> None:
            self.variables, self.coords = variables, coords

    stand_in = ModuleType("xarray")
    stand_in.Dataset = Dataset  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "xarray", stand_in)
    found = recorded_motion(CAGE, start="rest", duration=1e-4, samples=3)
    dataset = found.to_dataset()
    sizes = {"time": 3, "direction": 3, "ball": 7}
    for name, (dimensions, values, attributes) in dataset.variables.items():
        assert values.shape == tuple(sizes[dimension] for dimension in dimensions), name
        assert attributes["units"]
    assert set(dataset.variables) | {"time"} == set(vars(found))
    assert dataset.coords["time"][2] == {"units": "s"}


def test_without_xarray_the_dataset_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xarray", None)
    found = recorded_motion(CAGE, start="rest", duration=1e-4, samples=3)
    with pytest.raises(InputError, match=r"needs xarray, which is not installed: pip install 'fembearing\[series\]'"):
        found.to_dataset()


def test_a_series_needs_a_length() -> None:
    with pytest.raises(InputError, match="duration must be positive"):
        recorded_motion(CAGE, start="rest", duration=-1.0, samples=3)
