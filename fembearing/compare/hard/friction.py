"""Hard cases of the friction of ball on race: micro-slip at its limits, how torque grows with the load, scene files."""

import math
from dataclasses import replace

import numpy as np

from analytic.contact.rolling_contact import RollingContact
from analytic.loads.ring import ring_equilibrium
from analytic.scene import Bearing, ContactAngle, Decision, Operation, SpinRule
from analytic.scenefile.read import builtin_scene, load_scene, parse_scene
from analytic.sliding.long_ellipse import MicroslipTorque, microslip_moments, microslip_torque
from analytic.torque import friction_torque
from fembearing.compare.hard.case import HardCase
from fembearing.compare.hard.contacts import ROUND_OFF, exponent, with_clearance

VANISHING = (1e-6, "the next term, the square of a change of angle below 1e-4, and less")
# The limits are those of the text books' forms, at loads that no speed would leave to them.
AS_HERTZ: dict[str, Decision] = {
    "spin": "on",
    "finite_geometry": "off",
    "centrifugal": "off",
    "gyroscopic": "off",
    "cage": "off",
}
SCENE = """
name = "a scene with a mistake"
tolerance = "5 %"
[bearing]
catalog = "6205"
contact_angle = {{ rule = "solved" }}
[operation]
axial_load = "{load}"
{speed_key} = "{speed}"
"""


def spin(spin_to_roll: float) -> float:
    """M_spin/(mu Q b) at eps."""
    return _moments(spin_to_roll)[0]


def rolling(spin_to_roll: float) -> float:
    """M_roll R/(mu Q b^2) at eps."""
    return _moments(spin_to_roll)[1]


def _moments(spin_to_roll: float) -> tuple[float, float]:
    mu, load, semi_axis, radius = 0.07, 530.0, 0.9e-3, 3.7e-3
    found = microslip_moments(
        friction_force=mu * load,
        semi_axis_transverse=semi_axis,
        deformed_radius=radius,
        spin_to_roll=spin_to_roll,
    )
    size = mu * load * semi_axis
    return float(found[0]) / size, float(found[1]) * radius / (size * semi_axis)


def torque(
    part: str,
    load: float,
    *,
    free: float | None = 0.18,
    rule: SpinRule = "balanced",
    of: Bearing | None = None,
    speed: float = 31.0,
    friction_coefficient: float = 0.1,
    given: float | None = None,
) -> float:
    """One part of the 6205's torque, N m, under an axial load, N; `given` is a contact angle that is held, rad."""
    scene = load_scene(builtin_scene("6205"))
    angle = ContactAngle(rule="solved", free=free) if given is None else ContactAngle(rule="given", value=given)
    asked = replace(
        scene,
        bearing=of or scene.bearing,
        contact_angle=angle,
        operation=replace(scene.operation, axial_load=np.array([load]), inner_speed=np.array([speed])),
        friction_coefficient=friction_coefficient,
        spin_rule=rule,
        effects=AS_HERTZ,
    )
    return float(getattr(friction_torque(asked).torque, part)[0])


def preloaded(load: float) -> float:
    """Race torque under 14 um of interference."""
    return torque("total", load, free=None, of=with_clearance(-14e-6))


def balanced(spin_difference: float) -> MicroslipTorque:
    """One ball that takes its own spin between races that differ in the last digit of a semi-axis."""
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
    """Z Q/Fr of the ball in line with a radial load, without clearance and at no contact angle."""
    bearing, load = replace(with_clearance(0.0), ball_count=ball_count), 640.0
    found = ring_equilibrium(bearing, ContactAngle(rule="solved", free=0.0), radial_load_x=load)
    return ball_count * float(found.inner_load.max()) / load


def spin_without_angle() -> float:
    """Share of the spin in the torque of the 6205 under a radial load alone, without clearance."""
    scene = load_scene(builtin_scene("6205"))
    asked = replace(
        scene,
        bearing=with_clearance(0.0),
        contact_angle=ContactAngle(rule="solved", free=0.0),
        operation=Operation(axial_load=np.array([0.0]), inner_speed=np.array([31.0]), radial_load=np.array([640.0])),
        effects=AS_HERTZ,
    )
    found = friction_torque(asked).torque
    assert found.spin is not None
    return float(found.spin[0] / found.total[0])


def mistaken(load: str = "700 N", speed: str = "90 rpm", speed_key: str = "inner_speed") -> float:
    """What a scene with these entries gives."""
    return parse_scene(SCENE.format(load=load, speed=speed, speed_key=speed_key), origin="scene").tolerance


