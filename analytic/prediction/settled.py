"""The parts of the torque of a scene by the kernel alone, for the many scenes of an interval."""

import numpy as np

from analytic.effects import counted_effects, turns_freely
from analytic.oil.losses import stirred_oil
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import oil_numbers
from analytic.result import TorqueParts
from analytic.scene import Scene
from analytic.solve.model import Model, model_of
from analytic.solve.solution import points_of, solved

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage")


def settled_parts(scene: Scene, variation: Variation, level: int) -> TorqueParts | None:
    """The torque at the operating points of the scene; each part (n,), N m.

    variation : of the formulas;  level : of the nodes of sliding, one for all scenes, so that their error is common
    None: `friction_torque` has to compute it: a point does not settle, a cage is squeezed, or there are two bearings.
    Raises InputError as the formulas do that take the scene's numbers.
    """
    if scene.arrangement is not None:
        return None
    model = _model(scene, variation).with_numbers(level=level, allowed=np.inf)
    parts = solved(model, points_of(scene.operation.as_series(), model.temperature), keeps_balls=False).points
    if np.isnan(parts["total"]).any():
        return None
    counted, declared, stirred = counted_effects(scene), scene.losses.total, stirred_oil(scene, scene.losses)
    oil = None
    if stirred is not None and scene.lubricant is not None:
        speed = scene.operation.as_series().inner_speed
        oil = variation.oil_losses * stirred.torque(speed, oil_numbers(scene.lubricant).viscosity)
    return TorqueParts(
        total=parts["total"] if oil is None else parts["total"] + oil,
        race=parts["spin"] + parts["conformity"] + parts["hysteresis"] + parts["rolling"],
        oil=oil,
        declared=None if declared is None else np.full_like(parts["total"], declared),
        **{name: parts[name] if counted[name] else None for name in PARTS},
    )


def level_of(scene: Scene) -> int:
    """The finest level of nodes that an operating point of the scene takes for its tolerance."""
    if scene.arrangement is not None:
        return 0
    model = _model(scene, NOMINAL)
    points = points_of(scene.operation.as_series(), model.temperature)
    return int(solved(model, points, keeps_balls=False).points["level"].max())


def level_of_changes(scene: Scene) -> int:
    """The level of nodes for changes of a torque, to which their error is common: that on which free balls settle."""
    return max(level_of(scene) - turns_freely(scene, counted_effects(scene)), 0)


def _model(scene: Scene, variation: Variation) -> Model:
    counted = counted_effects(scene)
    return model_of(scene, counted, free=turns_freely(scene, counted), variation=variation)
