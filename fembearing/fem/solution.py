"""One contact solved on one mesh."""

import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from scipy.sparse import csr_matrix

from analytic.errors import ConvergenceError, InputError
from analytic.scene import Array, Contact, Material
from fembearing.fem.condensation import CondensedBody, condense
from fembearing.fem.contact import press
from fembearing.fem.elasticity import require_elastic, strip_integrals, surface_mass
from fembearing.fem.factor import solver_threads
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
    within_ellipse,
)
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.footprint import Sides, footprint_of, is_symmetric
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import Recipe

# Deviation of the ellipse from that of its mesh, in semi-axes. A mesh that is 1 % too large or too small changes no
# quantity by more than its own discretisation error (validation/benchmarks/calibrations.py); at 3 % the extrapolation
# of a semi-axis is off by three times its uncertainty.
GOOD_GUESS = 0.01
# On a mesh far too large a single node touches and the ellipse has no size. On one far too small all nodes touch and
# the ellipse is 1.6 times that of the mesh. A round corrects a factor of 4 or 1.6: all rounds together correct a guess
# that is 100 times too large or too small.
SMALLEST_CHANGE = 0.25
MOST_GUESSES = 12


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedPair:
    """Two bodies reduced to the nodes that may touch, ready to be pressed by any load that suits their mesh."""

    contact: Contact
    level: int  # number of the mesh of its recipe, coarse to fine
    pair: PairMesh
    upper: CondensedBody
    lower: CondensedBody
    mass: csr_matrix  # (m, m) m^2, of the upper body's surface up to a shoulder, over the nodes that may touch
    has_lands: bool  # False: a land was too steep to be meshed, and both sides are alike


@dataclass(frozen=True, kw_only=True, eq=False)
class MeshSolution:
    """A contact on one mesh. Arrays run over the nodes that may touch, of a quarter or of half the contact."""

    contact: Contact
    level: int  # number of the mesh of its recipe, coarse to fine
    pair: PairMesh
    quantities: Quantities
    semi_axes: tuple[float, float]  # m, of the ellipse that a mesh should follow; from the side that is not cut off
    shoulder: ShoulderLoad | None  # None where the contact ends before its shoulder
    x: Array  # (m,) rolling direction, m
    y: Array  # (m,) transverse direction, m
    force: Array  # (m,) normal force on the meshed part, N
    pressure: Array  # (m,) Pa
    unknowns: int  # number, of both bodies
    rounds: int  # number of rounds of the active set
    seconds: float  # of meshing and solving
    bodies: CondensedPair

    @property
    def upper(self) -> CondensedBody:
        """The condensed ball, for other solutions on this mesh."""
        return self.bodies.upper


def solve_on_mesh(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    sides: Sides = "mean",
    upper: CondensedBody | None = None,
) -> MeshSolution:
    """Solve a contact on one level of a recipe, on a mesh for an ellipse of `semi_axes` (m).

    extended : add cells around a block, to measure the effect of its far boundary
    sides : of y = 0 that are meshed, see `fembearing.mesh.pair.pair_mesh`; "mean": where they differ, compliance and
        gap are the mean of those of a quarter with each true side (validation/correction/sides.py), and the mesh has
        the side y > 0; where cells of either turn inside out under a steep land, both sides are alike
    upper : the condensed ball of this level and ellipse, if it is known; it does not depend on `extended`, nor on the
        side of a quarter
    Raises InputError if the mesh cannot be made, ConvergenceError if the contact does not converge.
    """
    start = time.perf_counter()
    bodies = condensed_pair(
        contact, recipe=recipe, level=level, semi_axes=semi_axes, extended=extended, sides=sides, upper=upper
    )
    solution = pressed(bodies, load=contact.load, expected=semi_axes)
    return replace(solution, seconds=time.perf_counter() - start)


def condensed_pair(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    sides: Sides = "mean",
    upper: CondensedBody | None = None,
) -> CondensedPair:
    """Mesh both bodies of a contact and condense them; arguments as those of `solve_on_mesh`.

    Only `semi_axes` depend on the load. Raises InputError if the mesh cannot be made, SingularError if the equations of
    a body have no unique solution.
    """
    require_elastic(contact)
    alike = recipe.geometry != "real" or is_symmetric(contact) or footprint_of(contact, semi_axes).cut
    quarters: tuple[Sides, ...] = ("above", "below") if sides == "mean" and not alike else (sides,)
    meshed = partial(pair_mesh, contact, recipe=recipe, level=level, semi_axes=semi_axes, extended=extended)
    has_lands = True
    try:
        pairs = [meshed(sides=side) for side in quarters]
    except InputError:
        if len(quarters) == 1:
            raise
        pairs, has_lands = [meshed(sides="even")], False
    upper, lower = _condensed(contact, pairs, upper)
    pair = replace(pairs[0], gap=np.mean([each.gap for each in pairs], axis=0))
    mass = _mass_within(pair)
    return CondensedPair(
        contact=contact, level=level, pair=pair, upper=upper, lower=lower, mass=mass, has_lands=has_lands
    )


