"""Ball kinematics against vectors: rigid bodies that do not slip at the centres of both contacts."""

import numpy as np
import pytest

from analytic.loads.kinematics import ball_kinematics, outer_control_pitch

PITCH, BALL = 39.01e-3, 7.94e-3  # m
AXIS = np.array([0.0, 0.0, 1.0])  # of the bearing; x radial through the ball's centre, y tangential


@pytest.mark.parametrize(
    ("inner_angle", "outer_angle"),
    [(0.0, 0.0), (0.18, 0.18), (1.2, 1.2), (np.pi / 2, np.pi / 2), (0.41, 0.12), (0.31, -0.02), (-0.5, -0.3)],
)
@pytest.mark.parametrize("inner", [52.4, -31.0])
def test_nothing_slips_at_the_centres(inner: float, inner_angle: float, outer_angle: float) -> None:
    """In the frame of the cage both surfaces have one velocity at each contact: what is left is roll and spin."""
    motion = ball_kinematics(inner, inner_angle, outer_angle, PITCH, BALL)
    pitch = np.arctan2(np.sin(outer_angle), np.cos(outer_angle) + BALL / PITCH)  # of outer control
    axis = np.array([-np.sin(pitch), 0.0, np.cos(pitch)])
    ball = -np.sign(inner) * np.linalg.norm(motion.ball_speed) * axis
    centre = np.array([PITCH / 2, 0.0, 0.0])
    rolling, spin = [], []
    rings = [(inner, -1, motion.inner_radius, inner_angle), (0.0, 1, motion.outer_radius, outer_angle)]
    for speed, side, radius, angle in rings:
        normal = np.array([np.cos(angle), 0.0, np.sin(angle)])  # outwards
        across = np.array([-np.sin(angle), 0.0, np.cos(angle)])
        contact = centre + side * BALL / 2 * normal
        np.testing.assert_allclose(np.hypot(*contact[:2]), radius, rtol=1e-14)  # round-off
        ring = (speed - motion.cage_speed) * AXIS
        velocity = np.cross(ring, contact)
        # round-off of speeds up to 1 m/s that nearly cancel
        np.testing.assert_allclose(velocity, np.cross(ball, contact - centre), atol=1e-14)
        entrainment = motion.inner_entrainment if side < 0 else motion.outer_entrainment
        np.testing.assert_allclose(np.linalg.norm(velocity), np.abs(entrainment), rtol=1e-13)
        rolling.append(-(ball - ring) @ across * side)
        spin.append((ring - ball) @ normal)
    expected = motion.inner_rolling_rate, motion.outer_rolling_rate
    np.testing.assert_allclose(np.abs(rolling), np.abs(expected), rtol=1e-13)  # round-off
    np.testing.assert_allclose(spin[0] - spin[1], motion.spin_difference, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(spin[1], 0.0, atol=1e-12)  # outer control; round-off of rates of some 100 rad/s


def test_a_ball_that_lies_steep_on_its_inner_race_still_turns() -> None:
    """Its axis stays 0.01 rad short of a right angle to the way it rolls there; below that outer control is free."""
    ratio = BALL / PITCH
    for inner, outer in ((1.38, -0.2), (-1.38, 0.2)):
        free = np.arctan2(np.sin(outer), np.cos(outer) + ratio)
        assert abs(inner - free) < np.pi / 2 - 0.01
        np.testing.assert_allclose(outer_control_pitch(inner, outer, ratio), free, rtol=1e-14)
    for inner, outer, expected in ((1.5, -0.4, 1.5 - np.pi / 2 + 0.01), (-1.5, 0.4, -1.5 + np.pi / 2 - 0.01)):
        np.testing.assert_allclose(outer_control_pitch(inner, outer, ratio), expected, rtol=1e-12)  # a difference
