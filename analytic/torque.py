"""Friction torque of a ball bearing, split by effect: equation 1 of [Paper], summed over the balls.

Every part is the power that one effect loses, over the speed of the ring. Torques are magnitudes about the bearing axis
and oppose the rotation: the other direction of rotation mirrors them.
"""

import platform
from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import cage_drive
from analytic.cage.torque import CagePart, cage_friction
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES
from analytic.effects.cage import decide_cage
from analytic.effects.declared import declared_losses
from analytic.effects.ledger import Ledger, share_in
from analytic.effects.limits import check_limits
from analytic.effects.warnings import torque_warnings
from analytic.effects.washers import held_in_the_middle
from analytic.errors import FembearingError, InputError, require_non_negative
from analytic.loads.balls import LoadedBalls
from analytic.loads.ring_state import state_of_ring
from analytic.oil.inlets import Inlets, starvation_source
from analytic.oil.variation import NOMINAL, Variation
from analytic.pair import pair_in_series, pair_torque
from analytic.races import BY_SLIP, RaceTorque, race_torque
from analytic.result import (
    FrictionCoefficients,
    FrictionTorque,
    LoadedContact,
    OnRaces,
    TorqueParts,
    require_numbers,
)
from analytic.scene import Array, Decision, Scene
from analytic.sliding.methods import Sliding
from analytic.units import Quantity

# Times the largest change over six directions: others change more, and so do other methods, up to 1.25 in 110 drawn
# scenes (validation/adversary.py).
BETWEEN = 1.5
DIRECTIONS = ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -1.0))
# Rises whenever a formula changes a torque; CHANGELOG.md then has the old and the new torque of each shipped scene.
# `python validation/model_version.py` prints both.
MODEL_VERSION = 2
NO_CAGE: Mapping[str, Decision] = dict.fromkeys(("cage", "cage_dynamics", "ball_dynamics"), "off")
PARTS = (*BY_SLIP, "hysteresis", "rolling", "cage")


