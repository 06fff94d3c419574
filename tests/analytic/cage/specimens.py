"""Specimens of the cage: that of a 6205 in a scene, and driven at 500 rpm; and the pocket of the paper."""

from dataclasses import replace
from typing import Any

import numpy as np

from analytic.cage.steady import DrivenCage
from analytic.scene import ContactAngle, Operation, Scene
from tests.analytic.specimens import AS_HERTZ, BEARING_6205, STAMPED_CAGE

RPM = np.pi / 30  # rad/s

W = 52.36  # rad/s: 500 rpm
RATE = 15.599 * 23.411 / (39.01 * 3.97)  # w_b/w of a 6205 at 0.18 rad
CAGE = DrivenCage(
    mass=STAMPED_CAGE.mass,
    ball_count=9,
    ball_radius=3.97e-3,
    pitch_radius=19.505e-3,
    half_clearance=0.1e-3,
    stiffness=6.0e10,
    restitution=0.8,
    friction_coefficient=0.1,
    orbit_speed=W * 15.599 / 39.01,
    ball_speed=W * RATE,
    contact_angle=0.18,
    ring_speed=W,
)
WEIGHTLESS = (0.0, 0.0, 0.0)  # gravity
CAGED = Scene(  # at 20 and 500 rpm
    bearing=BEARING_6205,
    contact_angle=ContactAngle(rule="given", value=0.18),
    operation=Operation(axial_load=np.array([1000.0, 1000.0]), inner_speed=np.array([20.0, 500.0]) * RPM),
    cage=replace(STAMPED_CAGE, seeds=2, duration=0.03),
    friction_coefficient=0.1,
    effects=AS_HERTZ,
)


def with_cage(scene: Scene, **change: Any) -> Scene:
    """The scene with another cage."""
    assert scene.cage is not None
    return replace(scene, cage=replace(scene.cage, **change))
