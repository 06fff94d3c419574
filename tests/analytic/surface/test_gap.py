"""Which curve of the mean gap a surface has: that of its measured heights, else that of its declared waves."""

from dataclasses import replace

import numpy as np

from analytic.scene import Autocorrelation, Surface
from analytic.surface.elastic_gap import declared_gap_curve, elastic_log_gap, gap_between, measured_gap_curve
from analytic.surface.gap import gap_law, log_gap_of
from analytic.surface.moments import SpectralMoments, mccool_summits
from analytic.surface.roughness import GapRoughness, generated_surface, spectral_moments
from tests.contacts import STEEL

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
