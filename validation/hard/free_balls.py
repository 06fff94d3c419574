"""Hard cases of free balls: standstill, vanishing and one-sided loads, the highest speeds, no friction and much."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.loads.kinematics import ball_motion
from analytic.result import FrictionTorque
from analytic.scene import Operation, Scene
from analytic.solve.model import model_of
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from validation.hard.friction import FREE
from validation.hard.specimens import SCENE_6205, exponent

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


FREE_BALL_CASES: dict[str, Callable[[], float]] = {
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
