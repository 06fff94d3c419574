"""A rough contact in oil as the tests of the shared load vary it."""

from analytic.oil.film import central_film, film_asymptotes
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.scene import Array, AsperityLaw, Autocorrelation, Surface
from analytic.surface.gap import GapLaw, gap_law
from analytic.surface.roughness import gap_roughness
from analytic.surface.truncated_gap import TruncatedGap
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


def rough(
    sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang", *, modulus: float = E
) -> TruncatedGap:
    """Two surfaces of this roughness against each other, that are cut off where they overlap."""
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 30)
    surface = Surface(rms_roughness=sq, autocorrelation=correlation, hardness=H, gap="truncated", asperities=asperities)
    found = gap_law(surface, gap_roughness(surface), modulus=modulus, bodies=(STEEL, STEEL))
    assert isinstance(found, TruncatedGap)
    return found


def area(load: float = 613.0) -> float:
    return float(hertzian(CONTACT | {"load": load})[0].area)


def mixed(gap: GapLaw | None, **changed: object) -> MixedContact:
    contact, rest = hertzian(CONTACT | OIL | changed)
    factors = {name: rest.pop(name) for name in ("film_factor", "pressure_factor", "share_step") if name in rest}
    return mixed_contact(contact, film_asymptotes(contact, **rest), gap=gap, **factors)


def smooth_film(**changed: object) -> Array:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return central_film(contact, **rest).thickness
