"""Deflection of a half space under pressure that is uniform on each cell of a tensor grid.

Love's integral of a rectangle. Source: [Johnson1985] section 3.8.
"""

import math

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.scene import Array


@compiled
def _corner(x: float, y: float) -> float:
    """The integral of 1/r from the origin to (x, y)."""
    u, v = abs(x), abs(y)
    if u == 0.0 or v == 0.0:
        return 0.0
    r = math.sqrt(u * u + v * v)
    value = u * math.log((v + r) / u) + v * math.log((u + r) / v)
    return value if (x > 0.0) == (y > 0.0) else -value


@compiled
def half_space_integrals(x: Array, y: Array, x_faces: Array, y_faces: Array) -> Array:
    """(n, n) integrals of 1/r over each cell and its mirror image at y < 0, at the centre of each cell.

    x, y : centres;  x_faces, y_faces : limits of the cells, one more each, y_faces from 0; one unit of length
    The cells are counted along y first. The result has that unit; over pi E* it is the deflection under unit pressure.
    """
    columns, rows = x.size, y.size
    found = np.empty((columns * rows, columns * rows))
    above = np.empty((columns + 1, 2 * rows + 1))  # corners of the cells and of their images
    for i in range(columns):
        for j in range(rows):
            for k in range(columns + 1):
                for m in range(rows + 1):
                    above[k, rows + m] = _corner(x_faces[k] - x[i], y_faces[m] - y[j])
                for m in range(1, rows + 1):
                    above[k, rows - m] = _corner(x_faces[k] - x[i], -y_faces[m] - y[j])
            for k in range(columns):
                for m in range(rows):
                    right, left = rows + m + 1, rows - m
                    cell = above[k + 1, right] - above[k, right] - above[k + 1, right - 1] + above[k, right - 1]
                    image = above[k + 1, left] - above[k, left] - above[k + 1, left - 1] + above[k, left - 1]
                    found[i * rows + j, k * rows + m] = cell + image
    return found
