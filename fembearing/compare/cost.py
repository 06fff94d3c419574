"""What each digit costs: for a quantity, the ways to compute it from cheap to exact, with error and seconds.

An error is relative to the ladder's reference rung, which has none of its own to show; seconds are wall time on this
machine. Rungs run from cheap to exact, each warmed up before it is timed.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.equilibrium import ThrustEquilibrium, free_angle, thrust_equilibrium, thrust_equilibrium_frozen
from analytic.errors import FembearingError, InputError, require_positive
from analytic.hertz import HertzContact, contact_modulus, hertz_contact, relative_curvatures
from analytic.hertz_fitted import hertz_contact_fitted
from analytic.scene import Contact, Scene
from fembearing.compare.corrected import corrected_hertz
from fembearing.compare.discrepancy import RECIPES, ContactSolution, contact_of, hertz_quantities
from fembearing.compare.progress import Progress, silent
from fembearing.compare.provenance import peak_memory, provenance_of
from fembearing.compare.reference import COMPARED, Estimates, estimates_of
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Recipe, load_recipe

FEWEST = 3  # meshes that can be extrapolated
HERTZ_FIELDS = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
FORMULA_REPEATS, MESH_REPEATS = 15, 3  # the median of 15 leaves out what other programs do to a short timing
SAMPLE = 5e-3  # s that one timing of a formula lasts at least: 1000 times what the clock and the loop take
MOST_CALLS = 1000  # in one timing


@dataclass(frozen=True, kw_only=True)
class Rung:
    """One way to compute a quantity."""

    name: str
    error: float | None  # worst relative deviation from the reference; None for the reference and where there is none
    seconds: float | None  # median of the repeats; None if it failed
    spread: float | None  # longest less shortest repeat, s
    repeats: int
    memory: int | None  # largest resident memory of the process so far, bytes: of this rung and those before it
    unknowns: int | None = None  # of a mesh
    chosen: bool = False  # the cheapest within the tolerance
    failed: str | None = None  # why it gave no answer, in one line

    def to_json(self) -> dict[str, Any]:
        return dict(vars(self))


@dataclass(frozen=True, kw_only=True)
class Ladder:
    """The rungs of one quantity, from cheap to exact."""

    quantity: str
    reference: str  # what the errors are taken against
    rungs: tuple[Rung, ...]

    @property
    def chosen(self) -> Rung | None:
        """The cheapest within the tolerance; None where no rung is."""
        return next((rung for rung in self.rungs if rung.chosen), None)

    def to_json(self) -> dict[str, Any]:
        return {
            "quantity": self.quantity,
            "reference": self.reference,
            "rungs": [rung.to_json() for rung in self.rungs],
        }


@dataclass(frozen=True, kw_only=True, eq=False)
class Cost:
    """What `measure_cost` found."""

    scene: Scene
    tolerance: float
    ladders: tuple[Ladder, ...]
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """The result as plain types; SI, errors relative."""
        return {
            "ladders": [ladder.to_json() for ladder in self.ladders],
            "tolerance": self.tolerance,
            "cost": {"seconds": self.seconds, "peak_memory": peak_memory()},
            "warnings": list(self.scene.warnings),
            "provenance": provenance_of(self.scene),
        }


@dataclass(frozen=True, kw_only=True, eq=False)
class Trial:
    """One way to compute a quantity that has run: a rung before it is compared."""

    name: str
    answer: np.ndarray | None  # what is compared, of one shape along a ladder; None if it failed
    seconds: tuple[float, ...] = ()  # of each repeat
    memory: int | None = None
    unknowns: int | None = None
    may_refer: bool = False  # the last of these that gave an answer is the reference
    failed: str | None = None


def measure_cost(scene: Scene, *, tolerance: float | None = None, progress: Progress = silent) -> Cost:
    """Error and time of every rung of a scene's ladders, in one run.

    tolerance : relative, for the choice; the scene's unless given
    progress : called with the share done, 0 to 1, and a word on the step at hand
    A rung that cannot solve the scene is shown with the reason. Raises InputError for a scene without a contact.
    """
    start = time.perf_counter()
    asked = scene.tolerance if tolerance is None else tolerance
    require_positive(tolerance=asked)
    progress(0.0, "formulas")
    contacts = contact_of(scene, pair="inner"), contact_of(scene, pair="outer")
    ladders = [hertz_ladder(contacts, tolerance=asked)]
    is_thrust = not (np.any(scene.operation.radial_load) or np.any(scene.operation.moment))
    if scene.contact_angle.rule == "solved" and is_thrust:
        ladders.append(angle_ladder(scene, tolerance=asked))
    recipe = load_recipe(RECIPES["real"])
    ladders.append(contact_ladder(contacts[0], recipe=recipe, tolerance=asked, progress=progress))
    return Cost(scene=scene, tolerance=asked, ladders=tuple(ladders), seconds=time.perf_counter() - start)


def hertz_ladder(contacts: Sequence[Contact], *, tolerance: float) -> Ladder:
    """Fitted against exact Hertz, all contacts in one call."""
    curvature_x, curvature_y = np.transpose([relative_curvatures(contact) for contact in contacts])
    load = np.array([contact.load for contact in contacts])
    modulus = np.array([contact_modulus(contact.ball_material, contact.race_material) for contact in contacts])

    def compared(formula: Callable[..., HertzContact]) -> np.ndarray:
        found = formula(curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus)
        return np.array([getattr(found, field) for field in HERTZ_FIELDS])

    trials = (
        timed_formula("fitted", lambda: compared(hertz_contact_fitted)),
        timed_formula("exact", lambda: compared(hertz_contact), may_refer=True),
    )
    reference = f"exact Hertz; worst of semi-axes, peak pressure and approach of {len(contacts)} contacts"
    return ladder_of("Hertz contact", reference, trials, tolerance=tolerance)


def angle_ladder(scene: Scene, *, tolerance: float) -> Ladder:
    """The loaded contact angle of a scene whose rule is `solved`, worst over its operating points."""
    bearing, rule, load = scene.bearing, scene.contact_angle, scene.operation.axial_load

    def unloaded() -> np.ndarray:
        free = free_angle(bearing) if rule.free is None else rule.free
        if free is None:
            raise InputError("a preloaded bearing has no free contact angle")
        return np.full_like(load, free)

    def loaded(solve: Callable[..., ThrustEquilibrium]) -> np.ndarray:
        return solve(bearing, rule, axial_load=load).contact_angle

    trials = (
        timed_formula("free angle", unloaded),
        timed_formula("frozen stiffness", lambda: loaded(thrust_equilibrium_frozen)),
        timed_formula("solved", lambda: loaded(thrust_equilibrium), may_refer=True),
    )
    reference = f"equilibrium of contacts that follow the angle; worst of {load.size} operating points"
    return ladder_of("contact angle", reference, trials, tolerance=tolerance)


def contact_ladder(contact: Contact, *, recipe: Recipe, tolerance: float, progress: Progress = silent) -> Ladder:
    """Hertz, corrected Hertz, then every level of `recipe`, timed apart from the sizing of the mesh."""
    trials = _formula_trials(contact)
    try:
        semi_axes = fitted_solution(contact, recipe=recipe).pair.semi_axes  # also warms up
    except FembearingError as problem:
        trials += [Trial(name=_level_name(level), answer=None, failed=str(problem)) for level in recipe.levels]
        return ladder_of(_contact_quantity(contact), _mesh_reference([], None), trials, tolerance=tolerance)
    work = np.cumsum([0, *(level**3 for level in recipe.levels)])
    meshes = []
    for number, level in enumerate(recipe.levels):
        progress(float(work[number] / work[-1]), f"{contact.pair}: mesh {number + 1}")
        try:
            solved = [
                solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes) for _ in range(MESH_REPEATS)
            ]
        except FembearingError as problem:
            trials.append(Trial(name=_level_name(level), answer=None, failed=str(problem)))
            continue
        meshes.append(solved[-1])
        seconds = tuple(mesh.seconds for mesh in solved)
        trials.append(_mesh_trial(solved[-1], seconds=seconds, memory=peak_memory()))
        del solved  # the next level should find its memory free
    estimates = estimates_of(meshes) if len(meshes) >= FEWEST else None
    trials += _extrapolated(estimates, trials)
    return ladder_of(_contact_quantity(contact), _mesh_reference(meshes, estimates), trials, tolerance=tolerance)


def contact_ladder_of(found: ContactSolution) -> Ladder:
    """The contact ladder of a solution at hand: formulas timed in place, each mesh at the seconds it took, once."""
    meshes = [_mesh_trial(mesh, seconds=(mesh.seconds,)) for mesh in found.meshes]
    trials = [*_formula_trials(found.contact), *meshes, *_extrapolated(found.estimates, meshes)]
    reference = _mesh_reference(found.meshes, found.estimates)
    return ladder_of(_contact_quantity(found.contact), reference, trials, tolerance=found.tolerance)


def timed_formula(name: str, run: Callable[[], np.ndarray], *, may_refer: bool = False) -> Trial:
    """A formula's answer and seconds a call: one call to warm up, then samples long enough for the clock."""
    try:
        answer = run()
        once = _seconds(run, calls=1)
        calls = int(np.clip(np.ceil(SAMPLE / once), 1, MOST_CALLS))
        seconds = tuple(_seconds(run, calls=calls) for _ in range(FORMULA_REPEATS))
    except FembearingError as problem:
        return Trial(name=name, answer=None, failed=str(problem))
    return Trial(name=name, answer=answer, seconds=seconds, memory=peak_memory(), may_refer=may_refer)


