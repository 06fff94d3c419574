"""The parts of the torque of a scene in which every effect and method is fixed, without deciding anything again."""

import numpy as np

from analytic.effects.declared import declared_torque
from analytic.effects.sliding import TURNING_FREELY
from analytic.free_ball.passes import FreeStart, no_start
from analytic.free_ball.rotation import Creep
from analytic.free_ball.sliding import free_settings
from analytic.free_ball.turning import ball_rows
from analytic.oil.variation import NOMINAL, Variation
from analytic.point.free import FreePointModel, torques_of_alike_balls, torques_of_unlike_balls
from analytic.point.numbers import Counted, PointModel, point_model, workspace
from analytic.point.torque import PointTorque, torques_of_points
from analytic.result import TorqueParts
from analytic.scene import Array, Scene

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage")
OF_ONE_RULE = ("single_coefficient", "along_axis")  # methods of sliding whose nodes do not depend on the torque
LEFT_OUT = ("cage_dynamics", "ball_dynamics")
# Of speeds and loads, relative, from a start to where the balls settle; films are those of the start. 300 samples of a
# 6205 under thrust move by 0.021 at most, and their torque errs by a thousandth. On a ring this is the median ball: one
# that is hardly loaded moves by more, and makes no torque.
FAR = 0.03


def settled_parts(scene: Scene, variation: Variation, start: FreeStart | None = None) -> TorqueParts | None:
    """The torque at the operating points of the scene, compiled; each part (n,), N m.

    scene : with its effects "on" or "off", and its method of sliding;  variation : of the formulas
    None: `friction_torque` has to compute it. A cage moves, a point does not settle, sliding over the ellipse takes
    as many nodes as its error needs, or the scene is of a kind that `friction_torque` checks for its limits: two
    bearings, a thrust bearing, or unequal loads at a given contact angle.
    start : of free balls, as `free_start` has it from a scene with nearly the same numbers
    Raises InputError as the formulas do that take the scene's numbers.
    """
    found = _settled(scene, variation, start)
    if found is None:
        return None
    counted, torques, _ = found
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


def free_start(scene: Scene, variation: Variation = NOMINAL, start: FreeStart | None = None) -> FreeStart | None:
    """Where the free balls of scenes with nearly the same numbers begin; None: they do not turn freely.

    scene, variation, start : as in `settled_parts`
    """
    found = _settled(scene, variation, start)
    return None if found is None else found[2]


def _settled(
    scene: Scene, variation: Variation, start: FreeStart | None
) -> tuple[Counted, Array, FreeStart | None] | None:
    """The effects that count, (6, n) torques of `PointTorque`, and how free balls settled; as in `settled_parts`."""
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
        return counted, torques, _turn_freely(scene, model, points, torques, start)
    torques_of_points(model, points, workspace(scene), torques)
    return counted, torques, None


def _turn_freely(
    scene: Scene, model: PointModel, points: Array, torques: Array, start: FreeStart | None
) -> FreeStart | None:
    """Write the torques of points whose balls turn freely, NaN where they do not settle; returns how they settled."""
    counted, creep = model.counted, scene.effects.get("creep")
    is_ring = bool(points[1:3].any()) or counted.weight
    count, balls = points.shape[1], scene.bearing.ball_count if is_ring else 1
    closed: Creep = "closed" if scene.sliding == "closed_creep" else "marched"
    inertia = counted.centrifugal, counted.gyroscopic
    settings = free_settings(scene.bearing, creep=closed if creep == "on" else "none", inertia=inertia)
    free, by_rule = FreePointModel(model, settings, scene.tolerance), no_start(count, balls)
    torques_of = torques_of_unlike_balls if is_ring else torques_of_alike_balls
    torques[:] = np.nan
    if start is not None:
        velocity, load = start.velocity.copy(), start.load.copy()
        torques_of(free, points, ball_rows((balls,)), start, workspace(scene), torques)
        speed = scene.bearing.pitch_diameter / 4  # of a ball along its orbit, nearly, per unit ring speed
        moved = np.maximum(
            np.abs(start.velocity - velocity).max(axis=2) / speed, np.abs(start.load - load).max(axis=1)
        )  # (n, m)
        if np.median(moved, axis=1).max() <= FAR and np.isfinite(torques[0]).all():
            return start
    torques_of(free, points, ball_rows((balls,)), by_rule, workspace(scene), torques)
    return by_rule
