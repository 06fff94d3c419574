"""Exact answers of the hard cases of contacts, meshes and micro-slip, from textbook formulas."""

from collections.abc import Callable

import mpmath
from mpmath import mpf

from tests.validation.hard.hertz_exact import hertz

STEEL, PEEK, INCOMPRESSIBLE = ("206e9", "0.3"), ("3.6e9", "0.38"), ("206e9", "0.4999")  # Pa and Poisson ratio


def plain(quantity: str, curvature_x: str = "310", curvature_y: str = "9.7", load: str = "613") -> mpf:
    return hertz(mpf(curvature_x), mpf(curvature_y), mpf(load), mpf("1.13e11"))[quantity]


def on_race(
    quantity: str,
    *,
    load: str = "620",
    ball: tuple[str, str] = STEEL,
    race: tuple[str, str] = STEEL,
    groove: str = "4.13e-3",
) -> mpf:
    """The ball on the inner race of the 6205 at 0.18 rad, from its dimensions typed in again."""
    radius, pitch, cosine = mpf("3.97e-3"), mpf("15.53e-3") + mpf("23.48e-3"), mpmath.cos(mpf("0.18"))
    along = 1 / radius + cosine / (pitch / 2 - radius * cosine)
    softness = sum((1 - mpf(ratio) ** 2) / mpf(modulus) for modulus, ratio in (ball, race))
    return hertz(along, 1 / radius - 1 / mpf(groove), mpf(load), 1 / softness)[quantity]


def still_line() -> mpf:
    """g of the pure-rolling lines without spin, the root of g^3 - 3 g + 1 between 0 and 1."""
    return mpmath.findroot(lambda g: g**3 - 3 * g + 1, mpf("0.35"))


def rolling_without_spin() -> mpf:
    """The moment of the friction about the rolling axis, with slip as y^2 - g^2, by quadrature."""
    g = still_line()

    def weighted(y: mpf) -> mpf:
        return mpf(3) / 4 * (1 - y**2) * mpmath.sign(y**2 - g**2) * y**2 / 2

    return 2 * (mpmath.quad(weighted, [0, g]) + mpmath.quad(weighted, [g, 1]))


def spinning_in_full(rate: str) -> mpf:
    """3/8 mu Q b times the rate, N m."""
    return mpf(3) / 8 * mpf("0.07") * 530 * mpf("0.9e-3") * mpf(rate)


def shared_spin() -> mpf:
    """Torque of two equal contacts with half of the spin each, times its rate."""
    eps = mpf("0.69") / 2 * mpf("3.7e-3") / (mpf("2.9") * mpf("0.9e-3"))
    d = mpmath.findroot(lambda d: d**3 - 3 * (1 - eps**2) * d + 1, mpf("0.49"))
    return 8 * eps * d * (1 - eps**2 - d**2) * spinning_in_full("0.69")


def mises_on_the_surface() -> mpf:
    """Von Mises stress of -p0 b/(a + b), -p0 a/(a + b) and -p0, at the ellipse's centre for Poisson ratio 0."""
    a, b = mpf("0.12"), mpf("1.1")
    along, across = b / (a + b), a / (a + b)
    return mpf("2.1e9") * mpmath.sqrt(((along - across) ** 2 + (across - 1) ** 2 + (1 - along) ** 2) / 2)


CERAMIC, BRONZE = ("310e9", "0.27"), ("110e9", "0.34")

