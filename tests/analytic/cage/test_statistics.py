"""Statistics of a moving cage: states against closed forms, intervals against their definition."""

from dataclasses import replace
from functools import partial

import numpy as np

from analytic.cage.motion import CageMotion
from analytic.cage.statistics import measured_motion
from analytic.cage.steady import LandGuidance, hanging_torque
from tests.analytic.cage.specimens import CAGE, RATE, W
from tests.refusals import refused, refuses

POWERS = ("slip_power", "land_power", "drag_power", "damping_power")


def test_the_start_decides_between_rest_and_whirl() -> None:
    resting = measured_motion(CAGE, start="rest", seeds=2, duration=0.04)
    whirling = measured_motion(CAGE, start="whirl", seeds=2, duration=0.04)
    assert (resting.state, whirling.state) == ("rest", "whirl")
    assert resting.other is not None
    assert whirling.other is not None
    assert (resting.other.start, resting.other.state) == ("whirl", "whirl")
    assert (whirling.other.start, whirling.other.state) == ("rest", "rest")
    np.testing.assert_allclose(resting.other.torque, whirling.torque, rtol=0.02)
    closed = hanging_torque(0.1, CAGE.mass * 9.80665, RATE * 3.97e-3, 0.18)
    np.testing.assert_allclose([resting.torque, whirling.other.torque], closed, rtol=0.02)
    # It goes round by w_b r/nabla + w_c; friction in the pockets slips a little.
    np.testing.assert_allclose(whirling.whirl_speed, CAGE.ball_speed * 39.7 + CAGE.orbit_speed, rtol=0.02)
    assert abs(resting.whirl_speed) < 1e-3 * whirling.whirl_speed
    assert max(resting.wobble, whirling.wobble) < 0.1 * CAGE.half_clearance
    assert abs(resting.signed_moment) < 1e-2 * resting.torque


def test_the_wobble_is_that_of_the_distance_instant_by_instant() -> None:
    cage, distances = replace(CAGE, ball_lead=0.06e-3), []
    for seed in range(2):
        motion = CageMotion(cage, begin="whirl", seed=seed)
        motion.advance(0.01)
        distances.append([float(np.hypot(*motion.advance(0.01 / 400).place)) for _ in range(400)])
    statistics = measured_motion(cage, start="whirl", seeds=2, duration=0.01)
    # Steps are shared out among the instants otherwise than among the blocks, and the end differs a little.
    np.testing.assert_allclose(statistics.wobble, np.sqrt(np.mean(np.var(distances, axis=1))), rtol=0.05)


def test_a_swing_slower_than_a_block_is_not_rest() -> None:
    """Pocket of Table 1: a swing takes 0.11 s, a block 5 ms, and the cage falls from the middle."""
    statistics = measured_motion(
        replace(CAGE, half_clearance=2.98e-3, centre_offset=0.14e-3), start="sudden", seeds=2, duration=0.05
    )
    assert statistics.state == "irregular"
    assert max(statistics.block_maxima) > 10
    assert 0.1 * 2.98e-3 < statistics.wobble < 2.98e-3


def test_statistics_are_those_of_the_blocks() -> None:
    """Two seeds of an irregular motion with a land, run again block by block."""
    land = LandGuidance(radius=17e-3, half_clearance=0.06e-3, outside=False, speed=W, half_width=5e-3)
    cage = replace(CAGE, ball_lead=0.06e-3, land=land, drag=4e-6)
    statistics = measured_motion(cage, start="whirl", seeds=2, duration=0.01)
    blocks = []
    for seed in range(2):
        motion = CageMotion(cage, begin="whirl", seed=seed)
        motion.advance(0.01)
        blocks += [motion.advance(1e-3) for _ in range(10)]
    lost = {name: np.mean([getattr(block, name) for block in blocks]) / W for name in POWERS}
    assert min(lost.values()) > 0
    np.testing.assert_allclose(
        statistics.torque, lost["slip_power"] + lost["land_power"] + lost["drag_power"], rtol=1e-12
    )
    np.testing.assert_allclose(statistics.damping_torque, lost["damping_power"])
    np.testing.assert_allclose(statistics.signed_moment, np.mean([block.moment for block in blocks]), rtol=1e-12)
    largest = sorted(block.max_force for block in blocks)
    np.testing.assert_allclose(statistics.max_force, (largest[9] + largest[10]) / 2, rtol=1e-12)
    assert max(statistics.block_maxima) == largest[-1]
    np.testing.assert_allclose([statistics.block, statistics.duration], [1e-3, 0.02], rtol=1e-12)
    # Order statistics 6 and 15 of 20: fewer than 6 values are below the median with the probability 21700/2^20, 2.07 %.
    assert statistics.max_force_interval == (largest[5], largest[14])
    low, high = statistics.torque_interval
    seeds = [np.mean([b.slip_power + b.land_power + b.drag_power for b in blocks[k : k + 10]]) / W for k in (0, 10)]
    # Student's t for one degree of freedom
    np.testing.assert_allclose((high - low) / 2, 12.706 * abs(seeds[0] - seeds[1]) / 2, rtol=1e-4)


def test_another_start_is_tried_above_a_whirl_number_of_one() -> None:
    for number in (1.3, 0.8):
        surface = np.sqrt(number * 9.80665 * CAGE.half_clearance) / 3.97e-3
        cage = replace(CAGE, ball_speed=surface, orbit_speed=surface / RATE * 0.4, ring_speed=surface / RATE)
        assert (measured_motion(cage, start="rest", seeds=2, duration=8e-3).other is None) == (number < 1)


def test_different_states_of_seeds_are_mixed() -> None:
    """With such a lead of the balls some motions whirl on and others stop."""
    statistics = measured_motion(replace(CAGE, ball_lead=0.1e-3), start="sudden", seeds=3, duration=0.05)
    assert statistics.state == "mixed"
    assert statistics.torque_interval[1] - statistics.torque_interval[0] > statistics.torque


def test_impossible_input_is_refused() -> None:
    refused(lambda: measured_motion(replace(CAGE, ring_speed=0.0), start="rest", seeds=3), "ring_speed")
    refuses(partial(measured_motion, CAGE, start="rest"), seeds=1, duration=0.0)
    # sqrt(4 x 0.1 mm/g), and 0.2 mm at the 0.49 m/s of the balls' surfaces
    refused(lambda: measured_motion(CAGE, start="rest", duration=6.3e-3), "0.0063 s", "0.00639 s")
    weightless = replace(CAGE, gravity=(0.0, 0.0, 0.0))
    refused(lambda: measured_motion(weightless, start="rest", duration=4.0e-4), "0.000408 s")
