"""Effects count by the presence of their input; what each contributes, and how exactly a torque is computed."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic.effects import ENTRIES
from analytic.errors import FembearingError, InputError
from analytic.function import torque_function
from analytic.scene import STANDARD_GRAVITY, ContactAngle, Losses, Operation, Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from analytic.words import torque_of
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE, dry, effect_of, present, without
from tests.analytic.test_losses import OILED
from tests.refusals import refused

SCENES = Path(__file__).parents[2] / "validation" / "scenes"
OILY = load_scene(SCENES / "6205_physical.toml")
DRY = without(load_scene("6205-dry"), "cage_dynamics")


def loaded(scene: Scene, axial: Any, speed: Any, radial: Any = 0.0) -> Scene:
    """N, rad/s, N"""
    axial, speed, radial = np.broadcast_arrays(
        *(np.array(each, dtype=float, ndmin=1) for each in (axial, speed, radial))
    )
    return replace(scene, operation=Operation(axial_load=axial, inner_speed=speed, radial_load=radial))


RADIAL = loaded(OILY, [30.0, 640.0], [220.0, 41.0], [700.0, 150.0])
GIVEN = replace(OILY, contact_angle=ContactAngle(rule="given", value=0.3))
BARE = replace(OILY, lubricant=None, surface=None, friction_coefficient=0.08)


@pytest.mark.parametrize(
    ("scene", "on", "off"),
    [
        (
            OILY,
            "centrifugal gyroscopic finite_geometry asperities starvation rolling creep",
            "load_distribution weight",
        ),
        (RADIAL, "load_distribution weight unloaded_balls inlet_heating spin conformity hysteresis", "cage seals"),
        (BARE, "creep spin", "rolling asperities inlet_heating starvation unloaded_balls"),
        (GIVEN, "creep rolling", "centrifugal gyroscopic weight load_distribution"),
        (replace(OILY, spin_rule="balanced"), "spin", "creep"),
        (loaded(OILY, 500.0, 0.0), "spin", "centrifugal gyroscopic"),
        (replace(OILY, down=(0.0, 1.0, 0.0)), "weight unloaded_balls", "load_distribution"),
        (replace(OILY, cage=STAMPED_CAGE), "cage", "cage_dynamics ball_dynamics"),
        (without(RADIAL, "rolling", "creep"), "asperities", "rolling creep unloaded_balls"),
    ],
)
def test_an_effect_counts_where_its_input_is_there_and_it_can_act(scene: Scene, on: str, off: str) -> None:
    """However small: at any tolerance."""
    for tolerance in (0.3, 0.01):
        decisions = friction_torque(replace(scene, tolerance=tolerance)).effects.decisions
        assert list(decisions) == list(ENTRIES)
        assert {name: decisions[name] for name in on.split()} == dict.fromkeys(on.split(), "on")
        assert {name: decisions[name] for name in off.split()} == dict.fromkeys(off.split(), "off")


@pytest.mark.parametrize(
    ("scene", "name", "key"),
    [
        (BARE, "rolling", "[lubricant]"),
        (BARE, "asperities", "[surface]"),
        (GIVEN, "gyroscopic", 'contact_angle.rule = "given"'),
        (replace(OILY, spin_rule="balanced"), "creep", "friction.spin_rule"),
        (OILY, "cage", "[cage]"),
        (replace(OILY, cage=STAMPED_CAGE), "ball_dynamics", "cage.start"),
        (OILY, "ball_drag", "losses.oil_share"),
        (OILY, "plasticity", "not modelled"),
        (OILY, "friction", "known: load_distribution, "),
    ],
)
def test_what_lacks_its_input_is_refused_with_the_key_to_give(scene: Scene, name: str, key: str) -> None:
    refused(lambda: friction_torque(replace(scene, effects={name: "on"})), f"effects.{name}", key)


MEASURED = "load_distribution centrifugal gyroscopic weight finite_geometry asperities inlet_heating starvation creep"


@pytest.mark.parametrize("name", [*MEASURED.split(), "unloaded_balls"])
def test_a_measured_share_is_the_change_of_the_torque_without_the_effect(name: str) -> None:
    """At the points that are named; of an effect that is off it is the change with it."""
    with_it, without_it = friction_torque(RADIAL), friction_torque(without(RADIAL, name))
    one, other = (effect_of(each, name) for each in (with_it, without_it))
    assert (one.decision, one.share_is, other.decision, other.share_is) == ("on", "measured", "off", "measured")
    change = np.abs(with_it.torque.race - without_it.torque.race)[list(with_it.effects.points)]
    close = 1e-6  # of the torque: passes end at 3e-7, and a share begins at its own level of nodes
    at = list(with_it.effects.points)
    assert one.share == pytest.approx(np.max(change / with_it.torque.total[at]), rel=1e-6, abs=close)
    assert other.share == pytest.approx(np.max(change / without_it.torque.total[at]), rel=1e-6, abs=close)


def test_a_part_has_its_share_and_its_loss_is_in_the_total() -> None:
    found = friction_torque(replace(RADIAL, losses=Losses(seals=5e-3, drag=2e-3)))
    plain = friction_torque(RADIAL)
    np.testing.assert_allclose(found.torque.total - plain.torque.total, 7e-3, rtol=1e-11)  # round-off
    parts = {name: present(getattr(found.torque, name)) for name in ("spin", "conformity", "hysteresis", "rolling")}
    for name, part in (parts | {"seals": 5e-3, "drag": 2e-3}).items():
        told = effect_of(found, name)
        assert (told.decision, told.share_is) == ("on", "part")
        assert told.share == pytest.approx(np.max(part / found.torque.total), rel=1e-12)
    np.testing.assert_allclose(sum(parts.values()), found.torque.race, rtol=1e-12)
    with pytest.raises(InputError, match=r"losses\.drag must be at least 0"):
        friction_torque(replace(RADIAL, losses=Losses(drag=-1e-3)))


def test_what_lacks_its_input_has_a_rough_size() -> None:
    """At a given angle loads are Q = Fa/(Z sin al); forces of a ball's own over it, radial load by its tangent."""
    axial, speed, radial = 400.0, 500.0, 9.0
    found = friction_torque(loaded(replace(GIVEN, spin_rule="outer_control"), axial, speed, radial))
    bearing, load = GIVEN.bearing, axial / (9 * np.sin(0.3))
    orbit = speed * (1 - bearing.ball_diameter * np.cos(0.3) / bearing.pitch_diameter) / 2
    expected = {
        "centrifugal": bearing.ball_mass * bearing.pitch_diameter / 2 * orbit**2 / load,
        "weight": bearing.ball_mass * STANDARD_GRAVITY / load,
        "load_distribution": radial * np.tan(0.3) / axial,
    }
    for name, size in expected.items():
        told = effect_of(found, name)
        assert (told.decision, told.share_is) == ("off", "estimate")
        assert told.share == pytest.approx(size, rel=0.01)  # closed kinematics of another pitch


