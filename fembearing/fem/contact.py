"""Unilateral contact under a given load: which nodes carry it, and the approach of the bodies.

    gap + compliance f + drift Q - lever d >= 0,   f >= 0,   f (that gap) = 0,   sum(f lever) = Q

f: normal force of each touching node, Q: load, d: approach, lever: cosine of the angle between normal and load.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cholesky

from analytic.errors import ConvergenceError
from analytic.scene import Array

ROUNDS = 400  # two to eight are usual; 25 nodes whose compliance spans nine decades took 48 at most
PATIENCE = 3  # rounds without a decrease of the wrong nodes, after which nodes change one at a time
ROUND_OFF = 1e-12  # relative, of an overlap, and of a pivot in the factorisation of the compliance
NOT_POSITIVE = (
    "Gaps or compliances are not finite, or the compliance is not positive definite: check that each body is held, "
    "moduli and Poisson ratios, and that no two nodes of the mesh coincide."
)
UNSETTLED = "Change the load or the size of the mesh by a per cent, or take another level of the recipe."


def press(
    *, compliance: Array, drift: Array, gap: Array, lever: Array, load: float, start: NDArray[np.bool_]
) -> tuple[Array, float, int]:
    """Forces (m,), N, the approach, m, and the number of rounds.

    compliance : (m, m) m/N, symmetric positive definite: only then is there exactly one answer
    lever : (m,) positive
    start : (m,) first guess of the nodes that touch; every start ends in the same answer

    Each round solves for the nodes that are taken to touch. A node is wrong if it pulls, or if it overlaps without
    touching. All wrong nodes change sets as long as their number decreases; otherwise the last of them alone changes,
    which cannot cycle where the compliance is positive definite.
    Source: block pivoting [Portugal1994] on the method of [Murty1974]; the tests try every subset of nodes.
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
        scale = system[0, 0]  # gives forces in N and the approach in m the same magnitude
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
        # the force with which a node pulls, or that would open an overlap
        missing = float(np.where(active, -force, overlap / compliance.diagonal())[wrong].max())
        if count < fewest:
            fewest, patience = count, PATIENCE
        elif patience > 0:
            patience -= 1
        else:
            wrong[: np.flatnonzero(wrong)[-1]] = False
        active ^= wrong  # never empty: forces that carry the load include one that pushes
    raise _stopped(ROUNDS, missing, active, remedy=UNSETTLED)


def is_positive_definite(matrix: Array) -> bool:
    """Whether a symmetric and finite matrix is positive definite beyond round-off."""
    try:
        factor = cholesky(matrix, lower=True, check_finite=False)
    except LinAlgError:
        return False
    pivots = factor.diagonal() ** 2 / matrix.diagonal()  # share of each diagonal that the rows before do not explain
    return bool(pivots.min() > ROUND_OFF)


def _stopped(rounds: int, missing: float, active: NDArray[np.bool_], *, remedy: str) -> ConvergenceError:
    return ConvergenceError(
        iterations=rounds,
        residual=missing,
        tolerance=0.0,
        problem=f"contact with {np.count_nonzero(active)} of {active.size} nodes touching",
        remedy=remedy,
    )
