"""The stress of one point of a free ball's contact by its law of traction, with and without surfaces that creep.

Rates are per unit ring speed w, so slip is a length. A point slides by the law where its slip, times its fluidity, is
the rate of shear over the rate at the Eyring stress; from the slip `most` on its oil shears at its limit.
"""

from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.exponentials import exponential, roughly_log
from analytic.oil.law_table import flow_of, rate_of
from analytic.oil.traction import PointLaw, flow_under

FAST = frozenset(("contract", "reassoc", "arcp", "nsz"))  # sums over the nodes may round in any order
SOLID = 1e250  # fluidity from which oil does not flow: it shears at its limit
NEARLY_LINEAR = 0.3  # from here on the difference of two exponentials is as accurate as the series of sinh


class Shear(NamedTuple):
    """The law of traction at one point of a contact, whose pressure is known."""

    steady: float  # Pa, at any slip
    limit: float  # Pa, of the oil
    eyring: float  # Pa
    fluidity: float  # 1/m
    most: float  # m, slip from which the oil shears at its limit; 0: at any


@compiled
def flow_at(law: PointLaw, pressure: float) -> tuple[float, float, float]:
    """Eyring stress, fluidity and `most` of a point under the pressure p, Pa; speeds are per unit ring speed."""
    fluidity, eyring = flow_under(law, pressure)
    if law.own != 0.0 and law.eyring > 0.0:
        fluidity = min(fluidity, SOLID)
        return eyring, fluidity, rate_of(law.own, 0.0, eyring, law.limit * pressure) / fluidity
    if law.eyring == 0.0 or not fluidity <= SOLID:
        return eyring, 0.0, 0.0
    return eyring, fluidity, np.sinh(law.limit * pressure / eyring) / fluidity


@compiled(fastmath=FAST)
def yielding(slip, shear):
    """Stress of a point that slides, and its slope."""
    if slip >= shear.most:
        return shear.steady + shear.limit, 0.0
    rate = shear.fluidity * slip
    return shear.steady + shear.eyring * np.arcsinh(rate), shear.eyring * shear.fluidity / np.sqrt(1.0 + rate * rate)


@compiled
def yielding_by_own(slip, shear, own):
    """`yielding` by a user's law; own : of a `PointLaw`"""
    if slip >= shear.most:
        return shear.steady + shear.limit, 0.0
    flow, steepness = flow_of(own, shear.fluidity * slip)
    return shear.steady + shear.eyring * flow, shear.eyring * shear.fluidity * steepness


@compiled(fastmath=FAST)
def _hyperbolic(y):
    """sinh and cosh: near 0 sinh by its series, whose next term is below rounding, else from one exponential."""
    above = exponential(y)
    below = 1.0 / above
    z = y * y
    small = y * (1.0 + z / 6.0 * (1.0 + z / 20.0 * (1.0 + z / 42.0 * (1.0 + z / 72.0 * (1.0 + z / 110.0)))))
    return small if y <= NEARLY_LINEAR else (above - below) / 2.0, (above + below) / 2.0


@compiled(fastmath=FAST)
def _halley(y, asked, softness):
    """The next y towards sinh(y) + softness y = asked, and about its cosh."""
    sinh, cosh = _hyperbolic(y)
    per_slope = 1.0 / (cosh + softness)
    newton = (sinh + softness * y - asked) * per_slope
    step = newton / (1.0 - newton * sinh * per_slope / 2.0)
    return y - step, cosh - step * sinh


@compiled(fastmath=FAST)
def sheared(reach, compliance, shear):
    """Stress and slope of a point whose surfaces would slip by `reach` without stress: g + compliance T(g) = reach."""
    whole = shear.steady + shear.limit
    rest, stiffness = reach - compliance * shear.steady, shear.eyring * shear.fluidity
    # sinh(y) + softness y = asked rises and is convex; the start lies on its right, and Halley's method goes down: from
    # any start to 3e-2, 3e-4 and 3e-10 of y.
    asked, softness = shear.fluidity * max(rest, 0.0), compliance * stiffness
    first, _ = _halley(min(asked / (1.0 + softness), roughly_log(1.0 + 2.0 * asked)), asked, softness)
    second, _ = _halley(first, asked, softness)
    y, cosh = _halley(second, asked, softness)
    stress, slope = shear.steady + shear.eyring * y, stiffness / (cosh + softness)
    sticks, is_solid = rest <= 0.0 or shear.most == 0.0, reach - compliance * whole >= shear.most
    stress, slope = (reach / compliance, 1.0 / compliance) if sticks else (stress, slope)
    return (whole, 0.0) if is_solid else (stress, slope)


@compiled
def sheared_by_own(reach, compliance, shear, own):
    """`sheared` by a user's law; own : of a `PointLaw`"""
    whole = shear.steady + shear.limit
    if reach - compliance * whole >= shear.most:
        return whole, 0.0
    rest = reach - compliance * shear.steady
    if rest <= 0.0 or shear.most == 0.0:
        return reach / compliance, 1.0 / compliance
    softness = compliance * shear.eyring * shear.fluidity
    flow, steepness = flow_of(own, rate_of(own, 1.0, softness, shear.fluidity * rest))
    slope = shear.eyring * shear.fluidity * steepness / (1.0 + softness * steepness)
    return shear.steady + shear.eyring * flow, slope
