"""What the cage of a scene asks of its balls: numbers, regimes, warnings and refusals in the friction torque."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.cage.drive import cage_drive
from analytic.errors import InputError
from analytic.scene import ContactAngle, Operation, Scene
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import balls_of, effect_of, present

FAST = replace(CAGED, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([500.0]) * RPM))


def pushed(radial: float, *, clearance: float, **cage: Any) -> Scene:
    """500 rpm and 1000 N of thrust with a radial load; clearance : of the pockets, m."""
    operation = Operation(
        axial_load=np.array([1000.0]), inner_speed=np.array([500.0]) * RPM, radial_load=np.array([radial]), tilt="free"
    )
    diameter = FAST.bearing.ball_diameter + clearance
    scene = replace(
        FAST,
        operation=operation,
        contact_angle=ContactAngle(rule="solved", free=0.18),
        spin_rule="balanced",  # creep takes some 4 % off the lead
        effects={"hysteresis": "off", "ball_dynamics": "off"},
    )
    return with_cage(scene, pocket_diameter=diameter, pocket_depth=diameter / 2, **cage)


def test_a_whirl_states_its_share_of_the_grip() -> None:
    result = friction_torque(with_cage(FAST, start="whirl"))
    cage = present(result.cage)
    load = 1000 / (9 * np.sin(0.18))
    # m (w_b r/nabla + w_c)^2 nabla is 15.95 N by hand (test_torque.py); each ball carries 2 mu Q/(1 + mu_c)
    expected = 15.95 / (9 * 2 * 0.1 * load / 1.1)
    np.testing.assert_allclose(cage.grip_number, expected, rtol=1e-2)  # free balls turn 0.4 % faster
    np.testing.assert_allclose(cage.grip_share, cage.grip_number, rtol=0.02)  # the motion against its closed form
    assert effect_of(result, "ball_dynamics").reason.startswith(f"grip number {cage.grip_number[0]:.3g} at most")


@pytest.mark.parametrize(
    ("thrust", "rpm", "friction", "carried", "number"),
    # Digits of an independent code of balls and cage in motion, which kept 0.6 to 0.9 of what is carried
    [(1000.0, 5500.0, 0.1, 606.0, 3.2), (100.0, 1800.0, 0.1, 83.0, 2.5), (20.0, 500.0, 0.05, 9.3, 1.7)],
)
def test_the_grip_of_fast_and_light_bearings(
    thrust: float, rpm: float, friction: float, carried: float, number: float
) -> None:
    operation = Operation(axial_load=np.array([thrust]), inner_speed=np.array([rpm * RPM])).as_series()
    balls = balls_of(replace(FAST, contact_angle=ContactAngle(rule="solved", free=0.18), operation=operation))
    drive = cage_drive(FAST, balls, friction, operation.inner_speed)
    mu = np.array([0.1])
    np.testing.assert_allclose(9 * np.min(present(drive.grip.carried(mu))), carried, rtol=0.005)  # digits
    np.testing.assert_allclose(drive.grip_number(mu), number, rtol=0.02)


@pytest.mark.parametrize(("start", "state"), [("whirl", "whirl"), ("rest", "rest")])
def test_a_whirl_that_needs_more_grip_than_there_is_is_warned_of(start: Any, state: str) -> None:
    """With a race friction of 0.0015 the grip number above is 67 times as large; a cage at rest needs little."""
    result = friction_torque(
        with_cage(
            replace(FAST, friction_coefficient=1.5e-3, effects={**FAST.effects, "ball_dynamics": "off"}),
            start=start,
            friction_coefficient=0.1,
        )
    )
    assert present(present(result.cage).motion[0]).state == state
    number = float(present(result.cage).grip_number[0])
    assert 0.9 < number < 2
    words = f"uses {100 * number:.3g} % of the grip of the races at 500 rpm, limit 90 %"
    assert any(words in warning for warning in result.warnings) == (state == "whirl")
    assert effect_of(result, "ball_dynamics").reason.startswith("off in the scene")


def test_balls_lead_by_the_loads_of_the_ring() -> None:
    """118 um at 500 N (test_grip.py); the motion has it too."""
    result = friction_torque(pushed(500.0, clearance=0.2e-3, start="rest"))
    cage = present(result.cage)
    np.testing.assert_allclose(np.abs(cage.ball_lead), 118e-6, rtol=0.02)  # contacts of finite geometry differ
    driven = present(cage.driven[0])
    assert driven.ball_lead == cage.ball_lead[0]
    assert present(cage.motion[0]).state == "rest"  # in a clearance of 0.2 mm it gives way
    # 2 mu Q/(1 + mu_c) of the ball with the least load, 314.8 N by Hertz; finite geometry changes it by 1 %
    least = 2 * 0.1 * 314.8 / 1.1
    force = 6.58e-3 * (driven.ball_speed * 39.7 + driven.orbit_speed) ** 2 * 0.1e-3
    np.testing.assert_allclose(cage.grip_number, force / (9 * least), rtol=0.03)
    back = pushed(-500.0, clearance=0.2e-3)
    np.testing.assert_allclose(present(friction_torque(back).cage).ball_lead, -cage.ball_lead, rtol=0.02)


def test_pockets_too_tight_for_the_lead_are_squeezed() -> None:
    scene = pushed(500.0, clearance=0.1e-3, start="whirl")
    result = friction_torque(scene)
    cage = present(result.cage)
    assert cage.motion == (None,)
    assert not result.is_on("cage_dynamics")
    (warning,) = (warning for warning in result.warnings if "wider pockets avoid this" in warning)
    assert "at 500 rpm" in warning
    assert present(result.cage).rows[0]["state"] == "squeezed"
    # Creep alone would give some 170 N (test_grip.py), so every ball slides: 2 mu Q/1.1, up to the weight of the cage
    np.testing.assert_allclose(cage.grip_share, 1.0, rtol=2e-4)
    rate = 15.599e-3 * 23.411 / 39.01  # r w_b/w at 0.18 rad; here the angle is larger
    np.testing.assert_allclose(cage.torque, 0.1 * cage.mean_force * rate, rtol=0.01)


def test_races_without_friction_drive_no_cage() -> None:
    with pytest.raises(InputError, match=r"races with a friction of 0 drive no cage.*above 0, usual are 0\.05 to"):
        friction_torque(replace(FAST, friction_coefficient=0.0))
    left_out = replace(FAST, friction_coefficient=0.0, effects={**FAST.effects, "cage": "off"})
    assert friction_torque(left_out).cage is None


def test_a_ball_without_load_drives_no_cage() -> None:
    """A large radial load and no thrust; without centrifugal force nothing holds the balls on the other side."""
    scene = pushed(800.0, clearance=0.2e-3)
    scene = replace(scene, operation=replace(scene.operation, axial_load=np.array([0.0])))
    unheld = replace(scene, effects={**scene.effects, "centrifugal": "off", "weight": "off"})
    with pytest.raises(InputError, match=r"ball \d of 9 has a load of 0 N on both races at 500 rpm.*axial_load"):
        friction_torque(unheld)
    assert present(friction_torque(scene).cage).torque[0] > 0  # pressed outward by its own force
    still = replace(unheld, operation=replace(unheld.operation, inner_speed=np.array([0.0])))
    assert present(friction_torque(still).cage).torque[0] > 0


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
