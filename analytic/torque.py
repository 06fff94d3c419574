"""Friction torque of a ball bearing, split by effect: equation 1 of [Paper], summed over the balls.

Every part is the power that one effect loses, over the speed of the ring. Torques are magnitudes about the bearing axis
and oppose the rotation: the other direction of rotation mirrors them.
"""

import os
import platform
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache, cached_property
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter
from types import MappingProxyType
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from analytic.any_scene import scene_by
from analytic.cage.drive import CageDrive, cage_drive
from analytic.cage.torque import CageMoves, CagePart, cage_friction, cage_moves
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES
from analytic.effects import (
    CHOSEN,
    DECLARED,
    ENTRIES,
    OIL_LOSSES,
    SWITCHED_OFF,
    Effect,
    Effects,
    counted_effects,
    idle_reason,
    require_known,
    turns_freely,
)
from analytic.errors import FembearingError, InputError, require_finite, require_non_negative, require_positive
from analytic.given import Quantity, SceneOptions
from analytic.left_out import Places
from analytic.limits import LimitNumbers, limit_numbers, limit_reasons, torque_warnings
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.ring_balance import require_enough_balls
from analytic.loads.ring_state import RingState, state_of_ring
from analytic.loads.thrust import require_given_angle
from analytic.numerics.elements import share_in
from analytic.numerics.records import Records
from analytic.oil.inlets import starvation_source
from analytic.oil.losses import estimated_loss, oil_parts, stirred_oil
from analytic.oil.variation import NOMINAL, Variation
from analytic.pair import pair_in_series, pair_torque
from analytic.result import FrictionCoefficients, FrictionTorque, LoadedContact, OnRaces, TorqueParts
from analytic.scene import Array, Bearing, Decision, Operation, OwnTraction, Scene, Sliding
from analytic.scenefile.fit import crowding
from analytic.solve.failures import failures_of, require_settled, undistributed
from analytic.solve.model import Model, model_of
from analytic.solve.solution import Solution, points_of, solved
from analytic.solve.steady_states import other_states
from analytic.surface.roughness import GapRoughness, gap_roughness
from analytic.units import METRIC, oil_words
from analytic.words import NEWTON, NEWTON_MILLIMETRE, speed_of, torque_of

# Rises whenever a formula changes a torque; CHANGELOG.md then has the old and the new torque of each shipped scene.
# `python validation/model_version.py` prints both.
MODEL_VERSION = 14
OF_RACES = ("spin", "conformity", "hysteresis", "rolling")
PARTS = (*OF_RACES, "cage", "oil", "declared")
TOLD = 0.1  # of the tolerance, a judgement: levels of nodes may agree by accident, so that no finer error is stated
MOST_UNEQUAL = 0.01  # of the thrust: radial load and moment, as they load balls, that a given angle may neglect
LOADING = ("load_distribution", "weight", "centrifugal", "gyroscopic", "finite_geometry")


