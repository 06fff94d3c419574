"""One contact of a 6205 as one formula, against what its parts are defined by."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import RACES
from analytic.contact.rolling_contact import ContactNumbers
from analytic.oil.ehl_fit import covered, film_correction, fitted_force, regime_of
from analytic.oil.film import Inflow
from analytic.oil.inlets import InletNumbers, oil_supply, replenishment_exponent, starvation_source
from analytic.oil.lubrication import (
    LubricatedContact,
    lubricated_contact,
    lubrication_of,
    rolling_force_of,
    rolling_torque_of,
)
from analytic.oil.race_resistance import SMOOTH_FORM
from analytic.oil.rolling import hydrodynamic_rolling
from analytic.oil.starvation import FLOODED
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import oil_at, oil_numbers
from analytic.scene import Bearing, ContactAngle, Lubricant, Surface
from analytic.scenefile.read import load_scene
from analytic.surface.gap import GapNumbers, gap_forms, gap_law
from analytic.surface.roughness import gap_roughness
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, contacts_under_thrust, present
from tests.contacts import STEEL
from tests.refusals import refuses

CLOSED = replace(OIL, film_formula="nijenbanning", rolling_formula="biboulet")
WARM = replace(CLOSED, temperature=331.0, compressible=False)
ROUGH = replace(FINISH, rms_roughness=0.3e-6, gap="truncated")
SPEEDS = (0.0, -3.1, 420.0)  # rad/s
ALL = {"asperities": True, "heats": True, "starves": True}


def loaded(race: int, point: int) -> ContactNumbers:
    """Under one of three loads."""
    angle = ContactAngle(rule="solved", free=0.19)
    return contacts_under_thrust(BEARING_6205, angle, (41.0, 230.0, 1700.0)[point])[race]


def gap_of(finish: Surface, contact: ContactNumbers) -> GapNumbers:
    return gap_law(finish, gap_roughness(finish), modulus=contact.modulus, bodies=(STEEL, STEEL))


def lubricated(
    bearing: Bearing, race: int, point: int, oil: Lubricant, finish: Surface, variation: Variation, **counts: bool
) -> tuple[ContactNumbers, LubricatedContact]:
    contact = loaded(race, point)
    (form,), cubics = gap_forms(gap_of(finish, contact))
    names = {"asperities": "asperities", "inlet_heating": "heats", "starvation": "starves"}
    given = {"boundary_friction": finish.boundary_friction, "variation": variation}
    supply = oil_supply(bearing, oil, RACES[race], contact_angle=0.19)
    lubrication = lubrication_of(form, supply, oil, is_on=lambda name: counts[names[name]], **given)  # pyright: ignore[reportArgumentType]
    return contact, lubricated_contact(contact, peak_of(contact), oil_numbers(oil), lubrication, cubics, SPEEDS[point])


def peak_of(contact: ContactNumbers) -> float:
    return 1.5 * contact.load / (np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse)


def test_the_fit_replaces_both_formulas_within_its_range() -> None:
    """Film and force are those of the fit; an error of the closed formula counts by its power for the fit, 0.12."""
    plain = ALL | {"asperities": False, "heats": False, "starves": False}
    for race in (0, 1):
        contact, found = lubricated(BEARING_6205, race, 2, OIL, FINISH, NOMINAL, **plain)
        _, closed = lubricated(BEARING_6205, race, 2, CLOSED, FINISH, NOMINAL, **plain)
        speed = abs(SPEEDS[2] * contact.entrainment)
        inflow = Inflow(speed, OIL.viscosity, OIL.pressure_viscosity, True, np.inf)
        regime = regime_of(contact, inflow)
        assert covered(regime) == 1
        supply = oil_supply(BEARING_6205, OIL, RACES[race], contact_angle=0.19)
        force = fitted_force(contact, inflow, regime, supply)
        assert found.rolling_torque == pytest.approx(2 * force * contact.entrainment, rel=1e-12)
        thinner = found.mixed.film_thickness / closed.mixed.film_thickness
        assert thinner == pytest.approx(np.exp(film_correction(regime)), rel=1e-12)
        _, doubtful = lubricated(BEARING_6205, race, 2, OIL, FINISH, Variation(rolling_error=1.7), **plain)
        assert doubtful.rolling_torque / found.rolling_torque == pytest.approx(1.7**0.12, rel=1e-12)


def test_at_the_ends_of_the_fit_both_formulas_count_by_its_share() -> None:
    """Under a light load, and with an error of the closed formula, of which the fit takes its part of the power."""
    oil = replace(OIL, compressible=True)
    numbers = loaded(0, 2)
    rate = numbers.entrainment
    numbers_of_oil, inflow = oil_numbers(oil), Inflow(420.0 * rate, oil.viscosity, oil.pressure_viscosity, True, np.inf)
    light = numbers._replace(load=4.7 / float(np.exp(regime_of(numbers, inflow).loading)) * numbers.load)  # N of 4.7
    regime = regime_of(light, inflow)
    share, supply = covered(regime), oil_supply(BEARING_6205, oil, "inner", contact_angle=0.19)
    assert 0.1 < share < 0.9
    fit = fitted_force(light, inflow, regime, supply)
    closed = hydrodynamic_rolling(light, inflow.viscosity, inflow.speed).force
    assert closed != pytest.approx(fit, rel=0.02)
    force, of_fit, _ = rolling_force_of(light, inflow, regime, supply, True, False)
    assert (force, of_fit) == (pytest.approx(share * fit + (1 - share) * closed, rel=1e-12), share)
    inlet = InletNumbers(1.0, 0.83, FLOODED)
    for error in (1.0, 1.7):
        varied = Variation(rolling_error=error, rolling=0.9, heating=1.4)
        lubrication = lubrication_of(
            SMOOTH_FORM, supply, oil, boundary_friction=0.1, is_on=lambda _: True, variation=varied
        )
        torque, _ = rolling_torque_of(light, numbers_of_oil, inlet, lubrication, regime, 420.0)
        power = 0.12 * share + 1 - share
        assert torque == pytest.approx(0.9 * error**power * 0.83**1.4 * 2 * force * rate, rel=1e-12)


@pytest.mark.parametrize(
    ("ahead", "oil", "shape", "is_said"),
    [
        (3.1, OIL, 1.0, False),
        (2.9, OIL, 1.0, True),  # the fit needs three semi-axes of oil
        (2.9, CLOSED, 1.0, False),  # the closed formula has a far field of its own
        (3.1, CLOSED, 40.0, True),  # longer along rolling than across
    ],
)
def test_rolling_is_extrapolated_beyond_what_its_formula_knows(
    ahead: float, oil: Lubricant, shape: float, is_said: bool
) -> None:
    numbers = loaded(0, 2)
    numbers = numbers._replace(curvature_transverse=shape * numbers.curvature_transverse)
    inflow = Inflow(420.0 * numbers.entrainment, oil.viscosity, oil.pressure_viscosity, True, np.inf)
    supply = oil_supply(BEARING_6205, oil, "inner", contact_angle=0.19)._replace(
        ahead=ahead * numbers.semi_axis_rolling
    )
    lubrication = lubrication_of(
        SMOOTH_FORM, supply, oil, boundary_friction=0.1, is_on=lambda _: False, variation=NOMINAL
    )
    inlet, regime = InletNumbers(1.0, 1.0, FLOODED), regime_of(numbers, inflow)
    assert rolling_torque_of(numbers, oil_numbers(oil), inlet, lubrication, regime, 420.0)[1] == is_said


@pytest.mark.parametrize(("bore", "outside"), [(None, 52e-3), (25e-3, None), (None, None)])
def test_a_given_degree_starves_rings_of_unknown_diameter(bore: float | None, outside: float | None) -> None:
    bearing = replace(BEARING_6205, bore_diameter=bore, outside_diameter=outside)
    supply = oil_supply(bearing, WARM, "inner", contact_angle=0.19)
    assert supply.mean_diameter == bearing.pitch_diameter
    assert np.isnan(supply.rate)
    assert starvation_source(bearing, WARM) is None
    given = replace(WARM, starvation_degree=1.3)
    _, starved = lubricated(bearing, 0, 2, given, ROUGH, NOMINAL, **ALL)
    assert starved.inlet.starvation.degree == 1.3
    _, flooded = lubricated(bearing, 0, 2, WARM, ROUGH, NOMINAL, **ALL)
    assert starved.mixed.film_thickness < 0.99 * flooded.mixed.film_thickness
    assert starvation_source(bearing, given) == "degree 1.3, given"


@pytest.mark.parametrize(("name", "constant"), [("6308", 3.1), ("7208 BEP", 4.4), ("thrust", 3.8)])
def test_each_kind_of_bearing_has_its_constant_of_replenishment(name: str, constant: float) -> None:
    """SKF's formula in its own units: n in 1/min, diameters in mm, nu in mm^2/s."""
    bearing, oil = load_scene("7208 BEP" if name == "thrust" else name).bearing, replace(OIL, viscosity=0.37)
    bearing = replace(bearing, kind="thrust") if name == "thrust" else bearing
    bore, outside = (1e3 * present(each) for each in (bearing.bore_diameter, bearing.outside_diameter))
    rate = 3e-8 * (bore + outside) * np.sqrt(constant / (2 * (outside - bore)))
    expected = rate * 1e6 * oil_numbers(oil).viscosity / oil.density * 70 * 60 / (2 * np.pi)
    found = replenishment_exponent(bearing, oil, np.array([-70.0, 0.0]))
    np.testing.assert_allclose(present(found), [expected, 0.0], rtol=1e-12)
    # 1e6: nu in mm^2/s; the rate of the kernel is per m^2/s and rad/s
    supply = oil_supply(bearing, oil, "inner", contact_angle=0.6)
    assert supply.rate == pytest.approx(rate * 1e6 * 60 / (2 * np.pi), rel=1e-12)
    assert replenishment_exponent(bearing, replace(oil, starvation_degree=1.7), np.array([70.0])) is None


