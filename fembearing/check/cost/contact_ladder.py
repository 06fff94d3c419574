"""The ladder of one contact: Hertz, Hertz corrected for finite geometry, and meshes from coarse to fine."""

import time
from collections.abc import Sequence
from functools import partial

import numpy as np

from analytic.errors import FembearingError, InputError
from analytic.progress import Progress, silent
from analytic.scene import Array, Contact
from fembearing.check.contact.bearings import which_bearing
from fembearing.check.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.check.contact.mesh_seconds import about, predicted_seconds
from fembearing.check.contact.refinement import COMPARED, Estimates, Refinement, estimates_of, solve_by_twin
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.cost.ladder import Ladder, TimedMethod, UntimedMethod, ladder_of, timed
from fembearing.check.memory import peak_while
from fembearing.fem.compliance import pair_compliance
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.fem.twin import shared_axes
from fembearing.mesh.footprint import footprint_of
from fembearing.mesh.recipe import Recipe

FEWEST = 3  # meshes needed to extrapolate
WITH_TWIN = 1e-3  # accuracy for which meshes with a twin are shown
MESH_REPEATS = 3
DEAR = 10.0  # s: a mesh that takes longer is timed once, to save minutes on a slow machine
# Worst error of semi-axes, peak pressure and approach on each level of the recipe of a race, for any contact: the mesh
# follows the ellipse, so that all have about the same error. The errors of 16 random contacts were 0.045 to 0.099,
# 0.0038 to 0.0094, 0.0008 to 0.0020 and 0.0003 to 0.0007; validation/benchmarks/choices.py tests others.
LEVEL_BOUNDS = {1: 0.105, 2: 0.01, 3: 0.0021, 4: 0.0008}
# The same of the compliance of a pair: the errors of 19 random races and pockets, seeds 100 to 118 of
# validation/intervals/twin.py, were up to 0.0052 and 0.0005.
COMPLIANCE_BOUNDS = {1: 0.008, 2: 0.001}


def measured_contact(contact: Contact, *, recipe: Recipe, tolerance: float, progress: Progress = silent) -> Ladder:
    """Hertz, corrected Hertz, then every level of `recipe`, timed without the sizing of the mesh.

    Each level's seconds are predicted from the largest mesh solved before it. A level runs once more than it is timed.
    """
    methods = _formulas(contact)
    try:
        sized = fitted_solution(contact, recipe=recipe)
    except FembearingError as problem:
        methods += [TimedMethod(name=_level_name(level), answer=None, failed=str(problem)) for level in recipe.levels]
        return ladder_of(_quantity(contact), _reference([], None), methods, tolerance=tolerance)
    work = np.cumsum([0, *(level**3 for level in recipe.levels)])
    meshes: list[MeshSolution] = []
    for number, level in enumerate(recipe.levels):
        expected = predicted_seconds(level, known=max([sized, *meshes], key=lambda mesh: mesh.level))
        step = f"{contact.pair}: mesh {number + 1}, {about((1 + _repeats(expected)) * expected)}"
        progress(float(work[number] / work[-1]), step)

        def solve(level: int = level) -> MeshSolution:
            return solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=sized.pair.semi_axes)

        try:
            warm_up = solve().seconds
            mesh, memory = peak_while(solve)
            seconds = (mesh.seconds, *(solve().seconds for _ in range(_repeats(mesh.seconds) - 1)))
        except FembearingError as problem:
            methods.append(TimedMethod(name=_level_name(level), answer=None, failed=str(problem), predicted=expected))
            continue
        meshes.append(mesh)
        methods.append(_mesh_method(mesh, seconds=seconds, warm_up=warm_up, memory=memory, predicted=expected))
    estimates = estimates_of(meshes) if len(meshes) >= FEWEST else None
    levels = list(methods)
    methods += _by_compliance(contact, recipe, sized.pair.semi_axes)
    methods += _with_twin(contact, recipe)
    methods += _extrapolated(estimates, levels)
    return ladder_of(_quantity(contact), _reference(meshes, estimates), methods, tolerance=tolerance)


def _by_compliance(contact: Contact, recipe: Recipe, semi_axes: tuple[float, float]) -> list[TimedMethod]:
    """Half spaces on pixels with what the true shapes add, from each coarse level; none without a true shape.

    Under another load of a series the compliance is known, and only its pixels are solved again.
    """
    if recipe.geometry != "real" or footprint_of(contact, semi_axes).cut:
        return []

    def solved(level: int) -> Array:
        compliance = pair_compliance(contact, recipe=recipe, level=level, semi_axes=shared_axes(semi_axes))
        return _compared(press_pair(compliance, load=contact.load).quantities)

    bounds = COMPLIANCE_BOUNDS if contact.pair != "pocket" else {}
    return [
        timed(
            UntimedMethod(
                name=f"compliance of the pair, level {level}",
                run=partial(solved, level),
                bound=partial(bounds.get, level, np.inf),
            )
        )
        for level in recipe.levels[:2]
    ]


