"""Roots of many rising functions at once, by Newton's method in a bracket.

scipy.optimize.elementwise.find_root needs no slopes, but its bookkeeping costs more than a closed form: on one spin
balance of `analytic.sliding.long_ellipse` it takes 5 times as long as this, and on 1000 at once still 3 times.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from analytic.errors import ConvergenceError
from analytic.numerics.compilation import compiled
from analytic.scene import Array

# Each step halves the bracket or the step before the last; 4 to 8 are usual, and bisection alone takes 60.
MOST_STEPS = 200


@compiled
def cube_root(x: float) -> float:
    """Of a number of either sign. Numba compiles each np.cbrt for itself, and this once."""
    return np.cbrt(x)


class Sought(NamedTuple):
    """What is sought, in the words of an error."""

    problem: str
    unit: str  # of x
    remedy: str


def bracketed_root(
    rising: Callable[[Array], tuple[Array, Array]],
    *,
    start: Array,
    low: Array,
    high: Array,
    relative: float,
    absolute: float = 0.0,
    sought: Sought,
) -> Array:
    """x between low and high where each function is 0; arrays of one shape.

    rising : x -> (values, slopes); a value that is no more than round-off should be given as 0, which ends the search
    start : between low and high;  relative, absolute : tolerances, |last step| <= relative |x| + absolute
    sought : words of the ConvergenceError, which is raised where a value is not a number
    A slope may be too flat, of the wrong sign, 0 or not finite: the bracket is then halved. A slope that is far too
    steep makes too small a step, which may be taken for the last. Without a change of sign x moves to one end.
    """
    x, last, before = start, high - low, high - low
    settled = np.zeros(np.shape(start), dtype=bool)
    for _ in range(MOST_STEPS):
        value, slope = rising(x)
        low, high = np.where(value < 0, x, low), np.where(value > 0, x, high)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            step = -value / slope
            newton = (x + step >= low) & (x + step <= high) & (np.abs(step) <= np.abs(before) / 2)
        settled = settled | (value == 0)
        before, last = last, np.where(settled, 0.0, np.where(newton, step, (low + high) / 2 - x))
        x = x + last
        settled = settled | ((np.abs(last) <= relative * np.abs(x) + absolute) & ~np.isnan(value))
        if settled.all():
            return x
    raise ConvergenceError(
        iterations=MOST_STEPS,
        residual=float(np.max(np.where(settled, 0.0, high - low))),
        tolerance=max(relative, absolute),
        unit=sought.unit,
        problem=sought.problem,
        remedy=sought.remedy,
    )
