"""Bounds of the cage against what defines them, and numbers computed elsewhere."""

import numpy as np
import pytest

from analytic.effects.bounds import cage_rest_torque, whirl_number
from analytic.errors import InputError
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.scene import Bearing


def motion(bearing: Bearing, rpm: float) -> BallKinematics:
    return ball_kinematics(
        inner_speed=rpm * 2 * np.pi / 60,
        inner_angle=0.18,
        outer_angle=0.18,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )


def test_a_whirling_cage_against_its_weight() -> None:
    """The cage's centre goes round with the radius nabla at w_b r/nabla: its centrifugal force over its weight."""
    ball_speed, nabla, mass, gravity = 123.0, 0.17e-3 / 2, 6.58e-3, 9.5
    turns = ball_speed * 3.97e-3 / nabla
    found = whirl_number(ball_speed=ball_speed, ball_radius=3.97e-3, clearance=2 * nabla, gravity=gravity)
    np.testing.assert_allclose(found, mass * turns**2 * nabla / (mass * gravity), rtol=1e-13)  # round-off
    on_earth = whirl_number(ball_speed=ball_speed, ball_radius=3.97e-3, clearance=2 * nabla)
    np.testing.assert_allclose(on_earth * 9.80665, found * gravity, rtol=1e-13)


def test_a_resting_cage_computed_elsewhere(bearing_6205: Bearing) -> None:
    found = cage_rest_torque(
        friction_coefficient=0.1, cage_mass=6.58e-3, ball_rate=motion(bearing_6205, 30 / np.pi).ball_speed,
        ball_radius=3.97e-3,
    )  # fmt: skip
    np.testing.assert_allclose(found * 1e3, 0.0604, atol=0.5e-4)  # N mm, the last digit given
    heavy = cage_rest_torque(
        friction_coefficient=0.1, cage_mass=6.58e-3, ball_rate=2.36, ball_radius=3.97e-3, gravity=[0.0, 19.6]
    )
    np.testing.assert_allclose(heavy, [0.0, 0.1 * 6.58e-3 * 19.6 * 2.36 * 3.97e-3], rtol=1e-13)


def test_nothing_opposed_is_infinite_and_nothing_at_all_is_nothing() -> None:
    np.testing.assert_array_equal(whirl_number(ball_speed=[0.0, 7.0], ball_radius=4e-3, clearance=2e-4, gravity=0.0),
                                  [0.0, np.inf])  # fmt: skip


def test_nonsense_is_refused() -> None:
    with pytest.raises(InputError, match="clearance must be positive"):
        whirl_number(ball_speed=3.0, ball_radius=4e-3, clearance=0.0)
    with pytest.raises(InputError, match="cage_mass must be at least 0"):
        cage_rest_torque(friction_coefficient=0.1, cage_mass=np.nan, ball_rate=2.0, ball_radius=4e-3)
