"""Scenes whose cage needs more than the races hold: balls and cage move together, and the result says so."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import ContactAngle, Operation, Scene
from analytic.torque import friction_torque
from tests.analytic.cage.specimens import CAGED, with_cage
from tests.analytic.specimens import present


def running(load: float, rpm: float, **changed: object) -> Scene:
    operation = Operation(axial_load=np.array([load]), inner_speed=np.array([rpm * np.pi / 30]))
    scene = replace(CAGED, operation=operation, contact_angle=ContactAngle(rule="solved", free=0.18), effects={})
    return with_cage(scene, **({"start": "whirl", "seeds": 2, "duration": 0.008} | changed))


@pytest.mark.slow
def test_a_whirl_beyond_the_grip_takes_what_the_balls_can_give() -> None:
    """At 6000 rpm and 100 N given balls would press 2250 N; the races carry 9 balls of some 9 N."""
    found = friction_torque(running(100.0, 6000.0))
    cage = present(found.cage)
    assert found.is_on("ball_dynamics")
    assert cage.grip_number[0] > 20
    assert cage.mean_force[0] < 85
    assert cage.race_excess[0] > 0
    # What the cage adds is its own torque and what the races lose more.
    own = present(cage.motion[0]).torque
    np.testing.assert_allclose(cage.torque, own + cage.race_excess, rtol=1e-12)  # round-off
    assert np.isfinite(found.numerical_uncertainty[0])
    assert "with balls that move freely at 1 of 1 points" in found.provenance["cage"]
    given = friction_torque(replace(running(100.0, 6000.0), effects={"ball_dynamics": "off"}))
    assert present(given.cage).mean_force[0] > 2000
    assert any("of the grip of the races" in warning for warning in given.warnings)
    assert not any("of the grip of the races" in warning for warning in found.warnings)


def test_balls_that_hold_their_motion_stay_given() -> None:
    found = friction_torque(running(1000.0, 500.0, duration=0.01))
    reason = next(effect.reason for effect in found.effects if effect.name == "ball_dynamics")
    assert not found.is_on("ball_dynamics")
    assert reason.startswith("grip number 0.0")
    assert np.isnan(present(found.cage).race_excess[0])