def ladder_of(quantity: str, reference: str, trials: Sequence[Trial], *, tolerance: float) -> Ladder:
    """Compare each trial with the reference and choose the cheapest within `tolerance` (relative)."""
    exact = next((trial for trial in reversed(trials) if trial.may_refer and trial.answer is not None), None)
    rungs = []
    for trial in trials:
        error = None
        if exact is not None and exact.answer is not None and trial.answer is not None and trial is not exact:
            error = float(np.max(np.abs(trial.answer / exact.answer - 1)))
        rungs.append(
            Rung(
                name=trial.name,
                error=error,
                seconds=float(np.median(trial.seconds)) if trial.seconds else None,
                spread=max(trial.seconds) - min(trial.seconds) if trial.seconds else None,
                repeats=len(trial.seconds),
                memory=trial.memory,
                unknowns=trial.unknowns,
                failed=trial.failed,
            )
        )
    within = [
        (rung.seconds, number)
        for number, (rung, trial) in enumerate(zip(rungs, trials, strict=True))
        if rung.seconds is not None and (trial is exact or (rung.error is not None and rung.error <= tolerance))
    ]
    if within:
        _, cheapest = min(within)
        rungs[cheapest] = replace(rungs[cheapest], chosen=True)
    return Ladder(quantity=quantity, reference=reference, rungs=tuple(rungs))


