"""Unilateral contact under a given load: which nodes carry it, and how far the bodies approach.

    gap + compliance f + drift Q - lever d >= 0,   f >= 0,   f (that gap) = 0,   sum(f lever) = Q

f: normal force of each touching node, d: approach, lever: cosine between normal and load.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.errors import ConvergenceError

Array = NDArray[np.float64]
ROUNDS = 60  # two to eight are usual


def press(
    *, compliance: Array, drift: Array, gap: Array, lever: Array, load: float, start: NDArray[np.bool_]
) -> tuple[Array, float, int]:
    """Forces (m,), N, the approach, m, and the rounds taken.

    start : (m,) nodes thought to touch; any start ends in the same answer
    Raises ConvergenceError when the set of touching nodes does not settle.
    """
    opened = gap + drift * load
    active = start.copy()
    if not active.any():
        active[np.argmin(gap)] = True
    force = np.zeros_like(gap)
    overlap, approach = -opened, 0.0
    for rounds in range(1, ROUNDS + 1):
        index = np.flatnonzero(active)
        system = np.zeros((index.size + 1, index.size + 1))
        system[:-1, :-1] = compliance[np.ix_(index, index)]
        system[:-1, -1] = -lever[index]
        system[-1, :-1] = lever[index]
        scale = compliance[index[0], index[0]]  # forces in N against an approach in m: bring both to one size
        system[:, -1] *= scale
        solution = np.linalg.solve(system, np.append(-opened[index], load))
        force = np.zeros_like(gap)
        force[index], approach = solution[:-1], solution[-1] * scale
        overlap = lever * approach - opened - compliance @ force
        round_off = 1e-12 * approach
        settled = np.where(active, force > 0, overlap > round_off)
        if (settled == active).all():
            return force, float(approach), rounds
        active = settled
        if not active.any():
            active[np.argmin(gap)] = True
    missing = overlap / np.abs(compliance.diagonal())  # the force, N, that would part a node that overlaps
    raise ConvergenceError(iterations=ROUNDS, residual=float(max(missing.max(), -force.min())), tolerance=0.0)
