"""The cage in motion, against closed forms, limits and mirror images."""

import subprocess
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.cage.motion import CageMotion, MotionError
from analytic.cage.pocket import impact
from analytic.cage.steady import rest_torque, whirl_force, whirl_speed, whirl_torque
from analytic.errors import InputError
from tests.analytic.cage.specimens import CAGE, RATE, TABLE_1, WEIGHTLESS, W


def test_balls_and_cage_at_one_speed_never_touch_without_gravity() -> None:
    motion = CageMotion(replace(CAGE, gravity=WEIGHTLESS), begin="rest")
    passed = motion.advance(0.05)
    assert passed.max_force == 0
    assert passed.slip_power == 0
    np.testing.assert_allclose(motion.centre, 0, atol=1e-15)


@pytest.mark.parametrize("begin", ["rest", "ramp"])
def test_a_cage_that_rests_slides_with_its_weight(begin: Any) -> None:
    motion = CageMotion(CAGE, begin=begin, ramp=0.2, seed=5)  # so slow that gravity prevails
    motion.advance(0.2)
    passed = motion.advance(0.1)
    closed = rest_torque(
        friction_coefficient=0.1, cage_mass=CAGE.mass, ball_rate=RATE, ball_radius=3.97e-3, contact_angle=0.18
    )
    np.testing.assert_allclose(passed.slip_power / W, closed, rtol=0.02)  # it swings a little, undamped
    np.testing.assert_allclose(passed.force, CAGE.mass * 9.80665 / np.hypot(1, 0.1), rtol=0.02)
    assert abs(passed.moment) < 1e-3 * passed.slip_power / W  # the signed moment averages to nothing


@pytest.mark.parametrize("sign", [1, -1])
def test_rest_begins_where_friction_and_weight_balance(sign: int) -> None:
    """Off the vertical by atan(mu), against the drive; begun elsewhere it would swing by as much."""
    cage = replace(CAGE, orbit_speed=sign * CAGE.orbit_speed, ball_speed=sign * CAGE.ball_speed)
    motion = CageMotion(cage, begin="rest")
    x, y, _ = motion.centre
    np.testing.assert_allclose(x / -y, sign * 0.1, rtol=1e-9)
    motion.advance(0.005)
    assert motion.advance(0.02).place_deviation < 0.01 * cage.half_clearance


@pytest.mark.parametrize("locked", [True, False])
def test_a_cage_that_whirls_rolls_in_its_pockets(locked: bool) -> None:
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
    torque = whirl_torque(
        friction_coefficient=0.1, force=force, ball_rate=RATE, ball_radius=3.97e-3, contact_angle=0.18
    )
    if locked:
        np.testing.assert_allclose(passed.slip_power / W, torque, rtol=0.02)
    else:
        assert passed.slip_power / W < 0.3 * torque


def test_impact_force_is_the_closed_form() -> None:
    """A cage thrown straight at its balls hits all of them at once; frictionless, at two speeds."""
    cage = replace(CAGE, friction_coefficient=0.0, restitution=1.0, gravity=WEIGHTLESS, orbit_speed=0.0)
    forces = []
    for speed in (0.11, 0.43):
        motion = CageMotion(cage, begin="sudden")
        motion.launch(velocity=np.array([0.6 * speed, 0.8 * speed, 0.0]), angular_velocity=np.zeros(3))
        largest = motion.advance(1.9 * cage.half_clearance / speed).max_force
        exact = impact(mass=cage.mass / 9, speed=speed, stiffness=cage.stiffness)
        np.testing.assert_allclose(largest, exact.force, rtol=3e-3)  # the largest of 40 points
        forces.append(largest)
    np.testing.assert_allclose(np.log(forces[1] / forces[0]) / np.log(43 / 11), 1.2, atol=3e-3)


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_a_bounce_keeps_the_restitution(restitution: float) -> None:
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=restitution, gravity=WEIGHTLESS, orbit_speed=0.0, ball_speed=100.0
    )
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array([0.0, 0.0, 0.37]), angular_velocity=np.zeros(3))
    motion.advance(1.9 * cage.half_clearance / 0.37)
    np.testing.assert_allclose(motion.velocity[2], -0.37 * restitution, rtol=5e-3)  # the step's error


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_a_blow_on_what_touches_already_keeps_the_restitution(restitution: float) -> None:
    """A cage that lies on its balls is hit: the damping is by the blow, not by how gently the contact once began."""
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=restitution, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0
    )
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-4)
    assert motion.forces().any()
    motion.launch(velocity=np.array([0.0, 0.0, -0.37]), angular_velocity=np.zeros(3))
    hit = motion.advance(1.5 * cage.contact_time)
    np.testing.assert_allclose(motion.velocity[2], 0.37 * restitution, rtol=0.01)  # the step's error, and its weight
    elastic = impact(mass=cage.mass / 9, speed=0.37, stiffness=cage.stiffness)
    assert hit.max_force < 1.1 * elastic.force  # a blow that is damped has about the same force


def test_torque_does_not_depend_on_how_friction_is_smoothed() -> None:
    found = []
    for smoothing in (0.25e-3, 0.5e-3, 1e-3):  # more is cut off at a share of the balls' speed
        motion = CageMotion(replace(CAGE, smoothing=smoothing), begin="whirl")
        motion.advance(0.03)
        found.append(motion.advance(0.03).slip_power)
    assert np.ptp(found) < 5e-3 * found[1]


