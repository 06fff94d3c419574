"""Specimens of the moving cage: the cage of a 6205 at 500 rpm, and pockets."""

from typing import Any

from analytic.cage.steady import DrivenCage
from tests.analytic.specimens import STAMPED_CAGE

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
TABLE_1: dict[str, Any] = {"half_clearance": 2.98e-3, "centre_offset": 0.14e-3}  # the paper's pocket
