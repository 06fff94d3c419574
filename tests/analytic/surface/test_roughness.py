"""Declared surfaces against derivatives of their autocorrelation; generated ones against both, over many seeds."""

import re
from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Autocorrelation, HeightMapFile, Surface
from analytic.surface.moments import mccool_summits
from analytic.surface.roughness import autocorrelation_at, gap_roughness, generated_surface, spectral_moments
from tests.analytic.surface.map_files import formless
from tests.refusals import refused

SQ = 0.37e-6  # m
SMOOTH = Autocorrelation(kind="gaussian", length=21e-6, spacing=2.1e-6)
FRACTAL = Autocorrelation(kind="exponential", length=21e-6, spacing=2.1e-6)
POINTS, SEEDS = 240, range(24)
SIGMAS = 4.0  # of the mean over the fixed seeds: a correct formula is outside with a probability of 1 in 16 000


@pytest.fixture(scope="module")
def smooth_maps() -> list[np.ndarray]:
    return [made(SMOOTH, seed) for seed in SEEDS]


def made(autocorrelation: Autocorrelation, seed: int) -> np.ndarray:
    return generated_surface(rms_roughness=SQ, autocorrelation=autocorrelation, points=POINTS, seed=seed).heights


def assert_mean(values: list[float], expected: float, systematic: float = 0.0, unit: float | None = None) -> None:
    """The mean is as expected within its standard error and a systematic error relative to the unit."""
    unit = abs(expected) if unit is None else unit
    mean, error = np.mean(values), np.std(values, ddof=1) / np.sqrt(len(values))
    assert abs(mean - expected) <= SIGMAS * error + systematic * unit, (mean, expected, error)
    assert error < 0.03 * unit, "else the test cannot fail"


def lagged(rows: int, columns: int, autocorrelation: Autocorrelation = SMOOTH) -> float:
    distance = np.array(np.hypot(rows, columns) * autocorrelation.spacing)
    return float(autocorrelation_at(distance, autocorrelation))


def test_gaussian_moments_are_the_derivatives_of_the_autocorrelation() -> None:
    """m_2 = -rho''(0), m_4 = rho''''(0), with 40 digits."""
    with mpmath.workdps(40):
        rho = lambda r: mpmath.exp(-((r / mpmath.mpf(SMOOTH.length)) ** 2))  # noqa: E731
        second = mpmath.diff(rho, 0, 2, h=mpmath.mpf("1e-12"))
        fourth = mpmath.diff(rho, 0, 4, h=mpmath.mpf("1e-12"))
    computed = spectral_moments(rms_roughness=SQ, autocorrelation=SMOOTH)
    np.testing.assert_allclose(computed.height, SQ**2, rtol=1e-14)
    np.testing.assert_allclose(computed.slope, -(SQ**2) * float(second), rtol=1e-10)  # the difference quotient's
    np.testing.assert_allclose(computed.curvature, SQ**2 * float(fourth), rtol=1e-10)


@pytest.mark.parametrize("spacing", [21e-6 * 1e-9, 0.3e-6, 2.1e-6, 35e-6])
def test_exponential_moments_are_differences_at_the_spacing(spacing: float) -> None:
    """E[(z1 - z0)^2] and E[(z2 - 2 z1 + z0)^2] from the covariances, in 40 digits."""
    computed = spectral_moments(
        rms_roughness=SQ, autocorrelation=Autocorrelation(kind="exponential", length=21e-6, spacing=spacing)
    )
    with mpmath.workdps(40):
        d = mpmath.mpf(spacing)
        one, two = mpmath.exp(-d / mpmath.mpf(21e-6)), mpmath.exp(-2 * d / mpmath.mpf(21e-6))
        slope, curvature = (2 - 2 * one) / d**2, (6 - 8 * one + 2 * two) / d**4
    np.testing.assert_allclose(computed.slope, SQ**2 * float(slope), rtol=1e-13)  # round-off
    np.testing.assert_allclose(computed.curvature, SQ**2 * float(curvature), rtol=1e-13)


def test_a_generated_surface_has_the_declared_autocorrelation(smooth_maps: list[np.ndarray]) -> None:
    """At lags of equal length along x, y and oblique, as it is isotropic; with np.roll, as the surface is periodic."""
    area = (POINTS * SMOOTH.spacing) ** 2
    offset = np.pi * SMOOTH.length**2 / area
    for rows, columns in ((0, 5), (5, 0), (3, 4), (4, -3), (0, 10), (6, -8)):
        products = [float(np.mean(z * np.roll(z, (rows, columns), (0, 1)))) for z in smooth_maps]
        assert_mean(products, SQ**2 * (lagged(rows, columns) - offset), unit=SQ**2)
    exponential = [made(FRACTAL, seed) for seed in SEEDS]
    offset = 2 * np.pi * FRACTAL.length**2 / area
    for rows, columns in ((0, 1), (1, 0), (3, 4), (0, 5)):
        products = [float(np.mean(z * np.roll(z, (rows, columns), (0, 1)))) for z in exponential]
        # 3e-3: hardly any part of the spectrum is cut off, as the correlation at half of the period is nearly 0.
        assert_mean(products, SQ**2 * (lagged(rows, columns, FRACTAL) - offset), systematic=3e-3, unit=SQ**2)