def test_running_backwards_is_the_mirror_image() -> None:
    """y turns round, and with it the bearing; gravity is along x, where the first ball is."""
    cage = replace(CAGE, gravity=(-9.80665, 0.0, 0.0))
    found = []
    for sign in (1, -1):
        motion = CageMotion(
            replace(cage, orbit_speed=sign * cage.orbit_speed, ball_speed=sign * cage.ball_speed), begin="sudden"
        )
        motion.launch(velocity=np.array([0.11, sign * 0.2, 0.05]), angular_velocity=np.array([sign * 3.0, 4.0, 0.0]))
        found.append((motion.advance(2e-3), motion.centre * [1, sign, 1]))
    (ahead, there), (back, mirrored) = found
    assert ahead.max_force > 1
    np.testing.assert_allclose(
        mirrored, there, atol=1e-6 * cage.half_clearance
    )  # round-off grows from impact to impact
    np.testing.assert_allclose([back.slip_power, -back.moment], [ahead.slip_power, ahead.moment], rtol=1e-6)


@pytest.mark.parametrize("duration", [float("nan"), float("inf"), -0.1, 0.0])
def test_no_motion_without_end_or_backwards(duration: float) -> None:
    with pytest.raises(InputError, match="duration must be positive and finite"):
        CageMotion(CAGE, begin="rest").advance(duration)


def test_a_contact_that_opens_fast_does_not_pull() -> None:
    """Balls that run away from a cage that lies on them, much faster than the blow that the damping is for."""
    cage = replace(CAGE, friction_coefficient=0.0, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-4)
    assert motion.forces().any()
    motion.launch(velocity=np.array([0.0, 0.0, 0.4]), angular_velocity=np.zeros(3))
    opened = motion.advance(motion.step)
    assert opened.force == 0
    assert motion.velocity[2] > 0.3999


def test_one_ball_and_a_still_bearing() -> None:
    passed = CageMotion(replace(CAGE, ball_count=1), begin="sudden", seed=3).advance(0.01)
    assert np.isfinite(passed.slip_power)
    still = replace(CAGE, ball_speed=0.0, orbit_speed=0.0, ring_speed=0.0, gravity=WEIGHTLESS)
    assert CageMotion(still, begin="whirl").advance(0.01).max_force == 0


def test_the_same_seed_gives_the_same_numbers() -> None:
    found = [CageMotion(CAGE, begin="sudden", seed=seed).advance(2e-3) for seed in (3, 3, 4)]
    assert found[0] == found[1]
    assert found[0] != found[2]


def test_both_shells_hold_a_ball_between_them() -> None:
    """Table 1's pocket: a cage that hangs in it touches each ball with both shells, across the axis."""
    cage = replace(CAGE, **TABLE_1)
    motion = CageMotion(cage, begin="rest")
    hanging = np.sqrt(2.98**2 - 0.14**2) * 1e-3
    np.testing.assert_allclose(np.linalg.norm(motion.centre), hanging, rtol=1e-4)  # the sag under its weight
    assert motion.forces().any()


def test_a_motion_that_comes_apart_says_when_and_how() -> None:
    motion = CageMotion(CAGE, begin="sudden", steps_per_contact=0.02)
    with pytest.raises(
        MotionError, match=r"came apart at .* s: centre at .* m, speed .* m/s, with a step of .* s\. Raise cage\.steps"
    ):
        motion.advance(1.0)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"begin": "sideways"}, 'start must be "rest", "ramp", "sudden" or "whirl"'),
        ({"begin": "ramp"}, "needs the time"),
        ({"begin": "rest", "steps_per_contact": 0.0}, "steps_per_contact must be positive"),
    ],
)
def test_what_cannot_be_is_refused(options: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        CageMotion(CAGE, **options)


def test_a_read_only_installation_without_a_home_compiles_each_time() -> None:
    show = """
import numba.core.caching
def refuse(*_): raise OSError(30, "Read-only file system")
for locator in [*numba.core.caching._CacheLocator.__subclasses__(), numba.core.caching._CacheLocator]:
    locator.ensure_cache_path = refuse
import analytic.cage.kernel
print(type(analytic.cage.kernel.advance).__name__)
"""
    assert subprocess.run([sys.executable, "-c", show], capture_output=True, check=True, text=True).stdout != ""


def test_no_compiler_is_loaded_before_the_first_motion() -> None:
    show = "import sys, analytic, analytic.torque, analytic.cage.motion; print('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", show], capture_output=True, check=True, text=True).stdout == "False\n"


def test_drag_takes_what_a_free_cage_loses() -> None:
    """In free flight, long enough to lose a tenth and too short to reach a ball."""
    cage = replace(CAGE, drag=0.1, gravity=WEIGHTLESS, axial_inertia=3e-6, friction_coefficient=0.0)
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array([0.11, -0.07, 0.05]), angular_velocity=np.array([0.0, 0.0, 1.7]))
    before, velocity = motion.kinetic_energy, motion.velocity
    passed = motion.advance(2e-6)
    assert passed.max_force == 0
    np.testing.assert_allclose(
        before - motion.kinetic_energy, passed.drag_power * passed.duration, rtol=0.02
    )  # one-sided sum
    decay = np.exp(-0.1 / cage.pitch_radius**2 / cage.mass * passed.duration)
    np.testing.assert_allclose(motion.velocity, velocity * decay, rtol=2e-3)  # second order in the step
