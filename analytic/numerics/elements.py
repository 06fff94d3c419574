"""Some elements of a dataclass whose fields are arrays or numbers: of a contact, a law of traction."""

from collections.abc import Callable
from dataclasses import fields
from typing import Any, TypeVar

import numpy as np

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
