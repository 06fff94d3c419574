"""The torque of free balls: limits, directions, hard corners, oil, and weight."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Bearing, ContactAngle, Decision, Operation, Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import balls_of, present


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        tolerance=0.01,
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.31),
        operation=Operation(axial_load=np.array([410.0]), inner_speed=np.array([83.0])),
        friction_coefficient=0.07,
        effects={"finite_geometry": "off"},
    )


def at(scene: Scene, **changed: float) -> Scene:
    values = {"axial_load": 410.0, "inner_speed": 83.0} | changed
    points: dict[str, Any] = {name: np.array([value]) for name, value in values.items()}
    return replace(scene, operation=Operation(**points))


@pytest.mark.parametrize("creep", ["off", "on"])
def test_the_coefficient_of_plain_friction_is_the_given_one(scene: Scene, creep: Decision) -> None:
    """Power lost over the power at a coefficient of 1; creep spares slip and no power of the stress that acts."""
    found = friction_torque(replace(scene, effects={**scene.effects, "creep": creep})).friction_coefficient
    for race in (found.inner, found.outer):
        np.testing.assert_allclose(present(race), 0.07, rtol=0.02)  # of a stress that is round near the slip of 0


def test_the_outer_ring_carries_load_and_weight(scene: Scene) -> None:
    """Newton's third law for the inner ring and the balls together, along x, y and z."""
    operation = Operation(
        axial_load=np.array([3.0]), inner_speed=np.array([0.0]), radial_load=np.array([0.7])
    ).as_series()
    down = (0.48, -0.6, 0.64)
    asked = replace(scene, contact_angle=ContactAngle(rule="solved", free=0.5), operation=operation, down=down)
    balls = balls_of(asked, weight="on", centrifugal="off", gyroscopic="off")[0]
    load, angle = balls["load"][:, 1], balls["angle"][:, 1]
    azimuth = 2 * np.pi * np.arange(9) / 9
    weight = 2.04e-3 * 9.80665 * np.array(down)
    # The cage carries the weight along the orbit: what is radial and axial adds up over nine balls.
    radial = weight[0] * np.cos(azimuth) + weight[1] * np.sin(azimuth)
    expected = [0.7 + np.sum(radial * np.cos(azimuth)), np.sum(radial * np.sin(azimuth)), 3.0 + 9 * weight[2]]
    found = [
        np.sum(load * np.cos(angle) * np.cos(azimuth)),
        np.sum(load * np.cos(angle) * np.sin(azimuth)),
        np.sum(load * np.sin(angle)),
    ]
    np.testing.assert_allclose(found, expected, atol=1e-9)  # of 3 N


def test_a_free_angle_that_does_not_fit_moves_both_grooves_alike(scene: Scene) -> None:
    """The bearing with these grooves has the same torque."""
    free, bearing = 0.47, scene.bearing
    unfit = replace(scene, contact_angle=ContactAngle(rule="solved", free=free))
    clearance = 4 * bearing.groove_centre_distance * np.sin(free / 2) ** 2
    apart = (clearance - bearing.diametral_clearance) / 4
    assert apart > 1e-5  # m: 5e-4 of the pitch radius
    inner = replace(bearing.inner, bottom_radius=bearing.inner.bottom_radius - apart)
    outer = replace(bearing.outer, bottom_radius=bearing.outer.bottom_radius + apart)
    fit = replace(unfit, bearing=replace(bearing, inner=inner, outer=outer), contact_angle=ContactAngle(rule="solved"))
    given, moved = (friction_torque(each).torque.total for each in (unfit, fit))
    np.testing.assert_allclose(given, moved, rtol=1e-8)  # residuals of 1e-10


def test_creep_is_refused_with_a_rule(scene: Scene) -> None:
    with pytest.raises(InputError, match=r'effects\.creep = "on" is refused: friction\.spin_rule = "inner_control"'):
        friction_torque(replace(scene, spin_rule="inner_control", effects={"creep": "on"}))


RUNAWAY = """
name = "light and slow"
tolerance = 0.03
[bearing]
name = "hybrid"
ball_count = 9
ball_diameter = "14.5742599 mm"
ball_mass = "5.1869031 g"
ball_material = "silicon_nitride"
bore_diameter = "36.6338128 mm"
outside_diameter = "94.9447589 mm"
contact_angle = { rule = "solved", free = "0.371642219 rad" }
[bearing.inner]
bottom_radius = "25.6040364 mm"
groove_radius = "7.77195019 mm"
shoulder_half_width = "6.1229778 mm"
material = "steel"
[bearing.outer]
bottom_radius = "40.1852495 mm"
groove_radius = "7.72029054 mm"
shoulder_half_width = "6.1229778 mm"
material = "steel"
[operation]
axial_load = "0.288781307 N"
radial_load = "0.00918955702 N"
moment = "0.285573304 N mm"
inner_speed = "0.0283056796 rad/s"
[lubricant]
viscosity = "0.0381157807 Pa s"
pressure_viscosity = "1.01685486e-08 1/Pa"
eyring_stress = "511008.0890912163 Pa"
supply = "oil_bath"
starvation_degree = 1.00334294
[friction]
hysteresis_loss = 0.0153003
spin_rule = "free"
coefficient = 0.0325691
"""


def test_no_ball_turns_faster_than_the_ring_can_drive_it() -> None:
    """The speed of a ball ran away once, to a torque of 3e212 N m: a step below its round-off passed for the end.

    Friction slips no faster than a few times the ring's surface moves: mu Q times that and no more is lost.
    """
    found = friction_torque(parse_scene(RUNAWAY, origin="here"))
    loads = 2 * 9 * max(found.inner.load[0], found.outer.load[0])  # of the heaviest ball, on both races
    most = 3 * 0.0325691 * loads * 40.2e-3
    assert 0 < found.torque.total[0] < most
