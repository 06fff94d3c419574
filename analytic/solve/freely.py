"""The torque by sliding of free balls at a scene's operating points."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.errors import ConvergenceError
from analytic.free_ball.kernel import MOST_STEPS
from analytic.free_ball.rotation import Creep
from analytic.free_ball.turning import ENOUGH
from analytic.loads.balls import LoadedBalls
from analytic.loads.ring_series import unsettled_ring
from analytic.loads.thrust import unsettled
from analytic.numerics.interpolated import far_points
from analytic.oil.variation import Variation
from analytic.scene import Array, Scene, SlidingMethod
from analytic.sliding.methods import Sliding
from analytic.solve.kernel import STATUS_OF_ROUND
from analytic.solve.model import Model, model_of, workspace
from analytic.solve.records import NO_STEADY_ROTATION, OPEN_ANGLE
from analytic.solve.solution import Solution, points_of, solved

METHODS: dict[Creep, SlidingMethod] = {"none": "free_ball", "closed": "closed_creep", "marched": "marched_creep"}
FAR = 8  # points of a series that choose the quadrature of all
BETWEEN = 1.25  # times the largest error at far points: what lies between them


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeSliding:
    """The balls, and the torque by their sliding."""

    balls: LoadedBalls
    sliding: Sliding


def slide_freely(
    scene: Scene,
    counted: Mapping[str, bool],
    *,
    creep: Creep,
    correction: ContactCorrection | None,
    variation: Variation,
    allowed: float,
) -> FreeSliding:
    """The balls and their torque at every operating point.

    counted : whether each effect counts;  creep : of the surfaces;  allowed : error, relative to the whole torque
    correction : factors on Hertz's contacts in place of those of the fit for finite geometry
    Up to FAR points refine their quadratures until the error is allowed. In a longer series so many far points do, and
    all points take the finest of these, each from where the last one has settled.
    Raises ConvergenceError where a ball finds no steady rotation, or loads and rotation do not settle.
    """
    operation = scene.operation.as_series()
    model = model_of(scene, counted, creep=creep, allowed=allowed, correction=correction, variation=variation)
    points = points_of(operation, model.temperature)
    if len(points) <= FAR:
        found = solved(model, points)
        _require_settled(scene, model, points, found)
        error = _relative_error(found)
    else:
        at_far = settled_at_far_points(scene, model, points)
        series = model.with_numbers(passes=int(at_far.points["passes"].max()), cold=False)
        found = solved(series, points)
        _require_settled(scene, series, points, found)
        error = np.full(len(points), BETWEEN * _relative_error(at_far).max())
    is_ring = bool(points[:, 1:3].any() and counted["load_distribution"]) or bool(counted["weight"])
    method = "ring" if is_ring else "thrust"
    coefficients = found.balls["friction_coefficient"] if is_ring else found.balls["friction_coefficient"][:, :1]
    return FreeSliding(
        balls=found.loaded_balls(scene.bearing, method),
        sliding=Sliding(
            spin=found.points["spin"].copy(),
            conformity=found.points["conformity"].copy(),
            coefficient=np.moveaxis(coefficients, -1, 0),
            method=METHODS[creep],
            error=error,
        ),
    )


def settled_at_far_points(scene: Scene, model: Model, points: Array) -> Solution:
    """Up to FAR points of a series, which choose the quadrature of all; each refines its own.

    points : (n, 5);  model : its allowed error holds for all points, so those between the far ones have room
    Raises ConvergenceError as `slide_freely`.
    """
    far = far_points(points / np.maximum(np.abs(points).max(axis=0), 1e-300), FAR)
    strict = model.with_numbers(allowed=model.numbers.allowed / BETWEEN).at(far)
    found = solved(strict, points[far])
    _require_settled(scene, strict, points[far], found)
    return found


def _relative_error(found: Solution) -> Array:
    """(n,) of the torque by sliding."""
    torque = found.points["spin"] + found.points["conformity"]
    return np.divide(found.points["sliding_error"], torque, out=np.zeros_like(torque), where=torque > 0)


def _require_settled(scene: Scene, model: Model, points: Array, found: Solution) -> None:
    """Raise the error of the first point that has not settled."""
    # What else may be wrong, as a contact beyond its shoulder, is for the limits of the formulas.
    bad = np.flatnonzero(np.isin(found.points["status"], (OPEN_ANGLE, *STATUS_OF_ROUND[1:])))
    if bad.size == 0:
        return
    first = bad[:1]
    work = workspace(model)
    end = solved(model.at(first), points[first], work=work).points[0]
    if end["status"] == OPEN_ANGLE:
        raise unsettled(points[first, 0] / scene.bearing.ball_count, float(end["left"]), float(end["tolerance"]))
    if end["status"] == NO_STEADY_ROTATION:
        ball = int(end["worst_ball"])
        inner, outer = work.contacts[ball]["load"]
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=float(end["left"]),
            tolerance=ENOUGH,
            unit="of its friction",
            problem=f"the rotation of ball {ball} under {inner:.4g} N on the inner and {outer:.4g} N on the outer race",
            remedy='Raise the load or lower the speed, or give friction.spin_rule = "outer_control".',
        )
    numbers = model.numbers.ring
    rounds = {"end": STATUS_OF_ROUND.index(int(end["status"])), **{n: end[n] for n in ("steps", "left", "tolerance")}}
    raise unsettled_ring(scene.bearing, numbers.grooves, float(points[first, 3][0]), work.ring, work.balls, rounds)