@dataclass(frozen=True, kw_only=True, eq=False)
class Races:
    """Balls and races of a scene: which effects count, and the solution at the operating points."""

    scene: Scene  # its operating points as a series
    counted: Mapping[str, bool]  # `counted_effects`
    correction: ContactCorrection | None
    variation: Variation
    model: Model
    points: Array  # (n, 5)
    found: Solution

    @property
    def slides(self) -> bool:
        """Whether spin or conformity counts."""
        return self.counted["spin"] or self.counted["conformity"]

    @property
    def is_mixed(self) -> bool:
        """Whether film and asperities share the load of the contacts."""
        return self.slides and self.scene.friction_coefficient is None

    @property
    def sliding(self) -> Sliding:
        """How the balls turn and slide."""
        if not self.slides:
            return "none"
        if self.model.is_free:
            return "marched_creep" if self.counted["creep"] else "free_ball"
        return "as_printed" if self.scene.microslip == "as_printed" else "over_ellipse"

    @cached_property
    def parts(self) -> dict[str, Array]:
        """Each (n,), N m, of the effects that count."""
        return {name: self.found.points[name].copy() for name in OF_RACES if self.counted[name]}

    @cached_property
    def drive(self) -> CageDrive | None:
        """What drives the cage; None: there is none."""
        scene, speed = self.scene, self.points[:, 3]
        return None if scene.cage is None else cage_drive(scene, self.found.balls, self.coefficient, speed)

    @cached_property
    def moves(self) -> CageMoves:
        """Where the cage moves."""
        return cage_moves(self.scene, self.drive)

    @cached_property
    def cage(self) -> CagePart | None:
        """What the cage adds; None: it does not count."""
        drive = self.drive if self.counted["cage"] else None
        return None if drive is None else cage_friction(self.scene, drive, self.moves)

    @property
    def cage_torque(self) -> tuple[Array, Array | float]:
        """(n,) torque of a cage that counts, and half of its interval, N m."""
        torque, mu = self.found.points["cage"], self.coefficient
        assert self.scene.cage is not None
        # By the kernel at rest; it has none of a cage that is squeezed, and does not refuse races without friction.
        grips = mu is None or bool(np.all(mu if np.isscalar(mu) else np.max(mu, axis=0)))
        has_grip = self.scene.cage.gives_way or grips
        if self.model.numbers.counted.cage and has_grip and np.isfinite(torque).all():
            return torque.copy(), 0.0
        assert self.cage is not None
        return self.cage.torque, self.cage.half_interval

    @cached_property
    def heaviest(self) -> Records:
        """(n,) `records.BALL`: the ball that presses hardest on a race at each operating point."""
        balls = self.found.balls
        return balls[np.arange(len(balls)), balls["load"].max(axis=2).argmax(axis=1)]

    @cached_property
    def roughness(self) -> GapRoughness | None:
        """Of ball and race together; None: nothing slides, or its friction coefficient is given."""
        surface = self.scene.surface
        return gap_roughness(surface) if self.is_mixed and surface is not None else None

    @property
    def coefficient(self) -> Array | float | None:
        """(2, n, m) friction coefficient of each contact, or the given one; None: not known."""
        if not self.slides:
            return self.scene.friction_coefficient
        return np.moveaxis(self.found.balls["friction_coefficient"], -1, 0)

    @cached_property
    def ring(self) -> RingState:
        """Displacement and stiffness of the ring, and every ball."""
        scene, held_by = self.scene, self.found.points["holding_moment"].copy()
        return state_of_ring(scene.bearing, scene.contact_angle, self.found.balls, scene.operation, held_by)

    @property
    def measured_points(self) -> NDArray[np.intp]:
        """Up to three points at which shares of effects are measured: of least and most load, and the fastest."""
        return _telling_points(self.scene.bearing, self.points)

    def change_without(self, name: str, total: Array) -> float:
        """Largest change of the torque when an effect changes sides, over the torque, at `measured_points`.

        total : (n,) N m. NaN where no point converges with the other choice.
        """
        scene, at = self.scene, self.measured_points
        other = replace(scene, effects={**scene.effects, name: "off" if self.counted[name] else "auto"})
        model = _model(other, counted_effects(other), self.correction, self.variation)
        changed = np.abs(self._by_one_level(model) - self._measured)
        known = np.isfinite(changed)
        return float(share_in(changed[known], total[at][known]).max()) if known.any() else np.nan

    @cached_property
    def _measured(self) -> Array:
        return self._by_one_level(self.model)

    def _by_one_level(self, model: Model) -> Array:
        """(k,) race torque at `measured_points` by the finest nodes there, N m: their error is common to a change."""
        at = self.measured_points
        level = int(self.found.points["level"][at].max())
        return solved(model.at(at).with_numbers(level=level, allowed=np.inf), self.points[at]).race_torque


def _telling_points(bearing: Bearing, points: Array) -> NDArray[np.intp]:
    """Those of least and of most load, and the fastest; points : (n, 5) as `points_of`"""
    axial, radial, moment, speed = np.abs(points[:, :4]).T
    load = axial + radial + 2 * moment / bearing.pitch_diameter
    return np.array(sorted({int(load.argmin()), int(load.argmax()), int(speed.argmax())}))


def _model(
    scene: Scene, counted: Mapping[str, bool], correction: ContactCorrection | None, variation: Variation
) -> Model:
    at_rest = (
        counted["cage"] and scene.cage is not None and (scene.cage.start is None or scene.bearing.kind == "thrust")
    )
    races = {**counted, "cage": at_rest}
    return model_of(scene, races, free=turns_freely(scene, counted), correction=correction, variation=variation)


