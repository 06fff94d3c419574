"""Friction torque of a ball bearing under thrust, split by effect: equation 1 of the paper.

Torques are magnitudes about the bearing axis and oppose the rotation: turning the other way mirrors them.
"""

import platform
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter
from types import MappingProxyType
from typing import Any, Literal

import numpy as np

from analytic.contact import Race, race_curvatures, shoulder_distance
from analytic.correction import ContactCorrection
from analytic.equilibrium import ThrustEquilibrium, thrust_equilibrium
from analytic.errors import InputError, require_finite, require_non_negative
from analytic.hertz import HertzContact
from analytic.kinematics import BallKinematics, ball_kinematics
from analytic.race import SlidingContact, deformed_radius, hysteresis_torque, microslip_torque, sliding_number
from analytic.scene import Array, Scene

STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
LEAST_SLIDING = 3.0  # of the sliding number: below, elastic creep takes a good part of the slip
NOT_MODELLED = ("rolling", "cage")


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueParts:
    """N m, each (n,); None where a part was left out or is not modelled."""

    total: Array  # the sum of what was computed
    race: Array  # spin + conformity + hysteresis + rolling, as far as computed
    spin: Array | None
    conformity: Array | None
    hysteresis: Array | None
    rolling: Array | None = None
    cage: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionCoefficients:
    """Of each contact, (n,); None where there is no such contact."""

    inner: Array
    outer: Array
    pocket: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedContact:
    """One ball on one race, each (n,)."""

    load: Array  # Q, N
    semi_axis_rolling: Array  # a, m
    semi_axis_transverse: Array  # b, m
    peak_pressure: Array  # p0, Pa
    approach: Array  # delta, m


@dataclass(frozen=True, kw_only=True)
class Effect:
    """One physical contribution, decided for the whole series."""

    name: str
    decision: Literal["on", "off"]
    share: float | None  # of the total, the largest over the series; None: left out, its size not known
    reason: str


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionTorque:
    """The friction torque at every operating point of a scene; arrays have the shape (n,)."""

    inner_speed: Array  # rad/s
    axial_load: Array  # N
    contact_angle: Array  # al, loaded, rad
    ball_load: Array  # Q, N
    torque: TorqueParts
    friction_coefficient: FrictionCoefficients
    inner: LoadedContact
    outer: LoadedContact
    effects: tuple[Effect, ...]
    warnings: tuple[str, ...]
    provenance: Mapping[str, str]
    seconds: float  # that the computation took

    def to_json(self) -> dict[str, Any]:
        """Plain Python numbers, texts, lists and dicts, all SI; None where a part was left out or is not modelled."""
        return {
            "points": [self._point(index) for index in range(self.inner_speed.size)],
            "effects": [asdict(effect) for effect in self.effects],
            "warnings": list(self.warnings),
            "provenance": dict(self.provenance),
            "seconds": self.seconds,
        }

    def _point(self, index: int) -> dict[str, Any]:
        def here(group: object) -> dict[str, float | None]:
            return {name: None if values is None else float(values[index]) for name, values in vars(group).items()}

        cage = ("mean_force", "max_force", "interval", "duration", "state", "signed_moment")
        return {
            "inner_speed": float(self.inner_speed[index]),
            "axial_load": float(self.axial_load[index]),
            "contact_angle": float(self.contact_angle[index]),
            "torque": here(self.torque),
            "friction_coefficient": here(self.friction_coefficient),
            "film": {"inner": None, "outer": None},
            "asperity_share": {"inner": None, "outer": None},
            "contact": {"inner": here(self.inner), "outer": here(self.outer)},
            "uncertainty": {"numerical": None, "model": None},
            "cage": dict.fromkeys(cage),
        }


