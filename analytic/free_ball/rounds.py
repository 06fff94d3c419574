"""The equilibria of balls that turn freely, compiled: rounds in which loads and rotation follow each other."""

import numpy as np

from analytic.contact.factors import correction_of_ball
from analytic.contact.hertz import HertzNumbers
from analytic.free_ball.turning import ACCURACY, ENOUGH, BallRows, FreeNodes, FreeNumbers, PlacedBall, turned
from analytic.loads.numbers import BearingNumbers
from analytic.loads.ring_balance import RingPoint, RingWork
from analytic.loads.ring_rounds import (
    MOST_ROUNDS,
    OPEN,
    SETTLED,
    RingLoad,
    RingNumbers,
    Round,
    hold_contacts,
    settle_round,
)
from analytic.loads.thrust_ball import (
    ROUGH_STEP,
    STEADYING,
    Held,
    ThrustedBall,
    balanced,
    change_of,
    contacts_at,
    in_groove,
)
from analytic.numerics.compilation import compiled

STEADY = 1e-6  # relative, of the forces on a ball from one round to the next: a torque needs three digits
ROUGHLY_STEADY = 1e-4  # likewise, of a pass that cannot be the last
SKIDS = 5  # beside the ends of `Round`: a ball finds no steady rotation
OF_CHANGE = 0.1  # residual of the rotation, over all friction, that is enough for a round, over the last change
LEAST_ANGLE, MOST_ANGLE = 1e-6, 1.5  # rad, where a search begins


@compiled
def placed_ball(point: RingPoint, j: int) -> PlacedBall:
    """Ball j at the angles and loads of a point, with the contacts that it holds."""
    a, b = point.unit[0], point.unit[1]
    return PlacedBall(
        (in_groove(point.angle[0, j]), in_groove(point.angle[1, j])),
        (point.load[0, j], point.load[1, j]),
        HertzNumbers(a[0, j], a[1, j], a[2, j], a[3, j], a[4, j]),
        HertzNumbers(b[0, j], b[1, j], b[2, j], b[3, j], b[4, j]),
    )


@compiled
def _next(nodes: FreeNodes, change: float) -> FreeNodes:
    """Nodes for the round after one that changed angles or forces by this much, relative; nodes : of the first one."""
    return FreeNodes(nodes.coarse, nodes.fine, min(max(OF_CHANGE * change, ACCURACY), nodes.accuracy), nodes.steady)


@compiled
def settle_free_thrust(
    bearing: BearingNumbers, free: FreeNumbers, load: RingLoad, point: RingPoint, balls: BallRows, nodes: FreeNodes
) -> Round:
    """The balls under thrust, which are alike, from what the point holds; writes point and balls."""
    push = load.force[0] / bearing.ball_count
    correction = correction_of_ball(load.factors, 0)
    placed = placed_ball(point, 0)
    last = ThrustedBall(
        np.tan(min(max(placed.angles[0], LEAST_ANGLE), MOST_ANGLE)),
        placed.angles[0],
        placed.angles[1],
        placed.loads[0],
        placed.loads[1],
    )
    held, change, speed, now = Held(0.0, 0.0, 0.0, 0.0, 0.0), 1.0, load.rule.inner_speed, nodes
    for number in range(MOST_ROUNDS):
        inner, outer = contacts_at(bearing, in_groove(last.inner_angle), in_groove(last.outer_angle), correction)
        for k in range(5):
            point.unit[0, k, 0], point.unit[1, k, 0] = inner[k], outer[k]
        forces = turned(bearing, free, speed, placed_ball(point, 0), balls, 0, now)
        if not balls.residual[0] <= max(ENOUGH, now.accuracy):
            return Round(SKIDS, number, balls.residual[0], ENOUGH)
        if not np.isnan(bearing.given_angle):  # which holds loads and angles, but not how the balls turn
            return Round(SETTLED, number, 0.0, nodes.steady)
        outward = forces.centrifugal / push
        inner_lean = -np.arctan(forces.inner_friction / last.inner_load)
        outer_lean = -np.arctan(forces.outer_friction / last.outer_load)
        if number >= STEADYING:
            outward = (outward + held.outward) / 2
            inner_lean, outer_lean = (inner_lean + held.inner_lean) / 2, (outer_lean + held.outer_lean) / 2
        held = Held(inner.approach, outer.approach, outward, inner_lean, outer_lean)
        ball = balanced(bearing, push, held, last.tangent, ROUGH_STEP)
        change = change_of(last, ball)
        point.load[0, 0], point.load[1, 0] = ball.inner_load, ball.outer_load
        point.angle[0, 0], point.angle[1, 0] = ball.inner_angle, ball.outer_angle
        if np.isnan(change):
            break
        # The balls keep the motion of the last round, so that this round must change nothing.
        if change <= nodes.steady:
            return Round(SETTLED, number, change, nodes.steady)
        last, now = ball, _next(nodes, change)
    return Round(OPEN, MOST_ROUNDS, change, nodes.steady)


@compiled
def settle_free_ring(
    ring: RingNumbers,
    free: FreeNumbers,
    load: RingLoad,
    point: RingPoint,
    work: RingWork,
    balls: BallRows,
    nodes: FreeNodes,
) -> Round:
    """The ring and its balls, from what the point holds; writes point and balls."""
    end, steps, now = Round(OPEN, 0, 0.0, 0.0), 0, nodes
    point.own[:], point.ring_force[:] = np.inf, np.inf  # all forces are to change
    for number in range(MOST_ROUNDS + 1):
        hold_contacts(ring, load.factors, point)
        for j in range(len(point.own)):
            forces = turned(ring.bearing, free, load.rule.inner_speed, placed_ball(point, j), balls, j, now)
            if not balls.residual[j] <= max(ENOUGH, now.accuracy):
                return Round(SKIDS, number, balls.residual[j], ENOUGH)
            for k in range(4):
                point.turning[k, j] = forces[k]
        end = settle_round(ring.rows, load.force, point, work, number, nodes.steady)
        steps += end.steps
        if end.end != OPEN:
            break
        now = _next(nodes, nodes.steady * end.left / end.tolerance)
    return Round(end.end, steps, end.left, end.tolerance)
