"""The torque that the balls lose by sliding on their races, by the cheapest method that is accurate enough.

The methods are those of `analytic.sliding.ball`. The error of `single_coefficient` follows from the dependence of the
stress on pressure and speed, tau ~ p^q |v|^s near the mean of each contact. On a long ellipse the error is 0 where
q = 1 and s = 0, as with Coulomb friction. The error of the long ellipse itself is E(m) - 1 of the power beyond full
spin, with m = 1 - (a/b)^2. It is largest just before full spin: 1.11 times as much at a spin-to-roll ratio of 0.43.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipe

from analytic.contact.rolling_contact import RollingContact
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls
from analytic.numerics.interpolated import sampled_series
from analytic.oil.traction import CoulombTraction, Traction
from analytic.scene import Array, Lubricant, Microslip, SpinRule
from analytic.sliding.as_printed import as_printed_torque
from analytic.sliding.ball import SlidingMethod, SlipFriction, Tractions, slip_friction, with_numbers
from analytic.sliding.ellipse import NODES
from analytic.sliding.long_ellipse import microslip_moments

# Errors of `single_coefficient` relative to the true power, measured against the most accurate method on 1500 scenes
# with oil and asperities (validation/benchmarks/friction.py --errors).
EVEN_STRESS = 0.182  # of a stress that does not follow the pressure
KINK = 0.17  # of a stress that stops following the pressure within the contact, at the limiting stress
STEEP = 0.05  # for each power of the pressure above 1
VISCOUS = 0.62  # of a stress proportional to the speed
# Bound on the error of sinh traction at the mean stress, relative to the true power. The largest observed errors are
# 0.87, at a few N in thin oil that pressure thickens steeply, and 0.69 on the scenes of the benchmark.
MOST_UNEVEN = 0.9
BELOW_FULL_SPIN = (
    1.15  # times E(m) - 1; the largest observed factor is 1.11, for any shape, with both contacts together
)
SERIES = 1000  # from this number of points on, a sample of them costs less
LEAST_POWER = 0.05  # least share of the true power that a method is assumed to give; its error is large anyway
SPREAD = 0.02  # relative step of the differences that give the exponents
SPIN_STIFFNESS = 0.9163  # d(M_spin/mu Q b)/d eps at eps = 0, its largest value; see analytic.sliding.long_ellipse


@dataclass(frozen=True, kw_only=True)
class Quadrature:
    """A method with the nodes of its quadrature, and the error by these nodes, measured against 48 by 48 nodes.

    On random scenes with oil and asperities (validation/benchmarks/friction.py --nodes) the errors with a kink were at
    most 3.6e-3 with 12 by 8 nodes and 3.9e-4 with 24 by 24. They vary with the position of the kink.
    """

    method: SlidingMethod
    nodes: tuple[int, int] = NODES
    kinked: float = 0.0  # relative error where the stress stops following the speed, at the limiting stress
    smooth: float = 0.0  # relative error where the stress does not depend on the speed


QUADRATURES = (  # from cheap to accurate
    Quadrature(method="single_coefficient"),
    Quadrature(method="along_axis", nodes=(12, 8), kinked=5e-3, smooth=1e-5),
    Quadrature(method="over_ellipse", nodes=(12, 8), kinked=5e-3, smooth=1e-5),
    Quadrature(method="over_ellipse", nodes=(24, 24), kinked=6e-4, smooth=1e-8),
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
    error: Array  # (n,) bound on the error of the method, relative to spin + conformity
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
    sliders = _Sliders(balls=balls, traction=traction, model=model, ring_speed=ring_speed)
    cheap = sliders.slide(QUADRATURES[0])
    if model.microslip == "as_printed":
        return _as_printed(sliders, cheap)
    if model.microslip != "derived":
        raise InputError(f'microslip must be "derived" or "as_printed", got {model.microslip!r}')

    def allowed_of(spin: Array, conformity: Array) -> Array:
        """(n,) the allowed error relative to the torque by sliding."""
        counted = spin * model.spins + conformity * model.conforms
        return np.divide(
            allowed * (counted + other_torque), counted, out=np.full_like(counted, np.inf), where=counted > 0
        )

    expected = allowed_of(balls.total(cheap.torque.spin), balls.total(cheap.torque.conformity))
    *cheaper, last = [each for each in QUADRATURES if model.method in ("auto", each.method)]
    for quadrature in cheaper:
        # Every method spreads the power over contacts and effects in nearly the same way.
        if np.any(sliders.error(quadrature, cheap) > expected):
            continue
        result = sliders.result(quadrature, cheap, expected)
        if np.all(result.error <= allowed_of(result.spin, result.conformity)):
            return result
    return sliders.result(last, cheap, expected)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Sliders:
    """All contacts of all balls at n operating points."""

    balls: LoadedBalls
    traction: Tractions
    model: SlidingModel
    ring_speed: Array

    def slide(self, quadrature: Quadrature, points: NDArray[np.intp] | slice = slice(None)) -> SlipFriction:
        shape = self.balls.load.shape[1:]
        difference = np.abs(self.balls.motion.spin_difference) if self.model.spins else np.zeros(shape)
        contacts, traction = with_numbers(
            (self.balls.race(0), self.balls.race(1)),
            self.traction,
            lambda value: np.broadcast_to(value, shape)[points],
        )
        return slip_friction(
            contacts,
            traction,
            ring_speed=self.ring_speed[points, None],
            spin_difference=difference[points],
            spin_rule=self.model.spin_rule,
            method=quadrature.method,
            nodes=quadrature.nodes,
        )

    def error(self, quadrature: Quadrature, result: SlipFriction) -> Array:
        """(n,) bound on the error relative to the result, which shows how the power is spread over the contacts."""
        smooth = not any(law.depends_on_speed for law in self.traction)
        error = np.full_like(self.balls.load, quadrature.smooth if smooth else quadrature.kinked)
        if quadrature.method != "over_ellipse":
            error = error + _long_ellipse_error(self.balls)
        if quadrature.method == "single_coefficient":
            error = error + _single_coefficient_error(self.balls, self.traction, result)
        return _relative(error, _weight(self.balls, result))

    def result(self, quadrature: Quadrature, cheap: SlipFriction, allowed: Array) -> Sliding:
        """The torque by a quadrature, at all points or at a sample of them."""
        if quadrature is QUADRATURES[0]:
            return self._all_points(quadrature, cheap)
        moving = self.ring_speed != 0
        if self.balls.load.shape[2] == 1 and np.count_nonzero(moving) >= SERIES:
            sampled = self._sampled(quadrature, cheap, np.flatnonzero(moving), allowed)
            if sampled is not None:
                return sampled
        return self._all_points(quadrature, self.slide(quadrature))

    def _all_points(self, quadrature: Quadrature, result: SlipFriction) -> Sliding:
        return Sliding(
            spin=self.balls.total(result.torque.spin),
            conformity=self.balls.total(result.torque.conformity),
            coefficient=np.stack([result.inner_coefficient, result.outer_coefficient]),
            method=quadrature.method,
            error=self.error(quadrature, result),
        )

    def _sampled(
        self, quadrature: Quadrature, cheap: SlipFriction, moving: NDArray[np.intp], allowed: Array
    ) -> Sliding | None:
        """From a sample of the points; None if that does not pay or is not accurate enough.

        Under thrust all balls are alike, and the difference between two methods depends on load and speed alone.
        """
        base = _quantities(cheap)
        whole = base[:, :2].sum(axis=1)
        if not (np.all(whole > 0) and np.all(base[:, 2:] > 0)):
            return None
        scale = np.stack([whole, whole, base[:, 2], base[:, 3]], axis=1)

        def evaluate(points: NDArray[np.intp]) -> Array:
            at = moving[points]
            return (_quantities(self.slide(quadrature, at)) - base[at]) / scale[at]

        def relative_error(interpolated: Array, true: Array, points: NDArray[np.intp]) -> Array:
            before = (base[:, :2] / scale[:, :2])[moving[points]]
            return np.abs(np.sum((interpolated - true)[:, :2], axis=1) / np.sum(before + true[:, :2], axis=1))

        error = self.error(quadrature, cheap)
        series = sampled_series(
            evaluate,
            np.log(np.stack([self.balls.load[0, moving, 0], np.abs(self.ring_speed[moving])], axis=1)),
            missed=relative_error,
            allowed=float(np.min(allowed - error)),
        )
        if series is None:
            return None
        values = base.copy()
        values[moving] += scale[moving] * series.values
        standing = np.flatnonzero(self.ring_speed == 0)
        if standing.size:
            values[standing] = _quantities(self.slide(quadrature, standing))
        return Sliding(
            spin=self.balls.alike * values[:, 0],
            conformity=self.balls.alike * values[:, 1],
            coefficient=values[:, 2:].T[..., None],
            method=quadrature.method,
            error=error + series.error,
            computed=series.at.size + standing.size,
        )


def _quantities(result: SlipFriction) -> Array:
    """(n, 4) for balls that are alike: torques by spin and conformity, inner and outer coefficient."""
    torque = result.torque
    columns = (torque.spin, torque.conformity, result.inner_coefficient, result.outer_coefficient)
    return np.concatenate(columns, axis=1)


def _as_printed(sliders: _Sliders, derived: SlipFriction) -> Sliding:
    """By the printed moments, at the spin and the coefficients of the derived ones; their error has no known bound."""
    balls = sliders.balls
    coefficients = derived.inner_coefficient, derived.outer_coefficient
    inner, outer = balls.race(0), balls.race(1)
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


def rolling_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) torque by conformity without spin per N of friction force, m: 0.0806 b^2/R w_roll/w."""
    contacts = balls.contacts
    _, moment = microslip_moments(
        friction_force=1.0,
        semi_axis_transverse=contacts.semi_axis_transverse,
        deformed_radius=contacts.deformed_radius,
        spin_to_roll=0.0,
    )
    return moment * contacts.rolling_rate


