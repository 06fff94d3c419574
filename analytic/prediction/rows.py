"""The groups of numbers that a prediction is made of."""

from dataclasses import dataclass

import numpy as np

from analytic.brief import Brief
from analytic.scene import Array

COVERED = 0.95  # probability of an interval
ENDS = ((1 - COVERED) / 2, (1 + COVERED) / 2)


@dataclass(frozen=True, kw_only=True, eq=False)
class Interval(Brief):
    """Of one quantity, each (n,), N m."""

    low: Array  # 2.5 % of the values lie below
    median: Array
    high: Array  # 2.5 % lie above
    low_error: Array  # standard error
    high_error: Array

    @property
    def ends(self) -> tuple[Array, Array]:
        """The low and the high end, N m."""
        return self.low, self.high

    @property
    def largest_error(self) -> float:
        """The standard error of an end over that end, relative, the largest of all; 0 where an end is 0."""
        ends = ((self.low_error, self.low), (self.high_error, self.high))
        return float(np.nanmax([np.divide(e, np.abs(v), out=np.zeros_like(e), where=v != 0) for e, v in ends]))


@dataclass(frozen=True, kw_only=True, eq=False)
class SobolIndices(Brief):
    """Of the total for d inputs, each (d, n)."""

    first: Array  # share of the variance by the input alone
    total: Array  # share with its products with others
    first_error: Array  # standard error, a share
    total_error: Array  # standard error, a share
