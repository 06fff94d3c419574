"""Hard cases of the numerical friction of a ball: vanishing and one-sided loads, extreme bodies, and slip all over."""

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
from validation.hard.case import HardCase
from validation.hard.specimens import (
    bearing,
    ceramic,
    exponent,
    nearly_incompressible,
    of_materials,
    peek,
    scene_6205,
    with_clearance,
    with_conformity,
)

FRICTION = 0.1
A, B, LOAD = 0.11e-3, 0.83e-3, 530.0  # m, m, N: one contact
SPUN = -0.38462533547742726964  # -3/8 E(1 - A^2/B^2)
PRESSED_SOLID = PointLaw(limit=FRICTION, eyring=5e6, fluidity=1e60)  # oil that shears at its limit wherever it slides

# Tolerances, relative, with their reasons
STRIPS = (2e-3, "the width of 24 strips, whose moments are those of their middles")
CLOSE = (0.05, "4 % of the reference's own, on an ellipse 60 times as long as wide")
SMALL = (2e-3, "the contact angle changes by the load's power 2/3, and conformity adds the next power")
SETTLED = (1e-3, "strips slip or do not by last digits, other ones on another processor, which moves a torque by 3e-4")
SAME_ANGLES = (1e-3, "1e-12 m changes the ball's load by 1e-8, and strips slip or do not: 3e-4 of a torque")
ALL_SLIDES = (1e-3, "the limit of the creepage: rectangles at the edge still lag behind")
METHODS = (0.03, "1.6 % of the reference's own, and tractions that change the pressure between unlike bodies")


def thrust_ball(load: float, *, law: PointLaw | None = None, angle: float | None = None) -> TurnedBall:
    """A ball under so much thrust, N, at rest; angle : held, rad; None: it follows from a free angle of 0.18 rad."""
    radial = None if angle is not None else bearing().groove_centre_distance * float(np.cos(0.18))
    centre = bearing().outer.bottom_radius - bearing().outer.groove_radius
    held = HeldBall(bearing=bearing(), centre=centre, thrust=load, radial=radial, angle=angle)
    each = PointLaw(boundary=FRICTION) if law is None else law
    ball = TurningBall(held=held, laws=(each, each), speed=31.0, inertia=False)
    return turn_ball(ball, Grid(12, 6), turn_ball(ball, Grid(8, 4)))


def sliding(creepages: Creepages) -> RollingFriction:
    """One contact of steel under these creepages."""
    strips = ellipse_strips(semi_axis_rolling=A, semi_axis_transverse=B, count=24, cells=8)
    steel = bearing().ball_material
    pressure = hertz_pressure(strips, load=LOAD)
    law = sliding_law(PointLaw(boundary=FRICTION), pressure=pressure, speed=0.37)
    surfaces = rolling_surfaces(strips, HalfSpaces(ball=steel, race=steel))
    return rolling_friction(surfaces, creepages, pressure=pressure, law=law)


def dry(*, load: float = 400.0, speed: float = 31.0, friction: float = FRICTION, **changed: Any) -> Scene:
    """The dry 6205 under thrust, N, at an inner speed, rad/s; `changed` replaces other fields."""
    operation = Operation(axial_load=np.array([load]), inner_speed=np.array([speed]))
    return replace(scene_6205(), operation=operation, cage=None, friction_coefficient=friction, **changed)


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


