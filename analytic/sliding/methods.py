"""What the balls lose by sliding on their races, by the cheapest rung of `analytic.sliding.ball` that is good enough.

The first rung's error follows from how the stress depends on pressure and speed, as tau ~ p^q |v|^s about the mean of
each contact: nothing is missed on a long ellipse where q = 1 and s = 0, as with Coulomb friction. What the long ellipse
itself misses is E(m) - 1 of the power beyond full spin, m = 1 - (a/b)^2, and most just before, 1.11 times as much at a
ratio of spin to roll of 0.43.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipe

from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls
from analytic.numerics.interpolated import sampled_series
from analytic.oil.traction import CoulombTraction, Traction
from analytic.scene import Array, Lubricant, Microslip, SpinRule
from analytic.sliding.as_printed import as_printed_torque
from analytic.sliding.ball import RaceContact, Rung, SlipFriction, slip_friction
from analytic.sliding.ellipse import NODES
from analytic.sliding.long_ellipse import SlidingContact, microslip_moments

# Measured against the last rung on 1500 scenes with oil and asperities (validation/benchmarks/friction.py --errors), of
# the true power: what is missed at a stress that does not follow the pressure, where it may stop doing so within the
# contact (the kink at the limiting stress), per power of the pressure above 1, where it is proportional to the speed.
EVEN_STRESS, KINK, STEEP, VISCOUS = 0.182, 0.17, 0.05, 0.62
# Of the true power, missed at mean stresses by sinh traction on any contact: 0.87 is the most found, at a few N in thin
# oil that pressure thickens steeply; 0.69 on the scenes of the benchmark.
MOST_UNEVEN = 0.9
BELOW_FULL_SPIN = 1.15  # of E(m) - 1: 1.11 is the most that was found there, at any shape and by contacts together
SERIES = 1000  # points, from which on a sample of them is worth its while
LEAST_FOUND = 0.05  # of the true power, that a rung is taken to find: below, its error is large enough
SPREAD = 0.02  # relative step of the differences that give the exponents
SPIN_STIFFNESS = 0.9163  # d(M_spin/mu Q b)/d eps at eps = 0, the largest; see analytic.sliding.long_ellipse


@dataclass(frozen=True, kw_only=True)
class Way:
    """A rung with the nodes of its quadrature, and what these miss of the power, measured against 48 by 48.

    On random scenes with oil and asperities (validation/benchmarks/friction.py --nodes): 3.6e-3 and 3.9e-4 at most at a
    kink, where errors come and go with its place.
    """

    rung: Rung
    nodes: tuple[int, int] = NODES
    kinked: float = 0.0  # where the stress stops following the speed at the limiting stress
    smooth: float = 0.0  # where it does not ask for the speed


WAYS = (  # from cheap to accurate
    Way(rung="single_coefficient"),
    Way(rung="along_axis", nodes=(12, 8), kinked=5e-3, smooth=1e-5),
    Way(rung="over_ellipse", nodes=(12, 8), kinked=5e-3, smooth=1e-5),
    Way(rung="over_ellipse", nodes=(24, 24), kinked=6e-4, smooth=1e-8),
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Sliding:
    """Torque and what goes with it; n operating points, m balls."""

    spin: Array  # (n,) N m
    conformity: Array  # (n,) N m
    coefficient: Array  # (2, n, m)
    rung: Rung
    error: Array  # (n,) bound on what the rung misses, of spin + conformity
    computed: int | None = None  # points at which it was; the others are interpolated. None: at all


def race_sliding(
    balls: LoadedBalls,
    traction: tuple[Traction, Traction],
    *,
    ring_speed: Array,
    spins: bool,
    conforms: bool,
    spin_rule: SpinRule,
    microslip: Microslip,
    asked: Rung | Literal["auto"],
    beside: Array,
    allowed: Array,
) -> Sliding:
    """Of all balls at each operating point.

    traction : of inner and outer race, its numbers (n, m);  ring_speed : w, (n,), rad/s
    spins : whether balls spin at all;  conforms : whether conformity counts
    asked : the rung, or auto for the cheapest that is good enough
    beside : (n,) torque of other effects, N m;  allowed : (n,) error of the whole that is left to the rung, relative
    """
    races = (
        RaceContact(
            traction=law,
            load=balls.load[race],
            semi_axis_rolling=balls.contact.semi_axis_x[race],
            semi_axis_transverse=balls.contact.semi_axis_y[race],
            deformed_radius=balls.deformed_radius[race],
            rolling_rate=balls.rolling_rate[race],
        )
        for race, law in enumerate(traction)
    )
    sliders = _Sliders(balls=balls, races=tuple(races), ring_speed=ring_speed, spins=spins, spin_rule=spin_rule)
    cheap = sliders.slide(WAYS[0])
    if microslip == "as_printed":
        return _as_printed(sliders, cheap)
    if microslip != "derived":
        raise InputError(f'microslip must be "derived" or "as_printed", got {microslip!r}')

    def left(spin: Array, conformity: Array) -> Array:
        """(n,) of the torque by sliding, the error that is left to it."""
        counted = spin * spins + conformity * conforms
        return np.divide(allowed * (counted + beside), counted, out=np.full_like(counted, np.inf), where=counted > 0)

    foretold = left(balls.total(cheap.torque.spin), balls.total(cheap.torque.conformity))
    *cheaper, last = [way for way in WAYS if asked in ("auto", way.rung)]
    for way in cheaper:
        if np.any(sliders.error(way, cheap) > foretold):  # power is spread over contacts and effects much alike
            continue
        found = sliders.result(way, cheap, foretold)
        if np.all(found.error <= left(found.spin, found.conformity)):
            return found
    return sliders.result(last, cheap, foretold)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Sliders:
    """All contacts of all balls at n operating points."""

    balls: LoadedBalls
    races: tuple[RaceContact, ...]
    ring_speed: Array
    spins: bool
    spin_rule: SpinRule

    def slide(self, way: Way, points: NDArray[np.intp] | slice = slice(None)) -> SlipFriction:
        shape = self.balls.load.shape[1:]
        difference = np.abs(self.balls.motion.spin_difference) if self.spins else np.zeros(shape)
        return slip_friction(
            *(race.at(points, shape) for race in self.races),
            ring_speed=self.ring_speed[points, None],
            spin_difference=difference[points],
            spin_rule=self.spin_rule,
            rung=way.rung,
            nodes=way.nodes,
        )

    def error(self, way: Way, found: SlipFriction) -> Array:
        """(n,) bound on what the way misses, of what it finds; power is spread over the contacts as it was found."""
        smooth = not any(race.traction.asks_speed for race in self.races)
        missed = np.full_like(self.balls.load, way.smooth if smooth else way.kinked)
        if way.rung != "over_ellipse":
            missed = missed + _slenderness(self.balls)
        if way.rung == "single_coefficient":
            missed = missed + _missed(self.races, found)
        return _relative(missed, _weight(self.balls, found))

    def result(self, way: Way, cheap: SlipFriction, allowed: Array) -> Sliding:
        """By a way, at all points or at a sample of them."""
        if way is WAYS[0]:
            return self._told(way, cheap)
        moving = self.ring_speed != 0
        if self.balls.load.shape[2] == 1 and np.count_nonzero(moving) >= SERIES:
            found = self._sampled(way, cheap, np.flatnonzero(moving), allowed)
            if found is not None:
                return found
        return self._told(way, self.slide(way))

    def _told(self, way: Way, found: SlipFriction) -> Sliding:
        return Sliding(
            spin=self.balls.total(found.torque.spin),
            conformity=self.balls.total(found.torque.conformity),
            coefficient=np.stack([found.inner_coefficient, found.outer_coefficient]),
            rung=way.rung,
            error=self.error(way, found),
        )

    def _sampled(self, way: Way, cheap: SlipFriction, moving: NDArray[np.intp], allowed: Array) -> Sliding | None:
        """Under thrust all balls are alike, and how far the ways are apart follows from load and speed alone."""
        base = _quantities(cheap)
        whole = base[:, :2].sum(axis=1)
        if not (np.all(whole > 0) and np.all(base[:, 2:] > 0)):
            return None
        scale = np.stack([whole, whole, base[:, 2], base[:, 3]], axis=1)

        def evaluate(points: NDArray[np.intp]) -> Array:
            at = moving[points]
            return (_quantities(self.slide(way, at)) - base[at]) / scale[at]

        def missed(found: Array, true: Array, points: NDArray[np.intp]) -> Array:
            before = (base[:, :2] / scale[:, :2])[moving[points]]
            return np.abs(np.sum((found - true)[:, :2], axis=1) / np.sum(before + true[:, :2], axis=1))

        error = self.error(way, cheap)
        series = sampled_series(
            evaluate,
            np.log(np.stack([self.balls.load[0, moving, 0], np.abs(self.ring_speed[moving])], axis=1)),
            missed=missed,
            allowed=float(np.min(allowed - error)),
        )
        if series is None:
            return None
        found = base.copy()
        found[moving] += scale[moving] * series.values
        standing = np.flatnonzero(self.ring_speed == 0)
        if standing.size:
            found[standing] = _quantities(self.slide(way, standing))
        return Sliding(
            spin=self.balls.alike * found[:, 0],
            conformity=self.balls.alike * found[:, 1],
            coefficient=found[:, 2:].T[..., None],
            rung=way.rung,
            error=error + series.error,
            computed=series.at.size + standing.size,
        )


def _quantities(found: SlipFriction) -> Array:
    """(n, 4) of balls alike: spin and conformity torque, coefficients."""
    torque = found.torque
    columns = (torque.spin, torque.conformity, found.inner_coefficient, found.outer_coefficient)
    return np.concatenate(columns, axis=1)


def _as_printed(sliders: _Sliders, found: SlipFriction) -> Sliding:
    """With the spin and the coefficients of the derived moments; how wrong it is, no rung of its own tells."""
    balls = sliders.balls
    coefficients = found.inner_coefficient, found.outer_coefficient
    inner, outer = (
        SlidingContact(
            friction_coefficient=coefficient,
            load=race.load,
            semi_axis_rolling=race.semi_axis_rolling,
            semi_axis_transverse=race.semi_axis_transverse,
            deformed_radius=race.deformed_radius,
            rolling_rate=race.rolling_rate,
        )
        for race, coefficient in zip(sliders.races, coefficients, strict=True)
    )
    torque = as_printed_torque(
        inner,
        outer,
        inner_spin_rate=found.torque.inner_spin_rate,
        outer_spin_rate=found.torque.outer_spin_rate,
        ball_radius=balls.ball_radius,
    )
    return Sliding(
        spin=balls.total(torque.spin),
        conformity=balls.total(torque.conformity),
        coefficient=np.stack(coefficients),
        rung="single_coefficient",
        error=np.full(balls.load.shape[1], np.inf),
    )


def rolling_power(balls: LoadedBalls) -> Array:
    """(2, n, m) torque of conformity without spin per N of friction force, m: 0.0806 b^2/R w_roll/w."""
    _, moment = microslip_moments(
        friction_coefficient=1.0,
        load=1.0,
        semi_axis_transverse=balls.contact.semi_axis_y,
        deformed_radius=balls.deformed_radius,
        spin_to_roll=0.0,
    )
    return moment * balls.rolling_rate


def full_spin(balls: LoadedBalls) -> Array:
    """(2, n, m) 3/8 b w_s/w, m: torque per N of friction of a race that takes all of the spin and does not roll."""
    return 3 / 8 * balls.contact.semi_axis_y * np.abs(balls.motion.spin_difference)


def largest_spin_rise(balls: LoadedBalls) -> Array:
    """(2, n, m) how much a race that takes all of the spin can add per N of Coulomb friction, m.

    The spin moment grows from 0 with a slope that never exceeds its first, and to no more than 3/8 mu Q b, and the
    power by slip grows with spin as the moment does: at most 0.458 eps b w_s/w, at most 3/8 b w_s/w.
    """
    spin = np.abs(balls.motion.spin_difference)
    ratio = spin * balls.deformed_radius / balls.rolling_rate  # eps b, m
    return np.minimum(SPIN_STIFFNESS / 2 * ratio * spin, full_spin(balls))


def most_missed(balls: LoadedBalls, lubricant: Lubricant | None) -> Array:
    """(2, n, m) how much larger than by mean stresses on a long ellipse the torque by sliding can be, relative."""
    uneven = {"eyring_sinh": MOST_UNEVEN, "eyring_constant": EVEN_STRESS}[lubricant.traction] if lubricant else 0.0
    return (1 + _slenderness(balls)) / (1 - uneven) - 1


def _weight(balls: LoadedBalls, found: SlipFriction) -> Array:
    """(2, n, m) of the power that slips at an operating point, what each contact loses."""
    torque, rate = found.torque, balls.rolling_rate
    power = np.stack(
        [
            torque.inner_spin_moment * torque.inner_spin_rate + torque.inner_rolling_moment * rate[0],
            torque.outer_spin_moment * torque.outer_spin_rate + torque.outer_rolling_moment * rate[1],
        ]
    )
    whole = np.sum(power, axis=(0, 2), keepdims=True)
    return np.divide(power, whole, out=np.zeros_like(power), where=whole > 0)


def _relative(missed: Array, weight: Array) -> Array:
    """(n,) what all contacts miss of their true power, told of what was found, which may be too small by it."""
    return np.sum(weight * missed / np.maximum(1 - missed, LEAST_FOUND), axis=(0, 2))


def _missed(races: tuple[RaceContact, ...], found: SlipFriction) -> Array:
    """(2, n, m) of the true power, what one coefficient misses on each contact."""
    slips = (found.inner_slip_speed, found.outer_slip_speed)
    return np.stack([_missed_by_one(race, slip) for race, slip in zip(races, slips, strict=True)])


def _missed_by_one(race: RaceContact, slip: Array) -> Array:
    if isinstance(race.traction, CoulombTraction):
        return np.zeros_like(slip)
    pressure = np.divide(race.load, race.area, out=np.zeros_like(slip), where=np.asarray(race.area) > 0)
    up, down = 1 + SPREAD, 1 / (1 + SPREAD)

    def exponent(high: Array, low: Array) -> Array:
        both = (high > 0) & (low > 0)
        return np.log(np.divide(high, low, out=np.ones_like(high), where=both)) / (2 * np.log(up))

    stress = race.traction.stress
    follows = exponent(stress(up * pressure, slip), stress(down * pressure, slip))
    missed = EVEN_STRESS * np.maximum(1 - follows, 0.0)
    if race.traction.asks_speed:
        missed = np.maximum(missed, KINK) + VISCOUS * exponent(
            stress(pressure, up * slip), stress(pressure, down * slip)
        )
    return missed + STEEP * np.maximum(follows - 1, 0.0)


def _slenderness(balls: LoadedBalls) -> Array:
    """(2, n, m) of the power, what a long ellipse misses; as a circle where the contact is longer along rolling."""
    a, b = balls.contact.semi_axis_x, balls.contact.semi_axis_y
    ratio = np.divide(a, b, out=np.zeros_like(b), where=b > 0)
    return BELOW_FULL_SPIN * (ellipe(1 - np.minimum(ratio, 1.0) ** 2) - 1)
