"""Ball kinematics against vectors: rigid bodies that do not slip at the centres of both contacts."""

import numpy as np
import pytest

from analytic.loads.kinematics import BallKinematics, ball_kinematics, outer_control_pitch
from tests.refusals import refuses

PITCH, BALL, ANGLE = 39.01e-3, 7.94e-3, 0.3031  # m, m, rad
AXIS = np.array([0.0, 0.0, 1.0])  # of the bearing; x radial through the ball's centre, y tangential


def kinematics(inner: float, outer: float, angle: float = ANGLE, outer_angle: float | None = None) -> BallKinematics:
    return ball_kinematics(
        inner_speed=inner,
        outer_speed=outer,
        inner_angle=angle,
        outer_angle=angle if outer_angle is None else outer_angle,
        pitch_diameter=PITCH,
        ball_diameter=BALL,
    )


@pytest.mark.parametrize(
    ("inner_angle", "outer_angle"), [(0.0, 0.0), (0.18, 0.18), (1.2, 1.2), (0.41, 0.12), (0.31, -0.02), (-0.5, -0.3)]
)
@pytest.mark.parametrize(("inner", "outer"), [(52.4, 0.0), (-31.0, 0.0), (0.0, 17.3), (23.0, -41.0)])
def test_nothing_slips_at_the_centres(inner: float, outer: float, inner_angle: float, outer_angle: float) -> None:
    """In the frame of the cage both surfaces have one velocity at each contact: what is left is roll and spin."""
    motion = kinematics(inner, outer, inner_angle, outer_angle)
    pitch = np.arctan2(np.sin(outer_angle), np.cos(outer_angle) + BALL / PITCH)  # of outer control
    axis = np.array([-np.sin(pitch), 0.0, np.cos(pitch)])
    ball = -np.sign(inner - outer) * np.linalg.norm(motion.ball_speed) * axis
    centre = np.array([PITCH / 2, 0.0, 0.0])
    rolling, spin = [], []
    rings = [(inner, -1, motion.inner_radius, inner_angle), (outer, 1, motion.outer_radius, outer_angle)]
    for speed, side, radius, angle in rings:
        normal = np.array([np.cos(angle), 0.0, np.sin(angle)])  # outwards
        across = np.array([-np.sin(angle), 0.0, np.cos(angle)])
        contact = centre + side * BALL / 2 * normal
        np.testing.assert_allclose(np.hypot(*contact[:2]), radius, rtol=1e-14)  # round-off
        ring = (speed - motion.cage_speed) * AXIS
        velocity = np.cross(ring, contact)
        # round-off of speeds up to 1 m/s that nearly cancel
        np.testing.assert_allclose(velocity, np.cross(ball, contact - centre), atol=1e-14)
        entrainment = motion.entrainment_speed[0 if side < 0 else 1]
        np.testing.assert_allclose(np.linalg.norm(velocity), np.abs(entrainment), rtol=1e-13)
        rolling.append(-(ball - ring) @ across * side)
        spin.append((ring - ball) @ normal)
    expected = motion.inner_rolling_rate, motion.outer_rolling_rate
    np.testing.assert_allclose(np.abs(rolling), np.abs(expected), rtol=1e-13)  # round-off
    np.testing.assert_allclose(spin[0] - spin[1], motion.spin_difference, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(spin[1], 0.0, atol=1e-12)  # outer control; round-off of rates of some 100 rad/s


def test_bad_input_is_refused() -> None:
    good = {"inner_speed": 52.4, "inner_angle": ANGLE, "outer_angle": 0.28, "pitch_diameter": PITCH}

    def kinematics(**changed: float) -> object:
        return ball_kinematics(**({"ball_diameter": BALL} | good | changed))

    refuses(kinematics, inner_speed=float("nan"), outer_speed=float("inf"), inner_angle=18.0, outer_angle=-18.0)
    refuses(kinematics, outer_angle=float("nan"), ball_diameter=PITCH)


def test_a_ball_that_lies_steep_on_its_inner_race_still_turns() -> None:
    """Its axis stays 0.01 rad short of a right angle to the way it rolls there; below that outer control is free."""
    ratio = BALL / PITCH
    for inner, outer in ((1.38, -0.2), (-1.38, 0.2)):
        free = np.arctan2(np.sin(outer), np.cos(outer) + ratio)
        assert abs(inner - free) < np.pi / 2 - 0.01
        np.testing.assert_allclose(outer_control_pitch(inner, outer, ratio), free, rtol=1e-14)
    for inner, outer, expected in ((1.5, -0.4, 1.5 - np.pi / 2 + 0.01), (-1.5, 0.4, -1.5 + np.pi / 2 - 0.01)):
        np.testing.assert_allclose(outer_control_pitch(inner, outer, ratio), expected, rtol=1e-12)  # a difference


def test_angles_up_to_a_right_one_are_taken() -> None:
    """At which both races run on the pitch circle."""
    found = kinematics(52.4, 0.0, np.pi / 2)
    np.testing.assert_allclose([found.inner_radius, found.outer_radius], PITCH / 2, rtol=1e-12)
    np.testing.assert_allclose(found.cage_speed, 26.2, rtol=1e-12)
    good = {"inner_speed": 3.0, "inner_angle": 0.1, "outer_angle": 0.1, "pitch_diameter": PITCH, "ball_diameter": BALL}
    refuses(
        lambda **wrong: ball_kinematics(**good | wrong), inner_angle=1.5709, outer_angle=-1.5709, pitch_diameter=BALL
    )