NUMERICAL_FRICTION_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("numerical friction: conformity 0.5005", "production over the reference where the ball fills its grooves",
        "1, by two methods: strips of their own stiffness, and half spaces",
        lambda: methods(bearing=with_conformity(0.5005)), 1.0, tolerance=CLOSE),
    HardCase("numerical friction: Poisson ratio 0.49", "the same at Poisson ratio 0.49", "1, by two methods",
        lambda: methods(bearing=of_materials(*[nearly_incompressible()] * 2)), 1.0, tolerance=METHODS),
    HardCase("numerical friction: ceramic on PEEK", "production over the reference for Si3N4 on PEEK under 20 N",
        "1, by two methods", lambda: methods(load=20.0, bearing=of_materials(ceramic(), peek())), 1.0,
        tolerance=METHODS),
    HardCase("numerical friction: 1e-6 N", "the exponent of the torque over the load, from 1e-6 to 2e-6 N at 0.18 rad",
        "4/3: spin at a given angle, and creep grows with the contact as slip does",
        lambda: exponent(lambda load: thrust_ball(load, angle=0.18).torque, 1e-6, 2e-6), 4 / 3, tolerance=SMALL),
    HardCase("numerical friction: 1e-4 N on a free ring", "the same from 1e-4 to 1e-3 N, whose angle is free",
        "4/3, where friction moves a ball a hundred times as far round its grooves as the approach",
        lambda: exponent(lambda load: by_reference(load=load, speed=1e-6), 1e-4, 1e-3), 4 / 3, tolerance=SMALL),
    HardCase("numerical friction: 1e-12 N", "1e-12 N of thrust: the approach is below the digits of the ball's place",
        "a refusal with the remedy", lambda: thrust_ball(1e-12).torque, refusal="or more load"),
    HardCase("numerical friction: clearance 1e-12 m", "the torque at a clearance of 1e-12 m over that without",
        "1: no clearance is no exception",
        lambda: by_reference(bearing=with_clearance(1e-12)) / by_reference(bearing=with_clearance(0.0)), 1.0,
        tolerance=SAME_ANGLES),
    HardCase("numerical friction: reversed", "the torque at -296 rpm over that at 296 rpm", "1, by symmetry",
        lambda: by_reference(speed=-31.0) / by_reference(), 1.0),
    HardCase("numerical friction: at standstill", "friction at 0 rpm", "a refusal: nothing rolls",
        lambda: by_reference(speed=0.0), refusal="at standstill nothing rolls"),
    HardCase("numerical friction: no friction", "a coefficient of 0", "a refusal: nothing resists slip",
        lambda: by_reference(friction=0.0), refusal="without friction nothing resists slip"),
    HardCase("numerical friction: slides along", "force of a contact at a creepage of 30 over the friction force",
        "-1: all of it slides", lambda: sliding(Creepages(along=30.0)).force_along / (FRICTION * LOAD), -1.0,
        tolerance=ALL_SLIDES),
    HardCase("numerical friction: slides in a spin", "spin moment at a spin of 30 per b over mu Q b",
        "-3/8 E(1 - a^2/b^2), by 40 digits",
        lambda: sliding(Creepages(spin=30 / B)).spin_moment / (FRICTION * LOAD * B), SPUN, tolerance=STRIPS),
    HardCase("numerical friction: skidding", "2 N of thrust at 8000 rad/s", "a refusal with the remedy",
        lambda: by_reference(load=2.0, speed=8000.0), refusal="Raise the load or lower the speed"),
    HardCase("numerical friction: oil pressed solid",
        "the torque of a full film that shears at its limit over that of dry friction of the same coefficient",
        "1: both are Coulomb friction", lambda: thrust_ball(40.0, law=PRESSED_SOLID).torque / thrust_ball(40.0).torque,
        1.0, tolerance=SETTLED),
    HardCase("numerical friction: inlet shorter than the contact",
        "the torque in oil that ends within the ellipse over that at a starvation degree of 1",
        "1: neither has a film", lambda: oil_of(reach=Reach(ahead=1e-3)) / oil_of(starvation_degree=1.0), 1.0,
        tolerance=SETTLED),
    HardCase("numerical friction: groove as wide as the ball", "friction in a groove of conformity 0.5",
        "a refusal: the contact is a line", lambda: by_reference(bearing=with_conformity(0.5)),
        refusal="at conformity 0.5 the contact is a line"),
)  # fmt: skip
