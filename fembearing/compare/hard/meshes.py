"""Hard cases of the finite elements: mismatched meshes, extreme loads, shapes and materials, systems without an answer.

Rows on half spaces have Hertz's exact answer. Rows on the true ball and groove lean on what holds there too: a limit, a
symmetry, or another choice of units.
"""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from analytic.scene import Contact, Material
from fembearing.compare.contact.hertz import hertz_quantities
from fembearing.compare.hard.case import HardCase, passing_file
from fembearing.compare.hard.contacts import (
    AS_ASKED,
    LEVEL,
    SECOND_LEVEL,
    incompressible,
    inner,
    meshed,
    peek,
    referenced,
)
from fembearing.fem.condensation import condense
from fembearing.fem.contact import press
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.series import solve_series
from fembearing.fem.solution import condensed_pair, fitted_solution, pressed, solve_on_mesh
from fembearing.mesh.meshfile import SETS, read_body
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe

LOADS = (170.0, 0.02, 600.0)  # N, in no order: two meshes
STATIC = 4.2e9  # Pa: the static limit of bearing steel
SAME = (1e-12, "round-off times the condition of the meshes' equations")


def ceramic() -> Material:
    return Material(name="Si3N4", youngs_modulus=310e9, poisson_ratio=0.27, density=3200.0, source="the case's")


def bronze() -> Material:
    return Material(name="bronze", youngs_modulus=110e9, poisson_ratio=0.34, density=8800.0, source="the case's")


def with_ratio(poisson_ratio: float) -> Contact:
    return inner(material=replace(peek(), poisson_ratio=poisson_ratio))


def with_modulus(youngs_modulus: float) -> Contact:
    return inner(material=replace(peek(), youngs_modulus=youngs_modulus))


def touched_by_one_node() -> float:
    """Approach, m, from a start where a single node is thought to touch."""
    recipe = load_recipe("hertzian")
    size = fitted_solution(inner(), recipe=recipe).pair.semi_axes
    bodies = condensed_pair(inner(), recipe=recipe, level=LEVEL, semi_axes=size)
    return pressed(bodies, load=inner().load, expected=(1e-12, 1e-12)).quantities.approach


def static_load() -> float:
    """N at which Hertz's peak pressure is the static limit."""
    one = hertz_quantities(inner())
    return inner().load * (STATIC / one.peak_pressure) ** 3


def shuffled() -> float:
    """Largest ratio of an approach in one order of the loads to that in another."""
    recipe = load_recipe("hertzian")
    found, rising = (
        {part.contact.load: part.quantities.approach for part in solve_series(inner(), recipe=recipe, level=1, loads=x)}
        for x in (LOADS, sorted(LOADS))
    )
    return max((found[load] / rising[load] for load in LOADS), key=lambda ratio: abs(ratio - 1))


def in_millimetres(contact: Contact) -> Contact:
    """The same contact in mm and MPa, where a newton stays a newton."""
    lengths = {name: 1e3 * getattr(contact, name) for name in ("ball_radius", "groove_radius", "rolling_radius")}
    materials = {
        name: replace(getattr(contact, name), youngs_modulus=1e-6 * getattr(contact, name).youngs_modulus)
        for name in ("ball_material", "race_material")
    }
    return replace(contact, **lengths, **materials, shoulder=1e3 * contact.shoulder)


def free_to_sink() -> float:
    """Compliance, m/N, of a half space whose far boundary nothing holds."""
    semi_axes = expected_semi_axes(inner())
    pair = pair_mesh(inner(), recipe=load_recipe("hertzian"), level=1, semi_axes=semi_axes)
    loose = replace(pair.lower, far=pair.lower.far[:0])
    found = condense(loose, material=inner().race_material, force=pair.normal, semi_axes=semi_axes)
    return float(found.compliance.max())


def pressed_nodes(compliance: list[list[float]]) -> float:
    """Approach, m, of three nodes that all touch at the start."""
    found = press(
        compliance=np.array(compliance),
        drift=np.zeros(3),
        gap=np.array([0.0, 0.1, 0.3]),
        lever=np.array([0.98, 0.96, 0.95]),
        load=2.3,
        start=np.ones(3, dtype=bool),
    )
    return found[1]


