"""The torque of a bearing at points whose balls turn freely, compiled.

Loads by rule and what follows from the balls are those of `analytic.point.torque`; between them the balls settle by
`analytic.free_ball.passes`, in the machine code that `analytic.torque.friction_torque` takes too.
"""

from analytic.free_ball.passes import FreeSpace, motion_of, rows_of_point
from analytic.loads.ring_balance import point_of
from analytic.loads.ring_rounds import SETTLED
from analytic.numerics.compilation import compiled
from analytic.oil.viscosity import OilNumbers
from analytic.point.numbers import PointModel, Workspace
from analytic.point.torque import (
    NO_LOSS,
    NO_TORQUE,
    Ball,
    load_balls,
    load_of_point,
    race_of_ball,
    whole_torque,
    with_ball,
)
from analytic.scene import Array


@compiled
def load_points(model: PointModel, points: Array, work: Workspace, force: Array, factors: Array) -> bool:
    """Write the loads on n rings and the factors on their contacts; False where balls by rule do not settle.

    points : as in `torques_of_points`;  force : (n, 5);  factors : (n, 2, 4, Z), those of the first ball where all are
    alike
    """
    for i in range(points.shape[1]):
        balls = load_balls(model, load_of_point(points, i), work)
        if balls == 0:
            return False
        force[i] = work.force
        factors[i] = work.factors
        if balls == 1:
            for j in range(1, factors.shape[3]):
                factors[i, :, :, j] = work.factors[:, :, 0]
    return True


@compiled
def torques_of_free_points(
    model: PointModel, points: Array, oil: OilNumbers, space: FreeSpace, ends: Array, torques: Array
) -> None:
    """Write (6, n) torques of `PointTorque`; oil : at its temperature;  space, ends : of `settled_points`"""
    for i in range(points.shape[1]):
        load, point, rows = load_of_point(points, i), point_of(space.point, i), rows_of_point(space.balls, i)
        torque = NO_TORQUE
        if ends[i, 0] == SETTLED:
            losses, balls = NO_LOSS, len(rows.velocity)
            for j in range(balls):
                motion = motion_of(rows, j)
                on_inner = race_of_ball(model, oil, load.speed, 0, point, Ball(j, motion))
                on_outer = race_of_ball(model, oil, load.speed, 1, point, Ball(j, motion))
                losses = with_ball(losses, on_inner, on_outer, point, j, motion)
            torque = whole_torque(model, oil, load, losses, (ends[i, 5], ends[i, 4] - ends[i, 5]), balls)
        for k in range(6):
            torques[k, i] = torque[k]
