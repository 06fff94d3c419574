"""Cubic splines as tables of numbers, for compiled formulas: SciPy makes them, and nothing of it is needed later."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.scene import Array


class Pieces(NamedTuple):
    """A cubic spline: rows of an array (rows, 5), which other splines may share.

    A row is where a piece begins, and the coefficients of the distance from there, highest power first. The first and
    the last piece extrapolate. Compiled formulas share one array, because numba counts references to each at each call.
    """

    first: int
    beyond: int  # the row after the last


@compiled
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
    """Rows of a spline with continuous curvature, through points of rising x."""
    from scipy.interpolate import CubicSpline  # a fifth of a second to import, only for rough surfaces

    return _rows(x, CubicSpline(x, y).c)


def monotone_cubic(x: Array, y: Array) -> Array:
    """Rows of a spline with continuous slope, through points of rising x.

    It rises or falls as the points do, at the ends too. There the slope of SciPy's monotone cubic may be 0; here it is
    at least a third of that of the last piece.
    """
    from scipy.interpolate import CubicHermiteSpline, PchipInterpolator  # slow to import, only for rough surfaces

    slopes = np.array(PchipInterpolator(x, y).derivative()(x))
    pieces = np.diff(y) / np.diff(x)
    for end in (0, -1):
        slopes[end] = np.sign(pieces[end]) * np.clip(abs(slopes[end]), abs(pieces[end]) / 3, 3 * abs(pieces[end]))
    return _rows(x, CubicHermiteSpline(x, y, slopes).c)


def _rows(x: Array, coefficients: Array) -> Array:
    return np.column_stack([x[:-1], np.transpose(coefficients)])
