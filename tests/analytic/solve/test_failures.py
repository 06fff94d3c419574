"""A point without a torque ends in one line that names its numbers and says what to change."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import FembearingError, InputError
from analytic.function import torque_function
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.torque import friction_torque
from tests.analytic.specimens import thrust
from tests.analytic.test_thrust_bearing import scene_of

SOLVED, GIVEN = ContactAngle(rule="solved", free=0.26), ContactAngle(rule="given", value=0.31)
GOOD = {"axial_load": 830.0, "radial_load": 0.0, "moment": 0.0, "inner_speed": 47.0}


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        tolerance=0.03,
        bearing=bearing_6205,
        contact_angle=SOLVED,
        operation=thrust(830.0),
        friction_coefficient=0.07,
        spin_rule="balanced",
    )


def under(scene: Scene, *points: dict[str, float]) -> Scene:
    loads: dict[str, Any] = {name: np.array([point.get(name, good) for point in points]) for name, good in GOOD.items()}
    return replace(scene, operation=Operation(**loads))


CASES: list[tuple[dict[str, Any], dict[str, float], str]] = [
    ({}, {"axial_load": 0.0, "inner_speed": 0.0}, r"operation\.axial_load = 0 N: without thrust .*; give a load"),
    ({}, {"axial_load": 0.0}, r"operation\.axial_load = 0 N: without thrust nothing presses the balls; give a load"),
    ({"effects": {"load_distribution": "off"}}, {"axial_load": 0.0, "radial_load": 70.0},
        "act without thrust, and are the whole load: set effects.load_distribution to auto"),
    ({"contact_angle": GIVEN}, {"radial_load": 660.0}, r"25\.5 % of .* use \"solved\""),  # 660 tan(0.31)/830
    ({"contact_angle": GIVEN}, {"axial_load": 0.0, "radial_load": 70.0}, 'use "solved"'),
    ({}, {"axial_load": 2e-3, "inner_speed": 2300.0},
        r"inner_speed = 21963 rpm: the centrifugal force of a ball is .* under 0\.002 N of thrust, above 1000"),
    ({}, {"axial_load": 7.7e6}, r"axial_load = 7\.7e\+06 N: the contact moves to .* shoulder: lower the load"),
    ({}, {"moment": 1900.0}, r"axial_load = 830 N, operation\.moment = 1\.9e\+06 N mm: .* shoulder: lower the load"),
]  # fmt: skip


def told(scene: Scene, number: int) -> str:
    """What is said of this point, which alone has no torque; loads that no method takes are refused at once."""
    try:
        found = friction_torque(scene)
    except InputError as refused:
        return str(refused)
    assert list(found.failures) == [number]
    np.testing.assert_array_equal(np.isnan(found.torque.total), np.arange(found.axial_load.size) == number)
    return str(found.failures[number])


@pytest.mark.parametrize(("changed", "bad", "words"), CASES)
def test_a_point_without_a_torque_is_told_in_one_line(
    scene: Scene, changed: dict[str, Any], bad: dict[str, float], words: str
) -> None:
    """In a series of few points and of many, and in a call of the function."""
    asked, slight = replace(scene, **changed), {"radial_load": 1e-3}  # a series of thrust alone asks for thrust
    for count in (3, 30):
        others = [{"axial_load": 620.0 + 17 * i, "inner_speed": 47.0 + 0.7 * i, **slight} for i in range(count)]
        others[count // 2] = bad
        message = told(under(asked, *others), count // 2)
        assert re.search(words, message), message
        assert "\n" not in message
    if not changed:
        with pytest.raises(FembearingError):
            torque_function(under(asked, GOOD))(**{**GOOD, **bad})


def test_a_thrust_bearing_names_its_speed() -> None:
    loads = thrust(900.0, 5.0, 700.0, speed=[30.0, 300.0, 41.0])
    message = told(scene_of(loads, friction_coefficient=0.1), 1)
    assert re.search(r"= 2864\.\d+ rpm: .* under 5 N of thrust, above 0\.1, and moves it out", message), message


def test_more_thrust_settles_a_contact_that_unequal_loads_move() -> None:
    with pytest.raises(InputError, match=r"beyond the outer race's shoulder: raise operation\.axial_load"):
        friction_torque("7206B", axial_load=300.0, radial_load=1000.0)
    assert friction_torque("7206B", axial_load=800.0, radial_load=1000.0).torque.total > 0
