"""Hard cases of the numerical friction of a ball: vanishing and one-sided loads, extreme bodies, and slip all over."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.oil.traction import PointLaw
from analytic.scene import Lubricant, Operation, Reach, Scene
from analytic.scenefile.read import load_scene
from fembearing.check.creep.scene_creep import CreepNumbers, creep_of
from fembearing.creep.ball import Grid, TurnedBall, TurningBall, turn_ball
from fembearing.creep.friction import sliding_law
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.place import HeldBall
from fembearing.creep.rolling import Creepages, RollingFriction, rolling_friction, rolling_surfaces
from fembearing.creep.strips import ellipse_strips, hertz_pressure
from validation.hard.specimens import (
    BEARING,
    CERAMIC,
    NEARLY_INCOMPRESSIBLE,
    PEEK,
    SCENE_6205,
    exponent,
    of_materials,
    with_clearance,
    with_conformity,
)

FRICTION = 0.1
A, B, LOAD = 0.11e-3, 0.83e-3, 530.0  # m, m, N: one contact
PRESSED_SOLID = PointLaw(limit=FRICTION, eyring=5e6, fluidity=1e60)  # oil that shears at its limit wherever it slides


def thrust_ball(load: float, *, law: PointLaw | None = None, angle: float | None = None) -> TurnedBall:
    """A ball under so much thrust, N, at rest; angle : held, rad; None: it follows from a free angle of 0.18 rad."""
    radial = None if angle is not None else BEARING.groove_centre_distance * float(np.cos(0.18))
    centre = BEARING.outer.bottom_radius - BEARING.outer.groove_radius
    held = HeldBall(bearing=BEARING, centre=centre, thrust=load, radial=radial, angle=angle)
    each = PointLaw(boundary=FRICTION) if law is None else law
    ball = TurningBall(held=held, laws=(each, each), speed=31.0, inertia=False)
    return turn_ball(ball, Grid(12, 6), turn_ball(ball, Grid(8, 4)))


def sliding(creepages: Creepages) -> RollingFriction:
    """One contact of steel under these creepages."""
    strips = ellipse_strips(semi_axis_rolling=A, semi_axis_transverse=B, count=24, cells=8)
    steel = BEARING.ball_material
    pressure = hertz_pressure(strips, load=LOAD)
    law = sliding_law(PointLaw(boundary=FRICTION), pressure=pressure, speed=0.37)
    surfaces = rolling_surfaces(strips, HalfSpaces(ball=steel, race=steel))
    return rolling_friction(surfaces, creepages, pressure=pressure, law=law)


def dry(*, load: float = 400.0, speed: float = 31.0, friction: float = FRICTION, **changed: Any) -> Scene:
    """The dry 6205 under thrust, N, at an inner speed, rad/s; `changed` replaces other fields."""
    operation = Operation(axial_load=np.array([load]), inner_speed=np.array([speed]))
    return replace(SCENE_6205, operation=operation, cage=None, friction_coefficient=friction, **changed)


def numbers(**changed: Any) -> CreepNumbers:
    """All balls by all methods; arguments of `dry`."""
    return creep_of(dry(**changed), tolerance=0.1).numbers


def by_reference(**changed: Any) -> float:
    """Torque by sliding, N m; arguments of `dry`."""
    return numbers(**changed).torque.reference


def methods(**changed: Any) -> float:
    """Production over the reference; arguments of `dry`."""
    torque = numbers(**changed).torque
    return torque.production / torque.reference


def oil_of(**changed: Any) -> float:
    """Torque by sliding of the shipped scene in oil, N m; `changed` replaces fields of its lubricant."""
    scene = load_scene("paper_6205")
    lubricant: Lubricant = replace(scene.lubricant, **changed)  # pyright: ignore[reportArgumentType]
    operation = Operation(axial_load=np.array([400.0]), inner_speed=np.array([31.0]))
    scene = replace(scene, lubricant=lubricant, operation=operation, cage=None)
    return creep_of(scene, tolerance=0.1).numbers.torque.reference


NUMERICAL_FRICTION_CASES: dict[str, Callable[[], float]] = {
    "numerical friction: conformity 0.5005": lambda: methods(bearing=with_conformity(0.5005)),
    "numerical friction: Poisson ratio 0.49": lambda: methods(bearing=of_materials(*[NEARLY_INCOMPRESSIBLE] * 2)),
    "numerical friction: ceramic on PEEK": lambda: methods(load=20.0, bearing=of_materials(CERAMIC, PEEK)),
    "numerical friction: 1e-6 N": lambda: exponent(lambda load: thrust_ball(load, angle=0.18).torque, 1e-6, 2e-6),
    "numerical friction: 1e-4 N on a free ring": lambda: exponent(
        lambda load: by_reference(load=load, speed=1e-6), 1e-4, 1e-3
    ),
    "numerical friction: 1e-12 N": lambda: thrust_ball(1e-12).torque,
    "numerical friction: clearance 1e-12 m": lambda: (
        by_reference(bearing=with_clearance(1e-12)) / by_reference(bearing=with_clearance(0.0))
    ),
    "numerical friction: reversed": lambda: by_reference(speed=-31.0) / by_reference(),
    "numerical friction: at standstill": lambda: by_reference(speed=0.0),
    "numerical friction: no friction": lambda: by_reference(friction=0.0),
    "numerical friction: slides along": lambda: sliding(Creepages(along=30.0)).force_along / (FRICTION * LOAD),
    "numerical friction: slides in a spin": lambda: sliding(Creepages(spin=30 / B)).spin_moment / (FRICTION * LOAD * B),
    "numerical friction: skidding": lambda: by_reference(load=2.0, speed=8000.0),
    "numerical friction: oil pressed solid": lambda: (
        thrust_ball(40.0, law=PRESSED_SOLID).torque / thrust_ball(40.0).torque
    ),
    "numerical friction: inlet shorter than the contact": lambda: (
        oil_of(reach=Reach(ahead=1e-3)) / oil_of(starvation_degree=1.0)
    ),
    "numerical friction: groove as wide as the ball": lambda: by_reference(bearing=with_conformity(0.5)),
}
