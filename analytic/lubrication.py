"""A rough ball on a lubricated rough race: from the scene's oil and finish to film, shared load and law of traction.

The film is that of the oil at the inlet of the contact, thinned by its own shear heating there; rolling nearly without
sliding, flooded.
"""

from dataclasses import dataclass

import numpy as np

from analytic.asperity import softer_hardness
from analytic.asperity_table import AsperityTable, tabulated_asperities
from analytic.contact import Race, race_curvatures
from analytic.errors import require_positive
from analytic.film import inlet_heating_factor, thermal_loading
from analytic.hertz import HertzContact, contact_modulus
from analytic.mixed import MixedContact, mixed_contact
from analytic.roughness import GapRoughness
from analytic.scene import Array, Bearing, Lubricant, Surface
from analytic.traction import MixedTraction
from analytic.viscosity import inlet_viscosity


@dataclass(frozen=True, kw_only=True, eq=False)
class LubricatedRace:
    """Balls on one race; arrays of the shape of their loads."""

    shared: MixedContact
    traction: MixedTraction


def lubricated_race(
    bearing: Bearing,
    race: Race,
    *,
    lubricant: Lubricant,
    surface: Surface,
    roughness: GapRoughness,
    contact_angle: Array,
    load: Array,
    contact: HertzContact,
    entrainment_speed: Array,
    film_factor: float = 1.0,
) -> LubricatedRace:
    """The load shared between oil and asperities, and what they resist sliding with; the arrays broadcast.

    roughness : `roughness.gap_roughness` of the surface
    film_factor : on the film that the formula gives, > 0
    contact_angle : al, rad;  load : Q, N;  contact : Hertz's at that load;  entrainment_speed : u, m/s, any sign
    Sliding adds next to nothing to the heat at the inlet, as a ball slides by less than a hundredth of its rolling.
    Raises InputError if no hardness is known, if film_factor is not positive, and as the formulas do for an oil out of
    range.
    """
    require_positive(film_factor=film_factor)
    groove = bearing.inner if race == "inner" else bearing.outer
    modulus = contact_modulus(bearing.ball_material, groove.material)
    along, across = race_curvatures(bearing, race, contact_angle=contact_angle)
    oil = inlet_viscosity(lubricant)
    asperities: AsperityTable | None = None
    if roughness.rms_roughness > 0:
        hardness = softer_hardness(surface, bearing.ball_material, groove.material)
        asperities = tabulated_asperities(summits=roughness.summits, modulus=modulus, hardness=hardness)
    heating = inlet_heating_factor(
        peak_pressure=contact.peak_pressure,
        modulus=modulus,
        thermal_loading=thermal_loading(
            viscosity=oil.viscosity,
            viscosity_temperature=oil.viscosity_temperature,
            entrainment_speed=entrainment_speed,
            conductivity=lubricant.thermal_conductivity,
        ),
        slide_to_roll=0.0,
    )
    shared = mixed_contact(
        curvature_x=along,
        curvature_y=across,
        load=load,
        modulus=modulus,
        contact_area=np.pi * contact.semi_axis_x * contact.semi_axis_y,
        entrainment_speed=entrainment_speed,
        viscosity=oil.viscosity,
        pressure_viscosity=oil.pressure_viscosity,
        asperities=asperities,
        heating_factor=film_factor * heating,
    )
    return LubricatedRace(
        shared=shared,
        traction=MixedTraction(
            lubricant=lubricant,
            boundary_friction=surface.boundary_friction,
            asperity_share=shared.asperity_share,
            area_fraction=shared.area_fraction,
            film_thickness=shared.film_thickness,
        ),
    )
