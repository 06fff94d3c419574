"""Hard cases of the friction of ball on race: micro-slip at its limits, torque over load, mistakes in scene files."""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.ring import ring_equilibrium
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Operation
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene
from analytic.sliding.long_ellipse import MicroslipTorque, microslip_moments, microslip_torque
from analytic.torque import friction_torque
from validation.hard.case import HardCase
from validation.hard.specimens import (
    AS_HERTZ,
    exponent,
    parsed,
    scene_6205,
    torque_6205,
    with_clearance,
    with_conformity,
)

VANISHING = (1e-6, "the next term, the square of a change of angle below 1e-4, and less")
RING = (1e-10, "the ring settles to 1e-12 of its loads, of which torques are powers")
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


def rolled(of: Bearing) -> FrictionTorque:
    """A bearing without clearance under 640 N aside: its balls roll at contact angle 0, on long ellipses."""
    return torque_6205(
        radial_load=640.0,
        contact_angle=ZERO,
        bearing=with_clearance(0.0, of=of),
        friction_coefficient=0.1,
        spin_rule="balanced",
    )


def conformity_torque(of: Bearing) -> float:
    """Its torque by conformity, N m; NaN if any comes from spin."""
    parts = rolled(of).torque
    assert parts.conformity is not None
    assert parts.spin is not None
    return float(parts.conformity[0]) if parts.spin[0] == 0.0 else math.nan


def beyond_the_shoulder(half_width: float) -> float:
    """Share of the heaviest contact's load beyond an inner shoulder at this distance, m, at conformity 0.5005."""
    narrow = with_clearance(0.0, of=with_conformity(0.5005))
    bearing = replace(narrow, inner=replace(narrow.inner, shoulder_half_width=half_width))
    operation = Operation(axial_load=np.array([0.0]), inner_speed=np.array([31.0]), radial_load=np.array([640.0]))
    scene = replace(scene_6205(), operation=operation, effects=AS_HERTZ, contact_angle=ZERO, spin_rule="balanced")
    scene = replace(scene, bearing=bearing)
    checks = torque_of_scene(scene, estimate=False).verdicts.physical
    (share,) = [check.value for check in checks if (check.name, check.where) == ("shoulder", "inner race")]
    assert share is not None
    return share


def hardly_loaded() -> float:
    """Torque of the shipped scene in oil at 500 rpm under 1e-6 N, N m."""
    settings = {"operation.axial_load": "1e-6 N", "operation.inner_speed": "500 rpm"}
    return float(friction_torque(load_scene("paper_6205", settings=settings)).torque.total[0])


