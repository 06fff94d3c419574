"""The torque of one scene with many values of its uncertain inputs."""

import os
from dataclasses import dataclass, fields, replace
from time import thread_time

import numpy as np

from analytic.effects import CAGE_OFF
from analytic.errors import FembearingError
from analytic.oil.variation import Variation
from analytic.prediction.settled import level_of_changes, settled_parts
from analytic.prediction.spreads import NUMERICAL, UncertainInput
from analytic.prediction.variants import varied_scene
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import Array, Scene
from analytic.torque import friction_torque


@dataclass(frozen=True, kw_only=True, eq=False)
class Problem:
    """What is evaluated at every sample."""

    scene: Scene  # whose cage does not move
    inputs: tuple[UncertainInput, ...]  # the numerical one last, if there is one
    numerical: Array  # (n,) relative standard deviation of the total by the numerical uncertainty
    parts: tuple[str, ...]  # of the torque that are there, "total" first
    level: int  # of the nodes of sliding, in all samples
    scale: Array  # (n,) torque of the scene over that on these nodes: their error is common to all samples and parts
    held: Array  # (n,) N m that is added to the races' part in the total: a cage whose motion is not computed again


def problem_of(scene: Scene, nominal: FrictionTorque, inputs: tuple[UncertainInput, ...]) -> Problem:
    """The problem of a scene.

    nominal : friction_torque(scene)
    The numerical uncertainty counts as two standard deviations of a normal one. A cage that moves keeps its torque, as
    each of its motions takes minutes. Raises the error of an operating point without a torque.
    """
    settled, torque = without_moving_cage(scene, nominal.settled()), nominal.torque
    held = np.zeros_like(torque.total)
    names = [field.name for field in fields(TorqueParts) if getattr(torque, field.name) is not None]
    if cage_moves(nominal):
        held = np.zeros_like(held) if torque.cage is None else torque.cage
        names.remove("cage")
    numerical = nominal.numerical_uncertainty / 2
    if np.any(numerical > 0):
        source = "bound or estimate by the model of its own computation, as two standard deviations"
        largest = float(numerical.max())
        numerics = UncertainInput(key=NUMERICAL, kind="numerical", value=1.0, unit="", deviation=largest, source=source)
        inputs = (*inputs, numerics)
    problem = Problem(
        scene=settled,
        inputs=inputs,
        numerical=numerical,
        parts=tuple(names),
        level=level_of_changes(settled),
        scale=np.ones_like(held),
        held=held,
    )
    base = torque_at(problem, np.zeros(len(inputs)))[0]
    return replace(problem, scale=np.divide(torque.total, base, out=np.ones_like(base), where=base > 0))


def cage_moves(nominal: FrictionTorque) -> bool:
    """Whether the motion of the cage was computed."""
    return nominal.is_on("cage_dynamics") or nominal.is_on("ball_dynamics")


def without_moving_cage(scene: Scene, nominal: FrictionTorque) -> Scene:
    """The scene without a cage that moves; nominal : its torque"""
    return replace(scene, effects={**scene.effects, **CAGE_OFF}) if cage_moves(nominal) else scene


def evaluated(problem: Problem, scores: Array) -> tuple[Array, list[str], float]:
    """The torque at each sample, (N, parts, n), NaN where it has none; why; and the processor's time.

    scores : (N, d)
    """
    begun = thread_time()
    torque = np.full((scores.shape[0], len(problem.parts), problem.held.size), np.nan)
    reasons = []
    for row, score in enumerate(scores):
        try:
            torque[row] = torque_at(problem, score)
        except FembearingError as failure:
            reasons.append(str(failure))
    return torque, reasons, thread_time() - begun


def torque_at(problem: Problem, score: Array) -> Array:
    """(parts, n) the torque of one sample, N m; score : (d,). Raises InputError and ConvergenceError of its scene."""
    scene, variation = moved_scene(problem.scene, problem.inputs, score)
    parts = parts_of(scene, variation, problem.level)
    named = (getattr(parts, name) for name in problem.parts)
    torque = np.stack([np.zeros_like(problem.held) if part is None else part for part in named])
    torque[0] += problem.held
    torque *= problem.scale
    if problem.inputs[-1].key == NUMERICAL:
        torque[0] *= np.exp(problem.numerical * score[-1])
    return torque


def parts_of(scene: Scene, variation: Variation, level: int) -> TorqueParts:
    """The parts of the torque, (n,) each, of a scene whose cage does not move.

    variation, level : as in `settled_parts`. Raises InputError, and ConvergenceError of a point that does not settle.
    """
    parts = settled_parts(scene, variation, level)
    return friction_torque(scene, variation=variation).settled().torque if parts is None else parts


def moved_scene(scene: Scene, inputs: tuple[UncertainInput, ...], score: Array) -> tuple[Scene, Variation]:
    """The scene with its uncertain inputs at a score, (d,), and the variation of the formulas."""
    values = {each.key: float(each.at(part)) for each, part in zip(inputs, score, strict=True)}
    values.pop(NUMERICAL, None)
    return varied_scene(scene, values)


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
