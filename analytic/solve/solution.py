"""The kernel for a scene's operating points: records of points and balls, on all cores."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.records import Records
from analytic.scene import Array, Operation
from analytic.solve.kernel import solve
from analytic.solve.model import Model, Workspace, workspace
from analytic.solve.records import BALL, POINT

OF_POINT = ("axial_load", "radial_load", "moment", "inner_speed", "temperature")  # columns of operating points, SI
LEAST_SLICE = 64  # points for a thread of its own


@dataclass(frozen=True, kw_only=True, eq=False)
class Solution:
    """n operating points, m balls: all of the bearing, or one that stands for all."""

    points: Records  # (n,) of `records.POINT`
    balls: Records  # (n, m) of `records.BALL`

    @property
    def sliding_torque(self) -> Array:
        """(n,) by spin and conformity, N m; NaN where a point has no torque, here and below."""
        return self.points["spin"] + self.points["conformity"]

    @property
    def race_torque(self) -> Array:
        """(n,) of all that balls and races lose: spin, conformity, hysteresis and rolling, N m."""
        return np.sum([self.points[name] for name in ("spin", "conformity", "hysteresis", "rolling")], axis=0)

    @property
    def sliding_number(self) -> Array:
        """(2, n) rolling force of the oil on all balls over the most friction of each race."""
        force, most = self.points["rolling_force"].T, self.points["most_friction"].T
        return np.divide(force, most, out=np.where(force > 0, np.inf, 0.0), where=most > 0)

    def at(self, points: NDArray[np.intp]) -> "Solution":
        """The same at some of the operating points."""
        return Solution(points=self.points[points], balls=self.balls[points])


def points_of(operation: Operation, temperature: float) -> Array:
    """(n, 5) operating points as the kernel takes them; temperature : of the oil, K"""
    points = np.empty((np.size(operation.axial_load), len(OF_POINT)))
    for place, name in enumerate(OF_POINT[:4]):
        points[:, place] = getattr(operation, name)
    points[:, 4] = temperature
    return points


def solved(model: Model, points: Array, *, work: Workspace | None = None, keeps_balls: bool = True) -> Solution:
    """The kernel at n points, (n, 5); work : a state to begin with and to leave, for one thread; None: by rule."""
    count, points = len(points), np.ascontiguousarray(points)  # another layout would be compiled again, for seconds
    counted, unequal = model.numbers.counted, bool(points[:, 1:3].any() or abs(model.numbers.tilt) > 0)
    # Unequal loads, or weights, ask for a ring of all balls.
    weighs = counted.weight and (unequal or model.numbers.weighs_alike)
    columns = len(model.balls) if (unequal and counted.load_distribution) or weighs else 1
    out, balls = np.zeros(count, POINT), np.zeros((count, columns) if keeps_balls else (0, 0), BALL)
    threads = 1 if work is not None else min(os.cpu_count() or 1, max(count // LEAST_SLICE, 1))

    def solve_slice(part: NDArray[np.intp]) -> None:
        at = slice(part[0], part[-1] + 1)
        tables, numbers = model.tables, model.numbers
        if threads > 1:  # the kernel writes the oil of a point into the record
            numbers = model.with_numbers().numbers
            if len(tables.factors) > 1:
                tables = tables._replace(factors=tables.factors[at])
        solve(numbers, tables, points[at], work or workspace(model), balls[at], out[at], model.is_free)

    if threads == 1:
        solve_slice(np.arange(count))
    else:
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(solve_slice, np.array_split(np.arange(count), threads)))
    return Solution(points=out, balls=balls)
