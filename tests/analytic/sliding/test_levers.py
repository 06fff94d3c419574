"""Creep numbers against values that were computed elsewhere, and their limits."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ellipe

from analytic.loads.balls import LoadEffects, thrust_balls
from analytic.scene import Bearing, ContactAngle, Operation
from analytic.sliding.levers import BELOW_FULL_SPIN, creep_numbers, long_ellipse_error


def test_the_creep_of_a_6205(bearing_6205: Bearing) -> None:
    """Under 1000 N at 0.18 rad and mu = 0.1 s_c/u is 0.0020845 inside and 0.0018872 outside."""
    operation = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([31.0])).as_series()
    still = LoadEffects(centrifugal=False, gyroscopic=False)
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.18), operation, still)
    contacts, speed = balls.contacts, balls.motion.entrainment_speed
    rolled, spun = creep_numbers(contacts, friction_coefficient=0.1, entrainment_speed=speed, spin_rate=0.29)
    for race, expected in enumerate((0.0020845, 0.0018872)):
        b = np.asarray(contacts.semi_axis_transverse)[race, 0, 0]
        saturated = expected * speed[race, 0, 0]
        assert spun[race, 0, 0] == pytest.approx(0.29 * b / saturated, rel=5e-5)  # five digits
        slip = (
            np.asarray(contacts.rolling_rate)[race, 0, 0]
            * b**2
            / (2 * np.asarray(contacts.deformed_radius)[race, 0, 0])
        )
        assert rolled[race, 0, 0] == pytest.approx(slip / saturated, rel=5e-5)


def test_surfaces_without_friction_do_not_creep(bearing_6205: Bearing) -> None:
    operation = Operation(axial_load=np.array([300.0]), inner_speed=np.array([31.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.3), operation, LoadEffects())
    numbers = creep_numbers(balls.contacts, friction_coefficient=0.0, entrainment_speed=0.009, spin_rate=0.3)
    assert all(np.all(np.isinf(each)) for each in numbers)


@pytest.mark.parametrize("ratio", [0.0, 1e-9, 3e-3, 0.21, 0.98, 1.0, 1.7])  # the last one is longer along rolling
def test_the_error_of_a_long_ellipse_is_that_of_its_perimeter(bearing_6205: Bearing, ratio: float) -> None:
    operation = Operation(axial_load=np.array([300.0, 1.3]), inner_speed=np.array([31.0, 2.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.3), operation, LoadEffects())
    contact = replace(balls.contact, semi_axis_x=ratio * balls.contact.semi_axis_y)
    expected = BELOW_FULL_SPIN * (ellipe(1 - min(ratio, 1.0) ** 2) - 1)
    np.testing.assert_allclose(long_ellipse_error(replace(balls, contact=contact)), expected, rtol=1e-12, atol=1e-14)
