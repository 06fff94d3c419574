"""Deflection of a half space under pressure that is uniform on each cell of a tensor grid.

Love's integral of a rectangle. Source: [Johnson1985] section 3.8.
"""

import numpy as np

from analytic.scene import Array


def _corner(x: Array, y: Array) -> Array:
    """The integral of 1/r from the origin to (x, y)."""
    u, v = np.maximum(np.abs(x), 1e-150), np.maximum(np.abs(y), 1e-150)  # without division by 0
    far = np.sqrt(u**2 + v**2)
    return x * np.sign(y) * np.log((v + far) / u) + y * np.sign(x) * np.log((u + far) / v)


def half_space_integrals(x: Array, y: Array, x_faces: Array, y_faces: Array) -> Array:
    """(n, n) integrals of 1/r over each cell and its mirror image at y < 0, at the centre of each cell.

    x, y : centres;  x_faces, y_faces : limits of the cells, one more each, y_faces from 0; one unit of length
    The cells are counted along y first. The result has that unit; over pi E* it is the deflection under unit pressure.
    """
    across = np.concatenate([-y_faces[:0:-1], y_faces]) - y[:, None]
    found = np.empty((x.size, y.size, x.size, y.size))
    for integrals, centre in zip(found, x, strict=True):  # one column after the other, for the memory
        corners = _corner((x_faces - centre)[:, None], across[:, None])
        cells = np.diff(np.diff(corners, axis=1), axis=2)
        integrals[:] = cells[..., y.size :] + cells[..., y.size - 1 :: -1]
    return found.reshape(x.size * y.size, -1)
