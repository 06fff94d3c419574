"""Exponential and logarithm without a branch or a call, so that a compiled loop computes several at once."""

import numpy as np

from analytic.numerics.compilation import compiled

ROUNDS = 1.5 * 2.0**52  # a sum with it is a whole number
LN_2, PER_LN_2 = float(np.log(2.0)), float(1.0 / np.log(2.0))
LN_2_HEAD = 0.6931471803691238  # with zeros in its last bits, so that whole multiples are exact
LN_2_TAIL = 1.9082149292705877e-10
# Of a double: how far the exponent is from the last bit and from 0, the bits of 1 and of 2^52, and those of a mantissa
EXPONENT, BIAS = 52, 1023
OF_ONE, OF_WHOLE, MANTISSA = 0x3FF0000000000000, 0x4330000000000000, 0x000FFFFFFFFFFFFF


@compiled
def exponential(y: float) -> float:
    """e^y for -700 < y < 700, to 1e-14 of itself: by its series within ln(2)/2 of a power of 2."""
    shifted = y * PER_LN_2 + ROUNDS
    power = shifted - ROUNDS  # a whole number, which the last bits of `shifted` hold too
    z = (y - power * LN_2_HEAD) - power * LN_2_TAIL
    ahead = ((z / 479001600.0 + 1.0 / 39916800.0) * z + 1.0 / 3628800.0) * z + 1.0 / 362880.0
    middle = (((ahead * z + 1.0 / 40320.0) * z + 1.0 / 5040.0) * z + 1.0 / 720.0) * z + 1.0 / 120.0
    series = ((((middle * z + 1.0 / 24.0) * z + 1.0 / 6.0) * z + 0.5) * z + 1.0) * z + 1.0
    bits = np.float64(shifted).view(np.int64)
    two_to_power = np.int64((bits + BIAS) << EXPONENT)
    return series * two_to_power.view(np.float64)


@compiled
def roughly_log(x: float) -> float:
    """ln x to 0.006, x > 0 and not below 1e-307: by a parabola between powers of 2."""
    bits = np.float64(x).view(np.int64)
    above = np.int64((bits >> EXPONENT) | OF_WHOLE).view(np.float64) - (2.0**52 + BIAS)
    m = np.int64((bits & MANTISSA) | OF_ONE).view(np.float64)
    return LN_2 * (above + (2.0 - m / 3.0) * m - 5.0 / 3.0)
