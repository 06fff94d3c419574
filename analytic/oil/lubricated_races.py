"""Rough balls on lubricated rough races: film, shared load and law of traction from the scene's oil and finish.

The film is flooded, and the balls roll nearly without sliding. The oil has its properties at the inlet of the contact.
Arrays are (2, n, m): races, operating points, balls.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from analytic.contact.rolling_contact import RollingContact
from analytic.errors import require_positive
from analytic.loads.balls import LoadedBalls
from analytic.oil.film import CentralFilm, central_film, inlet_heating_factor, thermal_loading
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import MixedTraction, oil_shear_stress
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Bearing, Lubricant, Surface
from analytic.surface.asperity import softer_hardness
from analytic.surface.asperity_table import AsperityTable, tabulated_asperities
from analytic.surface.roughness import GapRoughness, gap_roughness


@dataclass(frozen=True, kw_only=True, eq=False)
class LubricatedRaces:
    """Loaded balls on both races, with the oil and the finish between them."""

    balls: LoadedBalls
    lubricant: Lubricant
    surface: Surface
    roughness: GapRoughness
    tables: tuple[AsperityTable | None, AsperityTable | None]  # of inner and outer; None: smooth
    ring_speed: Array  # (n,) w, rad/s
    entrainment_speed: Array  # (n, m) u, m/s
    film: CentralFilm  # (2, n, m) of smooth surfaces, isothermal, with the film_factor
    film_factor: float  # on the film of the formula

    @cached_property
    def heating_factor(self) -> Array:
        """Share of the film that remains when shear heats the inlet; a ball slides by less than 1 % of its rolling."""
        oil = inlet_viscosity(self.lubricant)
        return inlet_heating_factor(
            peak_pressure=self.balls.contact.peak_pressure,
            modulus=self.balls.modulus,
            thermal_loading=thermal_loading(
                viscosity=oil.viscosity,
                viscosity_temperature=oil.viscosity_temperature,
                entrainment_speed=self.entrainment_speed,
                conductivity=self.lubricant.thermal_conductivity,
            ),
            slide_to_roll=0.0,
        )

    def largest_asperity_share(self, heating_factor: Array | float = 1.0) -> Array:
        """Bound on the asperities' share: p_a(h) A_H/F at the film of smooth surfaces, at most 1.

        It is a bound because the film of a shared load is thicker.
        """
        share = np.zeros(self.balls.load.shape)
        for race, table in enumerate(self.tables):
            if table is not None:
                with np.errstate(all="ignore"):  # without load there is nothing to share
                    log_share = table.log_pressure((self.film.thickness * heating_factor)[race])
                    log_share = log_share + np.log(self.balls.contacts.area[race] / self.balls.load[race])
                share[race] = np.exp(np.minimum(np.nan_to_num(log_share, nan=-np.inf), 0.0))
        return self._without_film(share)

    def largest_asperity_area(self, heating_factor: Array | float = 1.0) -> Array:
        """Bound on the asperities' share of the area: A_a/A_H at the film of smooth surfaces."""
        film = self.film.thickness * heating_factor
        fractions = [
            np.zeros(height.shape) if table is None else table.area_fraction(height)
            for table, height in zip(self.tables, film, strict=True)
        ]
        return self._without_film(np.stack(fractions))

    def _without_film(self, share: Array) -> Array:
        """The share, and 1 where rough surfaces have no film between them."""
        rough = np.reshape([table is not None for table in self.tables], (2, 1, 1))
        return np.where(rough & (self.film.thickness <= 0), 1.0, share)

    def oil_friction(self, slip_speed: Array, *, oil_share: Array | float = 1.0) -> Array:
        """(2, n, m) tau A_H, N, of smooth surfaces at slip_speed, m/s, with the oil's share of the mean pressure."""
        contacts = self.balls.contacts
        stress = oil_shear_stress(
            self.lubricant,
            pressure=oil_share * contacts.mean_pressure,
            speed=slip_speed,
            film_thickness=self.film.thickness,
        )
        return stress * contacts.area

    def shared(self, *, asperities: bool, heating_factor: Array | float) -> MixedContact:
        """The load, shared by film and asperities or carried by the film alone."""
        balls, factor = self.balls, np.broadcast_to(heating_factor, self.balls.load.shape)
        tables = self.tables if asperities else (None, None)
        if tables[0] is tables[1]:
            return self._mixed(balls.contacts, tables[0], factor)
        races = [self._mixed(balls.race(race), table, factor[race]) for race, table in enumerate(tables)]
        return MixedContact(**{name: np.stack([getattr(race, name) for race in races]) for name in vars(races[0])})

    def traction(self, shared: MixedContact, race: int) -> MixedTraction:
        """The law of traction on one race, (n, m)."""
        return MixedTraction(
            lubricant=self.lubricant,
            boundary_friction=self.surface.boundary_friction,
            asperity_share=shared.asperity_share[race],
            area_fraction=shared.area_fraction[race],
            film_thickness=shared.film_thickness[race],
        )

    def _mixed(self, contact: RollingContact, table: AsperityTable | None, heating_factor: Array) -> MixedContact:
        oil = inlet_viscosity(self.lubricant)
        return mixed_contact(
            contact,
            entrainment_speed=self.entrainment_speed,
            viscosity=oil.viscosity,
            pressure_viscosity=oil.pressure_viscosity,
            asperities=table,
            heating_factor=self.film_factor * heating_factor,
        )


def lubricate_races(
    bearing: Bearing,
    balls: LoadedBalls,
    *,
    lubricant: Lubricant,
    surface: Surface,
    ring_speed: Array,
    film_factor: float = 1.0,
) -> LubricatedRaces:
    """The oil and the finish between balls and races.

    ring_speed : w, (n,), rad/s;  film_factor : on every film of the formula, > 0
    Raises InputError if no hardness is known, if film_factor is not positive, or if a formula refuses the oil.
    """
    require_positive(film_factor=film_factor)
    roughness = gap_roughness(surface)
    tables: list[AsperityTable | None] = [None, None]
    if roughness.rms_roughness > 0:
        tables = [
            tabulated_asperities(
                summits=roughness.summits,
                modulus=float(modulus),
                hardness=softer_hardness(surface, bearing.ball_material, groove.material),
            )
            for modulus, groove in zip(balls.modulus.ravel(), (bearing.inner, bearing.outer), strict=True)
        ]
    speed = ring_speed[:, None] * balls.motion.entrainment_speed
    oil = inlet_viscosity(lubricant)
    film = central_film(
        balls.contacts,
        entrainment_speed=speed,
        viscosity=oil.viscosity,
        pressure_viscosity=oil.pressure_viscosity,
    )
    return LubricatedRaces(
        balls=balls,
        lubricant=lubricant,
        surface=surface,
        roughness=roughness,
        tables=(tables[0], tables[1]),
        ring_speed=ring_speed,
        entrainment_speed=speed,
        film=replace(film, thickness=film_factor * film.thickness),
        film_factor=film_factor,
    )
