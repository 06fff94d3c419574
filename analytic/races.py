"""What balls and races lose, by the kernel: which effects count, how the balls turn, and by which method they slide."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, PER_CENTRIFUGAL, PER_LAG, TRIED, ruled
from analytic.effects.trial import (
    OF_METHODS,
    Trial,
    at_all_points,
    decide_effects,
    growth_by_wedging,
    left_out_at_all,
    method_of_changes,
    possible,
    rolls_otherwise,
    slip_by_gyroscopic_moment,
    slip_by_weight,
    trial_of,
    unequal_loads,
)
from analytic.errors import ConvergenceError, InputError, require_finite, require_positive
from analytic.free_ball.rotation import QUADRATURES, Creep
from analytic.loads.balls import LoadedBalls
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.ring_balance import require_enough_balls
from analytic.loads.thrust import require_given_angle
from analytic.numerics.records import Records
from analytic.oil.variation import NOMINAL, Variation
from analytic.scene import Array, Bearing, Decision, Operation, Scene
from analytic.scene import Sliding as Method
from analytic.scenefile.fit import crowding
from analytic.sliding.judge import ALONG_AXIS, AS_PRINTED, FINE, METHODS, OVER_ELLIPSE
from analytic.solve.failures import require_settled, undistributed
from analytic.solve.freely import BETWEEN, error_of_sliding, other_states, part_by_sliding, slide_freely
from analytic.solve.freely import METHODS as FREE_METHODS
from analytic.solve.model import Model, weights_of
from analytic.solve.records import OWN_FORCES
from analytic.solve.sample import BY_SLIP, slide_by_sample
from analytic.solve.solution import Solution, solved
from analytic.surface.roughness import GapRoughness, gap_roughness
from analytic.words import NEWTON, NEWTON_MILLIMETRE

# rad: below, a force across a contact turns it by more of its own angle, and spin follows the angle. The torque changes
# by 6.8 shares of the weight at 0.1 rad, by 5.3 at 0.28 and by 4.8 at 0.25 (validation/adversary/run.py).
FLAT_ANGLE = 0.5
NEARLY_TURNED, LEAST_LEFT = 0.9, 1e-6  # of the friction, judgements: what its gyroscopic moment takes, and what is left
NEARLY_WEDGED = 4.0  # times, a judgement: balls whose loads friction lets change by so much may have others
TINIEST = 1e-300
WEDGED = "friction across the grooves wedges balls, whose loads change by more than closed kinematics show"
NOT_UNIQUE = "not applied: friction across the grooves wedges balls, whose loads are not unique; raise the load"
CREEP_OF: Mapping[Method, Creep] = {method: creep for creep, method in FREE_METHODS.items()}
LOADING = ("load_distribution", "weight", "centrifugal", "gyroscopic", "finite_geometry")


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceTorque:
    """What the races resist, and of which balls; n operating points."""

    scene: Scene
    trial: Trial
    counted: Mapping[str, bool]  # every effect of balls and races but creep
    found: Solution
    method: Method  # by which sliding is computed; auto: nothing slides
    error: Array  # (n,) of the method, relative to the torque by sliding
    computed: int  # number of points by the method; the others are interpolated
    warnings: tuple[str, ...]  # of the contacts' finite geometry
    beyond_fit: bool  # a contact lies outside the fit for finite geometry
    any_direction: NDArray[np.bool_]  # (n,) whether the balls' weight counts and nobody knows its direction
    other: Array  # (n,) race torque in another steady state of the balls, N m; NaN: none is known
    is_wedged: bool  # friction across the grooves lets balls have several loads, and their torque is that of equal ones

    @cached_property
    def balls(self) -> LoadedBalls:
        """The loaded balls as arrays."""
        return self.found.loaded_balls(self.scene.bearing)

    @property
    def slides(self) -> bool:
        """Whether spin or conformity counts."""
        return self.method != "auto"

    @cached_property
    def parts(self) -> dict[str, Array]:
        """Each (n,), N m, of the effects that count."""
        names = ("hysteresis", "rolling", *BY_SLIP)
        return {name: self.found.points[name].copy() for name in names if self.counted[name]}

    @cached_property
    def total(self) -> Array:
        """(n,) N m."""
        return self.found.race_torque

    @property
    def is_free(self) -> bool:
        """Whether the balls turn freely."""
        return self.method in CREEP_OF

    @property
    def coefficient(self) -> Array | None:
        """(2, n, m) friction coefficient of each contact; None: nothing slides."""
        return np.moveaxis(self.found.balls["friction_coefficient"], -1, 0) if self.slides else None

    @property
    def is_mixed(self) -> bool:
        """Whether film and asperities share the load of the contacts."""
        return self.slides and self.scene.friction_coefficient is None

    @property
    def are_alike(self) -> bool:
        """Whether one ball stands for all."""
        return self.found.balls.shape[1] == 1

    @cached_property
    def growth(self) -> float:
        """Factor on what weights do to balls by rule: above 1 where friction wedges free balls."""
        by_rule, found = self.trial.solved(self.counted), self.found.at(self.trial.tried)
        return float(growth_by_wedging(self.scene.bearing, by_rule, found).max())

    @cached_property
    def heaviest(self) -> Records:
        """(n,) `records.BALL`: the ball that presses hardest on a race at each operating point."""
        balls = self.found.balls
        return balls[np.arange(len(balls)), balls["load"].max(axis=2).argmax(axis=1)]

    @cached_property
    def gap_roughness(self) -> GapRoughness | None:
        """Of ball and race together; None: nothing slides, or its friction coefficient is given."""
        surface = self.scene.surface
        return gap_roughness(surface) if self.slides and surface is not None else None

    @property
    def sliding_number(self) -> Array | None:
        """(2, n) rolling force of the oil on all balls over the most friction of each race; None: not computed.

        A race turns its balls against this force. Beyond 1 it cannot, and the balls skid.
        """
        return self.found.sliding_number if self.slides and self.counted["rolling"] else None

    @property
    def gyroscopic_hold(self) -> Array | None:
        """(n,) gyroscopic moment over the most that friction holds, of the worst ball; None: it has no part."""
        known = ENTRIES["gyroscopic"].lacks(self.scene) is None and self.scene.effects.get("gyroscopic") != "off"
        return self.found.points["gyroscopic_hold"].copy() if self.slides and known else None

    @property
    def brink(self) -> Array:
        """(n,) times more that an error changes the torque where the gyroscopic moment takes nearly all friction; or 0.

        What is left of the friction u of a ball, 1 - u, decides how far it slips, and a small change may turn it. From
        u = NEARLY_TURNED on u/(1 - u) counts, beyond its value there.
        """
        if not (self.is_free and self.counted["gyroscopic"]):
            return np.zeros(len(self.found.points))
        used = self.found.points["gyroscopic_hold"]
        used = np.where(np.isfinite(used), used, 0.0)  # without friction nothing holds them
        left = np.maximum(np.abs(1 - used), LEAST_LEFT)
        return np.maximum(used / left - NEARLY_TURNED / (1 - NEARLY_TURNED), 0.0)

    def change_at_edge(self) -> Array:
        """(n,) change of rolling where forces that are left out take a ball off a race, or press it on one, N m.

        Free balls begin where those of the point before settled, with the first quadrature, whose error is common to
        both. Where only a force that counts all but takes a ball off, a smaller one moves it too: balls by rule show by
        how much. Infinite where they do not settle.
        """
        can = possible(self.scene)
        left_out = [can[name] and not self.counted[name] for name in OWN_FORCES]
        change = np.zeros(len(self.found.points))
        if not any(left_out) or not self.counted["rolling"]:
            return change
        every = {**self.counted, **{name: can[name] or self.counted[name] for name in LOADING}}
        every["unloaded_balls"] = can["unloaded_balls"]
        with_, without = (self.trial.model.counting(each) for each in (every, self.counted))
        by_any, by_these = (self.found.points["at_edge"][:, which].any(axis=1) for which in (slice(None), left_out))
        for at, solve in ((by_any & ~by_these, self._by_rule), (by_these, self._cheaply)):
            if at.any():
                rolling = [solve(model, np.flatnonzero(at)).points["rolling"] for model in (with_, without)]
                change[at] = np.abs(rolling[0] - rolling[1])
        return np.where(np.isnan(change), np.inf, change)

    def _cheaply(self, model: Model, at: NDArray[np.intp]) -> Solution:
        if not self.is_free:
            return self._by_rule(model, at)
        free = model.turning_freely(self.scene.bearing, CREEP_OF[self.method]).with_numbers(passes=1, cold=False)
        return solved(free.at(at), self.trial.points[at])

    def lead_spread(self, at: NDArray[np.intp]) -> Array:
        """(k,) largest change of how far free balls lead by the next two coarser quadratures, m.

        The coarsest one is compared with the second, and balls by rule that stand for free ones with both of these. A
        quadrature by which the balls do not settle shows nothing.
        """
        own, lead = (self.found.points[name][at] for name in ("passes", "ball_lead"))
        spread = np.zeros(at.size)
        creep = CREEP_OF[self.method if self.is_free else "marched_creep"]
        free = self.trial.model.counting(self.counted).turning_freely(self.scene.bearing, creep)
        for number in range(1, len(QUADRATURES)):
            others = np.flatnonzero((number != own) & (number >= own - 2) & (number <= np.maximum(own, 2)))
            if others.size:
                found = solved(free.with_numbers(passes=number).at(at[others]), self.trial.points[at[others]])
                spread[others] = np.fmax(spread[others], np.abs(found.points["ball_lead"] - lead[others]))
        return spread

    def by_rule(self, at: NDArray[np.intp], *, farthest: bool = False) -> Solution:
        """Balls by rule at p points, with the method of sliding of trials; NaN where they have no torque.

        farthest : contacts outside the fit have the factors at the far end of what is not known
        """
        return self._by_rule(self.trial.model.counting(self.counted).with_numbers(farthest=farthest), at)

    def with_weight(self, at: NDArray[np.intp], down: tuple[float, float, float] | None) -> Solution:
        """The same under the balls' own loads, with their weight in a direction; None: without weight."""
        return self._by_rule(self._weighing(down), at)

    def freely_with_weight(self, at: NDArray[np.intp], down: tuple[float, float, float] | None) -> Solution:
        """Free balls likewise; NaN where they do not settle. Raises KeyError where the balls turn by rule.

        They have the second quadrature, whose error is common to all directions.
        """
        model = self._weighing(down).turning_freely(self.scene.bearing, CREEP_OF[self.method])
        return solved(model.with_numbers(passes=2).at(at), self.trial.points[at])

    def _by_rule(self, model: Model, at: NDArray[np.intp]) -> Solution:
        cheap = model.with_numbers(method=method_of_changes(self.scene), judges=False)
        return solved(cheap.at(at), self.trial.points[at])

    def _weighing(self, down: tuple[float, float, float] | None) -> Model:
        """Balls under their own loads, with their weight in a direction; those that come off roll in oil."""
        weights = weights_of(self.scene.bearing, down)
        counted = {**self.counted, "load_distribution": True, "weight": bool(weights.any())}
        rolls_off = self.scene.effects.get("unloaded_balls") != "off"
        lacks = ENTRIES["unloaded_balls"].lacks(self.scene)
        counted["unloaded_balls"] = lacks is None and rolls_off and counted["rolling"]
        return self.trial.model.weighing(weights).counting(counted)


