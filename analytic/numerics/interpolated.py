"""A smooth quantity at many points from a sample of them, where it is costly and depends on a few numbers per point.

Radial basis functions interpolate between the points of the sample. The sample grows where the interpolation may be
wrong: far from its points, where the last two interpolations disagree, and anywhere at random. The points that join
show the error of the interpolation before.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.scene import Array

FIRST, MORE, MOST = 48, 16, 512  # points of a sample: at first, each time it grows by doubt and by chance, in all
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
    at = far_points(coordinates, FIRST)
    known = evaluate(at)

    def interpolated(count: int) -> Array:
        return RBFInterpolator(points[at[:count]], known[:count], kernel="cubic")(points)

    before, last = interpolated(len(at) - len(at) // 3), interpolated(len(at))
    chance, errors = np.random.default_rng(SEED), [np.inf]
    while len(at) < min(MOST, len(points)):
        doubt = np.max(np.abs(last - before), axis=1)
        joining = _spread(points, MORE, known=at, weight=doubt + np.mean(doubt))
        joining = np.setdiff1d(np.concatenate([joining, chance.choice(len(points), MORE, replace=False)]), at)
        if joining.size == 0:
            break
        true = evaluate(joining)
        errors.append(SAFETY * float(np.max(missed(last[joining], true, joining))))
        at, known = np.concatenate([at, joining]), np.concatenate([known, true])
        before, last = last, interpolated(len(at))
        if max(errors[-IN_A_ROW:]) <= allowed():
            last[at] = known
            return SampledSeries(values=last, at=at, error=max(errors[-IN_A_ROW:]))
        if allowed() <= 0:
            break  # what is computed is not accurate enough, wherever the others lie
    return None


def far_points(coordinates: Array, count: int) -> NDArray[np.intp]:
    """Indices of `count` points or fewer: none of the others is farther from all of them than they are from each other.

    coordinates : (n, d)
    """
    points = _principal(coordinates) if np.any(np.ptp(coordinates, axis=0)) else coordinates
    return _spread(points, count, known=np.array([], dtype=np.intp), weight=np.ones(len(points)))


def _principal(coordinates: Array) -> Array:
    """Coordinates in the directions in which the points extend at all: points on a line have one."""
    centred = coordinates - coordinates.mean(axis=0)
    _, extent, directions = np.linalg.svd(centred, full_matrices=False)
    return centred @ directions[extent > FLAT * extent[0]].T


def _spread(points: Array, count: int, *, known: NDArray[np.intp], weight: Array) -> NDArray[np.intp]:
    """Indices of points that are far from the known ones and from each other; none twice.

    weight : (n,) of each point; the point with the largest distance squared times weight comes next
    """
    columns = np.ascontiguousarray(points.T)  # long rows add up several times as fast as short ones

    def distances(place: Array) -> Array:
        return np.sum((columns - place[:, None]) ** 2, axis=0)

    order = list(known[:0])
    nearest = np.full(len(points), np.inf)
    for index in known:
        nearest = np.minimum(nearest, distances(points[index]))
    if known.size == 0:
        nearest = distances(np.zeros(len(columns)))
    for _ in range(count):
        farthest = int(np.argmax(nearest * weight))
        if nearest[farthest] == 0:
            break
        if known.size == 0 and not order:
            nearest[:] = np.inf
        order.append(farthest)
        nearest = np.minimum(nearest, distances(points[farthest]))
    return np.array(order, dtype=np.intp)
