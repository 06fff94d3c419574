"""Summits from spectral moments: published values, their theory, and impossible moments."""

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import erfc

from analytic.surface.moments import SpectralMoments, mccool_summits
from tests.refusals import refused, refuses

SQ, B = 0.73e-6, 41e-6  # m
GAUSSIAN = SpectralMoments(height=SQ**2, slope=2 * SQ**2 / B**2, curvature=12 * SQ**2 / B**4)


def test_published_values_of_a_gaussian_autocorrelation() -> None:
    computed = mccool_summits(GAUSSIAN)
    np.testing.assert_allclose(GAUSSIAN.bandwidth, 3, rtol=1e-14)  # round-off
    np.testing.assert_allclose(computed.density * B**2, 0.18378, atol=5e-6)  # all to the last printed digit
    np.testing.assert_allclose(computed.radius * SQ / B**2, 0.19187, atol=5e-6)
    np.testing.assert_allclose(computed.height_deviation / SQ, 0.8373, atol=5e-5)
    np.testing.assert_allclose(computed.mean_height / SQ, 1.3029, atol=5e-5)
    np.testing.assert_allclose(computed.density * computed.radius * computed.height_deviation, 0.0295, atol=5e-5)


@pytest.mark.parametrize("bandwidth", [1.7, 3.0, 9.3])
def test_nayaks_distribution_of_summit_heights(bandwidth: float) -> None:
    """Density over u = z/Sq by [Nayak1971]. Its integral of 1 shows that the formula is right; its mean and deviation
    are those of [McCool1987]."""
    c1 = bandwidth / (2 * bandwidth - 3)

    def density(u: float) -> float:
        wide = 3 * (2 * bandwidth - 3) / bandwidth**2
        beta = u * np.sqrt(3 / (2 * (2 * bandwidth - 3)))
        gamma = u * np.sqrt(bandwidth / (2 * (bandwidth - 1) * (2 * bandwidth - 3)))
        first = np.sqrt(wide) * u * np.exp(-c1 * u * u)
        second = 3 * np.sqrt(2 * np.pi) / (2 * bandwidth) * (u * u - 1) * np.exp(-u * u / 2) * erfc(-beta)
        third = np.sqrt(2 * np.pi * bandwidth / (3 * (bandwidth - 1)))
        third *= np.exp(-bandwidth * u * u / (2 * (bandwidth - 1))) * erfc(-gamma)
        return np.sqrt(3) / (2 * np.pi) * (first + second + third)

    total, mean, square = (quad(lambda u, n=n: u**n * density(u), -12, 12, limit=400)[0] for n in range(3))
    np.testing.assert_allclose(total, 1, rtol=1e-9)  # quadrature
    moments = SpectralMoments(height=SQ**2, slope=0.031, curvature=bandwidth * 0.031**2 / SQ**2)
    computed = mccool_summits(moments)
    np.testing.assert_allclose(computed.mean_height / SQ, mean, rtol=1e-9)
    # Tolerance: 0.8968 has 4 digits
    np.testing.assert_allclose(computed.height_deviation / SQ, np.sqrt(square - mean**2), rtol=1e-4)


def test_moments_of_two_surfaces_add_and_scale_with_the_heights() -> None:
    other = SpectralMoments(height=0.4e-12, slope=3e-4, curvature=7e5)
    both = GAUSSIAN + other
    np.testing.assert_allclose(both.rms_roughness, np.hypot(GAUSSIAN.rms_roughness, other.rms_roughness), rtol=1e-14)
    assert (both.slope, both.curvature) == (GAUSSIAN.slope + 3e-4, GAUSSIAN.curvature + 7e5)
    tall, plain = mccool_summits(other.scaled(2.5)), mccool_summits(other)
    np.testing.assert_allclose(tall.density, plain.density, rtol=1e-14)
    np.testing.assert_allclose(tall.radius, plain.radius / 2.5, rtol=1e-14)
    np.testing.assert_allclose(tall.height_deviation, 2.5 * plain.height_deviation, rtol=1e-14)
    np.testing.assert_allclose(tall.mean_height, 2.5 * plain.mean_height, rtol=1e-14)


def test_impossible_moments_are_refused() -> None:
    def moved(**changed: float) -> object:
        return mccool_summits(SpectralMoments(**({"height": SQ**2, "slope": 6e-4, "curvature": 2e6} | changed)))

    refuses(moved, height=-1e-12, curvature=np.nan)
    for wrong in ({"slope": 0.0}, {"slope": 1.0}, {"height": 0.0}):
        refused(lambda: moved(**wrong), "belong to no surface")  # noqa: B023