def race_torque(
    ledger: Ledger, operation: Operation, *, correction: ContactCorrection | None, variation: Variation
) -> RaceTorque:
    """The races' part of the torque; settles every effect of balls and races.

    operation : the scene's, every array (n,);  correction, variation : as in `analytic.torque.friction_torque`
    Raises InputError and ConvergenceError as the loads and the sliding do.
    """
    scene = ledger.scene
    if variation is NOMINAL:  # balls of a sample may overlap: it varies their size and the pitch diameter apart
        _require_room(scene.bearing)
    _require_loads(scene, operation)
    trial = trial_of(scene, operation, correction, variation)
    base = _base(scene, trial, operation)
    counted = decide_effects(ledger, trial, base, has_factors=correction is not None)
    any_direction = _any_direction(ledger, trial, counted)
    slides = counted["spin"] or counted["conformity"]
    creep = _free_creep(ledger, trial, counted, base, slides=slides)
    allowed = scene.tolerance - ledger.left_out
    method: Method = "auto"
    computed = len(trial.points)
    if creep is not None:
        found, error = _slide_freely(ledger, trial, counted, creep)
        method = FREE_METHODS[creep]
    else:
        found, error, method, computed = _slide_by_rule(scene, trial, counted, allowed, slides=slides)
    warnings, beyond = _finite_geometry(ledger, scene, found, is_given=correction is not None)
    return RaceTorque(
        scene=scene,
        trial=trial,
        counted=counted,
        found=found,
        method=method,
        error=error,
        computed=computed,
        warnings=warnings,
        beyond_fit=beyond,
        any_direction=any_direction,
        other=np.full(len(trial.points), np.nan) if creep is None else _other_states(trial, counted, creep, found),
        is_wedged=any(effect.reason == NOT_UNIQUE for effect in ledger.made.values()),
    )


