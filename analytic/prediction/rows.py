"""A prediction with a row for each operating point, and the groups of numbers that it is made of."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Generic

import numpy as np
from annotated_types import MinLen

from analytic.brief import Brief
from analytic.prediction.spreads import UncertainInput
from analytic.rows import Count, NotNegative, OperatingPoint, T, Two
from analytic.scene import Array

COVERED = 0.95  # probability of an interval
ENDS = ((1 - COVERED) / 2, (1 + COVERED) / 2)


@dataclass(frozen=True, kw_only=True, eq=False)
class Interval(Brief, Generic[T]):
    """Of one quantity, each (n,), or at one operating point, N m."""

    low: T  # 2.5 % of the values lie below
    median: T
    high: T  # 2.5 % lie above
    low_error: T  # standard error
    high_error: T

    @property
    def ends(self) -> tuple[T, T]:
        """The low and the high end, N m."""
        return self.low, self.high


@dataclass(frozen=True, kw_only=True, eq=False)
class SobolIndices(Brief, Generic[T]):
    """Of the total for d inputs: each (d, n), or (d,) at one operating point."""

    first: T  # share of the variance by the input alone
    total: T  # share with its products with others
    first_error: T  # standard error, a share
    total_error: T  # standard error, a share


@dataclass(frozen=True, kw_only=True)
class PredictedPoint(OperatingPoint):
    """The interval at one operating point."""

    nominal: float  # N m
    total: Interval[float]
    parts: Mapping[str, Interval[float]]  # by the parts of the torque
    made_of: Mapping[str, Two]  # ends of the total's interval if nothing else were uncertain, N m
    indices: SobolIndices[tuple[float, ...]]
    explained: float  # share of the variance of the total that the regression predicts


@dataclass(frozen=True, kw_only=True)
class PredictionRows:
    """A torque with its interval, a row for each operating point."""

    covered: float  # probability
    points: Annotated[tuple[PredictedPoint, ...], MinLen(1)]
    inputs: Annotated[tuple[UncertainInput, ...], MinLen(1)]
    not_varied: tuple[str, ...]  # what the interval does not know, in words
    samples: Count
    failed: int  # of them
    reasons: tuple[str, ...]  # why
    seed: int
    seconds: NotNegative
    evaluation_seconds: NotNegative

    def __post_init__(self) -> None:
        """Raises ValueError for indices of other inputs than those listed, and for unknown parts of the interval."""
        for point in self.points:
            if {len(values) for values in vars(point.indices).values()} != {len(self.inputs)}:
                raise ValueError(f"has indices of other than its {len(self.inputs)} inputs")
            if not {"input", "model", "numerical"} >= {name for name in point.made_of if "." not in name}:
                raise ValueError(f"is made of unknown parts: {', '.join(point.made_of)}")
            if point.made_of.keys() != self.points[0].made_of.keys():
                raise ValueError("is made of other parts at other points")

    @property
    def failures(self) -> str:
        """How many samples failed and why, in words; empty where none did."""
        words = f"{self.failed} of {self.samples} samples have no torque and are left out: {'; '.join(self.reasons)}."
        return words if self.failed else ""

    @property
    def ends(self) -> list[PredictedPoint]:
        """The slowest and the fastest operating point, of equal ones the first; one where they are the same."""
        known = [point for point in self.points if np.isfinite(point.nominal)]
        by_speed = sorted(known, key=lambda point: abs(point.inner_speed))
        return by_speed[:1] if by_speed[0].nominal == by_speed[-1].nominal else [by_speed[0], by_speed[-1]]

    @property
    def ranked(self) -> list[int]:
        """The inputs from the one with the largest total index at any of `ends`."""
        largest = [max(point.indices.total[place] for point in self.ends) for place in range(len(self.inputs))]
        return sorted(range(len(largest)), key=lambda place: -largest[place])

    @property
    def largest_error(self) -> float:
        """The largest standard error of an end of the total, over that end."""
        ends = [(p.total.low, p.total.low_error) for p in self.points]
        ends += [(p.total.high, p.total.high_error) for p in self.points]
        return max((error / abs(end) for end, error in ends if np.isfinite(end) and end), default=0.0)

    @property
    def explained(self) -> float:
        """The least share of the variance, at any point, that the indices are of; 0 where the regression fails."""
        return max(0.0, min(point.explained for point in self.points if np.isfinite(point.explained)))


def largest_error(interval: Interval[Array]) -> float:
    """The standard error of an end over that end, relative, the largest of all; 0 where an end is 0."""
    ends = ((interval.low_error, interval.low), (interval.high_error, interval.high))
    return float(np.max([np.divide(e, np.abs(v), out=np.zeros_like(e), where=v != 0) for e, v in ends]))
