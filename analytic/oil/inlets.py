"""The inlets of the contacts: oil that its own shear heats, and oil that does not return in time.

Both act on the film and on the resistance to rolling, as factors on flooded and isothermal ones.
"""

from dataclasses import dataclass

from analytic.loads.balls import LoadedBalls
from analytic.oil.film import inlet_heating_factor, thermal_loading
from analytic.oil.rolling import inlet_shear_factor
from analytic.oil.starvation import Starvation
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
        starvation=None,
    )
