"""Friction torque of a ball bearing, split by effect: equation 1 of [Paper], summed over the balls.

Every part is the power that one effect loses, over the speed of the ring. Torques are magnitudes about the bearing axis
and oppose the rotation: the other direction of rotation mirrors them.
"""

import os
import platform
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from itertools import product
from time import perf_counter
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import SQUEEZE_SPREAD, CageDrive, cage_drive
from analytic.cage.torque import CagePart, cage_friction, may_squeeze, squeezed_torque
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES
from analytic.effects.cage import decide_cage
from analytic.effects.declared import scene_losses
from analytic.effects.ledger import Ledger, share_in
from analytic.effects.limits import check_limits
from analytic.effects.table import ruled
from analytic.effects.trial import of_methods, slip_by_weight
from analytic.effects.warnings import torque_warnings
from analytic.effects.washers import held_in_the_middle
from analytic.errors import InputError, require_non_negative
from analytic.loads.ring_state import RingState, state_of_ring
from analytic.numerics.records import Records
from analytic.oil.inlets import starvation_source
from analytic.oil.variation import NOMINAL, Variation
from analytic.pair import pair_in_series, pair_torque
from analytic.races import WEDGED, RaceTorque, race_torque
from analytic.result import (
    FrictionCoefficients,
    FrictionTorque,
    LoadedContact,
    OnRaces,
    TorqueParts,
    require_numbers,
)
from analytic.scene import Array, Decision, OwnTraction, Scene
from analytic.solve.freely import BETWEEN
from analytic.solve.solution import Solution, tried_points
from analytic.units import Quantity
from analytic.words import percent_of, speed_of, torque_of

# Directions of the weight. Thrust is alike all round: only the tilt against the axis counts.
TILTS = np.array([(np.sin(tilt), 0.0, np.cos(tilt)) for tilt in np.linspace(0, np.pi, 25)])
ALL_ROUND = np.array([each for each in product((1.0, 0.0, -1.0), repeat=3) if any(each)])
ALONG_AXES = ALL_ROUND[np.abs(ALL_ROUND).sum(axis=1) == 1]
ALL_ROUND /= np.linalg.norm(ALL_ROUND, axis=1, keepdims=True)
MOST_FREE = 32  # points of a series whose free balls are computed in every direction, all of them
LEAD_SPREAD = 1.05  # of how far balls lead, by what `auto` leaves out: 4 % at most in 46 scenes of the adversary's
# Of the lead by weights in 26 directions: between them it is larger, and free balls led up to 1.73 times as far.
LEAD_BY_WEIGHT = 2.0
# Error of a lead over its difference by two quadratures: with the second of them, from the first one, it was up to 1.9.
OF_QUADRATURES = 2.0
LEAD_TRIED = 0.2  # of the free clearance of the pockets, from which on a lead is computed by other quadratures
MOST_GROWTH = 2.0  # of changes of balls by rule where friction wedges free ones: beyond, directions are close together
ASIDE = np.array([0.036, -0.048, 0.08])  # rad: turns these directions by 0.03 to 0.1, out of their symmetry
NO_SOLUTION = (
    "the direction of the balls' weight is not given, and some directions have no solution; give operation.down"
)
# Rises whenever a formula changes a torque; CHANGELOG.md then has the old and the new torque of each shipped scene.
# `python validation/model_version.py` prints both.
MODEL_VERSION = 13
SQUEEZED_BY_WEIGHT = (
    "the direction of the balls' weight is not given, and decides how balls squeeze the cage; give operation.down"
)
NO_EDGE = "balls at the edge of their load did not converge with every force on them"
NO_CAGE: Mapping[str, Decision] = dict.fromkeys(("cage", "cage_dynamics", "ball_dynamics"), "off")
LOSSES = ("oil", "declared")
PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage", *LOSSES)


class Unsure(NamedTuple):
    """A part of the numerical uncertainty."""

    share: Array  # (n,) of the total, relative; infinite where it is not known
    unknown: tuple[str, ...]  # why not


