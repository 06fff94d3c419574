"""The splines against the quadrature that they replace, and their own inverse."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Array
from analytic.surface.asperity import asperity_contact, first_yield
from analytic.surface.asperity_table import (
    SummitNumbers,
    log_pressure_at,
    separation_of,
    summit_area,
    tabulated_asperities,
)
from analytic.surface.moments import Summits

E, H = 113.187e9, 7.8e9  # Pa
DEVIATION, MEAN = 0.8e-6, 1.3e-6  # m
ACCURACY = 1e-8  # as documented


def table(ratio: float) -> tuple[tuple[Array, SummitNumbers], Summits]:
    """Table and summits of a surface whose summits yield at w_1 = ratio standard deviations."""
    radius = ratio * DEVIATION / float(first_yield(1.0, E, H))
    summits = Summits(density=5e8, radius=radius, height_deviation=DEVIATION, mean_height=MEAN)
    return tabulated_asperities(summits=summits, modulus=E, hardness=H), summits


@pytest.mark.parametrize("ratio", [1e-4, 3e-3, 0.02, 0.26, 1.1, 10.0, 300.0])
def test_table_agrees_with_the_integrals(ratio: float) -> None:
    made, summits = table(ratio)
    near = np.random.default_rng(7).uniform(-12, 36, 3000)
    far = -(np.random.default_rng(8).uniform(1, 10, 300) ** 4)
    kinks = [edge * ratio + np.linspace(-8, 8, 301) for edge in (-1, -54)]
    h = MEAN + DEVIATION * np.concatenate([near, far, *kinks])
    h = h[(h - MEAN) / DEVIATION < 36]  # where the pressure itself is a double
    exact = asperity_contact(film_thickness=h, summits=summits, modulus=E, hardness=H)
    np.testing.assert_allclose(np.exp(log_pressure_at(*made, h)), exact.pressure, rtol=ACCURACY)
    np.testing.assert_allclose(summit_area(*made, h), exact.area_fraction, rtol=ACCURACY)


@pytest.mark.parametrize("ratio", [3e-3, 0.26, 10.0])
def test_separation_is_the_inverse_of_the_integrals(ratio: float) -> None:
    made, summits = table(ratio)
    log_pressure = np.log(np.geomspace(1e-250, 1e12, 397))
    height, slope = separation_of(*made, log_pressure)
    exact = asperity_contact(film_thickness=height, summits=summits, modulus=E, hardness=H)
    t = np.abs(height - MEAN) / DEVIATION
    # An error of 3e-8 (1 + |t|) in t is as much in ln p times its slope there, |t| + 1 at most.
    assert np.all(np.abs(np.log(exact.pressure) - log_pressure) < 3e-8 * (1 + t) ** 2)
    step = 1e-4
    beyond, before = (separation_of(*made, log_pressure + d)[0] for d in (step, -step))
    np.testing.assert_allclose(slope, (beyond - before) / (2 * step), rtol=2e-6)  # third derivatives of a spline


def test_table_extrapolates_to_the_limits() -> None:
    made, _ = table(0.26)
    t = np.array([37.0, 1e3, 1e5, 1e6])
    log_pressure = log_pressure_at(*made, MEAN + DEVIATION * t)
    # Elastic summits at a large separation: p ~ exp(-t^2/2) t^(-5/2), which underflows.
    np.testing.assert_allclose(np.diff(log_pressure + t**2 / 2 + 2.5 * np.log(t)), 0, atol=0.2)  # t^2/2 to 1e-16
    deep = log_pressure_at(*made, MEAN - DEVIATION * np.array([1e4, 3e6]))
    np.testing.assert_allclose(np.diff(deep), np.log(300), rtol=1e-4)  # plastic: proportional to the depth
    assert summit_area(*made, np.array([-1.0])) == 1


def test_table_is_cached_and_impossible_input_is_refused() -> None:
    assert table(0.26)[0] is table(0.26)[0]
    smooth = Summits(density=0.0, radius=np.inf, height_deviation=0.0, mean_height=0.0)
    with pytest.raises(InputError, match="density must be positive"):
        tabulated_asperities(summits=smooth, modulus=E, hardness=H)
    with pytest.raises(InputError, match="modulus must be positive"):
        tabulated_asperities(summits=table(0.26)[1], modulus=-E, hardness=H)


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
