"""One contact solved on one mesh."""

import time
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from analytic.errors import ConvergenceError
from analytic.scene import Contact
from fembearing.fem.condensation import CondensedBody, condense
from fembearing.fem.contact import press
from fembearing.fem.elasticity import require_elastic, strip_integrals, surface_mass
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import (
    STRIP,
    Quantities,
    ShoulderLoad,
    nodal_pressure,
    peak_pressure,
    semi_axis,
    shoulder_load,
    uncut_semi_axes,
)
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import Recipe

Array = NDArray[np.float64]
# How far off, in semi-axes, the mesh may be made on the first and the second level. The first shows a slender ellipse
# up to a tenth too short; a mesh that is 1 % off changes no quantity by more than its own discretisation error
# (validation/benchmarks/calibrations.py).
GOOD_GUESSES = (0.1, 0.01)
# A mesh far too large is touched by one node and shows no size, one far too small is touched all over and shows 1.6
# times its own. Each try mends a factor of 4 or 1.6: these many, a guess 100 times too large or too small.
SMALLEST_CHANGE = 0.25
MOST_GUESSES = 12


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedPair:
    """Two bodies on one mesh, reduced to the nodes that may touch: to be pressed under any load that suits the mesh."""

    contact: Contact
    level: int
    pair: PairMesh
    upper: CondensedBody
    lower: CondensedBody
    mass: csr_matrix  # (m, m) m^2, of the upper body's surface over the nodes that may touch, as far as a shoulder


@dataclass(frozen=True, kw_only=True, eq=False)
class MeshSolution:
    """A contact on one mesh. Node arrays run over the nodes that may touch, of a quarter or of a half."""

    contact: Contact
    level: int
    pair: PairMesh
    quantities: Quantities
    semi_axes: tuple[float, float]  # m, of the ellipse that a mesh should follow: from y <= 0 where y > 0 is cut off
    shoulder: ShoulderLoad | None  # None where the contact ends before it
    x: Array  # (m,) along rolling, m
    y: Array  # (m,) transverse, m
    force: Array  # (m,) normal force on the meshed part, N
    pressure: Array  # (m,) Pa
    unknowns: int
    rounds: int  # of the active set
    seconds: float  # that meshing and solving took
    bodies: CondensedPair

    @property
    def upper(self) -> CondensedBody:
        return self.bodies.upper


def solve_on_mesh(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    upper: CondensedBody | None = None,
) -> MeshSolution:
    """Solve a contact on one level of a recipe, the mesh made for an ellipse of `semi_axes` (m).

    extended : add cells all round a block, to see what its far boundary does
    upper : the ball's condensation where it is known for this level and ellipse: no block changes it
    Raises InputError if the mesh cannot be made, ConvergenceError if the contact does not settle.
    """
    start = time.perf_counter()
    bodies = condensed_pair(contact, recipe=recipe, level=level, semi_axes=semi_axes, extended=extended, upper=upper)
    found = pressed(bodies, load=contact.load, expected=semi_axes)
    return replace(found, seconds=time.perf_counter() - start)


def condensed_pair(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    upper: CondensedBody | None = None,
) -> CondensedPair:
    """Mesh both bodies of a contact and condense them; arguments as those of `solve_on_mesh`.

    Nothing in it depends on the load but `semi_axes`. Raises InputError if the mesh cannot be made, SingularError if
    the equations of a body have no single answer.
    """
    require_elastic(contact)
    pair = pair_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes, extended=extended)
    upper, lower = _condensed(contact, pair, upper)
    mass = _mass_within(pair)
    return CondensedPair(contact=contact, level=level, pair=pair, upper=upper, lower=lower, mass=mass)


