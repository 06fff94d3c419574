"""Viscosity of an oil under pressure and at temperature.

eta_0 is the viscosity at ambient pressure and the reference temperature T_0; alpha_p = d ln(eta)/dp and
beta = -d ln(eta)/dT are its logarithmic slopes there. Over the temperature eta_0 follows [Roelands1966]. Under
pressure, as far as the oil shears,
    modulus equation: ln(eta/eta_0) = p/(A + B p),  A = 1/alpha_p, B = b1 + b2 T
    Roelands: ln(eta/eta_0) = G [(1 + 5.1e-9 p)^Z - 1],  G = ln(eta_0) + 9.67, Z = alpha_p/(5.1e-9 G)
Both have the slope alpha_p at ambient pressure, which is all that films ask for. The modulus equation was fitted to
measured viscosities up to 0.4 to 0.8 GPa [Arana2019], [Schwarz2023] and is extrapolated above; Roelands' fits mineral
oils to about 1 GPa within their scatter, and is 2.6 times too thin for M100 at 0.7 GPa and 60 degC. Barus's
eta_0 exp(alpha_p p) departs from measured oils above some 0.5 GPa and is not offered.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.oil.law_table import law_address
from analytic.scene import Array, Lubricant

LOG_POLE_VISCOSITY = -9.67  # ln of the viscosity in Pa s to which every oil tends
POLE_PRESSURE = 1 / 5.1e-9  # Pa
POLE_TEMPERATURE = 138.0  # K
MOST_THICKENING = 600.0  # in the logarithm: such an oil is solid


@dataclass(frozen=True, kw_only=True)
class InletViscosity:
    """The oil at the inlet's temperature and ambient pressure, as the film formula needs it."""

    viscosity: float  # eta_0, Pa s
    pressure_viscosity: float  # alpha_p, 1/Pa
    viscosity_temperature: float  # beta, 1/K


class OilNumbers(NamedTuple):
    """An oil at one temperature, for compiled formulas; `oil_at` makes another temperature of it."""

    temperature: float  # K
    viscosity: float  # eta at ambient pressure, Pa s
    pressure_viscosity: float  # alpha_p, 1/Pa
    viscosity_temperature: float  # beta, 1/K
    exponent: float  # Z of Roelands under pressure; 0: the modulus equation
    rise: float  # B of the modulus equation
    rise_slope: float  # b2, 1/K
    thermal_conductivity: float  # k_f, W/(m K)
    density: float  # kg/m^3
    eyring_stress: float  # tau_E at any pressure, Pa; 0: it follows from the limiting shear
    limiting_shear: float  # Lambda
    constant_stress: bool  # it shears at tau_E, whatever the speed
    compressible: bool
    own: float  # address of the table of a user's law of traction, see `analytic.oil.law_table`; 0: none


@compiled
def thickening_at(alpha: float, bend: float, exponent: float, pressure: float) -> tuple[float, float]:
    """ln(eta(p)/eta(0)), and the slope alpha over the secant ln(eta(p)/eta(0))/p.

    alpha : d ln(eta)/dp at ambient pressure, 1/Pa;  bend : B alpha of the modulus equation, 1/Pa
    exponent : Z of Roelands, 0 for the modulus equation;  pressure : p, Pa, >= 0
    The logarithm is at most MOST_THICKENING, which it also has where the modulus A + B p has fallen to 0 and below.
    """
    barus = alpha * pressure
    if exponent == 0.0:
        over = 1.0 + bend * pressure
        return (barus / over, over) if MOST_THICKENING * over > barus else (MOST_THICKENING, barus / MOST_THICKENING)
    # expm1 keeps the digits where the pressure is small.
    log = alpha * POLE_PRESSURE / exponent * np.expm1(exponent * np.log1p(pressure / POLE_PRESSURE))
    log = min(log, MOST_THICKENING)
    return log, barus / log if log > 0.0 else 1.0