def loaded_balls_of(scene: Scene) -> LoadedBalls:
    """The loaded balls at every operating point, with every effect on their loads that the scene does not rule out.

    They turn by closed kinematics. Raises InputError and ConvergenceError as `friction_torque` does.
    """
    operation = scene.operation.as_series()
    _require_room(scene.bearing)
    _require_loads(scene, operation)
    off: dict[str, Decision] = {name: "off" for name in TRIED if name not in LOADING}
    # Loads are the same whatever resists sliding, which the scene may lack.
    bare = replace(scene, lubricant=None, surface=None, effects={**scene.effects, **off})
    trial = trial_of(bare, operation, None, NOMINAL)
    _base(bare, trial, operation)
    model = trial.model.counting(possible(bare))
    found = solved(model, trial.points)
    require_settled(bare, model, trial.points, found)
    return found.loaded_balls(scene.bearing)


def _require_room(bearing: Bearing) -> None:
    """Raise InputError for more balls than fit, which a scene file cannot have."""
    if crowded := crowding(bearing):
        raise InputError(f"bearing.ball_count = {bearing.ball_count} {crowded}")


def _require_loads(scene: Scene, operation: Operation) -> None:
    """Raise InputError for loads that no method takes."""
    bearing = scene.bearing
    require_finite(**{f"operation.{name}": values for name, values in operation.points.items()})
    require_positive(ball_count=bearing.ball_count)
    require_given_angle(bearing, scene.contact_angle)
    if operation.is_thrust:
        require_positive(axial_load=operation.axial_load)
    elif bearing.kind == "thrust":
        _require_thrust(operation)
    elif abs(operation.held_tilt) > 0 and scene.contact_angle.rule == "given":
        raise InputError(
            f"operation.tilt = {operation.held_tilt:g} rad changes the contact angles, which the rule 'given' holds: "
            "use the rule 'solved', or leave the tilt out"
        )
    elif ENTRIES["load_distribution"].lacks(scene) is None and scene.effects.get("load_distribution") != "off":
        require_enough_balls(bearing)


