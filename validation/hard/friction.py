"""Hard cases of friction on races: micro-slip at its limits, torque over load, mistakes in scene files, free balls."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.kinematics import ball_motion
from analytic.loads.ring import ring_equilibrium
from analytic.result import FrictionTorque
from analytic.scene import ContactAngle, Operation, Scene
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene
from analytic.sliding.long_ellipse import MicroslipTorque, microslip_moments, microslip_torque
from analytic.solve.model import model_of
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from validation.hard.specimens import (
    AS_HERTZ,
    SCENE_6205,
    exponent,
    parsed,
    torque_6205,
    with_clearance,
    with_conformity,
)

FREE, ZERO = ContactAngle(rule="solved", free=0.18), ContactAngle(rule="solved", free=0.0)
SOLVED = ContactAngle(rule="solved")
ELLIPSE_END = 3.671169832276226692825e-3  # m, of the heaviest contact at conformity 0.5005, by 40 digits


def spin(spin_to_roll: float) -> float:
    """M_spin/(mu Q b) at eps."""
    return _moments(spin_to_roll)[0]


def rolling(spin_to_roll: float) -> float:
    """M_roll R/(mu Q b^2) at eps."""
    return _moments(spin_to_roll)[1]


def _moments(spin_to_roll: float) -> tuple[float, float]:
    mu, load, semi_axis, radius = 0.07, 530.0, 0.9e-3, 3.7e-3
    moments = microslip_moments(
        friction_force=mu * load, semi_axis_transverse=semi_axis, deformed_radius=radius, spin_to_roll=spin_to_roll
    )
    size = mu * load * semi_axis
    return float(moments[0]) / size, float(moments[1]) * radius / (size * semi_axis)


def torque(part: str, load: float, **changed: Any) -> float:
    """One part of the 6205's torque, N m, under an axial load, N; `changed` as of `torque_6205`."""
    settings = {"contact_angle": FREE, "friction_coefficient": 0.1, "spin_rule": "balanced"} | changed
    return float(getattr(torque_6205(axial_load=load, **settings).torque, part)[0])


def preloaded(load: float) -> float:
    """Race torque under 14 um of interference."""
    return torque("total", load, contact_angle=ContactAngle(rule="solved"), bearing=with_clearance(-14e-6))


def balanced(spin_difference: float) -> MicroslipTorque:
    """One ball with balanced spin between races that differ in the last digit of a semi-axis."""
    inner = ContactNumbers(
        load=530.0,
        semi_axis_rolling=0.11e-3,
        semi_axis_transverse=0.9e-3,
        curvature_rolling=310.0,
        curvature_transverse=14.7,
        modulus=1.13e11,
        deformed_radius=3.7e-3,
        rolling_rate=2.9,
    )
    outer = inner._replace(semi_axis_transverse=math.nextafter(0.9e-3, 1.0))
    forces = 0.07 * 530.0, 0.07 * 530.0
    return microslip_torque(
        (inner, outer), friction_force=forces, spin_difference=spin_difference, spin_rule="balanced"
    )


def heaviest(ball_count: int) -> float:
    """Z Q/Fr of the ball in line with a radial load, without clearance, at contact angle 0."""
    bearing, load = replace(with_clearance(0.0), ball_count=ball_count), 640.0
    ring = ring_equilibrium(bearing, ZERO, radial_load_x=load)
    return ball_count * float(ring.balls["load"].max()) / load


def spin_without_angle() -> float:
    """Share of the spin in the torque of the 6205 under a radial load alone, without clearance."""
    parts = torque_6205(radial_load=640.0, contact_angle=ZERO, bearing=with_clearance(0.0)).torque
    assert parts.spin is not None
    return float(parts.spin[0] / parts.total[0])