FRICTION_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="micro-slip: no spin",
        asked="the rolling moment where the spin is exactly 0",
        right="lines at -/+g with g^3 - 3 g + 1 = 0: (2/5 - 2 g^3 (1 - 3 g^2/5))/4, by 40 digits",
        evaluate=lambda: rolling(0.0),
        expected=0.080571198872177867677,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: all but no spin",
        asked="spin moment over spin at eps = 1e-12, both as good as 0",
        right="3 g (1 - g^2), the slope at eps = 0, by 40 digits",
        evaluate=lambda: spin(1e-12) / 1e-12,
        expected=0.91622186799683581378,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: spin in full",
        asked="the spin moment at eps = 1/2, where one line leaves the contact",
        right="3/8: the whole contact turns about its centre",
        evaluate=lambda: spin(0.5),
        expected=0.375,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: far beyond full spin",
        asked="the spin moment at eps = 1e9",
        right="3/8, as at 1/2: Coulomb friction does not know how fast",
        evaluate=lambda: spin(1e9),
        expected=0.375,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: the end of rolling",
        asked="how the rolling moment fades as eps comes to 1/2 from below",
        right="3/4 (1 - 2 eps)^2: the outer line stands (1 - 2 eps) from the edge, to first order",
        evaluate=lambda: rolling(0.5 - 5e-6) / (1e-5) ** 2,
        expected=0.75,
        tolerance=(1e-4, "the next term, relative, is a few times 1 - 2 eps = 1e-5"),
    ),
    HardCase(
        name="micro-slip: the other sense",
        asked="the spin moment at eps = -0.31 over that at 0.31",
        right="-1: a mirror image",
        evaluate=lambda: spin(-0.31) / spin(0.31),
        expected=-1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: across full spin",
        asked="the spin moment just below eps = 1/2 over that just beyond it",
        right="1: it falls short by the square of the distance, 1e-9",
        evaluate=lambda: spin(0.5 - 1e-9) / spin(0.5 + 1e-9),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="micro-slip: across full spin in the other sense",
        asked="the same at eps = -1/2",
        right="1",
        evaluate=lambda: spin(-0.5 + 1e-9) / spin(-0.5 - 1e-9),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="spin balance: races all but alike",
        asked="the spin's torque where a semi-axis differs by 1e-16 and both races spin all but in full",
        right="half of the spin each: 3 eps d (1 - eps^2 - d^2) with d^3 - 3 (1 - eps^2) d + 1 = 0, by 40 digits",
        evaluate=lambda: float(balanced(0.69).spin),
        expected=0.0086241907747470239282,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="spin balance: both races in full spin",
        asked="the spin's torque where no share of the spin leaves less of a moment than another",
        right="3/8 mu Q b times the spin, however it is shared",
        evaluate=lambda: float(balanced(0.83).spin),
        expected=0.0103926375,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="load: radial, at no angle",
        asked="Z Q/Fr of the heaviest of 9 balls without clearance, contact angle 0",
        right="Z over the sum of (cos psi)^(5/2) over the loaded half, by 40 digits",
        evaluate=lambda: heaviest(9),
        expected=4.3852080236186246584,
        tolerance=(1e-11, "the ring settles to 1e-12 of its loads"),
    ),
    HardCase(
        name="load: radial, on very many balls",
        asked="the same of 400 balls",
        right="Stribeck's 4.37: 2 pi over the integral of (cos psi)^(5/2), by 40 digits",
        evaluate=lambda: heaviest(400),
        expected=4.3700959238201996841,
        tolerance=(1e-8, "a sum for an integral that ends as a power of 5/2: 0.012 h^(7/2), h = 2 pi/400"),
    ),
    HardCase(
        name="torque: radial load at no angle",
        asked="one and the share of spin in the torque",
        right="1: a ball that rolls about an axis parallel to the bearing's does not spin",
        evaluate=lambda: 1 + spin_without_angle(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="torque: spin at vanishing load",
        asked="the exponent of the thrust from a free angle of 0.18 rad",
        right="4/3: the load Q goes as Fa, the semi-axis as Q^(1/3), and the balls spin in full",
        evaluate=lambda: exponent(lambda load: torque("spin", load), 1e-9, 1e-8),
        expected=4 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: conformity at vanishing load",
        asked="the exponent under outer control, where eps of the inner race grows beyond all limits",
        right="5/3, Q b^2: the inner race spins in full and its part has ended, the outer one rolls at any load",
        evaluate=lambda: exponent(lambda load: torque("conformity", load, rule="outer_control"), 1e-9, 1e-8),
        expected=5 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: hysteresis at vanishing load",
        asked="the exponent of the thrust from a free angle of 0.18 rad",
        right="4/3: Q a, and a goes as Q^(1/3)",
        evaluate=lambda: exponent(lambda load: torque("hysteresis", load), 1e-9, 1e-8),
        expected=4 / 3,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: spin from an angle of zero",
        asked="its exponent where the angle itself grows from 0",
        right="5/4: Q^(4/3) goes as Fa, for Q goes as Fa^(3/4), and the angle as Fa^(1/4)",
        evaluate=lambda: exponent(lambda load: torque("spin", load, free=0.0), 1e-10, 1e-9),
        expected=1.25,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: conformity from an angle of zero",
        asked="its exponent where the angle itself grows from 0",
        right="5/4: Q^(5/3) with Q as Fa^(3/4), and eps, the angle over b, stays what it is",
        evaluate=lambda: exponent(lambda load: torque("conformity", load, free=0.0), 1e-10, 1e-9),
        expected=1.25,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: hysteresis from an angle of zero",
        asked="its exponent where the angle itself grows from 0",
        right="1: Q^(4/3) with Q as Fa^(3/4)",
        evaluate=lambda: exponent(lambda load: torque("hysteresis", load, free=0.0), 1e-10, 1e-9),
        expected=1.0,
        tolerance=VANISHING,
    ),
    HardCase(
        name="torque: preload without thrust",
        asked="the torque of a preloaded bearing at 1e-12 N over that at 1e-9 N",
        right="1: the preload carries the balls, and their torque does not vanish with the thrust",
        evaluate=lambda: preloaded(1e-12) / preloaded(1e-9),
        expected=1.0,
        tolerance=(1e-9, "an axial load of 1e-9 N beside ball loads of hundreds"),
    ),
    HardCase(
        name="torque: the other way round",
        asked="the torque at -296 rpm over that at 296 rpm",
        right="1: a mirror image",
        evaluate=lambda: torque("total", 700.0, speed=-31.0) / torque("total", 700.0, speed=31.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="torque: at standstill",
        asked="the torque at 0 rpm, where slip power and speed are 0/0, over that at 296 rpm",
        right="1: Coulomb friction and the share of energy lost know no rate",
        evaluate=lambda: torque("total", 700.0, speed=0.0) / torque("total", 700.0, speed=31.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="torque: no friction",
        asked="the torque without friction over the hysteresis with it",
        right="1: what is left is the hysteresis, which no friction changes",
        evaluate=lambda: torque("total", 700.0, friction_coefficient=0.0) / torque("hysteresis", 700.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="torque: thrust at no angle",
        asked="a contact angle held at 0 under thrust",
        right="a refusal: no ball load carries it",
        evaluate=lambda: torque("total", 700.0, given=0.0),
        refusal="must lie between 0 and pi/2 rad, got 0.0",
    ),
    HardCase(
        name="torque: over the shoulder",
        asked="1e9 N of thrust",
        right="a refusal: the contact leaves the groove",
        evaluate=lambda: torque("total", 1e9),
        refusal="beyond the inner race's shoulder",
    ),
    HardCase(
        name="scene: a load in mm",
        asked='axial_load = "700 mm"',
        right="a refusal that names the key and its unit",
        evaluate=lambda: mistaken(load="700 mm"),
        refusal="operation.axial_load",
    ),
    HardCase(
        name="scene: a speed of infinity",
        asked='inner_speed = "inf rpm"',
        right="a refusal that names the key",
        evaluate=lambda: mistaken(speed="inf rpm"),
        refusal="operation.inner_speed",
    ),
    HardCase(
        name="scene: a load that is not a number",
        asked='axial_load = "nan N"',
        right="a refusal that names the key",
        evaluate=lambda: mistaken(load="nan N"),
        refusal="operation.axial_load",
    ),
    HardCase(
        name="scene: no load at all",
        asked='axial_load = "0 N", and no other',
        right="a refusal: nothing touches, and no torque over no load is a result",
        evaluate=lambda: mistaken(load="0 N"),
        refusal="leaves a point without any load",
    ),
    HardCase(
        name="scene: a key that is none",
        asked="inner_sped",
        right="a refusal with the key that was meant",
        evaluate=lambda: mistaken(speed_key="inner_sped"),
        refusal="operation.inner_sped = '90 rpm' is an unknown key; did you mean inner_speed?",
    ),
    HardCase(
        name="scene: a missing key",
        asked="no inner_speed",
        right="a refusal that names the key: what is missing is not 0",
        evaluate=lambda: mistaken(speed_key="# inner_speed"),
        refusal="operation.inner_speed is missing",
    ),
)
