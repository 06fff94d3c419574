"""Rough contact against its defining integrals in 40 digits, and Greenwood and Williamson's limit."""

from functools import cache

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.special import erfc, pbdv

from analytic.errors import InputError
from analytic.scene import Material, Surface
from analytic.surface.asperity import AsperityContact, asperity_contact, asperity_load, softer_hardness
from analytic.surface.moments import Summits
from tests.validation.hard.lubrication_exact import log_over_summits, summit

SUMMITS = Summits(density=5e8, radius=50e-6, height_deviation=0.8e-6, mean_height=1.3e-6)
E, H = 113.187e9, 7.8e9  # Pa
ACCURACY = 1e-8  # as documented
ROUND_OFF = 1e-13


def contact(h: object, summits: Summits = SUMMITS, **changed: object) -> AsperityContact:
    arguments = {"modulus": E, "hardness": H} | changed
    return asperity_contact(film_thickness=h, summits=summits, **arguments)  # pyright: ignore[reportArgumentType]


def with_yield_at(ratio: float) -> Summits:
    """SUMMITS with the tip radius for which w_1 = ratio standard deviations."""
    first_yield = (3 * np.pi * 0.4 * H / (4 * E)) ** 2
    return Summits(
        density=5e8, radius=ratio * SUMMITS.height_deviation / first_yield, height_deviation=0.8e-6, mean_height=1.3e-6
    )


@cache
def reference(h: float, radius: float) -> tuple[float, float]:
    """Nominal pressure and area fraction by quadrature in 40 digits over the heights of the summits."""
    with mpmath.workdps(40):
        of = (mpf(SUMMITS.density), mpf(radius), mpf(SUMMITS.height_deviation), mpf(SUMMITS.mean_height))
        t = (mpf(h) - of[3]) / of[2]
        pressure, area = (mpmath.exp(log_over_summits(t, of, area=area, modulus=E)) for area in (False, True))
        return float(pressure), float(area)


# Each ratio at three separations, and each separation at two or three ratios
@pytest.mark.parametrize(
    ("ratio", "t"),
    [
        *((ratio, t) for ratio in (1e-4, 0.26, 40.0) for t in (-7.0, 0.0, 6.1)),
        *((ratio, t) for ratio in (0.02, 3.1) for t in (-5.9, 1.7, 24.0)),
        *((1e5, t) for t in (-2.3, 1.7, 24.0)),
    ],
)
def test_the_integrals_in_40_digits(ratio: float, t: float) -> None:
    """From plastic to elastic, from flattened to a separation of 24 standard deviations with a pressure of 1e-130."""
    summits, h = with_yield_at(ratio), 1.3e-6 + t * 0.8e-6
    pressure, area = reference(h, float(summits.radius))
    computed = contact(h, summits)
    np.testing.assert_allclose(computed.pressure, pressure, rtol=ACCURACY)
    np.testing.assert_allclose(computed.area_fraction, min(area, 1.0), rtol=ACCURACY)


@pytest.mark.parametrize("t", [-3.1, -0.4, 0.0, 0.9, 3.3])
def test_hard_summits_have_the_elastic_limit(t: float) -> None:
    """p = (4/3) density E* sqrt(R_a sigma^3) F_{3/2}(t) of [Greenwood1966], F by a parabolic cylinder function."""
    computed = contact(1.3e-6 + t * 0.8e-6, hardness=1e6 * H)
    f32 = 3 * np.sqrt(np.pi) / 4 / np.sqrt(2 * np.pi) * np.exp(-(t**2) / 4) * pbdv(-2.5, t)[0]
    s = SUMMITS
    expected = 4 / 3 * s.density * E * np.sqrt(s.radius * s.height_deviation**3) * f32
    np.testing.assert_allclose(computed.pressure, expected, rtol=ACCURACY)
    f1 = np.exp(-(t**2) / 2) / np.sqrt(2 * np.pi) - t * erfc(t / np.sqrt(2)) / 2
    np.testing.assert_allclose(
        computed.area_fraction, np.pi * s.density * s.radius * s.height_deviation * f1, rtol=ACCURACY
    )