def test_heights_are_gaussian_and_follow_the_seed(smooth_maps: list[np.ndarray]) -> None:
    assert_mean([float(np.mean(z**4) / np.mean(z**2) ** 2) for z in smooth_maps], 3.0, systematic=0.02)  # 130 lengths^2
    skewness = [float(np.mean(z**3)) / SQ**3 for z in smooth_maps]
    assert abs(np.mean(skewness)) < SIGMAS * np.std(skewness) / np.sqrt(len(skewness))
    np.testing.assert_array_equal(made(SMOOTH, 7), smooth_maps[7])
    assert max(abs(z.mean()) for z in smooth_maps) < 1e-12 * SQ  # relative to the mean of the surface
    assert np.abs(np.mean(smooth_maps[3] * smooth_maps[4])) < 0.2 * SQ**2
    flat = generated_surface(rms_roughness=0.0, autocorrelation=SMOOTH, points=POINTS, seed=5)
    assert not flat.heights.any()


def test_both_surfaces_of_a_scene() -> None:
    """Moments add up; a ball with another roughness has the same autocorrelation."""
    alone = spectral_moments(rms_roughness=SQ, autocorrelation=SMOOTH)
    both = gap_roughness(Surface(rms_roughness=SQ, autocorrelation=SMOOTH))
    np.testing.assert_allclose(both.rms_roughness, np.sqrt(2) * SQ, rtol=1e-14)
    np.testing.assert_allclose(both.summits.radius, float(mccool_summits(alone).radius) / np.sqrt(2), rtol=1e-14)
    assert both.warnings == ()
    finer = gap_roughness(Surface(rms_roughness=SQ, autocorrelation=SMOOTH, ball_rms_roughness=0.2 * SQ))
    np.testing.assert_allclose(finer.rms_roughness, np.sqrt(1.04) * SQ, rtol=1e-14)
    np.testing.assert_allclose(finer.ball.slope, 0.04 * finer.race.slope, rtol=1e-14)
    smooth = gap_roughness(Surface(rms_roughness=0.0, autocorrelation=SMOOTH))
    assert (smooth.rms_roughness, smooth.summits.density) == (0, 0)
    one = gap_roughness(Surface(rms_roughness=0.0, autocorrelation=SMOOTH, ball_rms_roughness=SQ))
    np.testing.assert_allclose(one.rms_roughness, SQ, rtol=1e-14)


def test_a_scene_with_a_height_map(tmp_path: Path) -> None:
    heights = made(SMOOTH, 11)
    np.save(tmp_path / "race.npy", heights)
    given = HeightMapFile(path=str(tmp_path / "race.npy"), spacing=SMOOTH.spacing)
    computed = gap_roughness(Surface(height_map=given, ball_rms_roughness=0.1e-6))
    straight = formless(heights)
    np.testing.assert_allclose(computed.race.rms_roughness, straight.std(), rtol=1e-12)  # round-off
    np.testing.assert_allclose(computed.ball.rms_roughness, 0.1e-6, rtol=1e-13)
    np.testing.assert_allclose(computed.ball.bandwidth, computed.race.bandwidth, rtol=1e-12)
    np.save(tmp_path / "tilted.npy", 3e-7 * np.arange(60) + 2e-7 * np.arange(50)[:, None] + 4e-6)
    tilted = HeightMapFile(path=str(tmp_path / "tilted.npy"), spacing=1e-6)
    words = "surface.height_map: ", "tilted.npy: heights have Sq 0 nm without plane and form, less than 1 nm"
    refused(lambda: gap_roughness(Surface(height_map=tilted)), *words)
    refused(lambda: gap_roughness(Surface(rms_roughness=SQ)), "surface needs rms_roughness and autocorrelation")


def test_dependence_on_the_spacing_gives_warnings() -> None:
    near, wide, coarse = (
        gap_roughness(Surface(rms_roughness=SQ, autocorrelation=replace(kind, spacing=spacing)))
        for kind, spacing in ((FRACTAL, 2.1e-6), (FRACTAL, 3e-6), (SMOOTH, 3e-6))
    )
    for found, words in (
        (near, "depend on .*2.1 um"),
        (wide, "depend on .*3 um"),
        (coarse, "a tenth of the length 21 um .*ignored"),
    ):
        (warning,) = found.warnings
        assert re.search(words, warning)
    assert near.race.slope != wide.race.slope
    assert coarse.race.slope == pytest.approx(2 * SQ**2 / 21e-6**2, rel=1e-12)  # as at any spacing


def test_a_surface_too_steep_for_shallow_asperities_is_refused() -> None:
    """Ball and race together have the mean square slope 4 Sq^2/B^2, 1 at Sq = B/2."""
    assert gap_roughness(Surface(rms_roughness=10.4e-6, autocorrelation=SMOOTH)).rms_roughness > 0
    message = r"surface\.rms_roughness = 10\.6 um.*rms slope of 1\.01.*at most 10\.5 um.*longer"
    with pytest.raises(InputError, match=message):
        gap_roughness(Surface(rms_roughness=10.6e-6, autocorrelation=SMOOTH))
