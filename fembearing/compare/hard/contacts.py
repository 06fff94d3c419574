"""Hard cases of the contact: Hertz's formulas, the contact angle, and finite elements against exact Hertz.

The finite-element rows solve the Hertzian idealisation, whose exact answer is Hertz's, as users get it; those about
the first mesh itself take one mesh, fitted to its ellipse.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np

from analytic.contact.geometry import race_contact
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.subsurface import SubsurfaceMaximum, subsurface_maximum
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.scene import Bearing, Contact, ContactAngle, Material
from analytic.scenefile.read import builtin_scene, load_scene
from fembearing.compare.contact.hertz import hertz_quantities
from fembearing.compare.contact.mesh_refinement import solve_reference
from fembearing.compare.hard.case import HardCase
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import GOOD_GUESSES, fitted_on_level, fitted_solution
from fembearing.mesh.recipe import load_recipe
from fembearing.progress import silent

LARGE, SMALL, MODULUS = 310.0, 9.7, 1.13e11  # 1/m, 1/m, Pa: a steel ball on the inner race of a small bearing
LOAD = 613.0  # N
ANGLE, BALL_LOAD = 0.18, 620.0  # rad, N: the inner race contact of the 6205
LEVEL = 2  # the second of the mesh recipes: a mesh is fitted to its ellipse there

# Tolerances, relative, with their reasons
ROUND_OFF = (1e-13, "a few hundred roundings of a double")
SECOND_LEVEL = (0.005, "the mesh of the second level is up to 0.37 % off Hertz on this ellipse")
ACCURACY = 0.005
AS_ASKED = (ACCURACY, "the accuracy asked of the finite elements")


@cache
def bearing() -> Bearing:
    """The built-in 6205."""
    return load_scene(builtin_scene("6205")).bearing


def with_clearance(clearance: float) -> Bearing:
    """The 6205 with its outer ring opened to a diametral clearance, m; negative is preload."""
    touching = bearing().inner.bottom_radius + bearing().ball_diameter
    return replace(bearing(), outer=replace(bearing().outer, bottom_radius=touching + clearance / 2))


def hertz(**changed: float) -> HertzContact:
    arguments = {"curvature_x": LARGE, "curvature_y": SMALL, "load": LOAD, "modulus": MODULUS} | changed
    return hertz_contact(**arguments)


def inner(*, load: float = BALL_LOAD, material: Material | None = None, conformity: float | None = None) -> Contact:
    """The ball on the inner race of the 6205; `material` is that of both bodies, `conformity` is r_g/D."""
    found = race_contact(bearing(), "inner", contact_angle=ANGLE, ball_load=load)
    if material is not None:
        found = replace(found, ball_material=material, race_material=material)
    if conformity is not None:
        found = replace(found, groove_radius=2 * conformity * found.ball_radius)
    return found


def incompressible() -> Material:
    return replace(bearing().ball_material, poisson_ratio=0.4999)


def peek() -> Material:
    return Material(name="peek", youngs_modulus=3.6e9, poisson_ratio=0.38, density=1300.0, source="the catalog's")


def angle(free: float | None, load: float, *, of: Bearing | None = None) -> float:
    """The loaded contact angle, rad."""
    rule = ContactAngle(rule="solved", free=free)
    return float(thrust_equilibrium(of or bearing(), rule, axial_load=load).contact_angle)


def closure(load: float) -> float:
    """Groove centres: radial distance under load over the unloaded one, 1 whatever the load."""
    found = thrust_equilibrium(bearing(), ContactAngle(rule="solved", free=0.18), axial_load=load)
    distance = bearing().groove_centre_distance
    return float((distance + found.approach) * np.cos(found.contact_angle) / (distance * np.cos(0.18)))


def meshed(
    contact: Contact,
    *,
    recipe: str = "hertzian",
    level: int = LEVEL,
    scale: tuple[float, float] = (1.0, 1.0),
) -> Quantities:
    """A contact by finite elements.

    scale : makes the first mesh that many times too large along rolling and across
    """
    made = load_recipe(recipe)
    if made.geometry == "hertzian":
        contact = replace(contact, shoulder=math.inf)
    along, across = expected_semi_axes(contact)
    guess = scale[0] * along, scale[1] * across
    if level == LEVEL:
        return fitted_solution(contact, recipe=made, guess=guess).quantities
    return fitted_on_level(contact, recipe=made, level=level, start=guess, good=GOOD_GUESSES[0]).quantities


def grazing() -> float:
    """Approach, m, of a contact cut off at 1.1 mm; NaN unless its mesh saw the shoulder."""
    cut = replace(inner(), shoulder=1.1e-3)
    found = fitted_solution(cut, recipe=load_recipe("hertzian"))
    return found.quantities.approach if found.pair.footprint.half and found.shoulder is not None else math.nan


def referenced(contact: Contact, *, recipe: str = "hertzian") -> Quantities:
    """A contact as users get it: from as many meshes as `ACCURACY` needs, extrapolated."""
    made = load_recipe(recipe)
    if made.geometry == "hertzian":
        contact = replace(contact, shoulder=math.inf)
    found = solve_reference(contact, recipe=made, accuracy=ACCURACY, progress=silent)
    return Quantities(**{name: part.value for name, part in found.estimates.items()})


def exponent(quantity: Callable[[float], float], low: float, high: float) -> float:
    """Of the load, N, between two of them."""
    return math.log(quantity(high) / quantity(low)) / math.log(high / low)


CONTACT_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="Hertz: circle",
        asked="equal curvatures, where the elliptic integrals are 0/0",
        right="delta = (9 Q^2/(16 E*^2 R))^(1/3), the sphere's closed form",
        evaluate=lambda: float(hertz(curvature_y=LARGE).approach),
        expected=1.7248424322368216875e-5,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: nearly a circle",
        asked="curvatures that differ by 1e-12",
        right="ln(b/a) = 2/3 of ln(curvature ratio) to first order",
        evaluate=lambda: _log_elongation(1e-12) / 1e-12,
        expected=2 / 3,
        tolerance=(2e-3, "round-off of two lengths, 2e-16 each, against 7e-13"),
    ),
    HardCase(
        name="Hertz: ratio 1e6",
        asked="a ball in a groove a million times flatter across",
        right="minor semi-axis by 40 digits",
        evaluate=lambda: float(hertz(curvature_x=1e6 * SMALL).semi_axis_x),
        expected=5.6954968930329252938e-7,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: ratio 1e-6",
        asked="the same with the axes exchanged",
        right="the minor semi-axis lies the other way, of the same length",
        evaluate=lambda: float(hertz(curvature_x=SMALL, curvature_y=1e6 * SMALL).semi_axis_y),
        expected=5.6954968930329252938e-7,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: 1e-12 N",
        asked="a load far below any weight",
        right="approach by 40 digits: nothing underflows or is cut off",
        evaluate=lambda: float(hertz(load=1e-12).approach),
        expected=1.1591145743150080715e-15,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: no load",
        asked="the stiffness load/approach^1.5 where both are 0",
        right="the stiffness that every load has, by 40 digits",
        evaluate=lambda: float(hertz(load=0.0).stiffness),
        expected=25340224034.90751422,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: plastic overload",
        asked="1e7 N against 10 N: steel would yield, the elastic law must still hold",
        right="peak pressure goes as load^(1/3), so 100 times",
        evaluate=lambda: float(hertz(load=1e7).peak_pressure / hertz(load=10.0).peak_pressure),
        expected=100.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: incompressible",
        asked="E* of two bodies of Poisson ratio 0.4999",
        right="E/(2 (1 - nu^2)): nothing in it is singular at 1/2",
        evaluate=lambda: contact_modulus(incompressible(), incompressible()),
        expected=137315026494.0011531,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="Hertz: steel on PEEK",
        asked="a steel ball in a plastic groove, 57 times softer",
        right="approach by 40 digits, from the softness of both bodies",
        evaluate=lambda: hertz_quantities(replace(inner(), race_material=peek())).approach,
        expected=7.6737867455896463996e-5,
        tolerance=(1e-12, "the groove's curvature is the difference of two that agree to 4 %"),
    ),
    HardCase(
        name="Hertz: conformity 0.5",
        asked="a groove exactly as wide as the ball",
        right="a refusal: the contact is a line, the semi-axis infinite",
        evaluate=lambda: relative_curvatures(inner(conformity=0.5))[1],
        refusal="at conformity 0.5 the contact is a line",
    ),
    HardCase(
        name="Hertz: NaN load",
        asked="a load that is not a number",
        right="a refusal that names it: NaN must not spread",
        evaluate=lambda: float(hertz(load=math.nan).approach),
        refusal="load must be at least 0 and finite, got nan",
    ),
    HardCase(
        name="stress: Poisson ratio 0",
        asked="the largest von Mises stress of a body that does not widen: it lies on the surface",
        right="that of Hertz's three stresses in the middle, by 40 digits",
        evaluate=lambda: float(_mises_of_cork().max_von_mises),
        expected=1799079313.0461135061,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="stress: depth at Poisson ratio 0",
        asked="one and the depth of that stress over the minor semi-axis",
        right="1: none, by which nothing may be divided",
        evaluate=lambda: 1 + float(_mises_of_cork().max_von_mises_depth) / 0.12e-3,
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="contact angle: vanishing load",
        asked="1e-12 N from a free angle of 0.18 rad",
        right="the free angle: the balls do not give",
        evaluate=lambda: angle(0.18, 1e-12),
        expected=0.18,
        tolerance=(1e-9, "the approach, 2e-15 m, over the grooves' distance, 4e-4 m, and over al0^2"),
    ),
    HardCase(
        name="contact angle: from zero",
        asked="how the angle grows from a free angle of 0, where no force has a lever",
        right="load^(1/4): delta = A0 al^2/2, so Q goes as al^3, and Fa = Z Q al as al^4",
        evaluate=lambda: exponent(lambda load: angle(0.0, load), 1e-10, 1e-9),
        expected=0.25,
        tolerance=(1e-6, "the next term, of relative size al^2, is 1e-7 there"),
    ),
    HardCase(
        name="contact angle: preload",
        asked="14 um of interference under 1e-12 N: cos al0 would exceed 1",
        right="the ball keeps half of the interference as approach, and the angle is all but 0",
        evaluate=lambda: float(
            thrust_equilibrium(with_clearance(-14e-6), ContactAngle(rule="solved"), axial_load=1e-12).approach
        ),
        expected=7e-6,
        tolerance=(1e-9, "radii of 20 mm in doubles, 4e-18 m, and an angle below 1e-12 rad"),
    ),
    HardCase(
        name="contact angle: loose rings",
        asked="a clearance of 0.81 mm, more than twice the groove-centre distance",
        right="a refusal: no angle stops the rings",
        evaluate=lambda: angle(None, 5.0, of=with_clearance(0.81e-3)),
        refusal="diametral clearance 0.00081 m must be below 2 A0",
    ),
    HardCase(
        name="contact angle: huge load",
        asked="1e9 N: the angle comes near a right angle",
        right="below pi/2, with the groove centres where they were: the ratio of radial distances is 1",
        evaluate=lambda: closure(1e9),
        expected=1.0,
        tolerance=(1e-12, "the cosine, 0.007, of an angle that a double holds to 2e-16"),
    ),
    HardCase(
        name="contact angle: preload with a frozen stiffness",
        asked="the stiffness at the free angle of a bearing that has none",
        right="a refusal that names the form that can do it",
        evaluate=lambda: float(
            thrust_equilibrium_frozen(with_clearance(-14e-6), ContactAngle(rule="solved"), axial_load=5.0).contact_angle
        ),
        refusal="the frozen stiffness is that of the free contact angle",
    ),
    HardCase(
        name="contact: 1e-6 N",
        asked="finite elements on an ellipse of 0.14 by 1.3 um",
        right="Hertz's approach, by 40 digits: the mesh follows the contact",
        evaluate=lambda: referenced(inner(load=1e-6)).approach,
        expected=1.1612003284194039775e-11,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: load to the two thirds",
        asked="approach from 1e-6 to 100 N, on a mesh made for each load",
        right="exponent 2/3: half spaces have no length of their own",
        evaluate=lambda: exponent(lambda load: meshed(inner(load=load), level=1).approach, 1e-6, 1e2),
        expected=2 / 3,
        tolerance=(1e-6, "the meshes are alike, so that their errors cancel to round-off"),
    ),
    HardCase(
        name="contact: incompressible",
        asked="Poisson ratio 0.4999, where fully integrated cells lock",
        right="Hertz's peak pressure, by 40 digits",
        evaluate=lambda: referenced(inner(material=incompressible())).peak_pressure,
        expected=2482423059.3511842575,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: close groove",
        asked="conformity 0.505, an ellipse 21 times as long as wide",
        right="Hertz's major semi-axis, by 40 digits",
        evaluate=lambda: referenced(inner(conformity=0.505)).semi_axis_transverse,
        expected=1.9302041651009105401e-3,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: mesh ten times too small",
        asked="a first mesh of a tenth of the ellipse: every node of it touches",
        right="Hertz's minor semi-axis, by 40 digits: no answer depends on the first mesh",
        evaluate=lambda: meshed(inner(), scale=(0.1, 0.1)).semi_axis_rolling,
        expected=1.2091146725908945613e-4,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: mesh ten times too large",
        asked="a first mesh of ten times the ellipse",
        right="Hertz's approach, by 40 digits: no answer depends on the first mesh",
        evaluate=lambda: meshed(inner(), scale=(10.0, 10.0)).approach,
        expected=8.4430937122525567274e-6,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: a single node",
        asked="a first mesh a hundred times too large, touched by one node, which has no size",
        right="Hertz's peak pressure, by 40 digits: the mesh shrinks until it sees the contact",
        evaluate=lambda: meshed(inner(), scale=(100.0, 100.0)).peak_pressure,
        expected=2182366274.905845588,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: grazing its shoulder",
        asked="a groove that ends 2 % before the ellipse does, so that half of the contact is meshed",
        right="Hertz's approach, by 40 digits: what is cut off carries 3e-4 of the load. Not told of it: wrong",
        evaluate=grazing,
        expected=8.4430937122525567274e-6,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: far over its shoulder",
        asked="an ellipse 3.7 times as long as the room that the groove leaves",
        right="a refusal with what the mesh holds: there is next to no groove left",
        evaluate=lambda: referenced(replace(inner(), shoulder=0.3e-3), recipe="race").approach,
        refusal="its shoulder stands at 0.0003 m: the mesh holds up to 3 times that",
    ),
    HardCase(
        name="contact: past the ball",
        asked="2e5 N on the true ball and groove: the ellipse would reach round the ball",
        right="a refusal with the widest contact that the mesh holds",
        evaluate=lambda: referenced(inner(load=2e5), recipe="race").approach,
        refusal="too wide for a ball of radius",
    ),
)


def _log_elongation(difference: float) -> float:
    """ln(b/a) of curvatures that differ by a small share."""
    found = hertz(curvature_x=LARGE * (1 + difference), curvature_y=LARGE)
    return math.log(float(found.semi_axis_y / found.semi_axis_x))


def _mises_of_cork() -> SubsurfaceMaximum:
    return subsurface_maximum(peak_pressure=2.1e9, semi_axis_x=0.12e-3, semi_axis_y=1.1e-3, poisson_ratio=0.0)
