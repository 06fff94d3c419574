"""Friction torque of a ball bearing under thrust, split by effect: equation 1 of the paper.

Torques are magnitudes about the bearing axis and oppose the rotation: turning the other way mirrors them.
"""

import platform
from collections.abc import Mapping
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter
from types import MappingProxyType

import numpy as np

from analytic.as_printed import as_printed_torque
from analytic.contact import Race, race_curvatures
from analytic.correction import ContactCorrection
from analytic.equilibrium import ThrustEquilibrium, thrust_equilibrium
from analytic.errors import InputError, require_finite, require_non_negative
from analytic.friction import RaceContact, SlipFriction, slip_friction
from analytic.hertz import HertzContact, contact_modulus
from analytic.kinematics import BallKinematics, ball_kinematics
from analytic.lubrication import LubricatedRace, lubricated_race
from analytic.race import SlidingContact, deformed_radius, hysteresis_torque
from analytic.rolling import RollingResistance, hydrodynamic_rolling, rolling_torque
from analytic.roughness import GapRoughness, gap_roughness
from analytic.scene import Array, Lubricant, Scene
from analytic.torque_result import Effect, FrictionCoefficients, FrictionTorque, LoadedContact, OnRaces, TorqueParts
from analytic.torque_warnings import doubts
from analytic.traction import CoulombTraction, Traction
from analytic.viscosity import inlet_viscosity

RACES: tuple[Race, Race] = ("inner", "outer")
BY_SLIP = ("spin", "conformity")
MODELLED = (*BY_SLIP, "hysteresis", "rolling")
NOT_MODELLED = ("cage",)


