"""The inlets of the contacts: oil that its own shear heats, and oil that does not return in time.

Both act on the film and on the resistance to rolling, as factors on flooded and isothermal ones.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.oil.ehl_fit import OilSupply, Regime, effective_reach, inlet_length
from analytic.oil.film import FilmAsymptotes, Inflow, inlet_heating_factor, log_film_of, shear_heat
from analytic.oil.grease import log_greased_film
from analytic.oil.rolling import (
    ANGULAR_CONTACT,
    DEEP_GROOVE,
    THRUST,
    inlet_shear_factor,
    replenished,
    replenishment_rate,
)
from analytic.oil.starvation import (
    FLOODED,
    StarvedNumbers,
    checked_degree,
    starved_by_degree,
    starved_by_factor,
    starved_by_film,
)
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Bearing, Lubricant


class InletNumbers(NamedTuple):
    """One contact of `Inlets` in numbers, for compiled formulas."""

    film_heating: float
    rolling_heating: float
    starvation: StarvedNumbers


@compiled
def inflow_of(contact: ContactNumbers, oil: OilNumbers, ring_speed: float) -> Inflow:
    """How the oil enters a contact of a race; ring_speed : w, rad/s, of either sign."""
    speed = abs(ring_speed * contact.entrainment)
    return Inflow(speed, oil.viscosity, oil.pressure_viscosity, oil.compressible, np.inf)


@compiled
def inlet_of(
    contact: ContactNumbers,
    peak_pressure: float,
    oil: OilNumbers,
    film: FilmAsymptotes,
    supply: OilSupply,
    regime: Regime,
    ring_speed: float,
) -> InletNumbers:
    """Both factors of a contact; peak_pressure : p0, Pa;  film : flooded and isothermal, smooth.

    regime : of the contact at its speed
    A ball slides by less than 1 % of its rolling, so the heat is that of rolling.
    """
    inflow = inflow_of(contact, oil, ring_speed)
    loading = shear_heat(oil.viscosity, oil.viscosity_temperature, inflow.speed, oil.thermal_conductivity)
    kinematic = oil.viscosity / oil.density
    starved = FLOODED
    if supply.churned:
        shear, width = inflow.viscosity * inflow.speed, contact.semi_axis_transverse
        if shear * width > 0.0:
            left = log_greased_film(shear, width, supply.surface_tension, supply.axial_share) + supply.grease_film
            starved = starved_by_film(contact, np.exp(left), np.exp(log_film_of(film, 0.0)[0]))
    elif not np.isnan(supply.degree) or not np.isnan(supply.rate):
        height, length = np.exp(log_film_of(film, 0.0)[0]), inlet_length(contact, inflow, regime)
        if np.isnan(supply.degree):
            left = replenished(supply.rate, abs(ring_speed), kinematic)
            starved = starved_by_factor(contact, left, height, supply.ahead, length)
        else:
            starved = starved_by_degree(contact, supply.degree, height, supply.ahead, length)
    return InletNumbers(
        inlet_heating_factor(peak_pressure, contact.modulus, loading, 0.0),
        inlet_shear_factor(supply.mean_diameter, abs(ring_speed), kinematic),
        starved,
    )


def oil_supply(bearing: Bearing, lubricant: Lubricant, race: Race, *, contact_angle: float) -> OilSupply:
    """By the degree that the scene gives, films measured with grease, or an estimate of what is left of rolling.

    contact_angle : of the ball on the race, rad
    """
    bore, outside, degree = bearing.bore_diameter, bearing.outside_diameter, lubricant.starvation_degree
    mean = bearing.pitch_diameter if bore is None or outside is None else (bore + outside) / 2
    ahead, behind = (
        effective_reach(bearing, race, reach=reach, contact_angle=contact_angle)
        for reach in (lubricant.reach.ahead, lubricant.reach.behind)
    )
    return OilSupply(
        mean,
        np.nan if degree is None else checked_degree(degree),
        replenishment_of(bearing, lubricant),
        ahead,
        behind,
        -float(lubricant.cavitation_pressure),
        churned=lubricant.starves_as_measured(bearing),
        surface_tension=float(lubricant.surface_tension),
    )


def replenishment_of(bearing: Bearing, lubricant: Lubricant) -> float:
    """`replenishment_rate` of a bearing, s^2/m^2; NaN: its bore or its outside diameter is not known."""
    if bearing.bore_diameter is None or bearing.outside_diameter is None:
        return np.nan
    geometry = THRUST if bearing.kind == "thrust" else DEEP_GROOVE if bearing.is_deep_groove else ANGULAR_CONTACT
    rate = replenishment_rate(
        bore_diameter=bearing.bore_diameter,
        outside_diameter=bearing.outside_diameter,
        supply=lubricant.supply,
        geometry=geometry,
    )
    return float(rate)


def replenishment_exponent(bearing: Bearing, lubricant: Lubricant, ring_speed: Array) -> Array | None:
    """-ln phi_rs of `replenishment_factor` at each ring speed, rad/s; None: it does not decide on starvation."""
    if not lubricant.starves_by_replenishment(bearing):
        return None
    kinematic = oil_numbers(lubricant).viscosity / lubricant.density
    return replenishment_of(bearing, lubricant) * kinematic * np.abs(ring_speed)


def starvation_source(bearing: Bearing, lubricant: Lubricant) -> str | None:
    """Where the degree of starvation comes from, in words; None: it is not known."""
    if lubricant.starvation_degree is not None:
        return f"degree {lubricant.starvation_degree:g}, given"
    if lubricant.starves_as_measured(bearing):
        return "degree by films measured in greased deep groove bearings"
    if lubricant.starves_by_replenishment(bearing):
        return f"degree by the replenishment factor of {lubricant.supply}"
    return None
