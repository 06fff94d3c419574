"""Compiled formulas: a scalar kernel for each, and loops over them, cached where a folder is writable.

A kernel takes and gives numbers or NamedTuples of them. It raises nothing: where it fails it gives NaN or a status.
"""

from collections.abc import Callable
from contextlib import suppress
from typing import Any, TypeVar

import numpy as np
from numba import njit
from numpy.typing import ArrayLike

from analytic.scene import Array

Function = TypeVar("Function", bound=Callable[..., Any])
PLAIN = bool | int | float | tuple


def compiled(function: Function) -> Function:
    """Compile and cache; without a cache where no folder is writable (a read-only installation without a home).

    The cache holds what the function takes from elsewhere too, which numba does not notice: when a compiled function
    that it calls, a NamedTuple or a constant has changed, it is compiled anew. They must stand above it.
    """
    try:
        kernel: Any = njit(cache=True, error_model="numpy")(function)
    except RuntimeError:
        return njit(error_model="numpy")(function)  # pyright: ignore[reportReturnType]
    with suppress(AttributeError):  # numba has no public way to say what else the compiled code depends on
        kernel._cache._cache_file._source_stamp = _stamp(kernel)
    return kernel


def rows_of(*values: ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """(k, n) for a compiled loop from k values that broadcast, and the shape of the n elements."""
    together = np.array(np.broadcast_arrays(*values), dtype=np.float64)
    return together.reshape(len(values), -1), together.shape[1:]


def _stamp(kernel: Any) -> tuple[Any, ...]:
    """What the compiled code of a kernel depends on: its file, and the stamps and constants that it names."""
    function = kernel.py_func
    named = [function.__globals__.get(name) for name in function.__code__.co_names]
    called = tuple(value._cache._cache_file._source_stamp for value in named if hasattr(value, "py_func"))
    constants = tuple(getattr(value, "_fields", value) for value in named if isinstance(value, PLAIN | type))
    return (kernel._cache._cache_file._source_stamp, called, constants)
