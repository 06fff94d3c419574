"""The gap law of a scene's surfaces: how much room they leave for the oil while asperities carry a pressure."""

from typing import Any, NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.cubic import Pieces, cubic_at
from analytic.numerics.elements import formula
from analytic.scene import Array, Material, Surface
from analytic.surface.asperity import SummitNumbers, first_yield, softer_hardness
from analytic.surface.elastic_gap import (
    ElasticNumbers,
    declared_gap_curve,
    elastic_area,
    elastic_log_gap,
    gap_between,
    measured_gap_curve,
)
from analytic.surface.roughness import GapRoughness
from analytic.surface.truncated_gap import TruncatedNumbers, truncated_area, truncated_law, truncated_log_gap

NEVER_YIELDS = 400.0  # standard deviations of height that a summit of [Greenwood1966] can be pressed in
SMOOTH, TRUNCATED, ELASTIC = 0, 1, 2  # kinds of GapNumbers
NO_PIECES = Pieces(0, 1)
NOT_TRUNCATED = TruncatedNumbers(SummitNumbers(0.0, 1.0, 0.0, 0.0, NO_PIECES, NO_PIECES, NO_PIECES), 1.0, NO_PIECES)
NOT_ELASTIC = ElasticNumbers(0.0, 0.0, 0.0, 0.0, NO_PIECES, NO_PIECES, NO_PIECES, 1.0, 0.0)


class GapNumbers(NamedTuple):
    """A gap law of any kind in numbers, for compiled formulas; only the part of its kind has a meaning."""

    kind: int
    cubics: Array  # of `analytic.numerics.cubic.Pieces`
    truncated: TruncatedNumbers
    elastic: ElasticNumbers


class GapForm(NamedTuple):
    """`GapNumbers` without the splines, for a record of a model."""

    kind: int
    truncated: TruncatedNumbers
    elastic: ElasticNumbers


@formula
def log_gap_of(gap: GapNumbers, log_pressure: float) -> tuple[float, float]:
    """ln of the mean gap in m, and its derivative by ln p, < 0.

    log_pressure : ln of the nominal pressure p in Pa that the asperities carry
    """
    if gap.kind == TRUNCATED:
        return truncated_log_gap(gap.cubics, gap.truncated, log_pressure)
    return elastic_log_gap(gap.cubics, gap.elastic, log_pressure)


@formula
def area_of(gap: GapNumbers, log_pressure: float) -> float:
    """Real over nominal area, 0 to 1."""
    if gap.kind == TRUNCATED:
        return truncated_area(gap.cubics, gap.truncated, log_pressure)
    return elastic_area(gap.cubics, gap.elastic, log_pressure)


@compiled
def rough_log_pressure(gap: GapNumbers, log_gap: float) -> tuple[float, float]:
    """ln of the pressure that leaves this mean gap, to some per cent, and its slope: where a search begins."""
    if gap.kind == TRUNCATED:
        return cubic_at(gap.cubics, gap.truncated.inverse, log_gap)
    law = gap.elastic
    value, slope = cubic_at(gap.cubics, law.inverse, log_gap - law.log_sigma)
    return value + law.log_scale, slope


@compiled
def log_sigma_of(gap: GapNumbers) -> float:
    """ln of the rms height of both surfaces together in m, of rough ones."""
    return np.log(gap.truncated.deviation) if gap.kind == TRUNCATED else gap.elastic.log_sigma


SMOOTH_GAP = GapNumbers(SMOOTH, np.zeros((1, 5)), NOT_TRUNCATED, NOT_ELASTIC)


def gap_law(
    surface: Surface, roughness: GapRoughness, *, modulus: float, bodies: tuple[Material, Material]
) -> GapNumbers:
    """The law that `surface.gap` names, for both bodies together.

    roughness : gap_roughness(surface);  modulus : E*, Pa
    Raises InputError if a summit's hardness is needed and not known, or for nearly smooth surfaces.
    """
    if roughness.rms_roughness == 0:
        return SMOOTH_GAP
    if surface.gap == "elastic":
        if roughness.height_map is not None:
            curve = measured_gap_curve(roughness.height_map)
        else:
            assert surface.autocorrelation is not None
            curve = declared_gap_curve(surface.autocorrelation)
        cubics, elastic = gap_between(curve, moments=roughness.ball + roughness.race, modulus=modulus)
        return GapNumbers(ELASTIC, cubics, NOT_TRUNCATED, elastic)
    summits = roughness.summits
    if surface.asperities == "greenwood_williamson":
        depth = NEVER_YIELDS * float(summits.height_deviation)
        hardness = float(np.sqrt(depth / first_yield(summits.radius, modulus, 1.0)))  # first yield grows as H^2
    else:
        hardness = softer_hardness(surface, *bodies)
    cubics, truncated = truncated_law(
        summits=summits, modulus=modulus, hardness=hardness, deviation=roughness.rms_roughness
    )
    return GapNumbers(TRUNCATED, cubics, truncated, NOT_ELASTIC)


def gap_forms(*laws: GapNumbers) -> tuple[list[GapForm], Array]:
    """Laws as parts of a record, and the splines of all of them in one array."""
    forms, rows = [], []
    for law in laws:
        forms.append(_behind(GapForm(law.kind, law.truncated, law.elastic), sum(map(len, rows))))
        rows.append(law.cubics)
    return forms, np.concatenate(rows)


def _behind(numbers: Any, before: int) -> Any:
    """The numbers of a law whose splines stand behind so many rows."""
    if isinstance(numbers, Pieces):
        return Pieces(numbers.first + before, numbers.beyond + before)
    inside = {name: getattr(numbers, name) for name in numbers._fields}
    return numbers._replace(**{name: _behind(part, before) for name, part in inside.items() if isinstance(part, tuple)})