def friction_torque(
    scene: Scene,
    *,
    tolerance: float | str | Quantity | None = None,
    correction: ContactCorrection | None = None,
    variation: Variation = NOMINAL,
) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    Parameters
    ----------
    scene : Scene
        Bearing, loads, speeds, and either oil with surfaces or a friction coefficient.
    tolerance : float or str, optional
        Of the torque, relative (dimensionless), or a text as "1 %"; None: the scene's.
    correction : ContactCorrection, optional
        Factors on Hertz's contacts, dimensionless, in place of those of the finite geometry; under the rule `solved`
        they change contact angle and ball loads too.
    variation : Variation
        Of the formulas of oil and surfaces, dimensionless factors, to show the effect of their uncertainty.

    Returns
    -------
    FrictionTorque
        Torques by part, N m, loads, contacts, effects and warnings; arrays (n,), one element for each operating point.

    Raises
    ------
    InputError
        The scene gives neither or both of coefficient and surface, demands an effect that lacks its input, or loads the
        balls beyond a shoulder.
    ConvergenceError
        An equilibrium that did not settle.

    Notes
    -----
    The balls are loaded (`analytic.loads`), and each loses power to each race. Per unit speed and summed::

        race = spin + conformity + hysteresis (equations 9 to 12 of [Paper]) + hydrodynamic rolling, where there is oil
        total = race + cage (`analytic.cage`) + declared losses of seals and drag

    Sliding is by mixed lubrication where the scene has an oil and a surface. A friction coefficient takes the place of
    the surface: then sliding friction does not depend on speed, and at standstill it is that of the first motion.
    Rolling takes the oil at the inlet's temperature.
    With microslip "as_printed" the moments of [Paper] replace the derived ones, at the same spin and coefficients.
    The scene's tolerance decides which effects are computed, and how (`analytic.effects`, `analytic.sliding.methods`);
    the result lists them all, with the numerical uncertainty that remains.
    A scene with an arrangement has two bearings: the parts are sums over both, and `pair` has each of them.
    Sources: [Paper], and those of the modules named here.
    """
    started = perf_counter()
    if tolerance is not None:
        from analytic.scenefile.by_name import with_tolerance  # with pydantic and pint: only who asks for it pays

        scene = with_tolerance(scene, tolerance)
    _require_friction(scene)
    if scene.arrangement is not None:
        both = pair_in_series(scene, scene.arrangement, correction)
        result = pair_torque(scene, both, friction_torque(both.scene, correction=correction, variation=variation))
        return require_numbers(replace(result, seconds=perf_counter() - started))
    operation = scene.operation.as_series()
    speed = operation.inner_speed
    ledger = Ledger(scene, speed.size)
    races = race_torque(ledger, operation, correction=correction, variation=variation)
    balls, sliding, mixed, parts = races.balls, races.sliding, races.mixed, dict(races.parts)
    load_warnings = list(races.chosen.warnings)
    race = races.total
    coefficient = scene.friction_coefficient if sliding is None else sliding.coefficient
    drive = None if scene.cage is None else cage_drive(scene, balls, coefficient, speed)
    frees = decide_cage(scene, drive, ledger, race=race)
    cage: CagePart | None = None
    if drive is not None and ledger.is_on("cage"):
        cage = cage_friction(scene, drive, moves=ledger.is_on("cage_dynamics"), frees=frees)
    computed = race if cage is None else race + cage.torque
    declared = declared_losses(ledger, computed)
    total = computed if declared is None else computed + declared
    if cage is not None:
        parts["cage"] = cage.torque
        load_warnings = load_warnings + list(cage.warnings)
    limits = check_limits(scene, operation, balls, ledger)
    uncertainty = _uncertainty(ledger, races, total=total) + limits.uncertainty
    uncertainty = uncertainty + held_in_the_middle(scene, operation, balls, parts=races.parts, total=total)
    at, oiled = balls.heaviest, races.resisting.oiled
    result = FrictionTorque(
        inner_speed=speed,
        axial_load=operation.axial_load,
        radial_load=np.asarray(operation.radial_load),
        moment=np.asarray(operation.moment),
        contact_angle=balls.contact_angle.mean(axis=0)[at],
        ball_load=balls.load.max(axis=0)[at],
        torque=TorqueParts(total=total, race=race, declared=declared, **{name: parts.get(name) for name in PARTS}),
        numerical_uncertainty=uncertainty
        if cage is None
        else uncertainty + share_in(cage.half_interval + cage.unsure, total),
        friction_coefficient=FrictionCoefficients(
            **_on_races(None if sliding is None else sliding.coefficient, at),
            pocket=None if cage is None else cage.friction_coefficient,
        ),
        cage=cage,
        film=OnRaces(**_on_races(None if mixed is None else mixed.film_thickness, at)),
        asperity_share=OnRaces(**_on_races(None if mixed is None else mixed.asperity_share, at)),
        boundary_share=OnRaces(**_on_races(None if mixed is None else mixed.boundary_share, at)),
        limits=replace(
            limits.numbers,
            sliding_number=races.sliding_number,
            gyroscopic_hold=races.gyroscopic_hold,
            cage_grip=None if cage is None else cage.used_grip,
        ),
        inner=_loaded(balls, 0, at),
        outer=_loaded(balls, 1, at),
        ring=state_of_ring(scene.bearing, scene.contact_angle, balls, operation),
        effects=ledger.effects(parts, total),
        sliding="auto" if sliding is None else sliding.method,
        clearances=scene.clearances,
        gap_roughness=None if oiled is None else oiled.roughness.rms_roughness,
        warnings=tuple(
            torque_warnings(
                ledger,
                load=balls.load,
                limits=limits.warnings,
                oiled=oiled,
                mixed=mixed,
                resistance=races.resistance,
            )
            + load_warnings
        ),
        unknown=limits.unknown + _unknown_sliding(sliding) + (() if cage is None else cage.unknown),
        provenance=_provenance(ledger, races, correction=correction, cage=cage),
        seconds=perf_counter() - started,
    )
    if races.chosen.farthest is not None:
        result = _beyond_the_fit(scene, result, races.chosen.farthest, variation)
    at = np.flatnonzero(races.chosen.any_direction)
    if at.size:
        result = _in_any_direction(scene, result, at, correction, variation)
    return require_numbers(replace(result, seconds=perf_counter() - started))


def _in_any_direction(
    scene: Scene,
    result: FrictionTorque,
    at: NDArray[np.intp],
    correction: ContactCorrection | None,
    variation: Variation,
) -> FrictionTorque:
    """The torque with the uncertainty of the balls' weight, whose direction the scene does not give.

    at : operating points at which the weight counts
    It is the largest change of the race torque over six directions, by the cheapest method.
    """
    effects = {**result.settled(scene).effects, **NO_CAGE, "creep": "off"}
    operation, own = scene.operation.as_series(), correction
    some = replace(operation, **{name: values[at] for name, values in vars(operation).items()})
    if own is not None:
        own = own.mapped(lambda factors: factors[at])

    def torque(down: tuple[float, float, float] | None) -> Array:
        weight = {"load_distribution": "on", "weight": "off" if down is None else "on"}
        settled = replace(scene, operation=some, sliding="single_coefficient", down=down, effects=effects | weight)
        return friction_torque(settled, correction=own, variation=variation).torque.race

    try:
        without = torque(None)
        changes = [np.abs(torque(down) - without) for down in DIRECTIONS]
    except FembearingError as problem:
        why = str(problem).removesuffix(".")
        reason = f"the balls' weight counts, its direction is not given, and with one there may be no answer: {why}"
        uncertainty = result.numerical_uncertainty.copy()
        uncertainty[at] = np.inf
        return replace(result, numerical_uncertainty=uncertainty, unknown=(*result.unknown, reason))
    spread = np.zeros(result.inner_speed.shape)
    spread[at] = share_in(np.max(changes, axis=0), without)
    spread *= BETWEEN * share_in(result.torque.race, result.torque.total)
    return replace(result, numerical_uncertainty=result.numerical_uncertainty + spread)


def _beyond_the_fit(
    scene: Scene, result: FrictionTorque, farthest: ContactCorrection, variation: Variation
) -> FrictionTorque:
    """The torque with the uncertainty of contacts outside the fit for finite geometry: its change at their far end."""
    settled = result.settled(scene)
    settled = replace(settled, effects={**settled.effects, **NO_CAGE})
    try:
        other = friction_torque(settled, correction=farthest, variation=variation)
    except FembearingError as problem:
        reason = f"contacts outside the fit for finite geometry may be such that there is no answer: {problem}"
        unsure = np.full(result.inner_speed.shape, np.inf)
        return replace(result, numerical_uncertainty=unsure, unknown=(*result.unknown, reason))
    moved = share_in(np.abs(other.torque.race - result.torque.race), result.torque.total)
    return replace(result, numerical_uncertainty=result.numerical_uncertainty + moved)


def _require_friction(scene: Scene) -> None:
    """Raise InputError unless there is exactly one source of the friction of ball on race."""
    if scene.friction_coefficient is not None:
        require_non_negative(**{"friction.coefficient": scene.friction_coefficient})
        if scene.surface is not None:
            raise InputError(
                f"friction.coefficient = {scene.friction_coefficient:g} and [surface] both say what resists sliding: "
                "leave out the coefficient to have it computed from [lubricant] and [surface], or leave out [surface]"
            )
    elif scene.lubricant is None and scene.surface is None:
        raise InputError(
            "friction.coefficient is missing: add [friction] coefficient = 0.1 (usual are 0.05 to 0.12), or the tables "
            "[lubricant] and [surface] that it is computed from"
        )
    elif scene.lubricant is None or scene.surface is None:
        given, missing = ("surface", "lubricant") if scene.lubricant is None else ("lubricant", "surface")
        raise InputError(
            f"[{missing}] is missing: friction is computed from [lubricant] and [surface] together, and the scene has "
            f"[{given}] alone; add it, or give [friction] coefficient = 0.1"
        )


def _uncertainty(ledger: Ledger, races: RaceTorque, *, total: Array) -> Array:
    """(n,) of the total: estimates of what auto left out of the race torque, and of the sliding method's error."""
    left_out = ledger.left_out * share_in(races.total, total)
    if races.sliding is None:
        return left_out
    unknown = np.isinf(races.sliding.error)
    error = share_in(np.where(unknown, 0.0, races.sliding.error) * races.sliding_part, total)
    return left_out + np.where(unknown, np.inf, error)


