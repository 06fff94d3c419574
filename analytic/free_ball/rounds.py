"""The equilibria of balls that turn freely: rounds in which loads and rotation follow each other."""

import numpy as np

from analytic.contact.factors import CorrectionNumbers
from analytic.free_ball.turning import ACCURACY, ENOUGH, FreeNodes, FreeNumbers, turned
from analytic.loads.numbers import BearingNumbers
from analytic.loads.race_contacts import put_unit
from analytic.loads.ring_rounds import (
    MOST_ROUNDS,
    OPEN,
    SETTLED,
    RingNumbers,
    Round,
    begin_rounds,
    hold_contacts,
    put_turning,
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
from analytic.numerics.records import Record, Records

STEADY = 1e-6  # relative, of the forces on a ball from one round to the next: a torque needs three digits
ROUGHLY_STEADY = 1e-4  # likewise, of a first or rough pass, which gives a start or a difference
SKIDS = 5  # beside the ends of `Round`: a ball finds no steady rotation
OF_CHANGE = 0.1  # residual of the rotation, over all friction, that is enough for a round, over the last change
LEAST_ANGLE, MOST_ANGLE = 1e-6, 1.5  # rad, where a search begins


@compiled
def _next_accuracy(nodes: FreeNodes, change: float) -> float:
    """For the round after one that changed angles or forces by this much, relative; nodes : of the first one."""
    return min(max(OF_CHANGE * change, ACCURACY), nodes.accuracy)


@compiled
def settle_free_thrust(
    bearing: BearingNumbers,
    free: FreeNumbers,
    speed: float,
    axial_load: float,
    ball: Record,
    contacts: Records,
    nodes: FreeNodes,
) -> Round:
    """The balls under thrust, which are alike, from where one of them is; writes it.

    speed : w, rad/s;  axial_load : Fa, N
    """
    push, correction = axial_load / bearing.ball_count, CorrectionNumbers(ball.inner_factors, ball.outer_factors)
    start = min(max(in_groove(ball.angle[0]), LEAST_ANGLE), MOST_ANGLE)
    last = ThrustedBall(np.tan(start), in_groove(ball.angle[0]), in_groove(ball.angle[1]), ball.load[0], ball.load[1])
    held, change, now = Held(0.0, 0.0, 0.0, 0.0, 0.0), 1.0, nodes
    for number in range(MOST_ROUNDS):
        inner, outer = contacts_at(bearing, in_groove(last.inner_angle), in_groove(last.outer_angle), correction)
        put_unit(ball.inner_unit, inner)
        put_unit(ball.outer_unit, outer)
        forces = turned(bearing, free, speed, ball, contacts, now)
        if not ball.residual <= max(ENOUGH, now.accuracy):
            return Round(SKIDS, number, ball.residual, ENOUGH)
        if not np.isnan(bearing.given_angle):  # which holds loads and angles, but not how the balls turn
            return Round(SETTLED, number, 0.0, nodes.steady)
        outward = forces.centrifugal / push
        inner_lean = -np.arctan(forces.inner_friction / last.inner_load)
        outer_lean = -np.arctan(forces.outer_friction / last.outer_load)
        if number >= STEADYING:
            outward = (outward + held.outward) / 2
            inner_lean, outer_lean = (inner_lean + held.inner_lean) / 2, (outer_lean + held.outer_lean) / 2
        held = Held(inner.approach, outer.approach, outward, inner_lean, outer_lean)
        found = balanced(bearing, push, held, last.tangent, ROUGH_STEP)
        change = change_of(last, found)
        ball.load[0], ball.load[1] = found.inner_load, found.outer_load
        ball.angle[0], ball.angle[1] = found.inner_angle, found.outer_angle
        if np.isnan(change):
            break
        # The balls keep the motion of the last round, so that this round must change nothing.
        if change <= nodes.steady:
            return Round(SETTLED, number, change, nodes.steady)
        last = found
        now = FreeNodes(nodes.coarse, nodes.fine, _next_accuracy(nodes, change), nodes.steady, nodes.scratch)
    return Round(OPEN, MOST_ROUNDS, change, nodes.steady)


@compiled
def settle_free_ring(
    numbers: RingNumbers,
    free: FreeNumbers,
    speed: float,
    ring: Record,
    balls: Records,
    contacts: Records,
    nodes: FreeNodes,
) -> Round:
    """The ring and its balls, from where they are; writes them. speed : w, rad/s;  contacts : (Z, 2)"""
    end, steps, now = Round(OPEN, 0, 0.0, 0.0), 0, nodes
    begin_rounds(ring, balls)
    for number in range(MOST_ROUNDS + 1):
        hold_contacts(numbers.bearing, balls)
        for j in range(len(balls)):
            ball = balls[j]
            put_turning(ball, turned(numbers.bearing, free, speed, ball, contacts[j], now))
            if not ball.residual <= max(ENOUGH, now.accuracy):
                return Round(SKIDS, number, ball.residual, ENOUGH)
        end = settle_round(numbers.grooves, ring, balls, number, nodes.steady)
        steps += end.steps
        if end.end != OPEN:
            break
        accuracy = _next_accuracy(nodes, nodes.steady * end.left / end.tolerance)
        now = FreeNodes(nodes.coarse, nodes.fine, accuracy, nodes.steady, nodes.scratch)
    return Round(end.end, steps, end.left, end.tolerance)