class InAnyDirection(NamedTuple):
    """What the balls' weight may change, whose direction the scene does not give."""

    share: Array  # (n,) of the race torque in the total, relative; infinite where it is not known
    cage_rate: Array  # (n,) of the balls' rate at the cage, relative
    ball_lead: Array  # (n,) largest one, m; 0 where the weight does not count


def friction_torque(
    scene: Scene | str | os.PathLike[str],
    *,
    tolerance: float | str | Quantity | None = None,
    correction: ContactCorrection | None = None,
    variation: Variation = NOMINAL,
    **given: Any,
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
        An equilibrium that did not settle.

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
    The scene's tolerance decides which effects are computed, and how (`analytic.effects.trial`,
    `analytic.sliding.judge`); the result lists them all, with the numerical uncertainty that remains.
    A scene with an arrangement has two bearings: the parts are sums over both, and `pair` has each of them.
    Sources: [Paper], and those of the modules named here.
    """
    started = perf_counter()
    if not isinstance(scene, Scene):
        from analytic.scenefile.read import load_scene  # with pydantic: only who asks for it pays

        scene = load_scene(scene, **given)
    elif given:
        raise InputError(f"{min(given)} goes with a designation as 6308; change a Scene by dataclasses.replace")
    if tolerance is not None:
        from analytic.scenefile.by_name import with_tolerance  # with pydantic and pint: only who asks for it pays

        scene = with_tolerance(scene, tolerance)
    _require_friction(scene)
    if scene.arrangement is not None:
        both = pair_in_series(scene, scene.arrangement, correction)
        result = pair_torque(scene, both, friction_torque(both.scene, correction=correction, variation=variation))
        return require_numbers(replace(result, seconds=perf_counter() - started))
    result = _of_one_bearing(scene, correction, variation)
    return require_numbers(replace(result, seconds=perf_counter() - started))


def _of_one_bearing(scene: Scene, correction: ContactCorrection | None, variation: Variation) -> FrictionTorque:
    """As `friction_torque`, but for the seconds."""
    operation = scene.operation.as_series()
    speed = operation.inner_speed
    ledger = Ledger(scene, speed.size)
    races = race_torque(ledger, operation, correction=correction, variation=variation)
    parts, race, heaviest = dict(races.parts), races.total, races.heaviest
    coefficient = races.coefficient if races.slides else scene.friction_coefficient
    drive = None if scene.cage is None else cage_drive(scene, races.balls, coefficient, speed)
    frees = decide_cage(scene, drive, ledger, race=race)
    moves = ledger.is_on("cage_dynamics")
    cage = cage_friction(scene, drive, moves=moves, frees=frees) if drive is not None and ledger.is_on("cage") else None
    computed = race if cage is None else race + cage.torque
    parts |= scene_losses(ledger, computed, speed, variation.oil_losses)
    total = sum((parts[name] for name in LOSSES if name in parts), start=computed)
    parts |= {} if cage is None else {"cage": cage.torque}
    limits = check_limits(scene, races.found, ledger)
    weight = _in_any_direction(races, total)
    unsure = _unsure(ledger, races, total, weight)
    cage_unsure, cage_unknown, cage_warnings = _unsure_of_cage(cage, drive, races, weight)
    held_by = races.found.points["holding_moment"]
    ring = state_of_ring(scene.bearing, scene.contact_angle, races.found.balls, operation, held_by.copy())
    return FrictionTorque(
        inner_speed=speed,
        axial_load=operation.axial_load,
        radial_load=np.asarray(operation.radial_load),
        moment=np.asarray(operation.moment),
        contact_angle=np.abs(heaviest["angle"].mean(axis=1)),
        ball_load=heaviest["load"].max(axis=1),
        torque=TorqueParts(total=total, race=race, **{name: parts.get(name) for name in PARTS}),
        numerical_uncertainty=unsure.share + limits.uncertainty + share_in(cage_unsure, total),
        friction_coefficient=FrictionCoefficients(
            **_on_races(heaviest, "friction_coefficient", races.slides),
            pocket=None if cage is None else cage.friction_coefficient,
        ),
        cage=cage,
        film=OnRaces(**_on_races(heaviest, "film", races.is_mixed)),
        asperity_share=OnRaces(**_on_races(heaviest, "asperity_share", races.is_mixed)),
        boundary_share=OnRaces(**_on_races(heaviest, "boundary_share", races.is_mixed)),
        limits=replace(
            limits.numbers,
            sliding_number=races.sliding_number,
            gyroscopic_hold=races.gyroscopic_hold,
            cage_grip=None if cage is None or (scene.cage and scene.cage.gives_way) else cage.used_grip,
            tilt=_tilt(ring),
        ),
        inner=_loaded(heaviest, 0),
        outer=_loaded(heaviest, 1),
        ring=ring,
        effects=ledger.effects(parts, total, races.trial.measure(races.counted)),
        sliding=races.method,
        clearances=scene.clearances,
        gap_roughness=None if races.gap_roughness is None else races.gap_roughness.rms_roughness,
        warnings=(
            *torque_warnings(ledger, races.found, roughness=races.gap_roughness, limits=limits.warnings),
            *(*races.warnings, *_two_states(races), *_nearly_turned(races), *cage_warnings),
        ),
        unknown=limits.unknown + unsure.unknown + cage_unknown,
        provenance=_provenance(ledger, races, correction=correction, cage=cage),
        seconds=0.0,
    )


def _tilt(ring: RingState) -> Array | None:
    """(n,) of the ring against the outer one, rad; None where it is held straight or not known."""
    if ring.held_tilt == 0 or ring.displacement is None or ring.bearing.kind == "thrust":
        return None
    return np.hypot(*ring.displacement[:, 3:].T)


def _unsure(ledger: Ledger, races: RaceTorque, total: Array, weight: InAnyDirection) -> Unsure:
    """What is left out, the method of sliding, contacts outside the fit, the direction of the weight, held balls."""
    beyond = _beyond_the_fit(races, total)
    held = held_in_the_middle(races.scene, races.found, parts=races.parts, total=total)
    share = _uncertainty(ledger, races, total=total) + beyond.share + weight.share + held
    if races.is_wedged:
        return Unsure(np.full_like(share, np.inf), (WEDGED,))
    edge = share_in(races.change_at_edge(), total)  # which the far points of a trial do not show
    apart = np.nan_to_num(np.abs(races.other - races.total))
    apart = apart if races.trial.is_of_all else np.full_like(apart, apart.max())
    share = (share + edge) * (1 + races.brink) + share_in(apart, total)
    off = () if np.isfinite(edge).all() else (NO_EDGE,)
    off += () if np.isfinite(weight.share).all() else (NO_SOLUTION,)
    return Unsure(share, _unknown_sliding(races) + beyond.unknown + off)


def _unsure_of_cage(
    cage: CagePart | None, drive: CageDrive | None, races: RaceTorque, weight: InAnyDirection
) -> tuple[Array, tuple[str, ...], tuple[str, ...]]:
    """(n,) half width of the cage's torque, N m: its motion, balls by rule, unknown weights and how far balls lead.

    Infinite where it is not known, with the reasons why not, and the warnings of the cage. A weight in an unknown
    direction decides on lead and load of the balls that squeeze a cage.
    """
    if cage is None or drive is None:
        return np.zeros_like(races.total), (), ()
    known = races.is_free or ruled(races.scene) is not None
    by_axis = 0.0 if known else drive.spread_by_axis * cage.torque
    unsure = cage.half_interval + cage.unsure + by_axis + weight.cage_rate * cage.torque
    farthest = _farthest_lead(races, drive, weight)
    if np.any(farthest >= drive.room):
        more = squeezed_torque(races.scene, drive.leading(farthest)) - squeezed_torque(races.scene, drive)
        unsure = unsure + (1 + SQUEEZE_SPREAD) * np.maximum(more, 0.0)
    open_ = races.any_direction & (farthest >= drive.room)
    unknown = cage.unknown + ((SQUEEZED_BY_WEIGHT,) if open_.any() else ())
    return np.where(open_, np.inf, unsure), unknown, cage.warnings + may_squeeze(drive, farthest)


def _farthest_lead(races: RaceTorque, drive: CageDrive, weight: InAnyDirection) -> Array:
    """(n,) how far the balls may lead, m: a thousandth of their orbital speed decides whether they squeeze a cage."""
    by_weight, at = weight.ball_lead.copy(), np.flatnonzero(weight.ball_lead > LEAD_TRIED / 2 * drive.room)
    for x, y, z in ALL_ROUND.tolist() if at.size else ():  # along the axes weights make loads less unequal than between
        found = races.with_weight(at, (x, y, z))
        by_weight[at] = np.fmax(by_weight[at], np.abs(found.points["ball_lead"]))
    lead = np.maximum(np.abs(drive.grip.ball_lead), LEAD_BY_WEIGHT * by_weight)
    farthest = LEAD_SPREAD * lead
    at = np.flatnonzero(lead > LEAD_TRIED * drive.room)
    if at.size and races.slides and ruled(races.scene) is None:
        tried = at if races.trial.is_of_all else np.intersect1d(at, races.trial.tried)
        spread = races.lead_spread(tried) if tried.size else np.zeros(0)
        farthest[at] += OF_QUADRATURES * (spread if tried.size == at.size else spread.max(initial=0.0))
    return farthest


def _beyond_the_fit(races: RaceTorque, total: Array) -> Unsure:
    """What contacts outside the fit for finite geometry may change: the torque at their far end."""
    if not races.beyond_fit:
        return Unsure(np.zeros_like(total), ())
    every = np.arange(total.size)
    change = np.abs(races.by_rule(every, farthest=True).race_torque - races.by_rule(every).race_torque)
    if np.isfinite(change).all():
        return Unsure(share_in(change, total), ())
    reason = "contacts outside the fit for finite geometry may have no solution"
    return Unsure(np.where(np.isfinite(change), share_in(np.nan_to_num(change), total), np.inf), (reason,))


def _in_any_direction(races: RaceTorque, total: Array) -> InAnyDirection:
    """The largest change by the balls' weight over several directions.

    Free balls show it themselves: where they are preloaded and hardly spin, those by rule change by a sixtieth of it.
    Balls by rule that stand for free ones have factors for these, and for the slip under their weight.
    """
    unsure, rates, leads = np.zeros((3, total.size))
    at = np.flatnonzero(races.any_direction)
    if not at.size:
        return InAnyDirection(unsure, rates, leads)
    without = races.with_weight(at, None)
    changes = np.zeros(at.size)
    for x, y, z in ALONG_AXES.tolist():
        found = races.with_weight(at, (x, y, z))
        # The parts may cancel by one method of sliding, not by another.
        change = np.abs(found.race_parts - without.race_parts).sum(axis=0) + found.points["coming_off"]
        changes = np.maximum(changes, change)
        rate, first = _rate_at_cage(races, found), _rate_at_cage(races, without)
        turns = np.abs(np.divide(rate, first, out=np.ones_like(first), where=first > 0) - 1)
        rates[at] = np.fmax(rates[at], turns)
        leads[at] = np.fmax(leads[at], np.abs(found.points["ball_lead"]))
    share = np.where(np.isfinite(changes), share_in(np.nan_to_num(changes), np.nan_to_num(without.race_torque)), np.inf)
    if races.is_free:
        unsure[at], rates[at], leads[at] = _change_of_free_balls(races, at, share, leads[at])
    else:
        unsure[at], rates = of_methods(races.scene) * share, of_methods(races.scene) * rates
        if races.slides and ruled(races.scene) is None:
            unsure[at] += slip_by_weight(races.scene.bearing, races.found)[at]
    known = np.isfinite(unsure)
    unsure = np.where(known, np.where(known, unsure, 0.0) * share_in(races.total, total), np.inf)
    return InAnyDirection(unsure, rates, leads)


def _change_of_free_balls(
    races: RaceTorque, at: NDArray[np.intp], by_rule: Array, lead_by_rule: Array
) -> tuple[Array, Array, Array]:
    """(k,) change of the torque by the weight of free balls, over the smaller one, of their rate at the cage, and lead.

    That of the torque is infinite where a direction has none.
    by_rule, lead_by_rule : (k,) those of balls by rule; in a long series far points tell how much more free balls have
    What lies between two directions is at most their difference beyond the farthest. A ball may come off in a narrow
    range of directions, and its rolling then changes suddenly: each ball with little load counts as if it came off.
    """
    close = races.growth > MOST_GROWTH or not np.isfinite(by_rule).all()
    every = not close and at.size <= MOST_FREE
    far = np.arange(at.size) if every else tried_points(races.trial.points[at], float(races.trial.model.numbers.arm))
    # Each with an angle, rad, a little more than neighbours are apart.
    if races.scene.operation.is_thrust:
        directions, apart = (TILTS, 0.14) if close else (TILTS[::6], 0.8)
    else:
        directions, apart = (ALL_ROUND, 0.96) if close else (ALONG_AXES, 1.6)
    without, first_rate = _turning(races, races.freely_with_weight(at[far], None))[:2]
    change, off, turns, leads = np.zeros((4, len(directions), far.size))
    known = without > 0
    for number, down in enumerate(directions):
        if not (left := np.flatnonzero(known)).size:
            break
        torque, rate, more, lead = _with_weight_along(races, at[far[left]], down)
        known[left] = settles = torque > 0
        change[number, left[settles]] = np.log(torque[settles] / without[left[settles]])
        turns[number, left[settles]] = np.log(rate[settles] / first_rate[left[settles]])
        off[number, left[settles]] = np.log1p(more[settles] / torque[settles])
        leads[number, left[settles]] = lead[settles]
    first, second = np.nonzero(np.triu(directions @ directions.T > np.cos(apart), 1))

    def largest(each: Array, beyond: Array) -> Array:
        return np.expm1((np.abs(each) + beyond).max(axis=0) + np.abs(each[first] - each[second]).max(axis=0))

    share, rates = np.where(known, largest(change, off), np.inf), largest(turns, np.zeros_like(off))
    if far.size == at.size:
        return share, rates, leads.max(axis=0)
    farthest, rule = leads.max(axis=0), lead_by_rule[far]
    longer = BETWEEN * np.divide(farthest, rule, out=np.zeros_like(rule), where=rule > 0).max() * lead_by_rule
    longer[far] = farthest
    both, everywhere = np.isfinite(by_rule[far]) & (by_rule[far] > 0), np.full_like(by_rule, np.inf)
    more = np.divide(share, by_rule[far], out=np.full_like(share, np.inf), where=both).max()
    if np.isfinite(more):
        everywhere = BETWEEN * more * by_rule
        everywhere[far] = share
    return everywhere, np.full_like(by_rule, BETWEEN * rates.max()), longer


def _with_weight_along(races: RaceTorque, at: NDArray[np.intp], down: Array) -> Array:
    """(4, k) `_turning` of free balls with the weight in a direction.

    The direction is a little aside where the balls do not settle; NaN where they do not settle there either.
    Some directions do not settle among others that do: 1 to 8 of 60 in 6 of 18 scenes (validation/adversary/README.md).
    """

    def along(each: NDArray[np.intp], towards: Array) -> Array:
        x, y, z = map(float, towards)
        return _turning(races, races.freely_with_weight(each, (x, y, z)))

    found = along(at, down)
    if (open_ := np.isnan(found[0])).any():
        turned = down + np.cross(ASIDE, down)
        found[:, open_] = along(at[open_], turned / np.linalg.norm(turned))
    return found


def _turning(races: RaceTorque, found: Solution) -> Array:
    """(4, n) race torque, N m, rate of the balls at the cage, change by balls that may come off, N m, and lead, m."""
    points = found.points
    return np.array([found.race_torque, _rate_at_cage(races, found), points["coming_off"], np.abs(points["ball_lead"])])


def _rate_at_cage(races: RaceTorque, found: Solution) -> Array:
    """(n,) rate of the balls over that of the ring, which the torque of a resting cage is in proportion to.

    A cage whose axis is upright rests on flanks of its pockets, where the sine of the contact angle counts too.
    """
    cage, rate = races.scene.cage, found.points["ball_rate"]
    is_upright = cage is not None and cage.gravity == "along"
    return rate * np.sin(found.points["contact_angle"]) if is_upright else rate


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


def _uncertainty(ledger: Ledger, races: RaceTorque, *, total: Array) -> Array:
    """(n,) of the total: estimates of what auto left out of the race torque, and of the sliding method's error."""
    unknown = np.isinf(races.error)
    error = share_in(np.where(unknown, 0.0, races.error) * races.found.sliding_torque, total)
    return ledger.left_out * share_in(races.total, total) + np.where(unknown, np.inf, error)


