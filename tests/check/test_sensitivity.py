"""Changes that follow from known powers and proportions; ends that are refused; what a scene does not have."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.check import sensitivity
from fembearing.check.sensitivity import END, Input, Sensitivity, sensitivity_of
from fembearing.plain_types import plain
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed, scene

LOSSES = '[friction]\nhysteresis_loss = 0.006\n[losses]\nseals = "3 N mm"\n'


def changes(found: Sensitivity, name: str) -> np.ndarray:
    """(2, outputs): at the low end and the high one."""
    each = the(found, name)
    return np.array([each.change_low, each.change_high])


def the(found: Sensitivity, name: str) -> Input:
    (one,) = (each for each in found.inputs if each.name == name)
    return one


@pytest.fixture(scope="module")
def dry() -> Scene:
    """Without friction, its contact angle given: the balls' load is the thrust's share, whatever the contacts do."""
    scene = load_scene("6205-dry")
    return replace(
        scene, friction_coefficient=None, hysteresis_loss=None, contact_angle=ContactAngle(rule="given", value=0.31)
    )


@pytest.fixture(scope="module")
def pressures(dry: Scene) -> Sensitivity:
    return sensitivity_of(dry)


@pytest.fixture(scope="module")
def oiled() -> Scene:
    return scene(changed(SPEEDS, '["300 rpm", "100 rpm", "900 rpm"]', OILED) + LOSSES)


@pytest.fixture(scope="module")
def torques(oiled: Scene) -> Sensitivity:
    return sensitivity_of(oiled)


def test_peak_pressures_follow_hertz(pressures: Sensitivity) -> None:
    """p0 as Q^(1/3); Q as 1/sin(al)."""
    assert [(output.quantity, output.pair) for output in pressures.outputs] == [
        ("peak_pressure", "inner"),
        ("peak_pressure", "outer"),
    ]
    ends = np.exp(0.01 * END * np.array([[-1], [1]]))  # 1 % is the default of a load
    np.testing.assert_allclose(
        changes(pressures, "operation.axial_load"), np.tile(ends ** (1 / 3) - 1, 2), rtol=1e-9
    )  # round-off
    # The angle also bends the race along rolling, by some hundredth of the change of its cosine.
    angle = np.array([[0.31 - 0.03 * END], [0.31 + 0.03 * END]])
    steeper = (np.sin(0.31) / np.sin(angle)) ** (1 / 3) - 1
    np.testing.assert_allclose(changes(pressures, "bearing.contact_angle.value"), np.tile(steeper, 2), rtol=0.1)


def test_a_groove_moves_its_own_race_alone(pressures: Sensitivity) -> None:
    for column, race in enumerate(("inner", "outer")):
        found = changes(pressures, f"bearing.{race}.conformity")
        np.testing.assert_allclose(found[:, 1 - column], 0, atol=1e-12)  # the angle is given: nothing else moves
        assert found[0, column] < 0 < found[1, column]  # an opener groove presses harder


def test_without_friction_nothing_of_it_is_asked(pressures: Sensitivity) -> None:
    keys = ("ball_diameter", "pitch_diameter", "inner.conformity", "outer.conformity", "contact_angle.value")
    known = {f"bearing.{key}" for key in keys} | {"operation.axial_load"}
    assert {each.name for each in pressures.inputs} <= known
    assert {"operation.axial_load", "bearing.inner.conformity"} <= {each.name for each in pressures.inputs}


def test_parts_that_are_proportional_change_by_their_share(oiled: Scene, torques: Sensitivity) -> None:
    assert [round(output.inner_speed * 30 / np.pi) for output in torques.outputs if output.inner_speed] == [100, 900]
    ends = Operation(axial_load=np.full(2, 700.0), inner_speed=np.array([100.0, 900.0]) * np.pi / 30)
    parts = friction_torque(replace(oiled, operation=ends)).torque
    assert parts.hysteresis is not None
    np.testing.assert_allclose([output.value for output in torques.outputs], parts.total, rtol=1e-9)
    # 50 % and 30 % are the standard deviations of a loss factor and of seals, both lognormal. All samples
    # have the nodes of the most demanding point, which move the other totals within their numerical uncertainty.
    for key, deviation, part in (("friction.hysteresis_loss", 0.5, parts.hysteresis), ("losses.seals", 0.3, 3e-3)):
        share = np.expm1(deviation * END * np.array([[-1], [1]])) * part / parts.total
        np.testing.assert_allclose(changes(torques, key), share, rtol=2e-3)


def test_inputs_stand_in_the_order_of_their_swing(torques: Sensitivity) -> None:
    swings = [np.abs(changes(torques, each.name)).max() for each in torques.inputs]
    assert swings == sorted(swings, reverse=True)
    for each in torques.inputs:
        assert each.low < each.value < each.high
        assert each.source
    oil = "lubricant.viscosity"
    assert the(torques, oil).low == pytest.approx(0.06 * np.exp(-0.06 * END), rel=1e-12)  # round-off
    assert changes(torques, oil)[1, 1] > 0 > changes(torques, oil)[0, 1]  # fast: the oil resists
    warm = changes(torques, "lubricant.temperature")
    assert warm[0, 1] > 0 > warm[1, 1]


def test_a_given_coefficient_makes_all_speeds_one(dry: Scene) -> None:
    only = {**dry.effects, "hysteresis": "off"}
    scene = replace(dry, friction_coefficient=0.08, cage=None, spin_rule="balanced", effects=only)
    found = sensitivity_of(scene)
    assert len(found.outputs) == 1
    # All that slides does so with this coefficient, and the share of spin between the races stays. (Creep would take
    # more of the slip from a higher friction.) 20 % is the default of a coefficient.
    ends = np.expm1(0.2 * END * np.array([[-1], [1]]))
    np.testing.assert_allclose(changes(found, "friction.coefficient"), ends, rtol=1e-4)


def test_a_cage_that_its_balls_squeeze_stays_at_rest(dry: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """With balls that move freely each input would take as long as the torque's own motion of the cage."""
    effects = []

    def noted(scene: Scene):
        effects.append(friction_torque(scene).effects)
        return friction_torque(scene)

    monkeypatch.setattr(sensitivity, "friction_torque", noted)
    assert dry.cage is not None
    ball = dry.bearing.ball_diameter
    pocket = {"pocket_diameter": 1.003 * ball, "pocket_depth": 0.5015 * ball}
    tight = replace(dry.cage, **pocket, start="rest", duration=0.004, seeds=2)
    loads = Operation(axial_load=np.array([90.0]), radial_load=np.array([600.0]), inner_speed=np.array([210.0]))
    own = replace(
        dry, contact_angle=ContactAngle(rule="solved"), friction_coefficient=0.08, cage=tight, operation=loads
    )
    decided = {each.name: each.decision for each in friction_torque(own).effects}
    assert decided["ball_dynamics"] == "on"
    sensitivity_of(own)
    for found in effects:
        assert {each.decision for each in found if each.name in ("cage_dynamics", "ball_dynamics")} == {"off"}


