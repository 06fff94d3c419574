"""Hard cases of the friction of ball on race: micro-slip at its limits, torque over load, mistakes in scene files."""

import math
from dataclasses import replace
from typing import Any

from analytic.contact.rolling_contact import RollingContact
from analytic.loads.ring import ring_equilibrium
from analytic.scene import ContactAngle
from analytic.sliding.long_ellipse import MicroslipTorque, microslip_moments, microslip_torque
from validation.hard.case import HardCase
from validation.hard.specimens import exponent, parsed, torque_6205, with_clearance

VANISHING = (1e-6, "the next term, the square of a change of angle below 1e-4, and less")
FREE, ZERO = ContactAngle(rule="solved", free=0.18), ContactAngle(rule="solved", free=0.0)


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
    inner = RollingContact(
        load=530.0,
        semi_axis_rolling=0.11e-3,
        semi_axis_transverse=0.9e-3,
        curvature_rolling=310.0,
        curvature_transverse=14.7,
        modulus=1.13e11,
        deformed_radius=3.7e-3,
        rolling_rate=2.9,
    )
    outer = replace(inner, semi_axis_transverse=math.nextafter(0.9e-3, 1.0))
    forces = 0.07 * 530.0, 0.07 * 530.0
    return microslip_torque(
        (inner, outer), friction_force=forces, spin_difference=spin_difference, spin_rule="balanced"
    )


def heaviest(ball_count: int) -> float:
    """Z Q/Fr of the ball in line with a radial load, without clearance, at contact angle 0."""
    bearing, load = replace(with_clearance(0.0), ball_count=ball_count), 640.0
    ring = ring_equilibrium(bearing, ZERO, radial_load_x=load)
    return ball_count * float(ring.inner_load.max()) / load


def spin_without_angle() -> float:
    """Share of the spin in the torque of the 6205 under a radial load alone, without clearance."""
    parts = torque_6205(radial_load=640.0, contact_angle=ZERO, bearing=with_clearance(0.0)).torque
    assert parts.spin is not None
    return float(parts.spin[0] / parts.total[0])


