"""Hard cases of the finite elements: unsuitable meshes, extreme loads, shapes and materials, and singular systems.

Cases on half spaces have Hertz's exact answer. Cases on the true ball and groove compare with what holds there too: a
limit, a symmetry, or another system of units.
"""

from collections.abc import Iterable
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
from validation.hard.case import HardCase, temporary_file
from validation.hard.contacts import AS_REQUIRED, LEVEL, SECOND_LEVEL, meshed, referenced
from validation.hard.specimens import bronze, ceramic, incompressible, inner, peek

LOADS = (170.0, 0.02, 600.0)  # N, out of order: two meshes
STATIC = 4.2e9  # Pa: the static limit of bearing steel
SAME = (1e-12, "round-off times the condition number of the meshes' equations")


def with_ratio(poisson_ratio: float) -> Contact:
    return inner(material=replace(peek(), poisson_ratio=poisson_ratio))


def with_modulus(youngs_modulus: float) -> Contact:
    return inner(material=replace(peek(), youngs_modulus=youngs_modulus))


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


MESH_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("contact: mesh ten times too wide along rolling",
        "a first mesh of ten times the minor semi-axis and the true major one",
        "Hertz's approach, by 40 digits: each semi-axis is corrected by itself",
        lambda: meshed(inner(), scale=(10.0, 1.0)).approach, 8.4430937122525567274e-6, tolerance=SECOND_LEVEL),
    HardCase("contact: mesh ten times too narrow",
        "a first mesh of a tenth of the major semi-axis and the true minor one",
        "Hertz's major semi-axis, by 40 digits", lambda: meshed(inner(), scale=(1.0, 0.1)).semi_axis_transverse,
        1.1218581383711777898e-3, tolerance=SECOND_LEVEL),
    HardCase("contact: active set of one node",
        "the active set started from a single node, on a mesh where a hundred touch",
        "Hertz's approach, by 40 digits: the answer does not depend on the start", started_from_one_node,
        8.4430937122525567274e-6, tolerance=SECOND_LEVEL),
    HardCase("contact: static limit", "the load, 4.4 kN, at which Hertz's peak pressure is 4.2 GPa", "that pressure",
        lambda: referenced(inner(load=static_load())).peak_pressure, 4.2e9, tolerance=AS_REQUIRED),
    HardCase("contact: true groove at 1e-6 N", "the ball on the true groove, on an ellipse of 0.14 by 1.3 um",
        "Hertz's approach, by 40 digits: a vanishing contact deforms two half spaces",
        lambda: referenced(inner(load=1e-6), recipe="race").approach, 1.1612003284194039775e-11, tolerance=AS_REQUIRED),
    HardCase("contact: loads in any order",
        "the approaches of a series from 0.02 to 600 N, out of order, over those in ascending order",
        "1: no load depends on those before it", shuffled, 1.0, tolerance=SAME),
    HardCase("contact: closest groove", "conformity 0.5025, an ellipse 31 times as long as wide",
        "Hertz's approach, by 40 digits", lambda: referenced(inner(conformity=0.5025)).approach,
        5.009098256824933717e-6, tolerance=AS_REQUIRED),
    HardCase("contact: open groove", "conformity 0.6, an ellipse barely longer than wide",
        "Hertz's peak pressure, by 40 digits", lambda: referenced(inner(conformity=0.6)).peak_pressure,
        3022462074.5317120213, tolerance=AS_REQUIRED),
    HardCase("contact: steel on ceramic", "a race of Si3N4, 1.5 times as stiff as the ball",
        "Hertz's approach, by 40 digits", lambda: referenced(replace(inner(), race_material=ceramic())).approach,
        7.5076532342835269638e-6, tolerance=AS_REQUIRED),
    HardCase("contact: steel on bronze", "a race of bronze, half as stiff as the ball",
        "Hertz's minor semi-axis, by 40 digits",
        lambda: referenced(replace(inner(), race_material=bronze())).semi_axis_rolling, 1.3558431522983502455e-4,
        tolerance=AS_REQUIRED),
    HardCase("contact: steel on PEEK", "a race 57 times softer than the ball", "Hertz's approach, by 40 digits",
        lambda: referenced(replace(inner(), race_material=peek())).approach, 7.6737867455896463996e-5,
        tolerance=AS_REQUIRED),
    HardCase("contact: PEEK out of its groove", "620 N on the true groove of PEEK",
        "a refusal: the ellipse reaches past the ball's flank",
        lambda: referenced(replace(inner(), race_material=peek()), recipe="race").approach,
        refusal="too wide for a ball of radius"),
    HardCase("contact: bodies exchanged", "approach of bronze on steel over that of steel on bronze, as half spaces",
        "1: both bodies are half spaces",
        lambda: meshed(replace(inner(), ball_material=bronze()), level=1).approach / meshed(replace(inner(),
            race_material=bronze()), level=1).approach, 1.0, tolerance=SAME),
    HardCase("contact: incompressible race",
        "Poisson ratio 0.4999 of the race only, on the true groove at 1e-3 N, where locking would show",
        "Hertz's peak pressure, by 40 digits",
        lambda: referenced(replace(inner(load=1e-3), race_material=incompressible()), recipe="race").peak_pressure,
        27211668.556835280315, tolerance=AS_REQUIRED),
    HardCase("contact: other units", "approach on the true groove in mm and MPa over that in m and Pa",
        "1000: the solver has no length or force of its own",
        lambda: meshed(in_millimetres(inner()), recipe="race", level=1).approach / meshed(inner(), recipe="race",
            level=1).approach, 1000.0, tolerance=SAME),
    HardCase("contact: Poisson ratio 0.5", "incompressible bodies, whose stiffness matrix is infinite",
        "a refusal that names the limit", lambda: referenced(with_ratio(0.5)).approach,
        refusal="poisson_ratio must lie above -1 and below 0.5, got 0.5"),
    HardCase("contact: no modulus", "bodies of modulus 0", "a refusal that names it",
        lambda: referenced(with_modulus(0.0)).approach, refusal="youngs_modulus must be positive and finite, got 0.0"),
    HardCase("contact: no load", "finite elements on a contact without load",
        "a refusal: the mesh scales with the ellipse, which has no size", lambda: referenced(inner(load=0.0)).approach,
        refusal="load must be positive and finite, got 0.0"),
    HardCase("contact: a cell inside out", "a mesh whose core folds the cells around it",
        "a refusal with cell and place: the equations would still have a solution, which looks like a result", folded,
        refusal="is inside out at"),
    HardCase("equations: an unsupported body", "the compliance of a half space without supports",
        "a refusal that names the body: its equations are singular", unsupported, refusal="have no single answer"),
    HardCase("equations: a node given twice", "two nodes with the same compliance",
        "a refusal: how the two share their force is undetermined",
        lambda: pressed_nodes([[2.0, 2.0, 0.7], [2.0, 2.0, 0.7], [0.7, 0.7, 1.9]]),
        refusal="the compliance is not positive definite"),
    HardCase("equations: an indefinite compliance", "a node that moves against its force",
        "a refusal with the part of the load that is not carried",
        lambda: pressed_nodes([[2.0, 0.3, 0.7], [0.3, -1.1, 0.2], [0.7, 0.2, 1.9]]), refusal="residual 2.3e+00 N"),
    HardCase("mesh file: a node that does not exist",
        "a cell that names node 1e12, seen in damaged files: a table of so many nodes would take all memory",
        "a refusal", lambda: nodes_read(10**12), refusal="a cell names a node that does not exist"),
)  # fmt: skip
