"""One contact of a 6205 as one formula, against the arrays' step by step, and against what its parts are defined by."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.hertz import unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.oil.inlets import inlets_of, oil_supply
from analytic.oil.lubricated_races import lubricate_races
from analytic.oil.lubrication import LubricatedContact, lubricated_contact, lubrication_of
from analytic.oil.rolling import houpert_rolling, hydrodynamic_rolling, rolling_torque
from analytic.oil.traction import mean_force
from analytic.oil.variation import Variation
from analytic.oil.viscosity import inlet_viscosity, oil_at, oil_numbers, roelands_viscosity
from analytic.scene import Bearing, ContactAngle, Lubricant, Operation, Surface
from analytic.surface.gap import gap_forms
from tests.analytic.specimens import BEARING_6205, FINISH, OIL

WARM = replace(OIL, temperature=331.0)
ROUGH = replace(FINISH, rms_roughness=0.3e-6, gap="truncated")
ELASTIC = replace(FINISH, gap="elastic")
SPEEDS = np.array([0.0, -3.1, 420.0])
VARIED = Variation(film=0.83, asperity_pressure=1.21, rolling=0.77)
STILL = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)


def loaded(bearing: Bearing) -> LoadedBalls:
    operation = Operation(axial_load=np.array([41.0, 230.0, 1700.0]), inner_speed=np.zeros(3))
    return thrust_balls(bearing, ContactAngle(rule="solved", free=0.19), operation, STILL)


def contact_numbers(balls: LoadedBalls, race: int, point: int) -> ContactNumbers:
    fields = np.broadcast_arrays(*balls.contacts.fields[:8], balls.motion.entrainment_speed)
    return ContactNumbers(*(float(field[race, point, 0]) for field in fields))


def alone(
    bearing: Bearing, balls: LoadedBalls, race: int, point: int, oil: Lubricant, finish: Surface, **changed: Any
) -> tuple[ContactNumbers, LubricatedContact]:
    variation = changed.pop("variation", Variation())
    counts = {"asperities": True, "heats": True, "starves": True} | changed
    races = lubricate_races(bearing, balls, lubricant=oil, surface=finish, ring_speed=SPEEDS, variation=variation)
    (form,), cubics = gap_forms(races.gaps[race])
    lubrication = lubrication_of(
        form,
        oil_supply(bearing, oil),
        boundary_friction=finish.boundary_friction,
        variation=variation,
        **counts,
    )
    contact = contact_numbers(balls, race, point)
    unit = unit_hertz(contact.curvature_rolling, contact.curvature_transverse, contact.modulus)
    peak = float(balls.contact.peak_pressure[race, point, 0])
    return contact, lubricated_contact(contact, unit, peak, oil_numbers(oil), lubrication, cubics, SPEEDS[point])


@pytest.mark.parametrize(
    ("oil", "finish", "changed"),
    [
        (WARM, ROUGH, {}),
        (replace(OIL, starvation_degree=1.2, compressible=True), ELASTIC, {"variation": VARIED}),
        (replace(OIL, traction="eyring_constant"), ELASTIC, {"heats": False, "starves": False}),
        (WARM, replace(FINISH, rms_roughness=0.0), {"starves": False}),
        (WARM, ROUGH, {"asperities": False, "variation": replace(VARIED, rolling_formula="houpert")}),
    ],
)
def test_one_contact_is_that_of_the_arrays(oil: Lubricant, finish: Surface, changed: dict[str, Any]) -> None:
    balls, variation = loaded(BEARING_6205), changed.get("variation", Variation())
    counts = {"asperities": True, "heats": True, "starves": True} | changed
    how = {"heats": counts["heats"], "starves": counts["starves"]}
    races = lubricate_races(BEARING_6205, balls, lubricant=oil, surface=finish, ring_speed=SPEEDS, variation=variation)
    inlets, entrainment = inlets_of(BEARING_6205, balls, oil, ring_speed=SPEEDS), balls.motion.entrainment_speed
    mixed = races.mixed(asperities=counts["asperities"], film_factor=inlets.film_factor(**how))
    flow = {"viscosity": inlet_viscosity(oil).viscosity, "entrainment_speed": SPEEDS[:, None] * entrainment}
    if variation.rolling_formula == "houpert":
        resistance = houpert_rolling(balls.contacts, **flow, pressure_viscosity=inlet_viscosity(oil).pressure_viscosity)
    else:
        resistance = hydrodynamic_rolling(balls.contacts, **flow)
    torque = variation.rolling * rolling_torque(resistance, entrainment_rate=entrainment)
    torque = torque * inlets.rolling_factor(**how)
    speeds = np.array([0.02, 0.3, 1.7])
    friction = races.traction(mixed).force(balls.contacts)(speeds[:, None])
    for race, point in np.ndindex(2, 3):
        contact, found = alone(BEARING_6205, balls, race, point, oil, finish, **changed)
        for name in ("asperity_share", "boundary_share", "film_thickness", "area_fraction", "without_film", "capped"):
            # round-off of the order of operations
            np.testing.assert_allclose(getattr(found.mixed, name), getattr(mixed, name)[race, point, 0], rtol=1e-12)
        np.testing.assert_allclose(found.rolling_torque, torque[race, point, 0], rtol=1e-12)
        force = mean_force(found.law, contact, float(speeds[point]))
        np.testing.assert_allclose(force, friction[race, point, 0], rtol=1e-12)


def test_rings_of_unknown_diameter_are_flooded() -> None:
    bearing = replace(BEARING_6205, bore_diameter=None, outside_diameter=None)
    balls = loaded(bearing)
    _, starved = alone(bearing, balls, 0, 2, WARM, ROUGH)
    _, flooded = alone(bearing, balls, 0, 2, WARM, ROUGH, starves=False)
    assert starved.mixed == flooded.mixed
    assert starved.rolling_torque == flooded.rolling_torque
    assert starved.inlet.starvation.film_factor == 1


def test_an_oil_comes_to_a_temperature_by_any_way() -> None:
    """In one step or two, and as the lubricant's formula has it there."""
    straight = oil_at(oil_numbers(OIL), 367.0)
    np.testing.assert_allclose(straight[:6], oil_at(oil_at(oil_numbers(OIL), 291.0), 367.0)[:6], rtol=1e-13)
    there = oil_numbers(replace(OIL, temperature=367.0))
    np.testing.assert_allclose(straight, there, rtol=1e-13)
    np.testing.assert_allclose(straight.growth, np.log(straight.viscosity) + 9.67, rtol=1e-13)
    under = roelands_viscosity(
        pressure=0.9e9,
        temperature=367.0,
        viscosity=OIL.viscosity,
        pressure_viscosity=OIL.pressure_viscosity,
        reference_temperature=OIL.reference_temperature,
        viscosity_temperature=OIL.viscosity_temperature,
    )
    thickened = straight.growth * ((1 + 5.1e-9 * 0.9e9) ** straight.exponent - 1)
    np.testing.assert_allclose(straight.viscosity * np.exp(thickened), under, rtol=1e-12)  # exp of some 10
