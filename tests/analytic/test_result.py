"""What the result of a friction torque says: parts, effects, JSON, warnings, and what is refused."""

import pickle
from collections.abc import Callable
from copy import copy, deepcopy
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.columns import COLUMNS, COORDINATES
from analytic.effects import ENTRIES
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import DRY_PARTS, dry, part, present, thrust, without
from tests.refusals import refused, refuses

SOLVED = ContactAngle(rule="solved", free=0.18)


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return dry(bearing_6205)


def test_what_is_left_out_is_none_and_said(scene: Scene) -> None:
    found = friction_torque(replace(scene, effects={"hysteresis": "off", "conformity": "off", "spin": "on"}))
    for name in ("conformity", "hysteresis", "rolling", "cage"):
        assert getattr(found.torque, name) is None
    np.testing.assert_array_equal(found.torque.total, part(found.torque, "spin"))
    told = {effect.name: effect for effect in found.effects}
    assert list(told) == list(ENTRIES)
    assert (told["spin"].decision, told["spin"].share, told["spin"].reason) == ("on", 1.0, "computed")
    assert [found.is_on(name) for name in ("spin", "conformity", "no effect")] == [True, False, False]
    assert "off in the scene" in told["conformity"].reason
    assert "no lubricant" in told["rolling"].reason
    assert friction_torque(without(scene, *DRY_PARTS)).torque.total == 0


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
    refused(lambda: answered(operation=thrust(1e7), contact_angle=SOLVED), "1e+07 N: ", "inner race's shoulder")
    refused(lambda: answered(effects={"seals": "off"}), "effects.seals")


@pytest.mark.parametrize("name", ["numerical_uncertainty", "contact_angle", "model_uncertainty"])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf])
def test_a_number_that_is_not_finite_never_becomes_a_result(name: str, value: float) -> None:
    result = friction_torque(load_scene("6205-dry"))
    assert result.checked() is result
    values = np.full(result.inner_speed.shape, 0.4)
    values[-1] = value
    with pytest.raises(InputError, match=rf"is {value:g} at operating point {values.size} \(inner_speed"):
        replace(result, **{name: values}).checked()


@pytest.fixture(scope="module")
def series(scene: Scene) -> FrictionTorque:
    """At 13 operating points, of which a table has one too many rows."""
    return friction_torque(replace(scene, operation=thrust(*np.linspace(300.0, 900.0, 13), speed=2 * np.pi * 25)))


def test_columns_have_every_number_and_nan_for_what_is_left_out(series: FrictionTorque) -> None:
    found = series.columns()
    assert set(COORDINATES) < set(found) <= {*COORDINATES, *COLUMNS}
    assert all(values.shape == (13,) for values in found.values())
    np.testing.assert_array_equal(found["torque_spin"], part(series.torque, "spin"))
    np.testing.assert_array_equal(found["load_outer"], series.outer.load)
    np.testing.assert_array_equal(found["friction_coefficient_inner"], series.friction_coefficient.inner)
    for name in ("torque_rolling", "torque_cage", "film_inner", "uncertainty_model", "friction_coefficient_pocket"):
        assert np.isnan(found[name]).all()


def test_some_points_of_a_result_are_those_of_the_whole(series: FrictionTorque) -> None:
    chosen = np.array([7, 2])
    some = series.at(chosen)
    for name in ("axial_load", "ball_load", "numerical_uncertainty"):
        np.testing.assert_array_equal(getattr(some, name), getattr(series, name)[chosen])
    np.testing.assert_array_equal(some.torque.total, series.torque.total[chosen])
    np.testing.assert_array_equal(some.outer.peak_pressure, series.outer.peak_pressure[chosen])
    np.testing.assert_array_equal(some.limits.peak_pressure, series.limits.peak_pressure[:, chosen])
    assert some.torque.rolling is None
    assert some.rows[0]["axial_load"] == series.axial_load[7]
    assert some.warnings == series.warnings


@pytest.mark.parametrize("copied", [lambda each: pickle.loads(pickle.dumps(each)), deepcopy, copy, replace])
def test_what_is_computed_when_it_is_read_is_in_every_copy(copied: Callable[[FrictionTorque], FrictionTorque]) -> None:
    """Cage, limits, ring, warnings and effects of a result that nobody has read."""
    scene = load_scene("6206", radial_load="2 kN")
    own, other = friction_torque(scene), copied(friction_torque(scene))
    assert own.cage is not None
    assert other.cage is not None
    assert (other.warnings, other.provenance) == (own.warnings, own.provenance)
    assert [effect.decision for effect in other.effects] == [effect.decision for effect in own.effects]
    assert other.rows == own.rows
    np.testing.assert_array_equal(other.limits.peak_pressure, own.limits.peak_pressure)
    with pytest.raises(AttributeError, match="'FrictionTorque' object has no attribute 'torqe'"):
        other.torqe  # type: ignore[attr-defined]  # noqa: B018


def test_the_cage_of_a_result_is_that_of_its_torque() -> None:
    """The kernel has the total, and the closed form the part that is computed when it is read."""
    for result in (friction_torque("6206", radial_load="2 kN"), friction_torque("7208B", axial_load="900 N")):
        own, cage = present(result.torque.cage), present(result.cage)
        np.testing.assert_allclose(own, cage.torque, rtol=1e-8)  # of the ring's balance