def _with_twin(contact: Contact, recipe: Recipe) -> list[TimedMethod]:
    """The coarse levels with their twin as `solve_reference` takes them, with sizing and far boundary; none without."""
    if recipe.geometry != "real":
        return []
    start = time.perf_counter()
    found = solve_by_twin(
        contact, recipe=recipe, accuracy=WITH_TWIN, quantities=COMPARED, undecided=lambda _: False, progress=silent
    )
    if found is None:
        return []
    return [
        TimedMethod(
            name=f"finite elements, twin, to level {found.meshes[-1].level}",
            answer=np.array([found.estimates[name].limit for name in COMPARED]),
            bound=_off(found.estimates),
            seconds=(time.perf_counter() - start,),
        )
    ]


def contact_ladder_of(solution: ContactSolution) -> Ladder:
    """The contact ladder of a solution: formulas are timed here, each mesh has the seconds of its one solve."""
    found = solution.numbers
    meshes = [_mesh_method(mesh, seconds=(mesh.seconds,)) for mesh in solution.meshes]
    methods = [*_formulas(solution.contact), *meshes, *_extrapolated(found.estimates, meshes, found.refinement)]
    reference = _reference(solution.meshes, found.estimates)
    return ladder_of(
        f"{_quantity(solution.contact)}{which_bearing(found.bearing)}",
        reference,
        methods,
        tolerance=found.tolerance,
    )


def level_bound(contact: Contact, mesh: MeshSolution) -> float | None:
    """Bound on the error of one mesh; None for pockets and contacts cut off at a shoulder, which were not compared."""
    return LEVEL_BOUNDS.get(mesh.level) if contact.pair != "pocket" and mesh.shoulder is None else None


def _formulas(contact: Contact) -> list[TimedMethod]:
    """Hertz, and on a race Hertz corrected for finite geometry; the correction gives the bounds of both."""

    def correction() -> CorrectedHertz:
        corrected, reasons = corrected_hertz(contact, hertz=hertz_quantities(contact))
        if corrected is None:
            raise InputError("; ".join(reasons))
        return corrected

    def bound_of_corrected() -> float:
        return max(correction().uncertainty[name] for name in COMPARED)

    def bound_of_hertz() -> float:
        """The size of the correction, and its uncertainty."""
        try:
            corrected = correction()
        except InputError:
            return np.inf
        off = np.abs(_compared(hertz_quantities(contact)) / _compared(corrected.quantities) - 1)
        return float(np.max(off + [corrected.uncertainty[name] for name in COMPARED]))

    on_race = contact.pair != "pocket"
    hertz = UntimedMethod(
        name="Hertz",
        run=lambda: _compared(hertz_quantities(contact)),
        bound=bound_of_hertz if on_race else lambda: np.inf,
    )
    if not on_race:
        return [timed(hertz)]
    corrected = UntimedMethod(
        name="Hertz, corrected for finite geometry",
        run=lambda: _compared(correction().quantities),
        bound=bound_of_corrected,
    )
    return [timed(hertz), timed(corrected)]


def _mesh_method(
    mesh: MeshSolution,
    *,
    seconds: tuple[float, ...],
    warm_up: float | None = None,
    memory: int | None = None,
    predicted: float | None = None,
) -> TimedMethod:
    return TimedMethod(
        name=_level_name(mesh.level),
        answer=_compared(mesh.quantities),
        bound=level_bound(mesh.contact, mesh),
        seconds=seconds,
        warm_up=warm_up,
        predicted=predicted,
        memory=memory,
        unknowns=mesh.unknowns,
        may_refer=True,
    )


def _repeats(seconds: float) -> int:
    """Number of timings of a mesh that takes so long."""
    return 1 if seconds > DEAR else MESH_REPEATS


def _level_name(level: int) -> str:
    return f"finite elements, level {level}"


def _quantity(contact: Contact) -> str:
    return f"contact, {contact.pair}"


def _reference(meshes: Sequence[MeshSolution], estimates: Estimates | None) -> str:
    """What the errors of a contact ladder are relative to, in words."""
    if not meshes:
        return "none: no mesh was solved"
    words = "worst of semi-axes, peak pressure and approach"
    if estimates is None:
        return f"finite elements, level {meshes[-1].level}; {words}; too few meshes for an uncertainty"
    return f"all meshes, extrapolated; {words}; uncertainty {100 * _off(estimates):.2g} %; seconds without sizing"


def _off(estimates: Estimates) -> float:
    return max(part.mesh for name, part in estimates.items() if name in COMPARED)


def _extrapolated(
    estimates: Estimates | None, methods: Sequence[TimedMethod], refinement: Refinement = "levels"
) -> list[TimedMethod]:
    """The extrapolation of several meshes, at the price of all."""
    if estimates is None:
        return []
    meshes = [each for each in methods if each.unknowns and each.seconds]
    memories = [mesh.memory for mesh in meshes if mesh.memory is not None]
    return [
        TimedMethod(
            name=f"finite elements, {'with twin' if refinement == 'twin' else 'extrapolated'}",
            answer=np.array([estimates[name].limit for name in COMPARED]),
            bound=_off(estimates),
            seconds=(sum(float(np.median(mesh.seconds)) for mesh in meshes),),
            memory=max(memories, default=None),
            may_refer=True,
        )
    ]


def _compared(quantities: Quantities) -> Array:
    return np.array([getattr(quantities, name) for name in COMPARED])
