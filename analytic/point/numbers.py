"""A scene in the numbers that the compiled torque of one operating point takes."""

from typing import NamedTuple

import numpy as np

from analytic.cage.drive import resting_cage
from analytic.cage.pocket import NO_POCKET, PocketNumbers, pocket_numbers
from analytic.cage.steady import RestingCage
from analytic.contact.finite_geometry_fit import FitNumbers, fit_numbers
from analytic.effects.declared import declared_torque
from analytic.loads.ring_balance import RingPoint, RingWork, ring_points, ring_work
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.ring_series import ring_numbers
from analytic.oil.race_resistance import NO_OIL, RaceResistance, resistance_of
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import OilNumbers, oil_numbers
from analytic.scene import Array, Scene
from analytic.sliding.ellipse import Quadrature, quadrature_of
from analytic.sliding.long_ellipse import RULES

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


class PointModel(NamedTuple):
    """A scene without its operating points."""

    ring: RingNumbers
    arm: float  # R of the inner groove centres, m
    counted: Counted
    fit: FitNumbers  # for finite geometry
    oil: OilNumbers
    resistance: RaceResistance
    slipping: Slipping
    cage: RestingCage
    pocket: PocketNumbers
    declared: float  # torque of seals and drag, N m


NO_CAGE = RestingCage(0.0, 0.0, False, 0.0, np.inf, 1, 1.0, 1.0)


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
        cage=NO_CAGE if scene.cage is None else resting_cage(scene.bearing, scene.cage),
        pocket=NO_POCKET if scene.cage is None else pocket_numbers(scene, scene.cage),
        declared=float(declared_torque(scene.losses) or 0.0),
    )
