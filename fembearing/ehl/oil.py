"""Viscosity and density of the oil under pressure, with their slopes, as the Reynolds equation needs them.

Sources: [Roelands1966] for viscosity, C. Barus's exponential law as its limit of small pressure, and [Dowson1966] for
density.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array

LOG_POLE_VISCOSITY = -9.67  # ln of the viscosity in Pa s to which every oil tends
POLE_PRESSURE = 1 / 5.1e-9  # Pa
STIFFENING, MOST_DENSE = 5.9e8, 1.34  # Pa; density under endless pressure over that at ambient pressure


@dataclass(frozen=True, kw_only=True)
class Oil:
    """An oil at the temperature of the inlet."""

    viscosity: float  # eta_0, at ambient pressure, Pa s
    pressure_viscosity: float  # alpha, d ln(eta)/dp at ambient pressure, 1/Pa
    law: Literal["roelands", "barus"] = "roelands"  # of viscosity over pressure
    compressible: bool = True
    cavitation_pressure: float = 0.0  # p_cav over ambient pressure, Pa, <= 0

    def __post_init__(self) -> None:
        require_positive(viscosity=self.viscosity)
        require_non_negative(pressure_viscosity=self.pressure_viscosity)
        require_finite(cavitation_pressure=self.cavitation_pressure)
        if self.cavitation_pressure > 0:
            raise InputError(
                f"cavitation_pressure must be at most ambient pressure, 0 Pa, got {self.cavitation_pressure:g} Pa; "
                "give it relative to ambient pressure, -100 kPa for oil that stands no tension"
            )

    def log_viscosity(self, pressure: Array, *, share: float = 1.0) -> tuple[Array, Array]:
        """Logarithm of the viscosity over that at ambient pressure, with its slope.

        Parameters
        ----------
        pressure : ndarray, any shape
            p over ambient pressure, Pa, above -1.9e8.
        share : float
            Factor on both, 0 to 1, dimensionless, by which a solution approaches the oil from a softer one.

        Returns
        -------
        tuple of ndarray
            ln(eta/eta_0), dimensionless, and its derivative by p, 1/Pa, each of the shape of pressure.

        Notes
        -----
        ln(eta/eta_0) = G [(1 + 5.1e-9 p)^Z - 1], G = ln(eta_0) + 9.67, Z = alpha/(5.1e-9 G); Barus: alpha p.
        """
        if self.law == "barus":
            slope = share * self.pressure_viscosity
            return slope * pressure, np.full_like(pressure, slope)
        growth = np.log(self.viscosity) - LOG_POLE_VISCOSITY
        exponent = self.pressure_viscosity * POLE_PRESSURE / growth
        ratio = np.log1p(pressure / POLE_PRESSURE)
        slope = share * self.pressure_viscosity * np.exp((exponent - 1) * ratio)
        return share * growth * np.expm1(exponent * ratio), slope

    def density(self, pressure: Array) -> tuple[Array, Array]:
        """Density over that at ambient pressure, 1 + 0.34 p/(5.9e8 Pa + p), with its slope.

        Parameters
        ----------
        pressure : ndarray, any shape
            p over ambient pressure, Pa.

        Returns
        -------
        tuple of ndarray
            rho/rho_0, dimensionless, and its derivative by p, 1/Pa, each of the shape of pressure.
        """
        if not self.compressible:
            return np.ones_like(pressure), np.zeros_like(pressure)
        stiff = STIFFENING + pressure
        return 1 + (MOST_DENSE - 1) * pressure / stiff, (MOST_DENSE - 1) * STIFFENING / stiff**2
