"""Exact answers of the hard cases of torque and slip: balls that roll at contact angle 0, and contacts that slide."""

from collections.abc import Callable

import mpmath
from mpmath import mpf

from tests.validation.hard.contact_exact import STEEL
from tests.validation.hard.hertz_exact import hertz

BALL, BALLS, LOAD = mpf("7.94e-3"), 9, 640  # m, N
INNER = mpf("15.53e-3")  # m: bottom radius


def loads() -> list[mpf]:
    """Of the balls, N: the ring moves aside, and each approach goes as the cosine."""
    cosines = [max(mpmath.cospi(mpf(2 * i) / BALLS), mpf(0)) for i in range(BALLS)]
    heaviest = LOAD / sum(cosine ** mpf("2.5") for cosine in cosines)
    return [heaviest * cosine ** mpf("1.5") for cosine in cosines]


def ellipse_end() -> mpf:
    """Major semi-axis of the heaviest ball on the inner race at conformity 0.5005, m."""
    modulus, ratio = map(mpf, STEEL)
    unit = hertz(2 / BALL + 1 / INNER, 2 / BALL - 1 / (mpf("0.5005") * BALL), mpf(1), modulus / (2 * (1 - ratio**2)))
    return unit["major"] * mpmath.cbrt(max(loads()))


def beyond(distance: str) -> mpf:
    """Share of Hertz's load beyond this distance: its pressure, integrated over x, is a parabola over y."""
    u = mpf(distance) / ellipse_end()
    return mpmath.quad(lambda y: mpf(3) / 4 * (1 - y**2), [u, 1])


TORQUE: dict[str, Callable[[], mpf]] = {
    "torque: ellipse past the shoulder": lambda: beyond("0.6e-3"),
    "numerical friction: 1e-6 N": lambda: mpf(4) / 3,
    "numerical friction: 1e-4 N on a free ring": lambda: mpf(4) / 3,
    "numerical friction: slides in a spin": lambda: -mpf(3) / 8 * mpmath.ellipe(1 - (mpf("0.11") / mpf("0.83")) ** 2),
}
