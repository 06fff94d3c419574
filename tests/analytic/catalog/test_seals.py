"""The drag of seals: SKF's formula by hand in printed units, and which constants a suffix takes."""

import math
from typing import Any

import pytest

from analytic.catalog.bearing_rows import find_bearing
from analytic.catalog.seals import seal_spread, seal_torque
from analytic.effects import Effect
from analytic.prediction.spreads import uncertain_inputs
from analytic.scene import Scene
from analytic.scenefile.inputs import stated_inputs
from analytic.scenefile.read import scene_of
from analytic.torque import friction_torque
from tests.refusals import refused

ROUND_OFF = 1e-12


@pytest.mark.parametrize(
    ("designation", "diameter", "expected"),
    [  # mm, N mm: both seals of a bearing
        ("6205-2RS1", 31.3, 0.023 * 31.3**2.25 + 2),
        ("6205-2RSH", 31.3, 0.028 * 31.3**2.25 + 2),
        ("6205-2RSL", 31.3, 0.0018 * 31.3**2.25),
        ("6206-2RS1", 36.9, 0.023 * 36.9**2.25 + 2),  # 62 mm belongs to the smaller row
        ("6208-2RS1", 52.6, 0.018 * 52.6**2.25 + 20),
        ("6210-2RS1", 62.5, 0.018 * 62.5**2.25 + 15),
        ("6212-2RS1", 75.5, 0.018 * 75.5**2.25),
        ("7208 BEP-2RS1", 56.1, 0.014 * 56.1**2 + 10),
        ("6205-2Z", 31.3, 0.0),
    ],
)
def test_the_formula_by_hand(designation: str, diameter: float, expected: float) -> None:
    found = 1e3 * seal_torque(find_bearing(designation), counterface=diameter * 1e-3)
    assert math.isclose(found, expected, rel_tol=ROUND_OFF, abs_tol=0)


@pytest.mark.parametrize(
    ("designation", "alike"),
    [("6210-2RSH", "6210-2RS1"), ("7208 BEP-2RSH", "7208 BEP-2RS1"), ("6310-LLH", "6310-2RSL")],
)
def test_seals_without_constants_are_as_those_of_another_type(designation: str, alike: str) -> None:
    found, other = (seal_torque(find_bearing(each), counterface=40e-3) for each in (designation, alike))
    assert found == other > 0


def test_light_seals_brake_less_and_scatter_more() -> None:
    """A tenth of contact seals at any size, but for the smallest, where SKF has none."""
    for number in ("6003", "6205", "6210", "6320"):
        light, full = (find_bearing(f"{number}-{suffix}") for suffix in ("2RSL", "2RS1"))
        assert seal_torque(light, counterface=1.2 * light.bore) < 0.1 * seal_torque(full, counterface=1.2 * full.bore)
        assert seal_spread(light) > seal_spread(full)


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


def effect_of(scene: Scene) -> Effect:
    (effect,) = (each for each in friction_torque(scene).effects if each.name == "seals")
    return effect


@pytest.mark.parametrize("suffix", ["RS1", "2RSL", "DDW"])
def test_seals_that_rub_count_by_the_formula(suffix: str) -> None:
    """The whole estimate, assumed, in the total and among the uncertain inputs."""
    scene, plain = sealed(f"6205-{suffix}"), sealed("6205")
    drag = scene.losses.seals
    assert drag is not None
    assert drag > 0
    difference = friction_torque(scene).torque.total[0] - friction_torque(plain).torque.total[0]
    assert math.isclose(difference, drag, rel_tol=1e-8)  # a small difference
    effect, origin = effect_of(scene), scene.losses.origins["seals"]
    assert (effect.decision, origin.status) == ("on", "assumed")
    assert effect.reason.startswith("assumed: SKF's formula for RS")
    (spread,) = (each for each in uncertain_inputs(scene) if each.key == "losses.seals")
    assert spread.deviation == origin.uncertainty
    (stated,) = (each for each in stated_inputs(scene) if each.key == "losses.seals")
    assert (stated.value, stated.status) == (drag, "assumed")
    (warning,) = said_of_seals(scene)
    assert "is assumed: SKF's formula" in warning


@pytest.mark.parametrize("suffix", ["2Z", "2RZ"])
def test_shields_and_seals_that_do_not_touch_say_nothing(suffix: str) -> None:
    scene = sealed(f"6205-{suffix}")
    assert scene.losses.seals is None
    assert not said_of_seals(scene)
    assert effect_of(scene).reason.startswith(f"no drag: {suffix}: ")


@pytest.mark.parametrize(("given", "expected"), [("3 N mm", 3e-3), ("0 N mm", 0.0), ("off", 0.0)])
def test_a_drag_that_is_given_wins(given: str, expected: float) -> None:
    scene = sealed("6205-2RS1", losses={"seals": given})
    assert scene.losses.seals == expected
    assert not scene.losses.origins
    assert not said_of_seals(scene)


def test_seals_of_a_bearing_without_known_shoulders_count_too() -> None:
    """NSK's 7014C has no shoulder in the catalogue: RS1 seals between the bore and the middle of the shoulder."""
    scene = sealed("7014C-2RS")
    bearing, drag = scene.bearing, scene.losses.seals
    assert bearing.inner.shoulder_half_width is None
    assert drag is not None
    least, most = (0.014 * (1e3 * d) ** 2 + 10 for d in (0.070, bearing.pitch_diameter - 0.55 * bearing.ball_diameter))
    assert least < 1e3 * drag < most


def test_a_pair_has_the_seals_twice() -> None:
    single = sealed("7208 BEP-2RS1")
    pair = sealed("7208 BEP-2RS1", arrangement={"kind": "O", "preload": "300 N"})
    found = friction_torque(pair).torque.declared
    assert single.losses.seals is not None
    assert found is not None
    assert math.isclose(found[0], 2 * single.losses.seals, rel_tol=1e-12)  # one sum


def test_an_impossible_estimate_is_refused_in_one_line() -> None:
    for catalog in ("6205", "paper_6205"):
        given = {"losses": {"seals": "estimate"}, "bearing": {"catalog": catalog}}
        refused(lambda: sealed("6205-2RS1", **given), "losses.seals = 'estimate'")  # noqa: B023
    refused(lambda: sealed("6205-2RS1", losses={"seals": "guess"}), "estimate")
