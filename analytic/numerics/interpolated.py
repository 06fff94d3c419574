"""A smooth quantity at many points from a sample of them, where it is costly and depends on a few numbers per point.

Radial basis functions interpolate between the points of the sample. The sample grows where the interpolation may be
wrong: far from its points, where the last two interpolations disagree, and anywhere at random. The points that join
show the error of the interpolation before.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.compilation import compiled
from analytic.scene import Array

FIRST, MORE, MOST = 48, 16, 512  # points of a sample: at first, each time it grows by doubt and by chance, in all
TRIED = 2048  # points, by chance, at which interpolations are compared
# The bound on the error anywhere is so many times the largest error at the points that joined, in the last two rounds:
# a kink may pass between the points (compared in tests/analytic/numerics/test_interpolated.py).
SAFETY = 4.0
IN_A_ROW = 2
SEED = 20
FLAT = 1e-6  # of the widest extent, below which points lie on a line


@dataclass(frozen=True, kw_only=True, eq=False)
class SampledSeries:
    """n points, q quantities."""

    values: Array  # (n, q)
    at: NDArray[np.intp]  # the points that were computed
    error: float  # bound on the error, in the caller's measure


def sampled_series(
    evaluate: Callable[[NDArray[np.intp]], Array],
    coordinates: Array,
    *,
    missed: Callable[[Array, Array, NDArray[np.intp]], Array],
    allowed: Callable[[], float],
) -> SampledSeries | None:
    """The quantities at all points, or None where no sample is good enough.

    evaluate : indices (k,) -> quantities there, (k, q)
    coordinates : (n, d) the numbers that they depend on, in units in which they are about equally smooth (logarithms,
        say)
    missed : (interpolated, true, indices) -> measure of the error at each of them, (k,)
    allowed : limit of that measure, asked after each evaluation
    """
    from scipy.interpolate import RBFInterpolator  # 0.1 s to import, which few scenes need

    if not np.any(np.ptp(coordinates, axis=0)):
        return None  # the same point each time
    points = _principal(coordinates)
    few = FIRST + MORE
    if len(np.unique(points[:, 0])) < few and len(np.unique(points, axis=0)) < few:
        return None  # a sample of so few different points is all of them
    chance = np.random.default_rng(SEED)
    tried = chance.choice(len(points), min(TRIED, len(points)), replace=False)
    at = far_points(coordinates, FIRST)
    known, errors = evaluate(at), [np.inf]

    def through(count: int) -> RBFInterpolator:
        return RBFInterpolator(points[at[:count]], known[:count], kernel="cubic")

    before, last = through(len(at) - len(at) // 3), through(len(at))
    while len(at) < min(MOST, len(points)) and allowed() > 0:  # else it is wrong wherever the others lie
        doubt = np.max(np.abs(last(points[tried]) - before(points[tried])), axis=1)
        joining = tried[_spread(points[tried], MORE, points[at], doubt + np.mean(doubt))]
        joining = np.setdiff1d(np.concatenate([joining, chance.choice(len(points), MORE, replace=False)]), at)
        if joining.size == 0:
            break
        true = evaluate(joining)
        errors.append(SAFETY * float(np.max(missed(last(points[joining]), true, joining))))
        at, known = np.concatenate([at, joining]), np.concatenate([known, true])
        before, last = last, through(len(at))
        if max(errors[-IN_A_ROW:]) <= allowed():
            values = last(points)
            values[at] = known
            return SampledSeries(values=values, at=at, error=max(errors[-IN_A_ROW:]))
    return None


def far_points(coordinates: Array, count: int) -> NDArray[np.intp]:
    """Indices of `count` points or fewer: none of the others is farther from all of them than they are from each other.

    coordinates : (n, d)
    """
    points = _principal(coordinates) if np.any(np.ptp(coordinates, axis=0)) else coordinates
    return _spread(points, count, np.empty((0, points.shape[1])), np.ones(len(points)))


def _principal(coordinates: Array) -> Array:
    """Coordinates in the directions in which the points extend at all: points on a line have one."""
    centred = coordinates - coordinates.mean(axis=0)
    _, extent, directions = np.linalg.svd(centred, full_matrices=False)
    return centred @ directions[extent > FLAT * extent[0]].T


@compiled
def _spread(points: Array, count: int, known: Array, weight: Array) -> NDArray[np.intp]:
    """Indices of `count` points or fewer that are far from known places, (k, d), and from each other; none twice.

    weight : (n,) of each point; the point with the largest distance squared times weight comes next. Without known
    places the first one is the farthest from 0.
    """
    order, nearest = np.empty(count, np.int64), np.full(len(points), np.inf)
    for place in known:
        _approach(nearest, points, place)
    if len(known) == 0:
        _approach(nearest, points, np.zeros(points.shape[1]))
    for number in range(count):
        farthest = np.argmax(nearest * weight)
        if len(known) == 0 and number == 0:
            nearest[:] = np.inf
        elif nearest[farthest] == 0:
            return order[:number]
        order[number] = farthest
        _approach(nearest, points, points[farthest])
    return order


@compiled
def _approach(nearest: Array, points: Array, place: Array) -> None:
    """Lower the distances squared to the nearest place by one more place."""
    for i in range(len(points)):
        distance = 0.0
        for k in range(len(place)):
            distance += (points[i, k] - place[k]) ** 2
        nearest[i] = min(nearest[i], distance)
