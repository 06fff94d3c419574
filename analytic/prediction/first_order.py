"""The 95 % interval of a torque by moving one uncertain input at a time: an estimate at the price of a few torques.

Each input moves the logarithm of the torque by some amount up and down when it goes to the ends of its own 95 %. Inputs
are independent, so the squares of these changes add up, those that raise the torque for the upper end and those that
lower it for the lower end. Products of two inputs are neglected; `analytic.prediction.prediction` samples them.
"""

import numpy as np
from scipy.special import ndtri

from analytic.errors import FembearingError
from analytic.prediction.evaluation import Problem, problem_of, torque_at
from analytic.prediction.rows import ENDS
from analytic.prediction.spreads import uncertain_inputs
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene

SCORES = tuple(float(ndtri(end)) for end in ENDS)  # of a normal input at the ends of its 95 %


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
    problem = problem_of(scene, nominal, uncertain_inputs(scene))
    total, count = nominal.torque.total, len(problem.inputs)
    try:
        base = torque_at(problem, np.zeros(count))[0]
        changes = [_changes(problem, place, base) for place in range(count)]
    except FembearingError:
        return None
    lowered = np.sqrt(sum((np.minimum(each.min(axis=0), 0.0) ** 2 for each in changes), np.zeros_like(total)))
    raised = np.sqrt(sum((np.maximum(each.max(axis=0), 0.0) ** 2 for each in changes), np.zeros_like(total)))
    return total * np.exp([-lowered, raised])


def _changes(problem: Problem, place: int, base: Array) -> Array:
    """Of ln(total) as one input goes to each of its ends, (2, n); 0 where nothing resists.

    base : (n,) total with all inputs as they are, N m
    """
    scores = np.zeros(len(problem.inputs))
    found = []
    for score in SCORES:
        scores[place] = score
        moved = torque_at(problem, scores)[0]
        found.append(np.log(np.divide(moved, base, out=np.ones_like(base), where=(base > 0) & (moved > 0))))
    return np.array(found)
