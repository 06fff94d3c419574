"""The shared load against a root in 40 digits, and the digits of another program."""

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.optimize import brentq

from analytic.oil.mixed import _inverse_cubic, likely_share
from analytic.scene import AsperityLaw
from analytic.surface.asperity import separation_of
from tests.analytic.oil.mixed_contacts import ACCURACY, CONTACT, OIL, E, area, mixed, rough, summits_of
from tests.analytic.specimens import hertzian
from tests.validation.hard.lubrication_exact import film, log_over_summits, mean_gap


def test_the_next_step_is_exact_where_the_root_is_a_cubic_of_the_value() -> None:
    """x = 0.7 + 1.9 v - 0.8 v^2 + 0.3 v^3, from v = 0.41 and, before it, 0.57: the root is at 0.7."""

    def place(v: float) -> tuple[float, float]:
        return 0.7 + v * (1.9 + v * (-0.8 + v * 0.3)), 1 / (1.9 + v * (-1.6 + v * 0.9))

    (here, slope), (before, slope_before) = place(0.41), place(0.57)
    step = _inverse_cubic(0.41, slope, 0.57, slope_before, here - before)
    assert here + step == pytest.approx(0.7, rel=1e-13)  # differences of numbers near 1, over a step of 0.16


@pytest.mark.parametrize("falls", [0.2, 0.9, 3.1])
@pytest.mark.parametrize("log_pressure", [-23.0, -4.0, -0.7, 0.4, 3.0, 9.0])
def test_the_search_begins_near_the_root_of_straight_logarithms(log_pressure: float, falls: float) -> None:
    """ln s = ln p + falls ln(1 - s), of z = ln(s/(1 - s)): two steps leave less than a twentieth."""
    z = likely_share(log_pressure, falls)

    def left(z: float) -> float:
        return -np.logaddexp(0, -z) - log_pressure + falls * np.logaddexp(0, z)

    assert z == pytest.approx(brentq(left, -200.0, 200.0), abs=0.05)


def film_of(share: mpf, given: dict[str, float]) -> mpf:
    """Of the load F (1 - s) and the modulus E* (1 - s)."""
    names = {
        "along": "curvature_rolling",
        "across": "curvature_transverse",
        "load": "load",
        "modulus": "modulus",
        "speed": "entrainment_speed",
        "alpha": "pressure_viscosity",
    }
    return film(**{name: given[key] for name, key in names.items()}, borne=1 - share)


@pytest.mark.parametrize(
    ("sq", "changed"),
    [
        (0.1e-6, {}),  # a small share
        (0.016e-6, {}),  # 1e-11 or so
        (0.6e-6, {"entrainment_speed": 3e-5}),  # most of the load
        (0.3e-6, {"entrainment_speed": 1e-9, "load": 3.7}),  # all but 1e-6 of it
    ],
)
def test_the_root_of_the_printed_equations_in_40_digits(sq: float, changed: dict[str, float]) -> None:
    """The unknown is the separation of the mean planes, from which everything follows without an inverse."""
    gap, given = rough(sq), CONTACT | OIL | changed
    found = mixed(gap, **changed)
    log_pressure = np.log(found.asperity_share * given["load"] / area(given["load"]))
    start, slope = (float(part) for part in separation_of(gap.cubics, gap.truncated.summits, log_pressure))
    step = -0.1 * slope * (1 - float(found.asperity_share))  # a tenth of 1 - s
    with mpmath.workdps(40):
        nominal, summits = mpf(area(given["load"])), summits_of(sq)
        of = tuple(
            mpf(float(each))
            for each in (summits.density, summits.radius, summits.height_deviation, summits.mean_height)
        )

        def share(d: mpf) -> mpf:
            return mpmath.exp(log_over_summits((d - of[3]) / of[2], of, modulus=E)) * nominal / given["load"]

        def excess(d: mpf) -> mpf:
            return mpmath.log(mean_gap(d, mpf(gap.truncated.deviation)) / film_of(share(d), given))

        with mpmath.workdps(20):
            d = mpmath.findroot(excess, (start + step, start + step / 2), solver="secant", tol=1e-24)
        exact = share(d)
        thickness = film_of(exact, given)
        remaining = float(1 - exact)
    np.testing.assert_allclose(float(found.asperity_share), float(exact), rtol=ACCURACY)
    np.testing.assert_allclose(float(found.film_thickness), float(thickness), rtol=ACCURACY)
    # The splines' error in the gap is that of the film, which grows at least as (1 - s)^-1/2; round-off of 1 - s.
    if remaining < 0.5:
        np.testing.assert_allclose(1 - found.asperity_share, remaining, rtol=2 * ACCURACY, atol=1e-15)


