"""Formulas that Python interprets, and that are a part of machine code, see `analytic.numerics.machine_code`.

    @compiled
    def slope(x: float) -> float: ...

Both call formulas by names of their modules, but not in a circle. Formulas raise nothing: one that fails gives NaN or a
status, and a division by zero gives infinity or NaN.
"""

import ctypes
from collections.abc import Callable
from functools import cached_property, update_wrapper
from types import CodeType, FunctionType
from typing import Any, TypeVar, overload

import numpy as np

from analytic.numerics.records import as_records
from analytic.scene import Array

Function = TypeVar("Function", bound=Callable[..., Any])
Freedoms = frozenset[str]  # of the compiler with floating point: flags of LLVM
EXACT: Freedoms = frozenset()


@overload
def compiled(function: Function, /) -> Function: ...
@overload
def compiled(*, fastmath: Freedoms = EXACT, inline: bool = False) -> Callable[[Function], Function]: ...
def compiled(function: Any = None, /, *, fastmath: Freedoms = EXACT, inline: bool = False) -> Any:
    """A formula; inline : into others, before types are known, which is quicker where it takes many tuples."""
    options = {"fastmath": {*fastmath}, "inline": "always" if inline else "never"}
    return Compiled(function, options) if function else lambda function: Compiled(function, options)


class Compiled:
    """A formula: interpreted by Python, a part of the machine code of an entry."""

    def __init__(self, function: FunctionType, options: dict[str, Any]) -> None:
        self.function, self.options = function, options  # of numba.njit
        update_wrapper(self, function)

    def __call__(self, *given: Any) -> Any:
        with np.errstate(all="ignore"):
            return self.interpreted(*map(_as_compiled, given))

    @cached_property
    def interpreted(self) -> FunctionType:
        """The formula and all that it calls in Python, for numbers of NumPy, which divide by zero."""
        return self._calling({name: each.interpreted for name, each in self._called().items()})

    @cached_property
    def inside(self) -> Any:
        """The function of numba that other formulas call."""
        from numba import njit

        options: Any = {"error_model": "numpy", "no_cpython_wrapper": True, "no_cfunc_wrapper": True, **self.options}
        return njit(**options)(self._calling({name: each.inside for name, each in self._called().items()}))

    def _calling(self, called: dict[str, Any]) -> FunctionType:
        around = self.function.__globals__ | called
        copy = FunctionType(self.function.__code__, around, argdefs=self.function.__defaults__)
        update_wrapper(copy, self.function)
        return copy

    def _called(self) -> dict[str, "Compiled"]:
        around = self.function.__globals__
        found = {name: around.get(name) for name in _names(self.function.__code__)}
        return {name: each for name, each in found.items() if isinstance(each, Compiled)}


class _FromMemory(Compiled):
    """Numbers at an address, for a law of traction that has its table there: an array would be an argument of its own.

    Whoever gives an address keeps the array.
    """

    @cached_property
    def inside(self) -> Any:
        import numba
        from numba import types
        from numba.extending import intrinsic

        def to_pointer(typing: Any, address: Any) -> Any:  # noqa: ARG001 - numba's signature
            def code(context: Any, builder: Any, signature: Any, given: Any) -> Any:
                return builder.inttoptr(given[0], context.get_value_type(signature.return_type))

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


rows_at: Any = _FromMemory(_rows_at, {})  # pyright: ignore[reportArgumentType]


def _names(code: CodeType) -> set[str]:
    """All that code, and comprehensions in it, may take from its module."""
    inside = (_names(value) for value in code.co_consts if isinstance(value, CodeType))
    return {*code.co_names}.union(*inside)


def _as_compiled(value: Any) -> Any:
    """An argument with numbers that divide by zero, and with records that have attributes."""
    if isinstance(value, float):
        return np.float64(value)
    if isinstance(value, tuple):
        made = map(_as_compiled, value)
        return type(value)(*made) if hasattr(value, "_fields") else tuple(made)
    return as_records(value)
