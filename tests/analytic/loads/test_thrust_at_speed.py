"""Balls alike at speed against the ring's equilibrium, the forces on one ball, and the limits of low and high speed."""

from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.errors import InputError
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium
from analytic.loads.turning import Inertia
from analytic.numerics.records import Records
from analytic.scene import Bearing, ContactAngle
from tests.analytic.specimens import loaded_contacts, with_clearance

SOLVED = ContactAngle(rule="solved")


def assert_at_rest(balls: Records, bearing: Bearing, load: float, speed: float) -> None:
    """One ball: forces along the axis and outward, moment about its centre, springs, and the grooves' distance."""
    (al_i, al_o), normal, r = balls["angle"].tolist(), balls["load"], bearing.ball_radius
    motion = ball_kinematics(speed, al_i, al_o, bearing.pitch_diameter, bearing.ball_diameter)
    inertia = 2 / 5 * bearing.ball_mass * r**2
    pitch = np.arctan2(np.sin(al_o), np.cos(al_o) + 2 * r / bearing.pitch_diameter)  # of outer control
    moment = inertia * motion.ball_speed * motion.cage_speed * np.sin(pitch)
    friction = moment / r * normal / normal.sum()  # its moment about the centre, r (T_i + T_o), is the gyroscopic one
    outward = bearing.ball_mass * bearing.pitch_diameter / 2 * motion.cage_speed**2
    along = normal * np.sin([al_i, al_o]) + friction * np.cos([al_i, al_o])
    across = normal * np.cos([al_i, al_o]) - friction * np.sin([al_i, al_o])
    # Angles settle to 1e-10 or better; a preload, or friction against the moment, may be far above the load.
    np.testing.assert_allclose(along, load / bearing.ball_count, atol=1e-9 * normal.max())
    np.testing.assert_allclose(across[1] - across[0], outward, atol=1e-9 * normal.max())
    stretched = 0.0
    for groove, race, al, force in zip(
        (bearing.inner, bearing.outer), loaded_contacts(balls), (al_i, al_o), normal, strict=True
    ):
        assert race.stiffness * race.approach**1.5 == pytest.approx(force, rel=1e-12)  # round-off
        stretched += (groove.groove_radius - r + race.approach) * np.cos(al)
    radial = bearing.groove_centre_distance - bearing.diametral_clearance / 2
    assert stretched == pytest.approx(radial, abs=1e-15)  # m; round-off of 0.5 mm


@given(log_load=st.floats(0, 4), log_speed=st.floats(0, 3.6), clearance=st.floats(-30e-6, 60e-6))
def test_every_ball_is_at_rest(bearing_6205: Bearing, log_load: float, log_speed: float, clearance: float) -> None:
    bearing, load, speed = with_clearance(bearing_6205, clearance), 10.0**log_load, 10.0**log_speed
    assert_at_rest(thrust_equilibrium(bearing, SOLVED, axial_load=load, inner_speed=speed), bearing, load, speed)


@pytest.mark.parametrize(("centrifugal", "gyroscopic"), [(True, True), (True, False), (False, True)])
@pytest.mark.parametrize("free", [0.18, None])
def test_balls_at_speed_are_those_of_the_ring(
    bearing_6205: Bearing, free: float | None, centrifugal: bool, gyroscopic: bool
) -> None:
    rule = ContactAngle(rule="solved", free=free)
    load = np.array([41.0, 230.0, 890.0, 2600.0])
    speed = np.array([-740.0, 320.0, 1900.0, 2700.0])
    factors = ContactFactors(approach=np.array([0.93, 0.97, 1.02, 1.01]), semi_axis_rolling=1.03)
    loaded: dict[str, Any] = {"axial_load": load, "inner_speed": speed, "inertia": Inertia(centrifugal, gyroscopic)}
    balls = thrust_equilibrium(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=factors))
    each = factors._replace(approach=np.repeat(np.asarray(factors.approach)[:, None], bearing_6205.ball_count, axis=1))
    ring = ring_equilibrium(bearing_6205, rule, **loaded, correction=ContactCorrection(outer=each))
    for name in ("load", "angle"):
        # The ring stops at 1e-11 of its forces, some of which are hundreds of the light ball's.
        np.testing.assert_allclose(balls[name], ring.balls[name][:, 4], rtol=1e-8)
    np.testing.assert_allclose(approaches(balls), approaches(ring.balls)[:, 4], rtol=1e-8)


def test_slow_balls_are_those_of_the_thrust_equilibrium(bearing_6205: Bearing) -> None:
    loads = 10.0 ** np.arange(-3, 7, 3)
    still = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads)
    for speed, centrifugal in ((0.0, True), (1e-7, True), (430.0, False)):
        inertia = Inertia(centrifugal, gyroscopic=False)
        balls = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads, inner_speed=speed, inertia=inertia)
        for name in ("load", "angle"):
            np.testing.assert_allclose(balls[name], still[name], rtol=1e-9)  # both settle to 1e-10


def test_a_ball_hangs_in_the_outer_race_at_the_highest_speed(bearing_6205: Bearing) -> None:
    """The outer race carries the centrifugal force alone, and the inner one lifts the ball by the play that is left."""
    inertia = Inertia(gyroscopic=False)
    balls = thrust_equilibrium(bearing_6205, SOLVED, axial_load=5.0, inner_speed=2.4e4, inertia=inertia)
    inner, outer = balls["angle"].tolist()
    motion = ball_kinematics(2.4e4, inner, outer, bearing_6205.pitch_diameter, bearing_6205.ball_diameter)
    outward = bearing_6205.ball_mass * bearing_6205.pitch_diameter / 2 * motion.cage_speed**2
    assert balls["load"][1] == pytest.approx(outward, rel=1e-3)  # Q_i cos al_i is 4e-4 of it
    assert outer < 1e-3 < 0.3 < inner


def test_loads_without_a_balance_are_refused(bearing_6205: Bearing) -> None:
    with pytest.raises(InputError, match="inner_speed"):
        thrust_equilibrium(bearing_6205, SOLVED, axial_load=5.0, inner_speed=np.nan)
    with pytest.raises(InputError, match="axial_load"):
        thrust_equilibrium(bearing_6205, SOLVED, axial_load=-5.0, inner_speed=100.0)