FRICTION_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("micro-slip: no spin", "the rolling moment at exactly no spin",
        "pure rolling at -/+g with g^3 - 3 g + 1 = 0: (2/5 - 2 g^3 (1 - 3 g^2/5))/4, by 40 digits",
        lambda: rolling(0.0), 0.080571198872177867677),
    HardCase("micro-slip: vanishing spin", "spin moment over spin at eps = 1e-12",
        "3 g (1 - g^2), the slope at eps = 0, by 40 digits", lambda: spin(1e-12) / 1e-12, 0.91622186799683581378),
    HardCase("micro-slip: full spin", "the spin moment at eps = 1/2, where one line of pure rolling leaves the contact",
        "3/8: the whole contact spins about its centre", lambda: spin(0.5), 0.375),
    HardCase("micro-slip: far beyond full spin", "the spin moment at eps = 1e9",
        "3/8, as at 1/2: Coulomb friction does not depend on speed", lambda: spin(1e9), 0.375),
    HardCase("micro-slip: the end of rolling", "the rolling moment over (1 - 2 eps)^2 as eps approaches 1/2 from below",
        "3/4: the outer line of pure rolling is (1 - 2 eps) from the edge, to first order",
        lambda: rolling(0.5 - 5e-6) / (1e-5) ** 2, 0.75,
        tolerance=(1e-4, "the next term, relative, is a few times 1 - 2 eps = 1e-5")),
    HardCase("micro-slip: negative spin", "the spin moment at eps = -0.31 over that at 0.31", "-1, by symmetry",
        lambda: spin(-0.31) / spin(0.31), -1.0),
    HardCase("micro-slip: continuity at full spin", "the spin moment just below eps = 1/2 over that just above",
        "1: the difference is the square of the distance, 1e-9", lambda: spin(0.5 - 1e-9) / spin(0.5 + 1e-9), 1.0),
    HardCase("micro-slip: continuity at full negative spin", "the same at eps = -1/2", "1",
        lambda: spin(-0.5 + 1e-9) / spin(-0.5 - 1e-9), 1.0),
    HardCase("spin balance: nearly equal races",
        "the spin's torque where a semi-axis differs by 1e-16 and both races are close to full spin",
        "half of the spin each: 3 eps d (1 - eps^2 - d^2) with d^3 - 3 (1 - eps^2) d + 1 = 0, by 40 digits",
        lambda: float(balanced(0.69).spin), 0.0086241907747470239282),
    HardCase("spin balance: both races in full spin",
        "the spin's torque where all divisions of the spin give the same moment",
        "3/8 mu Q b times the spin, however it is divided", lambda: float(balanced(0.83).spin), 0.0103926375),
    HardCase("load: radial, zero angle", "Z Q/Fr of the heaviest of 9 balls without clearance at contact angle 0",
        "Z over the sum of (cos psi)^(5/2) over the loaded half, by 40 digits", lambda: heaviest(9),
        4.3852080236186246584, tolerance=(1e-11, "the ring settles to 1e-12 of its loads")),
    HardCase("load: radial, 400 balls", "the same of 400 balls",
        "Stribeck's 4.37: 2 pi over the integral of (cos psi)^(5/2), by 40 digits", lambda: heaviest(400),
        4.3700959238201996841,
        tolerance=(1e-8, "a sum for an integral that ends as a power of 5/2: 0.012 h^(7/2), h = 2 pi/400")),
    HardCase("torque: radial load, zero angle", "the share of spin in the torque",
        "0: a ball that rolls about an axis parallel to the bearing's does not spin", lambda: spin_without_angle(),
        0.0),
    HardCase("torque: spin at vanishing load",
        "the exponent of the spin's torque over the thrust from a free angle of 0.18 rad",
        "4/3: the load Q goes as Fa, the semi-axis as Q^(1/3), and the balls are in full spin",
        lambda: exponent(lambda load: torque("spin", load), 1e-9, 1e-8), 4 / 3, tolerance=VANISHING),
    HardCase("torque: conformity at vanishing load",
        "its exponent under outer control, where eps of the inner race grows without limit",
        "5/3, as Q b^2 of the outer race: the inner race is in full spin, which leaves no conformity part",
        lambda: exponent(lambda load: torque("conformity", load, spin_rule="outer_control"), 1e-9, 1e-8), 5 / 3,
        tolerance=VANISHING),
    HardCase("torque: hysteresis at vanishing load",
        "the exponent of the hysteresis torque over the thrust from a free angle of 0.18 rad",
        "4/3, as Q a, and a goes as Q^(1/3)", lambda: exponent(lambda load: torque("hysteresis", load), 1e-9, 1e-8),
        4 / 3, tolerance=VANISHING),
    HardCase("torque: spin from an angle of zero", "the exponent of the spin's torque from a free angle of 0",
        "5/4: Q^(4/3) goes as Fa, for Q goes as Fa^(3/4), and the angle as Fa^(1/4)",
        lambda: exponent(lambda load: torque("spin", load, contact_angle=ZERO), 1e-10, 1e-9), 1.25,
        tolerance=VANISHING),
    HardCase("torque: conformity from an angle of zero",
        "the exponent of the conformity's torque from a free angle of 0",
        "5/4: Q^(5/3) with Q as Fa^(3/4); eps, the angle over b, is constant",
        lambda: exponent(lambda load: torque("conformity", load, contact_angle=ZERO), 1e-10, 1e-9), 1.25,
        tolerance=VANISHING),
    HardCase("torque: hysteresis from an angle of zero", "the exponent of the hysteresis torque from a free angle of 0",
        "1: Q^(4/3) with Q as Fa^(3/4)",
        lambda: exponent(lambda load: torque("hysteresis", load, contact_angle=ZERO), 1e-10, 1e-9), 1.0,
        tolerance=VANISHING),
    HardCase("torque: preload without thrust", "the torque of a preloaded bearing at 1e-12 N over that at 1e-9 N",
        "1: the preload loads the balls, and their torque does not vanish with the thrust",
        lambda: preloaded(1e-12) / preloaded(1e-9), 1.0,
        tolerance=(1e-9, "an axial load of 1e-9 N beside ball loads of hundreds")),
    HardCase("torque: reversed rotation", "the torque at -296 rpm over that at 296 rpm", "1, by symmetry",
        lambda: torque("total", 700.0, speed=-31.0) / torque("total", 700.0, speed=31.0), 1.0),
    HardCase("torque: at standstill", "the torque at 0 rpm, where slip power over speed is 0/0, over that at 296 rpm",
        "1: Coulomb friction and the hysteresis loss do not depend on speed",
        lambda: torque("total", 700.0, speed=0.0) / torque("total", 700.0, speed=31.0), 1.0),
    HardCase("torque: no friction", "the torque without friction over the hysteresis with it",
        "1: only the hysteresis remains, which does not depend on friction",
        lambda: torque("total", 700.0, friction_coefficient=0.0) / torque("hysteresis", 700.0), 1.0),
    HardCase("torque: thrust at zero angle", "a contact angle held at 0 under thrust",
        "a refusal: no ball load balances it",
        lambda: torque("total", 700.0, contact_angle=ContactAngle(rule="given", value=0.0)),
        refusal="must lie between 0 and pi/2 rad, got 0.0"),
    HardCase("torque: over the shoulder", "1e9 N of thrust", "a refusal: the contact leaves the groove",
        lambda: torque("total", 1e9), refusal="beyond the inner race's shoulder"),
    HardCase("torque: groove as wide as the ball", "the same at conformity 0.5", "a refusal: the contact is a line",
        lambda: conformity_torque(with_conformity(0.5)), refusal="at conformity 0.5 the contact is a line"),
    HardCase("torque: clearance 1e-12 m", "the torque under thrust at a clearance of 1e-12 m over that without",
        "1: no clearance is no exception",
        lambda: torque("total", 700.0, contact_angle=SOLVED, bearing=with_clearance(1e-12)) / torque("total", 700.0,
            contact_angle=SOLVED, bearing=with_clearance(0.0)), 1.0,
        tolerance=(1e-7, "1e-12 m changes the ball's load by 1e-8")),
    HardCase("torque: ellipse up to the shoulder", "the load beyond a shoulder 1e-12 of a semi-axis past the ellipse",
        "0: nothing is cut off", lambda: beyond_the_shoulder(ELLIPSE_END * (1 + 1e-12)), 0.0),
    HardCase("torque: ellipse past the shoulder", "the load beyond a shoulder at 0.6 mm under an ellipse to 3.7 mm",
        "1/2 - (3 u - u^3)/4 with u the distance over the semi-axis, by 40 digits",
        lambda: beyond_the_shoulder(0.6e-3), 0.37851465908862662285, tolerance=RING),
    HardCase("torque: 1e-6 N at 500 rpm", "1e-6 N of thrust on a bearing in oil that turns", "a refusal: it skids",
        hardly_loaded,
        refusal="raise the load or lower the speed"),
    HardCase("scene: a load in mm", 'axial_load = "700 mm"', "a refusal that names the key and its unit",
        lambda: parsed(load="700 mm"), refusal="operation.axial_load"),
    HardCase("scene: a speed of infinity", 'inner_speed = "inf rpm"', "a refusal that names the key",
        lambda: parsed(speed="inf rpm"), refusal="operation.inner_speed"),
    HardCase("scene: a load that is not a number", 'axial_load = "nan N"', "a refusal that names the key",
        lambda: parsed(load="nan N"), refusal="operation.axial_load"),
    HardCase("scene: no load at all", 'axial_load = "0 N", and no other load',
        "a refusal: without load there is no contact and no torque", lambda: parsed(load="0 N"),
        refusal="leaves a point without any load"),
    HardCase("scene: an unknown key", "the key inner_sped", "a refusal with the key that was probably meant",
        lambda: parsed(speed_key="inner_sped"),
        refusal="operation.inner_sped = '90 rpm' is an unknown key; did you mean inner_speed?"),
    HardCase("scene: a missing key", "no inner_speed", "a refusal that names the key: a missing speed is not 0",
        lambda: parsed(speed_key="# inner_speed"), refusal="operation.inner_speed is missing"),
)  # fmt: skip
