"""The torque that the balls lose by sliding on their races, by the cheapest method that is accurate enough.

The methods are those of `analytic.sliding.ball`, and `analytic.sliding.judge` estimates the error of each. At the spin
and the creep of `single_coefficient` it foretells the error of a method before it is computed.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.contact.rolling_contact import Pair
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls
from analytic.numerics.elements import elements_of
from analytic.numerics.interpolated import far_points, sampled_series
from analytic.oil.traction import CoulombTraction
from analytic.scene import Array, Microslip, SpinRule
from analytic.sliding.as_printed import as_printed_torque
from analytic.sliding.ball import (
    SlidingMethod,
    SlipFriction,
    SlipRule,
    Tractions,
    slip_friction,
)
from analytic.sliding.judge import LEAST, judged_balls
from analytic.sliding.long_ellipse import MicroslipTorque

Points = NDArray[np.intp] | slice

SERIES = 1000  # from this number of points on, a sample of them costs less
FORETOLD = 64  # points of a series that foretell the errors of the methods
JUDGED = 256  # points of a long series that give the error of all
BETWEEN = 1.25  # times the largest error at the points of a sample: what lies between them
SEED = 31


QUADRATURES = (  # from cheap to accurate, in the order of `judge`
    SlipRule("single_coefficient"),
    SlipRule("along_axis", (12, 8)),
    SlipRule("over_ellipse", (12, 8)),
    SlipRule("over_ellipse", (24, 24)),
)


@dataclass(frozen=True, kw_only=True)
class SlidingModel:
    """What counts as sliding, and how it is computed."""

    spins: bool  # the balls spin on their races
    conforms: bool  # conformity counts
    spin_rule: SpinRule
    microslip: Microslip
    method: SlidingMethod | Literal["auto"]  # auto: the cheapest one that is accurate enough


@dataclass(frozen=True, kw_only=True, eq=False)
class Sliding:
    """The torque by sliding and its method; n operating points, m balls."""

    spin: Array  # (n,) N m
    conformity: Array  # (n,) N m
    coefficient: Array  # (2, n, m)
    method: SlidingMethod
    error: Array  # (n,) estimate of the error of the method, relative to spin + conformity
    computed: int | None = None  # number of computed points, the others are interpolated; None: all


def race_sliding(
    balls: LoadedBalls,
    traction: Tractions,
    model: SlidingModel,
    *,
    ring_speed: Array,
    other_torque: Array,
    allowed: Array,
) -> Sliding:
    """The torque by sliding of all balls at each operating point.

    traction : on inner and outer race, with numbers (n, m);  ring_speed : w, (n,), rad/s
    other_torque : (n,) of the other effects, N m
    allowed : (n,) error that the method may have, relative to the whole torque
    """
    sliders = Sliders(balls=balls, traction=traction, model=model, ring_speed=ring_speed)
    if model.microslip == "as_printed":
        return _as_printed(sliders, sliders.cheap)
    if model.microslip != "derived":
        raise InputError(f'microslip must be "derived" or "as_printed", got {model.microslip!r}')

    def allowed_of(spin: Array, conformity: Array) -> Array:
        """(n,) the allowed error relative to the torque by sliding."""
        counted = spin * model.spins + conformity * model.conforms
        return np.divide(
            allowed * (counted + other_torque), counted, out=np.full_like(counted, np.inf), where=counted > 0
        )

    expected = allowed_of(balls.total(sliders.cheap.torque.spin), balls.total(sliders.cheap.torque.conformity))
    *cheaper, last = [each for each in QUADRATURES if model.method in ("auto", each.method)]
    some, foretold, between = slice(None), sliders.foretold, BETWEEN if sliders.is_sampled else 1.0
    if sliders.is_sampled or expected.size > FORETOLD:
        some = sliders.far if sliders.is_sampled else _some(expected.size, FORETOLD)
        foretold = sliders.errors_at(_rows(sliders.cheap, some), some)
    for quadrature in cheaper:
        # Every method spreads the power over contacts and effects in nearly the same way.
        if np.any(between * foretold(quadrature) > expected[some]):
            continue
        result = sliders.result(quadrature, expected)
        if result is not None and np.all(result.error <= allowed_of(result.spin, result.conformity)):
            return result
    return sliders.result(last, expected) or sliders.at_all_points(last, sliders.slide(last), expected)


@dataclass(frozen=True, kw_only=True, eq=False)
class Sliders:
    """All contacts of all balls at n operating points."""

    balls: LoadedBalls
    traction: Tractions
    model: SlidingModel
    ring_speed: Array

    @cached_property
    def cheap(self) -> SlipFriction:
        """All points by the cheapest method."""
        return self.slide(QUADRATURES[0])

    @cached_property
    def foretold(self) -> Callable[[SlipRule], Array]:
        """`errors_at` all points, at the sliding by the cheapest method."""
        return self.errors_at(self.cheap)

    def slide(self, quadrature: SlipRule, points: Points = slice(None)) -> SlipFriction:
        shape = self.balls.load.shape[1:]
        difference = np.abs(self.balls.motion.spin_difference) if self.model.spins else np.zeros(shape)
        contacts, traction = self._at(points)
        return slip_friction(
            contacts,
            traction,
            ring_speed=self.ring_speed[points, None],
            spin_difference=difference[points],
            spin_rule=self.model.spin_rule,
            rule=quadrature,
        )

    def errors_at(self, result: SlipFriction, points: Points = slice(None)) -> Callable[[SlipRule], Array]:
        """(n,) estimate of the error of any method, relative to its power, at the sliding of a result at these points.

        The result may be that of a cheaper method. Methods that are judged by the same nodes share them.
        """

        def error(quadrature: SlipRule) -> Array:
            contacts, traction = self._at(points)
            missed, whole = judged_balls(
                contacts,
                (traction[0].point_law, traction[1].point_law),
                _slip_fields(result),
                ring_speed=self.ring_speed[points, None],
                method=QUADRATURES.index(quadrature),
            )
            least = 0.0 if self._has_closed_form(quadrature) else LEAST
            return _over(missed.sum(axis=-1), whole.sum(axis=-1)) + least

        return error

    def _error_at(self, points: NDArray[np.intp], result: SlipFriction, quadrature: SlipRule) -> Array:
        """(k,) estimate of the error of a method at some points; result : at all of them."""
        return self.errors_at(_rows(result, points), points)(quadrature)

    @property
    def is_sampled(self) -> bool:
        """Whether the series is so long that a sample stands for it, as its balls are alike."""
        return bool(self.balls.load.shape[2] == 1 and np.count_nonzero(self.ring_speed) >= SERIES)

    @cached_property
    def far(self) -> NDArray[np.intp]:
        """Some far points that move, where balls are alike."""
        moving = np.flatnonzero(self.ring_speed)
        return moving[far_points(self._coordinates(moving), FORETOLD)]

    def _coordinates(self, points: NDArray[np.intp]) -> Array:
        """(k, 2) what the torque of balls that are alike depends on."""
        return np.log(np.stack([self.balls.load[0, points, 0], np.abs(self.ring_speed[points])], axis=1))

    def _has_closed_form(self, quadrature: SlipRule) -> bool:
        by_coulomb = all(isinstance(law, CoulombTraction) for law in self.traction)
        return by_coulomb and quadrature.method == "single_coefficient"

    def _at(self, points: Points) -> tuple[Pair, Tractions]:
        (inner, outer), (inner_law, outer_law) = self.balls.races, self.traction
        if isinstance(points, slice):
            return self.balls.races, self.traction

        def chosen(value: Array) -> Array:
            return np.broadcast_to(value, self.balls.load.shape[1:])[points]

        pair = elements_of(inner, chosen), elements_of(outer, chosen)
        return pair, (elements_of(inner_law, chosen), elements_of(outer_law, chosen))

    def result(self, quadrature: SlipRule, allowed: Array) -> Sliding | None:
        """The torque by a quadrature, at all points or at a sample of them; None where the sample is too wrong."""
        if quadrature is QUADRATURES[0]:
            return self.at_all_points(quadrature, self.cheap, allowed)
        if self.is_sampled:
            sampled, worst = self._sampled(quadrature, np.flatnonzero(self.ring_speed), allowed)
            if sampled is not None or worst >= np.min(allowed):
                return sampled
        return self.at_all_points(quadrature, self.slide(quadrature), allowed)

    def at_all_points(self, quadrature: SlipRule, result: SlipFriction, allowed: Array) -> Sliding:
        """At all points; the error in a long series is the largest of a sample at each point where that is allowed."""
        if self.ring_speed.size < SERIES or self._has_closed_form(quadrature):
            error = (self.foretold if result is self.cheap else self.errors_at(result))(quadrature)
        else:
            some = _some(self.ring_speed.size, JUDGED)
            error = np.full_like(self.ring_speed, BETWEEN * np.max(self._error_at(some, result, quadrature)))
            doubtful = np.flatnonzero(error > allowed)
            if doubtful.size and self.balls.load.shape[2] > 1:
                error[doubtful] = self._error_at(doubtful, result, quadrature)
        return Sliding(
            spin=self.balls.total(result.torque.spin),
            conformity=self.balls.total(result.torque.conformity),
            coefficient=np.stack([result.inner_coefficient, result.outer_coefficient]),
            method=quadrature.method,
            error=error,
        )

    def _sampled(self, quadrature: SlipRule, moving: NDArray[np.intp], allowed: Array) -> tuple[Sliding | None, float]:
        """From a sample of the points, None if that does not pay or is not accurate enough; and the method's error.

        Under thrust all balls are alike, and the difference between two methods depends on load and speed alone.
        """
        base = _quantities(self.cheap)
        whole = base[:, :2].sum(axis=1)
        if not (np.all(whole > 0) and np.all(base[:, 2:] > 0)):
            return None, 0.0
        scale = np.stack([whole, whole, base[:, 2], base[:, 3]], axis=1)

        worst = 0.0

        def evaluate(points: NDArray[np.intp]) -> Array:
            nonlocal worst
            at = moving[points]
            found = self.slide(quadrature, at)
            worst = max(worst, BETWEEN * float(np.max(self.errors_at(found, at)(quadrature))))
            return (_quantities(found) - base[at]) / scale[at]

        def relative_error(interpolated: Array, true: Array, points: NDArray[np.intp]) -> Array:
            before = (base[:, :2] / scale[:, :2])[moving[points]]
            return np.abs(np.sum((interpolated - true)[:, :2], axis=1) / np.sum(before + true[:, :2], axis=1))

        series = sampled_series(
            evaluate,
            self._coordinates(moving),
            missed=relative_error,
            allowed=lambda: float(np.min(allowed)) - worst,
        )
        if series is None:
            return None, worst
        values = base.copy()
        values[moving] += scale[moving] * series.values
        standing = np.flatnonzero(self.ring_speed == 0)
        if standing.size:
            values[standing] = _quantities(self.slide(quadrature, standing))
        sliding = Sliding(
            spin=self.balls.alike * values[:, 0],
            conformity=self.balls.alike * values[:, 1],
            coefficient=values[:, 2:].T[..., None],
            method=quadrature.method,
            error=np.full(base.shape[0], worst + series.error),
            computed=series.at.size + standing.size,
        )
        return sliding, worst


def _quantities(result: SlipFriction) -> Array:
    """(n, 4) for balls that are alike: torques by spin and conformity, inner and outer coefficient."""
    torque = result.torque
    columns = (torque.spin, torque.conformity, result.inner_coefficient, result.outer_coefficient)
    return np.concatenate(columns, axis=1)


def _as_printed(sliders: Sliders, derived: SlipFriction) -> Sliding:
    """By the printed moments, at the spin and the coefficients of the derived ones; their error is unknown."""
    balls = sliders.balls
    coefficients = derived.inner_coefficient, derived.outer_coefficient
    inner, outer = balls.races
    torque = as_printed_torque(
        (inner, outer),
        friction_force=(coefficients[0] * inner.load, coefficients[1] * outer.load),
        spin_rates=(derived.torque.inner_spin_rate, derived.torque.outer_spin_rate),
        ball_radius=balls.ball_radius,
    )
    return Sliding(
        spin=balls.total(torque.spin),
        conformity=balls.total(torque.conformity),
        coefficient=np.stack(coefficients),
        method="single_coefficient",
        error=np.full(balls.load.shape[1], np.inf),
    )


def _slip_fields(result: SlipFriction) -> Array:
    """(12, n, m) fields of `long_ellipse.Slip` on inner and outer race."""
    torque = result.torque
    return np.stack(
        np.broadcast_arrays(
            torque.inner_spin_rate,
            torque.inner_spin_moment,
            torque.inner_rolling_moment,
            result.inner_coefficient,
            result.inner_slip_speed,
            result.inner_creep,
            torque.outer_spin_rate,
            torque.outer_spin_moment,
            torque.outer_rolling_moment,
            result.outer_coefficient,
            result.outer_slip_speed,
            result.outer_creep,
        )
    )


def _over(part: Array, whole: Array) -> Array:
    """The quotient, and 0 where nothing is lost."""
    return np.divide(part, whole, out=np.zeros_like(part), where=whole > 0)


def _some(points: int, count: int) -> NDArray[np.intp]:
    """So many of the points, at random."""
    return np.random.default_rng(SEED).choice(points, count, replace=False)


def _rows(result: SlipFriction, points: NDArray[np.intp]) -> SlipFriction:
    """The result at some operating points."""
    torque = MicroslipTorque(**{name: value[points] for name, value in vars(result.torque).items()})
    rest = {name: value[points] for name, value in vars(result).items() if name != "torque"}
    return SlipFriction(torque=torque, **rest)
