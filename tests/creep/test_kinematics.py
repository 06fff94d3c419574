"""Slip of rigid bodies against velocities of their points, by vectors in the axes of the bearing."""

import numpy as np
import pytest

from analytic.scene import Array
from fembearing.creep.kinematics import RaceMotion, RigidSlip, rigid_slip

R, SURFACE, ORBIT, ANGLE = 3.97e-3, 4.05e-3, 19.6e-3, 0.31  # m; rad
RACES = [pytest.param(-1.0, id="inner"), pytest.param(1.0, id="outer")]
# r_m w_c, then r w along the orbit, outward and along the axis, m; the second ball goes round the other way
VELOCITIES = [np.array([7.9e-3, 0.3e-3, 2.1e-3, -9.2e-3]), np.array([-6.1e-3, -0.7e-3, 1.3e-3, 11.4e-3])]


def motion(sign: float) -> RaceMotion:
    return RaceMotion(sign=sign, ball_radius=R, surface_radius=SURFACE)


def slip(sign: float, velocity: Array) -> RigidSlip:
    return rigid_slip(motion(sign), ANGLE, ORBIT, velocity)


def frame(sign: float) -> tuple[Array, Array]:
    """n out of the ball and t across the groove: radial, along the orbit, axial."""
    n = sign * np.array([np.cos(ANGLE), 0.0, np.sin(ANGLE)])
    return n, np.array([-n[2], 0.0, n[0]])


def surfaces(sign: float, velocity: Array, x: float, y: float) -> tuple[Array, Array]:
    """Velocities of ball and race at a point, x along the orbit; the inner ring turns with 1, the outer one rests."""
    (n, t), turn = frame(sign), np.array([velocity[2], velocity[1], velocity[3]]) / R
    place = (R - y**2 / 2 / SURFACE) * n + y * t + np.array([0.0, x, 0.0])
    ring = np.array([0.0, 0.0, 1.0 if sign < 0 else 0.0])
    ball = np.array([0.0, velocity[0], 0.0]) + np.cross(turn, place)
    return ball, np.cross(ring, np.array([ORBIT, 0.0, 0.0]) + place)


@pytest.mark.parametrize("sign", RACES)
@pytest.mark.parametrize("velocity", VELOCITIES)
def test_slip_is_the_balls_velocity_less_that_of_its_race(sign: float, velocity: Array) -> None:
    found, (n, t) = slip(sign, velocity), frame(sign)
    for x, y in ((0.0, 0.0), (0.11e-3, -0.83e-3), (-0.07e-3, 0.42e-3)):
        ball, race = surfaces(sign, velocity, x, y)
        given, ahead = found.creepages, found.side * x  # x of the contact points to its leading edge
        along = given.along + given.along_bend * y**2 - given.spin * y
        across = given.across + (given.spin - 2 * given.along_bend * y) * ahead
        # That vector across the surface is longer than 1, by which a turn about the orbit would seem to slide more.
        sideways = (ball - race) @ (t - y / SURFACE * n) + velocity[1] / R * y**2 / 2 / SURFACE
        expected = (ball - race) @ np.array([0.0, found.side, 0.0]), sideways
        np.testing.assert_allclose(np.array([along, across]) * found.rolling_speed, expected, atol=1e-15)  # round-off


@pytest.mark.parametrize("sign", RACES)
@pytest.mark.parametrize("velocity", VELOCITIES)
def test_rolling_speed_is_the_mean_of_both_surfaces_through_the_contact(sign: float, velocity: Array) -> None:
    """The contact goes round with the ball's centre, and its leading edge is where no surface goes."""
    found = slip(sign, velocity)
    contact = np.cross([0.0, 0.0, velocity[0] / ORBIT], np.array([ORBIT, 0.0, 0.0]) + R * frame(sign)[0])
    through = (np.mean(surfaces(sign, velocity, 0.0, 0.0), axis=0) - contact)[1]
    assert found.rolling_speed == pytest.approx(abs(through), rel=1e-12)  # round-off
    assert found.side == -np.sign(through)


@pytest.mark.parametrize("sign", RACES)
def test_rates_are_derivatives_of_slip_by_the_balls_velocity(sign: float) -> None:
    velocity = VELOCITIES[0]
    found = slip(sign, velocity)
    for number in range(4):
        step = 1e-5 * np.eye(4)[number]  # m: slip times its speed is linear, so that a large one is exact
        there, back = (slip(sign, velocity + each) for each in (step, -step))
        change = (
            np.array(there.creepages) * there.rolling_speed - np.array(back.creepages) * back.rolling_speed
        ) / 2e-5
        np.testing.assert_allclose(found.rates[:, number], change, rtol=1e-8, atol=1e-9)  # round-off
