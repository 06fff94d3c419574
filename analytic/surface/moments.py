"""Spectral moments of a random rough surface, and its summits as spheres.

The surface is isotropic and Gaussian, and smooth enough to have a curvature. Heights are relative to its mean plane.
Source: [McCool1987], by the theory of [Nayak1971]; the tests check density, mean height, deviation and mean curvature
by counting summits on generated surfaces.
"""

from dataclasses import dataclass

import numpy as np

from analytic.errors import InputError, require_finite, require_non_negative
from analytic.scene import Array


@dataclass(frozen=True, kw_only=True)
class SpectralMoments:
    """Mean squares of height, slope and curvature along one direction; those of independent surfaces add up."""

    height: float  # m_0 = Sq^2, m^2
    slope: float  # m_2
    curvature: float  # m_4, 1/m^2

    def __add__(self, other: "SpectralMoments") -> "SpectralMoments":
        """The moments of the gap between two surfaces."""
        return SpectralMoments(
            height=self.height + other.height,
            slope=self.slope + other.slope,
            curvature=self.curvature + other.curvature,
        )

    def scaled(self, factor: float) -> "SpectralMoments":
        """The moments of the surface with all heights multiplied by the factor."""
        square = factor**2
        return SpectralMoments(
            height=square * self.height, slope=square * self.slope, curvature=square * self.curvature
        )

    @property
    def rms_roughness(self) -> float:
        """Sq, m."""
        return float(np.sqrt(self.height))

    @property
    def bandwidth(self) -> float:
        """al = m_0 m_4/m_2^2: 1.5 for one wavelength in all directions, 3 for a gaussian autocorrelation."""
        return self.height * self.curvature / self.slope**2


@dataclass(frozen=True, kw_only=True)
class Summits:
    """The summits of a rough surface: equal spheres with Gaussian heights; numbers, or arrays that broadcast."""

    density: float | Array  # per area, 1/m^2
    radius: float | Array  # R_a, of their tips, m
    height_deviation: float | Array  # sigma_s, standard deviation of their heights, m
    mean_height: float | Array  # above the mean plane of the surface, m


def mccool_summits(moments: SpectralMoments) -> Summits:
    """The summits of a surface with these spectral moments.

        density = m_4/(6 pi sqrt(3) m_2),  radius = (3/8) sqrt(pi/m_4)
        height_deviation^2 = (1 - 0.8968/al) m_0,  mean_height = 4 sqrt(m_0/(pi al)),  al = m_0 m_4/m_2^2
    A smooth surface (all moments 0) has no summits: density, deviation and mean height are 0, the radius is infinite.
    Raises InputError for negative moments and for al < 1, which is impossible.
    """
    require_non_negative(height=moments.height, slope=moments.slope, curvature=moments.curvature)
    if moments.height == 0 and moments.slope == 0 and moments.curvature == 0:
        return Summits(density=0.0, radius=float("inf"), height_deviation=0.0, mean_height=0.0)
    if moments.slope == 0 or not moments.height * moments.curvature >= moments.slope**2 * (1 - 1e-12):  # round-off
        raise InputError(
            f"spectral moments {moments.height:g} m^2, {moments.slope:g}, {moments.curvature:g} 1/m^2 belong to no "
            "surface: height * curvature must be at least slope^2; check heights and spacing"
        )
    bandwidth = moments.bandwidth
    require_finite(bandwidth=bandwidth)
    return Summits(
        density=moments.curvature / (6 * np.pi * np.sqrt(3) * moments.slope),
        radius=3 / 8 * float(np.sqrt(np.pi / moments.curvature)),
        height_deviation=float(np.sqrt((1 - 0.8968 / bandwidth) * moments.height)),
        mean_height=4 * float(np.sqrt(moments.height / (np.pi * bandwidth))),
    )
