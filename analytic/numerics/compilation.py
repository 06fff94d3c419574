"""Formulas compiled by numba (stand-in)."""
from typing import Any
import numba
import numpy as np
from numpy.typing import ArrayLike, NDArray


def compiled(function: Any = None, /, *, fastmath: Any = frozenset(), inline: bool = False) -> Any:
    def make(f: Any) -> Any:
        return numba.njit(f, cache=True, error_model="numpy", nogil=True, fastmath=set(fastmath) or False, inline="always" if inline else "never")

    return make(function) if function else make


def rows_of(*values: ArrayLike) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """(k, n) for a loop over n elements from k values that broadcast, and the shape of the elements."""
    shape = np.broadcast(*values).shape
    together = np.empty((len(values), *shape))
    for row, value in enumerate(values):
        together[row] = value
    return together.reshape(len(values), -1), shape
