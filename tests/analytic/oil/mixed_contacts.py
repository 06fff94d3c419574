"""A rough contact in oil as the tests of the shared load vary it."""

import numpy as np

from analytic.oil.film import Inflow, asymptotes_of, central_film
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.scene import Array, AsperityLaw, Autocorrelation, Surface
from analytic.surface.gap import GapNumbers, gap_law
from analytic.surface.moments import Summits
from analytic.surface.roughness import gap_roughness
from tests.analytic.specimens import hertzian
from tests.contacts import STEEL

E, H = 113.187e9, 7.8e9  # Pa
CONTACT = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": E,
    "entrainment_speed": 0.37,
}
OIL = {"viscosity": 0.061, "pressure_viscosity": 2.1e-8}
ACCURACY = 2e-8  # of the share: 1e-8 of the table, twice where both of its splines take part


def finish(sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang") -> Surface:
    """Two surfaces of this roughness against each other, that are cut off where they overlap."""
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 30)
    return Surface(rms_roughness=sq, autocorrelation=correlation, hardness=H, gap="truncated", asperities=asperities)


def rough(
    sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang", *, modulus: float = E
) -> GapNumbers:
    surface = finish(sq, length, asperities)
    return gap_law(surface, gap_roughness(surface), modulus=modulus, bodies=(STEEL, STEEL))


def summits_of(sq: float) -> Summits:
    return gap_roughness(finish(sq)).summits


def area(load: float = 613.0) -> float:
    contact, _ = hertzian(CONTACT | {"load": load})
    return float(np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse)


def mixed(gap: GapNumbers, **changed: object) -> MixedContact:
    contact, rest = hertzian(CONTACT | OIL | changed)
    factors = {name: rest.pop(name) for name in ("film_factor", "pressure_factor", "share_step") if name in rest}
    inflow = Inflow(rest.pop("entrainment_speed"), **rest)
    return mixed_contact(contact, asymptotes_of(contact, inflow), gap, **factors)


def smooth_film(**changed: object) -> Array:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return central_film(contact, **rest).thickness
