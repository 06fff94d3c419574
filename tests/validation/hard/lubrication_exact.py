"""Exact answers of the hard cases of film, asperities, oil and surfaces, from the formulas as printed."""

from collections.abc import Callable

import mpmath
from mpmath import mpf

from tests.validation.hard.hertz_exact import hertz

STIFF, HARDNESS = "1.13e11", "7.8e9"  # E* and H, Pa
LENGTH = "60e-6"  # of the autocorrelation, m


Number = str | float | mpf
Summits = tuple[mpf, mpf, mpf, mpf]  # density, tip radius, deviation and mean height


def asymptotes(
    *,
    along: Number = "310",
    across: Number = "9.7",
    load: Number = "613",
    speed: Number = "0.37",
    alpha: Number = "2.1e-8",
    modulus: Number = STIFF,
    borne: mpf = mpf(1),  # noqa: B008  # by the oil, share of load and stiffness
) -> tuple[mpf, mpf, dict[str, mpf]]:
    """R_x U^(1/2), lambda and H of each asymptote, powers as printed."""
    r_x, stiff = 1 / mpf(along), 2 * mpf(modulus) * borne
    u = 2 * mpf("0.061") * mpf(speed) / (stiff * r_x)
    m = mpf(load) * borne / (stiff * r_x**2) * u ** mpf("-0.75")
    ell, ratio = mpf(alpha) * stiff * mpmath.root(u, 4), mpf(across) * r_x
    elastic = 1 + mpf("0.006") * mpmath.log(ratio) + mpf("0.63") * ratio ** (mpf(4) / 7)
    found = {
        "RI": 145 * (1 + mpf("0.796") * ratio ** (mpf(14) / 15)) ** (-mpf(15) / 7) / ratio / m**2,
        "RP": mpf("1.29") * (1 + mpf("0.691") * ratio) ** (-mpf(2) / 3) * ell ** (mpf(2) / 3),
        "EI": mpf("3.18") * elastic ** (-mpf(14) / 25) * ratio ** (-mpf(1) / 15) * m ** (-mpf(2) / 15),
        "EP": mpf("1.48")
        * elastic ** (-mpf(7) / 20)
        * ratio ** (-mpf(1) / 24)
        * m ** (-mpf(1) / 12)
        * ell ** mpf(".75"),
        "00": mpf("1.8") / ratio,
    }
    return r_x * mpmath.sqrt(u), ratio, found


def film(**changed) -> mpf:
    """The formula as printed."""
    size, _, h = asymptotes(**changed)
    s = mpf("1.5") * (1 + mpmath.exp(-mpf("1.2") * h["EI"] / h["EP"]))
    left = h["RI"] ** mpf("1.5") + (h["EI"] ** -4 + h["00"] ** -4) ** (-mpf(3) / 8)
    return size * (left ** (2 * s / 3) + (h["RP"] ** -8 + h["EP"] ** -8) ** (-s / 8)) ** (1 / s)


def isoviscous() -> mpf:
    """The formula without its piezoviscous half; s is then 3/2."""
    size, _, h = asymptotes(alpha="0")
    return size * (h["RI"] ** mpf("1.5") + (h["EI"] ** -4 + h["00"] ** -4) ** (-mpf(3) / 8)) ** (mpf(2) / 3)


def rigid_isoviscous(**changed: str) -> mpf:
    size, _, h = asymptotes(**changed)
    return size * h["RI"]


def summits(sq: str) -> Summits:
    """Of two equal surfaces with gaussian autocorrelation."""
    height = 2 * mpf(sq) ** 2
    slope, curvature = 2 * height / mpf(LENGTH) ** 2, 12 * height / mpf(LENGTH) ** 4
    return (
        curvature / (6 * mpmath.pi * mpmath.sqrt(3) * slope),
        mpf(3) / 8 * mpmath.sqrt(mpmath.pi / curvature),
        mpmath.sqrt((1 - mpf("0.8968") / 3) * height),
        4 * mpmath.sqrt(height / (3 * mpmath.pi)),
    )


def first_yield(radius: mpf, modulus: Number = STIFF) -> mpf:
    return (3 * mpmath.pi * mpf("0.4") * mpf(HARDNESS) / (4 * mpf(modulus))) ** 2 * radius


def summit(w: mpf, radius: mpf, modulus: Number = STIFF) -> tuple[mpf, mpf]:
    """Load and area at this interference: elastic, in between, and flowing."""
    w1 = first_yield(radius, modulus)
    w2 = 54 * w1
    if w < w1:
        return mpf(4) / 3 * mpf(modulus) * mpmath.sqrt(radius) * w * mpmath.sqrt(w), mpmath.pi * radius * w
    if w >= w2:
        return 2 * mpmath.pi * radius * w * mpf(HARDNESS), 2 * mpmath.pi * radius * w
    part = (w - w1) / (w2 - w1)
    area = mpmath.pi * radius * w * (1 - 2 * part**3 + 3 * part**2)
    return mpf(HARDNESS) * (1 - mpf("0.6") * mpmath.log(w2 / w) / mpmath.log(mpf(54))) * area, area


def log_over_summits(t: mpf, of: Summits, *, area: bool = False, modulus: Number = STIFF) -> mpf:
    """ln of nominal pressure or area fraction at t deviations above the mean, by quadrature over the heights."""
    density, radius, deviation, _ = of
    w1 = first_yield(radius, modulus)

    def weighted(y: mpf) -> mpf:
        return summit(y * deviation, radius, modulus)[area] * mpmath.exp(-t * y - y**2 / 2)  # phi(t + y) over phi(t)

    reach = 14 - t if t < 0 else mpmath.sqrt(t**2 + 200) - t
    edges = {mpf(0), reach, *(reach * part / 16 for part in (1, 2, 4, 8))}
    if t < 0:
        edges |= {-t + step for step in (-8, -4, -2, -1, 0, 1, 2, 4) if 0 < -t + step < reach}
    edges |= {w / deviation for w in (w1, 54 * w1) if w / deviation < reach}
    return mpmath.log(density * mpmath.quad(weighted, sorted(edges)) / mpmath.sqrt(2 * mpmath.pi)) - t**2 / 2


