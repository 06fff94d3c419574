"""Newton's method with a line search towards the least of a convex energy: its steps, for compiled loops.

The loops stand where their energies do (`analytic.loads.ball_balance`, `analytic.loads.ring_balance`). Each step is
halved until it lowers the energy by Armijo's share of what the slope promises [Armijo1966].
"""

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.scene import Array

# Usual are 3 to 15 steps; contacts that touch and part take up to some 50. A ball that next to nothing holds follows
# its groove in small steps, some 300.
MOST_STEPS = 1000
LEAST_DESCENT = 1e-4  # of what the slope promises: the customary share
# Of the tangent's trace: keeps the step finite along a freedom that nothing holds, and is well below the softest
# freedom that a loaded contact holds.
LEAST_TANGENT = 1e-13


@compiled
def is_too_long(energy: float, trial: float, promised: float, rounding: float) -> bool:
    """Whether a step has to be halved, because it leads to a trial energy that is not low enough; J.

    promised : slope along the step times the step, < 0;  rounding : of the energies
    """
    return trial > energy + LEAST_DESCENT * promised + rounding


@compiled
def newton_step(tangent: Array, gradient: Array, longest: float, factor: Array, step: Array) -> float:
    """Write Newton's step, at most `longest` in each freedom, and return what the slope promises for it, J.

    tangent : (d, d) second derivative of the energy, symmetric, N/m;  gradient : (d,), N;  step : (d,), m
    factor : (d, d) to work in
    A freedom that nothing holds is left where it is. Where nothing holds at all, the gradient gives the direction and
    `longest` the length.
    """
    freedoms = gradient.size
    trace = residual = 0.0
    for i in range(freedoms):
        trace += tangent[i, i]
        residual = max(residual, abs(gradient[i]))
    least = LEAST_TANGENT * (trace + residual / longest)
    for i in range(freedoms):  # Cholesky's factor, and the forward substitution
        right = -gradient[i]
        for j in range(i + 1):
            value = tangent[i, j]
            for k in range(j):
                value -= factor[i, k] * factor[j, k]
            if i == j:
                factor[i, i] = np.sqrt(value + least)
            else:
                factor[i, j] = value / factor[j, j]
                right -= factor[i, j] * step[j]
        step[i] = right / factor[i, i]
    size = longest
    for i in range(freedoms - 1, -1, -1):
        value = step[i]
        for k in range(i + 1, freedoms):
            value -= factor[k, i] * step[k]
        step[i] = value / factor[i, i]
        size = max(size, abs(step[i]))
    promised = 0.0
    for i in range(freedoms):
        step[i] *= longest / size
        promised += gradient[i] * step[i]
    return promised


@compiled
def plane_step(
    tangent: tuple[float, float, float], gradient: tuple[float, float], longest: float
) -> tuple[float, float]:
    """`newton_step` in a plane, m; tangent : its elements xx, xy and yy, N/m."""
    residual = max(abs(gradient[0]), abs(gradient[1]))
    least = LEAST_TANGENT * (tangent[0] + tangent[2] + residual / longest)
    xx, xy, yy = tangent[0] + least, tangent[1], tangent[2] + least
    determinant = xx * yy - xy * xy
    x = (xy * gradient[1] - yy * gradient[0]) / determinant
    y = (xy * gradient[0] - xx * gradient[1]) / determinant
    share = longest / max(abs(x), abs(y), longest)
    return share * x, share * y
