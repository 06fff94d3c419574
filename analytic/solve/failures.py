"""What is wrong at an operating point that has no torque: the words of each status, once."""

from dataclasses import replace

import numpy as np

from analytic.contact.geometry import RACES, shoulder_distances
from analytic.errors import ConvergenceError, FembearingError, InputError
from analytic.free_ball.kernel import MOST_STEPS
from analytic.free_ball.turning import ENOUGH
from analytic.loads.inertia import outward_force
from analytic.loads.ring_series import unsettled_ring
from analytic.loads.thrust import unsettled
from analytic.numerics.records import Records, copied, record_in
from analytic.oil.mixed import no_shared_load
from analytic.scene import Array, Bearing, Scene
from analytic.sliding.ellipse import no_creep_speed
from analytic.sliding.long_ellipse import no_spin_balance
from analytic.solve.kernel import MOST_CENTRIFUGAL, PRESSED, STATUS_OF_ROUND
from analytic.solve.model import Model, Workspace, workspace
from analytic.solve.records import (
    BEYOND_SHOULDER,
    NO_CREEP_SPEED,
    NO_DISTRIBUTION,
    NO_SHARED_LOAD,
    NO_SPIN_BALANCE,
    NO_STEADY_ROTATION,
    NO_THRUST,
    OPEN_ANGLE,
    THROWN,
    THROWN_WASHERS,
)
from analytic.solve.solution import OF_POINT, Solution, solved
from analytic.words import NEWTON, NEWTON_MILLIMETRE, angle_of, percent_of, speed_of

OWN = ("weight", "centrifugal", "gyroscopic", "finite_geometry")  # effects by what acts on a ball alone, or changes it


def failures_of(scene: Scene, model: Model, points: Array, found: Solution) -> dict[int, FembearingError]:
    """The errors of the operating points that have no torque, by their numbers from 0.

    points : (n, 5) as the kernel takes them;  found : at these
    What is wrong without the balls' own forces has the better words.
    """
    bad = np.flatnonzero(found.points["status"])
    if not bad.size:
        return {}
    numbers, balls = copied(model.numbers), copied(model.balls)
    for name in OWN:
        numbers["counted"][name] = False
    balls["weight"] = 0.0
    still = replace(model, numbers=record_in(numbers), balls=balls)
    return {each: _failure_at(scene, (still, model), points, each) for each in bad.tolist()}


def _failure_at(scene: Scene, models: tuple[Model, Model], points: Array, number: int) -> FembearingError:
    at = np.array([number])
    for model in models:
        work, one = workspace(model), model.at(at)
        end = solved(one, points[at], work=work)
        if end.points["status"][0]:
            return _failure(scene, one, points[at], end, work)
    raise AssertionError("a point without a torque has one the second time")


def require_settled(scene: Scene, model: Model, points: Array, found: Solution) -> None:
    """Raise the error of the first operating point that has no torque; arguments as of `failures_of`."""
    if failures := failures_of(scene, model, points, found):
        raise next(iter(failures.values()))


def _failure(scene: Scene, model: Model, point: Array, found: Solution, work: Workspace) -> FembearingError:
    """The error of one operating point, (1, 5)."""
    bearing, end = scene.bearing, found.points[0]
    status, load, speed = int(end["status"]), point[0, 0], float(point[0, 3])
    if status == NO_THRUST:
        return InputError(f"operation.axial_load = {load:g} N: without thrust nothing presses the balls; give a load")
    if status == NO_DISTRIBUTION:
        return undistributed(np.inf, None)
    if status in (THROWN, THROWN_WASHERS):
        return _thrown(status, float(end["left"]), float(load), speed)
    if status == OPEN_ANGLE:
        return unsettled(point[:, 0] / bearing.ball_count, float(end["left"]), float(end["tolerance"]))
    if status == NO_STEADY_ROTATION:
        ball = int(end["worst_ball"])
        inner, outer = work.contacts[ball]["load"]
        return ConvergenceError(
            iterations=MOST_STEPS,
            residual=float(end["left"]),
            tolerance=ENOUGH,
            unit="of its friction",
            problem=f"the rotation of ball {ball} under {inner:.4g} N on the inner and {outer:.4g} N on the outer race",
            remedy='Raise the load or lower the speed, or give friction.spin_rule = "outer_control".',
        )
    if status == BEYOND_SHOULDER:
        weight = float(np.hypot(*work.balls["weight"].T).max())
        return _beyond_shoulder(bearing, dict(zip(OF_POINT, map(float, point[0]), strict=True)), found.balls[0], weight)
    if status in STATUS_OF_ROUND:
        rounds = {"end": STATUS_OF_ROUND.index(status), **{n: end[n] for n in ("steps", "left", "tolerance")}}
        return unsettled_ring(bearing, model.numbers.ring.grooves, speed, work.ring, work.balls, rounds)
    words = {
        NO_SHARED_LOAD: no_shared_load,
        NO_SPIN_BALANCE: no_spin_balance,
        NO_CREEP_SPEED: no_creep_speed,
    }
    return words[status]()


