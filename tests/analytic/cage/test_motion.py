"""The cage in motion, against closed forms and limits."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.cage.motion import CageMotion
from analytic.cage.pocket import impact
from analytic.cage.steady import hanging_torque, whirl_force, whirl_speed
from analytic.errors import InputError
from tests.analytic.cage.specimens import CAGE, RATE, WEIGHTLESS, W
from tests.refusals import refused


@pytest.mark.parametrize("begin", ["rest", "ramp"])
def test_balls_slide_on_a_resting_cage_under_its_weight(begin: Any) -> None:
    motion = CageMotion(CAGE, begin=begin, ramp=0.2, seed=5)  # the ramp is slow enough for gravity to prevail
    motion.advance(0.2)
    passed = motion.advance(0.1)
    closed = hanging_torque(0.1, CAGE.mass * 9.80665, RATE * 3.97e-3, 0.18)
    np.testing.assert_allclose(passed.slip_power / W, closed, rtol=0.02)  # it swings slightly, without damping
    np.testing.assert_allclose(passed.force, CAGE.mass * 9.80665 / np.hypot(1, 0.1), rtol=0.02)
    assert abs(passed.moment) < 1e-3 * passed.slip_power / W  # the mean of the signed moment is 0


@pytest.mark.parametrize("sign", [1, -1])
def test_rest_begins_where_friction_and_weight_balance(sign: int) -> None:
    """Off the vertical by atan(mu); from another place the cage would swing."""
    cage = replace(CAGE, orbit_speed=sign * CAGE.orbit_speed, ball_speed=sign * CAGE.ball_speed)
    motion = CageMotion(cage, begin="rest")
    x, y, _ = motion.centre
    np.testing.assert_allclose(x / -y, sign * 0.1, rtol=1e-9)
    motion.advance(0.005)
    assert motion.advance(0.02).place_deviation < 0.01 * cage.half_clearance


@pytest.mark.parametrize("locked", [True, False])
def test_a_whirling_cage_rolls_in_its_pockets(locked: bool) -> None:
    cage = replace(CAGE, transverse_inertia=0.7) if locked else CAGE
    motion = CageMotion(cage, begin="whirl", seed=5)
    motion.advance(0.05)
    passed = motion.advance(0.05)
    leaning = 0.18 if locked else 0.0
    whirl = whirl_speed(
        ball_speed=cage.ball_speed, ball_radius=3.97e-3, contact_angle=leaning, half_clearance=cage.half_clearance
    )
    force = whirl_force(
        cage_mass=cage.mass, whirl=whirl, orbit_speed=cage.orbit_speed, half_clearance=cage.half_clearance
    )
    np.testing.assert_allclose(passed.circling, whirl + cage.orbit_speed, rtol=0.02)
    np.testing.assert_allclose(passed.force, force, rtol=0.02)
    # It slides along z, as the axes of the balls lean by the contact angle; the mean of |cos| over them is 2/pi.
    torque = 2 / np.pi * 0.1 * force * RATE * 3.97e-3 * np.sin(0.18)
    if locked:
        np.testing.assert_allclose(passed.slip_power / W, torque, rtol=0.02)
    else:
        assert passed.slip_power / W < 0.3 * torque


@pytest.mark.parametrize("softness", [1 / 1.3e8, 1 / 2e6])
def test_a_sheet_takes_a_share_of_the_energy_of_an_impact(softness: float) -> None:
    """m v^2/2 = 2/5 F^(5/3)/K^(2/3) + F^2/(2 k): a contact and a sheet that take up the speed of the cage."""
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=1.0, gravity=WEIGHTLESS, orbit_speed=0.0, sheet_softness=softness
    )
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array([0.258, 0.344, 0.0]), angular_velocity=np.zeros(3))
    largest = motion.advance(1.9 * cage.half_clearance / 0.43).max_force
    energy = cage.mass / 9 * 0.43**2 / 2
    force = brentq(
        lambda f: 0.4 * f ** (5 / 3) / cage.stiffness ** (2 / 3) + f**2 * softness / 2 - energy, 1e-6, 1e6, xtol=1e-9
    )
    np.testing.assert_allclose(largest, force, rtol=3e-3)  # the largest of 40 steps or more
    assert force < 0.95 * impact(mass=cage.mass / 9, speed=0.43, stiffness=cage.stiffness).force


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_an_impact_during_contact_keeps_the_restitution(restitution: float) -> None:
    """A cage lies on its balls and is hit: damping is by the speed of this impact, not by that of the first contact."""
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=restitution, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0
    )
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-4)
    assert motion.forces().any()
    motion.launch(velocity=np.array([0.0, 0.0, -0.37]), angular_velocity=np.zeros(3))
    impacted = motion.advance(1.5 * cage.contact_time)
    np.testing.assert_allclose(motion.velocity[2], 0.37 * restitution, rtol=0.01)  # error of the step, and the weight
    elastic = impact(mass=cage.mass / 9, speed=0.37, stiffness=cage.stiffness)
    assert impacted.max_force < 1.1 * elastic.force  # with damping the force is about the same


@pytest.mark.parametrize("duration", [float("nan"), float("inf"), -0.1, 0.0])
def test_a_duration_must_be_positive_and_finite(duration: float) -> None:
    with pytest.raises(InputError, match="duration must be positive and finite"):
        CageMotion(CAGE, begin="rest").advance(duration)


def test_a_motion_goes_on_by_whole_steps_and_at_least_by_one() -> None:
    motion = CageMotion(CAGE, begin="rest")
    assert motion.step == pytest.approx(CAGE.contact_time / 40, rel=1e-12)
    for duration, steps in ((0.1, 1), (1.4, 1), (6.6, 7)):
        assert motion.advance(duration * motion.step).duration == pytest.approx(steps * motion.step, rel=1e-12)
    assert motion.time == pytest.approx(9 * motion.step, rel=1e-12)
    still = replace(CAGE, ball_speed=0.0, orbit_speed=0.0, ring_speed=0.0, gravity=WEIGHTLESS)
    assert CageMotion(still, begin="sudden").step == 1e-4  # s: no impact limits it


def test_impossible_input_is_refused() -> None:
    refused(lambda: CageMotion(CAGE, begin="sideways"), "start", '"whirl"')  # pyright: ignore[reportArgumentType]
    refused(lambda: CageMotion(CAGE, begin="ramp"), "needs the time")
    refused(lambda: CageMotion(CAGE, begin="rest", steps_per_contact=0.0), "steps_per_contact")


def test_the_tilt_is_that_of_a_tumbling_cage() -> None:
    """Free of all contact it turns evenly about an axis across its own: the mean square is a third of the last."""
    motion = CageMotion(replace(CAGE, half_clearance=1e-3, gravity=WEIGHTLESS), begin="sudden")
    motion.launch(velocity=np.zeros(3), angular_velocity=np.array([6.0, -17.0, 0.0]))
    passed = motion.advance(1e-3)
    assert passed.max_force == 0
    np.testing.assert_allclose(passed.tilt, np.hypot(6, 17) * passed.duration / np.sqrt(3), rtol=1e-3)  # of the sum


@pytest.mark.parametrize("sheet", [0.0, 2.3e-7])
def test_a_cage_begins_at_rest_as_deep_as_its_weight_presses_it(sheet: float) -> None:
    """A heavy one that lies on all balls alike: their forces are its weight, with a rigid sheet and a soft one."""
    cage = replace(CAGE, mass=31.0, gravity=(0.0, 0.0, -9.80665), sheet_softness=sheet, smoothing=1e-4)
    forces = CageMotion(cage, begin="rest").forces()
    np.testing.assert_allclose(forces[:, 2], 31.0 * 9.80665 / 9, rtol=1e-6)  # of the root with a sheet
