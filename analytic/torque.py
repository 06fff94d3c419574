"""Friction torque of a ball bearing, split by effect: equation 1 of the paper, summed over the balls.

Every part is the power that one effect loses, over the speed of the ring. Torques are magnitudes about the bearing axis
and oppose the rotation: turning the other way mirrors them.
"""

import platform
from dataclasses import replace
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter
from types import MappingProxyType

import numpy as np

from analytic.cage.torque import cage_friction
from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import DECLARED, EFFECTS, Choices, Effect, share_in
from analytic.effects.limits import watch
from analytic.effects.loads import RACES, loaded_balls, points
from analytic.effects.sliding import chosen_lubrication
from analytic.effects.warnings import doubts
from analytic.errors import InputError, require_finite, require_non_negative
from analytic.loads.balls import LoadedBalls
from analytic.oil.lubricated_races import LubricatedRaces, lubricated_races
from analytic.oil.mixed import MixedContact
from analytic.oil.rolling import RollingResistance, hydrodynamic_rolling, rolling_torque
from analytic.oil.traction import CoulombTraction, Traction
from analytic.oil.viscosity import inlet_viscosity
from analytic.result import FrictionCoefficients, FrictionTorque, LoadedContact, OnRaces, TorqueParts
from analytic.scene import Array, Scene
from analytic.sliding.long_ellipse import hysteresis_moment
from analytic.sliding.methods import Sliding, race_sliding

BY_SLIP = ("spin", "conformity")
PARTS = (*BY_SLIP, "hysteresis", "rolling", "cage")


