"""Hard cases of roughness: one summit at its kinks, rough surfaces far apart and pressed flat, and odd surfaces."""

import math

import numpy as np

from analytic.scene import Autocorrelation
from analytic.scenefile.read import parse_scene
from analytic.surface.asperity import asperity_load, separation_at
from analytic.surface.asperity_table import AsperityTable, tabulated_asperities
from analytic.surface.heightmap import read_height_map
from analytic.surface.moments import Summits, mccool_summits
from analytic.surface.roughness import spectral_moments
from fembearing.compare.hard.case import HardCase, passing_file
from fembearing.compare.hard.contacts import MODULUS, ROUND_OFF

HARDNESS = 7.8e9  # Pa
CORRELATION = Autocorrelation(kind="gaussian", length=60e-6, spacing=2e-6)
TIP = 50e-6  # m, of one summit
FIRST_YIELD = (3 * math.pi * 0.4 * HARDNESS / (4 * MODULUS)) ** 2 * TIP  # m
SCENE = """
name = "a rough bearing"
tolerance = "5 %"
[bearing]
catalog = "6205"
contact_angle = {{ rule = "solved" }}
[operation]
axial_load = "700 N"
inner_speed = "300 rpm"
[lubricant]
viscosity = "0.06 Pa s"
pressure_viscosity = "2e-8 1/Pa"
eyring_stress = "5 MPa"
[surface]
rms_roughness = "0.3 um"
autocorrelation = {{ kind = "exponential", length = "60 um"{spacing} }}
"""

# Tolerance, relative, with its reason
KINK = (2e-12, "1e-12 beside the kink, times an exponent below 2")


def summits(rms_roughness: float) -> Summits:
    """Of two surfaces of so much each, m."""
    one = spectral_moments(rms_roughness=rms_roughness, autocorrelation=CORRELATION)
    return mccool_summits(one + one)


def rough(rms_roughness: float) -> AsperityTable:
    return tabulated_asperities(summits=summits(rms_roughness), modulus=MODULUS, hardness=HARDNESS)


def summit(interference: float) -> float:
    """Load on one summit, N."""
    found = asperity_load(interference=interference, tip_radius=TIP, modulus=MODULUS, hardness=HARDNESS)
    return float(found.load)


def apart(deviations: float) -> float:
    """ln of the pressure in Pa that asperities bear so many deviations above their mean height."""
    table = rough(0.3e-6)
    height = table.summits.mean_height + deviations * table.summits.height_deviation
    return float(table.log_pressure(np.asarray(height)))


def mapped(height: float) -> float:
    """Sq, m, of a height map of peaks and pits of that height, m."""
    heights = np.where(np.indices((32, 32)).sum(axis=0) % 2, height, -height)
    with passing_file("heights.npy") as path:
        np.save(path, heights)
        return float(np.std(read_height_map(path, spacing=2e-6).heights))


ROUGHNESS_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="asperity: not touching",
        asked="one and the load of a summit at an interference of 0 over that at first yield: ln 0",
        right="1: none",
        evaluate=lambda: 1 + summit(0.0) / summit(FIRST_YIELD),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="asperity: all but touching",
        asked="the load of a summit at an interference of 1e-150 m",
        right="Hertz's 4/3 E* R^(1/2) w^(3/2), by 40 digits",
        evaluate=lambda: summit(1e-150),
        expected=1.0653742169877316034e-216,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="asperity: first yield",
        asked="the load just above the interference w_1, by the logarithmic law",
        right="Hertz's at w_1, by 40 digits: no jump",
        evaluate=lambda: summit(FIRST_YIELD * (1 + 1e-12)),
        expected=0.10370962134913208738,
        tolerance=KINK,
    ),
    HardCase(
        name="asperity: full flow",
        asked="the load just below 54 w_1, by the logarithmic law",
        right="2 pi R w H, by 40 digits: no jump",
        evaluate=lambda: summit(54 * FIRST_YIELD * (1 - 1e-12)),
        expected=28.001597764265663593,
        tolerance=KINK,
    ),
    HardCase(
        name="asperities: 60 deviations apart",
        asked="ln of a pressure of e^-1793 Pa, which no double holds",
        right="the integral over the summits' heights, by 40 digits",
        evaluate=lambda: apart(60.0),
        expected=-1792.8705981150298242,
        tolerance=(1e-11, "1e-8 of the pressure, of a logarithm of 1793"),
    ),
    HardCase(
        name="asperities: pressed flat",
        asked="the separation under 1e15 Pa, 1e5 times the hardness",
        right="mean height - p/(2 pi R density H), by 40 digits: all summits flow, whatever their heights",
        evaluate=lambda: float(
            separation_at(pressure=1e15, summits=summits(0.3e-6), modulus=MODULUS, hardness=HARDNESS)
        ),
        expected=-0.24550238899485787844,
        tolerance=(1e-8, "integrals and their inverse as good as that; summits not yet flowing are too few to see"),
    ),
    HardCase(
        name="surface: exponential, looked at closely",
        asked="m_4 at a spacing of a billionth of the length: 6 - 8 rho + 2 rho^2, of numbers that agree to 9 digits",
        right="the difference, by 40 digits",
        evaluate=lambda: (
            spectral_moments(
                rms_roughness=0.3e-6,
                autocorrelation=Autocorrelation(kind="exponential", length=60e-6, spacing=60e-15),
            ).curvature
        ),
        expected=2.7777777777777777769e31,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="surface: exponential without a spacing",
        asked="summits of a profile that has no curvature of its own",
        right="a refusal that names the key: they are those seen at a spacing",
        evaluate=lambda: parse_scene(SCENE.format(spacing=""), origin="scene").tolerance,
        refusal="surface.autocorrelation.spacing is missing",
    ),
    HardCase(
        name="surface: all but flat",
        asked="Sq of 1e-18 m: summits whose loads no double holds",
        right="a refusal that names 0 as the remedy",
        evaluate=lambda: rough(1e-18).log_scale,
        refusal="all but flat: give a rougher surface, or an rms_roughness of 0",
    ),
    HardCase(
        name="surface: heights near the largest double",
        asked="a height map of +-1.7e308 m, found by damaged files: their span is no double",
        right="a refusal that names the unit",
        evaluate=lambda: mapped(1.7e308),
        refusal="give them in m, not in um",
    ),
)
