"""Creep numbers against values that were computed elsewhere, and their limits."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, ContactAngle, Operation
from analytic.sliding.creep import creep_numbers, creep_share, creep_shares


def numbers_of(balls: LoadedBalls, race: int) -> ContactNumbers:
    fields = np.broadcast_arrays(*balls.contacts.fields[:8], balls.motion.entrainment_speed)
    return ContactNumbers(*(float(field[race, 0, 0]) for field in fields))


def test_the_creep_of_a_6205(bearing_6205: Bearing) -> None:
    """Under 1000 N at 0.18 rad and mu = 0.1 s_c/u is 0.0020845 inside and 0.0018872 outside."""
    operation = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([31.0])).as_series()
    still = LoadEffects(centrifugal=False, gyroscopic=False)
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.18), operation, still)
    for race, expected in enumerate((0.0020845, 0.0018872)):
        contact = numbers_of(balls, race)
        rolled, spun = creep_numbers(contact, 0.1 * contact.load, 0.29)
        saturated = expected * contact.entrainment
        assert spun == pytest.approx(0.29 * contact.semi_axis_transverse / saturated, rel=5e-5)  # five digits
        slip = contact.rolling_rate * contact.semi_axis_transverse**2 / (2 * contact.deformed_radius)
        assert rolled == pytest.approx(slip / saturated, rel=5e-5)


def test_surfaces_without_friction_do_not_creep(bearing_6205: Bearing) -> None:
    operation = Operation(axial_load=np.array([300.0]), inner_speed=np.array([31.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.3), operation, LoadEffects())
    contact = numbers_of(balls, 0)
    assert np.all(np.isinf(creep_numbers(contact, 0.0, 0.3)))
    assert creep_share(contact, PointLaw(), 31.0, 0.3) == 0.0


def test_the_share_of_creep_is_that_of_its_numbers(bearing_6205: Bearing) -> None:
    """Of 1/K, infinite from a whole torque on: of the worst contact of each point."""
    operation = Operation(axial_load=np.array([300.0, 1.0]), inner_speed=np.array([31.0, 31.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.6), operation, LoadEffects())
    friction, shares = 0.02 * balls.load, []
    for race in range(2):
        contact = numbers_of(balls, race)
        rolled, spun = creep_numbers(contact, 0.02 * contact.load, abs(float(balls.motion.spin_difference[0, 0])))
        shares.append(4.5 / spun + 1.0 / rolled)
    assert max(shares) < 1
    np.testing.assert_allclose(creep_shares(balls, friction)[0], max(shares), rtol=1e-12)
    assert creep_shares(balls, 5e2 * friction)[0] == np.inf
    still = replace(balls, load=0 * balls.load)
    np.testing.assert_array_equal(creep_shares(still, friction), 0.0)
