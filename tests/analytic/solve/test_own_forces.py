"""What a ball's own forces, and loads that make balls unlike, are beside the load, against the equilibrium itself."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects.trial import unequal_loads
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.numerics.records import Record
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.solve.model import model_of
from analytic.solve.solution import Solution, points_of, solved

SHARES = ("centrifugal_share", "gyroscopic_share", "weight_share")
GRAVITY = 9.80665  # m/s^2
STEEP = ContactAngle(rule="solved", free=0.7)


def scene_of(bearing: Bearing, angle: ContactAngle, **operation: Any) -> Scene:
    arrays = {name: np.atleast_1d(np.asarray(value, dtype=float)) for name, value in operation.items()}
    return Scene(
        name="own forces",
        bearing=bearing,
        contact_angle=angle,
        operation=Operation(**arrays).as_series(),
        friction_coefficient=0.07,
    )


def found_at(scene: Scene, *counted: str) -> Solution:
    return solved(model_of(scene, dict.fromkeys(counted, True)), points_of(scene.operation, 0.0))


def own_forces(bearing: Bearing, angle: Array, speed: float) -> Array:
    """(3, ...) centrifugal force, gyroscopic moment over the radius and weight of balls with an upright axis, N."""
    motion = ball_kinematics(
        inner_speed=speed,
        inner_angle=angle,
        outer_angle=angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    mass, radius = bearing.ball_mass, bearing.ball_radius
    outward = mass * bearing.pitch_diameter / 2 * motion.cage_speed**2
    across = 2 / 5 * mass * radius**2 * np.abs(motion.ball_speed * motion.cage_speed) / radius
    return np.stack(np.broadcast_arrays(outward, across, mass * GRAVITY))


def shares_of(point: Record) -> Array:
    return np.array([point[name] for name in SHARES])


@pytest.mark.parametrize("speed", [700.0, -700.0])
def test_own_forces_are_beside_the_load_of_any_ball_under_thrust(bearing_6205: Bearing, speed: float) -> None:
    scene = scene_of(bearing_6205, ContactAngle(rule="given", value=0.31), axial_load=300.0, inner_speed=speed)
    load = 300.0 / (bearing_6205.ball_count * np.sin(0.31))
    expected = own_forces(bearing_6205, np.array(0.31), speed) / load
    np.testing.assert_allclose(shares_of(found_at(scene).points[0]), expected, rtol=1e-12)  # round-off


def test_own_forces_are_beside_the_load_of_the_lightest_ball(bearing_6205: Bearing) -> None:
    loads = {"axial_load": 900.0, "radial_load": 190.0, "moment": 0.7}
    scene = scene_of(bearing_6205, STEEP, **loads, inner_speed=310.0)
    ring = ring_equilibrium(bearing_6205, STEEP, axial_load=900.0, radial_load_x=190.0, moment_y=0.7)
    each = own_forces(bearing_6205, ring.inner_angle, 310.0) / ring.inner_load
    assert each[2].max() / each[2].min() > 1.5  # else any ball would do
    found = shares_of(found_at(scene, "load_distribution").points[0])
    np.testing.assert_allclose(found, each.max(axis=-1), rtol=1e-8)  # the ring settles to 1e-11 of its forces


def test_a_ball_without_load_has_own_forces_alone(bearing_6205: Bearing) -> None:
    """Four of nine balls hang loose; at rest they weigh, and no more."""
    loads = {"axial_load": [10.0, 10.0], "radial_load": [1.6, 1.6], "inner_speed": [12.6, 0.0]}
    scene = scene_of(bearing_6205, STEEP, **loads)
    scene = replace(scene, operation=replace(scene.operation, tilt="free"))
    found = found_at(scene, "load_distribution")
    assert np.count_nonzero(found.balls["load"][0, :, 0] == 0) == 4
    np.testing.assert_array_equal([shares_of(point) for point in found.points], [[np.inf] * 3, [0.0, 0.0, np.inf]])


@pytest.mark.parametrize("given", [("radial_load",), ("moment",), ("radial_load", "moment")])
def test_unequal_balls_add_up_to_the_radial_load_and_to_the_moment(
    bearing_6205: Bearing, given: tuple[str, ...]
) -> None:
    """Loads Q (1 + e cos psi) summed: a radial load and a moment that bring e each bring 2 e together."""
    angle, uneven = 0.37, 0.23
    psi = np.arange(bearing_6205.ball_count) * 2 * np.pi / bearing_6205.ball_count
    balls = 110.0 * (1 + uneven * np.cos(psi))
    across = balls @ np.cos(psi)
    sideways = {"radial_load": -across * np.cos(angle), "moment": across * np.sin(angle) * 39.01e-3 / 2}
    loads = {"axial_load": balls.sum() * np.sin(angle), "inner_speed": 17.0} | {name: sideways[name] for name in given}
    scene = scene_of(bearing_6205, ContactAngle(rule="given", value=angle), **loads)
    found = found_at(scene)  # of the thrust alone
    np.testing.assert_allclose(unequal_loads(scene, scene.operation, found), len(given) * uneven / 2, rtol=1e-12)


def test_nothing_bounds_how_unequal_balls_are_without_thrust(bearing_6205: Bearing) -> None:
    scene = scene_of(bearing_6205, STEEP, axial_load=[30.0, 30.0], radial_load=[0.0, 3.0], inner_speed=[17.0, 17.0])
    alone = replace(scene.operation, axial_load=np.zeros(2))
    np.testing.assert_array_equal(unequal_loads(scene, alone, found_at(scene)), [0.0, np.inf])
