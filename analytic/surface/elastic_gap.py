"""The mean gap between deformed rough surfaces, and their real area of contact, as curves over pressure.

The curves come from `boundary_elements`, with the heights of both surfaces and the modulus E* of both bodies: elastic
everywhere, no friction. Asperities that touch press down the ground around them, too, so that the gap closes more
slowly than between undeformed surfaces that overlap.

Gaps are over sigma, the rms height; pressures over E* slope, with slope = sqrt(2 m_2), the rms gradient.
`python validation/film/elastic_gap.py` makes the stored curves.
"""

from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any, NamedTuple

import numpy as np

from analytic import catalog
from analytic.errors import require_positive
from analytic.numerics.cubic import Pieces, cubic_at, monotone_cubic, together
from analytic.numerics.elements import formula
from analytic.scene import Array, Autocorrelation
from analytic.surface.boundary_elements import NO_GAP, pressed
from analytic.surface.heightmap import HeightMap, levelled, measure
from analytic.surface.moments import SpectralMoments

# A map is cut to so many points in each direction and pressed with these pressures, for 1 to 4 s.
MOST_POINTS = 256
PRESSURES = (1.0, 0.7, 0.45, 0.3, 0.2, 0.1, 0.05, 0.02, 0.007, 0.002)
STEEPEST = 300.0  # in ln p beyond the last knot: there exp(2 ln p) would soon overflow, and ln gap goes on straight
INVERSE = -np.sinh(np.linspace(np.arcsinh(700.0), -np.arcsinh(5.0), 60))  # ln p/(E* slope)
LONGEST = 0.5  # of the side of a map: a correlation length that the map does not show counts as so much


class ElasticNumbers(NamedTuple):
    """The gap between two surfaces; the splines are in an array that formulas take beside.

    Below the first knot p_1 the gap over sigma is e + sqrt(a^2 + 2 ln(p_1/p)).
    """

    log_sigma: float  # of m
    log_scale: float  # ln of E* slope, Pa
    first: float  # knots, ln of p/(E* slope)
    last: float
    gap: Pieces  # ln of the mean gap over sigma
    inverse: Pieces  # ln of p/(E* slope) over ln of the mean gap over sigma, roughly
    area: Pieces  # of ln(-ln(1 - area)), which is ln p where p is small and 2 ln p where it is large
    start: float  # a
    offset: float  # e


@formula
def elastic_log_gap(cubics: Array, law: ElasticNumbers, log_pressure: float) -> tuple[float, float]:
    """ln of the mean gap in m, and its derivative by ln p, below 0; log_pressure : ln of p in Pa.

    p is the nominal pressure that asperities carry.
    """
    at = log_pressure - law.log_scale
    if at < law.first:
        root = np.sqrt(law.start * law.start + 2.0 * (law.first - at))
        return law.log_sigma + np.log(law.offset + root), -1.0 / (root * (law.offset + root))
    value, slope = cubic_at(cubics, law.gap, min(at, law.last))
    if at > law.last:
        beyond = at - law.last
        growth = np.exp(2.0 * min(beyond, STEEPEST))
        value += slope * ((growth - 1.0) / 2.0 + growth * max(beyond - STEEPEST, 0.0))
        slope *= growth
    return law.log_sigma + value, slope


@formula
def elastic_area(cubics: Array, law: ElasticNumbers, log_pressure: float) -> float:
    """Real over nominal area, rising with p from 0 to 1: proportional to p where small; log_pressure as above."""
    at = log_pressure - law.log_scale
    inside = min(max(at, law.first), law.last)
    outside = min(at - law.first, 0.0) + 2.0 * max(at - law.last, 0.0)
    return -np.expm1(-np.exp(min(cubic_at(cubics, law.area, inside)[0] + outside, STEEPEST)))


@dataclass(frozen=True, kw_only=True, eq=False)
class GapCurve:
    """Mean gap and real area of a kind of rough surfaces over pressure.

    Between the knots ln gap is a monotone cubic. Below the first one the gap is that of the summits of a Gaussian
    surface, where it grows like sqrt(-2 ln p). Above the last one ln gap falls like p^2 [Persson2001]. Value and slope
    are continuous, and ln gap falls everywhere; ln p may be -1e4 to 700.
    """

    knots: Array  # rising, ln of p/(E* slope)
    gaps: Array  # falling, ln of the mean gap over sigma
    spreads: Array  # standard deviation of ln gap between surfaces of this width
    areas: Array  # real over nominal area
    width: float  # of those surfaces, in correlation lengths

    def spread(self, log_pressure: Array) -> Array:
        """Standard deviation of ln gap between surfaces of this width, each with its own sigma and slope.

        Between surfaces of another width it is larger by the ratio of the widths.
        """
        return np.interp(log_pressure, self.knots, self.spreads)

    @cached_property
    def splines(self) -> tuple[Array, ElasticNumbers]:
        """(rows, 5) cubics, and the numbers in units of sigma and of E* slope."""
        gap = monotone_cubic(self.knots, self.gaps)
        cubics, (gap_pieces, area_pieces) = together(gap, monotone_cubic(self.knots, np.log(-np.log1p(-self.areas))))
        height = float(np.exp(self.gaps[0]))
        start = -1 / (height * float(gap[0, 3]))  # by the slope at the first knot
        numbers = ElasticNumbers(
            log_sigma=0.0,
            log_scale=0.0,
            first=float(self.knots[0]),
            last=float(self.knots[-1]),
            gap=gap_pieces,
            inverse=Pieces(len(cubics), len(cubics) + INVERSE.size - 1),
            area=area_pieces,
            start=start,
            offset=height - start,
        )
        inverse = monotone_cubic(elastic_log_gap(cubics, numbers, INVERSE)[0][::-1], INVERSE[::-1])
        return np.concatenate([cubics, inverse]), numbers


