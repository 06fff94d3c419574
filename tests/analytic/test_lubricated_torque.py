"""Friction torque with a lubricant: what defines film and coefficient, limits, second scenes, JSON and refusals."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.stats import norm

from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import elliptic_contact
from analytic.errors import InputError
from analytic.oil.film import central_film, inlet_heating_factor
from analytic.oil.variation import Variation
from analytic.scene import Bearing, ContactAngle, Decision, Operation, Reach, Scene
from analytic.surface.asperity import separation_of, tabulated_asperities
from analytic.surface.roughness import gap_roughness
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
SLOWLY = Operation(axial_load=np.array([730.0]), inner_speed=np.array([1e-9]))

CLOSED = replace(OIL, film_formula="nijenbanning", rolling_formula="biboulet", compressible=False)  # by formulas alone


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        name="oiled",
        tolerance=1e-5,  # the finest nodes at every point
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.18),
        spin_rule="balanced",
        operation=Operation(axial_load=np.array([300.0, 910.0, 620.0]), inner_speed=SPEEDS),
        lubricant=OIL,
        surface=FINISH,
        effects=PLAIN,
    )


def at_rest(scene: Scene) -> Scene:
    return replace(scene, operation=Operation(axial_load=np.array([730.0]), inner_speed=np.array([0.0])))


def as_given(scene: Scene, coefficient: float) -> Scene:
    effects = PLAIN | {"inlet_heating": "auto", "asperities": "auto"}  # which need an oil and a surface
    return replace(scene, lubricant=None, surface=None, friction_coefficient=coefficient, effects=effects)


@pytest.mark.parametrize("temperature", [313.15, 341.0])
def test_film_and_share_carry_the_load_together(scene: Scene, temperature: float) -> None:
    """What defines them: the film of the oil's part of load and modulus fills the gap under the asperities' part."""
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
        summits, sigma = gap_roughness(FINISH).summits, np.hypot(0.31e-6, 0.13e-6)
        area = np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse
        assert np.all((share > 0) & (share < 1))
        table = tabulated_asperities(summits=summits, modulus=modulus, hardness=7.3e9)
        d, _ = separation_of(*table, np.log(share * contact.load / area))
        mean_gap = sigma * norm.pdf(d / sigma) + d * norm.cdf(d / sigma)
        np.testing.assert_allclose(film, mean_gap, rtol=1e-6)
        # A film of a molecule resists like the asperities.
        molecular = np.exp(-film / 1e-9)
        boundary = share + (1 - share) * molecular
        np.testing.assert_allclose(getattr(found.boundary_share, race), boundary, rtol=1e-12)
    assert not any("is from the scene" in warning for warning in found.warnings)


def test_asperities_alone_are_a_given_coefficient(scene: Scene) -> None:
    """At standstill they carry all, and where the oil has no stress worth naming the coefficient is theirs."""
    found = friction_torque(replace(at_rest(scene), lubricant=replace(OIL, eyring_stress=1e-3)))
    expected = friction_torque(as_given(at_rest(scene), 0.11))
    # 1e-3 Pa beside 0.11 of some GPa
    np.testing.assert_allclose(found.torque.total, expected.torque.total, rtol=1e-9)
    assert found.asperity_share.inner == found.asperity_share.outer == 1
    assert found.boundary_share.inner == found.boundary_share.outer == 1
    assert found.warnings == friction_torque(replace(scene, operation=SLOWLY)).warnings  # none about standing still


@pytest.mark.parametrize("traction", ["eyring_sinh", "eyring_constant"])
def test_the_torque_at_rest_is_that_of_slow_running(scene: Scene, traction: Any) -> None:
    speeds = np.concatenate([[0.0, 1e-100], np.geomspace(1e-9, 10.0, 1001)])
    slow = replace(
        scene,
        operation=Operation(axial_load=np.full(speeds.size, 730.0), inner_speed=speeds),
        lubricant=replace(OIL, traction=traction),
        effects=PLAIN | {"rolling": "off"},
    )
    torque = friction_torque(slow).torque.total
    still, *running = torque
    # A constant stress shears what oil the gap of 0.02 nm at rest holds, as slowly as it may slide.
    np.testing.assert_allclose(running[0], still, rtol=1e-9 if traction == "eyring_sinh" else 3e-4)
    np.testing.assert_allclose(torque[speeds <= 1e-6], still, rtol=0.01)
    assert np.max(np.abs(np.diff(np.log(torque)))) < 0.01  # no jump between any two of the speeds
    assert torque[-1] < 0.5 * still


def test_a_smooth_surface_slides_on_oil_alone(scene: Scene) -> None:
    """Under one load the force is tau_E times the area, whatever the speed."""
    smooth = replace(
        scene,
        lubricant=replace(CLOSED, traction=present(scene.lubricant).traction),
        surface=replace(FINISH, rms_roughness=0.0, ball_rms_roughness=0.0, hardness=None),
        operation=Operation(axial_load=np.full(3, 730.0), inner_speed=SPEEDS),
        effects=PLAIN | {"rolling": "off"},
    )
    found = friction_torque(smooth)
    assert np.all(found.asperity_share.inner == 0)
    assert np.all(present(found.film.inner) > 17e-9)  # e^-17 = 4e-8 of it is a film of a molecule
    np.testing.assert_allclose(found.torque.total, found.torque.total[0], rtol=1e-6)


def test_what_does_not_fit_together_is_refused(scene: Scene) -> None:
    for change, word in (
        ({"friction_coefficient": 0.07}, "friction.coefficient = 0.07"),
        ({"lubricant": None}, "[lubricant] is missing"),
        ({"surface": None}, "[surface] is missing"),
        ({"surface": replace(FINISH, hardness=None)}, "surface.hardness is missing"),
        ({"lubricant": replace(OIL, temperature=120.0)}, "temperature"),
    ):
        refused(lambda: friction_torque(replace(scene, **change)), word)  # noqa: B023


def test_rolling_beside_a_given_coefficient(bearing_6205: Bearing) -> None:
    """Of an independent calculation, N mm at three digits: 1000 N at 0.18 rad, two oils, 100, 300 and 500 rpm."""
    speeds = np.array([100.0, 300.0, 500.0]) * np.pi / 30
    for viscosity, expected in ((0.0275, [4.02, 9.18, 13.48]), (0.0585, [7.09, 16.20, 23.81])):
        found = friction_torque(
            Scene(
                name="rolling",
                tolerance=0.05,
                bearing=bearing_6205,
                contact_angle=ContactAngle(rule="given", value=0.18),
                operation=Operation(axial_load=np.full(3, 1000.0), inner_speed=speeds),
                lubricant=replace(CLOSED, viscosity=viscosity),
                friction_coefficient=0.05,
                spin_rule="balanced",  # as that calculation: balls that roll on their contacts' middles
                effects={"hysteresis": "off", "inlet_heating": "off", "starvation": "off"},
            )
        )
        assert found.torque.rolling is not None
        np.testing.assert_allclose(1e3 * found.torque.rolling, expected, atol=0.006)
        summed = present(found.torque.spin) + present(found.torque.conformity) + found.torque.rolling
        np.testing.assert_allclose(found.torque.total, summed, rtol=1e-15)
        effect = {effect.name: effect for effect in found.effects}["rolling"]
        assert (effect.decision, effect.share) == ("on", np.max(found.torque.rolling / found.torque.total))


def test_a_factor_on_the_film_reaches_film_and_torque(scene: Scene) -> None:
    """Smooth, the film is the formula's times the factor; rough, a thinner film leaves asperities more of the load."""
    smooth = replace(scene, surface=replace(FINISH, rms_roughness=0.0, ball_rms_roughness=0.0))
    for race in RACES:
        plain, thick = (getattr(friction_torque(smooth, variation=Variation(film=by)).film, race) for by in (1.0, 1.37))
        np.testing.assert_allclose(thick, 1.37 * plain, rtol=1e-12)  # round-off
    plain, thin = (friction_torque(scene, variation=Variation(film=by)) for by in (1.0, 0.6))
    for race in RACES:
        assert np.all(getattr(thin.asperity_share, race) > getattr(plain.asperity_share, race))
    assert np.all(thin.torque.total > plain.torque.total)  # a share of load meets 0.11, the oil here far less
    with pytest.raises(InputError, match="film must be positive"):
        friction_torque(scene, variation=Variation(film=0.0))


def test_oil_that_ends_next_to_the_contact_is_said_to_be_extrapolated(scene: Scene) -> None:
    """0.06 of the ball's radius is some two semi-axes; the usual reach is tens of them."""
    short = replace(present(scene.lubricant), reach=Reach(ahead=0.06))
    told = [
        any("semi-axes ahead" in warning for warning in friction_torque(each).warnings)
        for each in (scene, replace(scene, lubricant=short))
    ]
    assert told == [False, True]
