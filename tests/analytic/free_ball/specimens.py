"""Bearings of the published check values, and free balls under thrust with Coulomb friction."""

from dataclasses import replace

import numpy as np

from analytic.free_ball.rotation import Creep, FreeTurning, Nodes, Surfaces
from analytic.loads.balls import LoadedBalls, LoadEffects, loaded_balls
from analytic.oil.traction import CoulombTraction
from analytic.scene import Bearing, ContactAngle, Groove, Operation
from tests.analytic.specimens import BEARING_6205
from tests.contacts import STEEL

FINE = Nodes(32, 24)
DIAMETER, PITCH, FREE_ANGLE = 11.906e-3, 60e-3, np.radians(40)


def angular_contact() -> Bearing:
    """13 balls of 11.906 mm at 40 degrees, grooves of 0.52 and 0.53 ball diameters."""
    play = 2 * (0.52 + 0.53 - 1) * DIAMETER * (1 - np.cos(FREE_ANGLE))
    inner, outer = (
        Groove(
            bottom_radius=(PITCH + side * (DIAMETER + play / 2)) / 2,
            groove_radius=conformity * DIAMETER,
            shoulder_half_width=5.5e-3,
            material=STEEL,
        )
        for side, conformity in ((-1, 0.52), (1, 0.53))
    )
    mass = 7850 * np.pi / 6 * DIAMETER**3
    return replace(BEARING_6205, ball_count=13, ball_diameter=DIAMETER, ball_mass=mass, inner=inner, outer=outer)


def under_thrust(
    bearing: Bearing, free_angle: float | None, *, load: float, speed: float, friction: float, creep: Creep
) -> tuple[LoadedBalls, FreeTurning]:
    operation = Operation(axial_load=np.array([load]), inner_speed=np.array([speed])).as_series()
    law = CoulombTraction(friction_coefficient=friction)
    turning = FreeTurning(
        bearing, (law, law), inner_speed=operation.inner_speed, balls=None, surfaces=Surfaces(creep, FINE)
    )
    angle = ContactAngle(rule="solved", free=free_angle)
    return loaded_balls(bearing, angle, operation, LoadEffects(), turning=turning), turning


def torque(turning: FreeTurning) -> float:
    """Of all balls alike, N m."""
    return float(turning.bearing.ball_count * turning.balls().torque.sum())