def mean_gap(separation: mpf, sigma: mpf) -> mpf:
    """Of surfaces that are cut off where they overlap."""
    x = separation / sigma
    return sigma * (mpmath.npdf(x) + x * mpmath.ncdf(x))


def left_to_oil(sq: str, **changed: str) -> tuple[mpf, mpf]:
    """1 - s and h, where the film under the oil's part of load and stiffness fills the gap under the asperities' part.

    The unknown is by how much, in logarithms, the separation exceeds that of dry surfaces, in deviations of summits.
    """
    _, _, deviation, mean = of = summits(sq)
    sigma = mpmath.sqrt(2) * mpf(sq)
    ellipse = hertz(mpf(310), mpf("9.7"), mpf(613), mpf(STIFF))
    log_area = mpmath.log(mpmath.pi * ellipse["minor"] * ellipse["major"] / 613)

    def log_share(t: mpf) -> mpf:
        return log_over_summits(t, of) + log_area

    def gap(t: mpf) -> mpf:
        return mean_gap(mean + t * deviation, sigma)

    with mpmath.workdps(30):
        dry = mpmath.findroot(log_share, (mpf(0), mpf(-1)), tol=mpf(10) ** -56)

        def excess(log_rise: mpf) -> mpf:
            t = dry + mpmath.exp(log_rise)
            return mpmath.log(gap(t) / film(borne=-mpmath.expm1(log_share(t)), **changed))

        t = dry + mpmath.exp(mpmath.findroot(excess, (mpf(-9), mpf(-10)), tol=mpf(10) ** -44))
        return -mpmath.expm1(log_share(t)), gap(t)


def left_by_boundary(sq: str, **changed: str) -> mpf:
    """(1 - s)(1 - exp(-h/h_m)) with a molecular film of 1 nm."""
    borne, gap = left_to_oil(sq, **changed)
    return -borne * mpmath.expm1(-gap / mpf("1e-9"))


def pressed_flat() -> mpf:
    """h where all summits flow, whatever their heights: their mean interference carries the pressure."""
    density, radius, _, mean = summits("0.3e-6")
    return mean - mpf("1e15") / (density * 2 * mpmath.pi * radius * mpf(HARDNESS))


def roelands(pressure: str) -> mpf:
    """eta, Pa s, at the reference temperature."""
    log_factor = mpmath.log(mpf("0.061")) + mpf("9.67")
    exponent = mpf("2.1e-8") / (mpf("5.1e-9") * log_factor)
    return mpmath.exp(-mpf("9.67") + log_factor * (1 + mpf("5.1e-9") * mpf(pressure)) ** exponent)


def thick_shear() -> mpf:
    """Eyring's stress at 30 GPa, 0.02 m/s and a film of 0.23 um."""
    eyring = mpf("5.3e6")
    return eyring * mpmath.asinh(roelands("30e9") * mpf("0.02") / (mpf("0.23e-6") * eyring))


def exponential_curvature() -> mpf:
    """6 - 8 rho(d) + 2 rho(2 d) over d^4 at a billionth of the length, for Sq of 0.3 um."""
    length = mpf(LENGTH)
    d = length * mpf("1e-9")
    return mpf("0.3e-6") ** 2 * (6 - 8 * mpmath.exp(-d / length) + 2 * mpmath.exp(-2 * d / length)) / d**4


LUBRICATION: dict[str, Callable[[], mpf]] = {
    "film: wider along rolling": lambda: film(across="589"),
    "film: no load": lambda: 1 / (310 + mpf("9.7")),
    "film: 1e-12 N": lambda: 1 / (310 + mpf("9.7")),
    "film: 1e-12 N, limited gap": lambda: mpf("0.11e-3"),
    "film: 1e-12 N, 1e-12 m/s": lambda: film(load="1e-12", speed="1e-12"),
    "film: no piezoviscosity": isoviscous,
    "film: rigid bodies": lambda: rigid_isoviscous(load="1e-28", speed="1e-30", alpha="0"),
    "mixed: very rough": lambda: left_to_oil("40e-6")[0],
    "mixed: 1e-9 m/s": lambda: left_by_boundary("0.3e-6", speed="1e-9"),
    "mixed: friction at vanishing load": lambda: mpf(2) / 3,
    "asperity: vanishing interference": lambda: summit(mpf("1e-150"), mpf("50e-6"))[0],
    "asperity: first yield": lambda: summit(first_yield(mpf("50e-6")), mpf("50e-6"))[0],
    "asperity: full flow": lambda: summit(54 * first_yield(mpf("50e-6")), mpf("50e-6"))[0],
    "asperities: 60 deviations apart": lambda: log_over_summits(mpf(60), summits("0.3e-6")),
    "asperities: pressed flat": pressed_flat,
    "surface: exponential, tiny spacing": exponential_curvature,
    "oil: 3.1 GPa": lambda: roelands("3.1e9"),
    "oil: sliding at 1e-15 m/s": lambda: roelands("0.9e9") / mpf("0.23e-6"),
    "oil: 30 GPa": thick_shear,
    "oil: pressed solid": lambda: mpf("0.07") * mpf("7e9"),
    "oil: neither film nor sliding": lambda: mpf("0.07") * mpf("0.9e9"),
    "oiled torque: ellipse outside the film's fit": lambda: mpf(2),
}
