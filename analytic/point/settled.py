"""The parts of the torque of a scene in which every effect and method is fixed, without deciding anything again."""

import numpy as np

from analytic.effects.declared import declared_torque
from analytic.effects.sliding import TURNING_FREELY
from analytic.free_ball.passes import FreeModel
from analytic.free_ball.rotation import Creep
from analytic.free_ball.sliding import free_settings, settled_points
from analytic.loads.ring_rounds import RingLoads
from analytic.oil.variation import Variation
from analytic.point.free import load_points, torques_of_free_points
from analytic.point.numbers import Counted, PointModel, point_model, workspace
from analytic.point.torque import PointTorque, torques_of_points
from analytic.result import TorqueParts
from analytic.scene import Array, Scene

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage")
OF_ONE_RULE = ("single_coefficient", "along_axis")  # methods of sliding whose nodes do not depend on the torque
LEFT_OUT = ("cage_dynamics", "ball_dynamics")


def settled_parts(scene: Scene, variation: Variation) -> TorqueParts | None:
    """The torque at the operating points of the scene, compiled; each part (n,), N m.

    scene : with its effects "on" or "off", and its method of sliding;  variation : of the formulas
    None: `friction_torque` has to compute it. A cage moves, a point does not settle, sliding over the ellipse takes
    as many nodes as its error needs, or the scene is of a kind that `friction_torque` checks for its limits: two
    bearings, a thrust bearing, or unequal loads at a given contact angle.
    Raises InputError as the formulas do that take the scene's numbers.
    """
    counted = Counted(**{name: scene.effects.get(name) == "on" for name in Counted._fields})._replace(
        oil=scene.lubricant is not None
    )
    operation = scene.operation.as_series()
    slides = counted.spin or counted.conformity
    held = not counted.load_distribution and not operation.is_thrust
    moves = any(scene.effects.get(name) == "on" for name in LEFT_OUT)
    special = scene.arrangement is not None or scene.bearing.kind == "thrust" or scene.microslip != "derived"
    free = slides and scene.sliding in TURNING_FREELY
    if held or moves or special or (slides and not free and scene.sliding not in OF_ONE_RULE):
        return None
    points = np.empty((5, operation.inner_speed.size))
    points[0], points[1], points[2] = operation.axial_load, operation.radial_load, operation.moment
    points[3], points[4] = operation.inner_speed, np.nan if scene.lubricant is None else scene.lubricant.temperature
    torques = np.empty((len(PointTorque._fields), points.shape[1]))
    model = point_model(scene, counted, variation)
    if free:
        _turn_freely(scene, model, points, torques)
    else:
        torques_of_points(model, points, workspace(scene), torques)
    if not np.isfinite(torques[0]).all():
        return None
    parts = dict(zip(PointTorque._fields, torques, strict=True))
    declared = declared_torque(scene.losses)
    return TorqueParts(
        total=parts["total"],
        race=parts["spin"] + parts["conformity"] + parts["hysteresis"] + parts["rolling"],
        declared=None if declared is None else np.full_like(parts["total"], declared),
        **{name: parts[name] if getattr(counted, name) else None for name in PARTS},
    )


def _turn_freely(scene: Scene, model: PointModel, points: Array, torques: Array) -> None:
    """Write the torques of points whose balls turn freely; NaN where they do not settle."""
    count, balls, counted, creep = points.shape[1], scene.bearing.ball_count, model.counted, scene.effects.get("creep")
    force, factors = np.zeros((count, 5)), np.zeros((count, 2, 4, balls))
    torques[:] = np.nan
    if not load_points(model, points, workspace(scene), force, factors):
        return
    inertia = counted.centrifugal, counted.gyroscopic
    closed: Creep = "closed" if scene.sliding == "closed_creep" else "marched"
    settings = free_settings(scene.bearing, creep=closed if creep == "on" else "none", inertia=inertia)
    space, ends = settled_points(
        FreeModel(model.ring, model.resistance, settings),
        RingLoads(force, points[3], inertia, factors),
        model.oil,
        is_ring=bool(points[1:3].any()) or counted.weight,
        allowed=np.full(count, scene.tolerance),
    )
    torques_of_free_points(model, points, model.oil, space, ends, torques)
