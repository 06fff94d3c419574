"""Tensor grids that are fine where the film forms and coarsen with distance from the contact."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from analytic.scene import Array

LEVEL = 1e-9  # of their size, by which cells between two places differ that count as equal
FEWEST = 4  # cells along a direction


@dataclass(frozen=True, kw_only=True, eq=False)
class Grid:
    """Cells of the half domain y >= 0, counted along y first; all in one unit of length."""

    x_faces: Array  # (columns + 1,) from the end of the inlet to that of the outlet
    y_faces: Array  # (rows + 1,) from 0 to the far side

    @cached_property
    def x(self) -> Array:
        """(columns,) centres."""
        return (self.x_faces[1:] + self.x_faces[:-1]) / 2

    @cached_property
    def y(self) -> Array:
        """(rows,) centres."""
        return (self.y_faces[1:] + self.y_faces[:-1]) / 2

    @cached_property
    def widths_x(self) -> Array:
        """(columns,) of the cells along x."""
        return np.diff(self.x_faces)

    @cached_property
    def widths_y(self) -> Array:
        """(rows,) of the cells along y."""
        return np.diff(self.y_faces)

    @cached_property
    def areas(self) -> Array:
        """(columns, rows)."""
        return np.multiply.outer(self.widths_x, self.widths_y)

    @property
    def shape(self) -> tuple[int, int]:
        """Columns and rows."""
        return self.x.size, self.y.size


def graded_faces(places: Sequence[float], sizes: Sequence[float], *, refinement: float) -> Array:
    """Limits of cells from the first to the last place, whose size is linear between places, divided by refinement.

    places : ascending;  sizes : of the cells there at refinement 1, positive
    The number of cells is that of the sizes, rounded, at least 4. All sizes of grids of different refinement have one
    ratio.
    """
    x, size = np.asarray(places, dtype=float), np.asarray(sizes, dtype=float)
    step, (before, slope) = np.diff(x), _counted(places, sizes)
    level, safe = slope == 0.0, np.where(slope == 0.0, 1.0, slope)
    number = np.linspace(0.0, before[-1], max(round(refinement * float(before[-1])), FEWEST) + 1)
    piece = np.clip(np.searchsorted(before, number, side="right") - 1, 0, step.size - 1)
    along = number - before[piece]
    growing = size[piece] * np.expm1(slope[piece] * along) / safe[piece]
    faces = x[piece] + np.where(level[piece], size[piece] * along, growing)
    faces[[0, -1]] = x[[0, -1]]  # without round-off
    return faces


def usual_cells(places: Sequence[float], sizes: Sequence[float]) -> float:
    """Number of the cells that `graded_faces` gives at refinement 1, before it is rounded."""
    return float(_counted(places, sizes)[0][-1])


def _counted(places: Sequence[float], sizes: Sequence[float]) -> tuple[Array, Array]:
    """Cells before each place at refinement 1, and the slope of their size behind each but the last, 0: one size."""
    x, size = np.asarray(places, dtype=float), np.asarray(sizes, dtype=float)
    step, slope = np.diff(x), np.diff(size) / np.diff(x)
    slope = np.where(np.abs(slope) * step < LEVEL * size[:-1], 0.0, slope)
    safe = np.where(slope == 0.0, 1.0, slope)
    counts = np.where(slope == 0.0, step / size[:-1], np.log(size[1:] / size[:-1]) / safe)
    return np.concatenate([[0.0], np.cumsum(counts)]), slope