def mesh_file(node: int) -> str:
    """A .vtu of one cell of 27 nodes, the last of which is the one of that number."""

    def array(name: str, kind: str, numbers: Iterable[int], more: str = "") -> str:
        text = " ".join(map(str, numbers))
        return f'<DataArray Name="{name}" type="{kind}" format="ascii" {more}>{text}</DataArray>'

    points = array("points", "Float64", range(3 * 27), 'NumberOfComponents="3"')
    cells = array("connectivity", "Int64", [*range(26), node]) + array("offsets", "Int64", [27])
    cells += array("types", "Int64", [29])  # VTK's number of a hexahedron of 27 nodes
    marks = "".join(array(name, "Int32", [-1] * 27) for name in ("touching", *SETS))
    return (
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian"><UnstructuredGrid>'
        f'<Piece NumberOfPoints="27" NumberOfCells="1"><Points>{points}</Points><Cells>{cells}</Cells>'
        f"<PointData>{marks}</PointData></Piece></UnstructuredGrid></VTKFile>"
    )


def nodes_read(node: int) -> float:
    with passing_file("race.vtu") as path:
        path.write_text(mesh_file(node))
        return float(read_body(path, name="race").mesh.p.shape[1])


def folded() -> float:
    """Approach, m, on a mesh whose core reaches beyond the edge of its own contact."""
    shape = load_recipe("race")
    wide = replace(shape, patch=replace(shape.patch, core_size=1.7))
    return solve_on_mesh(inner(), recipe=wide, level=LEVEL, semi_axes=expected_semi_axes(inner())).quantities.approach


