"""Curves of the mean gap: the wanted shape everywhere, limits, units, and measured maps.

tests/validation/test_elastic_gap.py compares the stored curve with an independent code.
"""

import numpy as np
import pytest

from analytic.scene import Array, Autocorrelation
from analytic.surface.elastic_gap import (
    GapCurve,
    declared_gap_curve,
    elastic_area,
    elastic_log_gap,
    gap_between,
    measured_gap_curve,
)
from analytic.surface.heightmap import HeightMap
from analytic.surface.roughness import generated_surface, spectral_moments

GAUSSIAN = Autocorrelation(kind="gaussian", length=60e-6, spacing=2e-6)
WIDE = Autocorrelation(kind="exponential", length=50e-6, spacing=5e-6)
BETWEEN = Autocorrelation(kind="exponential", length=50e-6, spacing=3.5e-6)


def made(*, scale: float = 1.0, seed: int = 3, points: int = 128, spacing: float = 1e-6) -> HeightMap:
    kind = Autocorrelation(kind="gaussian", length=10 * spacing, spacing=spacing)
    heights = generated_surface(rms_roughness=0.2e-6, autocorrelation=kind, points=points, seed=seed).heights
    return HeightMap(heights=scale * heights, spacing=spacing)


@pytest.fixture(scope="module")
def measured() -> GapCurve:
    return measured_gap_curve(made())


@pytest.fixture(params=["gaussian", "wide", "between", "measured"])
def curve(request: pytest.FixtureRequest, measured: GapCurve) -> GapCurve:
    declared = {"gaussian": GAUSSIAN, "wide": WIDE, "between": BETWEEN}
    return measured if request.param == "measured" else declared_gap_curve(declared[request.param])


def everywhere(curve: GapCurve) -> Array:
    """200 random ln p within and near the knots, and far beyond both ends."""
    near = np.random.default_rng(11).uniform(curve.knots[0] - 3, curve.knots[-1] + 2, 200)
    return np.sort(np.concatenate([near, curve.knots, [-1e4, -2e3, -300.0, -40.0, 9.0, 150.0, 299.0, 310.0, 700.0]]))


def test_the_gap_falls_everywhere(curve: GapCurve) -> None:
    value, slope = elastic_log_gap(*curve.splines, everywhere(curve))
    assert np.isfinite(value).all()
    assert np.isfinite(slope).all()
    assert np.all(np.diff(value) < 0)
    assert np.all(slope < 0)


def test_the_slope_is_the_derivative_and_has_no_jump(curve: GapCurve) -> None:
    step = 1e-6
    at = np.concatenate([everywhere(curve)[3:-5], curve.knots])
    difference = (elastic_log_gap(*curve.splines, at + step)[0] - elastic_log_gap(*curve.splines, at - step)[0]) / (
        2 * step
    )
    np.testing.assert_allclose(
        elastic_log_gap(*curve.splines, at)[1], difference, rtol=1e-4
    )  # the second derivative times the step
    before, after = (elastic_log_gap(*curve.splines, curve.knots + side)[1] for side in (-1e-9, 1e-9))
    np.testing.assert_allclose(before, after, rtol=1e-6)


def test_the_gap_of_almost_no_pressure_is_that_of_gaussian_summits(curve: GapCurve) -> None:
    """ln p = -g^2/2 and smaller terms: g dg/d ln p tends to -1."""
    at = np.array([-1e4, -1e6])
    value, slope = elastic_log_gap(*curve.splines, at)
    smaller = np.array([0.05, 0.005])  # those terms are of the order of 1/g; the knots put 2 to 5 in place of 1
    assert np.all(np.abs(np.exp(value) / np.sqrt(-2 * at) - 1) < smaller)
    assert np.all(np.abs(np.exp(2 * value) * slope + 1) < smaller)


def test_the_area_rises_from_0_to_1(curve: GapCurve) -> None:
    at = everywhere(curve)
    area = elastic_area(*curve.splines, at)
    assert np.all(np.diff(area) >= 0)
    assert area[0] == 0
    assert area[-1] == 1
    low = np.array([-20.0, -21.0])
    np.testing.assert_allclose(np.diff(np.log(elastic_area(*curve.splines, low))), -1, rtol=1e-6)  # proportional to p


def test_twice_the_heights_have_twice_the_gap_at_twice_the_pressure() -> None:
    curve, modulus, at = declared_gap_curve(GAUSSIAN), 113e9, np.log([2e6, 3e8, 5e9])
    moments = spectral_moments(rms_roughness=0.3e-6, autocorrelation=GAUSSIAN)
    one, two = (gap_between(curve, moments=moments.scaled(factor), modulus=modulus) for factor in (1, 2))
    np.testing.assert_allclose(
        elastic_log_gap(*two, at + np.log(2))[0], elastic_log_gap(*one, at)[0] + np.log(2), rtol=1e-12
    )
    np.testing.assert_allclose(elastic_area(*two, at + np.log(2)), elastic_area(*one, at), rtol=1e-12)
    # p/(E* slope) = 0.1 at slope = 2 sigma/B; 0.643 sigma is published, 3 % its uncertainty (test of the table)
    (value,), _ = elastic_log_gap(*one, np.log([0.1 * modulus * 2 * 0.3 / 60]))
    assert np.exp(value) == pytest.approx(0.643 * 0.3e-6, rel=0.03)


def test_a_large_map_is_cut_to_its_middle_and_tilt_does_not_matter() -> None:
    large = made(points=300, seed=8)
    tilted = large.heights + np.linspace(0, 4e-6, 300)
    rim = np.pad(np.zeros((256, 256)), 22, constant_values=1e-3)
    changed = measured_gap_curve(HeightMap(heights=tilted + rim, spacing=1.0))
    np.testing.assert_allclose(changed.gaps, measured_gap_curve(large).gaps, atol=1e-6)  # round-off, amplified