def friction_torque(
    scene: Scene, *, correction: ContactCorrection | None = None, film_factor: float = 1.0
) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    correction : factors on Hertz's contacts; under the rule `solved` they move contact angle and ball load too
    film_factor : on every film that the formula gives, > 0: what its uncertainty does to the torque
    The equilibrium under thrust, the slip power of both contacts of one ball per unit speed, times the number of balls:
        total = race = spin + conformity + hysteresis (equations 9 to 12) + hydrodynamic rolling, where there is an oil
    What slides does so by mixed lubrication where the scene has an oil and a surface, each contact with the coefficient
    of its mean pressure and mean sliding speed (`analytic.friction`, its first rung). A friction coefficient stands in
    place of the surface: then what slides does not depend on speed, and at standstill is that of the first motion.
    With microslip "as_printed" the paper's moments replace the derived ones, at the same spin and coefficients.
    Rolling takes the oil at the inlet's temperature, flooded and not heated by its own shear; factors on contacts reach
    it by angle and ball load alone.
    Raises InputError if the scene gives neither or both, has a radial load or a moment, asks for an effect that is not
    modelled or lacks its input, or loads the balls beyond a shoulder.
    """
    started = perf_counter()
    bearing = scene.bearing
    _require_thrust(scene)
    _require_friction(scene)
    reasons = _left_out(scene)
    load, speed = np.broadcast_arrays(*map(np.atleast_1d, (scene.operation.axial_load, scene.operation.inner_speed)))
    if load.size == 0:
        raise InputError("operation.axial_load is empty: give at least one operating point")
    require_finite(**{"operation.inner_speed": speed})
    balls = thrust_equilibrium(bearing, scene.contact_angle, axial_load=load, correction=correction)
    motion = ball_kinematics(  # per unit speed: the torque exists at standstill too
        inner_speed=1.0,
        contact_angle=balls.contact_angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    parts: dict[str, Array] = {}
    roughness: GapRoughness | None = None
    oiled: Mapping[Race, LubricatedRace] = {}
    coefficients: Mapping[Race, Array] = {}
    slip: SlipFriction | None = None
    if any(name not in reasons for name in BY_SLIP):
        if scene.surface is not None:
            roughness = gap_roughness(scene.surface)
            oiled = {
                race: _lubricated(scene, race, roughness, balls, speed * motion.entrainment_speed, film_factor)
                for race in RACES
            }
        slip = _slip(scene, oiled, balls, motion, speed=speed, spins="spin" not in reasons)
        coefficients = {"inner": slip.inner_coefficient, "outer": slip.outer_coefficient}
    inner, outer = (_sliding(scene, race, balls, motion, coefficients.get(race, 0.0)) for race in RACES)
    if slip is not None:
        by_slip = slip.torque
        if scene.microslip == "as_printed":
            by_slip = as_printed_torque(
                inner,
                outer,
                inner_spin_rate=by_slip.inner_spin_rate,
                outer_spin_rate=by_slip.outer_spin_rate,
                ball_radius=bearing.ball_radius,
            )
        elif scene.microslip != "derived":
            raise InputError(f'microslip must be "derived" or "as_printed", got {scene.microslip!r}')
        parts |= {name: bearing.ball_count * getattr(by_slip, name) for name in BY_SLIP}
    if scene.hysteresis_loss is not None and "hysteresis" not in reasons:
        loss = hysteresis_torque(inner, outer, hysteresis_loss=scene.hysteresis_loss)
        parts["hysteresis"] = bearing.ball_count * loss
    resistance: Mapping[Race, RollingResistance] = {}
    if scene.lubricant is not None and "rolling" not in reasons:
        resistance = {
            race: _rolling(scene, scene.lubricant, race, balls, speed * motion.entrainment_speed) for race in RACES
        }
        rolling = rolling_torque(**resistance, entrainment_rate=motion.entrainment_speed)
        parts["rolling"] = bearing.ball_count * rolling
    parts = {name: part for name, part in parts.items() if name not in reasons}
    race = sum(parts.values(), start=np.zeros_like(balls.ball_load))
    return FrictionTorque(
        inner_speed=speed,
        axial_load=load,
        contact_angle=balls.contact_angle,
        ball_load=balls.ball_load,
        torque=TorqueParts(total=race, race=race, **{name: parts.get(name) for name in MODELLED}),
        friction_coefficient=FrictionCoefficients(**coefficients),
        film=OnRaces(**{race: found.shared.film_thickness for race, found in oiled.items()}),
        asperity_share=OnRaces(**{race: found.shared.asperity_share for race, found in oiled.items()}),
        inner=_loaded(balls.ball_load, balls.inner),
        outer=_loaded(balls.ball_load, balls.outer),
        effects=tuple(_effects(scene, reasons, parts, race)),
        warnings=tuple(
            doubts(
                scene,
                balls,
                motion,
                {"inner": inner, "outer": outer},
                roughness=roughness,
                oiled=oiled,
                resistance=resistance,
            )
        ),
        provenance=MappingProxyType(
            {
                "scene": scene.name,
                "contact_angle": scene.contact_angle.rule,
                "spin_rule": scene.spin_rule,
                "microslip": scene.microslip,
                "friction": "given coefficient" if scene.surface is None else "mixed lubrication, single coefficient",
                "contacts": "Hertz" if correction is None else "Hertz with given factors",
                **_versions(),
            }
        ),
        seconds=perf_counter() - started,
    )


def _require_thrust(scene: Scene) -> None:
    for name, unit in (("radial_load", "N"), ("moment", "N m")):
        values = np.atleast_1d(getattr(scene.operation, name))
        other = values[values != 0]  # NaN too
        if other.size:
            raise InputError(
                f"operation.{name} = {other[0]:g} {unit}: the torque is computed for thrust alone, where all balls are "
                "loaded alike; leave it out, or take ball loads and angles from analytic.ring_equilibrium"
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


def _lubricated(
    scene: Scene,
    race: Race,
    roughness: GapRoughness,
    balls: ThrustEquilibrium,
    entrainment_speed: Array,
    film_factor: float,
) -> LubricatedRace:
    assert scene.lubricant is not None
    assert scene.surface is not None
    return lubricated_race(
        scene.bearing,
        race,
        lubricant=scene.lubricant,
        surface=scene.surface,
        roughness=roughness,
        contact_angle=balls.contact_angle,
        load=balls.ball_load,
        contact=_contact(balls, race),
        entrainment_speed=entrainment_speed,
        film_factor=film_factor,
    )


def _slip(
    scene: Scene,
    oiled: Mapping[Race, LubricatedRace],
    balls: ThrustEquilibrium,
    motion: BallKinematics,
    *,
    speed: Array,
    spins: bool,
) -> SlipFriction:
    """Of one ball, at each operating point."""

    def contact(race: Race) -> RaceContact:
        return RaceContact(
            traction=oiled[race].traction if oiled else _coulomb(scene), **_geometry(scene, race, balls, motion)
        )

    return slip_friction(
        contact("inner"),
        contact("outer"),
        ring_speed=speed,
        spin_difference=motion.spin_difference if spins else np.zeros_like(motion.spin_difference),
        spin_rule=scene.spin_rule,
        rung="single_coefficient",
    )


def _rolling(
    scene: Scene, lubricant: Lubricant, race: Race, balls: ThrustEquilibrium, entrainment_speed: Array
) -> RollingResistance:
    groove = scene.bearing.inner if race == "inner" else scene.bearing.outer
    along, across = race_curvatures(scene.bearing, race, contact_angle=balls.contact_angle)
    return hydrodynamic_rolling(
        curvature_x=along,
        curvature_y=across,
        load=balls.ball_load,
        modulus=contact_modulus(scene.bearing.ball_material, groove.material),
        viscosity=inlet_viscosity(lubricant).viscosity,
        entrainment_speed=entrainment_speed,
    )


def _coulomb(scene: Scene) -> Traction:
    assert scene.friction_coefficient is not None
    return CoulombTraction(friction_coefficient=scene.friction_coefficient)


def _sliding(
    scene: Scene, race: Race, balls: ThrustEquilibrium, motion: BallKinematics, coefficient: Array | float
) -> SlidingContact:
    return SlidingContact(friction_coefficient=coefficient, **_geometry(scene, race, balls, motion))


def _geometry(scene: Scene, race: Race, balls: ThrustEquilibrium, motion: BallKinematics) -> dict[str, Array]:
    """Of a ball on one race, as RaceContact and SlidingContact take it."""
    bearing, contact = scene.bearing, _contact(balls, race)
    groove = bearing.inner if race == "inner" else bearing.outer
    return {
        "load": balls.ball_load,
        "semi_axis_rolling": contact.semi_axis_x,
        "semi_axis_transverse": contact.semi_axis_y,
        "deformed_radius": deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter),
        "rolling_rate": motion.inner_rolling_rate if race == "inner" else motion.outer_rolling_rate,
    }


def _contact(balls: ThrustEquilibrium, race: Race) -> HertzContact:
    return balls.inner if race == "inner" else balls.outer


def _loaded(load: Array, contact: HertzContact) -> LoadedContact:
    return LoadedContact(
        load=load,
        semi_axis_rolling=contact.semi_axis_x,
        semi_axis_transverse=contact.semi_axis_y,
        peak_pressure=contact.peak_pressure,
        approach=contact.approach,
    )


def _left_out(scene: Scene) -> dict[str, str]:
    """name -> why, for each effect that is not computed; refuses what the scene asks for and cannot have."""
    reasons = {name: "the scene says off" for name, decision in scene.effects.items() if decision == "off"}
    for name in NOT_MODELLED:
        if scene.effects.get(name) == "on":
            raise InputError(f'effects.{name} = "on" cannot be had: not modelled yet; give "auto" or "off"')
        reasons[name] = "not modelled yet"
    if scene.lubricant is None and "rolling" not in reasons:
        if scene.effects.get("rolling") == "on":
            raise InputError('effects.rolling = "on" needs the oil: add a table [lubricant]')
        reasons["rolling"] = "no lubricant is given"
    if scene.hysteresis_loss is None and "hysteresis" not in reasons:
        if scene.effects.get("hysteresis") == "on":
            raise InputError(
                'effects.hysteresis = "on" needs friction.hysteresis_loss: give the share of elastic energy lost in '
                "each cycle, for bearing steel 0.004 to 0.01"
            )
        reasons["hysteresis"] = "friction.hysteresis_loss is not given"
    return reasons


def _effects(scene: Scene, reasons: dict[str, str], parts: dict[str, Array], total: Array) -> list[Effect]:
    effects = []
    for name in (*MODELLED, *NOT_MODELLED):
        if name in reasons:
            effects.append(Effect(name=name, decision="off", share=None, reason=reasons[name]))
            continue
        shares = np.divide(parts[name], total, out=np.zeros_like(total), where=total > 0)
        reason = "the scene says on" if scene.effects.get(name) == "on" else "always computed: it costs next to nothing"
        effects.append(Effect(name=name, decision="on", share=float(np.max(shares, initial=0.0)), reason=reason))
    return effects


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
