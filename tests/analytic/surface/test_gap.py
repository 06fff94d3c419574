"""The mean gap of truncated surfaces, its integral in 60 digits and its limits; and which curve a surface has."""

from dataclasses import replace

import mpmath
import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.stats import norm

from analytic.numerics.normal_distribution import FAR
from analytic.scene import Autocorrelation, Surface
from analytic.surface.asperity import log_pressure_at
from analytic.surface.elastic_gap import declared_gap_curve, elastic_log_gap, gap_between, measured_gap_curve
from analytic.surface.gap import SMOOTH_GAP, GapNumbers, gap_law, log_gap_of
from analytic.surface.moments import SpectralMoments, mccool_summits
from analytic.surface.roughness import GapRoughness, gap_roughness, generated_surface, spectral_moments
from analytic.surface.truncated_gap import log_mean_gap
from tests.analytic.specimens import FINISH
from tests.contacts import STEEL

E = 113.187e9  # Pa
FINISHED = replace(FINISH, gap="truncated")


def exact(x: float) -> tuple[float, float]:
    """ln[phi(x) + x Phi(x)], and its derivative Phi over that; 60 digits, of which the sum cancels 12 at x = -1e6."""
    with mpmath.workdps(60):
        at = mpmath.mpf(x)
        below = mpmath.erfc(-at / mpmath.sqrt(2)) / 2
        gap = mpmath.exp(-(at**2) / 2) / mpmath.sqrt(2 * mpmath.pi) + at * below
        return float(mpmath.log(gap)), float(below / gap)


def law(surface: Surface = FINISHED) -> GapNumbers:
    return gap_law(surface, gap_roughness(surface), modulus=E, bodies=(STEEL, STEEL))


def test_random_separations_against_60_digits() -> None:
    random = np.random.default_rng(20)
    x = np.concatenate([random.uniform(-12, 12, 200), random.choice([-1, 1], 300) * 10 ** random.uniform(-9, 6, 300)])
    x = np.concatenate([x, -FAR * (1 + np.array([-1e-9, 0.0, 1e-9])), [-1e6, 1e6]])
    log_gap, slope = log_mean_gap(x)
    expected, steepness = np.array([exact(float(each)) for each in x]).T
    # 1 - t sqrt(pi/2) erfcx cancels to 1/t^2: at most 4 digits lost, of a logarithm near -5000 there.
    np.testing.assert_allclose(log_gap, expected, rtol=1e-15, atol=5e-13)
    np.testing.assert_allclose(slope, steepness, rtol=5e-12)  # those 4 digits


def test_it_is_the_mean_of_what_is_not_cut_off() -> None:
    """By integration over the heights, which the closed form does away with."""
    for x in (-6.3, -1.7, 0.4, 3.1):
        mean, _ = quad(lambda z, x=x: (x - z) * norm.pdf(z), -40, x, epsabs=0, epsrel=1e-10, points=(x - 1, x - 3))
        np.testing.assert_allclose(np.exp(log_mean_gap(x)[0]), mean, rtol=1e-9)  # quad's


def test_the_law_joins_pressure_and_gap() -> None:
    """By a search for the separation and a quadrature over the heights, in place of inverse and closed form."""
    truncated = law()
    deviation = np.sqrt(2) * FINISHED.rms_roughness
    for pressure in (3e4, 2e7, 8e8, 2.3e9):

        def excess(d: float, pressure: float = pressure) -> float:
            return float(log_pressure_at(truncated.cubics, truncated.truncated.summits, d)) - np.log(pressure)

        d = float(brentq(excess, -9e-6, 3e-6, xtol=1e-16))  # pyright: ignore[reportArgumentType]
        mean, _ = quad(lambda z, d=d: max(d - deviation * z, 0.0) * norm.pdf(z), -40, d / deviation, epsabs=0)
        log_gap, slope = log_gap_of(truncated, np.log(pressure))
        # Splines and quadrature agree to 3e-8 deviations; dh/dd = Phi(x) over h is 1/deviation at most |x| + 1 times.
        np.testing.assert_allclose(np.exp(log_gap), mean, rtol=3e-8 * (1 + abs(d) / deviation))
        step = 1e-4
        beyond, before = (log_gap_of(truncated, np.log(pressure) + change)[0] for change in (step, -step))
        np.testing.assert_allclose(slope, (beyond - before) / (2 * step), rtol=2e-6)  # third derivatives of a spline
        assert slope < 0


def test_the_dry_gap_of_smooth_and_unyielding_surfaces() -> None:
    flat = replace(FINISHED, rms_roughness=0.0)
    assert law(flat) is SMOOTH_GAP
    hard, never = replace(FINISHED, hardness=1e15), replace(FINISHED, asperities="greenwood_williamson", hardness=None)
    log_pressure = np.log([1e6, 1e9])
    for found, expected in zip(log_gap_of(law(never), log_pressure), log_gap_of(law(hard), log_pressure), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-6)  # both splines, around other kinks
    soft = replace(FINISHED, hardness=1e9)
    assert np.all(
        log_gap_of(law(never), log_pressure)[0] > log_gap_of(law(soft), log_pressure)[0]
    )  # yielding lets them closer


WAVES = Autocorrelation(kind="gaussian", length=13e-6, spacing=1.3e-6)
MODULUS = 113e9  # Pa


def together(ball: SpectralMoments, race: SpectralMoments) -> GapRoughness:
    return GapRoughness(ball=ball, race=race, summits=mccool_summits(ball + race), height_map=None, warnings=())


def test_the_elastic_gap_is_that_of_the_measured_heights_where_there_are_some() -> None:
    """The map is of waves with a kink at 0, whose curve is another one than that of smooth waves."""
    ball, race = (spectral_moments(rms_roughness=rms, autocorrelation=WAVES) for rms in (0.07e-6, 0.23e-6))
    kinked = replace(WAVES, kind="exponential")
    heights = generated_surface(rms_roughness=0.23e-6, autocorrelation=kinked, points=128, seed=6)
    declared = together(ball, race)
    measured = replace(declared, height_map=heights)
    at = np.log([3e6, 2e8, 4e9])
    curves = (measured_gap_curve(heights), declared_gap_curve(WAVES))
    gaps = (gap_between(curve, moments=ball + race, modulus=MODULUS) for curve in curves)
    own, other = (elastic_log_gap(*gap, at)[0] for gap in gaps)
    assert np.abs(own - other).max() > 0.05  # else it would not matter which of them is taken
    without, beside = Surface(gap="elastic", rms_roughness=None), Surface(gap="elastic", autocorrelation=WAVES)
    for surface, roughness, expected in ((without, measured, own), (beside, measured, own), (beside, declared, other)):
        law = gap_law(surface, roughness, modulus=MODULUS, bodies=(STEEL, STEEL))
        np.testing.assert_array_equal(log_gap_of(law, at)[0], expected)
