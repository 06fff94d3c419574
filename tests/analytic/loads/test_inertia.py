"""Inertia of a ball against what defines it: its orbit, its angular momentum, and numbers of another calculation."""

import numpy as np
import pytest
from scipy.integrate import quad

from analytic.errors import InputError
from analytic.loads.inertia import centrifugal_ratio, gyroscopic_moment, gyroscopic_pull, inertia_ratios
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.turning import RuledTurning
from analytic.scene import Bearing, ContactAngle

BALL = {"ball_mass": 2.04e-3, "ball_radius": 3.97e-3}
LOAD = 620.63  # N, at mu = 0.05 and b = 1.1222 mm


def motion(bearing: Bearing, rpm: float) -> BallKinematics:
    return ball_kinematics(
        inner_speed=rpm * 2 * np.pi / 60,
        inner_angle=0.18,
        outer_angle=0.18,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )


def test_the_centrifugal_force_is_that_of_a_circle() -> None:
    """Mass times the second difference of a point on its orbit, over the load."""
    step, speed, orbit = 1e-4, 37.0, 19.5e-3
    places = orbit * np.exp(1j * speed * step * np.array([-1, 0, 1]))
    force = 2.04e-3 * abs(places[0] - 2 * places[1] + places[2]) / step**2
    ratio = centrifugal_ratio(ball_mass=2.04e-3, pitch_diameter=2 * orbit, cage_speed=speed, load=613.0)
    np.testing.assert_allclose(ratio * 613.0, force, rtol=1e-5)  # (w dt)^2/12 of the second difference


def test_the_gyroscopic_moment_is_the_change_of_angular_momentum() -> None:
    """An angular momentum at the angle al to the axis, carried round by the cage; J by discs of a solid sphere."""
    spin, orbit, angle, step = 123.0, 21.0, 0.37, 1e-5
    radius, mass = BALL["ball_radius"], BALL["ball_mass"]
    discs, _ = quad(lambda z: np.pi / 2 * (radius**2 - z**2) ** 2, -radius, radius, epsabs=0)  # discs across the axis
    inertia = mass / (4 / 3 * np.pi * radius**3) * discs
    turned = np.exp(1j * orbit * step * np.array([-0.5, 0.5])) * inertia * spin * np.sin(angle)  # the part across
    moment = abs(turned[1] - turned[0]) / step
    found = gyroscopic_moment(
        ball_mass=mass, ball_diameter=2 * radius, ball_speed=spin, cage_speed=orbit, axis_angle=angle
    )
    np.testing.assert_allclose(found, moment, rtol=1e-8)  # round-off of the difference


def test_the_gyroscopic_pull_is_what_the_ring_feels(bearing_6205: Bearing) -> None:
    """The races share the friction that holds the moment: the normal force of the inner one loses half of the pull."""
    rule, speed = ContactAngle(rule="solved", free=0.21), 700.0
    still = ring_equilibrium(bearing_6205, rule, axial_load=310.0)
    gyroscopic = RuledTurning(bearing=bearing_6205, inner_speed=np.array([speed]), centrifugal=False, gyroscopic=True)
    turning = ring_equilibrium(bearing_6205, rule, axial_load=310.0, inner_speed=speed, turning=gyroscopic)
    angle, load = float(still.inner_angle[0]), float(still.inner_load[0])
    moving = ball_kinematics(
        inner_speed=speed, inner_angle=angle, outer_angle=angle, pitch_diameter=39.01e-3, ball_diameter=7.94e-3
    )
    pull = gyroscopic_pull(
        **BALL, ball_speed=moving.ball_speed, cage_speed=moving.cage_speed, contact_angle=angle, load=load
    )
    thrust, before = (ring.inner_load[0] * np.sin(ring.inner_angle[0]) for ring in (turning, still))
    # At outer control the ball's axis leans less than the contact angle, and the moment is less by the ratio of sines.
    leans = np.sin(np.arctan2(np.sin(angle), np.cos(angle) + 7.94 / 39.01)) / np.sin(angle)
    np.testing.assert_allclose(1 - thrust / before, pull / 2 * leans, rtol=2e-3)  # angle and speeds follow by as much
    with pytest.raises(InputError, match="contact_angle must be at least 0"):
        gyroscopic_pull(**BALL, ball_speed=3.0, cage_speed=2.0, contact_angle=-0.1, load=5.0)


def test_ratios_of_a_bearing_do_not_depend_on_the_direction_of_rotation(bearing_6205: Bearing) -> None:
    angle, load = np.array([0.18, 0.18]), np.array([LOAD, LOAD])
    turned = inertia_ratios(bearing_6205, inner_speed=np.array([310.0, -310.0]), contact_angle=angle, load=load)
    moving = motion(bearing_6205, 310.0 * 30 / np.pi)
    speeds = {"ball_speed": moving.ball_speed, "cage_speed": moving.cage_speed}
    pull = gyroscopic_pull(**BALL, **speeds, contact_angle=0.18, load=LOAD)
    centrifugal = centrifugal_ratio(ball_mass=2.04e-3, pitch_diameter=39.01e-3, cage_speed=moving.cage_speed, load=LOAD)
    for values, expected in zip(turned, (centrifugal, pull), strict=True):
        np.testing.assert_allclose(values, expected, rtol=1e-12)  # round-off


def test_a_force_without_load_is_infinite_and_no_force_is_nothing() -> None:
    speeds = {"pitch_diameter": 39e-3, "cage_speed": [0.0, 21.0]}
    np.testing.assert_array_equal(centrifugal_ratio(ball_mass=2e-3, load=0.0, **speeds), [0.0, np.inf])


def test_impossible_arguments_are_refused() -> None:
    with pytest.raises(InputError, match="load must be at least 0"):
        centrifugal_ratio(ball_mass=2e-3, pitch_diameter=39e-3, cage_speed=3.0, load=-1.0)