RING_SPEED = np.array([0.1, 10.471976, 52.359878])  # rad/s, of the inner ring: 1, 100 and 500 rpm
# s, mean gap, separation of the mean planes, um, at each speed: by another program, which solves in the logarithm of
# s/(1 - s) with Gauss panels and in the separation with an adaptive quadrature, to 6e-12 of each other.
PRINTED: dict[tuple[AsperityLaw, float, float], list[tuple[float, ...]]] = {
    ("zhao_maietta_chang", 0.1, 20): [
        (0.34195, 0.0017031, -0.26401),
        (0.11518, 0.047774, -0.018225),
        (0.030084, 0.15699, 0.14590),
    ],
    ("zhao_maietta_chang", 0.1, 60): [
        (0.11513, 0.0016091, -0.26713),
        (0.038449, 0.047671, -0.018454),
        (0.010033, 0.15695, 0.14586),
    ],
    ("zhao_maietta_chang", 0.4, 20): [
        (0.99000, 0.012383, -0.91940),
        (0.71219, 0.052164, -0.53523),
        (0.45894, 0.15889, -0.14918),
    ],
    ("zhao_maietta_chang", 0.4, 60): [
        (0.55616, 0.0018906, -1.3186),
        (0.28720, 0.048126, -0.55946),
        (0.17307, 0.15732, -0.15314),
    ],
    ("zhao_maietta_chang", 1, 60): [
        (0.99365, 0.016123, -2.6702),
        (0.79267, 0.055483, -1.9363),
        (0.59575, 0.16090, -1.1752),
    ],
    ("zhao_maietta_chang", 1, 165): [
        (0.56677, 0.0019049, -3.7138),
        (0.33527, 0.048271, -2.0257),
        (0.23823, 0.15754, -1.1919),
    ],
    ("greenwood_williamson", 0.4, 20): [(np.nan,) * 3, (0.81461, np.nan, np.nan), (np.nan,) * 3],
    ("greenwood_williamson", 1, 60): [(np.nan,) * 3, (0.86597, np.nan, np.nan), (np.nan,) * 3],
}
Finish = tuple[float, float]  # Sq and correlation length, um
DRY: dict[Finish, tuple[float, float]] = {  # d, um, and A_a/A_H
    (0.1, 20): (-0.74484, 0.728),
    (0.1, 60): (-1.7544, 1.0),
    (0.4, 20): (-0.93274, 0.329),
    (0.4, 60): (-2.3249, 0.600),
    (1, 60): (-2.6928, 0.356),
    (1, 165): (-6.3202, 0.639),
}
AT_500: dict[Finish, float] = {  # s at 500 rad/s
    (0.1, 20): 0.0,
    (0.1, 60): 0.0,
    (0.4, 20): 0.062235,
    (1, 60): 0.24048,
    (1, 165): 0.090532,
}
BALL, INNER_GROOVE, PITCH, ANGLE = 3.97e-3, 4.13e-3, 39.01e-3, 0.18  # m, rad: the inner contact of a 6205
BALL_ON_INNER = {
    "curvature_rolling": 1 / BALL + np.cos(ANGLE) / (PITCH / 2 - BALL * np.cos(ANGLE)),
    "curvature_transverse": 1 / BALL - 1 / INNER_GROOVE,
    "load": 620.630,
    "modulus": E,
}
PER_RADIAN = 9.361428e-3  # u/w, m


@pytest.mark.parametrize(("law", "sq", "length"), PRINTED)
def test_the_values_of_another_program(law: AsperityLaw, sq: float, length: float) -> None:
    """To its five printed digits: half a unit of the last, at most 5e-5 of the number."""
    gap = rough(sq * 1e-6, length * 1e-6, law)
    given = BALL_ON_INNER | {"viscosity": 0.06, "pressure_viscosity": 2e-8}
    found = mixed(gap, **given, entrainment_speed=PER_RADIAN * RING_SPEED)
    contact, _ = hertzian(given)
    np.testing.assert_allclose(
        np.array([contact.semi_axis_rolling, contact.semi_axis_transverse]), [0.120952e-3, 1.122238e-3], rtol=5e-6
    )
    mean_pressure = contact.load / (np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse)
    table = gap.cubics, gap.truncated.summits
    separation = separation_of(*table, np.log(found.asperity_share * mean_pressure))[0]
    numbers = np.array([found.asperity_share, found.film_thickness * 1e6, separation * 1e6]).T
    printed = np.array(PRINTED[law, sq, length])
    known = np.isfinite(printed)
    np.testing.assert_allclose(numbers[known], printed[known], rtol=5e-5)
    if law == "zhao_maietta_chang":
        still = mixed(gap, **given, entrainment_speed=0.0)
        d = float(separation_of(*table, np.log(mean_pressure))[0])
        separation, touching = DRY[sq, length]
        np.testing.assert_allclose(1e6 * d, separation, rtol=5e-5)
        np.testing.assert_allclose(still.area_fraction, touching, atol=5e-4)  # three digits
    if law == "zhao_maietta_chang" and (sq, length) in AT_500:
        fast = mixed(gap, **given, entrainment_speed=PER_RADIAN * 500).asperity_share
        np.testing.assert_allclose(fast, AT_500[sq, length], rtol=5e-5, atol=1e-6)  # 0 where it is printed as 0