@compiled
def warmed(viscosity: float, viscosity_temperature: float, before: float, temperature: float) -> tuple[float, float]:
    """eta at another temperature, and ln(eta) + 9.67 there over that before; ambient pressure.

    viscosity, viscosity_temperature : eta and beta at the temperature before, K
    """
    growth = np.log(viscosity) - LOG_POLE_VISCOSITY
    slope = viscosity_temperature * (before - POLE_TEMPERATURE) / growth  # S
    shift = -slope * np.log((temperature - POLE_TEMPERATURE) / (before - POLE_TEMPERATURE))
    return viscosity * np.exp(growth * np.expm1(shift)), np.exp(shift)


@compiled
def oil_at(oil: OilNumbers, temperature: float) -> OilNumbers:
    """The oil at another temperature, K, by Roelands: its viscosity and its slopes; the rest is taken as constant."""
    viscosity, left = warmed(oil.viscosity, oil.viscosity_temperature, oil.temperature, temperature)
    distances = (oil.temperature - POLE_TEMPERATURE) / (temperature - POLE_TEMPERATURE)
    return OilNumbers(
        temperature,
        viscosity,
        oil.pressure_viscosity * left,  # both slopes follow ln(eta) + 9.67
        oil.viscosity_temperature * left * distances,
        oil.exponent,
        oil.rise + oil.rise_slope * (temperature - oil.temperature),
        oil.rise_slope,
        oil.thermal_conductivity,
        oil.density,
        oil.eyring_stress,
        oil.limiting_shear,
        oil.constant_stress,
        oil.compressible,
        oil.own,
    )


@compiled
def _viscosity_at(
    pressure: float, temperature: float, viscosity: float, alpha: float, reference: float, beta: float
) -> float:
    exponent = alpha * POLE_PRESSURE / (np.log(viscosity) - LOG_POLE_VISCOSITY)
    ambient, left = warmed(viscosity, beta, reference, temperature)
    return ambient * np.exp(thickening_at(alpha * left, 0.0, exponent, pressure)[0])


def roelands_viscosity(
    *,
    pressure: ArrayLike,
    temperature: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    reference_temperature: ArrayLike,
    viscosity_temperature: ArrayLike,
) -> Array:
    """eta(p, T), Pa s; the arguments broadcast.

    pressure : p, Pa, >= 0;  temperature : T, K, > 138;  viscosity : eta_0, Pa s, > 6.3e-5
    pressure_viscosity : alpha_p, 1/Pa, >= 0;  viscosity_temperature : beta, 1/K, >= 0;  reference_temperature : T_0, K
        ln(eta) = -9.67 + G (1 + 5.1e-9 p)^Z [(T - 138)/(T_0 - 138)]^-S,  G = ln(eta_0) + 9.67
        Z = alpha_p/(5.1e-9 G),  S = beta (T_0 - 138)/G
    The formula fits mineral oils to about 1 GPa within their scatter and is extrapolated above. Z of an oil is 0.4 to
    0.8; with Z above 1 the viscosity would grow faster than by Barus's law.
    """
    require_non_negative(pressure=pressure)
    _require_liquid(
        temperature=temperature,
        viscosity=viscosity,
        reference_temperature=reference_temperature,
        viscosity_temperature=viscosity_temperature,
    )
    require_non_negative(pressure_viscosity=pressure_viscosity)
    others = pressure_viscosity, reference_temperature, viscosity_temperature
    return mapped(_viscosity_at, pressure, temperature, viscosity, *others)


