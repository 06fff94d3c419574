"""A thrust ball bearing: equilibrium, motion, pivoting and rolling by hand, and what its equilibrium leaves out."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.special import ellipe

from analytic.contact.finite_geometry import race_geometry, race_shape
from analytic.contact.geometry import race_contact, race_curvatures, shoulder_distances
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact
from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import InputError
from analytic.loads.thrust import thrust_equilibrium
from analytic.oil.rolling import hydrodynamic_rolling
from analytic.scene import Autocorrelation, Bearing, ContactAngle, Groove, Operation, Scene, Surface
from analytic.torque import friction_torque
from tests.analytic.specimens import OIL as USUAL_OIL
from tests.analytic.specimens import loaded_contacts, part, thrust
from tests.contacts import STEEL
from tests.refusals import refused

RIGHT = ContactAngle(rule="given", value=np.pi / 2)
BALL, PITCH, GROOVE, COUNT = 7.2e-3, 37.4e-3, 3.9e-3, 11  # m
WASHER = Groove(bottom_radius=PITCH / 2, groove_radius=GROOVE, shoulder_half_width=2.6e-3, material=STEEL)
BEARING = Bearing(
    name="thrust bearing",
    kind="thrust",
    ball_count=COUNT,
    ball_diameter=BALL,
    ball_mass=STEEL.density * np.pi / 6 * BALL**3,
    ball_material=STEEL,
    inner=WASHER,
    outer=WASHER,
)
OIL = replace(USUAL_OIL, eyring_stress=6e6, limiting_shear=0.07)
FINISH = Surface(
    rms_roughness=0.05e-6, autocorrelation=Autocorrelation(kind="gaussian", length=30e-6, spacing=2e-6), hardness=7.8e9
)


def scene_of(operation: Operation, **changed: Any) -> Scene:
    return Scene(bearing=BEARING, contact_angle=RIGHT, operation=operation, **changed)


def contact_by_hand(load: float) -> HertzContact:
    """A washer is flat along rolling."""
    return hertz_contact(
        curvature_x=2 / BALL, curvature_y=2 / BALL - 1 / GROOVE, load=load, modulus=contact_modulus(STEEL, STEEL)
    )


def test_every_ball_carries_its_share_at_a_right_angle() -> None:
    balls = thrust_equilibrium(BEARING, RIGHT, axial_load=[330.0, 2300.0])
    for index, axial in enumerate((330.0, 2300.0)):
        np.testing.assert_allclose(balls["load"][index], axial / COUNT, rtol=1e-14)  # round-off
        by_hand = contact_by_hand(axial / COUNT)
        for race in loaded_contacts(balls):
            for name in ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach"):
                np.testing.assert_allclose(getattr(race, name)[index], getattr(by_hand, name), rtol=1e-12)  # round-off
    assert np.all(balls["angle"] == np.pi / 2)


@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_pivoting_in_boundary_friction_is_the_closed_form(rule: Any) -> None:
    """3/8 mu Q b E(m) at each contact of a ball, at the spin of half the speed."""
    mu, axial = 0.13, 770.0
    scene = scene_of(
        thrust(axial, speed=25.0),
        friction_coefficient=mu,
        spin_rule=rule,
        tolerance=1e-3,
        effects={"finite_geometry": "off", "hysteresis": "off", "creep": "off" if rule == "free" else "auto"},
    )
    found = friction_torque(scene)
    contact, load = contact_by_hand(axial / COUNT), axial / COUNT
    flat = 1 - (float(contact.semi_axis_x) / float(contact.semi_axis_y)) ** 2
    moment = 3 / 8 * mu * load * float(contact.semi_axis_y) * ellipe(flat)
    # Curvature of the contact adds slip, 3 % of it at the ends, across that of spin: 1e-3 of the loss.
    np.testing.assert_allclose(found.torque.race, 2 * COUNT * moment / 2, rtol=2e-3)
    np.testing.assert_allclose(part(found.torque, "spin"), found.torque.race, rtol=2e-3)


def test_rolling_is_the_sum_over_the_contacts() -> None:
    """Power 2 u f at each, over w; twice the balls under twice the load lose twice as much."""
    axial, speed = 480.0, 31.0
    closed = replace(OIL, rolling_formula="biboulet")
    scene = scene_of(thrust(axial, speed=speed), lubricant=closed, surface=FINISH, spin_rule="balanced")
    effects = {"finite_geometry": "off", "inlet_heating": "off"}
    rolling = part(friction_torque(replace(scene, effects=effects)).torque, "rolling")
    by_hand = contact_by_hand(axial / COUNT)
    contact = ContactNumbers(
        load=axial / COUNT,
        semi_axis_rolling=by_hand.semi_axis_x,
        semi_axis_transverse=by_hand.semi_axis_y,
        curvature_rolling=2 / BALL,
        curvature_transverse=2 / BALL - 1 / GROOVE,
        modulus=contact_modulus(STEEL, STEEL),
        deformed_radius=2 / (1 / GROOVE + 2 / BALL),
        rolling_rate=PITCH / (2 * BALL),
    )
    force = hydrodynamic_rolling(contact, viscosity=OIL.viscosity, entrainment_speed=speed * PITCH / 4).force
    np.testing.assert_allclose(rolling, COUNT * PITCH * force, rtol=1e-12)  # round-off
    fewer = replace(scene.bearing, ball_count=4)
    quarter = replace(scene, bearing=fewer, operation=thrust(axial * 4 / COUNT, speed=speed), effects=effects)
    np.testing.assert_allclose(part(friction_torque(quarter).torque, "rolling"), rolling * 4 / COUNT, rtol=1e-12)


def test_free_balls_share_the_spin_by_symmetry() -> None:
    scene = scene_of(thrust(900.0, speed=12.0), lubricant=OIL, surface=FINISH)
    found = friction_torque(scene)
    assert "creep" in str(found.provenance["sliding"])
    assert found.film.inner is not None
    assert found.film.outer is not None
    np.testing.assert_allclose(found.film.inner, found.film.outer, rtol=1e-5)  # the moment of inertia tells them apart
    ruled = friction_torque(replace(scene, spin_rule="balanced"))
    most = ruled.torque.race * (1 + found.numerical_uncertainty)  # creep takes slip off, here next to nothing
    assert np.all(found.torque.race < most)
    assert np.all(found.torque.race > 0.9 * ruled.torque.race)  # of spin many times the saturated one, little


def test_shoulders_lie_on_both_sides_of_the_contact() -> None:
    near, far = shoulder_distances(BEARING, "outer", contact_angle=np.pi / 2)
    np.testing.assert_allclose([near, far], 2.6e-3, rtol=1e-12)  # the bottom is where the ball is
    contact = race_contact(BEARING, "inner", contact_angle=np.pi / 2, ball_load=50.0)
    assert (contact.rolling_radius, contact.tilt, contact.ring) == (np.inf, 0.0, None)
    unlike = replace(BEARING, outer=replace(BEARING.outer, far_shoulder_half_width=1.9e-3))
    near, far = shoulder_distances(unlike, "outer", contact_angle=np.pi / 2)
    np.testing.assert_allclose([near, far], [2.6e-3, 1.9e-3], rtol=1e-12)


def test_a_ball_touches_the_bottom_of_both_washers_only() -> None:
    for asked in (race_contact, race_geometry, race_shape):
        with pytest.raises(InputError, match=r"contact angle of 90 degrees, got 85\.9"):
            asked(BEARING, "inner", contact_angle=1.5, ball_load=50.0)
    for asked in (race_curvatures, shoulder_distances):
        with pytest.raises(InputError, match=r"contact angle of 90 degrees, got 85\.9"):
            asked(BEARING, "inner", contact_angle=[1.5, np.pi / 2])


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"operation": replace(thrust(500.0), radial_load=np.array([3.0]))}, "radial_load = 3 N"),
        ({"operation": replace(thrust(500.0), moment=np.array([-0.2]))}, "moment = -200 N mm"),
        ({"operation": thrust(5.0, speed=300.0)}, "raise the load"),
        ({"contact_angle": ContactAngle(rule="solved")}, "90 degrees"),
        ({"contact_angle": ContactAngle(rule="given", value=1.5)}, "90 degrees"),
    ],
)
def test_what_it_does_not_carry_is_refused(changed: dict[str, Any], words: str) -> None:
    refused(lambda: friction_torque(replace(scene_of(thrust(500.0), friction_coefficient=0.1), **changed)), words)
