"""Viscosity of an oil under pressure and at temperature, by Roelands.

eta_0 is the viscosity at ambient pressure and the reference temperature T_0; alpha_p = d ln(eta)/dp and
beta = -d ln(eta)/dT are its logarithmic slopes there. Barus's eta_0 exp(alpha_p p) has the same slope, but departs from
measured oils above some 0.5 GPa. Beyond 1 GPa, where races work, it is unphysical, so it is not offered.
Source: [Roelands1966].
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.scene import Array, Lubricant

LOG_POLE_VISCOSITY = -9.67  # ln of the viscosity in Pa s to which every oil tends
POLE_PRESSURE = 1 / 5.1e-9  # Pa
POLE_TEMPERATURE = 138.0  # K


@dataclass(frozen=True, kw_only=True)
class InletViscosity:
    """The oil at the inlet's temperature and ambient pressure, as the film formula needs it."""

    viscosity: float  # eta_0, Pa s
    pressure_viscosity: float  # alpha_p, 1/Pa
    viscosity_temperature: float  # beta, 1/K


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
    log_factor, shift = _thermal(
        temperature=temperature,
        viscosity=viscosity,
        reference_temperature=reference_temperature,
        viscosity_temperature=viscosity_temperature,
    )
    require_non_negative(pressure_viscosity=pressure_viscosity)
    exponent = np.asarray(pressure_viscosity) * POLE_PRESSURE / log_factor
    return np.asarray(viscosity) * _thickening(np.asarray(pressure), log_factor, exponent, shift)


def pressure_thickening(lubricant: Lubricant) -> tuple[float, float]:
    """(growth, exponent) of ln(eta(p)/eta(0)) = growth [(1 + 5.1e-9 p)^exponent - 1] at the lubricant's temperature.

    growth = G [(T - 138)/(T_0 - 138)]^-S and exponent = Z of `roelands_viscosity`. Raises as `inlet_viscosity` does.
    """
    log_factor, shift = _thermal(
        temperature=lubricant.temperature,
        viscosity=lubricant.viscosity,
        reference_temperature=lubricant.reference_temperature,
        viscosity_temperature=lubricant.viscosity_temperature,
    )
    require_non_negative(pressure_viscosity=lubricant.pressure_viscosity)
    return float(log_factor * np.exp(shift)), float(lubricant.pressure_viscosity * POLE_PRESSURE / log_factor)


def inlet_viscosity(lubricant: Lubricant) -> InletViscosity:
    """The oil as it enters a contact: Roelands' viscosity and its logarithmic slopes at the lubricant's temperature.

    Raises InputError if a temperature is not above 138 K or the viscosity not above 6.3e-5 Pa s.
    """
    log_factor, shift = _thermal(
        temperature=lubricant.temperature,
        viscosity=lubricant.viscosity,
        reference_temperature=lubricant.reference_temperature,
        viscosity_temperature=lubricant.viscosity_temperature,
    )
    cooling = float(np.exp(shift))  # both slopes follow ln(eta) + 9.67
    distances = (lubricant.reference_temperature - POLE_TEMPERATURE) / (lubricant.temperature - POLE_TEMPERATURE)
    return InletViscosity(
        viscosity=lubricant.viscosity * float(np.exp(log_factor * np.expm1(shift))),
        pressure_viscosity=lubricant.pressure_viscosity * cooling,
        viscosity_temperature=lubricant.viscosity_temperature * cooling * distances,
    )


def _thickening(pressure: Array, log_factor: Array, exponent: Array | float, shift: Array) -> Array:
    """eta/eta_0 = exp(G ((1 + 5.1e-9 p)^Z [(T - 138)/(T_0 - 138)]^-S - 1))."""
    # expm1 keeps the digits of the factor where pressure and heating are small.
    growth = log_factor * np.expm1(exponent * np.log1p(pressure / POLE_PRESSURE) + shift)
    with np.errstate(over="ignore"):  # large Z under very large pressure: the oil does not flow
        return np.exp(growth)


def _thermal(
    *,
    temperature: ArrayLike,
    viscosity: ArrayLike,
    reference_temperature: ArrayLike,
    viscosity_temperature: ArrayLike,
) -> tuple[Array, Array]:
    """G = ln(eta_0) + 9.67 and -S ln[(T - 138)/(T_0 - 138)]."""
    require_positive(viscosity=viscosity)
    require_non_negative(viscosity_temperature=viscosity_temperature)
    for name, value in {"temperature": temperature, "reference_temperature": reference_temperature}.items():
        require_positive(**{name: value})
        if np.min(value) <= POLE_TEMPERATURE:
            raise InputError(
                f"{name} must be above {POLE_TEMPERATURE:g} K, where Roelands' oil is solid, got "
                f"{float(np.min(value))!r}; give it in K"
            )
    log_factor = np.log(viscosity) - LOG_POLE_VISCOSITY
    if np.min(log_factor) <= 0:
        raise InputError(
            f"viscosity must be above {np.exp(LOG_POLE_VISCOSITY):.2g} Pa s, the thinnest oil that "
            f"Roelands' formula knows, got {float(np.min(viscosity))!r}; oils have 1e-3 to 10 Pa s"
        )
    distance = np.asarray(reference_temperature) - POLE_TEMPERATURE
    slope = np.asarray(viscosity_temperature) * distance / log_factor
    return log_factor, -slope * np.log((np.asarray(temperature) - POLE_TEMPERATURE) / distance)
