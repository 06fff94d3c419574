"""The torque of a bearing at points whose balls turn freely, compiled.

Loads by rule and what follows from the balls are those of `analytic.point.torque`; between them the balls settle by
`analytic.free_ball.passes`, in the compiled functions that `analytic.torque.friction_torque` takes too.
"""

from typing import NamedTuple

import numpy as np

from analytic.free_ball.passes import (
    FreeModel,
    FreeSettings,
    FreeSpace,
    FreeStart,
    motion_of,
    settle_freely,
    start_of_point,
)
from analytic.free_ball.turning import BallRows
from analytic.loads.ring_balance import RingWork
from analytic.loads.ring_rounds import SETTLED
from analytic.loads.turning import TurningRule
from analytic.numerics.compilation import compiled
from analytic.point.numbers import PointModel, Workspace
from analytic.point.torque import (
    NO_LOSS,
    NO_TORQUE,
    Ball,
    Load,
    PointTorque,
    load_balls,
    load_of_point,
    race_of_ball,
    ring_load,
    whole_torque,
    with_ball,
)
from analytic.scene import Array


class FreePointModel(NamedTuple):
    """A scene with free balls, without its operating points."""

    point: PointModel
    settings: FreeSettings
    allowed: float  # error of balls that begin by rule, relative to the whole torque


@compiled
def _free_torque(
    model: FreePointModel, load: Load, balls: BallRows, start: FreeStart, work: Workspace, ring: RingWork | None
) -> PointTorque:
    """The torque at one operating point; ring : None: all balls are alike, and no ring is compiled."""
    of_point, point, space = model.point, work.point, FreeSpace(work.point, balls, start)
    loaded = load_balls(of_point, load, work)
    if loaded == 0:
        return NO_TORQUE
    if loaded == 1:
        for j in range(1, work.factors.shape[2]):
            work.factors[:, :, j] = work.factors[:, :, 0]
    on_ring = ring_load(
        of_point, load, work, TurningRule(load.speed, of_point.counted.centrifugal, of_point.counted.gyroscopic)
    )
    free = FreeModel(of_point.ring, of_point.resistance, model.settings)
    end = settle_freely(free, on_ring, of_point.oil, space, ring, model.allowed)
    if end.round.end != SETTLED:
        return NO_TORQUE
    losses, count = NO_LOSS, len(balls.velocity)
    for j in range(count):
        motion = motion_of(balls, j)
        on_inner = race_of_ball(of_point, of_point.oil, load.speed, 0, point, Ball(j, motion))
        on_outer = race_of_ball(of_point, of_point.oil, load.speed, 1, point, Ball(j, motion))
        losses = with_ball(losses, on_inner, on_outer, point, j, motion)
    return whole_torque(of_point, of_point.oil, load, losses, (end.spin, end.torque - end.spin), count)


@compiled
def torques_of_alike_balls(
    model: FreePointModel, points: Array, balls: BallRows, start: FreeStart, work: Workspace, torques: Array
) -> None:
    """Write (6, n) torques of `PointTorque` of balls that are all alike, up to the first point that does not settle.

    points : (5, n) as in `torques_of_points`, all of the oil's temperature;  balls : of one point
    start : of n points, overwritten by how they settle
    """
    _free_torques(model, points, balls, start, work, None, torques)


@compiled
def torques_of_unlike_balls(
    model: FreePointModel, points: Array, balls: BallRows, start: FreeStart, work: Workspace, torques: Array
) -> None:
    """The same where every ball has its own load; each is compiled where it is needed."""
    _free_torques(model, points, balls, start, work, work.ring, torques)


@compiled
def _free_torques(
    model: FreePointModel,
    points: Array,
    balls: BallRows,
    start: FreeStart,
    work: Workspace,
    ring: RingWork | None,
    torques: Array,
) -> None:
    for i in range(points.shape[1]):
        torque = _free_torque(model, load_of_point(points, i), balls, start_of_point(start, i), work, ring)
        for k in range(6):
            torques[k, i] = torque[k]
        if np.isnan(torque.total):
            return
