"""Formulas of each element of arrays, and shares of elements.

    @formula
    def slope(x: Positive, y: float) -> float: ...

Other formulas call it with numbers, as they call what is `@compiled`. Python calls it by position or by name with
numbers, with arrays that broadcast, and with named tuples of both, some microseconds for each element.
"""

from collections.abc import Callable, Iterator
from functools import cache, cached_property
from inspect import Signature, signature
from math import prod
from typing import Annotated, Any, Literal, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.compilation import Compiled
from analytic.numerics.records import SCALARS
from analytic.scene import Array

# Ranges of an argument, or of a field of one, which are checked where Python calls
Finite = Annotated[float, require_finite]
Positive = Annotated[float, require_positive]
NotNegative = Annotated[float, require_non_negative]


class Formula(Compiled):
    """A formula of numbers that Python calls for each element of arrays."""

    def __call__(self, *given: Any, **named: Any) -> Any:
        """Numbers or arrays of the broadcast shape, in the tuples that the formula returns.

        Raises InputError for an argument out of its range, or for shapes that do not fit together.
        """
        bound = self._signature.bind(*given, **named)
        bound.apply_defaults()
        taken: list[tuple[Any, Any, bool]] = []  # type and value of each argument, and whether it has arrays
        varying: list[tuple[str, Array]] = []
        for name, value in bound.arguments.items():
            hint = self._hints.get(name, Any)
            parts = list(_parts(name, hint, value))
            if varies := any(part.ndim for _, part in parts):
                varying += parts
            else:
                value = _with_numbers(hint, value, (part[()] for _, part in parts))
            taken.append((hint, value, varies))
        shape = _common_shape(varying)

        def of(numbers: Iterator[Any]) -> Any:
            return self.interpreted(
                *(_with_numbers(hint, value, numbers) if varies else value for hint, value, varies in taken)
            )

        with np.errstate(all="ignore"):
            columns = [np.broadcast_to(part, shape).ravel() for _, part in varying]
            found = [of(iter(numbers)) for numbers in zip(*columns, strict=True)]
            # Of numbers alone there is one call; without elements one of zeros says what there would be.
            return _together(found or [of(part.dtype.type(0) for _, part in varying)], shape)

    @cached_property
    def _signature(self) -> Signature:
        return signature(self.function)

    @cached_property
    def _hints(self) -> dict[str, Any]:
        return get_type_hints(self.function, include_extras=True)


def formula(function: Any) -> Formula:
    """A `@compiled` formula that Python calls with arrays too; their ranges are in the annotations."""
    return Formula(function, {"fastmath": set(), "inline": "never"})


def _parts(name: str, hint: Any, value: Any) -> Iterator[tuple[str, Array]]:
    """(name, array) of each number or array in an argument, which is in its range."""
    base, *checks = get_args(hint) if get_origin(hint) is Annotated else (hint,)
    if get_origin(base) is Literal and value not in get_args(base):
        raise InputError(f"{name} must be one of {', '.join(get_args(base))}, got {value!r}")
    if base in SCALARS:
        for check in checks:
            check(**{name: value})
        yield name, np.asarray(value, SCALARS[base])
    else:
        for (inner, of), each in zip(_fields(name, base), value if _fields(name, base) else (), strict=True):
            yield from _parts(inner, of, each)


@cache
def _fields(name: str, base: Any) -> list[tuple[str, Any]]:
    """(name, type) of the fields of a tuple; none of what a formula takes as a whole."""
    if hasattr(base, "_fields"):
        return list(get_type_hints(base, include_extras=True).items())
    return [(name, each) for each in get_args(base)] if get_origin(base) is tuple else []


def _with_numbers(hint: Any, value: Any, numbers: Iterator[Any]) -> Any:
    """An argument with the next numbers in it."""
    base = get_args(hint)[0] if get_origin(hint) is Annotated else hint
    if base in SCALARS:
        return next(numbers)
    fields = _fields("", base)
    if not fields:
        return value
    made = [_with_numbers(of, each, numbers) for (_, of), each in zip(fields, value, strict=True)]
    return base(*made) if hasattr(base, "_fields") else tuple(made)


def _common_shape(parts: list[tuple[str, Array]]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(part.shape for _, part in parts))
    except ValueError as problem:
        given = {name: str(part.shape) for name, part in parts if part.ndim}
        raise InputError(f"{', '.join(given)} have shapes {', '.join(given.values())}: give equal lengths") from problem


def _together(found: list[Any], shape: tuple[int, ...]) -> Any:
    """Results of elements as one, with arrays in the place of numbers."""
    if isinstance(found[0], tuple):
        columns = [_together(list(column), shape) for column in zip(*found, strict=True)]
        return type(found[0])(*columns) if hasattr(found[0], "_fields") else tuple(columns)
    return np.array(found)[: prod(shape)].reshape(shape)[()]


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