def _seconds(run: Callable[[], object], *, calls: int) -> float:
    start = time.perf_counter()
    for _ in range(calls):
        run()
    return (time.perf_counter() - start) / calls


def _formula_trials(contact: Contact) -> list[Trial]:
    """Hertz, and on a race Hertz corrected for finite geometry."""

    def corrected() -> np.ndarray:
        found, beyond = corrected_hertz(contact, hertz=hertz_quantities(contact))
        if found is None:
            raise InputError("; ".join(beyond))
        return _compared(found.quantities)

    trials = [timed_formula("Hertz", lambda: _compared(hertz_quantities(contact)))]
    if contact.pair != "pocket":
        trials.append(timed_formula("Hertz, corrected for finite geometry", corrected))
    return trials


def _mesh_trial(mesh: MeshSolution, *, seconds: tuple[float, ...], memory: int | None = None) -> Trial:
    return Trial(
        name=_level_name(mesh.level),
        answer=_compared(mesh.quantities),
        seconds=seconds,
        memory=memory,
        unknowns=mesh.unknowns,
        may_refer=True,
    )


def _level_name(level: int) -> str:
    return f"finite elements, level {level}"


def _contact_quantity(contact: Contact) -> str:
    return f"contact, {contact.pair}"


def _mesh_reference(meshes: Sequence[MeshSolution], estimates: Estimates | None) -> str:
    """What the errors of a contact ladder are taken against, in words."""
    if not meshes:
        return "none: no mesh was solved"
    words = "worst of semi-axes, peak pressure and approach"
    if estimates is None:
        return f"finite elements, level {meshes[-1].level}; {words}; too few meshes to say how far off it is"
    off = max(part.mesh for name, part in estimates.items() if name in COMPARED)
    return f"all meshes, extrapolated; {words}; uncertain by {100 * off:.2g} %; seconds without sizing the mesh"


def _extrapolated(estimates: Estimates | None, trials: Sequence[Trial]) -> list[Trial]:
    """What three meshes or more say together, at the price of all."""
    if estimates is None:
        return []
    return [
        Trial(
            name="finite elements, extrapolated",
            answer=np.array([estimates[name].limit for name in COMPARED]),
            seconds=(sum(float(np.median(trial.seconds)) for trial in trials if trial.unknowns and trial.seconds),),
            memory=peak_memory(),
            may_refer=True,
        )
    ]


def _compared(quantities: Quantities) -> np.ndarray:
    return np.array([getattr(quantities, name) for name in COMPARED])
