"""The splines against the quadrature they stand for, and their own inverse."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.surface.asperity import asperity_contact, first_yield, separation_at
from analytic.surface.asperity_table import AsperityTable, tabulated_asperities
from analytic.surface.moments import Summits

E, H = 113.187e9, 7.8e9  # Pa
DEVIATION, MEAN = 0.8e-6, 1.3e-6  # m
ACCURACY = 1e-8  # claimed


def table(ratio: float) -> tuple[AsperityTable, Summits]:
    """Of a surface whose summits yield at this many standard deviations."""
    radius = ratio * DEVIATION / float(first_yield(1.0, E, H))
    summits = Summits(density=5e8, radius=radius, height_deviation=DEVIATION, mean_height=MEAN)
    return tabulated_asperities(summits=summits, modulus=E, hardness=H), summits


@pytest.mark.parametrize("ratio", [1e-4, 3e-3, 0.02, 0.26, 1.1, 10.0, 300.0])
def test_it_is_the_rough_contact(ratio: float) -> None:
    made, summits = table(ratio)
    near = np.random.default_rng(7).uniform(-12, 36, 3000)
    far = -(np.random.default_rng(8).uniform(1, 10, 300) ** 4)
    kinks = [edge * ratio + np.linspace(-8, 8, 301) for edge in (-1, -54)]
    h = MEAN + DEVIATION * np.concatenate([near, far, *kinks])
    h = h[(h - MEAN) / DEVIATION < 36]  # where the pressure itself is a double
    exact = asperity_contact(film_thickness=h, summits=summits, modulus=E, hardness=H)
    np.testing.assert_allclose(np.exp(made.log_pressure(h)), exact.pressure, rtol=ACCURACY)
    np.testing.assert_allclose(made.area_fraction(h), exact.area_fraction, rtol=ACCURACY)


@pytest.mark.parametrize("ratio", [3e-3, 0.26, 10.0])
def test_the_separation_is_its_inverse(ratio: float) -> None:
    made, summits = table(ratio)
    pressure = np.geomspace(1e-250, 1e12, 397)
    found, slope = made.separation(np.log(pressure))
    exact = separation_at(pressure=pressure, summits=summits, modulus=E, hardness=H)
    t = (exact - MEAN) / DEVIATION
    assert np.all(np.abs(found - exact) < 3e-8 * DEVIATION * (1 + np.abs(t)))  # separation_at: 1e-8 of a deviation
    step = 1e-4
    beyond, before = (made.separation(np.log(pressure) + d)[0] for d in (step, -step))
    np.testing.assert_allclose(slope, (beyond - before) / (2 * step), rtol=2e-6)  # third derivatives of a spline


def test_beyond_the_table_it_goes_on() -> None:
    made, _ = table(0.26)
    t = np.array([37.0, 1e3, 1e5, 1e6])
    log_pressure = made.log_pressure(MEAN + DEVIATION * t)
    # Elastic summits far off: p ~ exp(-t^2/2) t^(-5/2), which no double holds.
    np.testing.assert_allclose(np.diff(log_pressure + t**2 / 2 + 2.5 * np.log(t)), 0, atol=0.2)  # t^2/2 to 1e-16
    deep = made.log_pressure(MEAN - DEVIATION * np.array([1e4, 3e6]))
    np.testing.assert_allclose(np.diff(deep), np.log(300), rtol=1e-4)  # plastic: as the depth
    assert made.area_fraction(np.array([-1.0])) == 1


def test_it_is_made_once_and_refuses_what_has_no_table() -> None:
    assert table(0.26)[0] is table(0.26)[0]
    smooth = Summits(density=0.0, radius=np.inf, height_deviation=0.0, mean_height=0.0)
    with pytest.raises(InputError, match="density must be positive"):
        tabulated_asperities(summits=smooth, modulus=E, hardness=H)
    with pytest.raises(InputError, match="modulus must be positive"):
        tabulated_asperities(summits=table(0.26)[1], modulus=-E, hardness=H)


def test_a_surface_that_is_all_but_smooth_is_refused() -> None:
    """Sq of 6e-15 m on waves of 20 um: loads beyond the smallest double. What the fuzzing of scene files found."""
    nearly = Summits(density=1.5e9, radius=9.2e3, height_deviation=7e-15, mean_height=5e-15)
    with pytest.raises(InputError, match="all but flat"):
        tabulated_asperities(summits=nearly, modulus=1.13e11, hardness=7.8e9)
