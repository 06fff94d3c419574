"""What accuracy costs in a scene: every method of every ladder, with its error, bound, seconds and memory.

The function of a ladder gives what the errors are relative to, and the methods. It raises InputError, with the reason,
for a scene that has nothing to compare.
"""

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from operator import attrgetter
from typing import Any

import numpy as np

from analytic.cage.drive import cage_drive
from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.steady import DrivenCage
from analytic.cage.torque import cage_friction, cage_moves, driven_cage
from analytic.contact.geometry import RACES
from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.hertz_fitted import fitted_error, hertz_contact_fitted
from analytic.effects import ruled
from analytic.errors import FembearingError, InputError, require_positive
from analytic.free_ball.rotation import LEVELS as FREE_NODES
from analytic.loads.inertia import moment_of_turned_axis, outward_force
from analytic.loads.kinematics import BallMotion, ball_kinematics
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.ring import ring_equilibrium
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium, thrust_equilibrium_frozen
from analytic.numerics.elements import mapped
from analytic.numerics.records import Records
from analytic.oil.film import FILM_FACTORS
from analytic.oil.variation import COVERAGE, FIT_SHARE, ROLLING_SPREAD
from analytic.progress import Progress, part_of, silent
from analytic.rows import Count
from analytic.scene import Array, Contact, Scene
from analytic.sliding.ball import LEVELS as ELLIPSE_NODES
from analytic.solve.solution import points_of, solved
from analytic.surface.heightmap import WIDEST, measure
from analytic.surface.map_data import FEWEST_POINTS
from analytic.surface.moments import SpectralMoments
from analytic.surface.roughness import generated_surface, spectral_moments
from analytic.torque import friction_torque, loaded_balls_of
from analytic.words import speed_of
from fembearing.check.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.check.contact.reference import solve_by_pair
from fembearing.check.contact.refinement import COMPARED, Estimates, Wanted, estimates_of
from fembearing.check.contact.scene_contact import RECIPES, contact_of, which_bearing
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.cost.ladder import ROUND_OFF, Candidate, Ladder, clocked, deviation, measured
from fembearing.check.creep.production import models_of, produced
from fembearing.check.creep.scene_creep import reference_torque, scene_at_heaviest
from fembearing.check.film.scene_film import problem_of
from fembearing.check.memory import peak_memory
from fembearing.ehl.film import numerical_film
from fembearing.fem.compliance import sampled_pair
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.fem.twin import shared_axes
from fembearing.mesh.footprint import footprint_of
from fembearing.mesh.recipe import Recipe, load_recipe
from fembearing.provenance import Provenance, provenance_of

