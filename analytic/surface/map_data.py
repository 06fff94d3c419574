"""What a file of a measured surface holds, and how many points a map may have."""

from typing import NamedTuple

from analytic.errors import InputError
from analytic.scene import Array

FEWEST_POINTS, MOST_POINTS = 32, 4096  # in each direction: fewer are no statistics, more need too much memory
FEWER = f"give {FEWEST_POINTS} to {MOST_POINTS} in each direction, or cut out a part"


class MapData(NamedTuple):
    """A map as its file has it."""

    heights: Array  # (rows, columns), m; NaN where nothing was measured
    spacings: tuple[float, float] | None = None  # of the points along x and y, m; None: the file has none
    doubts: tuple[str, ...] = ()


def require_matrix(shape: tuple[int, ...]) -> None:
    """Raise InputError for a shape that a map does not have."""
    if len(shape) != 2:
        raise InputError(f"has the shape {shape}; a height map is a matrix, rows by columns")
    if not all(FEWEST_POINTS <= size <= MOST_POINTS for size in shape):
        raise InputError(f"has {shape[0]} by {shape[1]} points; {FEWER}")
