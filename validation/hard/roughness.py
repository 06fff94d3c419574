"""Hard cases of roughness: one summit at its kinks, rough surfaces far apart and pressed flat, extreme surfaces."""

import math
from collections.abc import Callable

import numpy as np

from analytic.scene import Array, Autocorrelation
from analytic.surface.asperity import REGIMES, SummitNumbers, log_pressure_at, separation_of, tabulated_asperities
from analytic.surface.heightmap import read_height_map
from analytic.surface.moments import Summits, mccool_summits
from analytic.surface.roughness import spectral_moments
from validation.hard.case import temporary_file
from validation.hard.specimens import MODULUS, parsed

HARDNESS = 7.8e9  # Pa
CORRELATION = Autocorrelation(kind="gaussian", length=60e-6, spacing=2e-6)
TIP = 50e-6  # m, radius of one summit
FIRST_YIELD = (3 * math.pi * 0.4 * HARDNESS / (4 * MODULUS)) ** 2 * TIP  # m
WITHOUT_SPACING = """
[lubricant]
viscosity = "0.06 Pa s"
pressure_viscosity = "2e-8 1/Pa"
eyring_stress = "5 MPa"
[surface]
rms_roughness = "0.3 um"
autocorrelation = { kind = "exponential", length = "60 um" }
"""


def summits(rms_roughness: float) -> Summits:
    """Summits of two surfaces, each of this roughness, m."""
    one = spectral_moments(rms_roughness=rms_roughness, autocorrelation=CORRELATION)
    return mccool_summits(one + one)


def rough(rms_roughness: float) -> tuple[Array, SummitNumbers]:
    """Asperities of two surfaces, each of this roughness, m."""
    return tabulated_asperities(summits=summits(rms_roughness), modulus=MODULUS, hardness=HARDNESS)


def summit(interference: float) -> float:
    """Load on one summit, N."""
    ratio = np.array([interference / FIRST_YIELD])
    pressure, growth = next(law(ratio) for low, high, law in REGIMES if low <= ratio < high)
    return float(np.squeeze(math.pi * TIP * interference * growth * HARDNESS * pressure))


def apart(deviations: float) -> float:
    """ln of the pressure in Pa on asperities at a separation of so many deviations above their mean height."""
    cubics, table = rough(0.3e-6)
    return float(log_pressure_at(cubics, table, table.mean_height + deviations * table.height_deviation))


def mapped(height: float) -> float:
    """Sq, m, of a height map with alternating peaks and pits of this height, m."""
    heights = np.where(np.indices((32, 32)).sum(axis=0) % 2, height, -height)
    with temporary_file("heights.npy") as path:
        np.save(path, heights)
        return float(np.std(read_height_map(path, spacing=2e-6).heights))


ROUGHNESS_CASES: dict[str, Callable[[], float]] = {
    "asperity: not touching": lambda: summit(0.0) / summit(FIRST_YIELD),
    "asperity: vanishing interference": lambda: summit(1e-150),
    "asperity: first yield": lambda: summit(FIRST_YIELD * (1 + 1e-12)),
    "asperity: full flow": lambda: summit(54 * FIRST_YIELD * (1 - 1e-12)),
    "asperities: 60 deviations apart": lambda: apart(60.0),
    "asperities: pressed flat": lambda: float(separation_of(*rough(0.3e-6), math.log(1e15))[0]),
    "surface: exponential, tiny spacing": lambda: (
        spectral_moments(
            rms_roughness=0.3e-6, autocorrelation=Autocorrelation(kind="exponential", length=60e-6, spacing=60e-15)
        ).curvature
    ),
    "surface: exponential without a spacing": lambda: parsed(WITHOUT_SPACING),
    "surface: nearly flat": lambda: rough(1e-18)[1].log_scale,
    "surface: heights near the largest double": lambda: mapped(1.7e308),
}