def test_equal_speeds_are_told_apart_by_their_loads(dry: Scene) -> None:
    loads = Operation(axial_load=np.array([700.0, 200.0, 1300.0]), inner_speed=np.full(3, 30.0))
    outputs = sensitivity_of(replace(dry, friction_coefficient=0.08, cage=None, operation=loads)).outputs
    assert [output.axial_load for output in outputs] == [200.0, 1300.0]


def test_an_end_that_is_refused_is_left_open_and_told(dry: Scene) -> None:
    """Balls of seven times the diameter have no room between the rings."""
    found = sensitivity_of(replace(dry, uncertainty={"bearing.ball_diameter": dry.bearing.ball_diameter}))
    ball = the(found, "bearing.ball_diameter")
    assert ball.change_low is not None
    assert ball.change_high is None
    (reason,) = ball.refused
    assert reason.startswith("56.37 mm: ")
    told = plain(found)
    (entry,) = (each for each in told["inputs"] if each["name"] == "bearing.ball_diameter")
    assert (entry["change_high"], entry["refused"]) == (None, [reason])


INPUT = Input(
    name="bearing.ball_diameter", unit="m", value=7.9e-3, low=7.8e-3, high=8e-3, source="given",
    change_low=(-0.02,), change_high=(0.03,), refused=(),
)  # fmt: skip


def test_the_swing_is_the_largest_change_at_either_end() -> None:
    assert INPUT.swing == 0.03
    assert replace(INPUT, change_low=(-0.02, -0.07), change_high=(0.03, 0.01)).swing == 0.07
    assert replace(INPUT, change_high=None).swing == 0.02
    assert replace(INPUT, change_low=None, change_high=None).swing == 0.0