def test_one_summit_follows_the_printed_formulas_without_jumps() -> None:
    radius = 37e-6
    first = (3 * np.pi * 0.4 * H / (4 * E)) ** 2 * radius
    depths = first * np.array([1e-30, 0.3, 0.9999, 1.0, 1.0001, 7.0, 53.99, 54.0, 54.01, 1e6])
    computed = asperity_load(interference=depths, tip_radius=radius, modulus=E, hardness=H)
    with mpmath.workdps(40):
        expected = np.array([[float(x) for x in summit(mpf(w), mpf(radius), E)] for w in depths])
    np.testing.assert_allclose(computed.load, expected[:, 0], rtol=1e-12)  # round-off of w - w_1 relative to w_1
    np.testing.assert_allclose(computed.area, expected[:, 1], rtol=1e-12)
    for edge in (first, 54 * first):
        around = asperity_load(
            interference=edge * np.array([1 - 1e-9, 1 + 1e-9]), tip_radius=radius, modulus=E, hardness=H
        )
        np.testing.assert_allclose(around.load[0], around.load[1], rtol=5e-9)  # slopes of 1 to 2 per step
        np.testing.assert_allclose(around.area[0], around.area[1], rtol=5e-9)
    free = asperity_load(interference=np.array([-1e-6, 0.0]), tip_radius=radius, modulus=E, hardness=H)
    assert not free.load.any()
    assert not free.area.any()
    hertz = asperity_load(interference=0.4 * first, tip_radius=radius, modulus=E, hardness=H)
    a = np.sqrt(radius * 0.4 * first)  # Hertz: p0 = 2 E* a/(pi R), mean 2/3 of it
    np.testing.assert_allclose(hertz.load, 2 / 3 * 2 * E * a / (np.pi * radius) * np.pi * a**2, rtol=ROUND_OFF)


@pytest.mark.parametrize("h", [-5e-6, 0.2e-6, 1.9e-6, 6.0e-6])
@pytest.mark.parametrize("ratio", [0.02, 0.26, 40.0])
def test_the_slope_is_the_derivative(h: float, ratio: float) -> None:
    summits, step = with_yield_at(ratio), 1e-10
    beyond, before = contact(h + step, summits).pressure, contact(h - step, summits).pressure
    # A difference of values good to 1e-8 over 2.5e-4 standard deviations; their errors move together.
    np.testing.assert_allclose(contact(h, summits).pressure_slope, (beyond - before) / (2 * step), rtol=1e-5)


def test_a_smooth_surface_is_a_wall() -> None:
    smooth = Summits(density=0.0, radius=np.inf, height_deviation=0.0, mean_height=0.0)
    computed = contact(np.array([-1e-9, 0.0, 1e-12, 3e-6]), smooth)
    np.testing.assert_array_equal(computed.pressure, [np.inf, np.inf, 0, 0])
    np.testing.assert_array_equal(computed.area_fraction, [1, 1, 0, 0])
    np.testing.assert_array_equal(computed.pressure_slope, 0)
    no_summits = Summits(density=0.0, radius=np.inf, height_deviation=0.3e-6, mean_height=0.0)
    np.testing.assert_array_equal(contact(np.array([-1e-9, 2e-7]), no_summits).pressure[1:], 0)
    # A thousandth of the roughness is near this limit.
    almost = Summits(density=5e8, radius=50e-3, height_deviation=0.8e-9, mean_height=1.3e-9)
    assert contact(0.1e-6, almost).pressure == 0


def test_the_softer_body_yields() -> None:
    def body(name: str, hardness: float | None) -> Material:
        return Material(
            name=name, youngs_modulus=2e11, poisson_ratio=0.3, density=7.8e3, source="test", hardness=hardness
        )

    hard, soft, unknown = body("nitride", 15e9), body("steel", 7.8e9), body("peek", None)
    assert softer_hardness(Surface(), hard, soft) == softer_hardness(Surface(), soft, hard) == 7.8e9
    assert softer_hardness(Surface(hardness=6.1e9), hard, unknown) == 6.1e9
    with pytest.raises(InputError, match=r"surface.hardness is missing, and peek has none"):
        softer_hardness(Surface(), hard, unknown)
    with pytest.raises(InputError, match=r"surface.hardness must be positive"):
        softer_hardness(Surface(hardness=-6e9), hard, soft)
