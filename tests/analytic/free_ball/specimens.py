"""Bearings of the published check values, and free balls under thrust with Coulomb friction."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.free_ball.passes import FreeModel
from analytic.free_ball.rotation import Creep, Nodes, quadrature_of
from analytic.free_ball.sliding import free_settings, settled_points
from analytic.free_ball.turning import BallRows
from analytic.loads.kinematics import BallMotion
from analytic.loads.ring_rounds import SETTLED, RingLoads
from analytic.loads.ring_series import factors_of, ring_numbers
from analytic.oil.race_resistance import DRY, NO_OIL, RaceResistance
from analytic.scene import Array, Bearing, ContactAngle, Groove
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


class Turned(NamedTuple):
    """Balls under thrust, one of which stands for all."""

    load: Array  # (2,) N
    angle: Array  # (2,) rad
    rows: BallRows
    motion: dict[str, float]
    torque: float  # of all balls, N m


def under_thrust(
    bearing: Bearing, free_angle: float | None, *, load: float, speed: float, friction: float, creep: Creep
) -> Turned:
    """With Coulomb friction: every pass has the same law, and here the same nodes."""
    ring, _ = ring_numbers(bearing, ContactAngle(rule="solved", free=free_angle), down=None)
    settings = free_settings(bearing, creep=creep, inertia=(True, True))
    fine = quadrature_of(FINE, marched=creep == "marched")
    settings = settings._replace(quadratures=(fine,) * len(settings.quadratures))
    resistance = RaceResistance(DRY, DRY, False, False, friction, 0.0)
    loads = RingLoads(
        np.array([[load, 0.0, 0.0, 0.0, 0.0]]), np.array([speed]), (True, True), factors_of(ContactCorrection())
    )
    model = FreeModel(ring, resistance, settings)
    space, ends = settled_points(model, loads, NO_OIL, is_ring=False, allowed=np.array([np.inf]))
    assert ends[0, 0] == SETTLED
    motion = dict(zip(BallMotion._fields, space.balls.motion[0, 0], strict=True))
    return Turned(space.point.load[0, :, 0], space.point.angle[0, :, 0], space.balls, motion, float(ends[0, 4]))