def beyond_the_shoulder(half_width: float) -> float:
    """Share of the heaviest contact's load beyond an inner shoulder at this distance, m, at conformity 0.5005."""
    narrow = with_clearance(0.0, of=with_conformity(0.5005))
    bearing = replace(narrow, inner=replace(narrow.inner, shoulder_half_width=half_width))
    operation = Operation(axial_load=np.array([0.0]), inner_speed=np.array([31.0]), radial_load=np.array([640.0]))
    scene = replace(SCENE_6205, operation=operation, effects=AS_HERTZ, contact_angle=ZERO, spin_rule="balanced")
    scene = replace(scene, bearing=bearing)
    checks = torque_of_scene(scene, estimate=False).verdicts.physical
    (share,) = [check.value for check in checks if (check.name, check.where) == ("shoulder", "inner race")]
    assert share is not None
    return share


def hardly_loaded() -> float:
    """Torque of the shipped scene in oil at 500 rpm under 1e-6 N, N m."""
    settings = {"operation.axial_load": "1e-6 N", "operation.inner_speed": "500 rpm"}
    return float(friction_torque(load_scene("paper_6205", settings=settings)).torque.total[0])


HIGHEST_SPEED = 3e6 / 39.01 * np.pi / 30  # rad/s, n d_m = 3e6 mm/min


def free_scene(*, load: float = 410.0, speed: float = 83.0, friction: float = 0.07, **changed: Any) -> Scene:
    """The 6205 dry and without a cage, under thrust, with marched creep."""
    scene = replace(
        SCENE_6205,
        operation=Operation(axial_load=np.array([load]), inner_speed=np.array([speed])),
        contact_angle=FREE,
        friction_coefficient=friction,
        hysteresis_loss=None,
        cage=None,
        effects={"finite_geometry": "off", "weight": "off"},
    )
    return replace(scene, **changed)


def free(**changed: Any) -> FrictionTorque:
    return friction_torque(free_scene(**changed))


def total(**changed: Any) -> float:
    return float(free(**changed).torque.total[0])


def orbit_at_own_pitch() -> float:
    """Orbital speed under 90 N at the highest speed, over that of closed kinematics at the pitch of the ball's axis."""
    scene = free_scene(load=90.0, speed=HIGHEST_SPEED)
    counted: dict[str, bool] = dict.fromkeys(("centrifugal", "gyroscopic", "spin", "conformity"), True)
    model = model_of(scene, counted, free=True)
    ball = solved(model, points_of(scene.operation, 0.0)).balls[0, 0]
    (inner, outer), motion, size = ball["angle"], ball["motion"], scene.bearing.ball_diameter
    pitch_diameter = 2 * motion["inner_radius"] + size * np.cos(inner)
    rolling = ball_motion(1.0, inner, outer, motion["pitch"], float(pitch_diameter), size)
    return float(motion["cage_speed"] / rolling.cage_speed)


def one_ball() -> float:
    """Load of the heaviest ball under 0.02 N aside, over that load: with clearance the others carry nothing."""
    aside = Operation(axial_load=np.array([0.0]), inner_speed=np.array([1e-6]), radial_load=np.array([0.02]))
    return float(free(operation=aside).inner.load[0]) / 0.02


