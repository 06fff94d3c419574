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

from analytic.cage.drive import cage_drive
from analytic.cage.torque import CagePart, cage_friction
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES
from analytic.effects.cage import decide_cage
from analytic.effects.declared import declared_losses
from analytic.effects.ledger import Ledger, share_in
from analytic.effects.limits import check_limits
from analytic.effects.loads import chosen_balls
from analytic.effects.sliding import Resisting, decide_sliding, decide_whether_sliding
from analytic.effects.warnings import torque_warnings
from analytic.errors import FembearingError, InputError, require_finite, require_non_negative
from analytic.loads.balls import LoadedBalls
from analytic.oil.film import FILM_FACTORS
from analytic.oil.inlets import Inlets, inlets_of, starvation_source
from analytic.oil.lubricated_races import LubricatedRaces, lubricate_races
from analytic.oil.mixed import MixedContact
from analytic.oil.rolling import (
    RollingResistance,
    houpert_rolling,
    hydrodynamic_rolling,
    hysteresis_moment,
    rolling_torque,
)
from analytic.oil.traction import CoulombTraction, Traction
from analytic.oil.variation import COVERAGE, ROLLING_SPREAD, SURFACE_SPREAD, Variation
from analytic.oil.viscosity import inlet_viscosity
from analytic.result import FrictionCoefficients, FrictionTorque, LoadedContact, OnRaces, TorqueParts
from analytic.scene import Array, Bearing, Scene, Surface
from analytic.sliding.methods import Sliding, SlidingModel, race_sliding

BY_SLIP = ("spin", "conformity")
PARTS = (*BY_SLIP, "hysteresis", "rolling", "cage")
NOMINAL = Variation()


