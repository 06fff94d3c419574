"""The gap law of a scene's surfaces: how much room they leave for the oil while asperities carry a pressure."""

from typing import Protocol

import numpy as np

from analytic.scene import Array, Material, Surface
from analytic.surface.asperity import first_yield, softer_hardness
from analytic.surface.asperity_table import tabulated_asperities
from analytic.surface.elastic_gap import declared_gap_curve, gap_between, measured_gap_curve
from analytic.surface.roughness import GapRoughness
from analytic.surface.truncated_gap import TruncatedGap

NEVER_YIELDS = 400.0  # standard deviations of height that a summit of [Greenwood1966] can be pressed in


class GapLaw(Protocol):
    """How much room rough surfaces leave for the oil, for one pair of surfaces."""

    def log_gap(self, log_pressure: Array) -> tuple[Array, Array]:
        """ln of the mean gap in m, and its derivative by ln p, < 0.

        log_pressure : ln of the nominal pressure p in Pa that the asperities carry
        """
        ...

    def area_fraction(self, log_pressure: Array) -> Array:
        """Real over nominal area at this pressure, 0 to 1."""
        ...


def gap_law(
    surface: Surface, roughness: GapRoughness, *, modulus: float, bodies: tuple[Material, Material]
) -> GapLaw | None:
    """The law that `surface.gap` names, for both bodies together; None: both are smooth.

    roughness : gap_roughness(surface);  modulus : E*, Pa
    Raises InputError if a summit's hardness is needed and not known, or for nearly smooth surfaces.
    """
    if roughness.rms_roughness == 0:
        return None
    if surface.gap == "elastic":
        if roughness.height_map is not None:
            curve = measured_gap_curve(roughness.height_map)
        else:
            assert surface.autocorrelation is not None
            curve = declared_gap_curve(surface.autocorrelation)
        return gap_between(curve, moments=roughness.ball + roughness.race, modulus=modulus)
    summits = roughness.summits
    if surface.asperities == "greenwood_williamson":
        depth = NEVER_YIELDS * float(summits.height_deviation)
        hardness = float(np.sqrt(depth / first_yield(summits.radius, modulus, 1.0)))  # first yield grows as H^2
    else:
        hardness = softer_hardness(surface, *bodies)
    return TruncatedGap(
        asperities=tabulated_asperities(summits=summits, modulus=modulus, hardness=hardness),
        deviation=roughness.rms_roughness,
    )