def friction_torque(scene: Scene, *, correction: ContactCorrection | None = None) -> FrictionTorque:
    """Friction torque at every operating point of the scene.

    correction : factors on Hertz's contacts; under the rule `solved` they move contact angle and ball load too
    The equilibrium under thrust, the slip power of both contacts of one ball per unit speed, times the number of balls:
        total = race = spin + conformity + hysteresis (equations 9 to 12)
    At constant friction coefficient the torque does not depend on speed, and at standstill is that of the first motion.
    Raises InputError if the scene has no friction coefficient, asks for an effect that is not modelled or lacks its
    input, or loads the balls beyond a shoulder.
    """
    started = perf_counter()
    bearing = scene.bearing
    if scene.friction_coefficient is None:
        raise InputError(
            "friction.coefficient is missing: no lubrication model gives the friction of ball on race yet; "
            "add [friction] coefficient = 0.1 (usual are 0.05 to 0.12)"
        )
    require_non_negative(**{"friction.coefficient": scene.friction_coefficient})
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
    inner, outer = (_sliding(scene, race, balls, motion) for race in ("inner", "outer"))
    parts: dict[str, Array] = {}
    if "spin" not in reasons or "conformity" not in reasons:
        spin = np.zeros_like(motion.spin_difference) if "spin" in reasons else motion.spin_difference
        slip = microslip_torque(inner, outer, spin_difference=spin, spin_rule=scene.spin_rule)
        parts |= {"spin": bearing.ball_count * slip.spin, "conformity": bearing.ball_count * slip.conformity}
    if scene.hysteresis_loss is not None and "hysteresis" not in reasons:
        loss = hysteresis_torque(inner, outer, hysteresis_loss=scene.hysteresis_loss)
        parts["hysteresis"] = bearing.ball_count * loss
    parts = {name: part for name, part in parts.items() if name not in reasons}
    race = sum(parts.values(), start=np.zeros_like(balls.ball_load))
    coefficient = np.full_like(balls.ball_load, scene.friction_coefficient)
    return FrictionTorque(
        inner_speed=speed,
        axial_load=load,
        contact_angle=balls.contact_angle,
        ball_load=balls.ball_load,
        torque=TorqueParts(
            total=race, race=race, **{name: parts.get(name) for name in ("spin", "conformity", "hysteresis")}
        ),
        friction_coefficient=FrictionCoefficients(inner=coefficient, outer=coefficient),
        inner=_loaded(balls.ball_load, balls.inner),
        outer=_loaded(balls.ball_load, balls.outer),
        effects=tuple(_effects(scene, reasons, parts, race)),
        warnings=tuple(_warnings(scene, balls, motion, {"inner": inner, "outer": outer})),
        provenance=MappingProxyType(
            {
                "scene": scene.name,
                "contact_angle": scene.contact_angle.rule,
                "spin_rule": scene.spin_rule,
                "contacts": "Hertz" if correction is None else "Hertz with given factors",
                **_versions(),
            }
        ),
        seconds=perf_counter() - started,
    )


def _sliding(scene: Scene, race: Race, balls: ThrustEquilibrium, motion: BallKinematics) -> SlidingContact:
    bearing = scene.bearing
    groove, contact, rate = (
        (bearing.inner, balls.inner, motion.inner_rolling_rate)
        if race == "inner"
        else (bearing.outer, balls.outer, motion.outer_rolling_rate)
    )
    return SlidingContact(
        friction_coefficient=np.full_like(balls.ball_load, scene.friction_coefficient),
        load=balls.ball_load,
        semi_axis_rolling=contact.semi_axis_x,
        semi_axis_transverse=contact.semi_axis_y,
        deformed_radius=deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter),
        rolling_rate=rate,
    )


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
    for name in ("spin", "conformity", "hysteresis", *NOT_MODELLED):
        if name in reasons:
            effects.append(Effect(name=name, decision="off", share=None, reason=reasons[name]))
            continue
        shares = np.divide(parts[name], total, out=np.zeros_like(total), where=total > 0)
        reason = "the scene says on" if scene.effects.get(name) == "on" else "always computed: it costs next to nothing"
        effects.append(Effect(name=name, decision="on", share=float(np.max(shares, initial=0.0)), reason=reason))
    return effects


def _warnings(
    scene: Scene, balls: ThrustEquilibrium, motion: BallKinematics, sliding: Mapping[Race, SlidingContact]
) -> list[str]:
    """What the reader has to know before using the numbers; refuses a contact that has left its race."""
    warnings = [
        *scene.warnings,
        f"the friction coefficient {scene.friction_coefficient:g} comes from the scene, not from a lubrication model",
        f"{' and '.join(NOT_MODELLED)} are not modelled yet: the total is too low by them",
    ]
    contacts: dict[Race, HertzContact] = {"inner": balls.inner, "outer": balls.outer}
    for race, contact in contacts.items():
        room = shoulder_distance(scene.bearing, race, contact_angle=balls.contact_angle)
        worst = int(np.argmin(room))
        if room[worst] <= 0:
            raise InputError(
                f"operation.axial_load = {scene.operation.axial_load[worst]:g} N: the contact moves to "
                f"{balls.contact_angle[worst]:.4f} rad, beyond the {race} race's shoulder: lower the load, reduce the "
                "clearance or raise shoulder_half_width"
            )
        worst = int(np.argmax(contact.semi_axis_y - room))
        if contact.semi_axis_y[worst] > room[worst]:
            warnings.append(
                f"the contact ellipse passes the {race} race's shoulder: semi-axis {contact.semi_axis_y[worst]:.4g} m, "
                f"room {room[worst]:.4g} m; the true contact is cut off there and its pressure higher"
            )
        peak = float(np.max(contact.peak_pressure))
        if peak > STATIC_LIMIT:
            warnings.append(
                f"peak pressure on the {race} race {peak:.4g} Pa is above the static limit {STATIC_LIMIT:.2g} Pa: "
                "the contact is no longer elastic"
            )
        curvature, _ = race_curvatures(scene.bearing, race, contact_angle=balls.contact_angle)
        creep = sliding_number(
            sliding[race], entrainment_speed=motion.entrainment_speed, curvature_rolling=curvature
        ).min()
        if creep < LEAST_SLIDING:
            warnings.append(
                f"the sliding number of the {race} contact is {creep:.3g}, below {LEAST_SLIDING:g}: elastic creep "
                "takes part of the slip, and spin and conformity come out too large"
            )
    return warnings


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
