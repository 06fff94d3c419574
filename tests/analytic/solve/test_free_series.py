"""Series of points with free balls: a torque depends neither on the others nor on where balls began."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.solve.model import Model, model_of, workspace
from analytic.solve.records import BEYOND_SHOULDER, NO_STEADY_ROTATION, OPEN_ANGLE, SETTLED
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from tests.analytic.free_ball.specimens import COUNTED, angular_contact, dry_scene

LEVEL = 1  # of the nodes at all points that are compared


def scene_of(bearing: Bearing, **operation: Any) -> Scene:
    """A dry scene with creep; what counts is not left to the points."""
    return Scene(
        tolerance=0.01,
        bearing=bearing,
        contact_angle=ContactAngle(rule="solved", free=0.31),
        operation=Operation(**operation),
        friction_coefficient=0.07,
        effects={
            **dict.fromkeys(("finite_geometry", "weight"), "off"),
            **dict.fromkeys(("centrifugal", "gyroscopic", "creep"), "on"),
        },
    )


def drawn(count: int, *, radial: bool) -> dict[str, Array]:
    """Loads, N, and speeds, rad/s, over two decades."""
    random = np.random.default_rng(17)
    operation = {"axial_load": 10 ** random.uniform(1.5, 3.2, count), "inner_speed": 10 ** random.uniform(1, 3, count)}
    return operation | ({"radial_load": 10 ** random.uniform(2, 3, count)} if radial else {})


def warm_model(scene: Scene) -> Model:
    return model_of(scene, COUNTED | {"creep": True}, free=True).with_numbers(level=LEVEL, allowed=np.inf, cold=False)


@pytest.mark.parametrize(("count", "radial"), [(20, False), (8, True)])
def test_a_series_in_reverse_order_has_the_same_torques(bearing_6205: Bearing, count: int, radial: bool) -> None:
    """Same nodes, other starts: passes end where they change the torque by 3e-7, and rounds at forces of 1e-6."""
    scene = scene_of(bearing_6205, **drawn(count, radial=radial))
    points = points_of(scene.operation, 0.0)
    forth, back = (
        solved(warm_model(scene), part, work=workspace(warm_model(scene))).points for part in (points, points[::-1])
    )
    assert np.any(forth["total"] != back["total"][::-1])  # else one start serves both
    np.testing.assert_allclose(back["total"][::-1], forth["total"], rtol=2e-6)


@pytest.mark.parametrize("radial", [False, True])
def test_a_far_start_gives_the_torque_of_a_cold_one(bearing_6205: Bearing, radial: bool) -> None:
    """From a light fast point to a heavy slow one and back; passes end where the torque changes by 3e-7."""
    operation = {"axial_load": np.array([31.0, 1700.0, 31.0]), "inner_speed": np.array([980.0, 13.0, 980.0])}
    if radial:
        operation["radial_load"] = np.array([120.0, 890.0, 120.0])
    scene = scene_of(bearing_6205, **operation)
    model, points = warm_model(scene), points_of(scene.operation, 0.0)
    warm = solved(model, points, work=workspace(model)).points
    cold = solved(model.with_numbers(cold=True), points).points
    assert np.all(warm["total"][1:] != cold["total"][1:])  # else the start has been thrown away
    np.testing.assert_array_equal(warm["level"], cold["level"])
    np.testing.assert_allclose(warm["total"], cold["total"], rtol=1e-6)


def test_a_point_that_does_not_settle_costs_no_other(bearing_6205: Bearing) -> None:
    """The contact angle of one point and the rotation of another do not settle."""
    load = np.array([410.0, 2.0, 300.0, 410.0, 520.0])
    speed = np.array([83.0, 8e3, 90.0, 1e5, 71.0])
    scene = scene_of(bearing_6205, axial_load=load, inner_speed=speed)
    points, good = points_of(scene.operation, 0.0), np.array([0, 2, 4])
    found, settled = (solved(warm_model(scene), part).points for part in (points, points[good]))
    np.testing.assert_array_equal(found["status"], [SETTLED, OPEN_ANGLE, SETTLED, NO_STEADY_ROTATION, SETTLED])
    np.testing.assert_array_equal(np.isnan(found["total"]), found["status"] != SETTLED)
    np.testing.assert_allclose(found["total"][good], settled["total"], rtol=1e-6)  # of other starts


def test_free_balls_beyond_a_shoulder_have_no_torque() -> None:
    """By rule the contact is on the groove, at 1.1377 rad, and the free ball's own friction moves it to 1.1398 rad."""
    bearing = angular_contact()
    edge = bearing.inner.groove_radius * np.sin(1.139)
    bearing = replace(bearing, inner=replace(bearing.inner, shoulder_half_width=edge))
    scene = dry_scene(bearing, None, 0.05, load=np.array([500.0]), speed=np.array([1500.0]))
    found = solved(warm_model(scene), points_of(scene.operation, 0.0)).points[0]
    assert found["status"] == BEYOND_SHOULDER
    assert np.isnan(found["total"])
    with pytest.raises(InputError, match=r"moves to 65\.\d+ deg .* beyond the inner race's shoulder"):
        friction_torque(scene)
