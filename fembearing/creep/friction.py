"""Friction on rectangles: tractions that follow from slip by a law, and slip that follows from tractions by elasticity.

With the slip s = v + M t and a law of friction, the tractions are the fixed point t = R(t - rho s), where R is the
resolvent of the law: what is left of a traction that would be `reach` without slip. With Coulomb friction R projects on
the disk of radius mu p. Newton's method with a line search solves this; it is semismooth [Christensen1998].
"""

from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import sgetrf, sgetrs

from analytic.errors import ConvergenceError
from analytic.oil.traction import PointLaw, flow_of, flow_under
from analytic.scene import Array

Real = TypeVar("Real", bound=np.floating)
MOST_STEPS = 60  # 5 to 20 are usual
SETTLED = 1e-10  # of the largest traction
LEAST_SHARE = 1 / 64  # of a step
SLOW = 0.2  # of what was left: what a step leaves for which the derivatives are computed again
SOLID = 1e250  # s/m: oil of this fluidity shears at its limit
LARGEST_SINH = 700.0  # argument that still has a double
LEAST_RATE = 1e-290  # of shear by a user's law
MOST_BISECTIONS = 200  # 5 to 15 are usual, with Newton's steps


@dataclass(frozen=True, kw_only=True, eq=False)
class SlidingLaw:
    """Resistance to slip on each rectangle: a steady stress, and oil that flows by its law up to a limit.

    Stress `steady` + min(`eyring` f(`fluidity` s), `limit`), opposite to the slip s; f = asinh, or a user's law.
    """

    steady: Array  # (n,) Pa
    limit: Array  # (n,) Pa
    eyring: Array  # (n,) Pa; 0 everywhere: there is no oil that flows
    fluidity: Array  # (n,) over 1 of the slip
    own: float = 0.0  # of `PointLaw`

    def resist(self, reach: Array, stiffness: Array) -> tuple[Array, Array]:
        """Stress T with T + stiffness s = reach where the slip s has the stress T, and dT/d reach.

        reach : traction that would act without slip, Pa, (n,), >= 0;  stiffness : traction over slip, Pa, (n,), > 0
        """
        stress, slope = np.minimum(reach, self.steady), (reach <= self.steady).astype(float)
        if not np.any(self.eyring):
            return stress, slope
        slides = reach > self.steady
        asked = np.where(slides, reach - self.steady, 0.0) * self.fluidity / stiffness
        softness = self.eyring * self.fluidity / stiffness
        if self.own == 0.0:
            most = np.minimum(self.limit / self.eyring, LARGEST_SINH)
            flow = _flowing(asked, softness, most)
            flows, steepness = flow < most, 1 / np.cosh(flow)
        else:  # as if it had no limit, where that needs less than the limit
            flow, steepness = flow_of(self.own, _rates(asked, softness, self.own))
            flows = self.eyring * flow < self.limit
        oil, yields = np.where(flows, self.eyring * flow, self.limit), softness * steepness / (1 + softness * steepness)
        return stress + np.where(slides, oil, 0.0), np.where(slides & flows, yields, slope)


def _rates(asked: Array, softness: Array, own: float) -> Array:
    """The root of x + softness f(x) = asked by bisection of ln x, and by Newton's method once that stays inside."""
    high = np.log(np.maximum(asked, LEAST_RATE))
    low = np.full_like(high, np.log(LEAST_RATE))
    at = high
    for _ in range(MOST_BISECTIONS):
        rates = np.exp(at)
        flow, steepness = flow_of(own, rates)
        with np.errstate(over="ignore", invalid="ignore"):  # of solid oil: infinity is too high, and bisected
            left = rates + softness * flow - asked
            step = left / (rates * (1 + softness * steepness))
        low, high = np.where(left <= 0, at, low), np.where(left > 0, at, high)
        then = np.where((at - step > low) & (at - step < high), at - step, (low + high) / 2)
        if np.all(np.abs(then - at) <= 1e-14 * np.maximum(np.abs(at), 1.0)):  # a few roundings
            break
        at = then
    return np.where(asked > 0, np.exp(at), 0.0)


def _flowing(asked: Array, softness: Array, most: Array) -> Array:
    """The root of sinh(y) + softness y = asked, from above, where the left side is convex."""
    y = np.minimum(np.minimum(np.arcsinh(asked), asked / (1 + softness)), most)
    for _ in range(MOST_STEPS):
        last, step = y, (np.sinh(y) + softness * y - asked) / (np.cosh(y) + softness)
        y = np.clip(y - step, 0.0, most)
        if np.all(np.abs(y - last) <= 1e-14 * np.maximum(y, 1.0)):  # a few roundings
            break
    return y