def _require_thrust(operation: Operation) -> None:
    """Raise InputError for loads that a thrust bearing does not take."""
    for name, unit in (("radial_load", NEWTON), ("moment", NEWTON_MILLIMETRE)):
        values = np.asarray(getattr(operation, name))
        if np.any(values):
            largest = unit.written(values.flat[np.argmax(np.abs(values))], "g")
            raise InputError(
                f"operation.{name} = {largest}: a thrust bearing carries axial_load alone; leave {name} out"
            )
    if abs(operation.held_tilt) > 0:
        raise InputError(
            f"operation.tilt = {operation.held_tilt:g} rad: washers are parallel in a thrust bearing; leave tilt out"
        )


def _base(scene: Scene, trial: Trial, operation: Operation) -> Solution:
    """The tried points with every effect. Raises the error of the first that has no torque."""
    counted, points = possible(scene), trial.points[trial.tried]
    base, lacks = trial.solved(counted), ENTRIES["load_distribution"].lacks(scene)
    if lacks is not None and not operation.is_thrust:
        unequal = float(unequal_loads(scene, operation, trial.under_thrust).max())
        if unequal > scene.tolerance:
            raise undistributed(unequal, lacks)
    if base.points["status"].any():  # what is wrong without the balls' own forces has the better words
        still = counted | dict.fromkeys(("weight", "centrifugal", "gyroscopic", "finite_geometry"), False)
        require_settled(scene, trial.model.counting(still).at(trial.tried), points, trial.solved(still))
        require_settled(scene, trial.model.at(trial.tried), points, base)
    return base


