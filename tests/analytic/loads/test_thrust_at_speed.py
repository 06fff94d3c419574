"""Balls alike at speed against the ring's equilibrium, the forces on one ball, and the limits of low and high speed."""

from dataclasses import replace

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.contact.factors import ContactCorrection, ContactFactors, correction_fields, correction_of
from analytic.errors import InputError
from analytic.loads.balls import LoadEffects, thrust_balls
from analytic.loads.kinematics import ball_kinematics, ruled_motion
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import ThrustAtSpeed, thrust_at_speed, thrust_equilibrium
from analytic.loads.thrust_ball import first_contacts, thrust_point
from analytic.loads.turning import RuledTurning, TurningRule
from analytic.scene import Bearing, ContactAngle, Operation
from tests.analytic.specimens import with_clearance

SOLVED = ContactAngle(rule="solved")
FIELDS = "inner_load", "outer_load", "inner_angle", "outer_angle"


def assert_at_rest(balls: ThrustAtSpeed, bearing: Bearing, load: float, speed: float) -> None:
    """One ball: forces along the axis and outward, moment about its centre, springs, and the grooves' distance."""
    r, al_i, al_o = bearing.ball_radius, float(balls.inner_angle), float(balls.outer_angle)
    motion = ball_kinematics(
        inner_speed=speed,
        inner_angle=al_i,
        outer_angle=al_o,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    inertia = 2 / 5 * bearing.ball_mass * r**2
    pitch = np.arctan2(np.sin(al_o), np.cos(al_o) + 2 * r / bearing.pitch_diameter)  # of outer control
    moment = inertia * motion.ball_speed * motion.cage_speed * np.sin(pitch)
    normal = np.array([float(balls.inner_load), float(balls.outer_load)])
    friction = moment / r * normal / normal.sum()  # its moment about the centre, r (T_i + T_o), is the gyroscopic one
    outward = bearing.ball_mass * bearing.pitch_diameter / 2 * motion.cage_speed**2
    along = normal * np.sin([al_i, al_o]) + friction * np.cos([al_i, al_o])
    across = normal * np.cos([al_i, al_o]) - friction * np.sin([al_i, al_o])
    # Angles settle to 1e-10 or better; a preload, or friction against the moment, may be far above the load.
    np.testing.assert_allclose(along, load / bearing.ball_count, atol=1e-9 * normal.max())
    np.testing.assert_allclose(across[1] - across[0], outward, atol=1e-9 * normal.max())
    stretched = 0.0
    for groove, race, al, force in zip(
        (bearing.inner, bearing.outer), (balls.inner, balls.outer), (al_i, al_o), normal, strict=True
    ):
        assert race.stiffness * race.approach**1.5 == pytest.approx(force, rel=1e-12)  # round-off
        stretched += (groove.groove_radius - r + race.approach) * np.cos(al)
    radial = bearing.groove_centre_distance - bearing.diametral_clearance / 2
    assert stretched == pytest.approx(radial, abs=1e-15)  # m; round-off of 0.5 mm


@given(log_load=st.floats(0, 4), log_speed=st.floats(0, 3.6), clearance=st.floats(-30e-6, 60e-6))
def test_every_ball_is_at_rest(bearing_6205: Bearing, log_load: float, log_speed: float, clearance: float) -> None:
    bearing, load, speed = with_clearance(bearing_6205, clearance), 10.0**log_load, 10.0**log_speed
    assert_at_rest(thrust_at_speed(bearing, SOLVED, axial_load=load, inner_speed=speed), bearing, load, speed)


@pytest.mark.parametrize(("centrifugal", "gyroscopic"), [(True, True), (True, False), (False, True)])
@pytest.mark.parametrize("free", [0.18, None])
def test_balls_at_speed_are_those_of_the_ring(
    bearing_6205: Bearing, free: float | None, centrifugal: bool, gyroscopic: bool
) -> None:
    rule = ContactAngle(rule="solved", free=free)
    load = np.array([41.0, 230.0, 890.0, 2600.0])
    speed = np.array([-740.0, 320.0, 1900.0, 2700.0])
    factors = ContactFactors(approach=np.array([0.93, 0.97, 1.02, 1.01]), semi_axis_rolling=1.03)
    turning = RuledTurning(bearing=bearing_6205, inner_speed=speed, centrifugal=centrifugal, gyroscopic=gyroscopic)
    loaded = {"axial_load": load, "inner_speed": speed, "turning": turning}
    balls = thrust_at_speed(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=factors))
    each = replace(factors, approach=np.repeat(np.asarray(factors.approach)[:, None], bearing_6205.ball_count, axis=1))
    ring = ring_equilibrium(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=each))
    for name in FIELDS:
        # The ring stops at 1e-11 of its forces, some of which are hundreds of the light ball's.
        np.testing.assert_allclose(getattr(balls, name), getattr(ring, name)[:, 4], rtol=1e-8)
    np.testing.assert_allclose(balls.outer.semi_axis_x, ring.outer.semi_axis_x[:, 4], rtol=1e-8)
    np.testing.assert_allclose(balls.inner.approach, ring.inner.approach[:, 4], rtol=1e-8)


