"""Unilateral contact under a given load: which nodes carry it, and how far the bodies approach.

    gap + compliance f + drift Q - lever d >= 0,   f >= 0,   f (that gap) = 0,   sum(f lever) = Q

f: normal force of each touching node, d: approach, lever: cosine between normal and load.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cholesky

from analytic.errors import ConvergenceError

Array = NDArray[np.float64]
ROUNDS = 400  # two to eight are usual; 48 the most that 25 nodes took whose compliance spans nine decades
PATIENCE = 3  # rounds that may pass without fewer nodes in the wrong before nodes change sides one at a time
ROUND_OFF = 1e-12  # of an overlap, and of the share of a node's compliance that no other node explains
NOT_POSITIVE = (
    "Gaps or compliances are not finite, or the compliance is not positive definite: check that each body is held, "
    "moduli and Poisson ratios, and that no two nodes of the mesh coincide."
)
UNSETTLED = "Change the load or the size of the mesh by a per cent, or take another level of the recipe."


def press(
    *, compliance: Array, drift: Array, gap: Array, lever: Array, load: float, start: NDArray[np.bool_]
) -> tuple[Array, float, int]:
    """Forces (m,), N, the approach, m, and the rounds taken.

    compliance : (m, m) m/N, symmetric; positive definite, or there is no answer or many
    lever : (m,) positive
    start : (m,) nodes thought to touch; any start ends in the same answer

    Each round solves for the nodes that touch. Then all nodes in the wrong change sides, those that pull and those that
    overlap, as long as that leaves fewer and fewer; else the last of them alone, which never goes in circles where
    the compliance is positive definite (block pivoting by Portugal, Judice and Vicente, 1994, on Murty's, 1974; neither
    seen; the tests try every subset).
    Raises ConvergenceError if the compliance is not finite or not positive definite, or the nodes do not settle.
    """
    opened = gap + drift * load
    active = start.copy()
    if not active.any():
        active[np.argmin(gap)] = True
    missing, fewest, patience = load, gap.size + 1, PATIENCE
    is_finite = all(np.isfinite(part).all() for part in (compliance, opened, lever))
    if not is_finite or compliance.diagonal().min() <= 0:
        raise _stopped(0, missing, active, remedy=NOT_POSITIVE)
    for rounds in range(1, ROUNDS + 1):
        index = np.flatnonzero(active)
        system = np.zeros((index.size + 1, index.size + 1))
        system[:-1, :-1] = compliance[np.ix_(index, index)]
        if not is_positive_definite(system[:-1, :-1]):
            raise _stopped(rounds, missing, active, remedy=NOT_POSITIVE)
        system[:-1, -1] = -lever[index]
        system[-1, :-1] = lever[index]
        scale = system[0, 0]  # forces in N against an approach in m: bring both to one size
        system[:, -1] *= scale
        solution = np.linalg.solve(system, np.append(-opened[index], load))
        force = np.zeros_like(gap)
        force[index], approach = solution[:-1], float(solution[-1] * scale)
        pushed = compliance @ force
        overlap = lever * approach - opened - pushed
        round_off = ROUND_OFF * (abs(approach) + np.abs(pushed))
        wrong = np.where(active, force <= 0, overlap > round_off)
        count = int(wrong.sum())
        if count == 0:
            return force, approach, rounds
        # the pull of a node, or the force that would part one that overlaps
        missing = float(np.where(active, -force, overlap / compliance.diagonal())[wrong].max())
        if count < fewest:
            fewest, patience = count, PATIENCE
        elif patience > 0:
            patience -= 1
        else:
            wrong[: np.flatnonzero(wrong)[-1]] = False
        active ^= wrong  # never empty: of forces that carry the load one pushes
    raise _stopped(ROUNDS, missing, active, remedy=UNSETTLED)


def is_positive_definite(matrix: Array) -> bool:
    """Beyond round-off; `matrix` is symmetric and finite."""
    try:
        factor = cholesky(matrix, lower=True, check_finite=False)
    except LinAlgError:
        return False
    own = factor.diagonal() ** 2 / matrix.diagonal()  # of each node's compliance, the share that those before leave
    return bool(own.min() > ROUND_OFF)


def _stopped(rounds: int, missing: float, active: NDArray[np.bool_], *, remedy: str) -> ConvergenceError:
    return ConvergenceError(
        iterations=rounds,
        residual=missing,
        tolerance=0.0,
        problem=f"contact with {np.count_nonzero(active)} of {active.size} nodes touching",
        remedy=remedy,
    )
