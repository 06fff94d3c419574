"""One contact under many loads, on as few meshes as their spread needs.

Condensing two bodies takes nearly all the time of a solution and does not know the load, so loads whose ellipses fit
one mesh share it: a band. Semi-axes grow about as load^(1/3), which sizes the next band's mesh from the last one's
ellipse; what was found there is checked, and a band that does not fit its mesh is split. So is one that a shoulder
divides: a mesh is cut off there or it is not, and each load has the one that its own ellipse asks for.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.errors import InputError, require_positive
from analytic.scene import Contact
from fembearing.fem.solution import (
    CondensedPair,
    MeshSolution,
    condensed_pair,
    fitted_on_level,
    fitted_solution,
    pressed,
)
from fembearing.mesh.footprint import farther_shoulder
from fembearing.mesh.recipe import Recipe

Array = NDArray[np.float64]
# Ellipse over that of its mesh. Between these the approach is off by no more than 0.41 % on a third level (worst seen
# on idealised contacts, validation/benchmarks/calibrations.py); below, too few cells carry it, and from 1.4 on it runs
# over the nodes that may touch.
NARROWEST, WIDEST = 0.7, 1.3
# A second level measures an ellipse to 3 %, and the groove's is not quite self-similar: before a band is split, more.
SLACK = 0.05
SMALLER = 0.85  # a mesh for so much of an ellipse that is itself too wide to be meshed
GOOD_GUESS = 0.03  # how far the ellipse of a band's own load may miss its mesh, in semi-axes
AT_SHOULDER = 0.01  # and where a shoulder stands that near: as of a single solution, whose mesh is cut off or is not


def solve_series(contact: Contact, *, recipe: Recipe, level: int, loads: ArrayLike) -> tuple[MeshSolution, ...]:
    """Solve a contact under each of `loads` on one level of a recipe; in the order given, repeated loads too.

    loads : (n,) N, in any order; the contact's own load does not matter
    Loads within a factor of 6 share one mesh, whatever their number: `solution.bodies` is then the same object.
    Raises InputError for loads that are not positive and finite, or a contact that cannot be meshed;
    ConvergenceError for one that does not settle.
    """
    given = checked_loads(loads)
    solved: dict[float, MeshSolution] = {}
    latest = None
    for band in _bands(sorted(set(given.tolist()))):
        found = _solve_band(contact, recipe=recipe, loads=band, latest=latest)
        solved |= {part.contact.load: part for part in found}
        latest = found[-1]
    series = tuple(solved[load] for load in given.tolist())
    return series if level == recipe.levels[1] else on_level(series, recipe=recipe, level=level)


def checked_loads(loads: ArrayLike) -> Array:
    """(n,) N. Raises InputError unless there is one load or more, all positive and finite."""
    require_positive(loads=loads)
    given = np.atleast_1d(np.asarray(loads, dtype=np.float64))
    if given.ndim > 1 or not given.size:
        raise InputError(f"loads must be one or more numbers in a row, N, got an array of shape {given.shape}")
    return given


def on_level(
    series: Sequence[MeshSolution], *, recipe: Recipe, level: int, extended: bool = False
) -> tuple[MeshSolution, ...]:
    """The loads of a solved series on another level, each on a mesh for the same ellipse as in `series`.

    extended : add cells all round a block, to see what its far boundary does
    Raises InputError and ConvergenceError as `solve_series`.
    """
    meshes: dict[CondensedPair, CondensedPair] = {}
    for part in series:
        if part.bodies not in meshes:
            meshes[part.bodies] = condensed_pair(
                part.contact,
                recipe=recipe,
                level=level,
                semi_axes=part.pair.semi_axes,
                extended=extended,
                upper=part.upper if level == part.level else None,
            )
    return tuple(pressed(meshes[part.bodies], load=part.contact.load, expected=part.semi_axes) for part in series)


def off_mesh(solution: MeshSolution) -> float:
    """How far an ellipse is from the one that its mesh is made for: the larger of two ratios, less one."""
    ratios = np.divide(solution.semi_axes, solution.pair.semi_axes)
    return float(np.abs(ratios - 1).max())


def _bands(loads: Sequence[float]) -> Iterable[tuple[float, ...]]:
    """Neighbours that one mesh holds; `loads` rising."""
    band: list[float] = []
    for load in loads:
        if band and load > band[0] * (WIDEST / NARROWEST) ** 3:
            yield tuple(band)
            band = []
        band.append(load)
    yield tuple(band)


def _solve_band(
    contact: Contact, *, recipe: Recipe, loads: tuple[float, ...], latest: MeshSolution | None
) -> tuple[MeshSolution, ...]:
    """On the second level; `latest` is a solution nearby to size the mesh from."""
    found = _mesh_of_band(replace(contact, load=_load_of_mesh(loads)), recipe=recipe, latest=latest)
    series = tuple(_under(found, load) for load in loads)
    if len(loads) == 1 or all(_fits(part) and _ends_rightly(part) for part in series):
        return series
    reached = [sum(part.semi_axes[1] > shoulder for shoulder in _shoulders(contact)) for part in series]
    before = sum(count == reached[0] for count in reached)
    split = before if before < len(loads) else len(loads) // 2
    below = _solve_band(contact, recipe=recipe, loads=loads[:split], latest=found)
    return below + _solve_band(contact, recipe=recipe, loads=loads[split:], latest=below[-1])


def _mesh_of_band(own: Contact, *, recipe: Recipe, latest: MeshSolution | None) -> MeshSolution:
    """A solution on a mesh for the ellipse of `own`, or for a smaller one where that is too wide to be meshed: what
    lies a little above the largest mesh still fits it, unless it reaches over a shoulder that this mesh does not know.
    """
    try:
        return _fitted(own, recipe=recipe, latest=latest)
    except InputError as problem:
        try:
            smaller = _fitted(replace(own, load=own.load * SMALLER**3), recipe=recipe, latest=latest)
        except InputError:
            raise problem from None
        if not _ends_rightly(_under(smaller, own.load)):
            raise
        return smaller


def _fitted(contact: Contact, *, recipe: Recipe, latest: MeshSolution | None) -> MeshSolution:
    if latest is None:
        return fitted_solution(contact, recipe=recipe)
    level, start = recipe.levels[1], _scaled(latest, contact.load)
    found = fitted_on_level(contact, recipe=recipe, level=level, start=start, good=GOOD_GUESS)
    if _ends_rightly(found):
        return found
    return fitted_on_level(contact, recipe=recipe, level=level, start=found.semi_axes, good=AT_SHOULDER)


def _under(solution: MeshSolution, load: float) -> MeshSolution:
    """The same bodies under another load, N."""
    if load == solution.contact.load:
        return solution
    return pressed(solution.bodies, load=load, expected=_scaled(solution, load))


def _load_of_mesh(loads: tuple[float, ...]) -> float:
    """The load whose ellipse sizes a band's mesh, N: one of `loads` if the mesh then holds all, else between two."""
    low, high = loads[0], loads[-1]
    least, most = high / WIDEST**3, low / NARROWEST**3
    share = np.log(1 / NARROWEST) / np.log(WIDEST / NARROWEST)
    middle = low ** (1 - share) * high**share  # both ends equally near to what the mesh holds
    inside = [load for load in loads if least <= load <= most]
    return float(min(inside, key=lambda load: abs(np.log(load / middle)), default=middle))


def _scaled(solution: MeshSolution, load: float) -> tuple[float, float]:
    factor = (load / solution.contact.load) ** (1 / 3)
    return solution.semi_axes[0] * factor, solution.semi_axes[1] * factor


def _fits(solution: MeshSolution) -> bool:
    ratios = np.divide(solution.semi_axes, solution.pair.semi_axes)
    return bool(ratios.min() > NARROWEST - SLACK and ratios.max() < WIDEST + SLACK)


def _shoulders(contact: Contact) -> tuple[float, float]:
    """How far away they stand at y < 0 and at y > 0, m."""
    return farther_shoulder(contact), contact.shoulder


def _ends_rightly(solution: MeshSolution) -> bool:
    """Whether the mesh is cut off just at those shoulders that the load's own ellipse reaches."""
    for room, shoulder in zip(solution.pair.footprint.room, _shoulders(solution.contact), strict=True):
        beyond = solution.semi_axes[1] / shoulder - 1
        if beyond <= -AT_SHOULDER if np.isfinite(room) else beyond >= AT_SHOULDER:
            return False
    return True