def test_one_point_in_numbers_gives_the_contacts_of_the_arrays(bearing_6205: Bearing) -> None:
    """From the load to both contacts of a ball, whose rates are those per unit ring speed."""
    operation = Operation(axial_load=np.array([430.0]), inner_speed=np.array([-910.0]))
    factors = ContactFactors(semi_axis_rolling=1.02, semi_axis_transverse=0.97, approach=0.94)
    correction = ContactCorrection(outer=factors)
    balls = thrust_balls(bearing_6205, SOLVED, operation, LoadEffects(gyroscopic=False), correction=correction)
    numbers, row = bearing_numbers(bearing_6205, SOLVED), np.array(correction_fields(correction), dtype=float)
    point = thrust_point(numbers, first_contacts(numbers), 430.0, TurningRule(-910.0, True, False), correction_of(row))
    angles = point.ball.inner_angle, point.ball.outer_angle
    motion = ruled_motion(numbers, 1.0, *angles)
    of_races = (
        (numbers.inner, point.inner, angles[0], point.ball.inner_load, motion.inner_rolling_rate),
        (numbers.outer, point.outer, angles[1], point.ball.outer_load, motion.outer_rolling_rate),
    )
    entrainments = motion.inner_entrainment, motion.outer_entrainment
    for race, (of_race, entrainment) in enumerate(zip(of_races, entrainments, strict=True)):
        found, expected = contact_under(*of_race, entrainment), balls.contacts[:-1]
        fields = [np.broadcast_to(field, (2, 1, 1))[race].item() for field in expected]
        np.testing.assert_allclose(found[:-1], fields, rtol=1e-13)  # round-off
        np.testing.assert_allclose(found.entrainment, balls.motion.entrainment_speed[race], rtol=1e-13)


def test_slow_balls_are_those_of_the_thrust_equilibrium(bearing_6205: Bearing) -> None:
    loads = 10.0 ** np.arange(-3, 7, 3)
    still = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads)
    for speed, centrifugal in ((0.0, True), (1e-7, True), (430.0, False)):
        turning = RuledTurning(
            bearing=bearing_6205, inner_speed=np.full(4, speed), centrifugal=centrifugal, gyroscopic=False
        )
        balls = thrust_at_speed(bearing_6205, SOLVED, axial_load=loads, inner_speed=speed, turning=turning)
        for name in FIELDS:
            expected = still.ball_load if name.endswith("load") else still.contact_angle
            np.testing.assert_allclose(getattr(balls, name), expected, rtol=1e-9)  # both settle to 1e-10


def test_a_ball_hangs_in_the_outer_race_at_the_highest_speed(bearing_6205: Bearing) -> None:
    """The outer race carries the centrifugal force alone, and the inner one lifts the ball by the play that is left."""
    turning = RuledTurning(bearing=bearing_6205, inner_speed=np.array([2.4e4]), centrifugal=True, gyroscopic=False)
    balls = thrust_at_speed(bearing_6205, SOLVED, axial_load=5.0, inner_speed=2.4e4, turning=turning)
    motion = ball_kinematics(
        inner_speed=2.4e4,
        inner_angle=balls.inner_angle,
        outer_angle=balls.outer_angle,
        pitch_diameter=bearing_6205.pitch_diameter,
        ball_diameter=bearing_6205.ball_diameter,
    )
    outward = bearing_6205.ball_mass * bearing_6205.pitch_diameter / 2 * motion.cage_speed**2
    assert balls.outer_load == pytest.approx(outward, rel=1e-3)  # Q_i cos al_i is 4e-4 of it
    assert balls.outer_angle < 1e-3 < 0.3 < balls.inner_angle


def test_loads_without_a_balance_are_refused(bearing_6205: Bearing) -> None:
    with pytest.raises(InputError, match="inner_speed"):
        thrust_at_speed(bearing_6205, SOLVED, axial_load=5.0, inner_speed=np.nan)
    with pytest.raises(InputError, match="axial_load"):
        thrust_at_speed(bearing_6205, SOLVED, axial_load=-5.0, inner_speed=100.0)
