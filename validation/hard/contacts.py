"""Hard cases of the contact: Hertz's formulas, the contact angle, finite elements, their meshes and equations.

Cases on half spaces have Hertz's exact answer, most as users get them; those about the first mesh take one mesh, fitted
to its ellipse. Cases on the true ball and groove compare with what holds there too: a limit, a symmetry, or another
system of units.
"""

import math
from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.subsurface import SubsurfaceMaximum, subsurface_maximum
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.scene import Bearing, Contact, ContactAngle
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.reference import solve_reference
from fembearing.check.contact.refinement import Wanted
from fembearing.check.contact.scene_contact import as_meshed
from fembearing.fem.condensation import condense
from fembearing.fem.contact import press
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.series import solve_series
from fembearing.fem.solution import condensed_pair, fitted_on_level, fitted_solution, pressed, solve_on_mesh
from fembearing.mesh.meshfile import SETS, read_body
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from validation.hard.specimens import (
    BEARING,
    BRONZE,
    CERAMIC,
    INCOMPRESSIBLE,
    LARGE,
    LOAD,
    MODULUS,
    PEEK,
    SMALL,
    exponent,
    inner,
    temporary_file,
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


LOADS = (170.0, 0.02, 600.0)  # N, out of order: two meshes
STATIC = 4.2e9  # Pa: the static limit of bearing steel


def started_from_one_node() -> float:
    """Approach, m, with an active set that starts from a single node."""
    recipe = load_recipe("hertzian")
    size = fitted_solution(inner(), recipe=recipe).pair.semi_axes
    bodies = condensed_pair(inner(), recipe=recipe, level=LEVEL, semi_axes=size)
    return pressed(bodies, load=inner().load, expected=(1e-12, 1e-12)).quantities.approach


def static_load() -> float:
    """Load, N, at which Hertz's peak pressure is the static limit."""
    one = hertz_quantities(inner())
    return inner().load * (STATIC / one.peak_pressure) ** 3


def shuffled() -> float:
    """The ratio farthest from 1 of an approach in one order of the loads to that in another."""
    recipe = load_recipe("hertzian")
    given, ascending = (
        {part.contact.load: part.quantities.approach for part in solve_series(inner(), recipe=recipe, level=1, loads=x)}
        for x in (LOADS, sorted(LOADS))
    )
    return max((given[load] / ascending[load] for load in LOADS), key=lambda ratio: abs(ratio - 1))


def in_millimetres(contact: Contact) -> Contact:
    """The same contact in mm and MPa, where a newton stays a newton."""
    names = ("ball_radius", "groove_radius", "rolling_radius", "shoulder", "far_shoulder")
    lengths = {name: 1e3 * getattr(contact, name) for name in names}
    materials = {
        name: replace(getattr(contact, name), youngs_modulus=1e-6 * getattr(contact, name).youngs_modulus)
        for name in ("ball_material", "race_material")
    }
    return replace(contact, **lengths, **materials)


def unsupported() -> float:
    """Compliance, m/N, of a half space whose far boundary is free."""
    semi_axes = expected_semi_axes(inner())
    pair = pair_mesh(inner(), recipe=load_recipe("hertzian"), level=1, semi_axes=semi_axes)
    loose = replace(pair.lower, far=pair.lower.far[:0])
    body = condense(loose, material=inner().race_material, force=pair.normal, semi_axes=semi_axes)
    return float(body.compliance.max())


def pressed_nodes(compliance: list[list[float]]) -> float:
    """Approach, m, of three nodes that all touch at the start."""
    solution = press(
        compliance=np.array(compliance),
        drift=np.zeros(3),
        gap=np.array([0.0, 0.1, 0.3]),
        lever=np.array([0.98, 0.96, 0.95]),
        load=2.3,
        start=np.ones(3, dtype=bool),
    )
    return solution[1]


def mesh_file(node: int) -> str:
    """A .vtu of one cell of 27 nodes, the last of which has that number."""

    def array(name: str, kind: str, numbers: Iterable[int], more: str = "") -> str:
        text = " ".join(map(str, numbers))
        return f'<DataArray Name="{name}" type="{kind}" format="ascii" {more}>{text}</DataArray>'

    points = array("points", "Float64", range(3 * 27), 'NumberOfComponents="3"')
    cells = array("connectivity", "Int64", [*range(26), node]) + array("offsets", "Int64", [27])
    cells += array("types", "Int64", [29])  # VTK's type of a hexahedron of 27 nodes
    marks = "".join(array(name, "Int32", [-1] * 27) for name in ("touching", *SETS))
    return (
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="27" NumberOfCells="1"><Points>{points}</Points><Cells>{cells}</Cells>'
        f"<PointData>{marks}</PointData></Piece></UnstructuredGrid></VTKFile>"
    )


def nodes_read(node: int) -> float:
    with temporary_file("race.vtu") as path:
        path.write_text(mesh_file(node))
        return float(read_body(path, name="race").mesh.p.shape[1])


def folded() -> float:
    """Approach, m, on a mesh whose core reaches beyond the edge of its contact."""
    shape = load_recipe("race")
    wide = replace(shape, patch=replace(shape.patch, core_size=1.7))
    return solve_on_mesh(inner(), recipe=wide, level=LEVEL, semi_axes=expected_semi_axes(inner())).quantities.approach


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
    "contact: mesh ten times too wide along rolling": lambda: meshed(inner(), scale=(10.0, 1.0)).approach,
    "contact: mesh ten times too narrow": lambda: meshed(inner(), scale=(1.0, 0.1)).semi_axis_transverse,
    "contact: active set of one node": started_from_one_node,
    "contact: static limit": lambda: referenced(inner(load=static_load())).peak_pressure,
    "contact: true groove at 1e-6 N": lambda: referenced(inner(load=1e-6), recipe="race").approach,
    "contact: loads in any order": shuffled,
    "contact: closest groove": lambda: referenced(inner(conformity=0.5025)).approach,
    "contact: open groove": lambda: referenced(inner(conformity=0.6)).peak_pressure,
    "contact: steel on ceramic": lambda: referenced(replace(inner(), race_material=CERAMIC)).approach,
    "contact: steel on bronze": lambda: referenced(replace(inner(), race_material=BRONZE)).semi_axis_rolling,
    "contact: steel on PEEK": lambda: referenced(replace(inner(), race_material=PEEK)).approach,
    "contact: PEEK out of its groove": lambda: referenced(replace(inner(), race_material=PEEK), recipe="race").approach,
    "contact: bodies exchanged": lambda: (
        meshed(replace(inner(), ball_material=BRONZE), level=1).approach
        / meshed(replace(inner(), race_material=BRONZE), level=1).approach
    ),
    "contact: incompressible race": lambda: (
        referenced(replace(inner(load=1e-3), race_material=INCOMPRESSIBLE), recipe="race").peak_pressure
    ),
    "contact: other units": lambda: (
        meshed(in_millimetres(inner()), recipe="race", level=1).approach
        / meshed(inner(), recipe="race", level=1).approach
    ),
    "contact: Poisson ratio 0.5": lambda: referenced(inner(material=replace(PEEK, poisson_ratio=0.5))).approach,
    "contact: no modulus": lambda: referenced(inner(material=replace(PEEK, youngs_modulus=0.0))).approach,
    "contact: no load": lambda: referenced(inner(load=0.0)).approach,
    "contact: a cell inside out": folded,
    "equations: an unsupported body": unsupported,
    "equations: a node given twice": lambda: pressed_nodes([[2.0, 2.0, 0.7], [2.0, 2.0, 0.7], [0.7, 0.7, 1.9]]),
    "equations: an indefinite compliance": lambda: pressed_nodes([[2.0, 0.3, 0.7], [0.3, -1.1, 0.2], [0.7, 0.2, 1.9]]),
    "mesh file: a node that does not exist": lambda: nodes_read(10**12),
}