Declared = tuple[str, list[Candidate]]  # what the last method that may refer is, in words, and the methods
# Relative change of the heaviest ball's load per share of centrifugal force and of gyroscopic pull in it: a larger
# inner angle unloads the inner race. Chosen on random scenes (validation/benchmarks/choices.py).
PER_CENTRIFUGAL, PER_PULL = 1.5, 1.5
HEAVIEST = 5.0  # times Fr/Z: load of the heaviest ball under a radial load; Stribeck's 4.37, rounded up for clearance
SETTLED = 1e-10  # difference of two iterations to the same equilibrium
# Tolerances that begin with each level of nodes, from coarse to fine; a level that misses half of its tolerance is left
# for the next one
LEVELS = (0.05, 5e-3, 5e-4, 1e-6)
FINEST = 0.02  # least uncertainty that is asked of stick and slip
LARGEST_MAP = 2048  # points along a side of a generated surface: takes 0.2 GB
SEED = 20250  # of the generated surfaces: arbitrary, but the same every time
# Deviation of one generated surface from its ensemble. On a square of side L the mean square height has the relative
# standard deviation sqrt(2 (integral of rho^2)/L^2) = sqrt(pi) B/L, with either autocorrelation, and Sq half of that;
# SCATTER is a little more than two of these. Slopes and curvatures scatter less. Differences over a spacing d make a
# smooth surface's curvature too small by 0.8 (d/B)^2 (analytic.surface.heightmap.measure).
SCATTER, LOW_BY = 2.0, 1.0
SEEDS, DURATION = 3, 0.02  # of each motion; s, shorter than a scene's, so that all repeats take less than half a minute
SHARES = (0.25, 0.5, 1.0, 2.0)  # of the scene's steps per contact
MODEL = "as in the torque"
FEWEST = 3  # meshes needed to extrapolate
BY_PAIR = 1e-3  # accuracy for which levels of the pair's compliance are shown
# Worst error of semi-axes, peak pressure and approach on each level of the recipe of a race, for any contact: the mesh
# follows the ellipse, so that all have about the same error. The errors of 16 random contacts were 0.045 to 0.099,
# 0.0038 to 0.0094, 0.0008 to 0.0020 and 0.0003 to 0.0007; validation/benchmarks/choices.py tests others. Pockets and
# contacts cut off at a shoulder were not compared.
LEVEL_BOUNDS = {1: 0.105, 2: 0.01, 3: 0.0021, 4: 0.0008}
# The same of the compliance of a pair: the errors of 19 random races and pockets, seeds 100 to 118 of
# validation/intervals/levels.py, were up to 0.0052 and 0.0005.
COMPLIANCE_BOUNDS = {1: 0.008, 2: 0.001}


