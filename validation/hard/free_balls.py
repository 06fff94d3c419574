"""Hard cases of free balls: standstill, vanishing and one-sided loads, the highest speeds, no friction and much."""

from dataclasses import replace
from typing import Any

import numpy as np

from analytic.loads.kinematics import ball_motion
from analytic.result import FrictionTorque
from analytic.scene import Operation, Scene
from analytic.solve.model import model_of
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from validation.hard.case import HardCase
from validation.hard.friction import FREE
from validation.hard.specimens import exponent, scene_6205

HIGHEST_SPEED = 3e6 / 39.01 * np.pi / 30  # rad/s, n d_m = 3e6 mm/min
STEADY = (1e-6, "the friction of the last two rounds differs by so much at most")


def free_scene(*, load: float = 410.0, speed: float = 83.0, friction: float = 0.07, **changed: Any) -> Scene:
    """The 6205 dry and without a cage, under thrust, with marched creep."""
    scene = replace(
        scene_6205(),
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


FREE_BALL_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("free ball: standstill", "the torque at 0 rpm over that at 1e-9 rad/s, with a friction coefficient",
        "1: slip is in proportion to the speed, and so is creep", lambda: total(speed=0.0) / total(speed=1e-9), 1.0,
        tolerance=STEADY),
    HardCase("free ball: reversed rotation", "the torque at -83 rad/s over that at 83 rad/s", "1, by symmetry",
        lambda: total(speed=-83.0) / total(speed=83.0), 1.0, tolerance=STEADY),
    HardCase("free ball: vanishing load", "the exponent of the torque over a thrust of 1 to 2 uN",
        "4/3: spin at a given angle, and creep grows with the contact as slip does",
        lambda: exponent(lambda load: total(load=load, speed=0.0), 1e-6, 2e-6), 4 / 3,
        tolerance=(2e-3, "the contact angle changes by the load's power 2/3, and conformity adds the next power")),
    HardCase("free ball: 1 mN",
        "whether the torque under 1 mN at 83 rad/s, where a ball weighs more, is above 0 and below 0.1 N mm",
        "1, it is: the ball hangs in its outer race", lambda: float(0 < total(load=1e-3) < 1e-4), 1.0),
    HardCase("free ball: n d_m of 3 million",
        "the orbital speed under 90 N over that of closed kinematics at the pitch of the ball's own axis",
        "1: both races still hold the ball", orbit_at_own_pitch, 1.0,
        tolerance=(5e-3, "slip of races of which one presses fifty times as hard as the other")),
    HardCase("free ball: skidding", "the torque at n d_m of 3 million under 2 N",
        "a refusal: the inner race cannot drive the ball against the conformity of the outer one",
        lambda: total(load=2.0, speed=HIGHEST_SPEED), refusal="Raise the load or lower the speed"),
    HardCase("free ball: no friction", "the torque at a friction coefficient of 0, without hysteresis",
        "0: nothing resists", lambda: total(friction=0.0, hysteresis_loss=0.0), 0.0),
    HardCase("free ball: much friction", "the torque at a friction coefficient of 20 over that at 40",
        "1: nothing slides, and creep that does not saturate forgets the coefficient",
        lambda: total(friction=20.0) / total(friction=40.0), 1.0,
        tolerance=(0.02, "the rims of the contacts still slide, where the pressure vanishes")),
    HardCase("free ball: one loaded ball", "the load of the heaviest of nine balls under 0.02 N aside, over 0.02 N",
        "1: with clearance one ball carries all", one_ball, 1.0,
        tolerance=(1e-3, "friction across the groove leans on the load, and the ring is in balance to 1e-6")),
)  # fmt: skip