def _two_states(races: RaceTorque) -> tuple[str, ...]:
    """A warning for the operating point at which two steady states of the balls differ most."""
    apart = np.nan_to_num(np.abs(races.other / races.total - 1))
    worst = int(apart.argmax())
    if not apart[worst]:
        return ()
    computed, other = (torque_of(each[worst]) for each in (races.total, races.other))
    speed = speed_of(float(races.trial.points[worst, 3]))
    return (
        f"free balls have two steady states at {speed}: the races resist {computed} or {other}, by how the bearing "
        "came to this speed; the first is computed, and the uncertainty covers both",
    )


def _nearly_turned(races: RaceTorque) -> tuple[str, ...]:
    """A warning for the operating point whose balls are nearest to turning across their grooves."""
    worst = int(races.brink.argmax())
    if not races.brink[worst]:
        return ()
    used = races.found.points["gyroscopic_hold"][worst]
    return (
        f"the gyroscopic moment takes {percent_of(used, 3)} of the friction that holds the balls at "
        f"{speed_of(float(races.trial.points[worst, 3]))}: small changes decide how far they slip, and the uncertainty "
        "is wide; raise the load or lower the speed",
    )


def _unknown_sliding(races: RaceTorque) -> tuple[str, ...]:
    if not np.any(np.isinf(races.error)):
        return ()
    return (f"no estimate of the error of sliding by the method {races.method} is known",)