FRICTION_CASES: dict[str, Callable[[], float]] = {
    "micro-slip: no spin": lambda: rolling(0.0),
    "micro-slip: vanishing spin": lambda: spin(1e-12) / 1e-12,
    "micro-slip: full spin": lambda: spin(0.5),
    "micro-slip: far beyond full spin": lambda: spin(1e9),
    "micro-slip: the end of rolling": lambda: rolling(0.5 - 5e-6) / (1e-5) ** 2,
    "micro-slip: negative spin": lambda: spin(-0.31) / spin(0.31),
    "micro-slip: continuity at full spin": lambda: spin(0.5 - 1e-9) / spin(0.5 + 1e-9),
    "micro-slip: continuity at full negative spin": lambda: spin(-0.5 + 1e-9) / spin(-0.5 - 1e-9),
    "spin balance: nearly equal races": lambda: float(balanced(0.69).spin),
    "spin balance: both races in full spin": lambda: float(balanced(0.83).spin),
    "load: radial, zero angle": lambda: heaviest(9),
    "load: radial, 400 balls": lambda: heaviest(400),
    "torque: radial load, zero angle": spin_without_angle,
    "torque: spin at vanishing load": lambda: exponent(lambda load: torque("spin", load), 1e-9, 1e-8),
    "torque: conformity at vanishing load": lambda: exponent(
        lambda load: torque("conformity", load, spin_rule="outer_control"), 1e-9, 1e-8
    ),
    "torque: hysteresis at vanishing load": lambda: exponent(lambda load: torque("hysteresis", load), 1e-9, 1e-8),
    "torque: spin from an angle of zero": lambda: exponent(
        lambda load: torque("spin", load, contact_angle=ZERO), 1e-10, 1e-9
    ),
    "torque: conformity from an angle of zero": lambda: exponent(
        lambda load: torque("conformity", load, contact_angle=ZERO), 1e-10, 1e-9
    ),
    "torque: hysteresis from an angle of zero": lambda: exponent(
        lambda load: torque("hysteresis", load, contact_angle=ZERO), 1e-10, 1e-9
    ),
    "torque: preload without thrust": lambda: preloaded(1e-12) / preloaded(1e-9),
    "torque: reversed rotation": lambda: torque("total", 700.0, speed=-31.0) / torque("total", 700.0, speed=31.0),
    "torque: at standstill": lambda: torque("total", 700.0, speed=0.0) / torque("total", 700.0, speed=31.0),
    "torque: no friction": lambda: torque("total", 700.0, friction_coefficient=0.0) / torque("hysteresis", 700.0),
    "torque: thrust at zero angle": lambda: torque("total", 700.0, contact_angle=ContactAngle(rule="given", value=0.0)),
    "torque: over the shoulder": lambda: torque("total", 1e9),
    "torque: groove as wide as the ball": lambda: torque("total", 700.0, bearing=with_conformity(0.5)),
    "torque: clearance 1e-12 m": lambda: (
        torque("total", 700.0, contact_angle=SOLVED, bearing=with_clearance(1e-12))
        / torque("total", 700.0, contact_angle=SOLVED, bearing=with_clearance(0.0))
    ),
    "torque: ellipse up to the shoulder": lambda: beyond_the_shoulder(ELLIPSE_END * (1 + 1e-12)),
    "torque: ellipse past the shoulder": lambda: beyond_the_shoulder(0.6e-3),
    "torque: 1e-6 N at 500 rpm": hardly_loaded,
    "scene: a load in mm": lambda: parsed(load="700 mm"),
    "scene: a speed of infinity": lambda: parsed(speed="inf rpm"),
    "scene: a load that is not a number": lambda: parsed(load="nan N"),
    "scene: no load at all": lambda: parsed(load="0 N"),
    "scene: an unknown key": lambda: parsed(speed_key="inner_sped"),
    "scene: a missing key": lambda: parsed(speed_key="# inner_speed"),
    "free ball: standstill": lambda: total(speed=0.0) / total(speed=1e-9),
    "free ball: reversed rotation": lambda: total(speed=-83.0) / total(speed=83.0),
    "free ball: vanishing load": lambda: exponent(lambda load: total(load=load, speed=0.0), 1e-6, 2e-6),
    "free ball: 1 mN": lambda: float(0 < total(load=1e-3) < 1e-4),
    "free ball: n d_m of 3 million": orbit_at_own_pitch,
    "free ball: skidding": lambda: total(load=2.0, speed=HIGHEST_SPEED),
    "free ball: no friction": lambda: total(friction=0.0, hysteresis_loss=0.0),
    "free ball: much friction": lambda: total(friction=20.0) / total(friction=40.0),
    "free ball: one loaded ball": one_ball,
}
