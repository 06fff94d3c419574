"""One contact under many loads, on as few meshes as their range needs.

The condensation of two bodies takes nearly all the time of a solution and does not depend on the load. Loads whose
ellipses fit one mesh therefore share it: a band. Semi-axes grow about as load^(1/3), which sizes the mesh of the next
band from the ellipse of the last one. The computed ellipses are checked, and a band that does not fit its mesh is
split. A band is also split where only some of its ellipses reach a shoulder: a mesh is either cut off there or not.
"""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_positive
from analytic.scene import Array, Contact
from fembearing.fem.solution import (
    CondensedPair,
    MeshSolution,
    condensed_pair,
    fitted_on_level,
    fitted_solution,
    pressed,
)
from fembearing.mesh.footprint import shoulders_of
from fembearing.mesh.recipe import Recipe

# Ellipse of the contact over the ellipse of its mesh. Within these bounds the error of the approach on a third level is
# at most 0.41 % (worst case on idealised contacts, validation/benchmarks/calibrations.py). Below, too few cells carry
# the contact; from 1.4 on it reaches beyond the nodes that may touch.
NARROWEST, WIDEST = 0.7, 1.3
# Excess over these bounds before a band is split: a second level measures an ellipse to 3 %, and the ellipses of a
# groove are not quite self-similar.
SLACK = 0.05
SMALLER = 0.85  # size of the mesh over an ellipse that is too wide to be meshed
GOOD_GUESS = 0.03  # deviation of the ellipse of a band's own load from its mesh, in semi-axes
AT_SHOULDER = 0.01  # the same where a shoulder is that near, as for a single solution: its mesh is cut off or it is not


def solve_series(contact: Contact, *, recipe: Recipe, level: int, loads: ArrayLike) -> tuple[MeshSolution, ...]:
    """Solve a contact under each of `loads` on one level of a recipe; the order and repeated loads are kept.

    loads : (n,) N, in any order; the contact's own load does not matter
    Loads within a factor of 6 share one mesh, however many they are: their `bodies` are then the same object.
    Raises InputError for loads that are not positive and finite, or a contact that cannot be meshed;
    ConvergenceError for one that does not converge.
    """
    given = checked_loads(loads)
    solved: dict[float, MeshSolution] = {}
    latest = None
    for band in _bands(sorted(set(given.tolist()))):
        solutions = _solve_band(contact, recipe=recipe, loads=band, latest=latest)
        solved |= {part.contact.load: part for part in solutions}
        latest = solutions[-1]
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

    extended : add cells around a block, to measure the effect of its far boundary
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
    """Deviation of an ellipse from that of its mesh: the larger of |ratio of semi-axes - 1|."""
    ratios = np.divide(solution.semi_axes, solution.pair.semi_axes)
    return float(np.abs(ratios - 1).max())


def _bands(loads: Sequence[float]) -> Iterable[tuple[float, ...]]:
    """Groups of loads that one mesh can hold; `loads` increase."""
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
    """A band on the second level; `latest`, the solution of a similar load, sizes the mesh."""
    meshed = _mesh_of_band(replace(contact, load=_load_of_mesh(loads)), recipe=recipe, latest=latest)
    series = tuple(_under(meshed, load) for load in loads)
    if len(loads) == 1 or all(_fits(part) and _is_cut_correctly(part) for part in series):
        return series
    reached = [sum(part.semi_axes[1] > shoulder for shoulder in shoulders_of(contact)) for part in series]
    alike = sum(count == reached[0] for count in reached)
    split = alike if alike < len(loads) else len(loads) // 2
    below = _solve_band(contact, recipe=recipe, loads=loads[:split], latest=meshed)
    return below + _solve_band(contact, recipe=recipe, loads=loads[split:], latest=below[-1])


def _mesh_of_band(own: Contact, *, recipe: Recipe, latest: MeshSolution | None) -> MeshSolution:
    """A solution on a mesh for the ellipse of `own`, or for a smaller ellipse where that is too wide to be meshed.

    An ellipse a little wider than the largest mesh still fits it, unless it reaches a shoulder at which this mesh is
    not cut off.
    """
    try:
        return _fitted(own, recipe=recipe, latest=latest)
    except InputError as problem:
        try:
            smaller = _fitted(replace(own, load=own.load * SMALLER**3), recipe=recipe, latest=latest)
        except InputError:
            raise problem from None
        if not _is_cut_correctly(_under(smaller, own.load)):
            raise
        return smaller


def _fitted(contact: Contact, *, recipe: Recipe, latest: MeshSolution | None) -> MeshSolution:
    if latest is None:
        return fitted_solution(contact, recipe=recipe)
    level, start = recipe.levels[1], _scaled(latest, contact.load)
    solution = fitted_on_level(contact, recipe=recipe, level=level, start=start, good=GOOD_GUESS)
    if _is_cut_correctly(solution):
        return solution
    return fitted_on_level(contact, recipe=recipe, level=level, start=solution.semi_axes, good=AT_SHOULDER)


def _under(solution: MeshSolution, load: float) -> MeshSolution:
    """The same bodies under another load, N."""
    if load == solution.contact.load:
        return solution
    return pressed(solution.bodies, load=load, expected=_scaled(solution, load))


def _load_of_mesh(loads: tuple[float, ...]) -> float:
    """The load whose ellipse sizes the mesh of a band, N: one of `loads` if that mesh holds all, else one between."""
    low, high = loads[0], loads[-1]
    least, most = high / WIDEST**3, low / NARROWEST**3
    share = np.log(1 / NARROWEST) / np.log(WIDEST / NARROWEST)
    middle = low ** (1 - share) * high**share  # both ends are equally near the bounds
    inside = [load for load in loads if least <= load <= most]
    return float(min(inside, key=lambda load: abs(np.log(load / middle)), default=middle))


def _scaled(solution: MeshSolution, load: float) -> tuple[float, float]:
    factor = (load / solution.contact.load) ** (1 / 3)
    return solution.semi_axes[0] * factor, solution.semi_axes[1] * factor


def _fits(solution: MeshSolution) -> bool:
    ratios = np.divide(solution.semi_axes, solution.pair.semi_axes)
    return bool(ratios.min() > NARROWEST - SLACK and ratios.max() < WIDEST + SLACK)


def _is_cut_correctly(solution: MeshSolution) -> bool:
    """Whether the mesh is cut off at exactly those shoulders that the ellipse of the load reaches."""
    for cut, shoulder in zip(solution.pair.footprint.shoulders, shoulders_of(solution.contact), strict=True):
        beyond = solution.semi_axes[1] / shoulder - 1
        if beyond <= -AT_SHOULDER if np.isfinite(cut) else beyond >= AT_SHOULDER:
            return False
    return True