FRICTION_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="micro-slip: no spin",
        problem="the rolling moment at exactly no spin",
        answer="pure rolling at -/+g with g^3 - 3 g + 1 = 0: (2/5 - 2 g^3 (1 - 3 g^2/5))/4, by 40 digits",
        evaluate=lambda: rolling(0.0),
        expected=0.080571198872177867677,
    ),
    HardCase(
        name="micro-slip: vanishing spin",
        problem="spin moment over spin at eps = 1e-12",
        answer="3 g (1 - g^2), the slope at eps = 0, by 40 digits",
        evaluate=lambda: spin(1e-12) / 1e-12,
        expected=0.91622186799683581378,
    ),
    HardCase(
        name="micro-slip: full spin",
        problem="the spin moment at eps = 1/2, where one line of pure rolling leaves the contact",
        answer="3/8: the whole contact spins about its centre",
        evaluate=lambda: spin(0.5),
        expected=0.375,
    ),
    HardCase(
        name="micro-slip: far beyond full spin",
        problem="the spin moment at eps = 1e9",
        answer="3/8, as at 1/2: Coulomb friction does not depend on speed",
        evaluate=lambda: spin(1e9),
        expected=0.375,
    ),
    HardCase(
        name="micro-slip: the end of rolling",
        problem="the rolling moment over (1 - 2 eps)^2 as eps approaches 1/2 from below",
        answer="3/4: the outer line of pure rolling is (1 - 2 eps) from the edge, to first order",
        evaluate=lambda: rolling(0.5 - 5e-6) / (1e-5) ** 2,
        expected=0.75,
        tolerance=(1e-4, "the next term, relative, is a few times 1 - 2 eps = 1e-5"),
    ),
    HardCase(
        name="micro-slip: negative spin",
        problem="the spin moment at eps = -0.31 over that at 0.31",
        answer="-1, by symmetry",
        evaluate=lambda: spin(-0.31) / spin(0.31),
        expected=-1.0,
    ),
    HardCase(
        name="micro-slip: continuity at full spin",
        problem="the spin moment just below eps = 1/2 over that just above",
        answer="1: the difference is the square of the distance, 1e-9",
        evaluate=lambda: spin(0.5 - 1e-9) / spin(0.5 + 1e-9),
        expected=1.0,
    ),
    HardCase(
        name="micro-slip: continuity at full negative spin",
        problem="the same at eps = -1/2",
        answer="1",
        evaluate=lambda: spin(-0.5 + 1e-9) / spin(-0.5 - 1e-9),
        expected=1.0,
    ),
    HardCase(
        name="spin balance: nearly equal races",
        problem="the spin's torque where a semi-axis differs by 1e-16 and both races are close to full spin",
        answer="half of the spin each: 3 eps d (1 - eps^2 - d^2) with d^3 - 3 (1 - eps^2) d + 1 = 0, by 40 digits",
        evaluate=lambda: float(balanced(0.69).spin),
        expected=0.0086241907747470239282,
    ),
    HardCase(
        name="spin balance: both races in full spin",
        problem="the spin's torque where all divisions of the spin give the same moment",
        answer="3/8 mu Q b times the spin, however it is divided",
        evaluate=lambda: float(balanced(0.83).spin),
        expected=0.0103926375,
    ),
    HardCase(
        name="load: radial, zero angle",
        problem="Z Q/Fr of the heaviest of 9 balls without clearance at contact angle 0",
        answer="Z over the sum of (cos psi)^(5/2) over the loaded half, by 40 digits",
        evaluate=lambda: heaviest(9),
        expected=4.3852080236186246584,
        tolerance=(1e-11, "the ring settles to 1e-12 of its loads"),
    ),
    HardCase(
        name="load: radial, 400 balls",
        problem="the same of 400 balls",
        answer="Stribeck's 4.37: 2 pi over the integral of (cos psi)^(5/2), by 40 digits",
        evaluate=lambda: heaviest(400),
        expected=4.3700959238201996841,
        tolerance=(1e-8, "a sum for an integral that ends as a power of 5/2: 0.012 h^(7/2), h = 2 pi/400"),
    ),
    HardCase(
        name="torque: radial load, zero angle",
        problem="the share of spin in the torque",
        answer="0: a ball that rolls about an axis parallel to the bearing's does not spin",
        evaluate=lambda: spin_without_angle(),
        expected=0.0,
    ),
    HardCase(
        name="torque: spin at vanishing load",
        problem="the exponent of the spin's torque over the thrust from a free angle of 0.18 rad",
        answer="4/3: the load Q goes as Fa, the semi-axis as Q^(1/3), and the balls are in full spin",
        evaluate=lambda: exponent(lambda load: torque("spin", load), 1e-9, 1e-8),
        expected=4 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: conformity at vanishing load",
        problem="its exponent under outer control, where eps of the inner race grows without limit",
        answer="5/3, as Q b^2 of the outer race: the inner race is in full spin, which leaves no conformity part",
        evaluate=lambda: exponent(lambda load: torque("conformity", load, spin_rule="outer_control"), 1e-9, 1e-8),
        expected=5 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: hysteresis at vanishing load",
        problem="the exponent of the hysteresis torque over the thrust from a free angle of 0.18 rad",
        answer="4/3, as Q a, and a goes as Q^(1/3)",
        evaluate=lambda: exponent(lambda load: torque("hysteresis", load), 1e-9, 1e-8),
        expected=4 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: spin from an angle of zero",
        problem="the exponent of the spin's torque from a free angle of 0",
        answer="5/4: Q^(4/3) goes as Fa, for Q goes as Fa^(3/4), and the angle as Fa^(1/4)",
        evaluate=lambda: exponent(lambda load: torque("spin", load, contact_angle=ZERO), 1e-10, 1e-9),
        expected=1.25,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: conformity from an angle of zero",
        problem="the exponent of the conformity's torque from a free angle of 0",
        answer="5/4: Q^(5/3) with Q as Fa^(3/4); eps, the angle over b, is constant",
        evaluate=lambda: exponent(lambda load: torque("conformity", load, contact_angle=ZERO), 1e-10, 1e-9),
        expected=1.25,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: hysteresis from an angle of zero",
        problem="the exponent of the hysteresis torque from a free angle of 0",
        answer="1: Q^(4/3) with Q as Fa^(3/4)",
        evaluate=lambda: exponent(lambda load: torque("hysteresis", load, contact_angle=ZERO), 1e-10, 1e-9),
        expected=1.0,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: preload without thrust",
        problem="the torque of a preloaded bearing at 1e-12 N over that at 1e-9 N",
        answer="1: the preload loads the balls, and their torque does not vanish with the thrust",
        evaluate=lambda: preloaded(1e-12) / preloaded(1e-9),
        expected=1.0,
        tolerance=(1e-9, "an axial load of 1e-9 N beside ball loads of hundreds"),
    ),
    HardCase(
        name="torque: reversed rotation",
        problem="the torque at -296 rpm over that at 296 rpm",
        answer="1, by symmetry",
        evaluate=lambda: torque("total", 700.0, speed=-31.0) / torque("total", 700.0, speed=31.0),
        expected=1.0,
    ),
    HardCase(
        name="torque: at standstill",
        problem="the torque at 0 rpm, where slip power over speed is 0/0, over that at 296 rpm",
        answer="1: Coulomb friction and the hysteresis loss do not depend on speed",
        evaluate=lambda: torque("total", 700.0, speed=0.0) / torque("total", 700.0, speed=31.0),
        expected=1.0,
    ),
    HardCase(
        name="torque: no friction",
        problem="the torque without friction over the hysteresis with it",
        answer="1: only the hysteresis remains, which does not depend on friction",
        evaluate=lambda: torque("total", 700.0, friction_coefficient=0.0) / torque("hysteresis", 700.0),
        expected=1.0,
    ),
    HardCase(
        name="torque: thrust at zero angle",
        problem="a contact angle held at 0 under thrust",
        answer="a refusal: no ball load balances it",
        evaluate=lambda: torque("total", 700.0, contact_angle=ContactAngle(rule="given", value=0.0)),
        refusal="must lie between 0 and pi/2 rad, got 0.0",
    ),
    HardCase(
        name="torque: over the shoulder",
        problem="1e9 N of thrust",
        answer="a refusal: the contact leaves the groove",
        evaluate=lambda: torque("total", 1e9),
        refusal="beyond the inner race's shoulder",
    ),
    HardCase(
        name="scene: a load in mm",
        problem='axial_load = "700 mm"',
        answer="a refusal that names the key and its unit",
        evaluate=lambda: parsed(load="700 mm"),
        refusal="operation.axial_load",
    ),
    HardCase(
        name="scene: a speed of infinity",
        problem='inner_speed = "inf rpm"',
        answer="a refusal that names the key",
        evaluate=lambda: parsed(speed="inf rpm"),
        refusal="operation.inner_speed",
    ),
    HardCase(
        name="scene: a load that is not a number",
        problem='axial_load = "nan N"',
        answer="a refusal that names the key",
        evaluate=lambda: parsed(load="nan N"),
        refusal="operation.axial_load",
    ),
    HardCase(
        name="scene: no load at all",
        problem='axial_load = "0 N", and no other load',
        answer="a refusal: without load there is no contact and no torque",
        evaluate=lambda: parsed(load="0 N"),
        refusal="leaves a point without any load",
    ),
    HardCase(
        name="scene: an unknown key",
        problem="the key inner_sped",
        answer="a refusal with the key that was probably meant",
        evaluate=lambda: parsed(speed_key="inner_sped"),
        refusal="operation.inner_sped = '90 rpm' is an unknown key; did you mean inner_speed?",
    ),
    HardCase(
        name="scene: a missing key",
        problem="no inner_speed",
        answer="a refusal that names the key: a missing speed is not 0",
        evaluate=lambda: parsed(speed_key="# inner_speed"),
        refusal="operation.inner_speed is missing",
    ),
)
