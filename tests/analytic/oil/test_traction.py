"""Laws of traction: the printed formula in 40 digits, its limits, and what may never happen."""

from dataclasses import replace
from functools import partial
from typing import Any

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given

from analytic.errors import InputError
from analytic.oil.film import Inflow, asymptotes_of
from analytic.oil.mixed import mixed_contact
from analytic.oil.traction import law_of_oil, mean_force, mixed_traction, oil_shear_stress, stress_and_slope
from analytic.oil.viscosity import oil_numbers
from analytic.surface.gap import gap_law
from analytic.surface.roughness import gap_roughness
from tests.analytic import specimens
from tests.analytic.specimens import rolling_contact
from tests.contacts import STEEL
from tests.refusals import refused, refuses

OIL = replace(specimens.OIL, temperature=329.0)


def shear(pressure: object, speed: object, film: object, **changed: object) -> np.ndarray:
    oil = replace(OIL, **changed)  # pyright: ignore[reportArgumentType]
    return oil_shear_stress(oil_numbers(oil), pressure=pressure, speed=speed, film_thickness=film)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(("p", "v", "h"), [(0.31e9, 1.7e-3, 0.21e-6), (0.7e9, 2.3e-5, 40e-9), (1e5, 0.9, 80e-9)])
def test_a_given_stress_with_roelands_viscosity_in_40_digits(p: float, v: float, h: float) -> None:
    with mpmath.workdps(40):
        q = mpmath.mpf
        g = mpmath.log(q(0.043)) + q("9.67")
        growth = (1 + q("5.1e-9") * q(p)) ** (q(1.9e-8) / (q("5.1e-9") * g))
        cooling = ((q(329) - 138) / (q(313.15) - 138)) ** (-q(0.04) * (q(313.15) - 138) / g)
        viscosity = mpmath.exp(q("-9.67") + g * growth * cooling)
        free = q(4.7e6) * mpmath.asinh(viscosity * q(v) / (q(h) * q(4.7e6)))
        expected = float(min(free, q(0.06) * q(p)))
    # round-off through exp of some 20
    np.testing.assert_allclose(shear(p, v, h, thickening="roelands"), expected, rtol=1e-12)


@pytest.mark.parametrize(("p", "v", "h"), [(0.31e9, 1.7e-3, 0.21e-6), (1.9e9, 2.3e-7, 40e-9), (1e5, 0.9, 80e-9)])
@pytest.mark.parametrize("rise", [(-68.2e-3, 27.68e-5), (5e-3, -1.83e-5)])
def test_the_law_of_its_source_in_40_digits(p: float, v: float, h: float, rise: tuple[float, float]) -> None:
    """Equations 12 and 13 of [Arana2019] with its modulus equation, both at the pressure of the point."""
    with mpmath.workdps(40):
        q = mpmath.mpf
        g = mpmath.log(q(0.043)) + q("9.67")
        cooling = ((q(329) - 138) / (q(313.15) - 138)) ** (-q(0.04) * (q(313.15) - 138) / g)
        ambient = mpmath.exp(q("-9.67") + g * cooling)
        alpha = 1 / (1 / (q(1.9e-8) * cooling) + (q(rise[0]) + q(rise[1]) * 329) * q(p))
        slow = (
            2 * q(0.06) / alpha * mpmath.asinh(ambient * mpmath.exp(alpha * q(p)) * alpha * q(v) / (2 * q(0.06) * q(h)))
        )
        expected = float(min(slow, q(0.06) * q(p)))
    found = shear(p, v, h, eyring_stress=None, modulus_rise=rise)
    np.testing.assert_allclose(found, expected, rtol=1e-12)  # round-off through exp of some 20


def test_at_low_pressure_it_is_the_law_with_the_coefficient_at_ambient_pressure_and_fast_the_limit() -> None:
    speeds = np.array([1e-9, 3e-4, 0.07])
    at_ambient = 2 * OIL.limiting_shear / oil_numbers(OIL).pressure_viscosity
    light = 2e4  # Pa: A + B p differs from A by 1e-5
    found = shear(light, speeds, 70e-9, eyring_stress=None)
    np.testing.assert_allclose(found, shear(light, speeds, 70e-9, eyring_stress=at_ambient), rtol=1e-4)
    np.testing.assert_allclose(shear(1.4e9, 0.3, 70e-9, eyring_stress=None), 0.06 * 1.4e9, rtol=1e-15)
    assert shear(0.0, 0.3, 70e-9, eyring_stress=None) == 0


