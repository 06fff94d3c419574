"""Hard cases of roughness: one summit at its kinks, rough surfaces far apart and pressed flat, extreme surfaces."""

import math

import numpy as np

from analytic.scene import Autocorrelation
from analytic.surface.asperity import asperity_load, separation_at
from analytic.surface.asperity_table import AsperityTable, tabulated_asperities
from analytic.surface.heightmap import read_height_map
from analytic.surface.moments import Summits, mccool_summits
from analytic.surface.roughness import spectral_moments
from validation.hard.case import HardCase, temporary_file
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

# Tolerance, relative, with its reason
KINK = (2e-12, "1e-12 from the kink, times an exponent below 2")


def summits(rms_roughness: float) -> Summits:
    """Summits of two surfaces, each of this roughness, m."""
    one = spectral_moments(rms_roughness=rms_roughness, autocorrelation=CORRELATION)
    return mccool_summits(one + one)


def rough(rms_roughness: float) -> AsperityTable:
    """Asperities of two surfaces, each of this roughness, m."""
    return tabulated_asperities(summits=summits(rms_roughness), modulus=MODULUS, hardness=HARDNESS)


def summit(interference: float) -> float:
    """Load on one summit, N."""
    one = asperity_load(interference=interference, tip_radius=TIP, modulus=MODULUS, hardness=HARDNESS)
    return float(one.load)


def apart(deviations: float) -> float:
    """ln of the pressure in Pa on asperities at a separation of so many deviations above their mean height."""
    table = rough(0.3e-6)
    height = table.summits.mean_height + deviations * table.summits.height_deviation
    return float(table.log_pressure(np.asarray(height)))


def mapped(height: float) -> float:
    """Sq, m, of a height map with alternating peaks and pits of this height, m."""
    heights = np.where(np.indices((32, 32)).sum(axis=0) % 2, height, -height)
    with temporary_file("heights.npy") as path:
        np.save(path, heights)
        return float(np.std(read_height_map(path, spacing=2e-6).heights))


ROUGHNESS_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="asperity: not touching",
        problem="the load of a summit at an interference of 0 over that at first yield: ln 0",
        answer="0",
        evaluate=lambda: summit(0.0) / summit(FIRST_YIELD),
        expected=0.0,
    ),
    HardCase(
        name="asperity: vanishing interference",
        problem="the load of a summit at an interference of 1e-150 m",
        answer="Hertz's 4/3 E* R^(1/2) w^(3/2), by 40 digits",
        evaluate=lambda: summit(1e-150),
        expected=1.0653742169877316034e-216,
    ),
    HardCase(
        name="asperity: first yield",
        problem="the load just above the interference w_1, by the logarithmic law",
        answer="Hertz's at w_1, by 40 digits: no jump",
        evaluate=lambda: summit(FIRST_YIELD * (1 + 1e-12)),
        expected=0.10370962134913208738,
        tolerance=KINK,
    ),
    HardCase(
        name="asperity: full flow",
        problem="the load just below 54 w_1, by the logarithmic law",
        answer="2 pi R w H, by 40 digits: no jump",
        evaluate=lambda: summit(54 * FIRST_YIELD * (1 - 1e-12)),
        expected=28.001597764265663593,
        tolerance=KINK,
    ),
    HardCase(
        name="asperities: 60 deviations apart",
        problem="ln of a pressure of e^-1793 Pa, too small for a double",
        answer="the integral over the summits' heights, by 40 digits",
        evaluate=lambda: apart(60.0),
        expected=-1792.8705981150298242,
        tolerance=(1e-11, "1e-8 of the pressure, of a logarithm of 1793"),
    ),
    HardCase(
        name="asperities: pressed flat",
        problem="the separation under 1e15 Pa, 1e5 times the hardness",
        answer="mean height - p/(2 pi R density H), by 40 digits: all summits flow, whatever their height",
        evaluate=lambda: float(
            separation_at(pressure=1e15, summits=summits(0.3e-6), modulus=MODULUS, hardness=HARDNESS)
        ),
        expected=-0.24550238899485787844,
        tolerance=(1e-8, "integrals and their inverse as good as that; summits not yet flowing are too few to see"),
    ),
    HardCase(
        name="surface: exponential, tiny spacing",
        problem="m_4 at a spacing of a billionth of the length: 6 - 8 rho + 2 rho^2, which cancels to 9 digits",
        answer="the difference, by 40 digits",
        evaluate=lambda: (
            spectral_moments(
                rms_roughness=0.3e-6, autocorrelation=Autocorrelation(kind="exponential", length=60e-6, spacing=60e-15)
            ).curvature
        ),
        expected=2.7777777777777777769e31,
    ),
    HardCase(
        name="surface: exponential without a spacing",
        problem="summits of a profile without a curvature",
        answer="a refusal that names the key: the curvature depends on the spacing",
        evaluate=lambda: parsed(WITHOUT_SPACING),
        refusal="surface.autocorrelation.spacing is missing",
    ),
    HardCase(
        name="surface: nearly flat",
        problem="Sq of 1e-18 m: the loads of summits are too small for a double",
        answer="a refusal that names 0 as the remedy",
        evaluate=lambda: rough(1e-18).numbers.log_scale,
        refusal="all but flat: give a rougher surface, or an rms_roughness of 0",
    ),
    HardCase(
        name="surface: heights near the largest double",
        problem="a height map of +-1.7e308 m, seen in damaged files: their span exceeds a double",
        answer="a refusal that names the unit",
        evaluate=lambda: mapped(1.7e308),
        refusal="give them in m, not in um",
    ),
)
