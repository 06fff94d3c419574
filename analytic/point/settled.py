"""The parts of the torque of a scene in which every effect and method is fixed, without deciding anything again."""

import numpy as np

from analytic.effects.declared import declared_torque
from analytic.oil.variation import Variation
from analytic.point.numbers import Counted, point_model, workspace
from analytic.point.torque import PointTorque, torques_of_points
from analytic.result import TorqueParts
from analytic.scene import Scene

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage")
OF_ONE_RULE = ("single_coefficient", "along_axis")  # methods of sliding whose nodes do not depend on the torque
LEFT_OUT = ("cage_dynamics", "ball_dynamics", "creep")


def settled_parts(scene: Scene, variation: Variation) -> TorqueParts | None:
    """The torque at the operating points of the scene, compiled; each part (n,), N m.

    scene : with its effects "on" or "off", and its method of sliding;  variation : of the formulas
    None: `friction_torque` has to compute it. Balls turn freely, a cage moves, a point does not settle, sliding takes
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
    if held or moves or special or (slides and scene.sliding not in OF_ONE_RULE):
        return None
    points = np.empty((5, operation.inner_speed.size))
    points[0], points[1], points[2] = operation.axial_load, operation.radial_load, operation.moment
    points[3], points[4] = operation.inner_speed, np.nan if scene.lubricant is None else scene.lubricant.temperature
    torques = np.empty((len(PointTorque._fields), points.shape[1]))
    torques_of_points(point_model(scene, counted, variation), points, workspace(scene), torques)
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
