"""The shared load against a root in 40 digits, and the digits of another program."""

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from analytic.scene import AsperityLaw
from analytic.surface.asperity_table import separation_of
from tests.analytic.oil.mixed_contacts import ACCURACY, CONTACT, OIL, E, area, mixed, rough, summits_of
from tests.validation.hard.lubrication_exact import film, log_over_summits, mean_gap


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
# s and mean gap, um, at each speed: by another program, which solves in the logarithm of s/(1 - s) with Gauss panels
# and in the separation with an adaptive quadrature, to 6e-12 of each other.
PRINTED: dict[tuple[AsperityLaw, float, float], list[tuple[float, float]]] = {
    ("zhao_maietta_chang", 0.1, 20): [(0.34195, 0.0017031), (0.11518, 0.047774), (0.030084, 0.15699)],
    ("zhao_maietta_chang", 0.4, 60): [(0.55616, 0.0018906), (0.28720, 0.048126), (0.17307, 0.15732)],
    ("zhao_maietta_chang", 1, 165): [(0.56677, 0.0019049), (0.33527, 0.048271), (0.23823, 0.15754)],
    ("greenwood_williamson", 0.4, 20): [(np.nan, np.nan), (0.81461, np.nan), (np.nan, np.nan)],
}
DRY = {(0.1, 20): 0.728, (0.4, 60): 0.600, (1, 165): 0.639}  # A_a/A_H at rest, by Sq and correlation length, um
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
    numbers = np.array([found.asperity_share, found.film_thickness * 1e6]).T
    printed = np.array(PRINTED[law, sq, length])
    known = np.isfinite(printed)
    np.testing.assert_allclose(numbers[known], printed[known], rtol=5e-5)
    if law == "zhao_maietta_chang":
        still = mixed(gap, **given, entrainment_speed=0.0)
        np.testing.assert_allclose(still.area_fraction, DRY[sq, length], atol=5e-4)  # three digits