def undistributed(unequal: float, lacks: str | None) -> InputError:
    """The error of unequal loads that the balls cannot share.

    unequal : how much they do over what thrust does, at most;  lacks : the input that is missing
    """
    much = f"are up to {percent_of(unequal)} of the thrust" if np.isfinite(unequal) else "act without thrust"
    return InputError(
        f"operation.radial_load and operation.moment {much}, and "
        + (lacks or "are the whole load: set effects.load_distribution to auto")
    )


def _thrown(status: int, ratio: float, load: float, speed: float) -> InputError:
    """The error of balls that centrifugal force takes from their inner race."""
    washers = status == THROWN_WASHERS
    most = 1 / PRESSED if washers else MOST_CENTRIFUGAL
    effect = (
        "moves it out of the middle of its grooves, which is not modelled in a thrust bearing"
        if washers
        else "it skids"
    )
    return InputError(
        f"operation.inner_speed = {speed_of(speed)}: the centrifugal force of a ball is {ratio:.3g} times its load "
        f"under {load:g} N of thrust, above {most:g}, and {effect}: raise the load or lower the speed"
    )


def _beyond_shoulder(bearing: Bearing, point: dict[str, float], balls: Records, weight: float) -> InputError:
    """The error of a contact that has left its race.

    point : the fields of `Operation` at the operating point;  balls : (m,) `records.BALL` there
    weight : of a ball across its orbit, N; 0 where it does not count
    """
    distance = balls["shoulder_distance"]
    race = int(np.argmax((distance <= 0.0).any(axis=0)))
    ball = int(np.argmin(distance[:, race]))
    angles, name = np.abs(balls["angle"][ball]), RACES[race]
    # The ball's inertia separates its two angles: without it both would be near their mean.
    separated = np.min(shoulder_distances(bearing, name, contact_angle=angles.mean())) > 0
    orbit = balls["motion"]["cage_speed"][ball] * point["inner_speed"]
    outward = outward_force(bearing.ball_mass, bearing.pitch_diameter, orbit)
    load, share = balls["load"][ball].max(), point["axial_load"] / bearing.ball_count
    if separated and (point["radial_load"] or point["moment"]) and max(load, weight, outward) < share:
        return InputError(
            f"{_loads(point)}: unequal loads leave {load:.3g} N for a ball, whose contact moves to "
            f"{angle_of(angles[race])}, beyond the {name} race's shoulder: raise operation.axial_load"
        )
    if separated and weight > outward:
        return InputError(
            f"{_loads(point)}: the weight of a ball, {weight:.3g} N, moves its contact to {angle_of(angles[race])}, "
            f'beyond the {name} race\'s shoulder: raise the load, or give effects.weight = "off"'
        )
    speed = f"the speed of {speed_of(point['inner_speed'])}, whose centrifugal force moves it there"
    return InputError(
        f"{_loads(point)}: the contact moves to {angle_of(angles[race])}, beyond the {name} race's shoulder: lower "
        f"{speed if separated else 'the load'}, reduce the clearance or raise shoulder_half_width"
    )


def _loads(point: dict[str, float]) -> str:
    """The loads at an operating point as the scene gives them."""
    found = f"operation.axial_load = {point['axial_load']:g} N"
    for name, unit in (("radial_load", NEWTON), ("moment", NEWTON_MILLIMETRE)):
        if point[name]:
            found += f", operation.{name} = {unit.written(point[name], 'g')}"
    return found