def pressed(bodies: CondensedPair, *, load: float, expected: tuple[float, float]) -> MeshSolution:
    """Press two condensed bodies together; `seconds` counts the pressing alone.

    load : of the whole contact, N
    expected : first guess of the semi-axes, m; every guess ends in the same answer
    Raises ConvergenceError if the contact does not converge.
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
        start=within_ellipse(x, y, expected),
    )
    carried = force * lever  # part of the load that each node carries, N
    pressure = nodal_pressure(force, bodies.mass)
    below, above = pair.footprint.shoulders
    side, distance = (1, above) if above <= below else (-1, below)  # of the nearer shoulder that cuts
    centroid = float(carried @ y / carried.sum()) if half else 0.0
    shoulder = None
    if np.isfinite(distance):
        low, high = sorted((side * (1 - STRIP) * distance, side * distance))
        strip = strip_integrals(pair.upper.mesh, pair.upper.touching, low=low, high=high)
        strip_force = float(strip @ (pressure * lever))
        shoulder = shoulder_load(centroid=centroid, strip_force=strip_force, shoulder=distance, load=load)
    measured = semi_axis(x, carried), semi_axis(y, carried, centre=centroid)
    ellipse = uncut_semi_axes(x, side * y, carried) if half and shoulder is not None else measured
    area = np.asarray(bodies.mass.sum(axis=1)).ravel()
    inside = (ellipse[0], min(ellipse[1], distance))
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
    """A contact on the second level, on a mesh for its own ellipse there: `pair.semi_axes`.

    guess : semi-axes to start from, m; `expected_semi_axes` unless given
    Raises ConvergenceError if the ellipse and its mesh do not converge.
    """
    start = expected_semi_axes(contact, geometry=recipe.geometry) if guess is None else guess
    return fitted_on_level(contact, recipe=recipe, level=recipe.levels[1], start=start, good=GOOD_GUESS)


def fitted_on_level(
    contact: Contact, *, recipe: Recipe, level: int, start: tuple[float, float], good: float
) -> MeshSolution:
    """A contact on one level, on a mesh for its own ellipse there.

    start : semi-axes of the first mesh, m
    good : largest deviation of the ellipse from that of the mesh, in semi-axes
    Raises ConvergenceError if the ellipse and its mesh do not converge.
    """
    semi_axes, misfit = start, np.inf
    for _ in range(MOST_GUESSES):
        solution = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes)
        changes = [max(new / old, SMALLEST_CHANGE) for new, old in zip(solution.semi_axes, semi_axes, strict=True)]
        misfit = max(abs(change - 1) for change in changes)
        if misfit < good:
            return solution
        semi_axes = (semi_axes[0] * changes[0], semi_axes[1] * changes[1])
    raise ConvergenceError(
        iterations=MOST_GUESSES,
        residual=misfit,
        tolerance=good,
        unit="of a semi-axis",
        problem="the size of the contact",
        remedy="Lower the load, or check the groove radius and the materials.",
    )


def _condensed(
    contact: Contact, pairs: Sequence[PairMesh], upper: CondensedBody | None
) -> tuple[CondensedBody, CondensedBody]:
    """Both bodies; the lower one is the mean of those of all `pairs`.

    upper : the ball, if it is known
    """
    first = pairs[0]

    def reduced(body: BodyMesh, material: Material, force: Array) -> CondensedBody:
        size = {"semi_axes": first.semi_axes, "shoulders": first.footprint.shoulders}
        return condense(body, material=material, force=force, **size)

    jobs = [(pair.lower, contact.race_material, pair.normal) for pair in pairs]
    if first.upper.name == first.lower.name and contact.ball_material == contact.race_material:
        both = reduced(*jobs[0])
        return both, both  # two half spaces of one material are mirror images
    if upper is None or first.upper.name != "ball":
        jobs.insert(0, (first.upper, contact.ball_material, -first.normal))
    with ThreadPoolExecutor(solver_threads()) as pool:
        found = list(pool.map(reduced, *zip(*jobs, strict=True)))
    if len(found) > len(pairs):
        upper = found.pop(0)
    assert upper is not None
    mean = {name: np.mean([getattr(each, name) for each in found], axis=0) for name in ("compliance", "drift")}
    return upper, replace(found[0], **mean)


def _mass_within(pair: PairMesh) -> csr_matrix:
    """Mass matrix of the upper surface; rows beyond a shoulder, where there is no pressure, are empty."""
    nodes = pair.upper.touching
    within = np.flatnonzero(pair.footprint.holds(pair.upper.mesh.doflocs[1, nodes]))
    inside = surface_mass(pair.upper.mesh, nodes[within]).tocoo()
    return csr_matrix((inside.data, (within[inside.row], within[inside.col])), shape=(nodes.size, nodes.size))