def test_a_point_that_does_not_settle_harms_no_other() -> None:
    scene = replace(BARE, contact_angle=ContactAngle(rule="solved", free=0.31))
    good, bad = loaded(scene, [410.0, 300.0], [83.0, 90.0]), loaded(scene, 2.0, 8e3)
    found = friction_torque(loaded(scene, [410.0, 2.0, 300.0], [83.0, 8e3, 90.0]))
    np.testing.assert_array_equal(np.isnan(found.torque.total), [False, True, False])
    np.testing.assert_allclose(found.torque.total[[0, 2]], friction_torque(good).torque.total, rtol=1e-12)  # round-off
    assert list(found.failures) == [1]
    (told,) = (each for each in found.warnings if "operating point 2 has no torque" in each)
    assert str(found.failures[1]) in told
    with pytest.raises(FembearingError):
        found.settled()
    with pytest.raises(type(found.failures[1])):
        friction_torque(bad)


def test_weight_points_along_the_radial_load_unless_a_direction_is_given() -> None:
    given = friction_torque(replace(RADIAL, down=(1.0, 0.0, 0.0)))
    np.testing.assert_array_equal(friction_torque(RADIAL).torque.total, given.torque.total)
    told = [
        any("operation.down" in each for each in friction_torque(scene).warnings)
        for scene in (RADIAL, loaded(OILY, 0.3, 3.0, 0.03), replace(loaded(OILY, 0.3, 3.0, 0.03), down=(1.0, 0.0, 0.0)))
    ]
    assert told == [False, True, False]  # a ball of 0.02 N under 0.1 N, or under 100 N


def test_under_thrust_the_weights_of_balls_cancel_to_first_order() -> None:
    """Across the axis: half the weight changes the torque by a quarter, whatever is left of second order."""
    plain = loaded(without(replace(OILY, tolerance=1e-4), "centrifugal", "gyroscopic"), 4.0, 50.0)
    changes = []
    for share in (1.0, 0.5):
        scene = replace(plain, bearing=replace(plain.bearing, ball_mass=share * plain.bearing.ball_mass))
        alike, turned = friction_torque(scene), friction_torque(replace(scene, down=(0.6, 0.8, 0.0)))
        assert (alike.is_on("weight"), turned.is_on("weight")) == (False, True)
        changes.append(turned.torque.race[0] / alike.torque.race[0] - 1)
        assert abs(changes[-1]) < 10 * present(effect_of(alike, "weight").share)
    assert changes[0] / changes[1] == pytest.approx(4.0, rel=0.2)  # of terms of higher order, and rounds to 1e-8


UNLIKE = {
    "radial": loaded(OILY, 150.0, 200.0, 900.0),
    "thrust": OILY,
    "combined": loaded(OILY, [500.0, 200.0], [40.0, 300.0], [300.0, 150.0]),
    "dry": DRY,
    "by rule": replace(OILY, spin_rule="outer_control"),
}


