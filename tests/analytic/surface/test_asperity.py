"""Pressed summits: the splines against the defining integrals in 40 digits, their limits, and their inverse."""

import mpmath
import numpy as np
import pytest
from mpmath import mpf
from scipy.special import erfc, pbdv

from analytic.errors import InputError
from analytic.scene import Array, Material, Surface
from analytic.surface.asperity import (
    SummitNumbers,
    first_yield,
    log_pressure_at,
    separation_of,
    softer_hardness,
    summit_area,
    summit_integrals,
    tabulated_asperities,
)
from analytic.surface.moments import Summits
from tests.validation.hard.lubrication_exact import log_over_summits

E, H = 113.187e9, 7.8e9  # Pa
DENSITY, RADIUS, DEVIATION, MEAN = 5e8, 50e-6, 0.8e-6, 1.3e-6  # 1/m^2, m
ACCURACY = 1e-8  # as documented
ANY = Summits(density=DENSITY, radius=RADIUS, height_deviation=DEVIATION, mean_height=MEAN)


def table(ratio: float) -> tuple[tuple[Array, SummitNumbers], Summits]:
    """Table and summits of a surface whose summits yield at w_1 = ratio standard deviations."""
    radius = ratio * DEVIATION / float(first_yield(1.0, E, H))
    summits = Summits(density=DENSITY, radius=radius, height_deviation=DEVIATION, mean_height=MEAN)
    return tabulated_asperities(summits=summits, modulus=E, hardness=H), summits


# Each ratio at three separations, and each separation at two or three ratios
@pytest.mark.parametrize(
    ("ratio", "t"),
    [
        *((ratio, t) for ratio in (1e-4, 0.26, 40.0) for t in (-7.0, 0.0, 6.1)),
        *((ratio, t) for ratio in (0.02, 3.1) for t in (-5.9, 1.7, 24.0)),
        *((1e5, t) for t in (-2.3, 1.7, 24.0)),
    ],
)
def test_pressure_and_area_in_40_digits(ratio: float, t: float) -> None:
    """From plastic to elastic, from flattened to a separation of 24 standard deviations with a pressure of 1e-130."""
    made, summits = table(ratio)
    with mpmath.workdps(40):
        of = mpf(DENSITY), mpf(float(summits.radius)), mpf(DEVIATION), mpf(MEAN)
        height = MEAN + t * DEVIATION
        at = (mpf(height) - of[3]) / of[2]
        pressure, area = (float(log_over_summits(at, of, area=area, modulus=E)) for area in (False, True))
    np.testing.assert_allclose(log_pressure_at(*made, height), pressure, atol=ACCURACY)
    np.testing.assert_allclose(summit_area(*made, height), min(np.exp(area), 1.0), rtol=ACCURACY)


@pytest.mark.parametrize("ratio", [1e-4, 3e-3, 0.02, 0.26, 1.1, 10.0, 300.0])
def test_the_splines_agree_with_the_integrals_everywhere(ratio: float) -> None:
    made, summits = table(ratio)
    near = np.random.default_rng(7).uniform(-12, 36, 3000)
    far = -(np.random.default_rng(8).uniform(1, 10, 300) ** 4)
    kinks = [edge * ratio + np.linspace(-8, 8, 301) for edge in (-1, -54)]
    t = np.concatenate([near, far, *kinks])
    load, area = summit_integrals(t, np.full_like(t, ratio))
    scale = np.log(np.pi * summits.radius * DENSITY * DEVIATION) - np.maximum(t, 0.0) ** 2 / 2
    height = MEAN + DEVIATION * t
    np.testing.assert_allclose(log_pressure_at(*made, height), np.log(H * load) + scale, atol=ACCURACY)
    np.testing.assert_allclose(summit_area(*made, height), np.minimum(np.exp(scale) * area, 1.0), rtol=ACCURACY)


@pytest.mark.parametrize("t", [-3.1, -0.4, 0.0, 0.9, 3.3])
def test_hard_summits_have_the_elastic_limit(t: float) -> None:
    """p = (4/3) density E* sqrt(R_a sigma^3) F_{3/2}(t) of [Greenwood1966], F by a parabolic cylinder function."""
    made = tabulated_asperities(summits=ANY, modulus=E, hardness=50 * H)  # no summit is 600 deviations high
    f32 = 3 * np.sqrt(np.pi) / 4 / np.sqrt(2 * np.pi) * np.exp(-(t**2) / 4) * pbdv(-2.5, t)[0]
    expected = 4 / 3 * DENSITY * E * np.sqrt(RADIUS * DEVIATION**3) * f32
    np.testing.assert_allclose(log_pressure_at(*made, MEAN + t * DEVIATION), np.log(expected), atol=ACCURACY)
    f1 = np.exp(-(t**2) / 2) / np.sqrt(2 * np.pi) - t * erfc(t / np.sqrt(2)) / 2
    area = np.pi * DENSITY * RADIUS * DEVIATION * f1
    np.testing.assert_allclose(summit_area(*made, MEAN + t * DEVIATION), area, rtol=ACCURACY)