def races_of(scene: Scene, correction: ContactCorrection | None = None, variation: Variation = NOMINAL) -> Races:
    """Balls and races at the scene's operating points, those that do not settle included.

    correction, variation : as in `friction_torque`. Raises InputError as that does.
    """
    require_known(scene)
    operation, counted = scene.operation.as_series(), counted_effects(scene)
    if operation is not scene.operation:
        scene = replace(scene, operation=operation)
    if variation is NOMINAL:  # balls of a sample may overlap: it varies their size and the pitch diameter apart
        _require_room(scene.bearing)
    _require_loads(scene, operation)
    model = _model(scene, counted, correction, variation)
    points = points_of(operation, model.temperature)
    return Races(
        scene=scene,
        counted=counted,
        correction=correction,
        variation=variation,
        model=model,
        points=points,
        found=solved(model, points),
    )


def friction_torque(
    scene: Scene | str | os.PathLike[str],
    *,
    tolerance: float | str | Quantity | None = None,
    correction: ContactCorrection | None = None,
    variation: Variation = NOMINAL,
    **given: Unpack[SceneOptions],
) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    Parameters
    ----------
    scene : Scene, str or path
        Bearing, loads, speeds, and either oil with surfaces or a friction coefficient; or what `load_scene` reads, a
        file or a designation as "6308".
    tolerance : float or str, optional
        Of the torque, relative (dimensionless), or a text as "1 %"; None: the scene's.
    correction : ContactCorrection, optional
        Factors on Hertz's contacts, dimensionless, in place of those of the finite geometry; under the rule `solved`
        they change contact angle and ball loads too.
    variation : Variation
        Of the formulas of oil and surfaces, dimensionless factors, to show the effect of their uncertainty.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    FrictionTorque
        Torques by part, N m, loads, contacts, effects and warnings; arrays (n,), one element for each operating point.

    Raises
    ------
    InputError
        The scene gives neither or both of coefficient and surface, demands an effect that lacks its input, or loads the
        balls beyond a shoulder; with a name, as `load_scene`.
    ConvergenceError
        No operating point has settled.

    Notes
    -----
    The balls are loaded (`analytic.loads`), and each loses power to each race. Per unit speed and summed::

        race = spin + conformity + hysteresis (equations 9 to 12 of [Paper]) + hydrodynamic rolling, where there is oil
        total = race + cage (`analytic.cage`) + oil outside the contacts (`analytic.oil.losses`) + declared losses of
            seals and drag

    Sliding is by mixed lubrication where the scene has an oil and a surface. A friction coefficient takes the place of
    the surface: then sliding friction does not depend on speed, and at standstill it is that of the first motion.
    Rolling takes the oil at the inlet's temperature.
    With microslip "as_printed" the moments of [Paper] replace the derived ones, at the same spin and coefficients.
    Every effect is computed that has its input, can act, and is not switched off (`analytic.effects`). Balls turn as
    friction has it, or by the scene's spin rule. The numerical uncertainty is the solver's error: twice what doubling
    the nodes of sliding changes, of race and cage alike, the residual of the equilibrium, the interval of a moving
    cage, and a tenth of the tolerance. The tolerance decides on the number of nodes alone. A point that does not settle
    has no torque (NaN), and `failures` says why.
    A scene with an arrangement has two bearings: the parts are sums over both, and `pair` has each of them.
    Sources: [Paper], and those of the modules named here.
    """
    scene = scene_by(scene, given)
    if tolerance is not None:
        from analytic.scenefile.parts import with_tolerance  # only who asks for it pays

        scene = with_tolerance(scene, tolerance)
    _require_friction(scene)
    started = perf_counter()
    if scene.arrangement is not None:
        both = pair_in_series(scene, scene.arrangement, correction)
        each = friction_torque(both.scene, correction=correction, variation=variation).settled()
        result = pair_torque(scene, both, each)
        effects = _effects_of_pair(scene, result, correction, variation)
        result = replace(result, effects=effects, seconds=perf_counter() - started)
    else:
        result = _of_one_bearing(scene, correction, variation, started)
    return result.checked()


def _effects_of_pair(
    scene: Scene, pair: FrictionTorque, correction: ContactCorrection | None, variation: Variation
) -> Effects:
    """Parts over the torque of both bearings; what takes another solution is measured of the whole pair."""
    operation, of_bearings, total = scene.operation.as_series(), pair.effects, pair.torque.total
    at = _telling_points(scene.bearing, points_of(operation, 0.0))

    def made() -> dict[str, Effect]:
        found = {each.name: each for each in of_bearings.unmeasured}
        for name, part in vars(pair.torque).items():
            if part is not None and name in found and found[name].share_is == "part":
                found[name] = replace(found[name], share=_largest(share_in(part, total)))
        return found

    def measured(name: str) -> float:
        choice: Decision = "off" if of_bearings.decisions[name] == "on" else "auto"
        other = replace(scene, operation=operation.at(at), effects={**scene.effects, name: choice})
        try:
            race = friction_torque(other, correction=correction, variation=variation).torque.race
        except FembearingError:
            return np.nan
        return _largest(share_in(np.abs(race - pair.torque.race[at]), total[at]))

    return Effects(made, measured, tuple(at.tolist()))


def _of_one_bearing(
    scene: Scene, correction: ContactCorrection | None, variation: Variation, started: float
) -> FrictionTorque:
    """As `friction_torque`; started : a time by `perf_counter`, s"""
    races = races_of(scene, correction, variation)
    failures = failures_of(scene, races.model, races.points, races.found)
    if not failures:
        return _torque_of(races, started)
    places = Places(operation=races.scene.operation, failures=failures)
    if not places.computed:
        raise next(iter(failures.values()))
    kept = np.array(places.computed)
    rest = replace(
        races,
        scene=replace(scene, operation=places.operation.at(kept)),
        model=races.model.at(kept),
        points=races.points[kept],
        found=races.found.at(kept),
    )
    return _torque_of(rest, started).among(places)


def _torque_of(races: Races, started: float) -> FrictionTorque:
    """The torque where every operating point has settled."""
    scene, found, counted, operation = races.scene, races.found, races.counted, races.scene.operation
    speed, race, parts = operation.inner_speed, found.race_torque, dict(races.parts)
    has_cage, half = scene.cage is not None and counted["cage"], 0.0
    if has_cage:
        parts["cage"], half = races.cage_torque
    parts |= _losses(scene, speed, races.variation.oil_losses)
    total = sum((parts[name] for name in ("cage", "oil", "declared") if name in parts), start=race)
    unsure = found.points["sliding_error"]
    if has_cage:  # the balls that drive it slide on the same nodes
        unsure = unsure + share_in(unsure, race) * parts["cage"] + half
    unsure = share_in(unsure, total) + found.points["residual"] + (TOLD * scene.tolerance if races.slides else 0.0)
    heaviest = races.heaviest
    return FrictionTorque.with_later(
        later={
            "friction_coefficient": lambda: _coefficients(races),
            "cage": lambda: races.cage,
            "effects": lambda: _effects(races, parts, total),
            "limits": lambda: _limits(races),
            "ring": lambda: races.ring,
            "warnings": lambda: _warnings(races),
            "provenance": lambda: _provenance(races),
            "gap_roughness": lambda: None if races.roughness is None else races.roughness.rms_roughness,
        },
        inner_speed=speed,
        axial_load=operation.axial_load,
        radial_load=operation.radial_load,
        moment=operation.moment,
        contact_angle=np.abs(heaviest["angle"].mean(axis=1)),
        ball_load=heaviest["load"].max(axis=1),
        torque=TorqueParts(total=total, race=race, **{name: parts.get(name) for name in PARTS}),
        numerical_uncertainty=unsure,
        film=OnRaces(**_on_races(heaviest, "film", races.is_mixed)),
        asperity_share=OnRaces(**_on_races(heaviest, "asperity_share", races.is_mixed)),
        boundary_share=OnRaces(**_on_races(heaviest, "boundary_share", races.is_mixed)),
        inner=_loaded(heaviest, 0),
        outer=_loaded(heaviest, 1),
        sliding=races.sliding,
        clearances=scene.clearances,
        seconds=perf_counter() - started,
    )


def _coefficients(races: Races) -> FrictionCoefficients:
    of_races = _on_races(races.heaviest, "friction_coefficient", races.slides)
    return FrictionCoefficients(**of_races, pocket=None if races.cage is None else races.cage.friction_coefficient)


def _limits(races: Races) -> LimitNumbers:
    scene, found, counted, cage = races.scene, races.found, races.counted, races.cage
    return replace(
        limit_numbers(scene, found, counted),
        sliding_number=found.sliding_number if races.slides and counted["rolling"] else None,
        gyroscopic_hold=found.points["gyroscopic_hold"].copy() if races.slides and counted["gyroscopic"] else None,
        cage_grip=None if cage is None or (scene.cage and scene.cage.gives_way) else cage.used_grip,
        tilt=_tilt(races.ring),
    )


def _warnings(races: Races) -> tuple[str, ...]:
    numbers = limit_numbers(races.scene, races.found, races.counted)
    return (
        *torque_warnings(races.scene, races.found, races.counted, numbers=numbers, roughness=races.roughness),
        *_beyond_the_fit(races),
        *_two_states(races),
        *(() if races.cage is None else races.cage.warnings),
    )


def _losses(scene: Scene, speed: Array, factor: float) -> dict[str, Array]:
    """Parts that there are, (n,) N m: "oil" outside the contacts, "declared" of seals and drag.

    factor : on the losses of the oil. Raises InputError for a loss below 0, for an input of a loss of the oil that is
    off, and as `stirred_oil`.
    """
    losses = scene.losses
    given = {name: value for name in DECLARED if (value := getattr(losses, name)) is not None}
    require_non_negative(**{f"losses.{name}": value for name, value in given.items()})
    for name in OIL_LOSSES:
        if scene.effects.get(name) == "off" and ENTRIES[name].lacks(scene) is None:
            raise InputError(f'effects.{name} = "off" contradicts its input in [losses]: leave one of them out')
    stirred, found = stirred_oil(scene, losses), {}
    if stirred is not None:
        found["oil"] = sum(oil_parts(scene, stirred, speed, factor).values(), start=np.zeros_like(speed))
    if losses.total is not None:
        found["declared"] = np.full_like(speed, losses.total)
    return found


def _effects(races: Races, parts: Mapping[str, Array], total: Array) -> Effects:
    """Every effect with its decision; shares that take another solution are measured when somebody reads them."""

    def made() -> dict[str, Effect]:
        found = {name: _chosen_effect(races, name, parts, total) for name in CHOSEN} | _loss_effects(races, total)
        for name, reason in races.moves.reasons.items():
            if found[name].decision == "on":
                found[name] = replace(found[name], decision="on" if races.moves.on(name) else "off", reason=reason)
        for name, reason in limit_reasons(races.scene, races.found).items():
            found[name] = Effect(name=name, decision="off", share=None, reason=reason)
        return {name: found[name] for name in ENTRIES}

    at = tuple(races.measured_points.tolist())
    return Effects(made, lambda name: races.change_without(name, total), at)


def _chosen_effect(races: Races, name: str, parts: Mapping[str, Array], total: Array) -> Effect:
    """An effect that a scene may choose."""
    scene, is_on = races.scene, races.counted[name]
    if (lacks := ENTRIES[name].lacks(scene)) is not None:
        return _without_input(name, lacks, _rough_share(races, name))
    if scene.effects.get(name) == "off":
        share_is = "measured" if ENTRIES[name].kind == "computed" else "unknown"
        return Effect(name=name, decision="off", share=None, share_is=share_is, reason=SWITCHED_OFF)
    if (idle := idle_reason(scene, name, counted=is_on)) is not None:
        # Where the weights cancel to first order, about the square of their share is left.
        left = _largest(races.found.points["weight_share"]) ** 2 if name == "weight" else 0.0
        return Effect(name=name, decision="off", share=left, share_is="estimate", reason=idle)
    if name in parts:
        share = _largest(share_in(parts[name], total))
        return Effect(name=name, decision="on", share=share, share_is="part", reason=ENTRIES[name].given)
    if name == "finite_geometry":
        if races.correction is not None:
            reason = "factors on the contacts given in the call"
            return Effect(name=name, decision="on", share=None, reason=reason)
        points = races.found.points
        if points["beyond_fit"].any() and not points["fit_applied"].any():
            reason = f"not applied: {'; '.join(corrections_of(scene.bearing, races.found.balls).warnings)}"
            return Effect(name=name, decision="off", share=0.0, share_is="part", reason=reason)
    share_is = "measured" if ENTRIES[name].kind == "computed" else "unknown"
    return Effect(name=name, decision="on", share=None, share_is=share_is, reason=ENTRIES[name].given)


def _loss_effects(races: Races, total: Array) -> dict[str, Effect]:
    """Losses that the scene declares, and those of the oil outside the contacts."""
    scene, speed = races.scene, races.points[:, 3]
    stirred, losses = stirred_oil(scene, scene.losses), scene.losses
    given = {name: value for name in DECLARED if (value := getattr(losses, name)) is not None}
    given |= {} if stirred is None else oil_parts(scene, stirred, speed, races.variation.oil_losses)
    made = {}
    for name in (*DECLARED, *OIL_LOSSES):
        lacks, origin = ENTRIES[name].lacks(scene), losses.origins.get(name)
        if lacks is None:
            share = _largest(share_in(np.broadcast_to(given[name], total.shape), total))
            reason = ENTRIES[name].given if origin is None else f"{origin.status}: {origin.source}"
            made[name] = Effect(name=name, decision="on", share=share, share_is="part", reason=reason)
            continue
        usual = estimated_loss(scene, name, speed, total) if name in OIL_LOSSES else None
        reason = SWITCHED_OFF if scene.effects.get(name) == "off" else lacks
        made[name] = _without_input(name, f"{reason}{'' if usual is None else '; size from usual values'}", usual)
    return made


def _rough_share(races: Races, name: str) -> Array | None:
    """(n,) rough size of an effect that lacks its input, over the torque, by one line of physics; None: not known."""
    if name in ("centrifugal", "gyroscopic", "weight"):
        return races.found.points[f"{name}_share"]
    return _unequal(races.scene) if name == "load_distribution" else None


def _unequal(scene: Scene) -> Array:
    """(n,) (Fr tan(al) + 2 M/d_m)/Fa: how unequal radial load and moment make balls at a given contact angle."""
    operation = scene.operation.as_series()
    other = np.abs(operation.radial_load) * np.tan(scene.contact_angle.value or 0.0)
    other = other + 2 * np.abs(operation.moment) / scene.bearing.pitch_diameter
    axial = np.asarray(operation.axial_load)
    return np.divide(other, axial, out=np.where(other > 0, np.inf, 0.0), where=axial > 0)


def _without_input(name: str, reason: str, share: Array | None) -> Effect:
    if share is None or not np.isfinite(share).all():
        return Effect(name=name, decision="off", share=None, reason=reason)
    return Effect(name=name, decision="off", share=_largest(share), share_is="estimate", reason=reason)


def _largest(share: Array) -> float:
    return float(np.max(share, initial=0.0))


def _tilt(ring: RingState) -> Array | None:
    """(n,) of the ring against the outer one, rad; None where it is held straight or not known."""
    if ring.held_tilt == 0 or ring.displacement is None or ring.bearing.kind == "thrust":
        return None
    return np.hypot(*ring.displacement[:, 3:].T)


def _beyond_the_fit(races: Races) -> tuple[str, ...]:
    """What is said of contacts outside the fit for finite geometry."""
    corrects = races.correction is None and races.counted["finite_geometry"]
    if not corrects or not races.found.points["beyond_fit"].any():
        return ()
    return corrections_of(races.scene.bearing, races.found.balls).warnings


def _two_states(races: Races) -> Iterator[str]:
    """A warning for the operating point at which two steady states of the balls differ most."""
    if not races.model.is_free:
        return
    other, race = other_states(races.model, races.points, races.found), races.found.race_torque
    apart = np.nan_to_num(np.abs(share_in(other, race) - 1))
    worst = int(apart.argmax())
    if apart[worst] > races.scene.tolerance:
        computed, second = (torque_of(each[worst]) for each in (race, other))
        yield (
            f"free balls have two steady states at {speed_of(float(races.points[worst, 3]))}: the races resist "
            f"{computed} or {second}, by how the bearing came to this speed; the first is computed"
        )


def loaded_balls_of(scene: Scene) -> Records:
    """(n, m) `records.BALL` at every operating point, with every effect on loads that the scene does not rule out.

    They turn by closed kinematics. Raises InputError and ConvergenceError as `friction_torque` does.
    """
    off: dict[str, Decision] = {name: "off" for name in CHOSEN if name not in LOADING}
    # Loads are the same whatever resists sliding, which the scene may lack.
    bare = replace(scene, lubricant=None, surface=None, effects={**scene.effects, **off})
    races = races_of(bare)
    require_settled(bare, races.model, races.points, races.found)
    return races.found.balls


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
        if not np.all(operation.axial_load):
            raise InputError("a point has no load: give axial_load or radial_load in N, or a moment")
        require_positive(axial_load=operation.axial_load)
    elif bearing.kind == "thrust":
        _require_thrust(operation)
    elif abs(operation.held_tilt) > 0 and scene.contact_angle.rule == "given":
        raise InputError(
            f"operation.tilt = {operation.held_tilt:g} rad changes the contact angles, which the rule 'given' holds: "
            "use the rule 'solved', or leave the tilt out"
        )
    elif (lacks := ENTRIES["load_distribution"].lacks(scene)) is None:
        if scene.effects.get("load_distribution") != "off":
            require_enough_balls(bearing)
    elif (unequal := float(_unequal(scene).max())) > MOST_UNEQUAL:
        raise undistributed(unequal, lacks)


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


def _require_friction(scene: Scene) -> None:
    """Raise InputError unless there is exactly one source of the friction of ball on race."""
    if scene.friction_coefficient is not None:
        require_non_negative(**{"friction.coefficient": scene.friction_coefficient})
        if scene.surface is not None:
            raise InputError(
                f"friction.coefficient = {scene.friction_coefficient:g} and [surface] both determine the friction: "
                "leave out the coefficient (computed from [lubricant] and [surface]), or leave out [surface]"
            )
    elif scene.lubricant is None and scene.surface is None:
        raise InputError(
            "friction.coefficient is missing: add [friction] coefficient = 0.1 (usual are 0.05 to 0.12), or the tables "
            "[lubricant] and [surface]"
        )
    elif scene.lubricant is None or scene.surface is None:
        given, missing = ("surface", "lubricant") if scene.lubricant is None else ("lubricant", "surface")
        raise InputError(
            f"[{missing}] is missing: friction is computed from [lubricant] and [surface] together, and the scene has "
            f"[{given}] alone; add it, or give [friction] coefficient = 0.1"
        )


def _on_races(balls: Records, name: str, is_known: bool) -> dict[str, Array | None]:
    """A field of balls, (n,), on inner and outer race; None where it is not known."""
    return {race: balls[name][:, index].copy() if is_known else None for index, race in enumerate(RACES)}


def _loaded(balls: Records, race: int) -> LoadedContact:
    return LoadedContact(**{each.name: balls[each.name][:, race].copy() for each in fields(LoadedContact)})


def _provenance(races: Races) -> Mapping[str, str]:
    """How each step was computed, and the versions."""
    scene, cage = races.scene, races.cage
    contacts = "Hertz, corrected for finite geometry" if races.counted["finite_geometry"] else "Hertz"
    return MappingProxyType(
        {
            "scene": scene.name,
            "oil": oil_words(scene.lubricant, METRIC),
            "contact_angle": scene.contact_angle.rule,
            "spin_rule": scene.spin_rule,
            "microslip": scene.microslip,
            "loads": "thrust, all balls alike" if races.found.balls.shape[1] == 1 else "equilibrium of the ring",
            "contacts": contacts if races.correction is None else "Hertz with given factors",
            "friction": "given coefficient" if scene.surface is None else "mixed lubrication",
            "traction": _law_in_words(scene),
            "inlets": _inlet_words(races),
            "sliding": races.sliding if races.slides else "nothing slides",
            "kinematics": "free balls" if races.model.is_free else "closed",
            "cage": "left out" if cage is None else cage.provenance,
            "model_version": str(MODEL_VERSION),
            **_versions(),
        }
    )


def _inlet_words(races: Races) -> str:
    scene = races.scene
    if scene.lubricant is None:
        return "no lubricant"
    if not races.counted["starvation"]:
        return "flooded"
    degree = float(races.found.balls["starvation_degree"].min())
    if np.isinf(degree):
        return "flooded"
    return f"starved, {starvation_source(scene.bearing, scene.lubricant)}, m = {degree:.4g} at least"


def _law_in_words(scene: Scene) -> str:
    if scene.lubricant is None or scene.surface is None:
        return "given coefficient"
    law = scene.lubricant.traction
    return law.origin if isinstance(law, OwnTraction) else law


@cache
def _versions() -> dict[str, str]:
    """Of the packages that take part."""
    versions = {"python": platform.python_version()}
    for name in ("fembearing", "numpy", "scipy"):
        try:
            versions[name] = version(name)
        except PackageNotFoundError:
            versions[name] = "not installed"
    return versions
