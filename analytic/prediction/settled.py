"""The parts of the torque of a scene in which every effect and method is fixed, without deciding anything again."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.records import Record, Records
from analytic.oil.losses import stirred_oil
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import oil_numbers
from analytic.result import TorqueParts
from analytic.scene import Array, Scene
from analytic.sliding.judge import METHODS as SLIDING_METHODS
from analytic.solve.freely import METHODS as FREE_METHODS
from analytic.solve.model import Counted, Model, Workspace, model_of, workspace
from analytic.solve.records import POINT, SETTLED
from analytic.solve.solution import points_of, solved

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage")
OF_ONE_RULE = ("single_coefficient", "along_axis")  # methods of sliding whose nodes do not depend on the torque
LEFT_OUT = ("cage_dynamics", "ball_dynamics")
# Of speeds and loads, relative, from a start to where the balls settle; films are those of the start. 300 samples of a
# 6205 under thrust move by 0.021 at most, and their torque errs by a thousandth. On a ring this is the median ball: one
# that is hardly loaded moves by more, and makes no torque.
FAR = 0.03


class FreeStart(NamedTuple):
    """Where the free balls of n operating points begin, over what the rule gives them; Z balls, as `BALL_STATE`."""

    passes: NDArray[np.int64]  # (n,) quadrature in which they settled; 0: not known
    velocity: Array  # (n, Z, 4)
    angle: Array  # (n, Z, 2)
    load: Array  # (n, Z, 2)
    forces: Array  # (n, Z, 3)


@dataclass(frozen=True, kw_only=True, eq=False)
class Settled:
    """A scene with fixed effects at its operating points."""

    counted: dict[str, bool]
    points: Records  # (n,) of `records.POINT`
    start: FreeStart | None  # how free balls settled; None: they turn by rule


def settled_parts(scene: Scene, variation: Variation, start: FreeStart | None = None) -> TorqueParts[Array] | None:
    """The torque at the operating points of the scene; each part (n,), N m.

    scene : with its effects "on" or "off", and its method of sliding;  variation : of the formulas
    None: `friction_torque` has to compute it. A cage moves, a point does not settle, sliding over the ellipse takes
    as many nodes as its error needs, or the scene is of a kind that `friction_torque` checks for its limits: two
    bearings, a thrust bearing, or unequal loads at a given contact angle.
    start : of free balls, as `free_start` has it from a scene with nearly the same numbers
    Raises InputError as the formulas do that take the scene's numbers.
    """
    found = settle(scene, variation, start)
    if found is None or found.points["status"].any():
        return None
    parts, declared, stirred = found.points, scene.losses.total, stirred_oil(scene, scene.losses)
    oil = None
    if stirred is not None and scene.lubricant is not None:
        speed = scene.operation.as_series().inner_speed
        oil = variation.oil_losses * stirred.torque(speed, oil_numbers(scene.lubricant).viscosity)
    return TorqueParts(
        total=parts["total"] if oil is None else parts["total"] + oil,
        race=parts["spin"] + parts["conformity"] + parts["hysteresis"] + parts["rolling"],
        oil=oil,
        declared=None if declared is None else np.full_like(parts["total"], declared),
        **{name: parts[name] if found.counted[name] else None for name in PARTS},
    )


def free_start(scene: Scene, variation: Variation = NOMINAL, start: FreeStart | None = None) -> FreeStart | None:
    """Where the free balls of scenes with nearly the same numbers begin; None: they do not turn freely.

    scene, variation, start : as in `settled_parts`
    """
    found = settle(scene, variation, start)
    return None if found is None else found.start


def settle(scene: Scene, variation: Variation, start: FreeStart | None) -> Settled | None:
    """The kernel at the operating points of a scene; arguments and None as in `settled_parts`."""
    counted = {name: scene.effects.get(name) == "on" for name in Counted._fields}
    operation = scene.operation.as_series()
    slides = counted["spin"] or counted["conformity"]
    held = not counted["load_distribution"] and not operation.is_thrust
    moves = any(scene.effects.get(name) == "on" for name in LEFT_OUT)
    special = scene.arrangement is not None or scene.bearing.kind == "thrust" or scene.microslip != "derived"
    free = slides and scene.sliding in FREE_METHODS.values()
    if held or moves or special or (slides and not free and scene.sliding not in OF_ONE_RULE):
        return None
    if not free:
        method = SLIDING_METHODS.index(scene.sliding) if scene.sliding in OF_ONE_RULE else 0
        model = model_of(scene, counted, method=method, judges=False, variation=variation)
        found = solved(model, points_of(operation, model.temperature))
        return Settled(counted=counted, points=found.points, start=None)
    creep = "closed" if scene.sliding == "closed_creep" else "marched"
    model = model_of(
        scene,
        counted,
        creep=creep if scene.effects.get("creep") == "on" else "none",
        allowed=scene.tolerance,
        cold=False,
        nearly=True,
        variation=variation,
    )
    points = points_of(operation, model.temperature)
    count, balls = len(points), len(model.balls)
    out, work = np.zeros(count, POINT), workspace(model)
    left = FreeStart(np.zeros(count, np.int64), *(np.empty((count, balls, size)) for size in (4, 2, 2, 3)))
    for i in range(count):
        out[i] = _turn_freely(model, points[i : i + 1], start, i, work, scene.bearing.pitch_diameter)
        left.passes[i] = work.ring["passes"]
        for name, values in zip(FreeStart._fields[1:], left[1:], strict=True):
            values[i] = work.balls[f"start_{name}"]
    return Settled(counted=counted, points=out, start=left)


def _turn_freely(
    model: Model, point: Array, start: FreeStart | None, i: int, work: Workspace, pitch_diameter: float
) -> Record:
    """One operating point, `records.POINT`, from its start if that is near; point : (1, 5)"""
    work.ring["passes"] = 0
    if start is not None and start.passes[i] > 0:
        work.ring["passes"] = start.passes[i]
        for name, values in zip(FreeStart._fields[1:], start[1:], strict=True):
            work.balls[f"start_{name}"] = values[i]
        found = solved(model, point, work=work, keeps_balls=False).points[0]
        speed = pitch_diameter / 4  # of a ball along its orbit, nearly, per unit ring speed
        alike = not (point[0, 1] or point[0, 2] or model.numbers.counted.weight or abs(model.numbers.tilt) > 0)
        moved = np.maximum(
            np.abs(work.balls["start_velocity"] - start.velocity[i]).max(axis=1) / speed,
            np.abs(work.balls["start_load"] - start.load[i]).max(axis=1),
        )[: 1 if alike else None]
        if found["status"] == SETTLED and np.median(moved) <= FAR:
            return found
        work.ring["passes"] = 0
    return solved(model, point, work=work, keeps_balls=False).points[0]