@pytest.mark.parametrize("t", [-3.1, 0.0, 3.3])
def test_soft_summits_carry_their_hardness(t: float) -> None:
    made = tabulated_asperities(summits=ANY, modulus=E, hardness=1e-4 * H)
    f1 = np.exp(-(t**2) / 2) / np.sqrt(2 * np.pi) - t * erfc(t / np.sqrt(2)) / 2
    area = 2 * np.pi * DENSITY * RADIUS * DEVIATION * f1
    np.testing.assert_allclose(summit_area(*made, MEAN + t * DEVIATION), area, rtol=2e-6)  # w_1 is 3e-9 deviations
    np.testing.assert_allclose(np.exp(log_pressure_at(*made, MEAN + t * DEVIATION)), 1e-4 * H * area, rtol=2e-6)


@pytest.mark.parametrize("ratio", [3e-3, 0.26, 10.0])
def test_the_separation_is_the_inverse_of_the_pressure(ratio: float) -> None:
    made, _ = table(ratio)
    log_pressure = np.log(np.geomspace(1e-250, 1e12, 397))
    height, slope = separation_of(*made, log_pressure)
    t = np.abs(height - MEAN) / DEVIATION
    # An error of 3e-8 (1 + |t|) in t is as much in ln p times its slope there, |t| + 1 at most.
    assert np.all(np.abs(log_pressure_at(*made, height) - log_pressure) < 3e-8 * (1 + t) ** 2)
    step = 1e-4
    beyond, before = (separation_of(*made, log_pressure + d)[0] for d in (step, -step))
    np.testing.assert_allclose(slope, (beyond - before) / (2 * step), rtol=2e-6)  # third derivatives of a spline


def test_the_table_extrapolates_to_the_limits() -> None:
    made, _ = table(0.26)
    t = np.array([37.0, 1e3, 1e5, 1e6])
    log_pressure = log_pressure_at(*made, MEAN + DEVIATION * t)
    # Elastic summits at a large separation: p ~ exp(-t^2/2) t^(-5/2), which underflows.
    np.testing.assert_allclose(np.diff(log_pressure + t**2 / 2 + 2.5 * np.log(t)), 0, atol=0.2)  # t^2/2 to 1e-16
    deep = log_pressure_at(*made, MEAN - DEVIATION * np.array([1e4, 3e6]))
    np.testing.assert_allclose(np.diff(deep), np.log(300), rtol=1e-4)  # plastic: proportional to the depth
    assert summit_area(*made, np.array([-1.0])) == 1


def test_a_table_is_made_once_and_impossible_input_is_refused() -> None:
    assert table(0.26)[0] is table(0.26)[0]
    smooth = Summits(density=0.0, radius=np.inf, height_deviation=0.0, mean_height=0.0)
    for summits, changed, words in (
        (smooth, {}, "density must be positive"),
        (ANY, {"modulus": -E}, "modulus must be positive"),
        (ANY, {"hardness": np.inf}, "hardness must be positive"),
    ):
        with pytest.raises(InputError, match=words):
            tabulated_asperities(summits=summits, **{"modulus": E, "hardness": H} | changed)


MODULUS, SOFT = 1.1318681318681319e11, 7.8e9  # of steel, Pa


@pytest.mark.parametrize(
    ("radius", "deviation"), [(9.2e3, 7e-15), (27526.73107586247, 1.3131765488081737e-13), (9.2e3, 3e-308)]
)
def test_a_nearly_smooth_surface_is_refused(radius: float, deviation: float) -> None:
    """They yield at 6e15, 9e14 and infinitely many deviations; numbers that large are a deviation or more apart."""
    nearly = Summits(density=1.5e9, radius=radius, height_deviation=deviation, mean_height=5e-15)
    with pytest.raises(InputError, match="all but flat"):
        tabulated_asperities(summits=nearly, modulus=MODULUS, hardness=SOFT)


@pytest.mark.parametrize("deviation", [4e-11, 7e-11, 2e-9])  # w_1 is 3e12, 2e12 and 6e10 deviations
def test_a_surface_that_is_flat_to_the_limit_has_a_falling_pressure(deviation: float) -> None:
    """A smaller film thickness has a higher pressure, also where w_1 is so many deviations."""
    summits = Summits(density=1.5e9, radius=27526.7, height_deviation=deviation, mean_height=5e-15)
    made = tabulated_asperities(summits=summits, modulus=MODULUS, hardness=SOFT)
    height = summits.mean_height + deviation * np.sinh(np.linspace(-30.0, 15.9, 1000))
    assert np.all(np.diff(log_pressure_at(*made, height)) < 0)


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