def test_factors_are_positive_and_a_step_is_any_number() -> None:
    refuses(Variation, film=0.0, rolling=-1.0, heating=np.nan, oil_losses=np.inf)
    refuses(Variation, elastic_rolling=np.nan, asperity_share=np.inf, starvation=np.nan)
    assert Variation(elastic_rolling=-2.0).elastic_rolling == -2.0


def test_a_step_leads_from_a_starved_inlet_to_a_flooded_one() -> None:
    """As powers of the replenishment factor, from its square at -1 to none of it at 1."""
    thick, flooded = replace(OIL, viscosity=0.9), {**ALL, "starves": False}

    def at(step: float, **counts: bool) -> LubricatedContact:
        return lubricated(BEARING_6205, 0, 2, thick, ROUGH, Variation(starvation=step), **(counts or ALL))[1]

    whole, steps = at(0.0, **flooded), (-1.0, -0.3, 0.0, 0.6, 1.0)
    left = [at(step).rolling_torque / whole.rolling_torque for step in steps]
    np.testing.assert_allclose(left, np.array(left[2]) ** (1 - np.array(steps)), rtol=1e-9)
    assert left[2] < 0.9
    assert at(1.0).mixed.film_thickness == pytest.approx(whole.mixed.film_thickness, rel=1e-12)
    for beyond, end in ((3.0, 1.0), (-3.0, -1.0)):
        assert at(beyond).rolling_torque == at(end).rolling_torque


def test_an_oil_comes_to_a_temperature_by_any_way() -> None:
    """In one step or two, and as a lubricant that is given there."""
    straight = oil_at(oil_numbers(OIL), 367.0)
    np.testing.assert_allclose(straight[:6], oil_at(oil_at(oil_numbers(OIL), 291.0), 367.0)[:6], rtol=1e-13)
    there = oil_numbers(replace(OIL, temperature=367.0))
    np.testing.assert_allclose(straight, there, rtol=1e-13)
