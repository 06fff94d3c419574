"""Creep numbers against values that were computed elsewhere, and their limits."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.oil.traction import PointLaw, mean_force
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.sliding.creep import creep_numbers, creep_share
from analytic.solve.model import model_of
from analytic.solve.solution import points_of, solved


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


def test_the_friction_of_the_share_is_that_of_a_contact_that_takes_all_spin(bearing_6205: Bearing) -> None:
    """Oil that shears harder at a higher speed: the mean sliding without spin, and (3/8) b w_s more."""
    operation = Operation(axial_load=np.array([300.0]), inner_speed=np.array([31.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.6), operation, LoadEffects())
    contact, ring_speed, spin = numbers_of(balls, 0), 17.0, 0.56
    law = PointLaw(boundary=0.001, limit=0.06, eyring=1.1e6, fluidity=310.0)
    # A line under 1 - y^2 slides by w_roll (y^2 - g^2) b^2/(2 R), with lines of pure rolling at g = 2 sin(10 degrees).
    y = (np.arange(4000) + 0.5) / 4000
    weight = (1 - y**2) / np.sum(1 - y**2)
    b = contact.semi_axis_transverse
    sag = contact.rolling_rate * b**2 / (2 * contact.deformed_radius)
    rolls = sag * float(np.sum(weight * np.abs(y**2 - 4 * np.sin(np.pi / 18) ** 2)))
    friction = mean_force(law, contact, ring_speed * (rolls + 3 / 8 * b * spin))
    assert friction > 1.3 * mean_force(law, contact, ring_speed * rolls)
    rolled, spun = creep_numbers(contact, friction, spin)
    assert creep_share(contact, law, ring_speed, spin) == pytest.approx(6.3 / spun + 1.4 / rolled, rel=1e-4)  # cells
    assert creep_share(contact, law, ring_speed, 0.0) == np.inf


@pytest.mark.parametrize(("worst", "radii"), [(0, (4.24e-3, 4.07e-3)), (1, (4.11e-3, 4.21e-3))])
def test_the_share_of_creep_is_that_of_its_numbers(
    bearing_6205: Bearing, worst: int, radii: tuple[float, float]
) -> None:
    """Of 1/K, infinite from a whole torque on; the kernel writes that of the worst contact."""
    inner, outer = (
        replace(groove, groove_radius=radius)
        for groove, radius in zip((bearing_6205.inner, bearing_6205.outer), radii, strict=True)
    )
    bearing = replace(bearing_6205, inner=inner, outer=outer)
    angle = ContactAngle(rule="given", value=0.6)
    operation = Operation(axial_load=np.array([300.0]), inner_speed=np.array([-31.0]))
    balls, shares = thrust_balls(bearing, angle, operation, LoadEffects()), []
    spin = abs(float(balls.motion.spin_difference[0, 0]))
    for contact in (numbers_of(balls, 0), numbers_of(balls, 1)):
        rolled, spun = creep_numbers(contact, 0.02 * contact.load, spin)
        shares.append(6.3 / spun + 1.4 / rolled)
        assert shares[-1] < 1
        assert creep_share(contact, PointLaw(boundary=0.02), 31.0, spin) == pytest.approx(shares[-1], rel=1e-12)
        assert creep_share(contact, PointLaw(boundary=7.0), 31.0, spin) == np.inf
        assert creep_share(contact._replace(load=0.0), PointLaw(boundary=7.0), 31.0, spin) == 0.0
    scene = Scene(name="creep", bearing=bearing, contact_angle=angle, operation=operation, friction_coefficient=0.02)
    model = model_of(scene, {"centrifugal": True, "spin": True, "conformity": True})
    found = solved(model, points_of(operation, 0.0)).points[0]["creep"]
    assert np.argmax(shares) == worst
    assert found == pytest.approx(max(shares), rel=1e-9)  # the balls settle to 1e-10
