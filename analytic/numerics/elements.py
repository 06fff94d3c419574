"""Elements of arrays: some of those of a dataclass, and their shares."""

from collections.abc import Callable
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np

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