def _any_direction(ledger: Ledger, trial: Trial, counted: Mapping[str, bool]) -> NDArray[np.bool_]:
    """(n,) where the balls' weight counts, and nobody knows its direction."""
    scene = ledger.scene
    unknown = scene.down is None and scene.contact_angle.rule == "solved"
    if not unknown or ledger.rules_out("weight"):
        return np.zeros(len(trial.points), dtype=bool)
    found = trial.solved(counted)
    if not trial.is_of_all:
        loads = {name: counted[name] for name in LOADING}
        found = solved(trial.model.counting(loads), trial.points, keeps_balls=False)
    lean = np.maximum(FLAT_ANGLE / np.maximum(found.points["contact_angle"], TINIEST), 1.0)
    alone = OF_METHODS if ledger.rules_out("conformity") else 1.0  # spin alone changes more than both together
    return ~ledger.leaves_out_at(alone * PER_CENTRIFUGAL * lean * found.points["weight_share"])


def _free_creep(
    ledger: Ledger, trial: Trial, counted: dict[str, bool], base: Solution, *, slides: bool
) -> Creep | None:
    """Settle creep; how the surfaces of freely turning balls creep, or None where closed kinematics turn them.

    Raises InputError for a method of sliding for free balls where something else in the scene says otherwise.
    """
    scene, contrary = ledger.scene, ruled(ledger.scene)
    wanted = {"closed_creep": "closed", "marched_creep": "marched"}.get(scene.sliding)
    if wanted is not None and ledger.rules_out("creep"):
        contrary = contrary or 'effects.creep = "off" neglects the creep: use "auto"'
    asked = scene.sliding in FREE_METHODS.values()
    if slides and contrary is not None and asked:
        raise InputError(f'friction.sliding = "{scene.sliding}" is refused: {contrary}')
    tried, between = trial.solved(counted) if slides else base, 1.0 if trial.is_of_all else BETWEEN
    share = tried.points["creep"] + PER_LAG * tried.sliding_number.max(axis=0)
    on = ledger.decide(
        "creep",
        bound=np.full_like(ledger.left_out, between * share.max()) if slides else None,
        lacks=None if slides else ENTRIES["creep"].idle,
        demanded=None if wanted is None else f'friction.sliding = "{scene.sliding}" has it',
    )
    if not slides or contrary is not None:
        return None
    if on:
        creep: Creep = "closed" if scene.sliding == "closed_creep" else "marched"
    elif asked or not _rule_suffices(ledger, trial, counted, tried):
        creep = "none"
    else:
        return None
    if not counted["spin"]:
        counted["spin"] = True
        ledger.settle("spin", on=True, reason=ENTRIES["spin"].given)
    return creep


def _rule_suffices(ledger: Ledger, trial: Trial, counted: Mapping[str, bool], tried: Solution) -> bool:
    """Whether closed kinematics turn balls well enough: friction drives and holds them, inertia hardly counts."""
    inertia = [name for name in ("centrifugal", "gyroscopic") if counted[name]]
    bound = at_all_points(ledger, rolls_otherwise(ledger.scene.bearing, tried))
    if inertia:
        bound = bound + left_out_at_all(ledger, trial.share_by_parts(counted, *inertia))
    if counted["weight"]:
        bound = bound + at_all_points(ledger, slip_by_weight(ledger.scene.bearing, tried))
    if counted["gyroscopic"]:
        bound = bound + slip_by_gyroscopic_moment(ledger, tried)
    if ledger.rules_out("creep"):  # else its bound has the lag
        bound = bound + at_all_points(ledger, PER_LAG * tried.sliding_number.max(axis=0))
    return ledger.leaves_out(bound)


def _slide_freely(ledger: Ledger, trial: Trial, counted: dict[str, bool], creep: Creep) -> tuple[Solution, Array]:
    """The balls at every operating point, and the error of their torque by sliding, (n,), relative to it.

    What makes balls unequal was left out by a trial with balls by rule. It counts after all where friction wedges the
    balls and what it may change grows beyond the tolerance. Where the balls do not settle with it, it stays out and
    the uncertainty is infinite. Raises ConvergenceError where the balls do not settle either way.
    """
    scene, points = ledger.scene, trial.points

    def slid() -> tuple[Solution, Array]:
        model = trial.model.counting(counted).turning_freely(scene.bearing, creep)
        allowed = float((scene.tolerance - ledger.left_out).min())
        return slide_freely(scene, model.with_numbers(allowed=allowed), points)

    found, error = slid()
    may, unequal = possible(scene), ("load_distribution", "weight")
    out = [name for name in unequal if may[name] and scene.effects.get(name, "auto") == "auto"]
    if not out or any(counted[name] for name in unequal):
        return found, error
    growth = float(growth_by_wedging(scene.bearing, trial.solved(counted), found.at(trial.tried)).max())
    share = max(ledger.made[name].share or 0.0 for name in out)
    if ledger.leaves_out(np.full_like(ledger.left_out, (growth - 1) * share if share else 0.0)):
        return found, error
    for name in out:
        counted[name] = True
        ledger.settle(name, on=True, share=growth * share, reason=WEDGED)
    try:
        return slid()
    except ConvergenceError:
        for name in out:
            counted[name] = False
            ledger.not_applied(name, NOT_UNIQUE)
        return found, error


