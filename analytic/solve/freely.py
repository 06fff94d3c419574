"""Free balls at a scene's operating points, by the quadrature that some of these choose."""

import numpy as np
from numpy.typing import NDArray

from analytic.free_ball.rotation import Creep
from analytic.loads.inertia import outward_force
from analytic.scene import Array, Scene, SlidingMethod
from analytic.solve.failures import require_settled
from analytic.solve.model import Model, workspace
from analytic.solve.records import SETTLED
from analytic.solve.solution import FAR, Solution, solved, tried_points

METHODS: dict[Creep, SlidingMethod] = {"none": "free_ball", "closed": "closed_creep", "marched": "marched_creep"}
# Speeds over that of a point at which a bearing comes there: from below and from above, in few steps and in many
RUNS = tuple(np.geomspace(first, 1.0, steps) for steps in (3, 8) for first in (0.5, 2.0))
SAME_STATE = 1e-3  # relative, of the torque: one that differs by less prints alike
SEARCHED = 2  # number of the quadrature of all runs: its error is common to both states, and finer ones take minutes
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


def other_states(model: Model, points: Array, found: Solution, is_wedged: NDArray[np.bool_]) -> Array:
    """(n,) race torque of the points in another steady state, the farthest that is found, N m; NaN: none is.

    points : (n, 5);  found : at these;  is_wedged : (n,) whether friction all but wedges balls there
    Several speeds of a ball's orbit are steady where centrifugal force presses it harder than the rings do, or the oil
    resists it more than friction drives it, and several loads where friction wedges it. Such a point is solved from
    closed kinematics, since the balls of a long series begin where those of the last point were. It is also solved from
    half its speed and from twice its speed, in steps that begin where the balls were; wedged balls, from half and twice
    the load.
    """
    bearing, balls, other = model.numbers.ring.bearing, found.balls, np.full(len(points), np.nan)
    orbit = balls["motion"]["cage_speed"] * points[:, 3:4]
    outward = np.mean(outward_force(bearing.ball_mass, bearing.pitch_diameter, orbit), axis=1)
    pressed_out = model.numbers.counted.centrifugal & (outward >= balls["load"][..., 0].mean(axis=1))
    lags = found.sliding_number.max(axis=0) > 1
    race = found.race_torque
    for i in map(int, np.flatnonzero((pressed_out | lags | is_wedged) & (race > 0))):
        fine = model.with_numbers(cold=False, passes=int(found.points["passes"][i])).at(np.array([i]))
        coarse = fine.with_numbers(passes=min(SEARCHED, fine.numbers.passes))
        one = solved(coarse, points[[i]]).race_torque[0]
        if abs(one / race[i] - 1) > SAME_STATE:  # by the quadrature, or in another state
            by_rule = solved(fine, points[[i]]).race_torque[0]
            if abs(by_rule / race[i] - 1) > SAME_STATE:
                other[i] = by_rule
        one = one if one > 0 else race[i]  # without it the quadrature's error counts as a difference of states
        changed = slice(0, 3) if is_wedged[i] else slice(3, 4)  # loads, or speed: dry balls turn alike at all speeds
        for run in RUNS:
            work, end = workspace(coarse), found
            for share in run:
                point = points[[i]].copy()
                point[0, changed] *= share
                end = solved(coarse.with_numbers(nearly=share != 1.0), point, work=work)
            ratio = end.race_torque[0] / one
            if abs(ratio - 1) > max(SAME_STATE, np.nan_to_num(abs(other[i] / race[i] - 1))):
                other[i] = ratio * race[i]
    return other


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