def hertz(scene: Scene) -> Declared:
    """Fitted and exact Hertz, both races in one call."""
    contacts = [contact_of(scene, pair=race) for race in RACES]
    x, y = np.transpose([relative_curvatures(each) for each in contacts])
    given = {
        "load": np.array([each.load for each in contacts]),
        "modulus": np.array([contact_modulus(each.ball_material, each.race_material) for each in contacts]),
    }
    fitted, exact = (partial(f, curvature_x=x, curvature_y=y, **given) for f in (hertz_contact_fitted, hertz_contact))
    numbers = attrgetter("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
    return "exact Hertz; worst of semi-axes, peak pressure and approach of 2 contacts", [
        Candidate("fitted", fitted, numbers, float(np.max(fitted_error(curvature_x=x, curvature_y=y)))),
        Candidate("exact", exact, numbers, ROUND_OFF, may_refer=True),
    ]


def loads(scene: Scene) -> Declared:
    """Load of the heaviest ball on each race at every operating point; by thrust alone where each point has thrust."""
    bearing, rule, operation = scene.bearing, scene.contact_angle, scene.operation.as_series()
    if rule.rule == "given":
        raise InputError('contact_angle.rule = "given" fixes the angle, and thrust gives the loads in closed form')
    axial, methods = operation.axial_load, []

    def on_both(found: Records) -> Array:
        return found["load"].T

    def ring() -> Array:
        found = ring_equilibrium(
            bearing,
            rule,
            axial_load=axial,
            radial_load_x=operation.radial_load,
            moment_y=operation.moment,
            tilts=None if np.isnan(operation.held_tilt) else (0.0, operation.held_tilt),
            inner_speed=operation.inner_speed,
        )
        return found.balls["load"].max(axis=1).T

    def at_free_angle() -> Array:
        return np.stack([axial / (bearing.ball_count * np.sin(_free_angle(scene)))] * 2)

    if np.all(axial > 0):
        frozen = partial(thrust_equilibrium_frozen, bearing, rule, axial_load=axial)
        at_speed = partial(thrust_equilibrium, bearing, rule, axial_load=axial, inner_speed=operation.inner_speed)
        unequal, inertia = _left_out_by_thrust(scene)
        still = float(np.max(unequal + inertia)) + SETTLED
        methods = [
            Candidate("free angle", at_free_angle, bound=lambda _: _opened(scene) + still),
            Candidate("thrust, frozen stiffness", frozen, on_both, lambda found: _softened(scene, found) + still),
            Candidate("thrust, solved", partial(_thrust, scene), on_both, still),
            Candidate("thrust, at speed", at_speed, on_both, float(np.max(unequal)) + SETTLED),
        ]
    reference = f"equilibrium of the ring, inertia included; worst of both races at {axial.size} operating points"
    return reference, [*methods, Candidate("equilibrium of the ring", ring, bound=ROUND_OFF, may_refer=True)]


def _thrust(scene: Scene, angle: float | None = None, points: int | slice = slice(None)) -> Records:
    """Thrust at operating points, by numbers from 0;  angle : rad, None: by the scene's rule."""
    rule = scene.contact_angle if angle is None else replace(scene.contact_angle, rule="given", value=angle)
    return thrust_equilibrium(scene.bearing, rule, axial_load=scene.operation.as_series().axial_load[points])


def _free_angle(scene: Scene) -> float:
    _, free = play_and_free_angle(scene.bearing, scene.contact_angle)
    if not free:
        raise InputError("no ball carries thrust at a free contact angle of 0, and a preload has none")
    return free


def _opened(scene: Scene) -> float:
    """sin al/sin al0 - 1: at the free angle al0 the load is too large, and so is the angle al that it opens."""
    free = _free_angle(scene)
    opened = approaches(_thrust(scene, free)).sum(axis=-1) / scene.bearing.groove_centre_distance
    return float(np.max(np.sin(np.arccos(np.cos(free) / (1 + opened))) / np.sin(free) - 1))


def _softened(scene: Scene, frozen: Records) -> float:
    """Bound from the error of the approach at the loaded angle, with the contacts' stiffness held at the free angle.

    Q falls as sin al rises, and ln(tan al) changes by at most 3/2 of the approach's relative change at any angle.
    """
    angle, approach = frozen["angle"][..., 0], approaches(frozen).sum(axis=-1)
    true = [float(approaches(_thrust(scene, float(each), n)).sum()) for n, each in enumerate(angle)]
    return float(np.max(np.abs(approach / true - 1) * np.cos(angle) ** 2 * 3 / 2))


def _left_out_by_thrust(scene: Scene) -> tuple[Array, Array]:
    """(n,) effects of radial load with moment, and of inertia, on the load of the heaviest ball, over its true load."""
    bearing, operation, still = scene.bearing, scene.operation.as_series(), _thrust(scene)
    sideways = np.abs(operation.radial_load) + np.abs(operation.moment) / bearing.pitch_diameter
    unequal = HEAVIEST * sideways / (bearing.ball_count * still["load"][..., 0])
    angle, speed = still["angle"][..., 0], operation.inner_speed
    motion = BallMotion._make(
        mapped(ball_kinematics, speed, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    )
    outward = outward_force(bearing.ball_mass, bearing.pitch_diameter, motion.cage_speed)
    upright = moment_of_turned_axis(
        bearing.ball_mass, bearing.ball_diameter, motion.ball_speed, motion.cage_speed, np.pi / 2
    )
    pull = upright * np.cos(angle) / bearing.ball_radius  # of the friction that holds the moment, along the axis
    return unequal / (1 + unequal), (PER_CENTRIFUGAL * outward + PER_PULL * pull) / still["load"][..., 0]


def friction(scene: Scene) -> Declared:
    """Torque of the races by the nodes that integrate sliding over the ellipses, with closed kinematics."""
    _require_sliding(scene)
    closed = replace(scene, spin_rule="balanced") if scene.spin_rule == "free" else scene
    return f"sliding integrated over the ellipses; {_worst(scene)}", _by_nodes("over ellipses", closed, ELLIPSE_NODES)


def turning(scene: Scene) -> Declared:
    """Torque of the races by how the balls turn: by rule, or freely with or without creep.

    Nothing bounds what a rule and rigid surfaces miss.
    """
    _require_sliding(scene)
    free = replace(scene, spin_rule="free")
    if reason := ruled(free):
        raise InputError(f"the balls do not turn freely: {reason}")
    rigid = replace(free, effects={**scene.effects, "creep": "off"})
    return f"torque of free balls, creep marched through many nodes; {_worst(scene)}", [
        _torque("rule of balanced spin", replace(scene, spin_rule="balanced"))._replace(bound=None),
        _torque("free balls without creep", rigid)._replace(bound=None),
        *_by_nodes("with marched creep", free, FREE_NODES),
    ]


def _require_sliding(scene: Scene) -> None:
    if not scene.has_friction:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    if scene.microslip == "as_printed":
        raise InputError('friction.microslip = "as_printed" has one method: the paper\'s moments')
    if scene.effects.get("spin") == scene.effects.get("conformity") == "off":
        raise InputError("nothing slides: spin and conformity are off")


def _worst(scene: Scene) -> str:
    return f"worst of {scene.operation.as_series().axial_load.size} operating points"


def _by_nodes(words: str, scene: Scene, nodes: Sequence[tuple[int, int]]) -> list[Candidate]:
    return [
        _torque(f"{words}, from {n} by {m} nodes", replace(scene, tolerance=tolerance))
        for (n, m), tolerance in zip(nodes, LEVELS, strict=True)
    ]


def _torque(name: str, scene: Scene) -> Candidate:
    return Candidate(
        name,
        partial(friction_torque, replace(scene, effects={**scene.effects, "cage": "off"})),
        answer=lambda found: found.settled().torque.race,
        bound=lambda found: float(np.max(found.numerical_uncertainty)),
        may_refer=scene.tolerance == LEVELS[-1],
    )


def sliding(scene: Scene) -> Declared:
    """Torque by sliding of all balls at the operating point of the heaviest one. Raises InputError as `creep_of`."""
    given, _ = scene_at_heaviest(scene)
    by_rule, free = models_of(given)
    points, torque = points_of(given.operation, free.temperature), attrgetter("sliding_torque")
    reference = partial(reference_torque, produced(given), tolerance=max(scene.tolerance, FINEST))
    return "stick and slip on half spaces; all balls at the operating point of the heaviest one", [
        Candidate("formula, closed kinematics", partial(solved, by_rule, points), torque),
        Candidate("free balls, marched creep", partial(solved, free, points), torque),
        Candidate("stick and slip", reference, lambda found: found[0], lambda found: found[1] / found[0], True),
    ]


def roughness(scene: Scene) -> Declared:
    """Rms height (Sq), slope and curvature of the declared surface: in closed form, and of generated surfaces."""
    surface = scene.surface
    if surface is None:
        raise InputError("the scene has no [surface]")
    correlation, rms = surface.autocorrelation, surface.rms_roughness
    if correlation is None or rms is None:
        raise InputError("the surface is measured: its height map is the only method for its moments")
    if rms == 0:
        raise InputError("surface.rms_roughness = 0: a smooth surface has no slopes to compare")
    kind, length, spacing = correlation.kind, correlation.length, correlation.spacing

    def generated(size: int) -> SpectralMoments:
        made = generated_surface(rms_roughness=rms, autocorrelation=correlation, points=size, seed=SEED)
        return measure(made).moments

    def numbers(moments: SpectralMoments) -> Array:
        return np.sqrt([moments.height, moments.slope, moments.curvature])

    def bound(size: int) -> float:
        """Scatter, by the correlation lengths in the map, and on a smooth surface the error of differences."""
        return SCATTER * length / (size * spacing) + (LOW_BY * (spacing / length) ** 2 if kind == "gaussian" else 0.0)

    least = max(length / (WIDEST * spacing) * (1 - 1e-12), FEWEST_POINTS)
    first = int(2 ** np.ceil(np.log2(least)))
    sizes = [size for size in (first, 2 * first, 4 * first) if size <= LARGEST_MAP] or [first]
    if spacing > WIDEST * length * (1 + 1e-12) or first > 2 * LARGEST_MAP:
        sizes = []  # none can be generated: the spacing is too coarse, or there are too many points
    closed = partial(spectral_moments, rms_roughness=rms, autocorrelation=correlation)
    return "closed forms, exact for the given autocorrelation; worst of Sq, slope and curvature, rms", [
        Candidate("closed-form moments", closed, numbers, ROUND_OFF, may_refer=True),
        *(Candidate(f"generated, {n} x {n}", partial(generated, n), numbers, bound(n)) for n in sizes),
    ]


def cage(scene: Scene) -> Declared:
    """Torque of the cage at the fastest operating point, each method with the friction coefficient of the closed form.

    The motion starts from rest, as the closed form assumes, unless the scene says how its cage started. Raises
    InputError for a scene without a cage, without friction in its pockets, at standstill, or with balls that lead
    farther than the pockets leave free.
    """
    given, series = scene.cage, scene.operation.as_series()
    if given is None:
        raise InputError("the scene has no [cage]")
    if not scene.has_friction and given.friction_coefficient is None:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    operation = series.at(np.array([np.argmax(np.abs(series.inner_speed))]))
    speed = float(operation.inner_speed[0])
    if speed == 0:
        raise InputError("the bearing stands still, without friction of the cage")
    resting = replace(scene, operation=operation, effects={**scene.effects, "cage": "on", "cage_dynamics": "off"})
    drive = cage_drive(resting, loaded_balls_of(resting), scene.friction_coefficient, operation.inner_speed)
    closed_form = partial(cage_friction, resting, drive, cage_moves(resting, None))
    level = driven_cage(
        scene.bearing,
        given,
        friction_coefficient=float(closed_form().friction_coefficient[0]),
        inner_speed=speed,
        orbit_speed=float(drive.orbit_speed[0]),
        ball_speed=float(drive.ball_speed[0]),
        contact_angle=float(drive.contact_angle[0]),
    )
    driven = replace(level, ball_lead=float(drive.grip.ball_lead[0]))
    start, duration = given.start or "rest", min(max(DURATION, driven.crossing_time), given.duration)
    longer = given.seeds * given.duration / (SEEDS * duration)
    how = {"start": start, "seeds": SEEDS, "duration": duration}
    words = f'motion in the finest steps, from "{start}", {SEEDS} seeds of {duration:.3g} s at {speed_of(speed)}'
    return f"{words}; the motion of the scene takes {longer:.3g} times as long", [
        # No closed form bounds what this one leaves out: only the motion shows it.
        Candidate("closed form at rest", closed_form, attrgetter("torque")),
        *_motions(driven, [share * given.steps_per_contact for share in SHARES], how),
    ]


def _motions(driven: DrivenCage, steps: Sequence[float], how: dict[str, Any]) -> Iterator[Candidate]:
    """The motion of a cage in so many steps a contact, each list twice as many; how : as `measured_motion`"""
    done: dict[float, CageStatistics] = {}

    def moved(number: float) -> CageStatistics:
        done[number] = measured_motion.__wrapped__(driven, **how, steps_per_contact=number)  # not from its cache
        return done[number]

    def bound(motion: CageStatistics, coarser: float) -> float | None:
        """The change from twice the step, and half the interval of the mean over seeds; None without a coarser one."""
        if coarser not in done:
            return None
        low, high = motion.torque_interval
        interval = 0.0 if high == low else (high - low) / 2 / abs(motion.torque)
        return deviation(np.array(done[coarser].torque), np.array(motion.torque)) + interval

    for each in steps:
        name, limit = f"motion, {each:g} steps a contact", partial(bound, coarser=each / 2)
        yield Candidate(name, partial(moved, each), attrgetter("torque"), limit, may_refer=True)


def films(scene: Scene) -> Iterator[Declared]:
    """Central film and rolling force of the heaviest ball on the inner race, from the same grids."""
    closed = problem_of(scene, "inner")
    found = numerical_film(closed.problem)
    of_film, spread = FILM_FACTORS[1] - 1, COVERAGE * ROLLING_SPREAD
    of_fit = spread * (1 - closed.model_force()[1] * (1 - FIT_SHARE))
    film = [Candidate("formula", closed.film, bound=of_film), Candidate(MODEL, closed.model_film, bound=of_film)]
    force = [
        Candidate("formula", closed.resistance, attrgetter("force"), float(np.expm1(spread))),
        Candidate(MODEL, lambda: closed.model_force()[0], bound=float(np.expm1(of_fit))),
    ]
    for part, formulas in ((found.central_film, film), (found.rolling_force, force)):
        grids = [
            Candidate(f"numerical, grid {1 + number}", partial(float, value), once=True, spent=seconds)
            for number, (value, seconds) in enumerate(zip(part.values, found.grid_seconds, strict=True))
        ]
        last = Candidate("numerical, three grids", partial(float, part.value), np.asarray, part.total, True, True)
        yield (
            "three grids, extrapolated; the seconds of a grid include those of the coarser grids",
            [*formulas, *grids, last._replace(spent=found.seconds)],
        )


def contact_methods(contact: Contact, recipe: Recipe) -> Declared:
    """Formulas, levels of `recipe` without the sizing of their mesh, compliances of the pair, and these extrapolated.

    recipe : of true shapes
    Raises InputError for a contact that cannot be meshed, ConvergenceError for one that does not settle.
    """
    axes = fitted_solution(contact, recipe=recipe).pair.semi_axes
    meshes: dict[int, MeshSolution] = {}

    def on_mesh(level: int) -> MeshSolution:
        meshes[level] = solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes)
        return meshes[level]

    def by_compliance(level: int) -> Quantities:
        """Half spaces on pixels with what the true shapes add; under another load only the pixels are solved again."""
        _, pair = sampled_pair(contact, recipe=recipe, level=level, semi_axes=shared_axes(axes))
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
    seconds, pair = clocked(partial(solve_by_pair, contact, Wanted(recipe, accuracy=BY_PAIR)))
    if pair is not None:  # with the far boundary
        name = f"compliance of the pair, extrapolated, to level {pair.meshes[-1].level}"
        others.append(Candidate(name, lambda: pair.estimates, _numbers, _off, once=True, spent=seconds))
    return _of_contact(contact, levels, others, Candidate("finite elements, extrapolated", extrapolated))


def contact_ladder_of(solution: ContactSolution) -> Ladder:
    """The contact ladder of a solution: formulas are timed here, each mesh has the seconds of its one solve."""
    found = solution.numbers
    levels = [
        _level(solution.contact, mesh.level, partial(lambda mesh: mesh, mesh))._replace(once=True, spent=mesh.seconds)
        for mesh in solution.meshes
    ]
    way = "compliance of the pair" if found.refinement == "pair" else "finite elements"
    methods = _of_contact(solution.contact, levels, [], Candidate(f"{way}, extrapolated", lambda: found.estimates))
    return measured(f"contact, {found.pair}{which_bearing(found.bearing)}", *methods, tolerance=found.tolerance)


def _of_contact(
    contact: Contact, levels: Sequence[Candidate], others: Sequence[Candidate], last: Candidate
) -> Declared:
    """Formulas, and all methods of a contact;  last : estimates from all levels, at the price of all"""

    def corrected() -> CorrectedHertz:
        found, reasons = corrected_hertz(contact, hertz=hertz_quantities(contact))
        if found is None:
            raise InputError("; ".join(reasons))
        return found

    def uncertainty(found: CorrectedHertz) -> list[float]:
        return [found.uncertainty[name] for name in COMPARED]

    def missed(hertz: Quantities) -> float | None:
        """The size of the correction, and its uncertainty."""
        found, _ = corrected_hertz(contact, hertz=hertz)
        return found and float(np.max(np.abs(_numbers(hertz) / _numbers(found) - 1) + uncertainty(found)))

    formulas = [Candidate("Hertz", partial(hertz_quantities, contact), _numbers)]
    if contact.pair != "pocket":
        name = "Hertz, corrected for finite geometry"
        best = Candidate(name, corrected, _numbers, lambda found: max(uncertainty(found)))
        formulas = [formulas[0]._replace(bound=missed), best]
    after = tuple(level.name for level in levels)
    exact = last._replace(answer=_numbers, bound=_off, may_refer=True, once=True, after=after)
    reference = "all meshes, extrapolated; worst of semi-axes, peak pressure and approach; seconds without sizing"
    return reference, [*formulas, *levels, *others, exact]


def _level(contact: Contact, level: int, run: Callable[[], MeshSolution]) -> Candidate:
    def bound(mesh: MeshSolution) -> float | None:
        return LEVEL_BOUNDS.get(level) if contact.pair != "pocket" and mesh.shoulder is None else None

    return Candidate(f"finite elements, level {level}", run, _numbers, bound, may_refer=True)


def _off(estimates: Estimates) -> float:
    return max(estimates[name].mesh for name in COMPARED)


def _numbers(found: MeshSolution | CorrectedHertz | Quantities | Estimates) -> Array:
    """The quantities that are compared; of estimates those for vanishing cells."""
    if isinstance(found, dict):
        return np.array([found[name].limit for name in COMPARED])
    return np.array([getattr(getattr(found, "quantities", found), name) for name in COMPARED])


FORMULA_LADDERS: dict[str, Callable[[Scene], Declared]] = {
    "Hertz contact": hertz,
    "load of the heaviest ball": loads,
    "friction torque": friction,
    "how balls turn": turning,
    "sliding in the contacts": sliding,
    "roughness": roughness,
    "cage torque": cage,
}
FILMS = "central film, inner", "rolling force, inner"


@dataclass(frozen=True, kw_only=True)
class Spent:
    """What a computation took."""

    seconds: float
    peak_memory: Count | None  # of the process, bytes


@dataclass(frozen=True, kw_only=True, eq=False)
class Cost:
    """The measured ladders of a scene."""

    ladders: tuple[Ladder, ...]
    tolerance: float
    cost: Spent
    warnings: tuple[str, ...]  # of the scene, one line each
    provenance: Provenance


def measure_cost(scene: Scene, *, tolerance: float | None = None, progress: Progress = silent) -> Cost:
    """Error and time of every method of a scene's ladders, in one run.

    tolerance : relative, for the choice; the scene's unless given
    progress : called with the share done, 0 to 1, and the name of the current step
    A method that cannot solve the scene is shown with the reason, and so is a ladder that the scene does not have.
    Raises InputError for a scene without a contact.
    """
    start = time.perf_counter()
    tolerance = scene.tolerance if tolerance is None else tolerance
    require_positive(tolerance=tolerance)
    contact = contact_of(scene, pair="inner")  # raises for a scene without one
    runs: dict[tuple[str, ...], Callable[[], Iterable[Declared]]] = {
        (name,): lambda declare=declare: [declare(scene)] for name, declare in FORMULA_LADDERS.items()
    }
    runs |= {
        FILMS: lambda: films(scene),
        ("contact, inner",): lambda: [contact_methods(contact, load_recipe(RECIPES["real"]))],
    }
    ladders = []
    for number, (quantities, declare) in enumerate(runs.items()):
        part = part_of(progress, number / len(runs), (number + 1) / len(runs))
        part(0.0, quantities[0])
        try:
            declared = zip(quantities, declare(), strict=True)
            ladders += [measured(name, *each, tolerance=tolerance, progress=part) for name, each in declared]
        except FembearingError as reason:
            ladders += [Ladder(quantity=each, absent=str(reason)) for each in quantities]
    return Cost(
        tolerance=tolerance,
        ladders=tuple(ladders),
        cost=Spent(seconds=time.perf_counter() - start, peak_memory=peak_memory()),
        warnings=tuple(scene.warnings),
        provenance=provenance_of(scene),
    )