def full_spin_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) 3/8 b w_s/w, m: torque per N of friction force on a race that takes all spin and does not roll."""
    return 3 / 8 * balls.contacts.semi_axis_transverse * np.abs(balls.motion.spin_difference)


def largest_spin_lever(balls: LoadedBalls) -> Array:
    """(2, n, m) bound on the torque that all spin adds on one race per N of Coulomb friction, m.

    The spin moment grows from 0 to at most 3/8 mu Q b, and its slope is largest at 0. The slip power is the integral of
    the moment over the spin: at most 0.458 eps b w_s/w, and at most 3/8 b w_s/w.
    """
    spin = np.abs(balls.motion.spin_difference)
    ratio = spin * balls.contacts.deformed_radius / balls.contacts.rolling_rate  # eps b, m
    return np.minimum(SPIN_STIFFNESS / 2 * ratio * spin, full_spin_lever(balls))


def largest_error(balls: LoadedBalls, lubricant: Lubricant | None) -> Array:
    """(2, n, m) bound on the torque by sliding over that of mean stresses on a long ellipse, less 1."""
    uneven = {"eyring_sinh": MOST_UNEVEN, "eyring_constant": EVEN_STRESS}[lubricant.traction] if lubricant else 0.0
    return (1 + _long_ellipse_error(balls)) / (1 - uneven) - 1


def _weight(balls: LoadedBalls, result: SlipFriction) -> Array:
    """(2, n, m) share of each contact in the slip power of its operating point."""
    torque, rate = result.torque, np.asarray(balls.contacts.rolling_rate)
    power = np.stack(
        [
            torque.inner_spin_moment * torque.inner_spin_rate + torque.inner_rolling_moment * rate[0],
            torque.outer_spin_moment * torque.outer_spin_rate + torque.outer_rolling_moment * rate[1],
        ]
    )
    whole = np.sum(power, axis=(0, 2), keepdims=True)
    return np.divide(power, whole, out=np.zeros_like(power), where=whole > 0)


def _relative(error: Array, weight: Array) -> Array:
    """(n,) error of all contacts relative to the computed power, from errors relative to the true power."""
    return np.sum(weight * error / np.maximum(1 - error, LEAST_POWER), axis=(0, 2))


def _single_coefficient_error(balls: LoadedBalls, traction: Tractions, result: SlipFriction) -> Array:
    """(2, n, m) error of a single coefficient on each contact, relative to the true power."""
    slips = (result.inner_slip_speed, result.outer_slip_speed)
    return np.stack([_mean_stress_error(balls.race(race), traction[race], slip) for race, slip in enumerate(slips)])


def _mean_stress_error(contact: RollingContact, traction: Traction, slip: Array) -> Array:
    """Error of the stress at mean pressure and mean slip, relative to the true power."""
    if isinstance(traction, CoulombTraction):
        return np.zeros_like(slip)
    pressure = contact.mean_pressure
    up, down = 1 + SPREAD, 1 / (1 + SPREAD)

    def exponent(high: Array, low: Array) -> Array:
        """Of the stress, from its values a step above and a step below the mean."""
        both = (high > 0) & (low > 0)
        return np.log(np.divide(high, low, out=np.ones_like(high), where=both)) / (2 * np.log(up))

    stress = traction.stress
    by_pressure = exponent(stress(up * pressure, slip), stress(down * pressure, slip))
    error = EVEN_STRESS * np.maximum(1 - by_pressure, 0.0)
    if traction.depends_on_speed:
        by_speed = exponent(stress(pressure, up * slip), stress(pressure, down * slip))
        error = np.maximum(error, KINK) + VISCOUS * by_speed
    return error + STEEP * np.maximum(by_pressure - 1, 0.0)


def _long_ellipse_error(balls: LoadedBalls) -> Array:
    """(2, n, m) error of a long ellipse relative to the true power; at most that of a circle, also where a > b."""
    a, b = balls.contact.semi_axis_x, balls.contact.semi_axis_y
    ratio = np.divide(a, b, out=np.zeros_like(b), where=b > 0)
    return BELOW_FULL_SPIN * (ellipe(1 - np.minimum(ratio, 1.0) ** 2) - 1)
