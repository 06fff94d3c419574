"""Thick rings against the equation of equilibrium, thin rings, discs and plates."""

import numpy as np
import pytest
from scipy.integrate import solve_bvp

from analytic.errors import InputError
from analytic.mounting.thick_ring import ThickRing, fit_pressure
from analytic.scene import Material
from tests.contacts import STEEL

BRONZE = Material(name="bronze", youngs_modulus=110e9, poisson_ratio=0.34, density=8800.0, source="test")
EXACT = 1e-12  # closed forms, rounded a few times


def ring(inner: float, outer: float, material: Material = STEEL) -> ThickRing:
    return ThickRing(inner_radius=inner, outer_radius=outer, material=material)


@pytest.mark.parametrize(("inside", "outside"), [(37e6, 0.0), (0.0, 53e6), (41e6, 29e6)])
def test_displacement_against_the_equilibrium_of_a_ring(inside: float, outside: float) -> None:
    """d(r s_r)/dr = s_t with Hooke's law in plane stress, solved with the pressures as boundary values."""
    a, b = 12.5, 15.5  # mm; displacements in um, stresses in MPa
    young, poisson = BRONZE.youngs_modulus / 1e6, BRONZE.poisson_ratio

    def hoop(r: np.ndarray, y: np.ndarray) -> np.ndarray:
        return young * y[0] / 1e3 / r + poisson * y[1]  # y = (u, s_r)

    def slopes(r: np.ndarray, y: np.ndarray) -> np.ndarray:
        return np.stack([1e3 * (y[1] - poisson * hoop(r, y)) / young, (hoop(r, y) - y[1]) / r])

    def ends(at_a: np.ndarray, at_b: np.ndarray) -> np.ndarray:
        return np.array([at_a[1] + inside / 1e6, at_b[1] + outside / 1e6])

    radii = np.linspace(a, b, 41)
    found = solve_bvp(slopes, ends, radii, np.zeros((2, 41)), tol=1e-9, max_nodes=20_000)
    assert found.success
    body = ring(a / 1e3, b / 1e3, BRONZE)
    closed = [1e6 * body.displacement(r / 1e3, inside=inside, outside=outside) for r in radii]
    np.testing.assert_allclose(closed, found.sol(radii)[0], rtol=1e-7)  # the tolerance of the solver, times 100


def test_a_disc_is_compressed_alike_everywhere() -> None:
    strain, disc = -(1 - BRONZE.poisson_ratio) * 7e6 / BRONZE.youngs_modulus, ring(0.0, 0.0091, BRONZE)
    for radius in (0.002, 0.0091):
        np.testing.assert_allclose(disc.displacement(radius, outside=7e6), strain * radius, rtol=EXACT)


def test_a_plate_without_end_is_a_very_wide_ring() -> None:
    radius, pressure = 0.026, 9e6
    plate = ring(radius, np.inf).displacement(radius, inside=pressure)
    # The share of the wide ring's radii is squared: 1e-8.
    np.testing.assert_allclose(plate, ring(radius, 1e4 * radius).displacement(radius, inside=pressure), rtol=1e-7)
    np.testing.assert_allclose(plate, pressure * radius * 1.3 / STEEL.youngs_modulus, rtol=EXACT)


def test_a_fit_closes_the_interference() -> None:
    shaft, hub = ring(0.006, 0.0125), ring(0.0125, 0.0162, BRONZE)
    pressure = fit_pressure(shaft, hub, interference=17e-6)
    meeting = hub.displacement(0.0125, inside=pressure) - shaft.displacement(0.0125, outside=pressure)
    np.testing.assert_allclose(2 * meeting, 17e-6, rtol=EXACT)


def test_a_ring_on_a_solid_shaft_of_its_material_grows_with_its_bore_over_its_diameter() -> None:
    bore, diameter, interference = 0.025, 0.031, 12e-6
    shaft, hub = ring(0.0, bore / 2), ring(bore / 2, diameter / 2)
    pressure = fit_pressure(shaft, hub, interference=interference)
    known = STEEL.youngs_modulus * interference / bore * (1 - (bore / diameter) ** 2) / 2  # of text books
    np.testing.assert_allclose(pressure, known, rtol=EXACT)
    grown = 2 * hub.displacement(diameter / 2, inside=pressure)
    np.testing.assert_allclose(grown, interference * bore / diameter, rtol=EXACT)


def test_a_loose_fit_has_no_pressure() -> None:
    assert fit_pressure(ring(0.0, 0.01), ring(0.01, 0.013), interference=-3e-6) == 0


def test_rings_that_do_not_meet_are_refused() -> None:
    with pytest.raises(InputError, match="do not fit into each other"):
        fit_pressure(ring(0.0, 0.01), ring(0.011, 0.013), interference=3e-6)
