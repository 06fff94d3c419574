"""The inlets of the contacts: oil that its own shear heats, and oil that does not return in time.

Both act on the film and on the resistance to rolling, as factors on flooded and isothermal ones.
"""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.contact.rolling_contact import ContactNumbers, contact_at
from analytic.loads.balls import LoadedBalls
from analytic.numerics.compilation import compiled, rows_of
from analytic.numerics.elements import elements_of
from analytic.numerics.records import record_of
from analytic.oil.asymptotes import FilmAsymptotes, Inflow, asymptotes_of, log_film_of
from analytic.oil.film import heated_part, shear_heat, smallest_ratio
from analytic.oil.rolling import heated_rolling, replenished, replenishment_rate
from analytic.oil.starvation import (
    FLOODED,
    Starvation,
    StarvedNumbers,
    checked_degrees,
    no_meniscus,
    starved_by_degree,
    starved_by_factor,
)
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Bearing, Lubricant


class OilSupply(NamedTuple):
    """How oil comes to the inlets of a bearing, in numbers. With neither degree nor rate the inlets are flooded."""

    mean_diameter: float  # of the bearing, m, for the inlets' heat
    degree: float  # m of `analytic.oil.starvation`; NaN: not given
    rate: float  # of `rolling.replenishment_rate`; NaN: no ring diameters


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
    ring_speed: float,
) -> InletNumbers:
    """Both factors of a contact; peak_pressure : p0, Pa;  film : flooded and isothermal, smooth.

    A ball slides by less than 1 % of its rolling, so the heat is that of rolling.
    """
    inflow = inflow_of(contact, oil, ring_speed)
    loading = shear_heat(oil.viscosity, oil.viscosity_temperature, inflow.speed, oil.thermal_conductivity)
    kinematic = oil.viscosity / oil.density
    starved = FLOODED
    if not np.isnan(supply.degree) or not np.isnan(supply.rate):
        height, ratio = np.exp(log_film_of(film, 0.0)[0]), smallest_ratio(contact, inflow)
        if np.isnan(supply.degree):
            starved = starved_by_factor(contact, replenished(supply.rate, abs(ring_speed), kinematic), height, ratio)
        else:
            starved = starved_by_degree(contact, supply.degree, height, ratio)
    return InletNumbers(
        heated_part(peak_pressure, contact.modulus, loading, 0.0),
        heated_rolling(supply.mean_diameter, abs(ring_speed), kinematic),
        starved,
    )


@compiled
def _inlets(rows: Array, oil: OilNumbers, supply: OilSupply) -> Array:
    fields = np.empty((6, rows.shape[1]))
    for i in range(rows.shape[1]):
        contact, ring_speed = contact_at(rows, 0, i), rows[10, i]
        film = asymptotes_of(contact, inflow_of(contact, oil, ring_speed))
        inlet = inlet_of(contact, rows[9, i], oil, film, supply, ring_speed)
        fields[0, i], fields[1, i] = inlet.film_heating, inlet.rolling_heating
        for k in range(4):
            fields[2 + k, i] = inlet.starvation[k]
    return fields


@dataclass(frozen=True, kw_only=True, eq=False)
class Inlets:
    """Factors on films and on rolling torques, each (2, n, m), 0 to 1."""

    film_heating: Array  # share of the film that remains when shear heats the inlet
    rolling_heating: Array  # share of the rolling torque that remains then
    starvation: Starvation | None  # None: the scene gives neither the degree nor the ring diameters

    def at(self, points: NDArray[np.intp]) -> "Inlets":
        """The same at some operating points."""

        def chosen(value: Array) -> Array:
            return value[:, points]

        starvation = None if self.starvation is None else elements_of(self.starvation, chosen)
        return replace(elements_of(self, chosen), starvation=starvation)

    def film_factor(self, *, heats: bool, starves: bool) -> Array | float:
        factor = self.film_heating if heats else 1.0
        return factor * self.starvation.film_factor if starves and self.starvation is not None else factor

    def rolling_factor(self, *, heats: bool, starves: bool) -> Array | float:
        factor = self.rolling_heating if heats else 1.0
        return factor * self.starvation.rolling_factor if starves and self.starvation is not None else factor


def inlets_of(bearing: Bearing, balls: LoadedBalls, lubricant: Lubricant, *, ring_speed: Array) -> Inlets:
    """Both factors of the loaded balls; ring_speed : w, (n,), rad/s, of either sign."""
    supply = oil_supply(bearing, lubricant)
    known = balls.contacts.fields[:8]  # but the entrainment
    rows, shape = rows_of(*known, balls.motion.entrainment_speed, balls.contact.peak_pressure, ring_speed[:, None])
    film_heating, rolling_heating, *starved = _inlets(
        rows, record_of(oil_numbers(lubricant)), record_of(supply)
    ).reshape(6, *shape)
    if np.isnan(starved[0]).any():
        raise no_meniscus()
    return Inlets(
        film_heating=film_heating,
        rolling_heating=rolling_heating,
        starvation=None
        if starvation_source(bearing, lubricant) is None
        else Starvation(**dict(zip(StarvedNumbers._fields, starved, strict=True))),
    )


def oil_supply(bearing: Bearing, lubricant: Lubricant) -> OilSupply:
    """By the degree that the scene gives, or by the engineering estimate of what starvation leaves of rolling."""
    bore, outside, degree = bearing.bore_diameter, bearing.outside_diameter, lubricant.starvation_degree
    if bore is None or outside is None:
        mean, rate = bearing.pitch_diameter, np.nan
    else:
        mean = (bore + outside) / 2
        rate = float(replenishment_rate(bore_diameter=bore, outside_diameter=outside, supply=lubricant.supply))
    return OilSupply(mean, np.nan if degree is None else float(checked_degrees(degree)), rate)


def starvation_source(bearing: Bearing, lubricant: Lubricant) -> str | None:
    """Where the degree of starvation comes from, in words; None: it is not known."""
    if lubricant.starvation_degree is not None:
        return f"degree {lubricant.starvation_degree:g}, given"
    if bearing.bore_diameter is None or bearing.outside_diameter is None:
        return None
    return f"degree by the replenishment factor of {lubricant.supply}"