def friction_torque(
    scene: Scene, *, correction: ContactCorrection | None = None, film_factor: float = 1.0
) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    correction : factors on Hertz's contacts, in place of those of the finite geometry; under the rule `solved` they
        move contact angle and ball loads too
    film_factor : on every film that the formula gives, > 0: what its uncertainty does to the torque
    The balls are loaded (`analytic.effects.loads`), and each loses power to each race: per unit speed and summed,
        race = spin + conformity + hysteresis (equations 9 to 12) + hydrodynamic rolling, where there is an oil
        total = race + cage (`analytic.cage.torque`) + declared, what the scene tells of seals and drag
    What slides does so by mixed lubrication where the scene has an oil and a surface. A friction coefficient stands in
    place of the surface: then what slides does not depend on speed, and at standstill is that of the first motion.
    Rolling takes the oil at the inlet's temperature.
    With microslip "as_printed" the paper's moments replace the derived ones, at the same spin and coefficients.
    What is computed, and how, follows from the scene's tolerance (`analytic.effects.ledger`, `analytic.sliding.methods`); the result
    names it all, with the numerical uncertainty that remains.
    Raises InputError if the scene gives neither or both of coefficient and surface, asks for an effect that lacks its
    input, or loads the balls beyond a shoulder.
    """
    started = perf_counter()
    _require_friction(scene)
    operation = points(scene)
    speed = operation.inner_speed
    require_finite(**{"operation.inner_speed": speed})
    choices = Choices(scene, speed.size)
    balls, warnings = loaded_balls(scene, operation, choices, correction=correction)
    parts, resistance = _rolled(scene, balls, speed, choices)
    oiled: LubricatedRaces | None = None
    shared: MixedContact | None = None
    slid: Sliding | None = None
    conforms = choices.calls_for("conformity", share=None)
    if conforms or scene.effects.get("spin") != "off":
        if scene.lubricant is not None and scene.surface is not None:
            oiled = lubricated_races(
                scene.bearing,
                balls,
                lubricant=scene.lubricant,
                surface=scene.surface,
                ring_speed=speed,
                film_factor=film_factor,
            )
        shared, parts = chosen_lubrication(scene, balls, oiled, choices, speed=speed, rolled=parts)
        slid = race_sliding(
            balls,
            _tractions(scene, oiled, shared),
            ring_speed=speed,
            spins=choices.on("spin"),
            conforms=choices.on("conformity"),
            spin_rule=scene.spin_rule,
            microslip=scene.microslip,
            asked=scene.sliding,
            beside=_sum(parts, speed),
            allowed=scene.tolerance - choices.left_out,
        )
        parts |= {name: getattr(slid, name) for name in BY_SLIP if choices.on(name)}
    race = _sum(parts, speed)
    cage = cage_friction(scene, balls, operation, choices, race=race)
    computed = race if cage is None else race + cage.torque
    declared = _declared(scene, choices, computed)
    total = computed if declared is None else computed + declared
    if cage is not None:
        parts["cage"] = cage.torque
        warnings = warnings + list(cage.warnings)
    watched = watch(scene, operation, balls, choices, slid=slid)
    at = balls.heaviest
    return FrictionTorque(
        inner_speed=speed,
        axial_load=operation.axial_load,
        radial_load=operation.radial_load,
        moment=operation.moment,
        contact_angle=balls.contact_angle.mean(axis=0)[at],
        ball_load=balls.load.max(axis=0)[at],
        torque=TorqueParts(total=total, race=race, declared=declared, **{name: parts.get(name) for name in PARTS}),
        numerical_uncertainty=_uncertainty(choices, slid, parts, race=race, total=total)
        + (0.0 if cage is None else share_in(cage.half_interval, total)),
        friction_coefficient=FrictionCoefficients(
            **_on_races(None if slid is None else slid.coefficient, at),
            pocket=None if cage is None else cage.friction_coefficient,
        ),
        cage=cage,
        film=OnRaces(**_on_races(None if shared is None else np.maximum(shared.film_thickness, 0.0), at)),
        asperity_share=OnRaces(**_on_races(None if shared is None else shared.asperity_share, at)),
        inner=_loaded(balls, 0, at),
        outer=_loaded(balls, 1, at),
        effects=tuple(_with_share(choices.made[name], parts, total) for name in EFFECTS if name in choices.made),
        sliding="auto" if slid is None else slid.rung,
        gap_roughness=None if oiled is None else oiled.roughness.rms_roughness,
        warnings=tuple(
            doubts(scene, choices, watched=watched, oiled=oiled, shared=shared, resistance=resistance) + warnings
        ),
        provenance=MappingProxyType(
            {
                "scene": scene.name,
                "contact_angle": scene.contact_angle.rule,
                "spin_rule": scene.spin_rule,
                "microslip": scene.microslip,
                "loads": "thrust, all balls alike" if balls.rung == "thrust" else "equilibrium of the ring",
                "contacts": _contacts(choices, correction),
                "friction": "given coefficient" if oiled is None else "mixed lubrication",
                "sliding": _slid_by(slid, speed.size),
                "cage": "left out" if cage is None else cage.provenance,
                **_versions(),
            }
        ),
        seconds=perf_counter() - started,
    )


def _require_friction(scene: Scene) -> None:
    """Exactly one source of the friction of ball on race."""
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


def _rolled(
    scene: Scene, balls: LoadedBalls, speed: Array, choices: Choices
) -> tuple[dict[str, Array], RollingResistance | None]:
    """What rolling costs without any sliding, (n,) N m: hysteresis of the bodies, and pushing the oil aside."""
    parts: dict[str, Array] = {}
    resistance: RollingResistance | None = None
    lacks = (
        "friction.hysteresis_loss is not given: the share of elastic energy lost in each cycle, for steel 0.004-0.01"
    )
    if choices.calls_for("hysteresis", share=None, lacks=lacks if scene.hysteresis_loss is None else None):
        assert scene.hysteresis_loss is not None
        moment = hysteresis_moment(
            hysteresis_loss=scene.hysteresis_loss, load=balls.load, semi_axis_rolling=balls.contact.semi_axis_x
        )
        parts["hysteresis"] = balls.total(moment * balls.rolling_rate)
    lacks = "no lubricant is given: add a table [lubricant]"
    if choices.calls_for("rolling", share=None, lacks=lacks if scene.lubricant is None else None):
        assert scene.lubricant is not None
        resistance = hydrodynamic_rolling(
            curvature_x=balls.curvature_along,
            curvature_y=balls.curvature_across,
            load=balls.load,
            modulus=balls.modulus,
            viscosity=inlet_viscosity(scene.lubricant).viscosity,
            entrainment_speed=speed[:, None] * balls.motion.entrainment_speed,
        )
        parts["rolling"] = balls.total(rolling_torque(resistance, entrainment_rate=balls.motion.entrainment_speed))
    return parts, resistance


def _tractions(scene: Scene, oiled: LubricatedRaces | None, shared: MixedContact | None) -> tuple[Traction, Traction]:
    if oiled is None or shared is None:
        assert scene.friction_coefficient is not None
        law = CoulombTraction(friction_coefficient=scene.friction_coefficient)
        return law, law
    return oiled.traction(shared, 0), oiled.traction(shared, 1)


def _declared(scene: Scene, choices: Choices, computed: Array) -> Array | None:
    """(n,) N m, of seals and drag; settles both."""
    given = {name: getattr(scene.losses, name) for name in DECLARED}
    known = {name: value for name, value in given.items() if value is not None}
    require_non_negative(**{f"losses.{name}": value for name, value in known.items()})
    total = computed + sum(known.values(), start=0.0)
    for name, value in given.items():
        share = None if value is None else share_in(np.full_like(total, value), total)
        reason = "not declared" if value is None else "declared by the scene"
        choices.settled(name, on=value is not None, share=share, reason=reason)
    return np.full_like(computed, sum(known.values())) if known else None


def _slid_by(slid: Sliding | None, points: int) -> str:
    if slid is None:
        return "nothing slides"
    return slid.rung if slid.computed is None else f"{slid.rung} at {slid.computed} of {points} points"


def _contacts(choices: Choices, correction: ContactCorrection | None) -> str:
    if correction is not None:
        return "Hertz with given factors"
    return "Hertz, corrected for finite geometry" if choices.on("finite_geometry") else "Hertz"


def _uncertainty(
    choices: Choices, slid: Sliding | None, parts: dict[str, Array], *, race: Array, total: Array
) -> Array:
    """(n,) of the total: bounds on what auto left out of the race's torque, and what the rung of sliding misses."""
    if slid is None:
        return choices.left_out * share_in(race, total)
    slipping = _sum({name: part for name, part in parts.items() if name in BY_SLIP}, race)
    unknown = np.isinf(slid.error)
    missed = np.where(unknown, np.inf, share_in(np.where(unknown, 0.0, slid.error) * slipping, total))
    return choices.left_out * share_in(race, total) + missed


def _with_share(effect: Effect, parts: dict[str, Array], total: Array) -> Effect:
    """A part of the torque is told with its own largest share in place of a bound."""
    if effect.name not in parts:
        return effect
    return replace(effect, share=float(np.max(share_in(parts[effect.name], total), initial=0.0)))


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


@cache
def _versions() -> dict[str, str]:
    """Of the packages that take part."""
    found = {"python": platform.python_version()}
    for name in ("fembearing", "numpy", "scipy"):
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed"
    return found