CONTACT: dict[str, Callable[[], mpf]] = {
    "Hertz: circle": lambda: plain("approach", curvature_y="310"),
    "Hertz: nearly a circle": lambda: plain("log_k", "310", str(310 * (1 - mpf("1e-12")))) * mpf("1e12"),
    "Hertz: ratio 1e6": lambda: plain("minor", "9.7e6"),
    "Hertz: ratio 1e-6": lambda: plain("minor", "9.7", "9.7e6"),
    "Hertz: 1e-12 N": lambda: plain("approach", load="1e-12"),
    "Hertz: no load": lambda: plain("stiffness"),
    "Hertz: plastic overload": lambda: plain("pressure", load="1e7") / plain("pressure", load="10"),
    "Hertz: incompressible": lambda: mpf("206e9") / (2 * (1 - mpf("0.4999") ** 2)),
    "Hertz: steel on PEEK": lambda: on_race("approach", race=PEEK),
    "stress: Poisson ratio 0": mises_on_the_surface,
    "contact angle: vanishing load": lambda: mpf("0.18"),
    "contact angle: from zero": lambda: mpf(1) / 4,
    "contact angle: preload": lambda: mpf("14e-6") / 2,
    "contact: 1e-6 N": lambda: on_race("approach", load="1e-6"),
    "contact: load to the two thirds": lambda: mpf(2) / 3,
    "contact: incompressible": lambda: on_race("pressure", ball=INCOMPRESSIBLE, race=INCOMPRESSIBLE),
    "contact: close groove": lambda: on_race("major", groove=str(mpf("0.505") * mpf("7.94e-3"))),
    "contact: mesh ten times too small": lambda: on_race("minor"),
    "contact: mesh ten times too large": lambda: on_race("approach"),
    "contact: cut off by 2 %": lambda: on_race("approach"),
    "contact: first mesh touched by one node": lambda: on_race("pressure"),
    "contact: mesh ten times too wide along rolling": lambda: on_race("approach"),
    "contact: mesh ten times too narrow": lambda: on_race("major"),
    "contact: active set of one node": lambda: on_race("approach"),
    "contact: static limit": lambda: mpf("4.2e9"),
    "contact: true groove at 1e-6 N": lambda: on_race("approach", load="1e-6"),
    "contact: closest groove": lambda: on_race("approach", groove=str(mpf("0.5025") * mpf("7.94e-3"))),
    "contact: open groove": lambda: on_race("pressure", groove=str(mpf("0.6") * mpf("7.94e-3"))),
    "contact: steel on ceramic": lambda: on_race("approach", race=CERAMIC),
    "contact: steel on bronze": lambda: on_race("minor", race=BRONZE),
    "contact: steel on PEEK": lambda: on_race("approach", race=PEEK),
    "contact: incompressible race": lambda: on_race("pressure", load="1e-3", race=INCOMPRESSIBLE),
    "contact: other units": lambda: mpf(1000),
    "micro-slip: no spin": rolling_without_spin,
    "micro-slip: vanishing spin": lambda: 3 * still_line() * (1 - still_line() ** 2),
    "micro-slip: full spin": lambda: 2 * mpmath.quad(lambda y: mpf(3) / 4 * (1 - y**2) * y, [0, 1]),
    "micro-slip: far beyond full spin": lambda: mpf(3) / 8,
    "micro-slip: the end of rolling": lambda: mpf(3) / 4,
    "spin balance: nearly equal races": shared_spin,
    "spin balance: both races in full spin": lambda: spinning_in_full("0.83"),
    "load: radial, zero angle": lambda: 9 / sum(max(mpmath.cospi(mpf(2 * i) / 9), 0) ** mpf("2.5") for i in range(9)),
    "load: radial, 400 balls": lambda: (
        2 * mpmath.pi / mpmath.quad(lambda psi: mpmath.cos(psi) ** mpf("2.5"), [-mpmath.pi / 2, 0, mpmath.pi / 2])
    ),
    "torque: spin at vanishing load": lambda: mpf(4) / 3,
    "free ball: vanishing load": lambda: mpf(4) / 3,
    "torque: conformity at vanishing load": lambda: mpf(5) / 3,
    "torque: hysteresis at vanishing load": lambda: mpf(4) / 3,
    "torque: spin from an angle of zero": lambda: mpf(5) / 4,
    "torque: conformity from an angle of zero": lambda: mpf(5) / 4,
}
