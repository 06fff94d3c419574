"""The ladder of one contact: Hertz, Hertz corrected for finite geometry, and meshes from coarse to fine."""

from collections.abc import Sequence

import numpy as np

from analytic.errors import FembearingError, InputError
from analytic.scene import Array, Contact
from fembearing.compare.contact.discrepancy import ContactSolution
from fembearing.compare.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.compare.contact.mesh_refinement import COMPARED, Estimates, estimates_of
from fembearing.compare.contact.mesh_seconds import about, predicted_seconds
from fembearing.compare.cost.ladder import Ladder, Trial, Way, ladder_of, timed
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.memory import peak_while
from fembearing.mesh.recipe import Recipe
from fembearing.progress import Progress, silent

FEWEST = 3  # meshes that can be extrapolated
MESH_REPEATS = 3
DEAR = 10.0  # s: a mesh that takes longer is timed once, or a slow machine would take minutes
# Worst error of semi-axes, peak pressure and approach on each level of the recipe of a race, whatever the contact: a
# mesh that follows the ellipse leaves about the same of any. 16 random contacts left 0.045 to 0.099, 0.0038 to 0.0094,
# 0.0008 to 0.0020 and 0.0003 to 0.0007; validation/benchmarks/choices.py tries others.
LEVEL_BOUNDS = {1: 0.105, 2: 0.01, 3: 0.0021, 4: 0.0008}


def measured_contact(contact: Contact, *, recipe: Recipe, tolerance: float, progress: Progress = silent) -> Ladder:
    """Hertz, corrected Hertz, then every level of `recipe`, timed apart from the sizing of the mesh.

    Each level's seconds are predicted from the largest mesh solved before it; it is run once more than it is timed.
    """
    trials = _formula_trials(contact)
    try:
        sized = fitted_solution(contact, recipe=recipe)
    except FembearingError as problem:
        trials += [Trial(name=_level_name(level), answer=None, failed=str(problem)) for level in recipe.levels]
        return ladder_of(_quantity(contact), _reference([], None), trials, tolerance=tolerance)
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
            trials.append(Trial(name=_level_name(level), answer=None, failed=str(problem), predicted=expected))
            continue
        meshes.append(mesh)
        trials.append(_mesh_trial(mesh, seconds=seconds, warm_up=warm_up, memory=memory, predicted=expected))
    estimates = estimates_of(meshes) if len(meshes) >= FEWEST else None
    trials += _extrapolated(estimates, trials)
    return ladder_of(_quantity(contact), _reference(meshes, estimates), trials, tolerance=tolerance)


def contact_ladder_of(found: ContactSolution) -> Ladder:
    """The contact ladder of a solution at hand: formulas timed in place, each mesh at the seconds it took, once."""
    meshes = [_mesh_trial(mesh, seconds=(mesh.seconds,)) for mesh in found.meshes]
    trials = [*_formula_trials(found.contact), *meshes, *_extrapolated(found.estimates, meshes)]
    reference = _reference(found.meshes, found.estimates)
    return ladder_of(_quantity(found.contact), reference, trials, tolerance=found.tolerance)


def level_bound(contact: Contact, mesh: MeshSolution) -> float | None:
    """On the error of one mesh; None for what was not compared: pockets, and contacts cut off at a shoulder."""
    return LEVEL_BOUNDS.get(mesh.level) if contact.pair != "pocket" and mesh.shoulder is None else None


def _formula_trials(contact: Contact) -> list[Trial]:
    """Hertz, and on a race Hertz corrected for finite geometry; the correction bounds both."""

    def correction() -> CorrectedHertz:
        found, beyond = corrected_hertz(contact, hertz=hertz_quantities(contact))
        if found is None:
            raise InputError("; ".join(beyond))
        return found

    def of_corrected() -> float:
        return max(correction().uncertainty[name] for name in COMPARED)

    def of_hertz() -> float:
        """What the correction mends, and what it may leave."""
        try:
            fitted = correction()
        except InputError:
            return np.inf
        off = np.abs(_compared(hertz_quantities(contact)) / _compared(fitted.quantities) - 1)
        return float(np.max(off + [fitted.uncertainty[name] for name in COMPARED]))

    on_race = contact.pair != "pocket"
    hertz = Way(
        name="Hertz",
        run=lambda: _compared(hertz_quantities(contact)),
        bound=of_hertz if on_race else lambda: np.inf,
    )
    if not on_race:
        return [timed(hertz)]
    corrected = Way(
        name="Hertz, corrected for finite geometry",
        run=lambda: _compared(correction().quantities),
        bound=of_corrected,
    )
    return [timed(hertz), timed(corrected)]


def _mesh_trial(
    mesh: MeshSolution,
    *,
    seconds: tuple[float, ...],
    warm_up: float | None = None,
    memory: int | None = None,
    predicted: float | None = None,
) -> Trial:
    return Trial(
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
    """How often a mesh that takes so long is timed."""
    return 1 if seconds > DEAR else MESH_REPEATS


def _level_name(level: int) -> str:
    return f"finite elements, level {level}"


def _quantity(contact: Contact) -> str:
    return f"contact, {contact.pair}"


def _reference(meshes: Sequence[MeshSolution], estimates: Estimates | None) -> str:
    """What the errors of a contact ladder are taken against, in words."""
    if not meshes:
        return "none: no mesh was solved"
    words = "worst of semi-axes, peak pressure and approach"
    if estimates is None:
        return f"finite elements, level {meshes[-1].level}; {words}; too few meshes to say how far off it is"
    return f"all meshes, extrapolated; {words}; uncertain by {100 * _off(estimates):.2g} %; seconds without sizing"


def _off(estimates: Estimates) -> float:
    return max(part.mesh for name, part in estimates.items() if name in COMPARED)


def _extrapolated(estimates: Estimates | None, trials: Sequence[Trial]) -> list[Trial]:
    """What three meshes or more say together, at the price of all."""
    if estimates is None:
        return []
    meshes = [trial for trial in trials if trial.unknowns and trial.seconds]
    memories = [trial.memory for trial in meshes if trial.memory is not None]
    return [
        Trial(
            name="finite elements, extrapolated",
            answer=np.array([estimates[name].limit for name in COMPARED]),
            bound=_off(estimates),
            seconds=(sum(float(np.median(trial.seconds)) for trial in meshes),),
            memory=max(memories, default=None),
            may_refer=True,
        )
    ]


def _compared(quantities: Quantities) -> Array:
    return np.array([getattr(quantities, name) for name in COMPARED])