def sliding_law(law: PointLaw, *, pressure: Array, speed: float) -> SlidingLaw:
    """A law of traction on rectangles, for slip over the rolling speed.

    law : numbers;  pressure : p, Pa, any shape, which is made (n,);  speed : V of rolling, m/s, >= 0
    """
    flat = pressure.ravel().astype(float)
    steady, limit = law.boundary * flat + law.plain * (flat > 0), law.limit * flat
    fluidity = eyring = np.zeros_like(flat)
    if speed > 0.0 and law.fluidity > 0.0:  # standing oil does not resist
        fluidity, eyring = np.array([flow_under(law, each) for each in flat.tolist()]).T
    return SlidingLaw(
        steady=steady,
        limit=limit,
        eyring=eyring,
        fluidity=speed * np.minimum(fluidity, SOLID),
        own=float(law.own),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class Settled:
    """Tractions and slip that fulfil the law."""

    traction: Array  # (2 n,) along x, then along y, Pa
    slip: Array  # (2 n,) likewise, over the rolling speed
    response: Array  # (2 n, k) of the tractions to the k patterns of slip, Pa
    steps: int


def settle(matrix: Array, slip: Array, law: SlidingLaw, *, stiffness: Array, patterns: Array, start: Array) -> Settled:
    """Tractions under a slip of rigid bodies.

    matrix : M, (2 n, 2 n), 1/Pa;  slip : v, (2 n,);  stiffness : rho, of each rectangle alone, (n,), Pa, > 0
    patterns : of v, whose response is wanted, (2 n, k)
    start : tractions, Pa, (2 n,)
    Raises ConvergenceError where Newton's method ends short of it.
    """
    traction, moved = start, matrix @ start
    found, slopes = _resolved(traction, slip + moved, law, stiffness)
    left, twice = traction - found, np.tile(stiffness, 2)[:, None]
    keeps = np.eye(len(matrix), dtype=np.float32) - (twice * matrix).astype(np.float32)  # steps need no more digits
    factor = _factor(keeps, slopes)
    for number in range(1, MOST_STEPS + 1):
        step, share, size = -sgetrs(*factor, left, trans=True)[0].astype(float), 1.0, np.sum(left**2)
        step_moved = matrix @ step
        while True:
            trial, trial_moved = traction + share * step, moved + share * step_moved
            found, slopes = _resolved(trial, slip + trial_moved, law, stiffness)
            left = trial - found
            if np.sum(left**2) <= (1 - share / 4) * size or share <= LEAST_SHARE:
                break
            share /= 2
        traction, moved = trial, trial_moved
        if np.max(np.abs(left)) <= SETTLED * np.max(np.abs(traction)):
            answer = np.zeros_like(patterns)
            for _ in range(2):  # as the factors are those of a step before
                reach = answer - twice * (patterns + matrix @ answer)
                answer -= sgetrs(*factor, answer - _turned(slopes, reach), trans=True)[0]
            return Settled(traction=traction, slip=slip + moved, response=answer, steps=number)
        if np.sum(left**2) > SLOW**2 * size:
            factor = _factor(keeps, slopes)
    raise ConvergenceError(
        iterations=MOST_STEPS,
        residual=float(np.max(np.abs(left))),
        tolerance=float(SETTLED * np.max(np.abs(traction))),
        unit="Pa",
        problem="friction on the contact",
        remedy="Use more rectangles, or less friction.",
    )


def _resolved(traction: Array, slip: Array, law: SlidingLaw, stiffness: Array) -> tuple[Array, Array]:
    """R(t - rho s), (2 n,), and the slopes of R by both components, (3, n): xx, xy, yy."""
    n = stiffness.size
    x, y = traction[:n] - stiffness * slip[:n], traction[n:] - stiffness * slip[n:]
    reach = np.hypot(x, y)
    stress, slope = law.resist(reach, stiffness)
    over = np.divide(stress, reach, out=slope.copy(), where=reach > 0)
    e_x, e_y = (np.divide(part, reach, out=np.zeros(n), where=reach > 0) for part in (x, y))
    rest = slope - over
    slopes = np.stack([over + rest * e_x * e_x, rest * e_x * e_y, over + rest * e_y * e_y])
    return np.concatenate([over * x, over * y]), slopes


def _turned(slopes: NDArray[Real], vectors: NDArray[Real]) -> NDArray[Real]:
    """R' times vectors, (2 n, k)."""
    n = slopes.shape[1]
    x, y = vectors[:n], vectors[n:]
    xx, xy, yy = (slope[:, None] for slope in slopes)
    return np.concatenate([xx * x + xy * y, xy * x + yy * y])


def _factor(keeps: NDArray[np.float32], slopes: Array) -> tuple[NDArray[np.float32], NDArray[np.int32]]:
    """Of 1 - R' times `keeps`, transposed, which is the order of Fortran."""
    tangent = np.eye(len(keeps), dtype=np.float32) - _turned(slopes.astype(np.float32), keeps)
    return sgetrf(tangent.T, overwrite_a=True)[:2]
