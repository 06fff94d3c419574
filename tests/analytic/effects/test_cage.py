"""Decisions about the cage: which method is used, and the reason."""

from dataclasses import replace

import numpy as np
import pytest

from analytic import friction_torque
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Operation
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import effect_of

RULED = replace(CAGED, spin_rule="balanced")  # closed kinematics: the speed of the balls by hand


def assert_rests(result: FrictionTorque, reason: str) -> None:
    """The motion is left out for this reason, and nothing moved."""
    effect = effect_of(result, "cage_dynamics")
    assert effect.decision == "off"
    assert reason in effect.reason
    assert result.cage is not None
    assert not any(result.cage.motion)


def test_without_a_start_the_closed_form_is_used() -> None:
    result = friction_torque(RULED)
    assert_rests(result, "cage.start is not given")
    # (w_b r)^2/(g nabla) at 500 rpm, with w_b r = w R_i R_o/d_m by hand: 52.36 x 15.599 x 23.411/39.01 mm/s
    assert_rests(result, f"{0.49016**2 / (9.80665 * 0.1e-3):.3g}")
    assert any("cage_dynamics is neglected, up to" in warning for warning in result.warnings)


def test_a_cage_that_cannot_whirl_has_the_closed_form() -> None:
    slow = replace(RULED, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([20.0]) * RPM))
    # The whirl number above by (20/500)^2
    assert_rests(friction_torque(with_cage(slow, start="sudden")), "whirl number 0.392")


def test_a_motion_within_the_tolerance_is_left_out() -> None:
    assert_rests(
        friction_torque(with_cage(replace(CAGED, tolerance=0.9), start="sudden")),
        "within the budget of 45 %",
    )
    off = replace(with_cage(CAGED, start="sudden"), effects={**CAGED.effects, "cage_dynamics": "off"})
    assert_rests(friction_torque(off), "off in the scene")


def test_auto_does_not_move_a_long_series() -> None:
    many = Operation(axial_load=np.full(3000, 1000.0), inner_speed=np.linspace(100, 500, 3000) * RPM)
    result = friction_torque(with_cage(replace(CAGED, operation=many), start="rest"))
    assert_rests(result, "3000 points need 540 s of motion")  # twice 0.03 s for two seeds and another start
    assert any('effects.cage_dynamics = "on"' in warning for warning in result.warnings)


def test_with_more_steps_auto_allows_less_motion() -> None:
    """A second of motion in 25 times the steps is as much work as 25 s."""
    many = Operation(axial_load=np.full(150, 1000.0), inner_speed=np.linspace(100, 500, 150) * RPM)
    given = with_cage(replace(CAGED, operation=many), start="rest", steps_per_contact=1000)
    assert_rests(friction_torque(given), "27 s of motion, limit 20 s at 1000 steps")


def test_without_cage_or_with_the_cage_left_out_nothing_is_added() -> None:
    for left in (replace(CAGED, cage=None), replace(CAGED, effects={**CAGED.effects, "cage": "off"})):
        result = friction_torque(left)
        assert result.cage is None
        assert result.torque.cage is None
        assert effect_of(result, "cage").decision == effect_of(result, "cage_dynamics").decision == "off"
        assert set(vars(result.row(0).cage).values()) == {None}


def test_a_motion_needs_its_start() -> None:
    with pytest.raises(InputError, match=r'effects\.cage_dynamics = "on" is refused: cage\.start is not given'):
        friction_torque(replace(CAGED, effects={**CAGED.effects, "cage_dynamics": "on"}))
