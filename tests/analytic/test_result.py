"""What the result of a friction torque says: parts, effects, JSON, warnings, and what is refused."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects.table import ENTRIES
from analytic.errors import InputError
from analytic.result import require_numbers
from analytic.scene import Bearing, ContactAngle, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.plain_types import plain
from tests.analytic.specimens import DRY_PARTS, dry, part, thrust, without
from tests.refusals import refused, refuses

SOLVED = ContactAngle(rule="solved", free=0.18)


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return dry(bearing_6205)


def test_what_is_left_out_is_none_and_said(scene: Scene) -> None:
    found = friction_torque(replace(scene, effects={"hysteresis": "off", "conformity": "off", "spin": "on"}))
    assert found.torque.conformity is None
    assert found.torque.hysteresis is None
    assert found.torque.rolling is None
    assert found.torque.cage is None
    np.testing.assert_array_equal(found.torque.total, part(found.torque, "spin"))
    told = {effect.name: effect for effect in found.effects}
    assert list(told) == list(ENTRIES)
    assert (told["spin"].decision, told["spin"].share, told["spin"].reason) == ("on", 1.0, "on in the scene")
    assert [found.is_on(name) for name in ("spin", "conformity", "no effect")] == [True, False, False]
    for name, words in (
        ("conformity", "off in the scene"),
        ("hysteresis", "off in the scene"),
        ("rolling", "no lubricant"),
    ):
        assert words in told[name].reason
    assert any("conformity is neglected" in warning for warning in found.warnings)
    nothing = friction_torque(without(scene, *DRY_PARTS)).torque
    assert nothing.total == 0


def test_shares_are_the_largest_of_the_series(scene: Scene) -> None:
    found = friction_torque(replace(scene, contact_angle=SOLVED, operation=thrust(1.0, 40.0, 900.0)))
    for effect in (effect for effect in found.effects if effect.name in DRY_PARTS):
        assert effect.share == np.max(part(found.torque, effect.name) / found.torque.total)


REGIME = ("whirl_speed", "wobble", "ball_lead", "grip_share", "grip_number", "race_excess")
DESIGN = {
    "inner_speed": None,
    "axial_load": None,
    "radial_load": None,
    "moment": None,
    "contact_angle": None,
    "torque": ["total", "race", "spin", "conformity", "hysteresis", "rolling", "cage", "oil", "declared"],
    "friction_coefficient": ["inner", "outer", "pocket"],
    "film": ["inner", "outer"],
    "asperity_share": ["inner", "outer"],
    "boundary_share": ["inner", "outer"],
    "contact": ["inner", "outer"],
    "uncertainty": ["numerical", "model", "model_parts"],
    "cage": ["mean_force", "max_force", "interval", "duration", "state", "signed_moment", *REGIME],
    "ring": ["displacement", "stiffness", "balls"],
}


def test_the_json_has_the_keys_of_the_design(scene: Scene) -> None:
    result = friction_torque(replace(scene, operation=thrust(500.0, 900.0)))
    found = {"points": plain(result.rows), "effects": plain(result.shares)}
    assert len(found["points"]) == 2
    for index, point in enumerate(found["points"]):
        assert {key: list(value) if isinstance(value, dict) else None for key, value in point.items()} == DESIGN
        for contact in point["contact"].values():
            names = ["load", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach"]
            assert list(contact) == names
        for race in ("inner", "outer"):
            shown = {name: values[index] for name, values in vars(getattr(result, race)).items()}
            assert point["contact"][race] == shown
        assert point["torque"]["rolling"] is None
    assert [point["axial_load"] for point in found["points"]] == [500.0, 900.0]
    assert set(found["effects"][0]) == {"name", "decision", "share", "share_is", "reason"}
    assert result.provenance["scene"] == "test"
    assert result.provenance["contact_angle"] == "given"
    assert result.provenance["contacts"] == "Hertz"
    assert {"fembearing", "numpy", "scipy"} <= set(result.provenance)
    assert result.seconds > 0


def test_what_cannot_be_answered_is_refused(scene: Scene) -> None:
    def answered(**changed: Any) -> object:
        return friction_torque(replace(scene, **changed))

    refused(lambda: answered(friction_coefficient=None), "friction.coefficient is missing", "coefficient = 0.1")
    for value in (-0.1, float("nan")):
        refused(lambda: answered(friction_coefficient=value), "friction.coefficient")  # noqa: B023
    refuses(answered, hysteresis_loss=-0.01, spin_rule="race_control")
    refused(lambda: answered(operation=thrust(900.0, speed=float("nan"))), "operation.inner_speed")
    refused(lambda: answered(operation=thrust()), "operation.axial_load is empty")
    refused(lambda: answered(operation=thrust(0.0)), "axial_load")
    refused(lambda: answered(operation=thrust(40.0, 1e7), contact_angle=SOLVED), "1e+07 N: ", "inner race's shoulder")
    refused(lambda: answered(effects={"seals": "off"}), "effects.seals")


@pytest.mark.parametrize("name", ["numerical_uncertainty", "contact_angle", "model_uncertainty"])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_not_finite_never_becomes_a_result(name: str, value: float) -> None:
    result = friction_torque(load_scene("6205-dry"))
    assert require_numbers(result) is result
    values = np.full(result.inner_speed.shape, 0.4)
    values[-1] = value
    with pytest.raises(InputError, match=rf"is {value:g} at operating point {values.size} \(inner_speed"):
        require_numbers(replace(result, **{name: values}))


def test_an_uncertainty_may_be_infinite_for_a_reason_alone() -> None:
    result = friction_torque(load_scene("6205-dry"))
    unsure = replace(result, numerical_uncertainty=np.full(result.inner_speed.shape, np.inf), unknown=("nobody knows",))
    assert require_numbers(unsure) is unsure
    with pytest.raises(InputError, match="numerical uncertainty is inf"):
        require_numbers(replace(unsure, unknown=()))
    with pytest.raises(InputError, match="total is nan"):
        require_numbers(replace(unsure, torque=replace(result.torque, total=result.torque.total * np.nan)))
