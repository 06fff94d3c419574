"""Stresses under a Hertzian contact against the integral of Boussinesq's point loads, and against known limits."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given
from scipy.integrate import dblquad

from analytic.contact.subsurface import AxisStress, SubsurfaceMaximum, axis_stress, subsurface_maximum

P0, A, B, NU = 2.31e9, 0.121e-3, 0.87e-3, 0.27  # Pa, m, m
FIELDS = ("sigma_x", "sigma_y", "sigma_z")
ROUND_OFF = 1e-13  # a few hundred roundings of a double


def stress(depth: float | np.ndarray, **changed: float | np.ndarray) -> AxisStress:
    given = {"depth": depth, "peak_pressure": P0, "semi_axis_x": A, "semi_axis_y": B, "poisson_ratio": NU} | changed
    return axis_stress(**{name: np.asarray(value) for name, value in given.items()})


def maximum(**changed: float | list[float]) -> SubsurfaceMaximum:
    return subsurface_maximum(
        **{"peak_pressure": P0, "semi_axis_x": A, "semi_axis_y": B, "poisson_ratio": NU} | changed
    )


def integrated(depth: float, *, a: float, b: float, ratio: float) -> np.ndarray:
    """sigma_x, sigma_y, sigma_z on the axis under the semi-ellipsoid, in units of its peak, by quadrature.

    Point loads by Boussinesq, [Johnson1985] section 3.2. In polar coordinates about the axis with
    r = R(direction) sin(t), neither the centre nor the edge of the pressure is singular.
    """

    def part(kernel: int, t: float, direction: float) -> float:
        c, s = np.cos(direction) ** 2, np.sin(direction) ** 2
        edge = 1 / np.sqrt(c / a**2 + s / b**2)
        r = edge * np.sin(t)
        rho = np.hypot(r, depth)
        if kernel == 1:
            c, s = s, c
        if kernel == 2:
            point = -3 * depth**3 / rho**5
        else:
            surface = (c - s) / (rho * (rho + depth)) + depth * s / rho**3
            point = (1 - 2 * ratio) * surface - 3 * depth * r**2 * c / rho**5
        return point / (2 * np.pi) * np.cos(t) * r * edge * np.cos(t)  # pressure, and r dr

    return np.array(
        [4 * dblquad(lambda t, d, k=k: part(k, t, d), 0, np.pi / 2, 0, np.pi / 2, epsabs=1e-9)[0] for k in range(3)]
    )


def line(z: np.ndarray, ratio: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The same under a line in the direction of y, z in half-widths: [Johnson1985] section 4.2(a)."""
    root = np.hypot(1, z)
    sigma_x, sigma_z = -((1 + 2 * z**2) / root - 2 * z), -1 / root
    return sigma_x, ratio * (sigma_x + sigma_z), sigma_z


@pytest.mark.parametrize("depth", [0.047e-3, 0.093e-3, 0.41e-3])
@pytest.mark.parametrize(("a", "b"), [(A, B), (0.34e-3, 0.211e-3)])
@pytest.mark.parametrize("ratio", [NU, 0.5, 0.0])
def test_stresses_are_the_sum_of_point_loads(depth: float, a: float, b: float, ratio: float) -> None:
    found = stress(depth, semi_axis_x=a, semi_axis_y=b, poisson_ratio=ratio)
    summed = integrated(depth, a=a, b=b, ratio=ratio)
    for name, expected in zip(FIELDS, summed, strict=True):
        np.testing.assert_allclose(getattr(found, name) / P0, expected, atol=1e-8)  # ten times the quadrature's


def test_stresses_keep_their_digits() -> None:
    """Against the defining integrals in 30 digits, from a circle to 1 : 50 and a thousandth to 50 minor axes deep."""
    for b, z in ((A, 0.07e-3), (A * (1 + 1e-12), 0.07e-3), (50 * A, 0.12e-6), (50 * A, 0.095e-3), (50 * A, 6.0e-3)):
        with mpmath.workdps(30):
            aa, bb, zz = mpmath.sqrt(mpmath.mpf(A) ** 2 + z**2), mpmath.sqrt(mpmath.mpf(b) ** 2 + z**2), mpmath.mpf(z)
            x_part = 2 / mpmath.mpf(3) * zz * mpmath.elliprd(bb**2, zz**2, aa**2)
            y_part = 2 / mpmath.mpf(3) * zz * mpmath.elliprd(aa**2, zz**2, bb**2)
            rest = 2 * mpmath.mpf(NU) / (aa * bb) + (1 - 2 * mpmath.mpf(NU)) / (aa * (aa + bb))
            expected = float(mpmath.mpf(A) * b * (x_part + NU * y_part - rest))
        found = stress(z, semi_axis_y=b)
        np.testing.assert_allclose(found.sigma_x / P0, expected, atol=20 * np.finfo(float).eps)


@pytest.mark.parametrize(
    ("ratio", "shear", "depth"), [(1.0, 0.310, 0.481), (1e6, 0.3003, 0.7862)], ids=["circle", "line"]
)
def test_published_maxima(ratio: float, shear: float, depth: float) -> None:
    """nu = 0.3, text-book numbers to the digits printed there."""
    found = maximum(semi_axis_y=ratio * A, poisson_ratio=0.3)
    np.testing.assert_allclose(found.max_shear / P0, shear, atol=5e-4 if ratio == 1 else 5e-5)
    np.testing.assert_allclose(found.max_shear_depth / A, depth, atol=5e-4 if ratio == 1 else 5e-5)


@given(ratio=st.floats(-0.9, 0.5), elongation=st.floats(-6, 6).map(np.exp), place=st.floats(0, 3))
def test_no_depth_has_more_than_the_maximum(ratio: float, elongation: float, place: float) -> None:
    b = elongation * A
    found = maximum(semi_axis_y=b, poisson_ratio=ratio)
    here = stress(place * min(A, b), semi_axis_y=b, poisson_ratio=ratio)
    assert here.max_shear <= found.max_shear * (1 + ROUND_OFF)
    assert here.von_mises <= found.max_von_mises * (1 + ROUND_OFF)
    at = stress(float(found.max_shear_depth), semi_axis_y=b, poisson_ratio=ratio)
    np.testing.assert_allclose(at.max_shear, found.max_shear, rtol=ROUND_OFF)
    at = stress(float(found.max_von_mises_depth), semi_axis_y=b, poisson_ratio=ratio)
    np.testing.assert_allclose(at.von_mises, found.max_von_mises, rtol=ROUND_OFF)


def test_low_poisson_ratio_brings_the_maximum_under_a_line_to_the_surface() -> None:
    """At 0.1 the shear between sigma_y and sigma_z is the larger one; at 0.3 it is that with sigma_x."""
    z = np.linspace(0, 1, 100_001)
    _, sigma_y, sigma_z = line(z, 0.1)
    shear = (sigma_y - sigma_z) / 2
    low, high = (maximum(semi_axis_y=1e6 * A, poisson_ratio=ratio) for ratio in (0.1, 0.3))
    np.testing.assert_allclose(low.max_shear / P0, shear.max(), rtol=1e-5)  # ends are felt as 1/k
    np.testing.assert_allclose(low.max_shear_depth / A, z[np.argmax(shear)], atol=2e-5)  # the step
    assert low.max_shear_depth < 0.2 * A < 0.7 * A < high.max_shear_depth
    assert maximum(semi_axis_y=1e9 * A, poisson_ratio=-0.2).max_shear_depth == 0  # only the surface is left
