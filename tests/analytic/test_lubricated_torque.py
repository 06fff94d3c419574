"""Friction torque with a lubricant: what defines film and coefficient, limits, second scenes, JSON and refusals."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import elliptic_contact
from analytic.oil.film import central_film, inlet_heating_factor
from analytic.scene import Bearing, ContactAngle, Decision, Operation, Reach, Scene
from analytic.torque import RACES, friction_torque
from tests.analytic import specimens
from tests.analytic.specimens import present
from tests.refusals import refused

OIL = replace(specimens.OIL, traction="eyring_constant")
FINISH = replace(specimens.FINISH, rms_roughness=0.31e-6, ball_rms_roughness=0.13e-6, gap="truncated")
# What the tests below compute beside it; inlet heating and starvation act on rolling by factors of their own.
PLAIN: dict[str, Decision] = {"asperities": "on", "inlet_heating": "on", "spin": "on", "finite_geometry": "off"}
PLAIN |= dict.fromkeys(("starvation", "centrifugal", "gyroscopic"), "off")
SPEEDS = np.array([3.7, 21.0, 640.0])

CLOSED = replace(OIL, film_formula="nijenbanning", rolling_formula="biboulet", compressible=False)  # by formulas alone


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        tolerance=1e-5,  # the finest nodes at every point
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.18),
        spin_rule="balanced",
        operation=Operation(axial_load=np.array([300.0, 910.0, 620.0]), inner_speed=SPEEDS),
        lubricant=OIL,
        surface=FINISH,
        effects=PLAIN,
    )


@pytest.mark.parametrize("temperature", [313.15, 341.0])
def test_the_film_is_that_of_the_oil_s_share_at_its_temperature(scene: Scene, temperature: float) -> None:
    """By the formula, of its part of load and modulus, thinned by the heat of the inlet."""
    found = friction_torque(replace(scene, lubricant=replace(CLOSED, temperature=temperature)))
    # Roelands' law by its logarithm at ambient pressure: ln eta = -9.67 + G x, x = [(T - 138)/(T0 - 138)]^-S.
    g = np.log(OIL.viscosity) + 9.67
    x = ((temperature - 138) / 175.15) ** (-OIL.viscosity_temperature * 175.15 / g)
    viscosity, slope = np.exp(g * x - 9.67), OIL.viscosity_temperature * x * 175.15 / (temperature - 138)
    bearing = scene.bearing
    reach = bearing.ball_radius * np.cos(found.contact_angle)
    u = SPEEDS * (bearing.pitch_diameter**2 / 4 - reach**2) / bearing.pitch_diameter
    for race in RACES:
        film, share = getattr(found.film, race), getattr(found.asperity_share, race)
        contact, groove = getattr(found, race), getattr(bearing, race)
        modulus = contact_modulus(bearing.ball_material, groove.material)
        rolling, transverse = race_curvatures(bearing, race, contact_angle=found.contact_angle)
        softer = elliptic_contact(
            curvature_rolling=rolling,
            curvature_transverse=transverse,
            load=contact.load * (1 - share),
            modulus=modulus * (1 - share),
        )
        oil = central_film(
            softer, entrainment_speed=u, viscosity=viscosity, pressure_viscosity=OIL.pressure_viscosity * x
        )
        heating = inlet_heating_factor(
            peak_pressure=contact.peak_pressure,
            modulus=modulus,
            thermal_loading=viscosity * slope * u**2 / OIL.thermal_conductivity,
            slide_to_roll=0.0,
        )
        assert heating[2] < 0.97  # so that it shows
        np.testing.assert_allclose(film, heating * oil.thickness, rtol=1e-6)  # the share is good to 1e-7
        assert np.all((share > 0) & (share < 1))


def test_what_does_not_fit_together_is_refused(scene: Scene) -> None:
    for change, word in (
        ({"friction_coefficient": 0.07}, "friction.coefficient = 0.07"),
        ({"lubricant": None}, "[lubricant] is missing"),
        ({"surface": None}, "[surface] is missing"),
        ({"surface": replace(FINISH, hardness=None)}, "surface.hardness is missing"),
        ({"lubricant": replace(OIL, temperature=120.0)}, "temperature"),
    ):
        refused(lambda: friction_torque(replace(scene, **change)), word)  # noqa: B023


def test_oil_that_ends_next_to_the_contact_is_said_to_be_extrapolated(scene: Scene) -> None:
    """0.06 of the ball's radius is some two semi-axes; the usual reach is tens of them."""
    short = replace(present(scene.lubricant), reach=Reach(ahead=0.06))
    told = [
        any("semi-axes ahead" in warning for warning in friction_torque(each).warnings)
        for each in (scene, replace(scene, lubricant=short))
    ]
    assert told == [False, True]
