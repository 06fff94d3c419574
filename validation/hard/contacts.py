"""Hard cases of the contact: Hertz's formulas, the contact angle, and finite elements against exact Hertz.

Most finite-element cases solve the Hertzian idealisation, whose exact answer is Hertz's, as users get it. Those about
the first mesh take one mesh, fitted to its ellipse.
"""

import math
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
from validation.hard.case import HardCase
from validation.hard.specimens import (
    LARGE,
    LOAD,
    MODULUS,
    SMALL,
    bearing,
    exponent,
    incompressible,
    inner,
    peek,
    with_clearance,
)

LEVEL = 2  # of the mesh recipes, on which a mesh is fitted to its ellipse
ROUGH = 0.1  # deviation of an ellipse from that of its mesh on the first level, where it is up to a tenth too short

# Tolerances, relative, with their reasons
SECOND_LEVEL = (0.005, "the mesh of the second level is up to 0.37 % off Hertz on this ellipse")
ACCURACY = 0.005
AS_REQUIRED = (ACCURACY, "the accuracy required of the finite elements")


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
    return float(thrust_equilibrium(of or bearing(), rule, axial_load=load)["angle"][0])


def radial_distance(load: float) -> float:
    """Radial distance of the groove centres under load over the unloaded one."""
    loaded = thrust_equilibrium(bearing(), ContactAngle(rule="solved", free=0.18), axial_load=load)
    distance = bearing().groove_centre_distance
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


