"""Hard cases of the finite elements: unsuitable meshes, extreme loads, shapes and materials, and singular systems.

Cases on half spaces have Hertz's exact answer. Cases on the true ball and groove compare with what holds there too: a
limit, a symmetry, or another system of units.
"""

from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from analytic.scene import Contact
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.fem.condensation import condense
from fembearing.fem.contact import press
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.series import solve_series
from fembearing.fem.solution import condensed_pair, fitted_solution, pressed, solve_on_mesh
from fembearing.mesh.meshfile import SETS, read_body
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from validation.hard.case import temporary_file
from validation.hard.contacts import LEVEL, meshed, referenced
from validation.hard.specimens import BRONZE, CERAMIC, INCOMPRESSIBLE, PEEK, inner

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


MESH_CASES: dict[str, Callable[[], float]] = {
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
