"""Hard cases of lubrication: film, load share of asperities, sliding oil, the torque in oil, and rough surfaces."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.oil.film import Inflow, asymptotes_of, central_film
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import mean_force, mixed_traction, oil_shear_stress
from analytic.oil.viscosity import oil_numbers, roelands_viscosity
from analytic.result import FrictionTorque
from analytic.scene import Array, Autocorrelation, Lubricant, Reach, Surface
from analytic.surface.asperity import REGIMES, SummitNumbers, log_pressure_at, separation_of, tabulated_asperities
from analytic.surface.gap import NOT_ELASTIC, SMOOTH_GAP, TRUNCATED, GapNumbers
from analytic.surface.heightmap import read_height_map
from analytic.surface.moments import Summits, mccool_summits
from analytic.surface.roughness import spectral_moments
from analytic.surface.truncated_gap import truncated_law
from validation.hard.specimens import (
    BEARING,
    LARGE,
    LOAD,
    MODULUS,
    SMALL,
    exponent,
    parsed,
    temporary_file,
    torque_6205,
    with_conformity,
)

SPEED = 0.37  # m/s, of entrainment
BOUNDARY_FRICTION = 0.12  # coefficient where asperities touch
OIL = Lubricant(
    viscosity=0.061,
    pressure_viscosity=2.1e-8,
    viscosity_temperature=0.041,
    reference_temperature=313.0,
    temperature=313.0,
    thermal_conductivity=0.14,
    density=870.0,
    eyring_stress=5.3e6,
    limiting_shear=0.07,
    traction="eyring_sinh",
    thickening="roelands",
)


def film(**changed: Any) -> float:
    """Central film, m; NaN unless exactly the ellipses outside the fitted shapes are marked."""
    of_contact = {name: changed.pop(name) for name in ("load", "curvature_transverse") if name in changed}
    here = contact(**of_contact)
    oil: dict[str, Any] = {"viscosity": OIL.viscosity, "pressure_viscosity": OIL.pressure_viscosity}
    oil |= {"entrainment_speed": SPEED} | changed
    central = central_film(here, **oil)
    fitted = 0.03 <= here.curvature_transverse / here.curvature_rolling <= 1
    return float(central.thickness) if bool(central.outside_range) != fitted else math.nan


def contact(load: float = LOAD, curvature_transverse: float = SMALL) -> ContactNumbers:
    """A ball on a race."""
    return elliptic_contact(
        curvature_rolling=LARGE, curvature_transverse=curvature_transverse, load=load, modulus=MODULUS
    )


def shared(rms_roughness: float, *, load: float = LOAD, speed: float = SPEED, film_factor: float = 1.0) -> MixedContact:
    """Oil and asperities of two surfaces, each of this roughness, m; 0: smooth."""
    here = contact(load)
    film = asymptotes_of(here, Inflow(abs(speed), OIL.viscosity, OIL.pressure_viscosity))
    return mixed_contact(here, film, truncated(rms_roughness) if rms_roughness else SMOOTH_GAP, film_factor)


def truncated(rms_roughness: float) -> GapNumbers:
    """The gap between these surfaces; what overlaps is cut off."""
    deviation = math.sqrt(2) * rms_roughness
    cubics, law = truncated_law(summits=summits(rms_roughness), modulus=MODULUS, hardness=HARDNESS, deviation=deviation)
    return GapNumbers(TRUNCATED, cubics, law, NOT_ELASTIC)


def share(rms_roughness: float, **changed: float) -> float:
    """s, the asperities' share of the load."""
    return float(shared(rms_roughness, **changed).asperity_share)


def friction(oil: Lubricant, mixed: MixedContact, *, load: float, slip: float) -> float:
    """Friction, N, of a contact that slides with slip, m/s."""
    law = mixed_traction(oil_numbers(oil), BOUNDARY_FRICTION, mixed, 1.0)
    return float(mean_force(law, contact(load), slip))


def light_friction(load: float) -> float:
    """Friction, N, of oil at constant shear stress; NaN unless the film is marked as capped by the gap."""
    mixed = shared(0.3e-6, load=load)
    force = friction(replace(OIL, traction="eyring_constant"), mixed, load=load, slip=0.02)
    return force if bool(mixed.capped) else math.nan


def thickened(pressure: float, *, alpha: float = OIL.pressure_viscosity, temperature: float = 313.0) -> float:
    """Viscosity, Pa s, at a pressure, Pa, and a temperature, K; alpha : 1/Pa"""
    known = {"viscosity": OIL.viscosity, "viscosity_temperature": OIL.viscosity_temperature}
    known["reference_temperature"] = OIL.reference_temperature
    return float(roelands_viscosity(pressure=pressure, temperature=temperature, pressure_viscosity=alpha, **known))


def shear(speed: float, *, oil: Lubricant = OIL, pressure: float = 0.9e9, film_thickness: float = 0.23e-6) -> float:
    """Shear stress, Pa, of oil that slides with speed, m/s."""
    return float(oil_shear_stress(oil_numbers(oil), pressure=pressure, speed=speed, film_thickness=film_thickness))


