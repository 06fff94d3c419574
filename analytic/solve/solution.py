"""The kernel for a scene's operating points: records of points and balls, on all cores."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.contact.hertz import HertzContact, HertzNumbers
from analytic.loads.balls import LoadedBalls, balls_between
from analytic.loads.kinematics import BallKinematics, BallMotion
from analytic.numerics.records import Records
from analytic.scene import Array, Bearing, Operation
from analytic.solve.kernel import solve, solve_free
from analytic.solve.model import Model, Workspace, workspace
from analytic.solve.records import BALL, POINT

LEAST_SLICE = 64  # points for a thread of its own


@dataclass(frozen=True, kw_only=True, eq=False)
class Solution:
    """n operating points, Z balls."""

    points: Records  # (n,) of `records.POINT`
    balls: Records  # (n, Z) of `records.BALL`

    def loaded_balls(self, bearing: Bearing, method: Literal["thrust", "ring"]) -> LoadedBalls:
        """The balls as arrays by name; method : "thrust", where one stands for all"""
        balls = self.balls[:, :1] if method == "thrust" else self.balls
        contacts = [
            HertzContact(
                semi_axis_x=balls["semi_axis_rolling"][..., race],
                semi_axis_y=balls["semi_axis_transverse"][..., race],
                **{name: balls[name][..., race] for name in HertzNumbers._fields[2:]},
            )
            for race in (0, 1)
        ]
        return balls_between(
            bearing,
            method=method,
            load=np.moveaxis(balls["load"], -1, 0),
            angle=np.moveaxis(balls["angle"], -1, 0),
            contacts=(contacts[0], contacts[1]),
            motion=BallKinematics(**{name: balls["motion"][name] for name in BallMotion._fields}),
        )


def points_of(operation: Operation, temperature: float) -> Array:
    """(n, 5) operating points as the kernel takes them; temperature : of the oil, K"""
    given = (operation.axial_load, operation.radial_load, operation.moment, operation.inner_speed, temperature)
    return np.stack(np.broadcast_arrays(*given), axis=-1).astype(np.float64)


def solved(model: Model, points: Array, *, work: Workspace | None = None, keeps_balls: bool = True) -> Solution:
    """The kernel at n points, (n, 5); work : a state to begin with and to leave, for one thread; None: by rule."""
    count = len(points)
    out, balls = np.zeros(count, POINT), np.zeros((count, len(model.balls)) if keeps_balls else (0, 0), BALL)
    kernel = solve if model.creep is None else solve_free
    # Unequal loads, or weights, ask for a ring of all balls.
    has_ring = True if points[:, 1:3].any() or model.numbers.counted.weight else None
    threads = 1 if work is not None else min(os.cpu_count() or 1, max(count // LEAST_SLICE, 1))

    def solve_slice(part: NDArray[np.intp]) -> None:
        at = slice(part[0], part[-1] + 1)
        tables, numbers = model.tables, model.numbers
        if threads > 1:  # the kernel writes the oil of a point into the record
            numbers = model.with_numbers().numbers
            if len(tables.factors) > 1:
                tables = tables._replace(factors=tables.factors[at])
        kernel(numbers, tables, points[at], work or workspace(model), balls[at], out[at], has_ring)

    if threads == 1:
        solve_slice(np.arange(count))
    else:
        with ThreadPoolExecutor(threads) as pool:
            list(pool.map(solve_slice, np.array_split(np.arange(count), threads)))
    return Solution(points=out, balls=balls)
