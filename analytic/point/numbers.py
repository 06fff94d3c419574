"""A scene in the numbers that the compiled torque of one operating point takes."""

from typing import NamedTuple

import numpy as np

from analytic.cage.drive import GRAVITY, pocket_shape_of
from analytic.cage.steady import lead_room
from analytic.contact.finite_geometry_fit import FitNumbers, fit_numbers
from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus
from analytic.effects.declared import declared_torque
from analytic.errors import InputError
from analytic.loads.ring_balance import RingPoint, RingWork, ring_points, ring_work
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.ring_series import ring_numbers
from analytic.oil.race_resistance import NO_OIL, RaceResistance, gap_numbers_of, resistance_of
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Cage, Scene
from analytic.sliding.ellipse import Quadrature, quadrature_of
from analytic.sliding.long_ellipse import RULES
from analytic.surface.gap import GapNumbers, gap_numbers

SINGLE_COEFFICIENT, ALONG_AXIS, OVER_ELLIPSE = range(3)
METHODS = {"single_coefficient": SINGLE_COEFFICIENT, "along_axis": ALONG_AXIS, "over_ellipse": OVER_ELLIPSE}


class Counted(NamedTuple):
    """Which effects count."""

    load_distribution: bool
    weight: bool
    centrifugal: bool
    gyroscopic: bool
    finite_geometry: bool
    asperities: bool
    inlet_heating: bool
    starvation: bool
    spin: bool
    conformity: bool
    oil: bool  # there is one
    hysteresis: bool
    rolling: bool  # resistance of the oil to it
    cage: bool


class Slipping(NamedTuple):
    """How sliding is computed."""

    rule: int  # of `long_ellipse.RULES`
    method: int  # of METHODS
    quadrature: Quadrature


class CageNumbers(NamedTuple):
    """A cage at rest on its balls."""

    mass: float  # kg
    gravity: float  # g along or across the axis, m/s^2
    lies_along: bool  # gravity is along the axis
    drag: float  # N m s
    room: float  # lead of the balls that the pockets leave free, m
    coefficient: float  # of ball on pocket; NaN: by oil and surface
    curvature: float  # of ball against pocket, 1/m, both ways
    modulus: float  # Pa
    largest_gap: float  # m
    gap: GapNumbers
    boundary_friction: float


class PointModel(NamedTuple):
    """A scene without its operating points."""

    ring: RingNumbers
    arm: float  # R of the inner groove centres, m
    counted: Counted
    fit: FitNumbers  # for finite geometry
    oil: OilNumbers
    resistance: RaceResistance
    slipping: Slipping
    cage: CageNumbers
    declared: float  # torque of seals and drag, N m


NO_CAGE = CageNumbers(0.0, 0.0, False, 0.0, np.inf, 0.0, 1.0, 1.0, 1.0, gap_numbers(None), 0.0)


class Workspace(NamedTuple):
    """Arrays that one point after the other uses."""

    point: RingPoint
    ring: RingWork
    force: Array  # (5,)
    factors: Array  # (2, 4, Z) on Hertz's contacts


def workspace(scene: Scene) -> Workspace:
    """Arrays for the balls of a scene."""
    balls = scene.bearing.ball_count
    point = RingPoint(*(of_points[0] for of_points in ring_points(1, balls)))
    return Workspace(point, ring_work(balls), np.zeros(5), np.ones((2, 4, balls)))


def point_model(scene: Scene, counted: Counted, variation: Variation = NOMINAL) -> PointModel:
    """The scene with these effects, and with its own spin rule and sliding method; variation : of the formulas.

    Raises InputError as the formulas do that take the scene's numbers.
    """
    ring, arm = ring_numbers(scene.bearing, scene.contact_angle, down=scene.down if counted.weight else None)
    return PointModel(
        ring=ring,
        arm=arm,
        counted=counted,
        fit=fit_numbers(),
        oil=NO_OIL if scene.lubricant is None else oil_numbers(scene.lubricant),
        resistance=resistance_of(scene, lambda name: getattr(counted, name), variation),
        slipping=Slipping(
            rule=RULES["balanced" if scene.spin_rule == "free" else scene.spin_rule],
            method=METHODS.get(scene.sliding, SINGLE_COEFFICIENT),
            quadrature=quadrature_of((12, 8)),
        ),
        cage=NO_CAGE if scene.cage is None else _cage(scene, scene.cage),
        declared=float(declared_torque(scene.losses) or 0.0),
    )


def _cage(scene: Scene, cage: Cage) -> CageNumbers:
    bearing, pocket = scene.bearing, pocket_contact(scene.bearing, cage, load=0.0)
    shape, gravity = pocket_shape_of(bearing, cage), float(np.linalg.norm(GRAVITY[cage.gravity]))
    given = scene.friction_coefficient if cage.friction_coefficient is None else cage.friction_coefficient
    surface = None if given is not None else scene.surface
    bodies = pocket.ball_material, pocket.race_material
    if given is None and (scene.lubricant is None or surface is None):
        raise InputError("the friction of ball on pocket is not known: add [cage] friction_coefficient = 0.1")
    return CageNumbers(
        mass=cage.mass,
        gravity=gravity,
        lies_along=cage.gravity == "along",
        drag=cage.drag,
        room=lead_room(
            half_clearance=shape.half_clearance,
            centre_offset=shape.centre_offset,
            land_half_clearance=np.inf if cage.land is None else cage.land.clearance / 2,
        ),
        coefficient=np.nan if given is None else float(given),
        curvature=1 / pocket.ball_radius - 1 / pocket.groove_radius,
        modulus=float(contact_modulus(*bodies)),
        largest_gap=pocket.groove_radius - pocket.ball_radius,
        gap=gap_numbers(None) if surface is None else gap_numbers_of(scene, bodies),
        boundary_friction=0.0 if surface is None else surface.boundary_friction,
    )
