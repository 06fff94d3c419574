"""Dataclasses of arrays with one row for each operating point: take some rows out, and put them back."""

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

Rows = TypeVar("Rows")  # a dataclass of arrays, or of such dataclasses, with a row for each operating point


def part_of(whole: Rows, index: NDArray[np.intp]) -> Rows:
    """The rows at the index, which rises, of every array."""
    if len(index) == len(next(iter(vars(whole).values()))):
        return whole
    fields = vars(whole).items()
    return type(whole)(**{k: v[index] if isinstance(v, np.ndarray) else part_of(v, index) for k, v in fields})


def merged(whole: Rows, index: NDArray[np.intp], part: Rows) -> Rows:
    """The whole with the rows at the index, which rises, taken from the part."""
    if len(index) == len(next(iter(vars(whole).values()))):
        return part
    fields = {}
    for name, new in vars(part).items():
        old = getattr(whole, name)
        if isinstance(new, np.ndarray):
            fields[name] = old.copy()
            fields[name][index] = new
        else:
            fields[name] = merged(old, index, new)
    return type(whole)(**fields)
