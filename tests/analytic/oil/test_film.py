"""The central film against the printed formula in 40 digits and another program."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given

from analytic.oil.film import (
    CentralFilm,
    central_film,
    density_ratio,
    inlet_heating_factor,
    shear_heat,
)
from tests.analytic.specimens import hertzian
from tests.validation.hard.lubrication_exact import film as printed_film

ROUND_OFF = 1e-13  # a few hundred roundings of a double
OIL = {"viscosity": 0.061, "pressure_viscosity": 2.1e-8}
CONTACT = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": 1.13e11,
    "entrainment_speed": 0.37,
}
loads = st.floats(-12, 6).map(lambda power: 10.0**power)
speeds = st.floats(-6, 2).map(lambda power: 10.0**power)
ratios = st.floats(0.01, 3.0)


def film(**changed: object) -> CentralFilm:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return central_film(contact, **rest)


@given(load=loads, speed=speeds, alpha=st.floats(1e-12, 5e-8), ratio=ratios)
def test_the_printed_formula_in_40_digits(load: float, speed: float, alpha: float, ratio: float) -> None:
    changed = {
        "load": load,
        "entrainment_speed": speed,
        "pressure_viscosity": alpha,
        "curvature_transverse": ratio * CONTACT["curvature_rolling"],
    }
    cap = 1 / (CONTACT["curvature_rolling"] + changed["curvature_transverse"])
    with mpmath.workdps(40):
        across = changed["curvature_transverse"]
        expected = float(printed_film(across=across, load=load, speed=speed, alpha=alpha))
    found = film(**changed)
    np.testing.assert_allclose(found.thickness, min(expected, cap), rtol=1e-12)  # round-off of ln h, some 30 at most
    assert found.capped == (expected > cap)


def test_the_density_of_oil_in_the_digits_given() -> None:
    """Values of another program; from 1 without pressure to 1.34 without end."""
    np.testing.assert_allclose(
        density_ratio([0.5e9, 1e9, 1.83e9, 2.18e9]), [1.15596, 1.21384, 1.25711, 1.26758], atol=6e-6
    )
    np.testing.assert_allclose(density_ratio([0.0, 1e30]), [1.0, 1.34], rtol=ROUND_OFF)


@given(load=loads, speed=speeds)
def test_compressible_oil_is_thinner_by_its_density_at_the_peak_pressure(load: float, speed: float) -> None:
    """p0^3 = 6 F E*^2/(pi^3 R^2) on a circle, which is Hertz's own; a full clearance stays full."""
    circle = {"curvature_transverse": 310.0, "load": load, "entrainment_speed": speed}
    plain, squeezed = film(**circle), film(**circle, compressible=True)
    peak = np.cbrt(6 * load * (1.13e11 * 310.0) ** 2 / np.pi**3)
    free = not (plain.capped or squeezed.capped)
    expected = plain.thickness / density_ratio(peak) if free else squeezed.thickness
    np.testing.assert_allclose(squeezed.thickness, expected, rtol=1e-12)
    assert squeezed.thickness <= plain.thickness


@pytest.mark.parametrize(("ratio", "outside"), [(0.029, True), (0.031, False), (0.99, False), (1.01, True)])
def test_an_ellipse_outside_the_fit_is_marked(ratio: float, outside: bool) -> None:
    found = film(curvature_transverse=ratio * CONTACT["curvature_rolling"])
    assert bool(found.outside_range) is outside
    np.testing.assert_allclose(found.ellipticity, ratio, rtol=ROUND_OFF)
    assert found.thickness > 0  # the formula still has a value


def test_inlet_heating() -> None:
    """About 2 % at the inner race of a 6205 at 500 rpm; the printed formula in 40 digits; its limits."""
    loading = shear_heat(0.06, 0.04, 0.49, 0.14)
    np.testing.assert_allclose(loading, 0.06 * 0.04 * 0.49**2 / 0.14, rtol=ROUND_OFF)
    factor = inlet_heating_factor(peak_pressure=2.18e9, modulus=1.13e11, thermal_loading=loading, slide_to_roll=0.0)
    assert 0.975 < factor < 0.985
    with mpmath.workdps(40):
        x = mpmath.mpf("3.7")
        top = 1 - mpmath.mpf("13.2") * (mpmath.mpf("1.9e9") / mpmath.mpf("2.26e11")) * x ** mpmath.mpf("0.42")
        slip = 1 + mpmath.mpf("2.23") * mpmath.mpf("0.31") ** mpmath.mpf("0.83")
        expected = float(top / (1 + mpmath.mpf("0.213") * slip * x ** mpmath.mpf("0.64")))
    arguments = {"peak_pressure": 1.9e9, "modulus": 1.13e11, "slide_to_roll": 0.31}
    np.testing.assert_allclose(inlet_heating_factor(thermal_loading=3.7, **arguments), expected, rtol=ROUND_OFF)
    assert inlet_heating_factor(thermal_loading=0.0, **arguments) == 1
    growing = inlet_heating_factor(thermal_loading=np.geomspace(1e-6, 1e4, 301), **arguments)
    assert np.all(np.diff(growing) <= 0)
    assert growing[-1] == 0
    slipping = inlet_heating_factor(thermal_loading=0.2, **(arguments | {"slide_to_roll": np.linspace(0, 2, 41)}))
    assert np.all(np.diff(slipping) < 0)