def oiled(
    *,
    speed: float = 31.0,
    rms_roughness: float = 0.3e-6,
    conformity: float | None = None,
    ahead: float = 0.9,
    degree: float | None = None,
) -> FrictionTorque:
    """The 6205 under 700 N of thrust in oil, its inner ring at speed, rad/s.

    ahead : reach of the oil, in radii of the ball;  degree : of starvation
    """
    surface = Surface(
        rms_roughness=rms_roughness,
        autocorrelation=CORRELATION,
        hardness=HARDNESS,
        boundary_friction=BOUNDARY_FRICTION,
        gap="truncated",
    )
    bearing = BEARING if conformity is None else with_conformity(conformity)
    lubricant = replace(OIL, reach=Reach(ahead=ahead), starvation_degree=degree)
    changed: dict[str, Any] = {"bearing": bearing, "lubricant": lubricant, "surface": surface}
    return torque_6205(axial_load=700.0, speed=speed, friction_coefficient=None, **changed)


def coefficient(**changed: float) -> float:
    """Friction coefficient of the inner race; arguments of `oiled`."""
    coefficient = oiled(**changed).friction_coefficient.inner
    assert coefficient is not None
    return float(coefficient[0])


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


LUBRICATION_CASES: dict[str, Callable[[], float]] = {
    "film: standstill": lambda: film(entrainment_speed=0.0) / film(),
    "film: reversed": lambda: film(entrainment_speed=-SPEED) / film(),
    "film: wider along rolling": lambda: film(curvature_transverse=1.9 * LARGE),
    "film: no load": lambda: film(load=0.0),
    "film: 1e-12 N": lambda: film(load=1e-12),
    "film: 1e-12 N, limited gap": lambda: film(load=1e-12, largest_gap=0.11e-3),
    "film: 1e-12 N, 1e-12 m/s": lambda: film(load=1e-12, entrainment_speed=1e-12),
    "film: no piezoviscosity": lambda: film(pressure_viscosity=0.0),
    "film: rigid bodies": lambda: film(pressure_viscosity=0.0, load=1e-28, entrainment_speed=1e-30),
    "mixed: standstill": lambda: (
        friction(OIL, shared(0.3e-6, speed=0.0), load=LOAD, slip=0.02) / (BOUNDARY_FRICTION * LOAD)
    ),
    "mixed: reversed": lambda: share(0.3e-6, speed=-SPEED) / share(0.3e-6),
    "mixed: smooth": lambda: share(0.0),
    "mixed: nearly smooth": lambda: float(shared(1e-12).film_thickness) / film(),
    "mixed: very rough": lambda: 1 - share(40e-6),
    "mixed: 1e-9 m/s": lambda: 1 - float(shared(0.3e-6, speed=1e-9).boundary_share),
    "mixed: rougher than the gap": lambda: share(1e-2),
    "mixed: no film after inlet heating": lambda: share(0.3e-6, film_factor=0.0),
    "mixed: friction at vanishing load": lambda: exponent(light_friction, 1e-12, 1e-9),
    "oil: 3.1 GPa": lambda: thickened(3.1e9),
    "oil: no piezoviscosity": lambda: thickened(3.1e9, alpha=0.0) / OIL.viscosity,
    "oil: a temperature in degrees Celsius": lambda: thickened(0.9e9, temperature=40.0),
    "oil: no sliding": lambda: shear(0.0) / 5.3e6,
    "oil: sliding at 1e-15 m/s": lambda: shear(1e-15) / 1e-15,
    "oil: 30 GPa": lambda: shear(0.02, pressure=30e9),
    "oil: pressed solid": lambda: shear(0.02, oil=replace(OIL, viscosity=1e4, pressure_viscosity=1e-7), pressure=7e9),
    "oil: neither film nor sliding": lambda: shear(0.0, film_thickness=0.0),
    "oiled torque: standstill": lambda: coefficient(speed=0.0) / BOUNDARY_FRICTION,
    "oiled torque: slow running": lambda: float(oiled(speed=1e-20).torque.total[0] / oiled(speed=0.0).torque.total[0]),
    "oiled torque: reversed rotation": lambda: float(
        oiled(speed=-31.0).torque.total[0] / oiled(speed=31.0).torque.total[0]
    ),
    "oiled torque: smooth races": lambda: max(
        float(values[0]) for values in vars(oiled(rms_roughness=0.0).asperity_share).values()
    ),
    "oiled torque: inlet shorter than the contact": lambda: coefficient(ahead=0.01, degree=5.0) / BOUNDARY_FRICTION,
    "oiled torque: inlet that ends at the contact": lambda: coefficient(degree=1.0) / BOUNDARY_FRICTION,
    "oiled torque: ellipse outside the film's fit": lambda: float(
        sum("contact ellipse outside the fitted shapes" in words for words in oiled(conformity=0.505).warnings)
    ),
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