@pytest.mark.parametrize("name", UNLIKE)
def test_the_numerical_uncertainty_falls_with_the_tolerance_and_contains_the_error(name: str) -> None:
    found = {each: friction_torque(UNLIKE[name], tolerance=each) for each in (0.05, 5e-3, 1e-4)}
    fine, unsure = found[1e-4].torque.total, {each: of.numerical_uncertainty for each, of in found.items()}
    assert np.all(unsure[5e-3] < unsure[0.05])
    assert np.all(unsure[1e-4] < unsure[5e-3])
    for tolerance, result in found.items():
        assert tolerance == 1e-4 or np.all(unsure[tolerance] <= tolerance)  # no finer level is there
        assert np.all(np.abs(result.torque.total / fine - 1) <= unsure[tolerance] + unsure[1e-4]), tolerance


TWO_STATES = """
name = "large balls under their own force"
tolerance = 0.01
[bearing]
name = "drawn"
ball_count = 9
ball_diameter = "26.2453827 mm"
ball_mass = "73.8332446 g"
ball_material = "steel"
contact_angle = { rule = "solved", free = "0.475048843 rad" }
inner = { bottom_radius = "52.3614362 mm", groove_radius = "14.1921408 mm", shoulder_half_width = "10.5036431 mm" }
outer = { bottom_radius = "78.8730721 mm", groove_radius = "13.9566665 mm", shoulder_half_width = "10.5036431 mm" }
bore_diameter = "78.4774897 mm"
outside_diameter = "183.991527 mm"
[operation]
axial_load = "0.824612 N"
inner_speed = "77.5543 rad/s"
radial_load = "0.149876 N"
down = [0.41, 0.2407, 0.5757]
tilt = "free"
[lubricant]
viscosity = "0.111423102 Pa s"
pressure_viscosity = "9.92261256e-09 1/Pa"
eyring_stress = "5737349.38 Pa"
limiting_shear = 0.0776635
traction = "eyring_constant"
supply = "oil_bath"
[friction]
hysteresis_loss = 0.0127454
coefficient = 0.130296
"""


def test_two_steady_states_are_told_once_with_both_torques() -> None:
    """Centrifugal force of 22 N presses a ball that the thrust presses with 0.1 N."""
    scene = parse_scene(TWO_STATES, origin="drawn")
    found = friction_torque(scene)
    (told,) = (each for each in found.warnings if "two steady states" in each)
    assert torque_of(found.torque.race[0]) in told
    other = float(re.findall(r"or ([0-9.]+) N mm", told)[0]) / (1e3 * found.torque.race[0])
    assert abs(other - 1) > scene.tolerance > found.numerical_uncertainty[0]
    loads = {"axial_load": 0.824612, "inner_speed": 77.5543, "radial_load": 0.149876}
    assert torque_function(scene)(**loads) == pytest.approx(found.torque.total[0], rel=1e-7)  # of the first one


OIL_LOSSES = ("through_flow", "cage_shear", "ball_drag")


def test_a_loss_of_the_oil_without_its_input_has_the_size_of_usual_values() -> None:
    scene = replace(parse_scene(OILED, origin="here"), losses=Losses())
    found, usual = friction_torque(scene), replace(scene, losses=Losses(oil_share=0.02))  # as docs/effects.md has it
    assert [effect_of(found, name).share_is for name in OIL_LOSSES] == ["estimate"] * 3
    drag = present(friction_torque(usual).torque.oil)
    assert effect_of(found, "ball_drag").share == pytest.approx(np.max(drag / found.torque.total), rel=1e-12)
    grease = replace(present(scene.lubricant), supply="grease")
    greased = friction_torque(replace(scene, lubricant=grease))
    assert [effect_of(greased, name).share for name in OIL_LOSSES] == [None] * 3
    refused(lambda: friction_torque(without(usual, "ball_drag")), 'ball_drag = "off" contradicts its input')


@pytest.mark.parametrize(
    ("load", "words", "is_past"),
    [  # b = 1.1222 mm, p0 = 2.1831 GPa inside at 1000 N, both with its cube root; r_g sin(asin(w/r_g) - al) = 2.561 mm
        (7100.0, "exceeds the static limit", False),
        (7140.0, "the peak pressure on the inner race, 4.2", True),
        (11840.0, "exceeds the shoulder of the inner race", False),
        (11930.0, "exceeds the shoulder of the inner race", True),
    ],
)
def test_a_limit_is_warned_of_past_it_and_not_before(load: float, words: str, is_past: bool) -> None:
    found = friction_torque(loaded(dry(BEARING_6205), load, 31.0))
    assert any(words in warning for warning in found.warnings) == is_past
    assert np.all(np.isfinite(found.numerical_uncertainty))
    assert effect_of(found, "plasticity").decision == "off"