def _unknown_sliding(sliding: Sliding | None) -> tuple[str, ...]:
    if sliding is None or not np.any(np.isinf(sliding.error)):
        return ()
    return (f"no estimate of the error of sliding by the method {sliding.method} is known",)


def _inlet_words(ledger: Ledger, inlets: Inlets | None) -> str:
    scene = ledger.scene
    if scene.lubricant is None:
        return "no lubricant"
    if not ledger.is_on("starvation"):
        return "flooded"
    assert inlets is not None
    assert inlets.starvation is not None
    degree = float(np.min(inlets.starvation.degree))
    return f"starved, {starvation_source(scene.bearing, scene.lubricant)}, m = {degree:.4g} at least"


def _on_races(values: Array | None, at: tuple[Array, Array]) -> dict[str, Array]:
    """inner, outer: of the heaviest ball at each point."""
    return {} if values is None else {race: values[index][at] for index, race in enumerate(RACES)}


def _loaded(balls: LoadedBalls, race: int, at: tuple[Array, Array]) -> LoadedContact:
    contact = balls.contact
    return LoadedContact(
        load=balls.load[race][at],
        semi_axis_rolling=contact.semi_axis_x[race][at],
        semi_axis_transverse=contact.semi_axis_y[race][at],
        peak_pressure=contact.peak_pressure[race][at],
        approach=contact.approach[race][at],
    )


def _provenance(
    ledger: Ledger, races: RaceTorque, *, correction: ContactCorrection | None, cage: CagePart | None
) -> Mapping[str, str]:
    """How each step was computed, and the versions."""
    scene, balls, sliding = ledger.scene, races.balls, races.sliding
    contacts = "Hertz, corrected for finite geometry" if ledger.is_on("finite_geometry") else "Hertz"
    slid_by = "nothing slides" if sliding is None else sliding.method
    if sliding is not None and sliding.computed is not None:
        slid_by += f" at {sliding.computed} of {balls.load.shape[1]} points"
    return MappingProxyType(
        {
            "scene": scene.name,
            "contact_angle": scene.contact_angle.rule,
            "spin_rule": scene.spin_rule,
            "microslip": scene.microslip,
            "loads": "thrust, all balls alike" if balls.method == "thrust" else "equilibrium of the ring",
            "contacts": contacts if correction is None else "Hertz with given factors",
            "friction": "given coefficient" if scene.surface is None else "mixed lubrication",
            "inlets": _inlet_words(ledger, races.resisting.inlets),
            "sliding": slid_by,
            "cage": "left out" if cage is None else cage.provenance,
            "model_version": str(MODEL_VERSION),
            **_versions(),
        }
    )


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
