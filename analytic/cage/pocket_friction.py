"""Friction of a ball in its cage pocket: a given coefficient, or mixed lubrication of a contact of nearly equal radii.

The pocket stands still against the rotating ball, so the rolling and entrainment speed is half of the sliding speed.
This is far outside the range that film formulas were fitted to. Between nearly equal radii and under the small forces
of a cage the computed film is thicker than the clearance, and it is limited to the clearance. Oil is then taken to
shear in the contact of Hertz alone; its shear in the rest of the pocket is not in the coefficient.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import elliptic_contact
from analytic.errors import InputError
from analytic.oil.film import film_asymptotes
from analytic.oil.mixed import mixed_contact
from analytic.oil.traction import mixed_traction
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Scene
from analytic.surface.gap import gap_law
from analytic.surface.roughness import gap_roughness


@dataclass(frozen=True, kw_only=True, eq=False)
class PocketFriction:
    """The friction coefficient at every operating point, where it comes from, and its warnings."""

    coefficient: Array  # (n,)
    source: str  # a key of the scene file, or the model
    warnings: tuple[str, ...] = ()


def friction_in_pocket(scene: Scene, *, load: ArrayLike, surface_speed: ArrayLike) -> PocketFriction:
    """mu of ball on pocket: the coefficient of the cage, else that of the races, else by lubricant and surface.

    load : of one ball on the pocket, (n,), N, > 0;  surface_speed : w_b r, (n,), m/s, >= 0
    Raises InputError for a scene without a cage, or without any of these.
    """
    cage, lubricant, surface = scene.cage, scene.lubricant, scene.surface
    if cage is None:
        raise InputError("the scene has no [cage], so there is no pocket: add an empty table [cage] for the catalog's")
    force, speed = np.broadcast_arrays(np.asarray(load, dtype=np.float64), np.asarray(surface_speed, dtype=np.float64))
    given = scene.friction_coefficient if cage.friction_coefficient is None else cage.friction_coefficient
    if given is not None:
        key = "friction.coefficient" if cage.friction_coefficient is None else "cage.friction_coefficient"
        return PocketFriction(coefficient=np.full(force.shape, given), source=key)
    if lubricant is None or surface is None:
        raise InputError("the friction of ball on pocket is not known: add [cage] friction_coefficient = 0.1")
    pocket = pocket_contact(scene.bearing, cage, load=0.0)
    curvature = 1 / pocket.ball_radius - 1 / pocket.groove_radius
    modulus = float(contact_modulus(pocket.ball_material, pocket.race_material))
    contact = elliptic_contact(curvature_rolling=curvature, curvature_transverse=curvature, load=force, modulus=modulus)
    gap = gap_law(surface, gap_roughness(surface), modulus=modulus, bodies=(pocket.ball_material, pocket.race_material))
    oil = inlet_viscosity(lubricant)
    film = film_asymptotes(
        contact,
        entrainment_speed=speed / 2,
        viscosity=oil.viscosity,
        pressure_viscosity=oil.pressure_viscosity,
        largest_gap=pocket.groove_radius - pocket.ball_radius,
        compressible=lubricant.compressible,
    )
    shared = mixed_contact(contact, film, gap=gap)
    traction = mixed_traction(lubricant, surface.boundary_friction, shared)
    warnings = ()
    if np.any(shared.capped):
        warnings = (
            "the computed film in the cage pockets is thicker than their clearance: its formula does not hold between "
            "nearly equal radii, and oil that shears outside the contact is not counted; [cage] friction_coefficient "
            "replaces both",
        )
    return PocketFriction(
        coefficient=traction.force(contact)(speed) / force, source="mixed lubrication", warnings=warnings
    )
