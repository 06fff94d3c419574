"""Balls and cage in motion together: invariants, limits in closed form, and the motion on given balls as a limit."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.cage.motion import CageMotion, MeanMotion
from analytic.cage.pocket import impact
from analytic.cage.raceways import Raceways
from analytic.cage.statistics import measured_motion
from analytic.contact.geometry import RACES
from analytic.errors import InputError
from tests.analytic.cage.specimens import WEIGHTLESS, W, cage_on, races_under, races_under_thrust
from tests.analytic.specimens import BEARING_6205
from tests.refusals import refused

FRICTIONLESS = 1e-30  # of the races; they refuse 0
THRUST = races_under_thrust()


def energy_error(steps_per_contact: float) -> float:
    """Share of the ring's work that neither losses nor kinetic energy account for, after a sudden start."""
    cage = cage_on(THRUST, gravity=WEIGHTLESS, restitution=0.6, drag=2e-6)
    motion = CageMotion(cage, THRUST, begin="sudden", seed=0, steps_per_contact=steps_per_contact)
    before, passages = motion.kinetic_energy, [motion.advance(4e-3)]
    while motion.forces().any():  # a pressed pocket holds energy that is not counted
        passages.append(motion.advance(motion.step))

    def joules(name: str) -> float:
        return sum(getattr(passage, name) * passage.duration for passage in passages)

    lost = sum(map(joules, ("race_power", "slip_power", "damping_power", "drag_power", "numerical_power")))
    assert max(passage.max_force for passage in passages) > 10  # N: it collided
    return (joules("ring_power") - lost - (motion.kinetic_energy - before)) / joules("ring_power")


def axial_momentum(motion: CageMotion) -> float:
    """Of balls and cage about the axis of the bearing, N m s."""
    cage, speeds = motion.cage, motion.ball_speeds
    (x, y, _), (vx, vy, _) = motion.centre, motion.velocity
    axial, transverse = cage.inertia
    axis, turning = motion.orientation[:, 2], motion.angular_velocity
    own = transverse * turning + (axial - transverse) * axis * (axis @ turning)
    of_balls = cage.pitch_radius * speeds[:, 0].sum() + 0.4 * cage.ball_radius * speeds[:, 3].sum()
    return BEARING_6205.ball_mass * of_balls + cage.mass * (x * vy - y * vx) + own[2]


def measured(
    cage: Any, races: Raceways, begin: Any, *, after: float, during: float, steps: float = 40, seed: int = 0
) -> MeanMotion:
    motion = CageMotion(cage, races, begin=begin, seed=seed, steps_per_contact=steps)
    motion.advance(after)
    return motion.advance(during)


def test_without_traction_of_the_races_momentum_about_the_axis_is_constant() -> None:
    races = races_under_thrust(friction=FRICTIONLESS)
    motion = CageMotion(cage_on(races, gravity=WEIGHTLESS), races, begin="sudden", seed=0)
    before = axial_momentum(motion)
    passed = motion.advance(9e-3)
    assert passed.max_force > 10
    while motion.forces().any():  # half a step of a force is the cage's already and not yet the ball's
        motion.advance(motion.step)
    np.testing.assert_allclose(axial_momentum(motion), before, rtol=1e-12)  # round-off of 40 000 steps
    assert abs(passed.ring_power) < 1e-20 * passed.slip_power


def test_the_work_of_the_ring_is_losses_and_kinetic_energy() -> None:
    errors = [abs(energy_error(steps)) for steps in (40, 80)]
    assert errors[0] < 1.5e-3
    assert errors[1] < 0.6 * errors[0]  # first order, and impacts at other times


@pytest.mark.parametrize("begin", ["rest", "whirl"])
def test_firm_races_make_it_the_motion_on_given_balls(begin: Any) -> None:
    """A cage under its weight or in a whirl at 500 rpm uses little of what the races can bear at 1000 N."""
    cage = cage_on(THRUST)
    given = CageMotion(cage, begin=begin, seed=0)
    given.advance(0.01)
    expected, free = given.advance(0.02), measured(cage, THRUST, begin, after=0.01, during=0.02)
    # The balls slip by creep, and where their contact surface is hollow they turn 1 % faster than rigid ones.
    np.testing.assert_allclose([free.slip_power, free.force], [expected.slip_power, expected.force], rtol=0.03)
    np.testing.assert_allclose(free.force, 0.0642 if begin == "rest" else 16.16, rtol=0.01)  # of another program
    assert free.grip < 0.1
    assert abs(free.race_power - free.alone_power) < 0.05 * free.slip_power


def test_balls_and_cage_at_one_speed_never_touch() -> None:
    motion = CageMotion(cage_on(THRUST, gravity=WEIGHTLESS), THRUST, begin="rest")
    passed = motion.advance(0.01)
    assert passed.max_force == 0
    np.testing.assert_allclose(motion.offsets, 0, atol=1e-11)  # round-off of sums of 45 000 steps
    np.testing.assert_allclose(motion.ball_angle, THRUST.alone.orbit_speed * passed.duration, rtol=1e-9)
    np.testing.assert_allclose(motion.ball_angles - motion.ball_angle, 2 * np.pi / 9 * np.arange(9), atol=1e-9)
    np.testing.assert_allclose(passed.race_power, passed.alone_power, rtol=1e-9)
    np.testing.assert_allclose(passed.ring_power, passed.race_power, rtol=1e-9)
    np.testing.assert_allclose(9 * THRUST.alone.slip_power, passed.alone_power, rtol=1e-12)


