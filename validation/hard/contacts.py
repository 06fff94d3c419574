"""Hard cases of the contact: Hertz's formulas, the contact angle, and finite elements against exact Hertz.

Most finite-element cases solve the Hertzian idealisation, whose exact answer is Hertz's, as users get it. Those about
the first mesh take one mesh, fitted to its ellipse.
"""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.subsurface import SubsurfaceMaximum, subsurface_maximum
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.scene import Bearing, Contact, ContactAngle
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.refinement import Wanted, solve_reference
from fembearing.check.contact.scene_contact import as_meshed
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import fitted_on_level, fitted_solution
from fembearing.mesh.recipe import load_recipe
from validation.hard.specimens import (
    BEARING,
    INCOMPRESSIBLE,
    LARGE,
    LOAD,
    MODULUS,
    PEEK,
    SMALL,
    exponent,
    inner,
    with_clearance,
)

LEVEL = 2  # of the mesh recipes, on which a mesh is fitted to its ellipse
ACCURACY = 0.005  # required of the finite elements
ROUGH = 0.1  # deviation of an ellipse from that of its mesh on the first level, where it is up to a tenth too short


def hertz(**changed: float) -> HertzContact:
    arguments = {"curvature_x": LARGE, "curvature_y": SMALL, "load": LOAD, "modulus": MODULUS} | changed
    return hertz_contact(**arguments)


def log_elongation(difference: float) -> float:
    """ln(b/a) of curvatures with a small relative difference."""
    ellipse = hertz(curvature_x=LARGE * (1 + difference), curvature_y=LARGE)
    return math.log(float(ellipse.semi_axis_y / ellipse.semi_axis_x))


def stress_at_zero_ratio() -> SubsurfaceMaximum:
    return subsurface_maximum(peak_pressure=2.1e9, semi_axis_x=0.12e-3, semi_axis_y=1.1e-3, poisson_ratio=0.0)


def angle(free: float | None, load: float, *, of: Bearing | None = None) -> float:
    """The loaded contact angle, rad."""
    rule = ContactAngle(rule="solved", free=free)
    return float(thrust_equilibrium(of or BEARING, rule, axial_load=load)["angle"][0])


def radial_distance(load: float) -> float:
    """Radial distance of the groove centres under load over the unloaded one."""
    loaded = thrust_equilibrium(BEARING, ContactAngle(rule="solved", free=0.18), axial_load=load)
    distance = BEARING.groove_centre_distance
    return float((distance + approaches(loaded).sum()) * np.cos(loaded["angle"][0]) / (distance * np.cos(0.18)))


def meshed(
    contact: Contact, *, recipe: str = "hertzian", level: int = LEVEL, scale: tuple[float, float] = (1.0, 1.0)
) -> Quantities:
    """A contact on one mesh.

    scale : factors by which the first mesh is too large in the rolling and the transverse direction
    """
    made = load_recipe(recipe)
    contact = as_meshed(contact, recipe=made)
    rolling, transverse = expected_semi_axes(contact)
    guess = scale[0] * rolling, scale[1] * transverse
    if level == LEVEL:
        return fitted_solution(contact, recipe=made, guess=guess).quantities
    return fitted_on_level(contact, recipe=made, level=level, start=guess, good=ROUGH).quantities


def cut_off() -> float:
    """Approach, m, of a contact cut off at 1.1 mm; NaN unless its mesh ends at the shoulder."""
    cut = replace(inner(), shoulder=1.1e-3)
    solution = fitted_solution(cut, recipe=load_recipe("hertzian"))
    is_cut = solution.pair.footprint.half and solution.shoulder is not None
    return solution.quantities.approach if is_cut else math.nan


def referenced(contact: Contact, *, recipe: str = "hertzian") -> Quantities:
    """A contact as users get it: from as many meshes as `ACCURACY` needs, extrapolated."""
    made = load_recipe(recipe)
    contact = as_meshed(contact, recipe=made)
    reference = solve_reference(contact, Wanted(made, accuracy=ACCURACY))
    return Quantities(**{name: part.value for name, part in reference.estimates.items()})


CONTACT_CASES: dict[str, Callable[[], float]] = {
    "Hertz: circle": lambda: float(hertz(curvature_y=LARGE).approach),
    "Hertz: nearly a circle": lambda: log_elongation(1e-12) / 1e-12,
    "Hertz: ratio 1e6": lambda: float(hertz(curvature_x=1e6 * SMALL).semi_axis_x),
    "Hertz: ratio 1e-6": lambda: float(hertz(curvature_x=SMALL, curvature_y=1e6 * SMALL).semi_axis_y),
    "Hertz: 1e-12 N": lambda: float(hertz(load=1e-12).approach),
    "Hertz: no load": lambda: float(hertz(load=0.0).stiffness),
    "Hertz: plastic overload": lambda: float(hertz(load=1e7).peak_pressure / hertz(load=10.0).peak_pressure),
    "Hertz: incompressible": lambda: contact_modulus(INCOMPRESSIBLE, INCOMPRESSIBLE),
    "Hertz: steel on PEEK": lambda: hertz_quantities(replace(inner(), race_material=PEEK)).approach,
    "Hertz: conformity 0.5": lambda: relative_curvatures(inner(conformity=0.5))[1],
    "Hertz: NaN load": lambda: float(hertz(load=math.nan).approach),
    "stress: Poisson ratio 0": lambda: float(stress_at_zero_ratio().max_von_mises),
    "stress: depth at Poisson ratio 0": lambda: float(stress_at_zero_ratio().max_von_mises_depth) / 0.12e-3,
    "contact angle: vanishing load": lambda: angle(0.18, 1e-12),
    "contact angle: from zero": lambda: exponent(lambda load: angle(0.0, load), 1e-10, 1e-9),
    "contact angle: preload": lambda: float(
        approaches(thrust_equilibrium(with_clearance(-14e-6), ContactAngle(rule="solved"), axial_load=1e-12)).sum()
    ),
    "contact angle: loose rings": lambda: angle(None, 5.0, of=with_clearance(0.81e-3)),
    "contact angle: huge load": lambda: radial_distance(1e9),
    "contact angle: preload with a frozen stiffness": lambda: float(
        thrust_equilibrium_frozen(with_clearance(-14e-6), ContactAngle(rule="solved"), axial_load=5.0)["angle"][0]
    ),
    "contact: 1e-6 N": lambda: referenced(inner(load=1e-6)).approach,
    "contact: load to the two thirds": lambda: exponent(
        lambda load: meshed(inner(load=load), level=1).approach, 1e-6, 1e2
    ),
    "contact: incompressible": lambda: referenced(inner(material=INCOMPRESSIBLE)).peak_pressure,
    "contact: close groove": lambda: referenced(inner(conformity=0.505)).semi_axis_transverse,
    "contact: mesh ten times too small": lambda: meshed(inner(), scale=(0.1, 0.1)).semi_axis_rolling,
    "contact: mesh ten times too large": lambda: meshed(inner(), scale=(10.0, 10.0)).approach,
    "contact: first mesh touched by one node": lambda: meshed(inner(), scale=(100.0, 100.0)).peak_pressure,
    "contact: cut off by 2 %": cut_off,
    "contact: far over its shoulder": lambda: referenced(replace(inner(), shoulder=0.3e-3), recipe="race").approach,
    "contact: past the ball": lambda: referenced(inner(load=2e5), recipe="race").approach,
}