def pressed(bodies: CondensedPair, *, load: float, expected: tuple[float, float]) -> MeshSolution:
    """Press two condensed bodies together; its `seconds` are those of pressing alone.

    load : of the whole contact, N
    expected : semi-axes, m, to start from; any end in the same answer
    Raises ConvergenceError if the contact does not settle.
    """
    start = time.perf_counter()
    pair, upper, lower = bodies.pair, bodies.upper, bodies.lower
    half, parts = pair.footprint.half, pair.footprint.parts
    x, y, _ = pair.upper.mesh.doflocs[:, pair.upper.touching]
    lever = -pair.normal[2]
    force, approach, rounds = press(
        compliance=upper.compliance + lower.compliance,
        drift=parts * (upper.drift + lower.drift),
        gap=pair.gap,
        lever=lever,
        load=load / parts,
        start=(x / expected[0]) ** 2 + (y / expected[1]) ** 2 < 1,
    )
    along_load = force * lever
    pressure = nodal_pressure(force, bodies.mass)
    room = pair.footprint.room[1]
    centroid = float(along_load @ y / along_load.sum()) if half else 0.0
    shoulder = None
    if np.isfinite(room):
        strip = strip_integrals(pair.upper.mesh, pair.upper.touching, low=(1 - STRIP) * room, high=room)
        strip_force = float(strip @ (pressure * lever))
        shoulder = shoulder_load(centroid=centroid, strip_force=strip_force, shoulder=room, load=load)
    measured = semi_axis(x, along_load), semi_axis(y, along_load, centre=centroid)
    ellipse = uncut_semi_axes(x, y, along_load) if half else measured
    area = np.asarray(bodies.mass.sum(axis=1)).ravel()
    inside = (ellipse[0], min(ellipse[1], room))
    quantities = Quantities(
        semi_axis_rolling=measured[0],
        semi_axis_transverse=measured[1],
        peak_pressure=peak_pressure(x, y, pressure, area, semi_axes=inside, half=half),
        approach=approach,
        stiffness=load / approach**1.5,
    )
    return MeshSolution(
        contact=replace(bodies.contact, load=load),
        level=bodies.level,
        pair=pair,
        quantities=quantities,
        semi_axes=ellipse,
        shoulder=shoulder,
        x=x,
        y=y,
        force=force,
        pressure=pressure,
        unknowns=upper.unknowns + lower.unknowns,
        rounds=rounds,
        seconds=time.perf_counter() - start,
        bodies=bodies,
    )


def fitted_solution(contact: Contact, *, recipe: Recipe, guess: tuple[float, float] | None = None) -> MeshSolution:
    """A contact on the second level, whose mesh is made for the ellipse that it finds there: its `pair.semi_axes`.

    guess : to start from, m; its own unless given
    Raises ConvergenceError if the ellipse keeps running away from its mesh.
    """
    coarse, fine = recipe.levels[:2]
    start = expected_semi_axes(contact) if guess is None else guess
    rough = fitted_on_level(contact, recipe=recipe, level=coarse, start=start, good=GOOD_GUESSES[0])
    return fitted_on_level(contact, recipe=recipe, level=fine, start=rough.pair.semi_axes, good=GOOD_GUESSES[1])


def fitted_on_level(
    contact: Contact, *, recipe: Recipe, level: int, start: tuple[float, float], good: float
) -> MeshSolution:
    """A contact on one level, whose mesh is made for the ellipse that it finds there.

    start : semi-axes of the first mesh, m
    good : by how much of a semi-axis the ellipse may miss its mesh
    Raises ConvergenceError if the ellipse keeps running away from its mesh.
    """
    semi_axes, misfit = start, np.inf
    for _ in range(MOST_GUESSES):
        found = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes)
        changes = [max(new / old, SMALLEST_CHANGE) for new, old in zip(found.semi_axes, semi_axes, strict=True)]
        misfit = max(abs(change - 1) for change in changes)
        if misfit < good:
            return found
        semi_axes = (semi_axes[0] * changes[0], semi_axes[1] * changes[1])
    raise ConvergenceError(
        iterations=MOST_GUESSES,
        residual=misfit,
        tolerance=good,
        unit="of a semi-axis",
        problem="the size of the contact",
        remedy="Lower the load, or check the groove radius and the materials.",
    )


def _condensed(contact: Contact, pair: PairMesh, upper: CondensedBody | None) -> tuple[CondensedBody, CondensedBody]:
    pressed_on = {"semi_axes": pair.semi_axes, "room": pair.footprint.room}
    if upper is None or pair.upper.name != "ball":
        upper = condense(pair.upper, material=contact.ball_material, force=-pair.normal, **pressed_on)
    if pair.upper.name == pair.lower.name and contact.ball_material == contact.race_material:
        return upper, upper  # two half spaces of one material are mirror images
    return upper, condense(pair.lower, material=contact.race_material, force=pair.normal, **pressed_on)


def _mass_within(pair: PairMesh) -> csr_matrix:
    """Of the ball's surface; beyond a shoulder that cuts the contact off there is no pressure, and rows are empty."""
    nodes = pair.upper.touching
    within = np.flatnonzero(pair.footprint.holds(pair.upper.mesh.doflocs[1, nodes]))
    some = surface_mass(pair.upper.mesh, nodes[within]).tocoo()
    return csr_matrix((some.data, (within[some.row], within[some.col])), shape=(nodes.size, nodes.size))
