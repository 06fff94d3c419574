"""Ring and balls as a result, against the equilibrium's own displacement and tangent, and against small changes."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import analytic
from analytic.brief import span
from analytic.loads.ring import ring_equilibrium
from analytic.loads.ring_state import RingState
from analytic.result import FrictionTorque
from analytic.scene import Operation, Scene
from tests.analytic.specimens import present

PLAIN = {"cage": "off", "cage_dynamics": "off", "finite_geometry": "off", "creep": "off", "weight": "off"}
AT_SPEED = {"load_distribution": "on", "centrifugal": "on", "gyroscopic": "on"}


def torque(scene: Scene, *, effects: dict | None = None, **operation) -> FrictionTorque:
    points: dict[str, Any] = {name: np.asarray(value, dtype=float) for name, value in operation.items()}
    scene = replace(scene, operation=Operation(**points), effects={**scene.effects, **PLAIN, **(effects or {})})
    return analytic.friction_torque(scene)


def state(scene: Scene, **operation) -> RingState:
    return present(torque(scene, effects=AT_SPEED, **operation).ring)


@pytest.fixture(scope="module")
def scene() -> Scene:
    # Balls by closed kinematics, as in the equilibrium alone; the state of free balls comes from theirs.
    return replace(analytic.load_scene("paper_6205"), spin_rule="balanced")


LOADS = {"axial_load": [1000.0, 60.0], "radial_load": [800.0, 900.0], "moment": [3.0, -2.0], "inner_speed": [11.0, 2e3]}


def test_displacement_and_stiffness_are_those_that_the_equilibrium_solved_for(scene):
    ring = state(scene, **LOADS)
    solved = ring_equilibrium(
        scene.bearing,
        scene.contact_angle,
        axial_load=LOADS["axial_load"],
        radial_load_x=LOADS["radial_load"],
        moment_y=LOADS["moment"],
        inner_speed=LOADS["inner_speed"],
    )
    assert np.any(solved.balls["angle"][..., 0] < 0)
    assert np.any(solved.balls["load"][..., 0] == 0)
    # The rounds of the equilibrium end at 1e-12 of the load, and the place is rebuilt from angles and approaches.
    np.testing.assert_allclose(present(ring.displacement), solved.displacement, rtol=1e-8, atol=1e-15)
    scale = np.abs(solved.stiffness).max(axis=(1, 2), keepdims=True)
    np.testing.assert_allclose(ring.stiffness / scale, solved.stiffness / scale, rtol=0, atol=1e-9)


def test_a_small_load_moves_the_ring_by_the_inverse_of_the_stiffness(scene):
    loads = {"axial_load": [700.0], "radial_load": [240.0], "moment": [2.0], "inner_speed": [3.0]}
    steps = {"axial_load": (0, 0.07), "radial_load": (1, 0.07), "moment": (4, 0.0007)}
    compliance = np.linalg.inv(state(scene, **loads).stiffness[0])
    for name, (freedom, step) in steps.items():
        ends = [
            present(state(scene, **{**loads, name: [loads[name][0] + sign * step]}).displacement)[0] for sign in (-1, 1)
        ]
        moved = (ends[1] - ends[0]) / (2 * step)
        # K follows the contact angle, which the stiffness holds: 0.5 % of the largest entry; the balls' loads alike.
        scale = np.sqrt(np.diag(compliance) * compliance[freedom, freedom])
        np.testing.assert_allclose(moved / scale, compliance[:, freedom] / scale, rtol=0, atol=5e-3)


def test_thrust_alone_moves_the_ring_along_its_axis_and_is_the_limit_of_a_small_radial_load(scene):
    thrust = torque(scene, axial_load=[430.0, 900.0], inner_speed=[7.0, 20.0])
    nearly = state(scene, axial_load=[430.0, 900.0], radial_load=[1e-3, 1e-3], inner_speed=[7.0, 20.0])
    ring = present(thrust.ring)
    assert ring.load.shape == (2, 2, scene.bearing.ball_count)
    np.testing.assert_allclose(present(ring.displacement)[:, 0], present(nearly.displacement)[:, 0], rtol=1e-5)
    np.testing.assert_allclose(present(ring.displacement)[:, 1:], 0, atol=1e-15)
    scale = np.abs(nearly.stiffness).max()
    np.testing.assert_allclose(ring.stiffness / scale, nearly.stiffness / scale, rtol=0, atol=1e-5)


def test_a_given_angle_has_no_displacement_and_a_thrust_bearing_begins_where_it_touches(scene):
    angle = replace(scene.contact_angle, rule="given", value=0.31, free=None)
    given = torque(replace(scene, contact_angle=angle), axial_load=[800.0], inner_speed=[9.0])
    assert present(given.ring).displacement is None
    assert present(given.ring).rows[0]["displacement"] is None
    washers = analytic.load_scene("validation/scenes/thrust_rig_3mm.toml")
    ring = present(torque(washers, axial_load=[9.0], inner_speed=[5.0]).ring)
    np.testing.assert_allclose(present(ring.displacement)[0, 0], ring.approach[0, :, 0].sum(), rtol=1e-9)
    # A thrust bearing is a spring of its balls in parallel, each with two contacts in a row.
    each = 1 / np.sum(ring.approach[0, :, 0] / (1.5 * ring.load[0, :, 0]))
    np.testing.assert_allclose(ring.stiffness[0, 0, 0], washers.bearing.ball_count * each, rtol=1e-9)


def test_the_dataset_names_race_ball_and_freedom(scene):
    ring = state(scene, **LOADS)
    found, rows = ring.to_dataset(), ring.rows
    for point, content in enumerate(rows):
        at = found.isel(point=point)
        for race in ("inner", "outer"):
            assert at["load"].sel(race=race).values.tolist() == content["balls"][f"{race}_load"]
        for freedom, value in content["displacement"].items():
            assert float(at[f"displacement_{freedom}"]) == value
        assert float(at["stiffness"].sel(force="axial", freedom="tilt_y")) == content["stiffness"][0][4]
    assert repr(ring) == f"RingState(6205, 2 points, 9 balls, heaviest {span(ring.load.max(axis=(1, 2)))} N)"
    assert ring.at(np.array([1])).rows[0] == ring.rows[1]
