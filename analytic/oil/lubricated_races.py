"""Rough balls on lubricated rough races: film, shared load and law of traction from the scene's oil and finish.

The film is flooded, and the balls roll nearly without sliding. The oil has its properties at the inlet of the contact.
Arrays are (2, n, m): races, operating points, balls.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.loads.balls import LoadedBalls
from analytic.oil.asymptotes import FilmAsymptotes
from analytic.oil.film import film_asymptotes
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import MixedTraction, mixed_traction
from analytic.oil.variation import Variation
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Bearing, Lubricant, Surface
from analytic.surface.gap import GapLaw, gap_law
from analytic.surface.roughness import GapRoughness, gap_roughness


@dataclass(frozen=True, kw_only=True, eq=False)
class LubricatedRaces:
    """Loaded balls on both races, with the oil and the finish between them."""

    balls: LoadedBalls
    lubricant: Lubricant
    surface: Surface
    roughness: GapRoughness
    gaps: tuple[GapLaw | None, GapLaw | None]  # of inner and outer race; None: smooth
    ring_speed: Array  # (n,) w, rad/s
    film: FilmAsymptotes  # (2, n, m) of smooth surfaces, flooded and isothermal
    variation: Variation

    def at(self, points: NDArray[np.intp]) -> "LubricatedRaces":
        """The same at some operating points."""
        film = FilmAsymptotes(*(values[:, points] for values in self.film))
        return replace(self, balls=self.balls.at(points), ring_speed=self.ring_speed[points], film=film)

    def mixed(self, *, asperities: bool, film_factor: Array | float) -> MixedContact:
        """The load, shared by film and asperities or carried by the film alone; (2, n, m).

        film_factor : of heated and starved inlets, on the film
        """
        balls, factor = self.balls, self.variation.film * np.broadcast_to(film_factor, self.balls.load.shape)
        gaps, pressure = self.gaps if asperities else (None, None), self.variation.asperity_pressure
        if gaps[0] is gaps[1]:
            contacts = balls.contacts
            return mixed_contact(contacts, self.film, gap=gaps[0], film_factor=factor, pressure_factor=pressure)
        films = np.broadcast_arrays(*self.film, factor)[:-1]
        races = [
            mixed_contact(
                balls.races[race],
                FilmAsymptotes(*(values[race] for values in films)),
                gap=gap,
                film_factor=factor[race],
                pressure_factor=pressure,
            )
            for race, gap in enumerate(gaps)
        ]
        return MixedContact(**{name: np.stack([getattr(race, name) for race in races]) for name in vars(races[0])})

    def traction(self, mixed: MixedContact) -> MixedTraction:
        """The law of traction of mixed contacts."""
        return mixed_traction(self.lubricant, self.surface.boundary_friction, mixed)


def lubricate_races(
    bearing: Bearing,
    balls: LoadedBalls,
    *,
    lubricant: Lubricant,
    surface: Surface,
    ring_speed: Array,
    variation: Variation,
) -> LubricatedRaces:
    """The oil and the finish between balls and races.

    ring_speed : w, (n,), rad/s
    Raises InputError if no hardness is known or if a formula refuses the oil.
    """
    roughness = gap_roughness(surface)
    bodies = [(bearing.ball_material, groove.material) for groove in (bearing.inner, bearing.outer)]
    inner, outer = (
        gap_law(surface, roughness, modulus=float(modulus), bodies=pair)
        for modulus, pair in zip(balls.modulus.ravel(), bodies, strict=True)
    )
    oil = inlet_viscosity(lubricant)
    return LubricatedRaces(
        balls=balls,
        lubricant=lubricant,
        surface=surface,
        roughness=roughness,
        gaps=(inner, inner if bodies[0] == bodies[1] else outer),
        ring_speed=ring_speed,
        film=film_asymptotes(
            balls.contacts,
            entrainment_speed=ring_speed[:, None] * balls.motion.entrainment_speed,
            viscosity=oil.viscosity,
            pressure_viscosity=oil.pressure_viscosity,
            compressible=lubricant.compressible,
        ),
        variation=variation,
    )