def _inlet_words(ledger: Ledger, races: RaceTorque) -> str:
    scene = ledger.scene
    if scene.lubricant is None:
        return "no lubricant"
    if not ledger.is_on("starvation"):
        return "flooded"
    degree = float(races.found.balls["starvation_degree"].min())
    return f"starved, {starvation_source(scene.bearing, scene.lubricant)}, m = {degree:.4g} at least"


def _sliding_words(races: RaceTorque) -> str:
    if not races.slides:
        return "nothing slides"
    count = len(races.found.points)
    return races.method if races.computed == count else f"{races.method} at {races.computed} of {count} points"


def _on_races(balls: Records, name: str, is_known: bool) -> dict[str, Array | None]:
    """A field of balls, (n,), on inner and outer race; None where it is not known."""
    return {race: balls[name][:, index].copy() if is_known else None for index, race in enumerate(RACES)}


def _loaded(balls: Records, race: int) -> LoadedContact[Array]:
    names = ("load", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
    return LoadedContact(**{name: balls[name][:, race].copy() for name in names})


def _provenance(
    ledger: Ledger, races: RaceTorque, *, correction: ContactCorrection | None, cage: CagePart | None
) -> Mapping[str, str]:
    """How each step was computed, and the versions."""
    scene = ledger.scene
    contacts = "Hertz, corrected for finite geometry" if ledger.is_on("finite_geometry") else "Hertz"
    return MappingProxyType(
        {
            "scene": scene.name,
            "contact_angle": scene.contact_angle.rule,
            "spin_rule": scene.spin_rule,
            "microslip": scene.microslip,
            "loads": "thrust, all balls alike" if races.are_alike else "equilibrium of the ring",
            "contacts": contacts if correction is None else "Hertz with given factors",
            "friction": "given coefficient" if scene.surface is None else "mixed lubrication",
            "traction": _law_in_words(scene),
            "inlets": _inlet_words(ledger, races),
            "sliding": _sliding_words(races),
            "cage": "left out" if cage is None else cage.provenance,
            "model_version": str(MODEL_VERSION),
            **_versions(),
        }
    )


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
