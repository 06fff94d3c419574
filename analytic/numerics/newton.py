"""Least convex energy of many problems at once, by Newton's method with a line search.

Each step is halved until it lowers the energy by Armijo's share of what the slope promises [Armijo1966]. Problems that
have converged drop out, so that each has the result that it has alone.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from analytic.errors import ConvergenceError
from analytic.numerics.rows import merged, part_of
from analytic.scene import Array

# Usual are 3 to 15 steps; contacts that touch and part take up to some 50. A ball that next to nothing holds follows
# its groove in small steps, some 300.
MOST_STEPS = 1000
LEAST_DESCENT = 1e-4  # of what the slope promises: the customary share
# Of the tangent's trace: keeps the step finite along a freedom that nothing holds, and is well below the softest
# freedom that a loaded contact holds.
LEAST_TANGENT = 1e-13


@dataclass(frozen=True, kw_only=True, eq=False)
class ConvexState:
    """n problems of d freedoms, each at one place. A problem adds its own fields in a subclass, n rows each."""

    place: Array  # (n, d) m
    energy: Array  # (n,) J
    gradient: Array  # (n, d) of the energy, N
    tangent: Array  # (n, d, d) second derivative, N/m
    tolerance: Array  # (n,) on the residual, N
    energy_rounding: Array  # (n,) J
    longest_step: Array  # (n,) m, > 0

    @property
    def residual(self) -> Array:
        """(n,) largest component of the gradient, N."""
        return np.max(np.abs(self.gradient), axis=-1)


State = TypeVar("State", bound=ConvexState)


def least_energy(
    evaluate: Callable[[Array, State], State], start: State, *, problem: str, remedy: str
) -> tuple[State, NDArray[np.intp]]:
    """The state of each problem where the energy is least, and the Newton steps that it took, (n,).

    evaluate : (place, state) -> the state of the same problems at another place
    A freedom that nothing holds is left where it is. Where nothing holds at all, the gradient gives the direction and
    longest_step the length.
    problem, remedy : words of the ConvergenceError where the residual stays above its tolerance
    """
    state, steps = start, np.zeros(len(start.place), dtype=np.intp)
    for _ in range(MOST_STEPS):
        rows = np.flatnonzero(~(state.residual <= state.tolerance))  # a residual that is not a number is open too
        if not len(rows):
            return state, steps
        state = merged(state, rows, _stepped(evaluate, part_of(state, rows)))
        steps[rows] += 1
    worst = int(np.argmax(state.residual / np.maximum(state.tolerance, 1e-300)))
    raise ConvergenceError(
        iterations=MOST_STEPS,
        residual=float(state.residual[worst]),
        tolerance=float(state.tolerance[worst]),
        problem=problem,
        remedy=remedy,
    )


def _stepped(evaluate: Callable[[Array, State], State], state: State) -> State:
    """The state after one Newton step, which is halved where it lowers the energy too little."""
    longest = state.longest_step
    trace = np.trace(state.tangent, axis1=-2, axis2=-1)
    least = LEAST_TANGENT * trace + LEAST_TANGENT * state.residual / longest
    held = state.tangent + least[:, None, None] * np.eye(state.place.shape[-1])
    step = -np.linalg.solve(held, state.gradient[..., None])[..., 0]
    step *= np.minimum(1.0, longest / np.maximum(np.max(np.abs(step), axis=-1), longest))[:, None]
    slope = np.sum(state.gradient * step, axis=-1)
    share = np.ones(len(step))
    while True:
        trial = evaluate(state.place + share[:, None] * step, state)
        short = trial.energy > state.energy + LEAST_DESCENT * share * slope + state.energy_rounding
        if not np.any(short):
            return trial
        share = np.where(short, share / 2, share)
