"""The torque by sliding of free balls: loads, rotation and friction settle together.

Traction turns the balls and pushes them across their grooves, loads and angles follow, and where there is oil its film
follows these. Each pass has the tractions of the last one, and more nodes. The change of the torque between two passes
is what is left of both errors.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import loaded_contact
from analytic.free_ball.rotation import Creep, FreeBalls, FreeTurning, Nodes, Surfaces
from analytic.loads.balls import LoadedBalls, LoadEffects, balls_between, loaded_balls
from analytic.loads.kinematics import BallKinematics
from analytic.loads.race_contacts import unit_contacts
from analytic.numerics.interpolated import sampled_series
from analytic.scene import Array, Bearing, ContactAngle, Operation, SlidingMethod
from analytic.sliding.ball import Tractions
from analytic.sliding.methods import Sliding

QUADRATURES = (Nodes(16, 12), Nodes(32, 20), Nodes(64, 36), Nodes(128, 72), Nodes(192, 108))
# Times the change from one quadrature to the next: what is left of it, where the error falls at least as fast as the
# nodes lie closer. Films follow loads with small powers, and settle faster.
SAFETY = 2.0
# Errors change sign with the load, and two quadratures may agree by chance. These are errors of each, relative, that
# 99 % of 2300 points do not exceed, of drawn bearings, loads of 10 to 2000 N and friction of 0.01 to 0.16. The first
# quadrature is only a start.
LEAST = (np.inf, 0.01, 0.003, 0.0007, 0.0003)
METHODS: dict[Creep, SlidingMethod] = {"none": "free_ball", "closed": "closed_creep", "marched": "marched_creep"}
SERIES = 130  # from this number of points on, a sample of them costs less
BETWEEN = 1.25  # times the largest error at the points of a sample: what lies between them
# Of the allowed error, at the points of a sample. The rest is for what lies between them: errors of a quadrature change
# sign with the load, and four times their noise counts there.
METHODS_PART = 0.2
POSITIVE = ("inner_entrainment", "outer_entrainment", "inner_rolling_rate", "outer_rolling_rate", "ball_speed")
Points = NDArray[np.intp]


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeProblem:
    """n operating points with free balls."""

    bearing: Bearing
    contact_angle: ContactAngle
    operation: Operation  # every array (n,)
    effects: LoadEffects
    creep: Creep
    correction: ContactCorrection | None
    # Of balls at some of the points: the tractions, and what else resists them, (k,) N m
    resistance: Callable[[LoadedBalls, Points], tuple[Tractions, Array]]

    def at(self, points: Points) -> "FreeProblem":
        operation = Operation(**{name: values[points] for name, values in vars(self.operation).items()})
        correction = None if self.correction is None else self.correction.mapped(lambda factor: factor[points])
        return replace(
            self,
            operation=operation,
            correction=correction,
            resistance=lambda balls, some: self.resistance(balls, points[some]),
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeSliding:
    """The balls, and the torque by their sliding."""

    balls: LoadedBalls
    sliding: Sliding


def slide_freely(problem: FreeProblem, ruled: LoadedBalls, *, allowed: Array) -> FreeSliding:
    """The balls and their torque, from balls by closed kinematics.

    allowed : (n,) error, relative to the whole torque
    Raises ConvergenceError where a ball finds no steady rotation, or loads and rotation do not settle.
    """
    if ruled.alike > 1 and np.count_nonzero(problem.operation.inner_speed) >= SERIES:
        sampled = _sampled(problem, ruled, allowed=allowed)
        if sampled is not None:
            return sampled
    return _settled(problem, ruled, allowed=allowed)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Pass:
    """Balls that turned with the tractions of the balls before them."""

    balls: LoadedBalls
    turning: FreeTurning
    free: FreeBalls
    torque: Array  # (n,) by sliding, N m
    whole: Array  # (n,) with what else resisted the balls before, N m


def _settled(problem: FreeProblem, ruled: LoadedBalls, *, allowed: Array) -> FreeSliding:
    """Every point by itself, by passes with more and more nodes, until the torque changes no more than it may."""
    last = _passed(problem, ruled, QUADRATURES[0], None)
    error = np.full_like(last.torque, np.inf)
    for nodes, least in zip(QUADRATURES[1:], LEAST[1:], strict=True):
        before, last = last, _passed(problem, last.balls, nodes, last.turning)
        error = np.maximum(SAFETY * np.abs(last.whole - before.whole), least * last.torque)
        if np.all(error <= allowed * last.whole):
            break
    spin = last.balls.total(_each(last.free.spin_torque))
    return FreeSliding(
        balls=last.balls,
        sliding=Sliding(
            spin=spin,
            conformity=last.torque - spin,
            coefficient=_each(last.free.coefficient),
            method=METHODS[problem.creep],
            error=np.divide(error, last.torque, out=np.zeros_like(error), where=last.torque > 0),
        ),
    )


def _passed(problem: FreeProblem, balls: LoadedBalls, nodes: Nodes, near: FreeTurning | None) -> _Pass:
    """One pass from the tractions of these balls; near : the last pass's, from where the balls turn on."""
    tractions, other = problem.resistance(balls, np.arange(problem.operation.inner_speed.size))
    turning = FreeTurning(
        problem.bearing,
        tractions,
        inner_speed=problem.operation.inner_speed,
        balls=None if balls.method == "thrust" else problem.bearing.ball_count,
        surfaces=Surfaces(problem.creep, nodes),
        inertia=(problem.effects.centrifugal, problem.effects.gyroscopic),
    )
    if near is not None:
        turning.velocity = near.velocity.copy()
    balls = loaded_balls(
        problem.bearing,
        problem.contact_angle,
        problem.operation,
        problem.effects,
        correction=problem.correction,
        turning=turning,
        near=balls,
    )
    free = turning.balls()
    torque = balls.total(_each(free.torque))
    return _Pass(balls=balls, turning=turning, free=free, torque=torque, whole=torque + other)


