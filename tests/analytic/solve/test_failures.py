"""A point without a torque ends in one line that names its numbers and says what to change."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import FembearingError, InputError
from analytic.function import torque_function
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.solve import failures, records
from analytic.torque import friction_torque
from tests.analytic.specimens import thrust
from tests.analytic.test_thrust_bearing import scene_of

SOLVED, GIVEN = ContactAngle(rule="solved", free=0.26), ContactAngle(rule="given", value=0.31)
GOOD = {"axial_load": 830.0, "radial_load": 0.0, "moment": 0.0, "inner_speed": 47.0}


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        name="failing",
        tolerance=0.03,
        bearing=bearing_6205,
        contact_angle=SOLVED,
        operation=thrust(830.0),
        friction_coefficient=0.07,
        spin_rule="balanced",
    )


def under(scene: Scene, *points: dict[str, float]) -> Scene:
    loads = {name: np.array([point.get(name, good) for point in points]) for name, good in GOOD.items()}
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


def beyond_outer_shoulder(
    bearing: Bearing,
    lean: tuple[float, float],
    *,
    load: float = 0.7,
    weight: float = 0.0,
    speed: float = 100.0,
    **loads: float,
) -> str:
    """What is said of the second ball of two, whose outer contact has left its race."""
    balls = np.zeros(2, records.BALL)
    balls["shoulder_distance"] = [[2e-4, 1e-5], [1e-4, -1e-5]]
    balls["load"] = [[400.0, 410.0], [load, 0.9 * load]]
    balls["angle"], balls["motion"]["cage_speed"] = [(0.2, -0.4), lean], [0.1, 0.4]
    point = {"axial_load": 830.0, "radial_load": 0.0, "moment": 0.0, "inner_speed": speed} | loads
    return str(failures._beyond_shoulder(bearing, point, balls, weight))


def test_a_contact_beyond_a_shoulder_is_told_by_what_moved_it(bearing_6205: Bearing) -> None:
    """The outer shoulder ends the groove at 47.4 deg: loads move both contacts there, inertia one of them."""
    edge = float(np.arcsin(3.1 / 4.21))
    loaded = beyond_outer_shoulder(bearing_6205, (edge + 0.01, edge + 0.03))
    assert f"moves to {np.degrees(edge + 0.03):.4g} deg" in loaded
    assert "beyond the outer race's shoulder: lower the load, reduce" in loaded
    by_speed = beyond_outer_shoulder(bearing_6205, (edge - 0.06, -edge - 0.04))
    assert "lower the speed of 954.93 rpm, whose centrifugal force moves it there, reduce" in by_speed


@pytest.mark.parametrize(("near", "is_weight"), [(0.999, False), (1.001, True)])
def test_a_contact_that_a_weight_moves_is_told_by_it(bearing_6205: Bearing, near: float, is_weight: bool) -> None:
    """Where the weight of a ball exceeds its centrifugal force m d_m/2 (0.4 w)^2."""
    outward = bearing_6205.ball_mass * bearing_6205.pitch_diameter / 2 * 40.0**2
    words = beyond_outer_shoulder(bearing_6205, (0.3, 0.9), weight=near * outward)
    assert (f"the weight of a ball, {near * outward:.3g} N, moves its contact to 51.57 deg" in words) == is_weight
    assert ("centrifugal force" in words) != is_weight
    unlike = beyond_outer_shoulder(bearing_6205, (0.85, 0.9), weight=2 * outward)
    assert "lower the load" in unlike


@pytest.mark.parametrize("unequal", [{"radial_load": 2700.0}, {"moment": 3.0}])
def test_a_contact_is_told_by_unequal_loads_where_its_ball_has_less_than_its_share_of_the_thrust(
    bearing_6205: Bearing, unequal: dict[str, float]
) -> None:
    """The share of each of 9 balls in 830 N is 92.2 N; centrifugal force exceeds it at 4000 rad/s."""
    lean = (0.3, 0.9)
    words = beyond_outer_shoulder(bearing_6205, lean, weight=0.2, **unequal)
    assert "unequal loads leave 0.7 N for a ball, whose contact moves to 51.57 deg" in words
    assert words.endswith("beyond the outer race's shoulder: raise operation.axial_load")
    for other in ({"speed": 4000.0}, {"load": 93.0}, {"weight": 93.0}, {"axial_load": 6.0}):
        assert "unequal" not in beyond_outer_shoulder(bearing_6205, lean, **(unequal | other))


def test_more_thrust_settles_a_contact_that_unequal_loads_move() -> None:
    with pytest.raises(InputError, match=r"beyond the outer race's shoulder: raise operation\.axial_load"):
        friction_torque("7206B", axial_load=300.0, radial_load=1000.0)
    assert friction_torque("7206B", axial_load=800.0, radial_load=1000.0).torque.total > 0


def test_loads_that_are_0_are_not_told(bearing_6205: Bearing) -> None:
    words = beyond_outer_shoulder(bearing_6205, (0.3, 0.9), radial_load=-70.0)
    assert words.startswith("operation.axial_load = 830 N, operation.radial_load = -70 N: ")
    assert beyond_outer_shoulder(bearing_6205, (0.3, 0.9)).startswith("operation.axial_load = 830 N: ")


def test_what_is_said_of_unequal_loads_has_their_size_or_their_thrust() -> None:
    for unequal, lacks, words in (
        (0.123, "no angle", "are up to 12.3 % of the thrust, and no angle"),
        (np.inf, "no angle", "act without thrust, and no angle"),
        (0.123, None, "of the thrust, and are the whole load"),
    ):
        assert words in str(failures.undistributed(unequal, lacks))
