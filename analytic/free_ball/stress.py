"""The stress of one point of a free ball's contact by its law of traction, with and without surfaces that creep.

Rates are per unit ring speed w, so slip is a length; a law is part of a contact's row (`analytic.free_ball.layout`).
"""

import numpy as np

from analytic.free_ball.layout import EYRING, FLUIDITY, SHARE
from analytic.numerics.compilation import compiled

SOLID = 1e250  # fluidity from which oil does not flow: it shears at its limit


@compiled(inline=True)
def yielding(slip, steady, limit, eyring, fluidity):
    """Stress of a point that slides, and its slope: steady + min(eyring asinh(fluidity slip), limit)."""
    if eyring == 0.0:
        return steady, 0.0
    if fluidity > SOLID:
        return steady + limit, 0.0
    rate = fluidity * slip
    oil = eyring * np.arcsinh(rate)
    if oil >= limit:
        return steady + limit, 0.0
    return steady + oil, eyring * fluidity / np.sqrt(1.0 + rate * rate)


@compiled(inline=True)
def _hyperbolic(y):
    """sinh and cosh from one exponential, without the cancellation near 0."""
    above = np.expm1(y)
    return (above + above / (1.0 + above)) / 2.0, 1.0 + above * (above / (2.0 * (1.0 + above)))


@compiled(inline=True)
def sheared(reach, compliance, steady, limit, eyring, fluidity):
    """Stress and slope of a point whose surfaces would slip by `reach` without stress: g + compliance T(g) = reach."""
    if eyring == 0.0:
        limit = 0.0
    elif fluidity > SOLID:
        steady, eyring = steady + limit, 0.0
    if reach <= compliance * steady:
        return reach / compliance, 1.0 / compliance
    slip = reach - compliance * (steady + limit)
    if eyring == 0.0 or (slip > 0.0 and eyring * np.arcsinh(fluidity * slip) >= limit):
        return steady + limit, 0.0
    # sinh(y)/fluidity + compliance eyring y = rest rises and is convex: from the right Newton cannot overshoot.
    rest = reach - compliance * steady
    y = min(np.arcsinh(fluidity * rest), rest / (compliance * eyring))
    for _ in range(50):
        sinh, cosh = _hyperbolic(y)
        value = sinh / fluidity + compliance * eyring * y - rest
        step = value / (cosh / fluidity + compliance * eyring)
        y -= step
        if step <= 1e-14 * y:
            break
    _, cosh = _hyperbolic(y)
    slope = eyring * fluidity / cosh
    return steady + eyring * y, slope / (1.0 + compliance * slope)


@compiled(inline=True)
def fluidity_of(law, pressure, table, spacing):
    """Slip times this is the rate of shear over the rate at the Eyring stress; table : ln of the oil's thickening."""
    if law[EYRING] == 0.0:
        return 0.0
    place = law[SHARE] * pressure / spacing
    index = min(int(place), table.shape[0] - 2)
    return law[FLUIDITY] * np.exp(table[index] + (place - index) * (table[index + 1] - table[index]))
