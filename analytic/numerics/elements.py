"""Elements of arrays: some of those of a dataclass, their shares, and formulas of each."""

from collections.abc import Callable
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from analytic.scene import Array

Each = TypeVar("Each")


def elements_of(each: Each, choose: Callable[[Any], Any]) -> Each:
    """The same dataclass with chosen elements of each array or number; other fields stay.

    They are as valid as all elements are, and so nothing is checked again.
    """
    chosen = object.__new__(type(each))
    for field in fields(each):  # pyright: ignore[reportArgumentType]
        value = getattr(each, field.name)
        vars(chosen)[field.name] = choose(value) if isinstance(value, np.ndarray | float) else value
    return chosen


def share_in(part: Array, total: Array) -> Array:
    """part/total, 0 where there is nothing to share; both broadcast."""
    return np.divide(part, total, out=np.zeros(np.broadcast(part, total).shape), where=total > 0)


def rows_of(*values: ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """(k, n) for a loop over n elements from k values that broadcast, and the shape of the elements."""
    shape = np.broadcast(*values).shape
    together = np.empty((len(values), *shape))
    for row, value in enumerate(values):
        together[row] = value
    return together.reshape(len(values), -1), shape


def mapped(function: Callable[..., Any], *values: ArrayLike) -> Array:
    """The results of a function of numbers for each element of values that broadcast.

    function : mostly a compiled formula. Python calls it, in some microseconds for each element: more than some
        thousand elements need a compiled loop. It gives a number, or a tuple of k numbers, which becomes the first axis
    Raises ValueError if the shapes do not fit together.
    """
    arrays = np.broadcast_arrays(*(np.asarray(value, dtype=np.float64) for value in values))
    each = zip(*(array.ravel().tolist() for array in arrays), strict=True)
    found = np.array([function(*numbers) for numbers in each], dtype=np.float64)
    if found.size == 0:
        found = np.empty((0, *np.shape(function(*(np.nan for _ in values)))))
    return np.moveaxis(found, 0, -1).reshape(found.shape[1:] + arrays[0].shape)
