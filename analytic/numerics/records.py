"""Records of numbers for compiled formulas: the named fields of a named tuple in one block of memory.

A compiled function takes a record by its address. A tuple of as many numbers is an argument for each of them, which
costs time at every call and multiplies that of compiling.
"""

from functools import cache
from typing import TYPE_CHECKING, Any, TypeVar, cast, get_args, get_origin, get_type_hints

import numpy as np

# Type checkers know no fields of records.
Record = Any  # one record
Records = Any  # an array of records
Numbers = TypeVar("Numbers")
# A field of a named tuple: a number in compiled formulas and records, and where Python calls also an array of them.
if TYPE_CHECKING:
    Real = Any
else:
    Real = float

SCALARS = {float: np.float64, int: np.int64, bool: np.bool_}


@cache
def dtype_of(numbers: type) -> np.dtype:
    """The structured type of a named tuple whose fields are numbers, pairs of numbers, and such named tuples."""
    return np.dtype([(name, *_field_of(hint)) for name, hint in get_type_hints(numbers).items()], align=True)


def record_of(numbers: Numbers) -> Numbers:
    """A named tuple of numbers as a record; formulas take either, field by field."""
    return cast(Numbers, np.array([numbers], dtype=dtype_of(type(numbers))).view(np.recarray)[0])


def as_record(element: Any) -> Record:
    """An element of a structured array as a record, which compiled formulas take."""
    return element if isinstance(element, np.record) else element.reshape(1).view(np.recarray)[0]


def as_records(value: Any) -> Any:
    """A record, or an array of them, with fields as attributes; anything else as it is."""
    if isinstance(value, np.void):
        return as_record(value)
    return value.view(np.recarray) if isinstance(value, np.ndarray) and value.dtype.names else value


def copied(records: Any) -> Records:
    """A copy of an array of records, or an array of one from a record; `record_in` gives that back.

    NumPy copies structured arrays field by field, which takes forty times as long as their bytes. It reads and writes
    nested fields of an array ten times as fast as those of a record.
    """
    copy = np.frombuffer(bytearray(records.tobytes()), records.dtype)
    return copy if isinstance(records, np.void) else copy.reshape(records.shape)


def record_in(records: Records) -> Record:
    """The record of an array of one, in its memory."""
    return records.view(np.recarray)[0]


def _field_of(hint: Any) -> tuple[Any, ...]:
    if get_origin(hint) is tuple:
        first, *rest = get_args(hint)
        return *_field_of(first), 1 + len(rest)
    return (SCALARS[hint],) if hint in SCALARS else (dtype_of(hint),)
