"""The inlets of the contacts: oil that its own shear heats, and oil that does not return in time.

Both act on the film and on the resistance to rolling, as factors on flooded and isothermal ones.
"""

from dataclasses import dataclass

from analytic.contact.rolling_contact import RollingContact
from analytic.loads.balls import LoadedBalls
from analytic.oil.film import central_film, inlet_heating_factor, minimum_ratio, thermal_loading
from analytic.oil.rolling import inlet_shear_factor, replenishment_factor
from analytic.oil.starvation import Starvation, starved_at_degree, starved_at_factor
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Bearing, Lubricant


@dataclass(frozen=True, kw_only=True, eq=False)
class Inlets:
    """Factors on films and on rolling torques, each (2, n, m) or of a shape that broadcasts with it, 0 to 1."""

    film_heating: Array  # share of the film that remains when shear heats the inlet
    rolling_heating: Array  # share of the rolling torque that remains then, (n, 1)
    starvation: Starvation | None  # None: the scene gives neither the degree nor the ring diameters

    def film_factor(self, *, heats: bool, starves: bool) -> Array | float:
        factor = self.film_heating if heats else 1.0
        return factor * self.starvation.film_factor if starves and self.starvation is not None else factor

    def rolling_factor(self, *, heats: bool, starves: bool) -> Array | float:
        factor = self.rolling_heating if heats else 1.0
        return factor * self.starvation.rolling_factor if starves and self.starvation is not None else factor


def inlets_of(bearing: Bearing, balls: LoadedBalls, lubricant: Lubricant, *, ring_speed: Array) -> Inlets:
    """Both factors of the loaded balls; ring_speed : w, (n,), rad/s, of either sign.

    A ball slides by less than 1 % of its rolling, so the heat is that of rolling.
    """
    oil = inlet_viscosity(lubricant)
    speed = ring_speed[:, None] * balls.motion.entrainment_speed
    bore, outside = bearing.bore_diameter, bearing.outside_diameter
    mean = bearing.pitch_diameter if bore is None or outside is None else (bore + outside) / 2
    return Inlets(
        film_heating=inlet_heating_factor(
            peak_pressure=balls.contact.peak_pressure,
            modulus=balls.modulus,
            thermal_loading=thermal_loading(
                viscosity=oil.viscosity,
                viscosity_temperature=oil.viscosity_temperature,
                entrainment_speed=speed,
                conductivity=lubricant.thermal_conductivity,
            ),
            slide_to_roll=0.0,
        ),
        rolling_heating=inlet_shear_factor(
            mean_diameter=mean,
            ring_speed=abs(ring_speed)[:, None],
            kinematic_viscosity=oil.viscosity / lubricant.density,
        ),
        starvation=_starvation(bearing, balls.contacts, lubricant, ring_speed=ring_speed, entrainment_speed=speed),
    )


def starvation_source(bearing: Bearing, lubricant: Lubricant) -> str | None:
    """Where the degree of starvation comes from, in words; None: it is not known."""
    if lubricant.starvation_degree is not None:
        return f"degree {lubricant.starvation_degree:g}, given"
    if bearing.bore_diameter is None or bearing.outside_diameter is None:
        return None
    return f"degree by the replenishment factor of {lubricant.supply}"


def _starvation(
    bearing: Bearing, contact: RollingContact, lubricant: Lubricant, *, ring_speed: Array, entrainment_speed: Array
) -> Starvation | None:
    """By the degree that the scene gives, or by the engineering estimate of what starvation leaves of rolling."""
    if starvation_source(bearing, lubricant) is None:
        return None
    oil = inlet_viscosity(lubricant)
    flow = {
        "entrainment_speed": entrainment_speed,
        "viscosity": oil.viscosity,
        "pressure_viscosity": oil.pressure_viscosity,
    }
    film = central_film(contact, **flow, compressible=lubricant.compressible).thickness
    ratio = minimum_ratio(contact, **flow)
    if lubricant.starvation_degree is not None:
        return starved_at_degree(contact, degree=lubricant.starvation_degree, film=film, minimum_ratio=ratio)
    assert bearing.bore_diameter is not None
    assert bearing.outside_diameter is not None
    factor = replenishment_factor(
        bore_diameter=bearing.bore_diameter,
        outside_diameter=bearing.outside_diameter,
        ring_speed=abs(ring_speed),
        kinematic_viscosity=oil.viscosity / lubricant.density,
        supply=lubricant.supply,
    )
    return starved_at_factor(contact, rolling_factor=factor[:, None], film=film, minimum_ratio=ratio)