def gap_between(curve: GapCurve, *, moments: SpectralMoments, modulus: float) -> tuple[Array, ElasticNumbers]:
    """Splines, (rows, 5), and numbers of surfaces with these moments, the sum of both; modulus : E*, Pa, > 0.

    Raises InputError for a smooth surface, whose gap is 0.
    """
    require_positive(height=moments.height, slope=moments.slope, modulus=modulus)
    cubics, numbers = curve.splines
    scale = float(np.log(modulus) + np.log(2 * moments.slope) / 2)
    return cubics, numbers._replace(log_sigma=float(np.log(moments.rms_roughness)), log_scale=scale)


def declared_gap_curve(autocorrelation: Autocorrelation) -> GapCurve:
    """The mean over generated Gaussian surfaces, from the catalog.

    gaussian: one curve. exponential: the curves of several spacings, linear in ln of the spacing over the length;
    beyond the widest and the finest, theirs.
    """
    require_positive(length=autocorrelation.length, spacing=autocorrelation.spacing)
    curves = _stored_curves(autocorrelation.kind)
    spacing, at = autocorrelation.spacing / autocorrelation.length, np.log([c["spacing"] for c in curves])
    weights = tuple(float(np.interp(np.log(spacing), at, row)) for row in np.eye(len(curves)))
    return _mean_curve(autocorrelation.kind, weights)


@lru_cache(maxsize=64)
def _mean_curve(kind: str, weights: tuple[float, ...]) -> GapCurve:
    table, curves = _table(), _stored_curves(kind)
    return GapCurve(
        knots=np.log(table["pressure"]),
        gaps=np.array(weights) @ np.log([c["gap"] for c in curves]),
        spreads=np.array(weights) @ np.array([c["spread"] for c in curves]),
        areas=np.array(weights) @ np.array([c["area_fraction"] for c in curves]),
        width=table["width"],
    )


def _stored_curves(kind: str) -> list[dict[str, Any]]:
    """From the finest spacing to the widest."""
    return sorted((c for c in _table()["curve"] if c["kind"] == kind), key=lambda c: c["spacing"])


@cache
def _table() -> dict[str, Any]:
    return catalog.entry("corrections", "elastic_gap")


def measured_gap_curve(height_map: HeightMap) -> GapCurve:
    """The curve of a measured surface, of the middle of its map, at most 256 by 256 points, levelled again.

    Mirror images continue the map beyond its edges, where they make ridges and furrows: on generated surfaces 20
    correlation lengths wide this lowers the gap by 2 % or less up to p/(E* slope) = 0.3, by 4 % at 0.9. The
    spread between such pieces is that of surfaces with a gaussian autocorrelation, for the piece's own width. The
    result is remembered.
    Raises InputError for a flat map.
    """
    rows, columns = (max(size - MOST_POINTS, 0) // 2 for size in height_map.heights.shape)
    heights = height_map.heights[rows : rows + MOST_POINTS, columns : columns + MOST_POINTS]
    return _of_heights(heights.tobytes(), heights.shape)


@lru_cache(maxsize=8)
def _of_heights(content: bytes, shape: tuple[int, int]) -> GapCurve:
    piece = levelled(HeightMap(heights=np.frombuffer(content).reshape(shape), spacing=1.0))
    pressures, results = np.array(PRESSURES), list(pressed(piece.heights, PRESSURES, periodic=False))
    open_ = np.array([result.mean_gap > NO_GAP for result in results])
    knots = np.log(pressures[open_])[::-1]
    gaps = np.log(np.array([result.mean_gap for result in results])[open_])[::-1]
    areas = np.array([min(result.area_fraction, 1 - NO_GAP) for result in results])[open_][::-1]
    width = min(shape) / min(measure(piece).correlation_length, LONGEST * min(shape))
    table = declared_gap_curve(Autocorrelation(kind="gaussian", length=10.0, spacing=1.0))
    return GapCurve(knots=knots, gaps=gaps, areas=areas, spreads=table.spread(knots) * table.width / width, width=width)