def friction_torque(
    scene: Scene, *, correction: ContactCorrection | None = None, variation: Variation = NOMINAL
) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    correction : factors on Hertz's contacts, in place of those of the finite geometry; under the rule `solved` they
        change contact angle and ball loads too
    variation : of the formulas of oil and surfaces, to show the effect of their uncertainty
    The balls are loaded (`analytic.loads`), and each loses power to each race: per unit speed and summed,
        race = spin + conformity + hysteresis (equations 9 to 12 of [Paper]) + hydrodynamic rolling, where there is oil
        total = race + cage (`analytic.cage`) + declared losses of seals and drag
    Sliding is by mixed lubrication where the scene has an oil and a surface. A friction coefficient takes the place of
    the surface: then sliding friction does not depend on speed, and at standstill it is that of the first motion.
    Rolling takes the oil at the inlet's temperature.
    With microslip "as_printed" the moments of [Paper] replace the derived ones, at the same spin and coefficients.
    The scene's tolerance decides which effects are computed, and how (`analytic.effects`, `analytic.sliding.methods`);
    the result lists them all, with the numerical uncertainty that remains.
    Raises InputError if the scene gives neither or both of coefficient and surface, demands an effect that lacks its
    input, or loads the balls beyond a shoulder.
    """
    started = perf_counter()
    _require_friction(scene)
    operation = scene.operation.as_series()
    speed = operation.inner_speed
    require_finite(**{"operation.inner_speed": speed})
    ledger = Ledger(scene, speed.size)
    chosen = chosen_balls(scene, operation, ledger, correction=correction)
    balls, load_warnings = chosen.balls, list(chosen.warnings)
    parts: dict[str, Array] = {}
    if ledger.decide("hysteresis"):
        assert scene.hysteresis_loss is not None
        moment = hysteresis_moment(balls.contacts, hysteresis_loss=scene.hysteresis_loss)
        parts["hysteresis"] = balls.total(moment * balls.contacts.rolling_rate)
    slides, constant = decide_whether_sliding(ledger), _sum(parts, speed)
    resisting, resistance = _resisting(ledger, balls, speed, constant=constant, slides=slides, variation=variation)
    oiled, inlets = resisting.oiled, resisting.inlets
    mixed = decide_sliding(scene, resisting, ledger, slides=slides)
    if resisting.rolling is not None and inlets is not None:
        left = inlets.rolling_factor(heats=ledger.is_on("inlet_heating"), starves=ledger.is_on("starvation"))
        parts["rolling"] = balls.total(resisting.rolling * left)
    sliding: Sliding | None = None
    if slides:
        sliding = race_sliding(
            balls,
            _tractions(scene, oiled, mixed),
            SlidingModel(
                spins=ledger.is_on("spin"),
                conforms=ledger.is_on("conformity"),
                spin_rule=scene.spin_rule,
                microslip=scene.microslip,
                method=scene.sliding,
            ),
            ring_speed=speed,
            other_torque=_sum(parts, speed),
            allowed=scene.tolerance - ledger.left_out,
        )
        parts |= {name: getattr(sliding, name) for name in BY_SLIP if ledger.is_on(name)}
    race = _sum(parts, speed)
    coefficient = scene.friction_coefficient if sliding is None else sliding.coefficient
    drive = None if scene.cage is None else cage_drive(scene, balls, coefficient, speed)
    decide_cage(scene, drive, ledger, race=race)
    cage: CagePart | None = None
    if drive is not None and ledger.is_on("cage"):
        cage = cage_friction(scene, drive, moves=ledger.is_on("cage_dynamics"))
    computed = race if cage is None else race + cage.torque
    declared = declared_losses(ledger, computed)
    total = computed if declared is None else computed + declared
    if cage is not None:
        parts["cage"] = cage.torque
        load_warnings = load_warnings + list(cage.warnings)
    limits = check_limits(scene, operation, balls, ledger, sliding=sliding)
    uncertainty = _uncertainty(ledger, sliding, parts, race=race, total=total) + limits.uncertainty
    at = balls.heaviest
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
        inner=_loaded(balls, 0, at),
        outer=_loaded(balls, 1, at),
        effects=ledger.effects(parts, total),
        sliding="auto" if sliding is None else sliding.method,
        gap_roughness=None if oiled is None else oiled.roughness.rms_roughness,
        warnings=tuple(
            torque_warnings(ledger, limits=limits.warnings, oiled=oiled, mixed=mixed, resistance=resistance)
            + load_warnings
        ),
        unknown=limits.unknown + _unknown_sliding(sliding) + (() if cage is None else cage.unknown),
        provenance=_provenance(ledger, resisting, correction=correction, sliding=sliding, cage=cage),
        seconds=perf_counter() - started,
    )
    if chosen.farthest is not None:
        result = _beyond_the_fit(scene, result, chosen.farthest, variation)
    return replace(result, seconds=perf_counter() - started)


def _beyond_the_fit(
    scene: Scene, result: FrictionTorque, farthest: ContactCorrection, variation: Variation
) -> FrictionTorque:
    """The torque with the uncertainty of contacts outside the fit for finite geometry: its change at their far end."""
    settled = result.settled(scene)
    settled = replace(settled, effects={**settled.effects, "cage": "off", "cage_dynamics": "off"})
    try:
        other = friction_torque(settled, correction=farthest, variation=variation)
    except FembearingError as problem:
        reason = f"contacts outside the fit for finite geometry may be such that there is no answer: {problem}"
        unsure = np.full(result.inner_speed.shape, np.inf)
        return replace(result, numerical_uncertainty=unsure, unknown=(*result.unknown, reason))
    moved = share_in(np.abs(other.torque.race - result.torque.race), result.torque.total)
    return replace(result, numerical_uncertainty=result.numerical_uncertainty + moved)


def with_model_uncertainty(
    scene: Scene, result: FrictionTorque, *, correction: ContactCorrection | None = None
) -> FrictionTorque:
    """The torque of a scene with the part of its model uncertainty that is known, 95 %.

    result : friction_torque(scene, correction=correction)
    The torque is computed again, with the same effects and methods, and each change is a part:
        film: films thicker and thinner by twice the standard uncertainty of their formula, 15 % of ln h
        gap: the other law of the room between rough surfaces, `elastic` or `truncated`
        surfaces: asperities that press more and less by twice the spread between surfaces of equal statistics
        rolling: a resistance to rolling of 0.61 and 1.65 times the formula's, and the formula of [Houpert1987]
    The largest change counts. The parts are independent, so the root of the sum of their squares is the whole.
    The errors of the oil's own properties, of traction and of the inputs come on top, so the true one is larger.
    """
    variations: dict[str, tuple[tuple[Scene, Variation], ...]] = {}
    same = result.settled(scene)
    surface, lubricant = scene.surface, scene.lubricant
    if surface is not None and result.film.inner is not None:
        variations["film"] = tuple((same, Variation(film=factor)) for factor in FILM_FACTORS)
        if result.is_on("asperities"):
            variations["gap"] = ((replace(same, surface=_other_gap(surface, scene.bearing)), NOMINAL),)
            factors = [np.exp(sign * COVERAGE * SURFACE_SPREAD) for sign in (-1, 1)]
            variations["surfaces"] = tuple((same, Variation(asperity_pressure=factor)) for factor in factors)
    if result.torque.rolling is not None and lubricant is not None:
        factors = [np.exp(sign * COVERAGE * ROLLING_SPREAD) for sign in (-1, 1)]
        resistances = [Variation(rolling=factor) for factor in factors]
        if lubricant.pressure_viscosity > 0:
            resistances.append(Variation(rolling_formula="houpert"))
        variations["rolling"] = tuple((same, resistance) for resistance in resistances)
    if not variations:
        return result
    total = result.torque.total

    def changes(pairs: tuple[tuple[Scene, Variation], ...]) -> list[Array]:
        varied = (friction_torque(scene, correction=correction, variation=variation) for scene, variation in pairs)
        return [share_in(np.abs(other.torque.total - total), total) for other in varied]

    parts = {name: np.max(changes(pairs), axis=0) for name, pairs in variations.items()}
    whole = np.sqrt(np.sum([part**2 for part in parts.values()], axis=0))
    return replace(result, model_uncertainty=whole, model_parts=MappingProxyType(parts))


def _other_gap(surface: Surface, bearing: Bearing) -> Surface:
    """The surface with the other law of the gap; its summits never yield where no hardness is known."""
    if surface.gap == "truncated":
        return replace(surface, gap="elastic")
    bodies = (bearing.ball_material, bearing.inner.material, bearing.outer.material)
    if surface.hardness is None and any(body.hardness is None for body in bodies):
        return replace(surface, gap="truncated", asperities="greenwood_williamson")
    return replace(surface, gap="truncated")


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


def _resisting(
    ledger: Ledger, balls: LoadedBalls, speed: Array, *, constant: Array, slides: bool, variation: Variation
) -> tuple[Resisting, RollingResistance | None]:
    """What resists the balls; settles rolling. constant : (n,) N m, torques that no oil changes."""
    scene, lubricant = ledger.scene, ledger.scene.lubricant
    resistance: RollingResistance | None = None
    rolling: Array | None = None
    if ledger.decide("rolling"):
        assert lubricant is not None
        oil, entrainment = inlet_viscosity(lubricant), speed[:, None] * balls.motion.entrainment_speed
        if variation.rolling_formula == "houpert":
            resistance = houpert_rolling(
                balls.contacts,
                viscosity=oil.viscosity,
                pressure_viscosity=oil.pressure_viscosity,
                entrainment_speed=entrainment,
            )
        else:
            resistance = hydrodynamic_rolling(balls.contacts, viscosity=oil.viscosity, entrainment_speed=entrainment)
        rolling = variation.rolling * rolling_torque(resistance, entrainment_rate=balls.motion.entrainment_speed)
    oiled: LubricatedRaces | None = None
    if slides and lubricant is not None and scene.surface is not None:
        oiled = lubricate_races(
            scene.bearing,
            balls,
            lubricant=lubricant,
            surface=scene.surface,
            ring_speed=speed,
            variation=variation,
        )
    resisting = Resisting(
        balls=balls,
        constant=constant,
        rolling=rolling,
        inlets=None if lubricant is None else inlets_of(scene.bearing, balls, lubricant, ring_speed=speed),
        oiled=oiled,
        friction_coefficient=scene.friction_coefficient or 0.0,
    )
    return resisting, resistance


def _tractions(scene: Scene, oiled: LubricatedRaces | None, mixed: MixedContact | None) -> tuple[Traction, Traction]:
    if oiled is None or mixed is None:
        assert scene.friction_coefficient is not None
        law = CoulombTraction(friction_coefficient=scene.friction_coefficient)
        return law, law
    return oiled.traction(mixed.race(0)), oiled.traction(mixed.race(1))


def _uncertainty(
    ledger: Ledger, sliding: Sliding | None, parts: dict[str, Array], *, race: Array, total: Array
) -> Array:
    """(n,) of the total: estimates of what auto left out of the race torque, and of the sliding method's error."""
    left_out = ledger.left_out * share_in(race, total)
    if sliding is None:
        return left_out
    slipping = _sum({name: part for name, part in parts.items() if name in BY_SLIP}, race)
    unknown = np.isinf(sliding.error)
    error = np.where(unknown, np.inf, share_in(np.where(unknown, 0.0, sliding.error) * slipping, total))
    return left_out + error


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


def _sum(parts: dict[str, Array], like: Array) -> Array:
    return sum(parts.values(), start=np.zeros(like.shape))


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
    ledger: Ledger,
    resisting: Resisting,
    *,
    correction: ContactCorrection | None,
    sliding: Sliding | None,
    cage: CagePart | None,
) -> Mapping[str, str]:
    """How each step was computed, and the versions."""
    scene, balls = ledger.scene, resisting.balls
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
            "inlets": _inlet_words(ledger, resisting.inlets),
            "sliding": slid_by,
            "cage": "left out" if cage is None else cage.provenance,
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
