"""Cubic splines as tables of numbers, for compiled formulas: SciPy makes them, and nothing of it is needed later."""

from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.scene import Array


class Cubic(NamedTuple):
    """A piecewise cubic; the first and the last piece extrapolate."""

    left: Array  # (pieces,) where each piece begins, rising
    coefficients: Array  # (pieces, 4) of the distance from there, highest power first


@compiled
def cubic_at(cubic: Cubic, x: float) -> tuple[float, float]:
    """Value and slope at x."""
    piece, beyond = 0, cubic.left.size
    while beyond - piece > 1:
        middle = (piece + beyond) // 2
        if cubic.left[middle] < x:
            piece = middle
        else:
            beyond = middle
    c3, c2, c1, c0 = cubic.coefficients[piece]
    d = x - cubic.left[piece]
    return ((c3 * d + c2) * d + c1) * d + c0, (3 * c3 * d + 2 * c2) * d + c1


def smooth_cubic(x: Array, y: Array) -> Cubic:
    """With continuous curvature, through points of rising x."""
    from scipy.interpolate import CubicSpline  # a fifth of a second to import, only for rough surfaces

    return _cubic(x, CubicSpline(x, y).c)


def monotone_cubic(x: Array, y: Array) -> Cubic:
    """With continuous slope, through points of rising x; it rises or falls as the points do, at the ends too.

    There the slope of SciPy's monotone cubic may be 0; here it is at least a third of that of the last piece.
    """
    from scipy.interpolate import CubicHermiteSpline, PchipInterpolator  # slow to import, only for rough surfaces

    slopes = np.array(PchipInterpolator(x, y).derivative()(x))
    pieces = np.diff(y) / np.diff(x)
    for end in (0, -1):
        slopes[end] = np.sign(pieces[end]) * np.clip(abs(slopes[end]), abs(pieces[end]) / 3, 3 * abs(pieces[end]))
    return _cubic(x, CubicHermiteSpline(x, y, slopes).c)


def _cubic(x: Array, coefficients: Array) -> Cubic:
    return Cubic(np.array(x[:-1], dtype=np.float64), np.array(np.transpose(coefficients), dtype=np.float64, order="C"))