def _each(of_contact: Array) -> Array:
    """(2, n, m) of balls that may be all alike."""
    return of_contact[..., None] if of_contact.ndim == 2 else of_contact


def _sampled(problem: FreeProblem, ruled: LoadedBalls, *, allowed: Array) -> FreeSliding | None:
    """All balls alike, from a sample of the points; None where that does not pay or is not accurate enough.

    Loads, speeds and torques vary with load and speed in a smooth way, as logarithms. Errors are relative to the whole
    torque: that by sliding may be a small part of it.
    """
    count = problem.operation.inner_speed.size
    moving, standing = np.flatnonzero(problem.operation.inner_speed), np.flatnonzero(problem.operation.inner_speed == 0)
    _, others = problem.resistance(ruled, np.arange(count))
    worst = 0.0

    def settled(at: Points) -> Array:
        nonlocal worst
        part = _settled(problem.at(at), ruled.at(at), allowed=METHODS_PART * allowed[at] / BETWEEN)
        torque = part.sliding.spin + part.sliding.conformity
        worst = max(worst, BETWEEN * float(np.max(part.sliding.error * _share(torque, others[at]))))
        return _quantities(part)

    def missed(interpolated: Array, true: Array, some: Points) -> Array:
        wrong = np.abs(np.expm1((interpolated - true)[:, :3]))  # loads and torque
        wrong[:, 2] *= _share(np.exp(true[:, 2]), others[moving[some]])
        return wrong.max(axis=1)

    still = settled(standing) if standing.size else None
    series = sampled_series(
        lambda some: settled(moving[some]),
        np.log(np.stack([ruled.load[0, moving, 0], np.abs(problem.operation.inner_speed[moving])], axis=1)),
        missed=missed,
        allowed=lambda: float(np.min(allowed)) - worst,
    )
    if series is None:
        return None
    values = np.zeros((count, series.values.shape[1]))
    values[moving] = series.values
    if still is not None:
        values[standing] = still
    share = _share(np.exp(values[:, 2]), others)
    error = np.divide(worst + series.error, share, out=np.zeros_like(share), where=share > 0)
    return _from_quantities(problem, values, error=error, computed=series.at.size + standing.size)


def _share(torque: Array, others: Array) -> Array:
    """(n,) of the torque by sliding in the whole torque."""
    whole = torque + others
    return np.divide(torque, whole, out=np.zeros_like(whole), where=whole > 0)


def _quantities(free: FreeSliding) -> Array:
    """(n, q): logarithms of loads, torque, friction coefficients and speeds; angles, pitch, share of spin, spin."""
    balls, sliding, motion = free.balls, free.sliding, free.balls.motion
    torque = sliding.spin + sliding.conformity
    positive = [balls.load[0, :, 0], balls.load[1, :, 0], torque, *sliding.coefficient[..., 0]]
    positive += [getattr(motion, name)[:, 0] for name in POSITIVE]
    share = np.divide(sliding.spin, torque, out=np.zeros_like(torque), where=torque > 0)
    rest = [*balls.contact_angle[..., 0], motion.cage_speed[:, 0], motion.spin_difference[:, 0], motion.pitch[:, 0]]
    return np.stack([*np.log(np.maximum(positive, 1e-300)), *rest, share], axis=1)


def _from_quantities(problem: FreeProblem, values: Array, *, error: Array, computed: int) -> FreeSliding:
    bearing, radius, half = problem.bearing, problem.bearing.ball_radius, problem.bearing.pitch_diameter / 2
    count = 5 + len(POSITIVE)
    inner_load, outer_load, torque, inner_friction, outer_friction, *speeds = np.exp(values[:, :count]).T
    inner_angle, outer_angle, cage_speed, spin_difference, pitch, share = values[:, count:].T
    inner, outer = unit_contacts(
        bearing,
        inner_angle=np.abs(inner_angle),
        outer_angle=np.abs(outer_angle),
        correction=problem.correction or ContactCorrection(),
    )
    balls = balls_between(
        bearing,
        method="thrust",
        load=np.stack([inner_load, outer_load])[..., None],
        angle=np.stack([inner_angle, outer_angle])[..., None],
        contacts=(loaded_contact(inner, load=inner_load), loaded_contact(outer, load=outer_load)),
        motion=BallKinematics(
            inner_radius=half - radius * np.cos(inner_angle),
            outer_radius=half + radius * np.cos(outer_angle),
            cage_speed=cage_speed,
            spin_difference=spin_difference,
            pitch=pitch,
            **dict(zip(POSITIVE, speeds, strict=True)),
        ),
    )
    return FreeSliding(
        balls=balls,
        sliding=Sliding(
            spin=torque * share,
            conformity=torque * (1 - share),
            coefficient=np.stack([inner_friction, outer_friction])[..., None],
            method=METHODS[problem.creep],
            error=error,
            computed=computed,
        ),
    )
