"""Exact answers of the hard cases of torque and slip: balls that roll at contact angle 0, and contacts that slide."""

from collections.abc import Callable

import mpmath
from mpmath import mpf

from tests.validation.hard.contact_exact import STEEL, rolling_without_spin
from tests.validation.hard.hertz_exact import hertz

BALL, BALLS, LOAD, FRICTION = mpf("7.94e-3"), 9, 640, mpf("0.1")  # m, N
INNER = mpf("15.53e-3")  # m: bottom radius, and without clearance the outer one is INNER + BALL
SOFT = ("206e9", "0.49")  # Pa and Poisson ratio


def units(groove: dict[str, mpf], ball: tuple[str, str], race: tuple[str, str]) -> dict[str, dict[str, mpf]]:
    """Hertz's contacts under 1 N, by race."""
    softness = sum((1 - mpf(ratio) ** 2) / mpf(modulus) for modulus, ratio in (ball, race))
    along = {"inner": 2 / BALL + 1 / INNER, "outer": 2 / BALL - 1 / (INNER + BALL)}
    return {each: hertz(along[each], 2 / BALL - 1 / groove[each], mpf(1), 1 / softness) for each in along}


def loads() -> list[mpf]:
    """Of the balls, N: the ring moves aside, and each approach goes as the cosine."""
    cosines = [max(mpmath.cospi(mpf(2 * i) / BALLS), mpf(0)) for i in range(BALLS)]
    heaviest = LOAD / sum(cosine ** mpf("2.5") for cosine in cosines)
    return [heaviest * cosine ** mpf("1.5") for cosine in cosines]


def conformity_torque(
    conformity: str | None = None, ball: tuple[str, str] = STEEL, race: tuple[str, str] = STEEL
) -> mpf:
    """Friction of all balls over the speed of the inner ring, N m.

    On each race it is mu Q b^2/R times 0.0806 times the rate at which the ball rolls there. With the ring at speed 1
    a ball turns at pitch/(2 D) (1 - (D/pitch)^2) about its axis, and its orbit has the speed (1 - D/pitch)/2.
    """
    radius = mpf(conformity) * BALL if conformity else None
    groove = {"inner": radius or mpf("4.13e-3"), "outer": radius or mpf("4.21e-3")}
    pitch = 2 * INNER + BALL
    turning, orbit = (pitch / BALL) * (1 - (BALL / pitch) ** 2) / 2, (1 - BALL / pitch) / 2
    rates = {"inner": turning + 1 - orbit, "outer": turning - orbit}
    total = mpf(0)
    for each, unit in units(groove, ball, race).items():
        surface = 2 / (2 / BALL + 1 / groove[each])  # radius of the contact surface: halfway between both
        per_load = FRICTION * unit["major"] ** 2 / surface * rolling_without_spin() * rates[each]
        total += per_load * sum(load ** (mpf(5) / 3) for load in loads())
    return total


def ellipse_end() -> mpf:
    """Major semi-axis of the heaviest ball on the inner race at conformity 0.5005, m."""
    groove = mpf("0.5005") * BALL
    return units({"inner": groove, "outer": groove}, STEEL, STEEL)["inner"]["major"] * mpmath.cbrt(max(loads()))


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
