"""The ladder of one contact: Hertz, Hertz corrected for finite geometry, and meshes from coarse to fine."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array, Contact
from fembearing.check.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.check.contact.refinement import COMPARED, Estimates, Wanted, estimates_of, solve_by_twin
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.cost.ladder import Candidate, Ladder, clocked, measured
from fembearing.fem.compliance import pair_compliance
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.fem.twin import shared_axes
from fembearing.mesh.footprint import footprint_of
from fembearing.mesh.recipe import Recipe

FEWEST = 3  # meshes needed to extrapolate
WITH_TWIN = 1e-3  # accuracy for which meshes with a twin are shown
# Worst error of semi-axes, peak pressure and approach on each level of the recipe of a race, for any contact: the mesh
# follows the ellipse, so that all have about the same error. The errors of 16 random contacts were 0.045 to 0.099,
# 0.0038 to 0.0094, 0.0008 to 0.0020 and 0.0003 to 0.0007; validation/benchmarks/choices.py tests others. Pockets and
# contacts cut off at a shoulder were not compared.
LEVEL_BOUNDS = {1: 0.105, 2: 0.01, 3: 0.0021, 4: 0.0008}
# The same of the compliance of a pair: the errors of 19 random races and pockets, seeds 100 to 118 of
# validation/intervals/twin.py, were up to 0.0052 and 0.0005.
COMPLIANCE_BOUNDS = {1: 0.008, 2: 0.001}


def measured_contact(contact: Contact, *, recipe: Recipe, **how: Any) -> Ladder:
    """Formulas, every level of `recipe` without the sizing of its mesh, compliances of the pair, levels with a twin.

    recipe : of true shapes;  how : as `measured`
    Raises InputError for a contact that cannot be meshed, ConvergenceError for one that does not settle.
    """
    axes = fitted_solution(contact, recipe=recipe).pair.semi_axes
    meshes: dict[int, MeshSolution] = {}

    def on_mesh(level: int) -> MeshSolution:
        meshes[level] = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes)
        return meshes[level]

    def by_compliance(level: int) -> Quantities:
        """Half spaces on pixels with what the true shapes add; under another load only the pixels are solved again."""
        pair = pair_compliance(contact, recipe=recipe, level=level, semi_axes=shared_axes(axes))
        return press_pair(pair, load=contact.load).quantities

    def extrapolated() -> Estimates:
        if len(meshes) < FEWEST:
            raise InputError(f"{len(meshes)} meshes are solved, {FEWEST} are needed")
        return estimates_of(list(meshes.values()))

    levels = [_level(contact, level, partial(on_mesh, level)) for level in recipe.levels]
    bounds = {} if contact.pair == "pocket" else COMPLIANCE_BOUNDS
    others = [
        Candidate(f"compliance of the pair, level {level}", partial(by_compliance, level), _numbers, bounds.get(level))
        for level in (() if footprint_of(contact, axes).cut else recipe.levels[:2])
    ]
    seconds, twin = clocked(partial(solve_by_twin, contact, Wanted(recipe, accuracy=WITH_TWIN)))
    if twin is not None:  # with the sizing and the far boundary
        name = f"finite elements, twin, to level {twin.meshes[-1].level}"
        others.append(Candidate(name, lambda: twin.estimates, _limits, _off, once=True, spent=seconds))
    return _ladder(contact, levels, others, Candidate("finite elements, extrapolated", extrapolated), **how)


def contact_ladder_of(solution: ContactSolution) -> Ladder:
    """The contact ladder of a solution: formulas are timed here, each mesh has the seconds of its one solve."""
    found = solution.numbers
    levels = [
        _level(solution.contact, mesh.level, partial(lambda mesh: mesh, mesh))._replace(once=True, spent=mesh.seconds)
        for mesh in solution.meshes
    ]
    name = "finite elements, with twin" if found.refinement == "twin" else "finite elements, extrapolated"
    last = Candidate(name, lambda: found.estimates)
    ladder = _ladder(solution.contact, levels, [], last, tolerance=found.tolerance)
    return replace(ladder, quantity=f"{ladder.quantity}{which_bearing(found.bearing)}")


def _ladder(
    contact: Contact, levels: Sequence[Candidate], others: Sequence[Candidate], last: Candidate, **how: Any
) -> Ladder:
    """All methods of a contact;  last : estimates from all levels, at the price of all;  how : as `measured`"""
    after = tuple(level.name for level in levels)
    exact = last._replace(answer=_limits, bound=_off, may_refer=True, once=True, after=after)
    reference = "all meshes, extrapolated; worst of semi-axes, peak pressure and approach; seconds without sizing"
    return measured(f"contact, {contact.pair}", reference, [*_formulas(contact), *levels, *others, exact], **how)


def _formulas(contact: Contact) -> list[Candidate]:
    """Hertz, and on a race Hertz corrected for finite geometry."""

    def corrected(hertz: Quantities) -> CorrectedHertz:
        found, reasons = corrected_hertz(contact, hertz=hertz)
        if found is None:
            raise InputError("; ".join(reasons))
        return found

    def uncertainty(found: CorrectedHertz) -> Array:
        return np.array([found.uncertainty[name] for name in COMPARED])

    def missed(hertz: Quantities) -> float | None:
        """The size of the correction, and its uncertainty."""
        found, _ = corrected_hertz(contact, hertz=hertz)
        if found is None:
            return None
        return float(np.max(np.abs(_numbers(hertz) / _numbers(found.quantities) - 1) + uncertainty(found)))

    hertz = partial(hertz_quantities, contact)
    if contact.pair == "pocket":
        return [Candidate("Hertz", hertz, _numbers)]
    return [
        Candidate("Hertz", hertz, _numbers, missed),
        Candidate(
            "Hertz, corrected for finite geometry",
            lambda: corrected(hertz()),
            lambda found: _numbers(found.quantities),
            lambda found: float(uncertainty(found).max()),
        ),
    ]


def _level(contact: Contact, level: int, run: Callable[[], MeshSolution]) -> Candidate:
    def bound(mesh: MeshSolution) -> float | None:
        return LEVEL_BOUNDS.get(level) if contact.pair != "pocket" and mesh.shoulder is None else None

    return Candidate(f"finite elements, level {level}", run, lambda mesh: _numbers(mesh.quantities), bound, True)


def _off(estimates: Estimates) -> float:
    return max(part.mesh for name, part in estimates.items() if name in COMPARED)


def _limits(estimates: Estimates) -> Array:
    return np.array([estimates[name].limit for name in COMPARED])


def _numbers(quantities: Quantities) -> Array:
    return np.array([getattr(quantities, name) for name in COMPARED])
