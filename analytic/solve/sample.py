"""A long series under thrust by a costly method of sliding: a sample of its points shows the method's difference.

Balls that are alike slide as load and speed have it. The torque by the cheapest method, which every point gets, differs
from that by another one by a smooth function of these two.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.interpolated import sampled_series
from analytic.scene import Array
from analytic.sliding.judge import SINGLE_COEFFICIENT
from analytic.solve.freely import BETWEEN, error_of_sliding
from analytic.solve.model import Model
from analytic.solve.solution import Solution, solved

BY_SLIP = ("spin", "conformity")


@dataclass(frozen=True, kw_only=True, eq=False)
class SampledSolution:
    """All points, of which a sample is computed by the method."""

    found: Solution
    computed: int  # number of points by the method
    error: float  # of the torque by sliding, relative to it: of the method, and of what lies between the sample


def slide_by_sample(model: Model, points: Array, allowed: Array) -> SampledSolution | None:
    """The points, (n, 5), under thrust by the model's method; None where no sample is good enough, or none pays.

    allowed : (n,) error, relative to the whole torque
    """
    base, speed = solved(model.with_numbers(method=SINGLE_COEFFICIENT, judges=False), points), np.abs(points[:, 3])
    moving, values = np.flatnonzero(speed), _quantities(base)
    whole = values[:, :2].sum(axis=1)
    if moving.size == 0 or base.points["status"].any() or not np.all(whole > 0) or not np.all(values[:, 2:] > 0):
        return None
    scale, worst = np.stack([whole, whole, values[:, 2], values[:, 3]], axis=1), 0.0

    def evaluate(chosen: NDArray[np.intp]) -> Array:
        nonlocal worst
        at = moving[chosen]
        found = solved(model.with_numbers(judges=True), points[at])
        worst = max(worst, BETWEEN * float(error_of_sliding(found).max()))
        return (_quantities(found) - values[at]) / scale[at]

    def relative_error(interpolated: Array, true: Array, chosen: NDArray[np.intp]) -> Array:
        before = (values[:, :2] / scale[:, :2])[moving[chosen]]
        return np.abs(np.sum((interpolated - true)[:, :2], axis=1) / np.sum(before + true[:, :2], axis=1))

    coordinates = np.log(np.stack([points[moving, 0], speed[moving]], axis=1))
    limit = float(allowed.min())
    # A point without a torque has an infinite error, which no sample may have.
    series = sampled_series(evaluate, coordinates, missed=relative_error, allowed=lambda: limit - worst)
    if series is None:
        return None
    values[moving] += scale[moving] * series.values
    still = np.flatnonzero(speed == 0)
    if still.size:
        standing = solved(model, points[still])
        if standing.points["status"].any():
            return None
        values[still] = _quantities(standing)
    for place, name in enumerate(BY_SLIP):
        base.points[name] = values[:, place]
    base.balls["friction_coefficient"] = values[:, None, 2:]
    return SampledSolution(found=base, computed=series.at.size + still.size, error=worst + series.error)


def _quantities(found: Solution) -> Array:
    """(n, 4) torques by spin and conformity, coefficients of inner and outer race."""
    torques = [found.points[name] for name in BY_SLIP]
    return np.concatenate([np.stack(torques, axis=1), found.balls["friction_coefficient"][:, 0]], axis=1)
