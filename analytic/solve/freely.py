"""Free balls at a scene's operating points, by the quadrature that some of these choose."""

import numpy as np

from analytic.free_ball.rotation import Creep
from analytic.scene import Array, Scene, SlidingMethod
from analytic.solve.failures import require_settled
from analytic.solve.model import Model
from analytic.solve.records import SETTLED
from analytic.solve.solution import FAR, Solution, solved, tried_points

METHODS: dict[Creep, SlidingMethod] = {"none": "free_ball", "closed": "closed_creep", "marched": "marched_creep"}
BETWEEN = 1.25  # times the largest error at far points: what lies between them


def slide_freely(scene: Scene, model: Model, points: Array) -> tuple[Solution, Array]:
    """The balls at every operating point, (n, 5), and the error of their torque by sliding, (n,), relative to it.

    Up to FAR points refine their quadratures until the error is allowed. In a longer series so many far points do, and
    all points take the finest of these, each from where the last one has settled.
    Raises ConvergenceError where a ball finds no steady rotation, or loads and rotation do not settle.
    """
    if len(points) <= FAR:
        found = solved(model, points)
        require_settled(scene, model, points, found)
        return found, error_of_sliding(found)
    at_far = settled_at_far_points(scene, model, points)
    series = model.with_numbers(passes=int(at_far.points["passes"].max()), cold=False)
    found = solved(series, points)
    require_settled(scene, series, points, found)
    # Of the whole torque where sliding is a part of it: the quadrature is as fine as its largest part asks for.
    error, whole = error_of_sliding(at_far), (error_of_sliding(at_far) * part_by_sliding(at_far)).max()
    return found, BETWEEN * np.minimum(error.max(), whole / np.maximum(part_by_sliding(found), 1e-300))


def settled_at_far_points(scene: Scene, model: Model, points: Array) -> Solution:
    """Up to FAR points of a series, which choose the quadrature of all; each refines its own.

    points : (n, 5);  model : its allowed error holds for all points, so those between the far ones have room
    Raises ConvergenceError as `slide_freely`.
    """
    far = tried_points(points, float(model.numbers.arm))
    strict = model.with_numbers(allowed=model.numbers.allowed / BETWEEN).at(far)
    found = solved(strict, points[far])
    require_settled(scene, strict, points[far], found)
    return found


def part_by_sliding(found: Solution) -> Array:
    """(n,) share of the race torque."""
    race = found.race_torque
    return np.divide(found.sliding_torque, race, out=np.where(np.isnan(race), 1.0, 0.0), where=race > 0)


def error_of_sliding(found: Solution) -> Array:
    """(n,) of the torque by sliding, relative to it; infinite where there is none."""
    torque = found.sliding_torque
    error = np.where(found.points["status"] == SETTLED, found.points["sliding_error"], np.inf)
    return np.divide(error, torque, out=np.where(np.isinf(error), np.inf, 0.0), where=torque > 0)
