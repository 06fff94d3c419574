"""Hard cases of roughness: one summit at its kinks, rough surfaces far apart and pressed flat, extreme surfaces."""

import math

import numpy as np

from analytic.scene import Array, Autocorrelation
from analytic.surface.asperity import REGIMES, SummitNumbers, log_pressure_at, separation_of, tabulated_asperities
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


ROUGHNESS_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("asperity: not touching", "the load of a summit at an interference of 0 over that at first yield: ln 0",
        "0", lambda: summit(0.0) / summit(FIRST_YIELD), 0.0),
    HardCase("asperity: vanishing interference", "the load of a summit at an interference of 1e-150 m",
        "Hertz's 4/3 E* R^(1/2) w^(3/2), by 40 digits", lambda: summit(1e-150), 1.0653742169877316034e-216),
    HardCase("asperity: first yield", "the load just above the interference w_1, by the logarithmic law",
        "Hertz's at w_1, by 40 digits: no jump", lambda: summit(FIRST_YIELD * (1 + 1e-12)), 0.10370962134913208738,
        tolerance=KINK),
    HardCase("asperity: full flow", "the load just below 54 w_1, by the logarithmic law",
        "2 pi R w H, by 40 digits: no jump", lambda: summit(54 * FIRST_YIELD * (1 - 1e-12)), 28.001597764265663593,
        tolerance=KINK),
    HardCase("asperities: 60 deviations apart", "ln of a pressure of e^-1793 Pa, too small for a double",
        "the integral over the summits' heights, by 40 digits", lambda: apart(60.0), -1792.8705981150298242,
        tolerance=(1e-11, "1e-8 of the pressure, of a logarithm of 1793")),
    HardCase("asperities: pressed flat", "the separation under 1e15 Pa, 1e5 times the hardness",
        "mean height - p/(2 pi R density H), by 40 digits: all summits flow, whatever their height",
        lambda: float(separation_of(*rough(0.3e-6), math.log(1e15))[0]),
        -0.24550238899485787844,
        tolerance=(1e-8, "integrals and their inverse as good as that; summits not yet flowing are too few to see")),
    HardCase("surface: exponential, tiny spacing",
        "m_4 at a spacing of a billionth of the length: 6 - 8 rho + 2 rho^2, which cancels to 9 digits",
        "the difference, by 40 digits",
        lambda: spectral_moments(rms_roughness=0.3e-6, autocorrelation=Autocorrelation(kind="exponential",
            length=60e-6, spacing=60e-15)).curvature, 2.7777777777777777769e31),
    HardCase("surface: exponential without a spacing", "summits of a profile without a curvature",
        "a refusal that names the key: the curvature depends on the spacing", lambda: parsed(WITHOUT_SPACING),
        refusal="surface.autocorrelation.spacing is missing"),
    HardCase("surface: nearly flat", "Sq of 1e-18 m: the loads of summits are too small for a double",
        "a refusal that names 0 as the remedy", lambda: rough(1e-18)[1].log_scale,
        refusal="all but flat: give a rougher surface, or an rms_roughness of 0"),
    HardCase("surface: heights near the largest double",
        "a height map of +-1.7e308 m, seen in damaged files: their span exceeds a double",
        "a refusal that names the unit", lambda: mapped(1.7e308), refusal="give them in m, not in um"),
)  # fmt: skip