@lru_cache(maxsize=64)
def oil_numbers(lubricant: Lubricant) -> OilNumbers:
    """A lubricant at its temperature in numbers. Raises InputError as `inlet_viscosity` does, or for a stress.

    A constant Eyring stress does not need the limiting shear, but that must have a meaning too.
    """
    _require_liquid(
        temperature=lubricant.temperature,
        viscosity=lubricant.viscosity,
        reference_temperature=lubricant.reference_temperature,
        viscosity_temperature=lubricant.viscosity_temperature,
    )
    require_non_negative(pressure_viscosity=lubricant.pressure_viscosity, limiting_shear=lubricant.limiting_shear)
    require_positive(thermal_conductivity=lubricant.thermal_conductivity, density=lubricant.density)
    stress = lubricant.eyring_stress
    if stress is not None:
        require_positive(eyring_stress=stress)
    elif lubricant.traction == "eyring_constant":
        raise InputError(
            'eyring_stress is missing: an oil with traction = "eyring_constant" shears at this stress at any speed; '
            'give for example 5e6 Pa, or traction = "eyring_sinh"'
        )
    growth = float(np.log(lubricant.viscosity)) - LOG_POLE_VISCOSITY
    exponent, (rise, rise_slope) = lubricant.pressure_viscosity * POLE_PRESSURE / growth, lubricant.modulus_rise
    reference = OilNumbers(
        temperature=float(lubricant.reference_temperature),
        viscosity=float(lubricant.viscosity),
        pressure_viscosity=float(lubricant.pressure_viscosity),
        viscosity_temperature=float(lubricant.viscosity_temperature),
        exponent=float(exponent) if lubricant.thickening == "roelands" else 0.0,
        rise=float(rise + rise_slope * lubricant.reference_temperature),
        rise_slope=float(rise_slope),
        thermal_conductivity=float(lubricant.thermal_conductivity),
        density=float(lubricant.density),
        eyring_stress=0.0 if stress is None else float(stress),
        limiting_shear=float(lubricant.limiting_shear),
        constant_stress=lubricant.traction == "eyring_constant",
        compressible=bool(lubricant.compressible),
        own=law_address(lubricant.traction),
    )
    return oil_at(reference, float(lubricant.temperature))


def viscosity_under_pressure(lubricant: Lubricant, *, pressure: ArrayLike) -> Array:
    """eta(p), Pa s, of a lubricant at its temperature by its law of thickening.

    pressure : p, Pa, >= 0, any shape. Raises InputError as `oil_numbers`.
    """
    require_non_negative(pressure=pressure)
    oil = oil_numbers(lubricant)
    slopes = oil.pressure_viscosity, oil.rise * oil.pressure_viscosity, oil.exponent
    return oil.viscosity * np.exp(mapped(thickening_at, *slopes, pressure)[0])


def inlet_viscosity(lubricant: Lubricant) -> InletViscosity:
    """The oil as it enters a contact: Roelands' viscosity and its logarithmic slopes at the lubricant's temperature.

    Raises InputError if a temperature is not above 138 K or the viscosity not above 6.3e-5 Pa s.
    """
    oil = oil_numbers(lubricant)
    return InletViscosity(
        viscosity=oil.viscosity,
        pressure_viscosity=oil.pressure_viscosity,
        viscosity_temperature=oil.viscosity_temperature,
    )


def _require_liquid(
    *,
    temperature: ArrayLike,
    viscosity: ArrayLike,
    reference_temperature: ArrayLike,
    viscosity_temperature: ArrayLike,
) -> None:
    require_positive(viscosity=viscosity)
    require_non_negative(viscosity_temperature=viscosity_temperature)
    for name, value in {"temperature": temperature, "reference_temperature": reference_temperature}.items():
        require_positive(**{name: value})
        if np.min(value) <= POLE_TEMPERATURE:
            raise InputError(
                f"{name} must be above {POLE_TEMPERATURE:g} K, where Roelands' oil is solid, got "
                f"{float(np.min(value))!r}; give it in K"
            )
    if np.min(np.log(viscosity)) <= LOG_POLE_VISCOSITY:
        raise InputError(
            f"viscosity must be above {np.exp(LOG_POLE_VISCOSITY):.2g} Pa s, the thinnest oil that "
            f"Roelands' formula knows, got {float(np.min(viscosity))!r}; oils have 1e-3 to 10 Pa s"
        )
