"""Specimens of the cage: that of a 6205 in a scene, and driven at 500 rpm; and the raceways under its balls."""

from dataclasses import replace
from typing import Any

import numpy as np

from analytic.cage.raceways import RaceContacts, Raceways, thrust_raceways
from analytic.cage.steady import DrivenCage
from analytic.cage.torque import driven_cage
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus, hertz_contact
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import ContactAngle, Operation, Scene
from tests.analytic.specimens import AS_HERTZ, BEARING_6205, STAMPED_CAGE, balls_of
from tests.contacts import STEEL

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


ANGLE = ContactAngle(rule="solved", free=0.18)


def races_under_thrust(*, axial_load: float = 1000.0, rpm: float = 500.0, friction: float = 0.1) -> Raceways:
    """Raceways of a 6205 with a free contact angle of 0.18 rad."""
    speed = rpm * RPM
    operation = Operation(axial_load=np.array([axial_load]), inner_speed=np.array([speed]))
    balls = balls_of(replace(CAGED, contact_angle=ANGLE, operation=operation, spin_rule="balanced"))[0]
    return thrust_raceways(BEARING_6205, balls, inner_speed=speed, friction=(friction, friction))


def races_under(
    loads: tuple[float, float], angles: tuple[float, float], *, inner_speed: float, friction: float
) -> Raceways:
    """Raceways of a 6205 whose balls all have these loads, N, and angles, rad, on the inner and the outer race."""
    pairs = [
        race_curvatures(BEARING_6205, race, contact_angle=np.array([angle]))
        for race, angle in zip(("inner", "outer"), angles, strict=True)
    ]
    rolling, transverse = (np.stack(values) for values in zip(*pairs, strict=True))
    load = np.reshape(loads, (2, 1))
    contact = hertz_contact(
        curvature_x=rolling, curvature_y=transverse, load=load, modulus=contact_modulus(STEEL, STEEL)
    )
    contacts = RaceContacts(load=load, contact_angle=np.reshape(angles, (2, 1)), contact=contact)
    return Raceways(bearing=BEARING_6205, contacts=contacts, friction=(friction, friction), inner_speed=inner_speed)


def cage_on(races: Raceways, *, friction: float = 0.1, **changed: Any) -> DrivenCage:
    """The stamped cage at the speed of these races, with 0.2 mm of clearance."""
    angle = float(races.contacts.contact_angle.mean())
    moving = ball_kinematics(races.inner_speed, angle, angle, BEARING_6205.pitch_diameter, BEARING_6205.ball_diameter)
    cage = driven_cage(
        BEARING_6205,
        STAMPED_CAGE,
        friction_coefficient=friction,
        inner_speed=races.inner_speed,
        orbit_speed=float(moving.cage_speed),
        ball_speed=float(moving.ball_speed),
        contact_angle=angle,
    )
    return replace(cage, **changed)