MESH_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="contact: mesh ten times too wide along rolling",
        asked="a first mesh of ten times the minor semi-axis, right across",
        right="Hertz's approach, by 40 digits: each semi-axis mends by itself",
        evaluate=lambda: meshed(inner(), scale=(10.0, 1.0)).approach,
        expected=8.4430937122525567274e-6,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: mesh ten times too short across",
        asked="a first mesh of a tenth of the major semi-axis, right along rolling",
        right="Hertz's major semi-axis, by 40 digits",
        evaluate=lambda: meshed(inner(), scale=(1.0, 0.1)).semi_axis_transverse,
        expected=1.1218581383711777898e-3,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: one node thought to touch",
        asked="the active set from a single node, on a mesh where a hundred touch",
        right="Hertz's approach, by 40 digits: any start ends in the same answer",
        evaluate=touched_by_one_node,
        expected=8.4430937122525567274e-6,
        tolerance=SECOND_LEVEL,
    ),
    HardCase(
        name="contact: static limit",
        asked="the load, 4.4 kN, at which Hertz's peak pressure is 4.2 GPa",
        right="that pressure",
        evaluate=lambda: referenced(inner(load=static_load())).peak_pressure,
        expected=4.2e9,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: true groove at 1e-6 N",
        asked="the ball on the true groove, on an ellipse of 0.14 by 1.3 um",
        right="Hertz's approach, by 40 digits: a vanishing contact sees two half spaces",
        evaluate=lambda: referenced(inner(load=1e-6), recipe="race").approach,
        expected=1.1612003284194039775e-11,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: loads in any order",
        asked="a series from 0.02 to 600 N in no order over the same one rising",
        right="1: no load depends on those before it",
        evaluate=shuffled,
        expected=1.0,
        tolerance=SAME,
    ),
    HardCase(
        name="contact: closest groove",
        asked="conformity 0.5025, an ellipse 31 times as long as wide",
        right="Hertz's approach, by 40 digits",
        evaluate=lambda: referenced(inner(conformity=0.5025)).approach,
        expected=5.009098256824933717e-6,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: open groove",
        asked="conformity 0.6, an ellipse barely longer than wide",
        right="Hertz's peak pressure, by 40 digits",
        evaluate=lambda: referenced(inner(conformity=0.6)).peak_pressure,
        expected=3022462074.5317120213,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: steel on ceramic",
        asked="a race of Si3N4, 1.5 times as stiff as the ball",
        right="Hertz's approach, by 40 digits",
        evaluate=lambda: referenced(replace(inner(), race_material=ceramic())).approach,
        expected=7.5076532342835269638e-6,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: steel on bronze",
        asked="a race of bronze, half as stiff as the ball",
        right="Hertz's minor semi-axis, by 40 digits",
        evaluate=lambda: referenced(replace(inner(), race_material=bronze())).semi_axis_rolling,
        expected=1.3558431522983502455e-4,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: steel on PEEK",
        asked="a race 57 times softer than the ball",
        right="Hertz's approach, by 40 digits",
        evaluate=lambda: referenced(replace(inner(), race_material=peek())).approach,
        expected=7.6737867455896463996e-5,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: PEEK out of its groove",
        asked="620 N on the true groove of PEEK",
        right="a refusal: the ellipse reaches past the ball's flank",
        evaluate=lambda: referenced(replace(inner(), race_material=peek()), recipe="race").approach,
        refusal="too wide for a ball of radius",
    ),
    HardCase(
        name="contact: bodies exchanged",
        asked="bronze on steel over steel on bronze, as half spaces",
        right="1: a half space does not know on which side it lies",
        evaluate=lambda: (
            meshed(replace(inner(), ball_material=bronze()), level=1).approach
            / meshed(replace(inner(), race_material=bronze()), level=1).approach
        ),
        expected=1.0,
        tolerance=SAME,
    ),
    HardCase(
        name="contact: incompressible race",
        asked="Poisson ratio 0.4999 of the race alone, on the true groove at 1e-3 N, where locking would show",
        right="Hertz's peak pressure, by 40 digits",
        evaluate=lambda: (
            referenced(replace(inner(load=1e-3), race_material=incompressible()), recipe="race").peak_pressure
        ),
        expected=27211668.556835280315,
        tolerance=AS_ASKED,
    ),
    HardCase(
        name="contact: other units",
        asked="the true groove in mm and MPa over the same in m and Pa",
        right="1000: no length or force is the solver's own",
        evaluate=lambda: (
            meshed(in_millimetres(inner()), recipe="race", level=1).approach
            / meshed(inner(), recipe="race", level=1).approach
        ),
        expected=1000.0,
        tolerance=SAME,
    ),
    HardCase(
        name="contact: Poisson ratio 0.5",
        asked="bodies that keep their volume, for which the stiffness is infinite",
        right="a refusal that names the limit",
        evaluate=lambda: referenced(with_ratio(0.5)).approach,
        refusal="poisson_ratio must lie above -1 and below 0.5, got 0.5",
    ),
    HardCase(
        name="contact: no modulus",
        asked="bodies of modulus 0",
        right="a refusal that names it",
        evaluate=lambda: referenced(with_modulus(0.0)).approach,
        refusal="youngs_modulus must be positive and finite, got 0.0",
    ),
    HardCase(
        name="contact: no load",
        asked="finite elements on a contact that is none",
        right="a refusal: a mesh scales with its ellipse, which has no size",
        evaluate=lambda: referenced(inner(load=0.0)).approach,
        refusal="load must be positive and finite, got 0.0",
    ),
    HardCase(
        name="contact: a cell inside out",
        asked="a mesh whose core folds the cells around it",
        right="a refusal with cell and place: the equations would be solved all the same, and look like a result",
        evaluate=folded,
        refusal="is inside out at",
    ),
    HardCase(
        name="equations: a body that nothing holds",
        asked="the compliance of a half space free to sink",
        right="a refusal that names the body: its equations are singular",
        evaluate=free_to_sink,
        refusal="have no single answer",
    ),
    HardCase(
        name="equations: a node there twice",
        asked="two nodes with the same compliance",
        right="a refusal: how they share their force is nobody's guess",
        evaluate=lambda: pressed_nodes([[2.0, 2.0, 0.7], [2.0, 2.0, 0.7], [0.7, 0.7, 1.9]]),
        refusal="the compliance is not positive definite",
    ),
    HardCase(
        name="equations: an indefinite compliance",
        asked="a node that comes nearer when it is pushed away",
        right="a refusal that says how much of the load is not carried",
        evaluate=lambda: pressed_nodes([[2.0, 0.3, 0.7], [0.3, -1.1, 0.2], [0.7, 0.2, 1.9]]),
        refusal="residual 2.3e+00 N",
    ),
    HardCase(
        name="mesh file: a node that does not exist",
        asked="a cell that names node 1e12, found by damaged files: a table up to it would take all memory",
        right="a refusal",
        evaluate=lambda: nodes_read(10**12),
        refusal="a cell names a node that does not exist",
    ),
)
