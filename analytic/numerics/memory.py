"""Numbers at an address: an array that compiled formulas take as one number, in place of an array.

Numba counts references to an array at each call, and an array among the fields of a law would make another type of it.
Whoever gives an address keeps the array: see `address_of`.
"""

import ctypes
from functools import cached_property
from typing import Any

import numpy as np

from analytic.numerics.compilation import Compiled, compiled
from analytic.scene import Array


class _FromMemory(Compiled):
    """A function that numba cannot have from Python: it reads memory."""

    def __call__(self, *given: Any) -> Any:
        return self.function(*given)

    @cached_property
    def inside(self) -> Any:
        import numba
        from numba.core import cgutils, types
        from numba.core.extending import intrinsic

        def to_pointer(typing: Any, address: Any) -> Any:  # noqa: ARG001 - numba's signature
            def code(context: Any, builder: Any, signature: Any, given: Any) -> Any:  # noqa: ARG001 - numba's signature
                return builder.inttoptr(given[0], cgutils.voidptr_t)

            return types.voidptr(types.int64), code

        typed: Any = numba  # it has no types
        pointer: Any = intrinsic(to_pointer)
        carray = typed.carray

        def rows_at(address, rows, columns):
            return carray(pointer(np.int64(address)), (rows, columns), np.float64)

        return typed.njit(no_cpython_wrapper=True, no_cfunc_wrapper=True)(rows_at)


def _rows_at(address: float, rows: int, columns: int) -> Array:
    """(rows, columns) numbers at an address, which a float holds exactly: addresses have at most 52 bits."""
    numbers = (ctypes.c_double * (rows * columns)).from_address(int(address))
    return np.ctypeslib.as_array(numbers).reshape(rows, columns)


class _Apart(Compiled):
    """A note to LLVM in the function that calls it."""

    def __call__(self, *given: Any) -> Any:
        return self.function(*given)

    @cached_property
    def inside(self) -> Any:
        from numba.core import types
        from numba.core.extending import intrinsic

        def noted(typing: Any) -> Any:  # noqa: ARG001 - numba's signature
            def code(context: Any, builder: Any, signature: Any, given: Any) -> Any:  # noqa: ARG001 - numba's signature
                builder.function.attributes.add("noinline")
                return context.get_dummy_value()

            return types.none(), code

        return intrinsic(noted)


def _stay_apart() -> None:
    """Callers jump to the function that calls this; without it they take its code, and slow down their own."""


rows_at: Any = _FromMemory(_rows_at, {})  # pyright: ignore[reportArgumentType]
stay_apart: Any = _Apart(_stay_apart, {})  # pyright: ignore[reportArgumentType]


@compiled
def address_of(rows: Array) -> float:
    """Address of an array in one block of memory, for as long as it exists; 0: it has no numbers."""
    return float(rows.ctypes.data) if rows.size > 0 else 0.0
