"""Cubic splines as tables of numbers, for compiled formulas.

They are those of SciPy, whose import would take a quarter of the time of the first torque of a process.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from analytic.numerics.elements import formula
from analytic.scene import Array


class Pieces(NamedTuple):
    """A cubic spline: rows of an array (rows, 5), which other splines may share.

    A row is where a piece begins, and the coefficients of the distance from there, highest power first. The first and
    the last piece extrapolate. Compiled formulas share one array, because numba counts references to each at each call.
    """

    first: int
    beyond: int  # the row after the last


@formula
def cubic_at(rows: Array, pieces: Pieces, x: float) -> tuple[float, float]:
    """Value and slope at x."""
    piece, beyond = pieces.first, pieces.beyond
    while beyond - piece > 1:
        middle = (piece + beyond) // 2
        if rows[middle, 0] < x:
            piece = middle
        else:
            beyond = middle
    d, c3, c2, c1 = x - rows[piece, 0], rows[piece, 1], rows[piece, 2], rows[piece, 3]
    return ((c3 * d + c2) * d + c1) * d + rows[piece, 4], (3 * c3 * d + 2 * c2) * d + c1


def together(*splines: Array) -> tuple[Array, list[Pieces]]:
    """One array of several splines, and where each of them is."""
    ends = np.cumsum([0, *map(len, splines)])
    return np.concatenate(splines), [Pieces(int(a), int(b)) for a, b in pairwise(ends)]


def smooth_cubic(x: Array, y: Array) -> Array:
    """Rows of a spline with continuous curvature, through four or more points of rising x.

    The third derivative is continuous at the second point and at the last but one ("not a knot").
    """
    steps = np.diff(x)
    return _rows(x, y, _smooth_slopes(steps, np.diff(y) / steps))


def monotone_cubic(x: Array, y: Array) -> Array:
    """Rows of a spline with continuous slope, through three or more points of rising x.

    It rises or falls as the points do, at the ends too: a slope inside is the weighted harmonic mean of those of the
    pieces beside it, and 0 at an extremum. At an end it is that of the parabola through three points, at least a third
    of that of the last piece, and at most three times as much. Source: [Fritsch1984].
    """
    steps = np.diff(x)
    pieces = np.diff(y) / steps
    ahead, behind = 2 * steps[1:] + steps[:-1], steps[1:] + 2 * steps[:-1]  # weights of the piece before and after
    rises = pieces[1:] * pieces[:-1] > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        means = (ahead + behind) / (ahead / pieces[:-1] + behind / pieces[1:])
    slopes = np.concatenate([[0.0], np.where(rises, means, 0.0), [0.0]])
    for end, beside in ((0, 1), (-1, -2)):
        near, next_ = steps[end], steps[beside]
        parabola = ((2 * near + next_) * pieces[end] - near * pieces[beside]) / (near + next_)
        least, most = abs(pieces[end]) / 3, 3 * abs(pieces[end])
        slopes[end] = np.sign(pieces[end]) * np.clip(parabola * np.sign(pieces[end]), least, most)
    return _rows(x, y, slopes)


def _smooth_slopes(steps: Array, pieces: Array) -> Array:
    """(n + 1,) slopes at the points, by elimination; steps, pieces : (n,) in x, and their slopes."""
    last = steps.size
    slopes, above = np.empty(last + 1), np.empty(last + 1)  # of the diagonal, which becomes 1
    both = steps[0] + steps[1]
    above[0] = both / steps[1]
    slopes[0] = ((steps[0] + 2 * both) * pieces[0] + steps[0] ** 2 / steps[1] * pieces[1]) / both
    for i in range(1, last):
        pivot = 2 * (steps[i - 1] + steps[i]) - steps[i] * above[i - 1]
        above[i] = steps[i - 1] / pivot
        right = 3 * (steps[i] * pieces[i - 1] + steps[i - 1] * pieces[i])
        slopes[i] = (right - steps[i] * slopes[i - 1]) / pivot
    both = steps[-1] + steps[-2]
    right = (steps[-1] ** 2 * pieces[-2] + (2 * both + steps[-1]) * steps[-2] * pieces[-1]) / both
    slopes[last] = (right - both * slopes[last - 1]) / (steps[-2] - both * above[last - 1])
    for i in range(last - 1, -1, -1):
        slopes[i] -= above[i] * slopes[i + 1]
    return slopes


def _rows(x: Array, y: Array, slopes: Array) -> Array:
    """Of the cubic between each two points with these slopes."""
    steps = np.diff(x)
    pieces = np.diff(y) / steps
    bend = (slopes[:-1] + slopes[1:] - 2 * pieces) / steps
    square = (pieces - slopes[:-1]) / steps - bend
    return np.column_stack([x[:-1], bend / steps, square, slopes[:-1], y[:-1]])
