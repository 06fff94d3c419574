"""Compilation of loops, cached where a folder is writable. Imported on demand: numba takes half a second to import."""

from collections.abc import Callable
from typing import TypeVar

from numba import njit

Function = TypeVar("Function", bound=Callable)


def compiled(function: Function) -> Function:
    """Compile and cache; without a cache where no folder is writable (a read-only installation without a home)."""
    try:
        return njit(cache=True, error_model="numpy")(function)
    except RuntimeError:
        return njit(error_model="numpy")(function)