CONTACT_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("Hertz: circle", "equal curvatures, where the elliptic integrals are 0/0",
        "delta = (9 Q^2/(16 E*^2 R))^(1/3), the sphere's closed form", lambda: float(hertz(curvature_y=LARGE).approach),
        1.7248424322368216875e-5),
    HardCase("Hertz: nearly a circle", "curvatures that differ by 1e-12",
        "ln(b/a) = 2/3 of ln(curvature ratio) to first order", lambda: log_elongation(1e-12) / 1e-12, 2 / 3,
        tolerance=(2e-3, "round-off of two lengths, 2e-16 each, against 7e-13")),
    HardCase("Hertz: ratio 1e6", "a ball in a groove whose transverse curvature is a million times smaller",
        "the minor semi-axis, by 40 digits", lambda: float(hertz(curvature_x=1e6 * SMALL).semi_axis_x),
        5.6954968930329252938e-7),
    HardCase("Hertz: ratio 1e-6", "the same with the axes exchanged", "the same length, along the other axis",
        lambda: float(hertz(curvature_x=SMALL, curvature_y=1e6 * SMALL).semi_axis_y), 5.6954968930329252938e-7),
    HardCase("Hertz: 1e-12 N", "a load far below any weight",
        "the approach, by 40 digits: nothing underflows or is cut off", lambda: float(hertz(load=1e-12).approach),
        1.1591145743150080715e-15),
    HardCase("Hertz: no load", "the stiffness load/approach^1.5 where both are 0",
        "the stiffness under any load, by 40 digits", lambda: float(hertz(load=0.0).stiffness), 25340224034.90751422),
    HardCase("Hertz: plastic overload",
        "peak pressure at 1e7 N over that at 10 N: steel would yield, but the elastic law must hold",
        "100, as the peak pressure grows as load^(1/3)",
        lambda: float(hertz(load=1e7).peak_pressure / hertz(load=10.0).peak_pressure), 100.0),
    HardCase("Hertz: incompressible", "E* of two bodies of Poisson ratio 0.4999",
        "E/(2 (1 - nu^2)), which is not singular at 1/2", lambda: contact_modulus(incompressible(), incompressible()),
        137315026494.0011531),
    HardCase("Hertz: steel on PEEK", "a steel ball in a plastic groove, 57 times softer",
        "the approach, by 40 digits, from the compliance of both bodies",
        lambda: hertz_quantities(replace(inner(), race_material=peek())).approach, 7.6737867455896463996e-5,
        tolerance=(1e-12, "the groove's curvature is the difference of two that agree to 4 %")),
    HardCase("Hertz: conformity 0.5", "a groove exactly as wide as the ball",
        "a refusal: the contact is a line, the semi-axis infinite",
        lambda: relative_curvatures(inner(conformity=0.5))[1], refusal="at conformity 0.5 the contact is a line"),
    HardCase("Hertz: NaN load", "a load that is not a number", "a refusal that names the load: NaN must not spread",
        lambda: float(hertz(load=math.nan).approach), refusal="load must be at least 0 and finite, got nan"),
    HardCase("stress: Poisson ratio 0",
        "the largest von Mises stress of a body with Poisson ratio 0: it lies on the surface",
        "that of Hertz's three stresses at the centre, by 40 digits",
        lambda: float(stress_at_zero_ratio().max_von_mises), 1799079313.0461135061),
    HardCase("stress: depth at Poisson ratio 0", "the depth of that stress over the minor semi-axis",
        "0, which nothing may be divided by", lambda: float(stress_at_zero_ratio().max_von_mises_depth) / 0.12e-3, 0.0),
    HardCase("contact angle: vanishing load", "1e-12 N from a free angle of 0.18 rad",
        "the free angle: the contacts do not deform", lambda: angle(0.18, 1e-12), 0.18,
        tolerance=(1e-9, "the approach, 2e-15 m, over the grooves' distance, 4e-4 m, and over al0^2")),
    HardCase("contact angle: from zero",
        "the exponent of the angle over the load from a free angle of 0, where thrust has no lever",
        "1/4: delta = A0 al^2/2, so Q goes as al^3, and Fa = Z Q al as al^4",
        lambda: exponent(lambda load: angle(0.0, load), 1e-10, 1e-9), 0.25,
        tolerance=(1e-6, "the next term, of relative size al^2, is 1e-7 there")),
    HardCase("contact angle: preload", "14 um of interference under 1e-12 N: cos al0 would exceed 1",
        "half of the interference remains as each ball's approach, and the angle is nearly 0",
        lambda: float(approaches(thrust_equilibrium(with_clearance(-14e-6), ContactAngle(rule="solved"),
            axial_load=1e-12)).sum()), 7e-6,
        tolerance=(1e-9, "radii of 20 mm in doubles, 4e-18 m, and an angle below 1e-12 rad")),
    HardCase("contact angle: loose rings", "a clearance of 0.81 mm, more than twice the groove-centre distance",
        "a refusal: at no angle do the balls stop the rings", lambda: angle(None, 5.0, of=with_clearance(0.81e-3)),
        refusal="diametral clearance 0.81 mm must be below 2 A0"),
    HardCase("contact angle: huge load",
        "radial distance of the groove centres at 1e9 N, near a right angle, over the unloaded one",
        "1: the angle stays below pi/2, and the radial distance does not change", lambda: radial_distance(1e9), 1.0,
        tolerance=(1e-12, "the cosine, 0.007, of an angle that a double holds to 2e-16")),
    HardCase("contact angle: preload with a frozen stiffness",
        "the stiffness at the free angle of a preloaded bearing, which has no free angle",
        "a refusal that names the method to use",
        lambda: float(thrust_equilibrium_frozen(with_clearance(-14e-6), ContactAngle(rule="solved"),
            axial_load=5.0)["angle"][0]), refusal="the frozen stiffness is that of the free contact angle"),
    HardCase("contact: 1e-6 N", "finite elements on an ellipse of 0.14 by 1.3 um",
        "Hertz's approach, by 40 digits: the mesh follows the contact", lambda: referenced(inner(load=1e-6)).approach,
        1.1612003284194039775e-11, tolerance=AS_REQUIRED),
    HardCase("contact: load to the two thirds",
        "the exponent of the approach from 1e-6 to 100 N, each load on its own mesh",
        "2/3: half spaces have no length of their own",
        lambda: exponent(lambda load: meshed(inner(load=load), level=1).approach, 1e-6, 1e2), 2 / 3,
        tolerance=(1e-6, "the meshes are alike, so that their errors cancel to round-off")),
    HardCase("contact: incompressible", "Poisson ratio 0.4999, where fully integrated cells lock",
        "Hertz's peak pressure, by 40 digits", lambda: referenced(inner(material=incompressible())).peak_pressure,
        2482423059.3511842575, tolerance=AS_REQUIRED),
    HardCase("contact: close groove", "conformity 0.505, an ellipse 21 times as long as wide",
        "Hertz's major semi-axis, by 40 digits", lambda: referenced(inner(conformity=0.505)).semi_axis_transverse,
        1.9302041651009105401e-3, tolerance=AS_REQUIRED),
    HardCase("contact: mesh ten times too small", "a first mesh of a tenth of the ellipse, where every node touches",
        "Hertz's minor semi-axis, by 40 digits: the answer does not depend on the first mesh",
        lambda: meshed(inner(), scale=(0.1, 0.1)).semi_axis_rolling, 1.2091146725908945613e-4, tolerance=SECOND_LEVEL),
    HardCase("contact: mesh ten times too large", "a first mesh of ten times the ellipse",
        "Hertz's approach, by 40 digits: the answer does not depend on the first mesh",
        lambda: meshed(inner(), scale=(10.0, 10.0)).approach, 8.4430937122525567274e-6, tolerance=SECOND_LEVEL),
    HardCase("contact: first mesh touched by one node",
        "a first mesh a hundred times too large, where a single node touches",
        "Hertz's peak pressure, by 40 digits: the mesh shrinks until it resolves the contact",
        lambda: meshed(inner(), scale=(100.0, 100.0)).peak_pressure, 2182366274.905845588, tolerance=SECOND_LEVEL),
    HardCase("contact: cut off by 2 %",
        "a groove that ends 2 % before the ellipse, so that half of the contact is meshed",
        "Hertz's approach, by 40 digits: only 3e-4 of the load is cut off. Wrong if the shoulder is ignored", cut_off,
        8.4430937122525567274e-6, tolerance=SECOND_LEVEL),
    HardCase("contact: far over its shoulder", "an ellipse 3.7 times as wide as the groove",
        "a refusal with the widest contact that the mesh allows",
        lambda: referenced(replace(inner(), shoulder=0.3e-3), recipe="race").approach,
        refusal="its shoulder stands at 0.3 mm: the mesh holds up to 3 times that"),
    HardCase("contact: past the ball", "2e5 N on the true ball and groove: the ellipse would reach around the ball",
        "a refusal with the widest contact that the mesh allows",
        lambda: referenced(inner(load=2e5), recipe="race").approach, refusal="too wide for a ball of radius"),
)  # fmt: skip