@pytest.mark.parametrize(("loads", "race"), [((372.0, 180.0), 1), ((200.0, 372.0), 0)])
def test_a_cage_brakes_a_ball_up_to_the_grip_of_its_races(loads: tuple[float, float], race: int) -> None:
    """N = min(2 mu Q_i/(1 + mu_c), 2 mu Q_o/(1 - mu_c)): both races share N, and the friction in the pocket.

    That friction also presses the ball inward with mu_c N, which loads the inner race and relieves the outer one.
    """
    friction, pocket = 0.05, 0.3
    races = races_under(loads, (0.303, 0.303), inner_speed=W, friction=friction)
    cage = cage_on(races, friction=pocket, gravity=WEIGHTLESS, drag=0.5)  # so much that all balls slide
    passed = measured(cage, races, "rest", after=0.02, during=0.01, steps=10)
    sign = -1 if race else 1
    pressed = races.table[0][RACES[race]]["load_by_radial"] * -pocket  # per force of the pocket
    limit = 2 * friction * loads[race] / (1 + sign * pocket - 2 * friction * pressed)
    np.testing.assert_allclose(passed.force / 9, limit, rtol=5e-3)  # the ball's axis leans, so its friction does
    assert passed.grip > 0.999
    assert abs(2 * friction * loads[race] / (1 + sign * pocket) / limit - 1) > 8e-3  # with the loads at rest


def test_running_backwards_is_the_mirror_image() -> None:
    """The bearing is mirrored in y; gravity is along -x."""
    results = []
    for sign in (1, -1):
        races = replace(THRUST, inner_speed=sign * W)
        cage = cage_on(races, gravity=(-9.80665, 0.0, 0.0))
        motion = CageMotion(cage, races, begin="sudden")
        motion.launch(velocity=np.array([0.11, sign * 0.2, 0.05]), angular_velocity=np.array([sign * 3.0, 4.0, 0.0]))
        results.append((motion.advance(1e-3), motion.centre * [1, sign, 1]))
    (ahead, there), (back, mirrored) = results
    assert ahead.max_force > 1
    np.testing.assert_allclose(mirrored, there, atol=1e-4 * 0.1e-3)  # Newton's last change grows with every impact
    np.testing.assert_allclose([back.slip_power, -back.moment], [ahead.slip_power, ahead.moment], rtol=1e-4)


def test_statistics_take_free_balls_too() -> None:
    """What the races lose more than without a cage, in the blocks of both seeds."""
    cage = cage_on(THRUST)
    statistics = measured_motion(cage, races=THRUST, start="whirl", seeds=2, duration=8e-3, steps_per_contact=20)
    blocks = []
    for seed in range(2):
        motion = CageMotion(cage, THRUST, begin="whirl", seed=seed, steps_per_contact=20)
        motion.advance(8e-3)
        blocks += [motion.advance(8e-4) for _ in range(10)]
    excess = np.mean([block.race_power - block.alone_power for block in blocks]) / cage.ring_speed
    np.testing.assert_allclose(statistics.race_excess_torque, excess, rtol=1e-9)
    low, high = statistics.race_excess_interval
    assert low <= statistics.race_excess_torque <= high


def test_impossible_input_is_refused() -> None:
    for change in ({"ring_speed": 50.0}, {"ball_lead": 2e-5}):
        (name,) = change
        refused(lambda: CageMotion(cage_on(THRUST, **change), THRUST, begin="rest"), f"{change[name]:g}")  # noqa: B023
    refused(lambda: CageMotion(cage_on(THRUST), THRUST, begin="rest", steps_per_contact=9.0), "steps_per_contact = 9.0")
    refused(lambda: CageMotion(cage_on(THRUST), THRUST, begin="sideways"), "start")  # pyright: ignore[reportArgumentType]


def test_the_step_is_a_share_of_an_impact_of_a_free_ball_and_its_share_of_the_cage() -> None:
    cage = cage_on(THRUST)
    hit = impact(
        mass=1 / (cage.ball_count / cage.mass + 1 / BEARING_6205.ball_mass),
        speed=cage.impact_speed,
        stiffness=cage.stiffness,
    )
    motion = CageMotion(cage, THRUST, begin="sudden", steps_per_contact=37)
    assert 37 * motion.step == pytest.approx(hit.duration, rel=1e-12)
    assert hit.duration < 0.9 * cage.contact_time  # both give way


def test_an_impact_too_hard_for_the_steps_is_refused() -> None:
    motion = CageMotion(cage_on(THRUST, gravity=WEIGHTLESS), THRUST, begin="sudden", steps_per_contact=10)
    motion.launch(velocity=np.array([90.0, 0.0, 0.0]), angular_velocity=np.zeros(3))
    with pytest.raises(InputError, match=r"an impact of .* N had .* steps: .* raise cage\.steps_per_contact .* times"):
        motion.advance(1e-5)
