"""Hertz's contact to more than 40 digits."""

from functools import cache

import mpmath
from mpmath import mpf


@cache
@mpmath.workdps(100)
def hertz(curvature_x: mpf, curvature_y: mpf, load: mpf, modulus: mpf) -> dict[str, mpf]:
    """By the textbook formula in Legendre's integrals, with 100 digits, half of which it loses close to a circle."""
    large, small = max(curvature_x, curvature_y), min(curvature_x, curvature_y)
    log_ratio = mpmath.log(large / small)

    def integrals(log_k: mpf) -> tuple[mpf, mpf]:
        m = 1 - mpmath.exp(-2 * log_k)
        return mpmath.ellipk(m), mpmath.ellipe(m)

    def excess(log_k: mpf) -> mpf:
        K, E = integrals(log_k)
        return mpmath.log((mpmath.exp(2 * log_k) * E - K) / (K - E)) - log_ratio

    log_k = mpf(0)
    if log_ratio:
        log_k = mpmath.findroot(excess, (log_ratio / 2, log_ratio * 2 / 3), solver="anderson", tol=mpf(10) ** -90)
    K, E = integrals(log_k)
    k = mpmath.exp(log_k)
    major = mpmath.cbrt(3 * k**2 * E * load / (mpmath.pi * modulus * (large + small)))
    approach = 3 * load * K / (2 * mpmath.pi * modulus * major)
    return {
        "minor": major / k,
        "major": major,
        "pressure": 3 * load * k / (2 * mpmath.pi * major**2),
        "approach": approach,
        "stiffness": load / approach ** (mpf(3) / 2),
        "log_k": log_k,
    }
