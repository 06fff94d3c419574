"""The friction of a ball with its numerical uncertainty, from three grids."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from analytic.errors import ConvergenceError, require_positive
from fembearing.creep.ball import Grid, RaceCreep, TurnedBall, TurningBall, turn_ball
from fembearing.grid_convergence import Estimate, observed_order

GRIDS = (Grid(8, 4), Grid(12, 6), Grid(16, 8), Grid(24, 12), Grid(32, 16))
LEAST_GRIDS = 3  # which an uncertainty takes
ORDER = 2.0  # of the error in the length and width of a rectangle, where slip does not turn round
# Where slip turns round the error is smaller and irregular. Half of Richardson's step was best on the balls of seeds
# 1000 to 1015 of validation/creep/run.py, and so large a factor held all but one of their quantities.
OF_STEP, CAUTIOUS = 0.5, 3.0
FLOOR = 1e-4  # relative: the least uncertainty claimed
TINY = 1e-300  # for a quantity that is 0 by symmetry, whose relative uncertainty is of any size
T = TypeVar("T")  # of each number: Estimate by the reference, float by production


class RaceFriction(NamedTuple, Generic[T]):
    """A ball on one race. Creepages are slip over the rolling speed.

    Signs of estimates are those of `ball.RaceCreep` and `rolling.Creepages`. By production moments and power resist.
    """

    creepage_along: T  # of the centre
    creepage_across: T
    spin_creepage: T  # 1/m; by production >= 0
    spin_moment: T  # N m
    rolling_moment: T  # int (t_x y^2/2 - t_y x y) dA/R, N m
    transverse_force: T  # on the ball, N
    slip_share: T  # of the area
    torque: T  # by sliding about the bearing axis, N m


@dataclass(frozen=True, kw_only=True, eq=False)
class CreepReference:
    """Friction of one ball on both races."""

    inner: RaceFriction[Estimate]
    outer: RaceFriction[Estimate]
    torque: Estimate  # by sliding of this ball about the bearing axis, N m
    finest: TurnedBall  # on the last grid, with maps of traction and slip
    grids: tuple[Grid, ...]  # the last three


def creep_reference(ball: TurningBall, *, tolerance: float = 0.01) -> CreepReference:
    """The friction of a ball that turns steadily between its races.

    tolerance : of the torque by sliding, relative, > 0
    Grids become finer until the uncertainty of the torque is below the tolerance; the last grid ends this in any case.
    A grid on which the ball does not settle is left out, once: with few strips a ball that only rolls may not.
    Raises InputError and ConvergenceError as `ball.turn_ball` does.
    """
    require_positive(tolerance=tolerance)
    grids: list[Grid] = []
    turned: list[TurnedBall] = []
    for number, grid in enumerate(GRIDS):
        try:
            turned.append(turn_ball(ball, grid, turned[-1] if turned else None))
        except ConvergenceError:
            if len(turned) < number:  # the second one
                raise
            continue
        grids.append(grid)
        if len(grids) < LEAST_GRIDS:
            continue
        torque = _estimate(turned, grids, lambda each: each.torque)
        if torque.uncertainty <= tolerance * abs(torque.value):
            break
    inner, outer = (_race_estimates(turned, grids, k) for k in range(2))
    torque = _estimate(turned, grids, lambda each: each.torque)
    last = grids[-LEAST_GRIDS:]
    return CreepReference(inner=inner, outer=outer, torque=torque, finest=turned[-1], grids=tuple(last))


def _race_estimates(turned: list[TurnedBall], grids: list[Grid], race: int) -> RaceFriction[Estimate]:
    def of(quantity: Callable[[RaceCreep], float]) -> Estimate:
        return _estimate(turned, grids, lambda each: quantity(each.races[race]))

    return RaceFriction(
        creepage_along=of(lambda each: each.friction.creepages.along),
        creepage_across=of(lambda each: each.friction.creepages.across),
        spin_creepage=of(lambda each: each.friction.creepages.spin),
        spin_moment=of(lambda each: each.spin_moment),
        rolling_moment=of(lambda each: each.rolling_moment),
        transverse_force=of(lambda each: each.transverse_force),
        slip_share=_at_border(of(lambda each: each.friction.slip_share), grids[-1]),
        torque=of(lambda each: each.torque),
    )


def _estimate(turned: list[TurnedBall], grids: list[Grid], quantity: Callable[[TurnedBall], float]) -> Estimate:
    """From the last three grids."""
    values, sizes = map(quantity, turned[-LEAST_GRIDS:]), (1 / grid.strips for grid in grids[-LEAST_GRIDS:])
    return estimate(tuple(map(float, values)), tuple(sizes))


def _at_border(share: Estimate, grid: Grid) -> Estimate:
    """A share of the area, which counts rectangles: a border across the ellipse is known to half of one along rolling.

    Three grids may agree by chance, so their differences alone do not bound it.
    """
    least = 2 / (np.pi * grid.cells)
    return replace(share, mesh=max(share.mesh, least / max(abs(share.value), TINY)))


def estimate(values: tuple[float, ...], sizes: tuple[float, ...]) -> Estimate:
    """Value and uncertainty from three grids, coarse to fine; sizes : of their rectangles, any unit, descending.

    The value is the finest one and half of Richardson's step of second order. The uncertainty is three times that step,
    or three times half of the step that the two coarser grids foretell, and 0.01 %.
    """
    first, middle, fine = values
    squares = np.array(sizes) ** ORDER
    step = float((fine - middle) * squares[2] / (squares[1] - squares[2]))
    foretold = float((middle - first) * squares[2] / (squares[0] - squares[1]))
    uncertainty = CAUTIOUS * max(abs(step), abs(foretold) / 2) + FLOOR * abs(fine)
    value = fine + OF_STEP * step
    return Estimate(
        values=values, order=observed_order(values, sizes), richardson=value, mesh=uncertainty / max(abs(value), TINY)
    )
