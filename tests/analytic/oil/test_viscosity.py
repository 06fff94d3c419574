"""Roelands' viscosity against the printed formula in 40 digits and the slopes that define its constants."""

from typing import Any

import hypothesis.strategies as st
import mpmath
import numpy as np
from hypothesis import given

from analytic.oil.viscosity import oil_numbers, roelands_viscosity
from analytic.scene import Lubricant

ETA, ALPHA, BETA, T0 = 0.061, 2.1e-8, 0.043, 311.0
OIL: dict[str, Any] = {
    "viscosity": ETA,
    "pressure_viscosity": ALPHA,
    "viscosity_temperature": BETA,
    "reference_temperature": T0,
}
ROUND_OFF = 1e-12  # ln(eta) reaches 30, and its rounding is the viscosity's


def viscosity(pressure: object, temperature: object, **changed: object) -> np.ndarray:
    return roelands_viscosity(pressure=pressure, temperature=temperature, **(OIL | changed))  # pyright: ignore


def printed(p: mpmath.mpf, t: mpmath.mpf) -> mpmath.mpf:
    q = mpmath.mpf
    g = mpmath.log(q(ETA)) + q("9.67")
    z, s = q(ALPHA) / (q("5.1e-9") * g), q(BETA) * (q(T0) - 138) / g
    return mpmath.exp(-q("9.67") + g * (1 + q("5.1e-9") * p) ** z * ((t - 138) / (q(T0) - 138)) ** -s)


@given(pressure=st.floats(0, 4e9), temperature=st.floats(250, 450))
def test_the_printed_formula_in_40_digits(pressure: float, temperature: float) -> None:
    with mpmath.workdps(40):
        expected = float(printed(mpmath.mpf(pressure), mpmath.mpf(temperature)))
    np.testing.assert_allclose(viscosity(pressure, temperature), expected, rtol=ROUND_OFF)


def test_the_slopes_are_alpha_and_beta() -> None:
    """The constants are defined by them."""
    assert viscosity(0.0, T0) == ETA
    step = 1e3  # Pa: what is left of the second derivative is alpha 5.1e-9 step/2
    np.testing.assert_allclose(np.log(viscosity(step, T0) / ETA) / step, ALPHA, rtol=1e-5)
    np.testing.assert_allclose(np.log(viscosity(0.0, T0 + 1e-3) / ETA) / 1e-3, -BETA, rtol=1e-4)


def test_the_oil_at_the_inlet() -> None:
    """Viscosity and both slopes at another temperature, against differences of the formula there."""
    oil = Lubricant(
        **OIL, supply="grease", temperature=347.0, thermal_conductivity=0.13, density=860.0, eyring_stress=5e6,
        limiting_shear=0.07, traction="eyring_sinh",
    )  # fmt: skip
    found = oil_numbers(oil)
    np.testing.assert_allclose(found.viscosity, viscosity(0.0, 347.0), rtol=ROUND_OFF)
    with mpmath.workdps(40):
        t = mpmath.mpf(347)
        by_pressure = mpmath.diff(lambda p: mpmath.log(printed(p, t)), 0, direction=1, h=1e-6)
        by_temperature = mpmath.diff(lambda x: mpmath.log(printed(mpmath.mpf(0), x)), t)
    np.testing.assert_allclose(found.pressure_viscosity, float(by_pressure), rtol=1e-9)
    np.testing.assert_allclose(found.viscosity_temperature, -float(by_temperature), rtol=1e-9)
    assert found.pressure_viscosity < ALPHA
    assert found.viscosity < ETA