def _other_states(trial: Trial, counted: Mapping[str, bool], creep: Creep, found: Solution) -> Array:
    """(n,) race torque in another steady state, N m; NaN: none is known. Of a longer series the tried points tell."""
    other, tried = np.full(len(trial.points), np.nan), trial.tried
    model = trial.model.counting(counted).turning_freely(trial.scene.bearing, creep)
    growth = growth_by_wedging(trial.scene.bearing, trial.solved(counted), found.at(tried))
    other[tried] = other_states(model.at(tried), trial.points[tried], found.at(tried), growth > NEARLY_WEDGED)
    return other


def _slide_by_rule(
    scene: Scene, trial: Trial, counted: Mapping[str, bool], allowed: Array, *, slides: bool
) -> tuple[Solution, Array, Method, int]:
    """Every operating point by the cheapest method whose error is allowed at the tried ones, or by the best one.

    allowed : (n,) relative to the whole torque
    Returns the points, the error relative to the torque by sliding, the method, and how many points it computed.
    Raises ConvergenceError for a point without a torque.
    """
    model, between = trial.model.counting(counted), 1.0 if trial.is_of_all else BETWEEN
    if not slides:
        found = solved(model, trial.points)
        require_settled(scene, model, trial.points, found)
        return found, np.zeros(len(trial.points)), "auto", len(trial.points)
    printed = scene.microslip == "as_printed"
    methods = [AS_PRINTED] if printed else [k for k, m in enumerate(METHODS) if scene.sliding in ("auto", m)]
    for method in methods[:-1]:
        tried = trial.solved(counted, method, judges=True)
        missed = error_of_sliding(tried) * part_by_sliding(tried)
        largest = np.nan_to_num(missed, nan=np.inf).max()
        if between * largest <= allowed.min():
            break
        if largest <= allowed.min():  # near the limit: the error of every point decides
            found = solved(model.with_numbers(method=method, judges=True), trial.points)
            error = error_of_sliding(found)
            if np.all(error * part_by_sliding(found) <= allowed.min()):
                return found, error, METHODS[method], len(trial.points)
    else:
        method = methods[-1]
        tried = trial.solved(counted, method, judges=True)
    found, error, model = tried, error_of_sliding(tried), model.with_numbers(method=method)
    sampled = None
    if not trial.is_of_all:
        alike = tried.balls.shape[1] == 1 and len(model.tables.factors) < 2
        if alike and method in (ALONG_AXIS, OVER_ELLIPSE, FINE):
            sampled = slide_by_sample(model, trial.points, allowed)
        found = solved(model.with_numbers(judges=False), trial.points) if sampled is None else sampled.found
        error = np.full(len(trial.points), between * error.max() if sampled is None else sampled.error)
    require_settled(scene, model, trial.points, found)
    computed = len(trial.points) if sampled is None else sampled.computed
    return found, error, "single_coefficient" if printed else METHODS[method], computed


def _finite_geometry(ledger: Ledger, scene: Scene, found: Solution, *, is_given: bool) -> tuple[tuple[str, ...], bool]:
    """What is said of contacts outside the fit for finite geometry, and whether there are any."""
    if is_given or not ledger.is_on("finite_geometry") or not found.points["beyond_fit"].any():
        return (), False
    warnings = corrections_of(scene.bearing, found.loaded_balls(scene.bearing)).warnings
    if not found.points["fit_applied"].any():
        ledger.not_applied("finite_geometry", f"not applied: {'; '.join(warnings)}")
    return warnings, True