def test_an_oil_that_does_not_thicken_is_newtonian_up_to_its_limit() -> None:
    thin = {"pressure_viscosity": 0.0, "eyring_stress": None}
    viscosity = oil_numbers(OIL).viscosity
    np.testing.assert_allclose(shear(0.9e9, 1e-5, 0.2e-6, **thin), viscosity * 1e-5 / 0.2e-6, rtol=1e-12)
    np.testing.assert_allclose(shear(0.9e9, 1e4, 0.2e-6, **thin), 0.06 * 0.9e9, rtol=1e-15)


def test_a_constant_stress_depends_on_nothing_and_without_a_film_oil_shears_at_its_limit() -> None:
    constant = shear(np.array([0.0, 2e9]), np.array([[0.0], [0.4]]), 1e-7, traction="eyring_constant")
    np.testing.assert_array_equal(constant, np.full((2, 2), 4.7e6))
    np.testing.assert_allclose(shear(1.3e9, 0.2, np.array([0.0, -3e-7])), 0.06 * 1.3e9, rtol=1e-15)


extreme = st.floats(-300, 300).map(lambda power: 10.0**power)


@given(p=st.floats(0, 20e9), v=extreme, h=extreme, faster=st.floats(1.0, 1e6))
def test_it_never_falls_with_the_speed_and_is_always_a_number(p: float, v: float, h: float, faster: float) -> None:
    stress = shear(p, np.array([0.0, v, v * faster]), h)
    assert np.all(np.isfinite(stress))
    assert np.all(np.diff(stress) >= 0)
    assert np.all(stress <= 0.06 * p)
    assert stress[0] == 0


def test_oil_and_boundary_friction_add() -> None:
    law = law_of_oil(oil_numbers(OIL), 0.13 * 0.37, 1 - 0.3, 0.91, 60e-9)
    p, v = np.array([0.4e9, 0.9e9]), 2.1e-4
    oil = shear(0.7 * p, v, 60e-9)  # the load on the asperities does not press on the oil
    np.testing.assert_allclose(stress_and_slope(law, p, v)[0], 0.13 * 0.37 * p + 0.91 * oil, rtol=1e-14)
    contact, area = rolling_contact(load=310.0), np.pi * 0.12e-3 * 1.1e-3
    expected = 0.13 * 0.37 * 310 + shear(0.7 * 310 / area, v, 60e-9) * 0.91 * area
    np.testing.assert_allclose(mean_force(law, contact, v), expected, rtol=1e-13)
    unloaded = rolling_contact(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    assert mean_force(law, unloaded, v) == 0
    dry = law_of_oil(oil_numbers(OIL), 0.13, 0.0, 0.91, 0.0)
    np.testing.assert_allclose(stress_and_slope(dry, p, v)[0], 0.13 * p, rtol=1e-15)


@pytest.mark.parametrize("traction", ["eyring_sinh", "eyring_constant"])
def test_the_law_of_a_mixed_contact(traction: str) -> None:
    """Boundary friction on asperities and on films of a molecule; oil beside the asperities, above the mean gap."""
    surface = replace(specimens.FINISH, rms_roughness=0.4e-6, gap="truncated")
    gap = gap_law(surface, gap_roughness(surface), modulus=1.13e11, bodies=(STEEL, STEEL))
    contact, oil, p, v = rolling_contact(), replace(OIL, traction=traction), 0.7e9, 3e-3  # pyright: ignore[reportArgumentType]
    speeds: Any = np.array([0.0, 1e-3, 1.3])
    film = asymptotes_of(contact, Inflow(speeds, 0.06, 2e-8))
    shared = mixed_contact(contact, film, gap)
    law = mixed_traction(oil_numbers(oil), 0.13, shared, 1.0)
    s, h, touching = shared.asperity_share, shared.film_thickness, shared.area_fraction
    molecular = np.exp(-h / 1e-9) * [0, 1, 1] + [1, 0, 0]  # at standstill nothing flows into the gap
    assert 0.01 < molecular[1] < 0.99
    stress = shear((1 - s) * p, v, h / (1 - touching), traction=traction)
    expected = 0.13 * p * (s + (1 - s) * molecular) + stress * (1 - touching) * (1 - molecular)
    np.testing.assert_allclose(stress_and_slope(law, p, v)[0], expected, rtol=1e-12)
    np.testing.assert_allclose(mean_force(law, contact, v)[0], 0.13 * contact.load, rtol=1e-15)


def test_nonsense_is_refused() -> None:
    refuses(partial(shear, 1e9, 0.1, 1e-7), traction="barus", thickening="barus", eyring_stress=0.0)
    with pytest.raises(InputError, match="eyring_stress is missing"):
        shear(1e9, 0.1, 1e-7, traction="eyring_constant", eyring_stress=None)
    refused(lambda: shear(1e9, -0.1, 1e-7), "speed")
