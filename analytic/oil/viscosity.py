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

from functools import lru_cache
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import NotNegative, formula
from analytic.oil.law_table import law_address
from analytic.scene import Lubricant

LOG_POLE_VISCOSITY = -9.67  # ln of the viscosity in Pa s to which every oil tends
POLE_PRESSURE = 1 / 5.1e-9  # Pa
POLE_TEMPERATURE = 138.0  # K
MOST_THICKENING = 600.0  # in the logarithm: such an oil is solid


def require_liquid(**temperatures: ArrayLike) -> None:
    """Raise InputError unless every temperature is finite and above 138 K."""
    require_positive(**temperatures)
    for name, value in temperatures.items():
        if np.min(value) <= POLE_TEMPERATURE:
            raise InputError(
                f"{name} must be above {POLE_TEMPERATURE:g} K, where Roelands' oil is solid, got "
                f"{float(np.min(value))!r}; give it in K"
            )


def require_thick(**viscosities: ArrayLike) -> None:
    """Raise InputError unless every viscosity is finite and above 6.3e-5 Pa s."""
    require_positive(**viscosities)
    for name, value in viscosities.items():
        if np.min(np.log(value)) <= LOG_POLE_VISCOSITY:
            raise InputError(
                f"{name} must be above {np.exp(LOG_POLE_VISCOSITY):.2g} Pa s, the thinnest oil that "
                f"Roelands' formula knows, got {float(np.min(value))!r}; oils have 1e-3 to 10 Pa s"
            )


LiquidTemperature = Annotated[float, require_liquid]
OilViscosity = Annotated[float, require_thick]


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


@formula
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


@formula
def roelands_viscosity(
    pressure: NotNegative,
    temperature: LiquidTemperature,
    viscosity: OilViscosity,
    pressure_viscosity: NotNegative,
    reference_temperature: LiquidTemperature,
    viscosity_temperature: NotNegative,
) -> float:
    """eta(p, T), Pa s.

    pressure : p, Pa, >= 0;  temperature : T, K, > 138;  viscosity : eta_0, Pa s, > 6.3e-5
    pressure_viscosity : alpha_p, 1/Pa, >= 0;  viscosity_temperature : beta, 1/K, >= 0;  reference_temperature : T_0, K
        ln(eta) = -9.67 + G (1 + 5.1e-9 p)^Z [(T - 138)/(T_0 - 138)]^-S,  G = ln(eta_0) + 9.67
        Z = alpha_p/(5.1e-9 G),  S = beta (T_0 - 138)/G
    The formula fits mineral oils to about 1 GPa within their scatter and is extrapolated above. Z of an oil is 0.4 to
    0.8; with Z above 1 the viscosity would grow faster than by Barus's law.
    """
    exponent = pressure_viscosity * POLE_PRESSURE / (np.log(viscosity) - LOG_POLE_VISCOSITY)
    ambient, left = warmed(viscosity, viscosity_temperature, reference_temperature, temperature)
    return ambient * np.exp(thickening_at(pressure_viscosity * left, 0.0, exponent, pressure)[0])


@lru_cache(maxsize=64)
def oil_numbers(lubricant: Lubricant) -> OilNumbers:
    """A lubricant at its temperature in numbers, with Roelands' viscosity and its logarithmic slopes there.

    Raises InputError if a temperature is not above 138 K, the viscosity not above 6.3e-5 Pa s, or for a stress. A
    constant Eyring stress does not need the limiting shear, but that must have a meaning too.
    """
    require_thick(viscosity=lubricant.viscosity)
    require_liquid(temperature=lubricant.temperature, reference_temperature=lubricant.reference_temperature)
    for name in ("viscosity_temperature", "pressure_viscosity", "limiting_shear"):
        require_non_negative(**{name: getattr(lubricant, name)})
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
