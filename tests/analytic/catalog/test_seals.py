"""The drag of seals: SKF's formula by hand in printed units, and which constants a suffix takes."""

import math
from typing import Any

import pytest

from analytic.catalog.bearing_rows import find_bearing
from analytic.catalog.seals import seal_torque
from analytic.scene import Scene
from analytic.scenefile.read import scene_of
from analytic.torque import friction_torque
from tests.refusals import refused

ROUND_OFF = 1e-12


@pytest.mark.parametrize(
    ("designation", "diameter", "expected"),
    [  # mm, N mm: both seals of a bearing
        ("6205-2RS1", 31.3, 0.023 * 31.3**2.25 + 2),
        ("6205-RS1", 31.3, (0.023 * 31.3**2.25 + 2) / 2),
        ("6205-2RSH", 31.3, 0.028 * 31.3**2.25 + 2),
        ("6205-2RSL", 31.3, 0.0018 * 31.3**2.25),
        ("NSK 6205 DDU", 31.3, 0.023 * 31.3**2.25 + 2),
        ("6206-2RS1", 36.9, 0.023 * 36.9**2.25 + 2),  # 62 mm belongs to the smaller row
        ("6208-2RS1", 52.6, 0.018 * 52.6**2.25 + 20),
        ("6210-2RS1", 62.5, 0.018 * 62.5**2.25 + 15),
        ("6212-2RS1", 75.5, 0.018 * 75.5**2.25),
        ("7208 BEP-2RS1", 56.1, 0.014 * 56.1**2 + 10),
        ("6205-2Z", 31.3, 0.0),
        ("6205-2RZ", 31.3, 0.0),
    ],
)
def test_the_formula_by_hand(designation: str, diameter: float, expected: float) -> None:
    found = 1e3 * seal_torque(find_bearing(designation), counterface=diameter * 1e-3)
    assert math.isclose(found, expected, rel_tol=ROUND_OFF, abs_tol=0)


@pytest.mark.parametrize(
    ("designation", "words"),
    [("6205", "no seals"), ("6210-2RSH", "0 to 52 mm"), ("6310-2RSL", "25 to 52 mm"), ("7208 BEP-2RSH", "angular")],
)
def test_an_estimate_without_constants_is_refused(designation: str, words: str) -> None:
    refused(lambda: seal_torque(find_bearing(designation), counterface=40e-3), words)


def sealed(designation: str, **more: Any) -> Scene:
    document = {
        "name": "sealed",
        "tolerance": "5 %",
        "bearing": {"catalog": designation},
        "operation": {"axial_load": "130 N", "inner_speed": "300 rpm"},
        "friction": {"coefficient": 0.07},
    }
    return scene_of(document | more, origin="test")


def said_of_seals(scene: Scene) -> list[str]:
    return [warning for warning in friction_torque(scene).warnings if "seals" in warning]


def test_seals_whose_drag_is_not_declared_are_warned_of() -> None:
    words = "the total is without the drag of the seals (2RS1: rubber seal that rubs, on both sides): give losses.seals"
    (warning,) = said_of_seals(sealed("6205-2RS1"))
    assert warning.startswith(words)
    assert not said_of_seals(sealed("6205-2RS1", losses={"seals": "3 N mm"}))
    assert not said_of_seals(sealed("6205"))


def test_shields_have_no_drag() -> None:
    scene = sealed("6205-2Z")
    assert not said_of_seals(scene)
    (effect,) = (each for each in friction_torque(scene).effects if each.name == "seals")
    assert effect.reason == "no drag: 2Z: sheet-metal shield that does not touch, on both sides"


def test_an_estimate_takes_the_inner_shoulder() -> None:
    """A shoulder diameter of 34 mm, given: 0.023 34^2.25 + 2 N mm."""
    bearing = {"catalog": "6205-2RS1", "inner": {"shoulder_diameter": "34 mm"}}
    scene = sealed("6205", bearing=bearing, losses={"seals": "estimate"})
    expected = 1e-3 * (0.023 * 34**2.25 + 2)
    assert scene.losses.seals is not None
    assert math.isclose(scene.losses.seals, expected, rel_tol=1e-10)  # the shoulder passes through its half-width
    assert "SKF's formula for RS1 seals on the inner shoulder of 34 mm" in said_of_seals(scene)[0]
    found, without = friction_torque(scene).torque, friction_torque(sealed("6205", bearing=bearing)).torque
    assert math.isclose(found.total[0] - without.total[0], expected, rel_tol=1e-9)  # a small difference


def test_an_impossible_estimate_is_refused_in_one_line() -> None:
    for catalog in ("6205", "paper_6205"):
        given = {"losses": {"seals": "estimate"}, "bearing": {"catalog": catalog}}
        refused(lambda: sealed("6205-2RS1", **given), "losses.seals = 'estimate'")  # noqa: B023
    refused(lambda: sealed("6205-2RS1", losses={"seals": "guess"}), "estimate")
