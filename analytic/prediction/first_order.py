"""The 95 % interval of a torque by moving one uncertain input at a time: an estimate at the price of a few torques.

Each input moves the logarithm of the torque by some amount up and down when it goes to the ends of its own 95 %. Inputs
are independent, so the squares of these changes add up, those that raise the torque for the upper end and those that
lower it for the lower end. Products of two inputs are neglected; `analytic.prediction.prediction` samples them.
"""

from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from statistics import NormalDist
from typing import NamedTuple

import numpy as np

from analytic.errors import FembearingError
from analytic.prediction.evaluation import cores, problem_of, torque_at
from analytic.prediction.rows import ENDS
from analytic.prediction.spreads import uncertain_inputs
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene

SCORES = tuple(map(NormalDist().inv_cdf, ENDS))  # of a normal input at the ends of its 95 %


class MovedTotals(NamedTuple):
    """The total torque of a scene as one uncertain input at a time moves, N m."""

    base: Array  # (n,) with all inputs as they are
    moved: Mapping[str, Array]  # (2, n) by the key of the input, at both ends of its 95 %


def first_order_ends(scene: Scene, nominal: FrictionTorque) -> Array | None:
    """Both ends of the 95 % interval of the total, N m, (2, n); None where an input at its end leaves no torque.

    Parameters
    ----------
    scene : Scene
        As in `friction_torque`.
    nominal : FrictionTorque
        Its torque.

    Raises
    ------
    InputError
        As `uncertain_inputs`.
    """
    totals = moved_totals(scene, nominal)
    return None if totals is None else nominal.torque.total * end_factors(totals.base, totals.moved.values())


def moved_totals(scene: Scene, nominal: FrictionTorque) -> MovedTotals | None:
    """The totals of a scene; arguments and errors of `first_order_ends`. None: an input at its end leaves no torque."""
    problem = problem_of(scene, nominal, uncertain_inputs(scene))
    count = len(problem.inputs)
    scores = [end * score for score in np.eye(count) for end in SCORES]
    threads = ThreadPoolExecutor(cores())
    try:
        ends = list(threads.map(lambda score: torque_at(problem, score)[0], scores))
    except FembearingError:
        return None
    finally:
        threads.shutdown(cancel_futures=True)
    return MovedTotals(
        nominal.torque.total, {each.key: np.array(ends[2 * k : 2 * k + 2]) for k, each in enumerate(problem.inputs)}
    )


def end_factors(base: Array, moved: Iterable[Array]) -> Array:
    """Both ends of the 95 % interval of any positive quantities over their values, (2, n).

    base : (n,) with all inputs as they are;  moved : (2, n) each, with one input at both ends of its 95 %
    A quantity of 0, with which nothing resists, has the factor 1.
    """
    lowered, raised = np.zeros_like(base), np.zeros_like(base)
    for ends in moved:
        both = np.log(np.divide(ends, base, out=np.ones_like(ends), where=(base > 0) & (ends > 0)))
        lowered += np.minimum(both.min(axis=0), 0.0) ** 2
        raised += np.maximum(both.max(axis=0), 0.0) ** 2
    return np.exp([-np.sqrt(lowered), np.sqrt(raised)])
