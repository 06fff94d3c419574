"""Random rough surfaces with a declared autocorrelation: spectral moments in closed form, and generated height maps.

Heights are Gaussian and isotropic with the mean square Sq^2; rho(r) is exp(-(r/B)^2) (gaussian) or exp(-r/B)
(exponential). The gaussian autocorrelation is smooth. The exponential one has a kink at 0: slope and curvature grow
without limit as the spacing decreases. They are defined only by differences at the declared spacing, which is then part
of the input.
Source: spectral filtering as in [Hu1992].
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.scene import Array, Autocorrelation, Surface
from analytic.surface.heightmap import WIDEST, HeightMap, measure, read_height_map
from analytic.surface.map_data import FEWEST_POINTS, MOST_POINTS
from analytic.surface.moments import SpectralMoments, Summits, mccool_summits
from analytic.words import length_of

STEEPEST = 1.0  # rms slope of ball and race together, 45 degrees: far past what asperities on half spaces stand for


@dataclass(frozen=True, kw_only=True)
class GapRoughness:
    """Ball and race as one rough surface against a smooth one."""

    ball: SpectralMoments
    race: SpectralMoments
    summits: Summits  # of the sum of both
    height_map: HeightMap | None  # the measured race; None: declared statistics
    warnings: tuple[str, ...]

    @property
    def rms_roughness(self) -> float:
        """Sq of both together, m."""
        return (self.ball + self.race).rms_roughness


def autocorrelation_at(distance: Array, autocorrelation: Autocorrelation) -> Array:
    """rho(r), 1 at r = 0 and 1/e at the length B; distance : r, m, of any shape."""
    ratio = np.abs(distance) / autocorrelation.length
    return np.exp(-(ratio**2) if autocorrelation.kind == "gaussian" else -ratio)


def spectral_moments(*, rms_roughness: float, autocorrelation: Autocorrelation) -> SpectralMoments:
    """m_0, m_2, m_4 in closed form.

    rms_roughness : Sq, m, >= 0
    gaussian: m_2 = 2 m_0/B^2, m_4 = 12 m_0/B^4 at any spacing. exponential: the mean squares of first and second
    differences of neighbours at the spacing d, which `heightmap.measure` takes,
        m_2 = 2 m_0 [1 - rho(d)]/d^2,  m_4 = m_0 [6 - 8 rho(d) + 2 rho(2 d)]/d^4
    For d << B these are 2 m_0/(B d) and 4 m_0/(B d^3), and diverge for d -> 0.
    """
    _require_sound(autocorrelation)
    require_non_negative(rms_roughness=rms_roughness)
    square, length, d = rms_roughness**2, autocorrelation.length, autocorrelation.spacing
    if autocorrelation.kind == "gaussian":
        return SpectralMoments(height=square, slope=2 * square / length**2, curvature=12 * square / length**4)
    fall = np.expm1(-d / length)  # rho(d) - 1, to full digits at a small spacing
    slope = -2 * fall / d**2
    curvature = (-4 * fall + 2 * fall**2) / d**4  # 6 - 8 rho + 2 rho^2, as rho(2 d) = rho(d)^2
    return SpectralMoments(height=square, slope=square * float(slope), curvature=square * float(curvature))


def generated_surface(*, rms_roughness: float, autocorrelation: Autocorrelation, points: int, seed: int) -> HeightMap:
    """A random periodic surface of points by points heights; equal seeds give equal surfaces.

    rms_roughness : Sq of the ensemble, m, >= 0; single surfaces scatter about it by about length/domain
    White noise is filtered with the square root of the spectrum of the autocorrelation. Heights are relative to the
    mean of the surface.
    Raises InputError if the domain is narrower than 10 lengths or the spacing wider than a tenth of one.
    """
    _require_sound(autocorrelation)
    require_non_negative(rms_roughness=rms_roughness)
    length, spacing = autocorrelation.length, autocorrelation.spacing
    if not FEWEST_POINTS <= points <= MOST_POINTS:
        raise InputError(f"points must be {FEWEST_POINTS} to {MOST_POINTS}, got {points!r}")
    if spacing > WIDEST * length * (1 + 1e-12):  # round-off: exactly a tenth is fine
        raise InputError(
            f"autocorrelation.spacing {length_of(spacing)} is more than a tenth of its length {length_of(length)}: "
            f"give at most {length_of(WIDEST * length)}"
        )
    if length > WIDEST * points * spacing * (1 + 1e-12):
        raise InputError(
            f"autocorrelation.length {length_of(length)} is more than a tenth of {points} points at "
            f"{length_of(spacing)}; give {int(np.ceil(length / (WIDEST * spacing) - 1e-9))} points or more"
        )
    from scipy import fft  # only rough surfaces need it

    steps = np.minimum(np.arange(points), points - np.arange(points)) * spacing  # the shorter of both directions
    correlation = autocorrelation_at(np.hypot(steps[:, None], steps), autocorrelation)
    # The correlation is not quite 0 at half of the period, so its spectrum falls slightly below 0.
    gain = np.sqrt(np.maximum(fft.rfft2(correlation).real, 0.0))
    noise = np.random.default_rng(seed).standard_normal((points, points))
    heights = rms_roughness * fft.irfft2(fft.rfft2(noise) * gain, s=(points, points))
    return HeightMap(heights=heights - heights.mean(), spacing=spacing)


def gap_roughness(surface: Surface) -> GapRoughness:
    """Ball and race of a scene, declared or measured, and the summits of both together.

    Warnings name numbers that depend on the spacing. Raises InputError as read_height_map does, and if the surface has
    neither a height map nor a roughness with its autocorrelation, or is steeper than the model's asperities.
    """
    height_map: HeightMap | None = None
    if surface.height_map is not None:
        try:
            height_map = read_height_map(surface.height_map.path, spacing=surface.height_map.spacing)
            measured = measure(height_map)
        except InputError as problem:
            raise InputError(f"surface.height_map: {problem}") from problem
        race, warnings = measured.moments, measured.warnings
        if race.height == 0:
            raise InputError(f"surface.height_map: {surface.height_map.path}: flat; give a map of a rough surface")
        unit = race.scaled(1 / race.rms_roughness)
    elif surface.rms_roughness is not None and surface.autocorrelation is not None:
        unit = spectral_moments(rms_roughness=1.0, autocorrelation=surface.autocorrelation)
        race, warnings = unit.scaled(surface.rms_roughness), tuple(_doubts(surface.autocorrelation))
    else:
        raise InputError("surface needs rms_roughness and autocorrelation, or height_map")
    ball = race
    if surface.ball_rms_roughness is not None:
        require_non_negative(ball_rms_roughness=surface.ball_rms_roughness)
        ball = unit.scaled(surface.ball_rms_roughness)
    slope = (ball + race).slope ** 0.5
    if slope > STEEPEST:
        key = "rms_roughness" if surface.height_map is None else "height_map"
        raise InputError(
            f"surface.{key} = {length_of(race.rms_roughness)} (Sq) gives ball and race together an rms slope of "
            f"{slope:.3g}, limit {STEEPEST:g} for the shallow asperities of the model: give at most "
            f"{length_of(race.rms_roughness * STEEPEST / slope)} or a longer autocorrelation.length"
        )
    summits = mccool_summits(ball + race)
    return GapRoughness(ball=ball, race=race, summits=summits, height_map=height_map, warnings=warnings)


def _require_sound(autocorrelation: Autocorrelation) -> None:
    require_positive(length=autocorrelation.length, spacing=autocorrelation.spacing)


def _doubts(autocorrelation: Autocorrelation) -> Iterator[str]:
    length, spacing = autocorrelation.length, autocorrelation.spacing
    if autocorrelation.kind == "exponential":
        yield (
            f"slope and curvature of the summits depend on surface.autocorrelation.spacing {length_of(spacing)}, by "
            "finite differences: an exponential autocorrelation does not define them"
        )
    elif spacing > WIDEST * length * (1 + 1e-12):
        yield (
            f"surface.autocorrelation.spacing {length_of(spacing)} is more than a tenth of the length "
            f"{length_of(length)} and is ignored: slope and curvature of a gaussian autocorrelation have closed forms"
        )
