"""Compilation of loops, cached where a folder is writable. Imported on demand: numba takes half a second to import."""

from collections.abc import Callable
from typing import Any

from numba import njit


def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """Compile and cache; without a cache where no folder is writable (a read-only installation without a home)."""
    try:
        return njit(cache=True, error_model="numpy")(function)
    except RuntimeError:
        return njit(error_model="numpy")(function)
