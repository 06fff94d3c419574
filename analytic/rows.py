"""Rows of a result, one for each operating point: what JSON holds of arrays, and what is known of its numbers."""

from dataclasses import dataclass
from typing import Annotated, TypeVar

from annotated_types import Ge, Gt, Lt

T = TypeVar("T")  # of a group of numbers: Array at every operating point, (n,), or float at one of them
Positive = Annotated[float, Gt(0)]
NotNegative = Annotated[float, Ge(0)]
Count = Annotated[int, Gt(0), Lt(2**63)]
Two = tuple[float, float]


@dataclass(frozen=True, kw_only=True)
class OperatingPoint:
    """Speed and loads."""

    inner_speed: float  # rad/s
    axial_load: float  # N
    radial_load: float  # N
    moment: float  # N m
