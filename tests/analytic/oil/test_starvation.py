"""Starved inlets: values of another program, Hertz's gap by integration, limits, and both ways to the degree."""

from functools import partial
from typing import Any

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import assume, given
from scipy.integrate import quad

from analytic.contact.geometry import race_curvatures
from analytic.contact.rolling_contact import EllipticContact, elliptic_contact
from analytic.errors import InputError
from analytic.oil.film import central_film, minimum_ratio
from analytic.oil.starvation import (
    film_factor,
    fullness_at,
    inlet_fullness,
    meniscus_gap,
    rolling_factor,
    starved_at_degree,
    starved_at_factor,
)
from tests.analytic.specimens import BEARING_6205, rolling_contact
from tests.refusals import refused, refuses

ANGLE = 0.18
OIL: dict[str, Any] = {"viscosity": 0.06, "pressure_viscosity": 2e-8}
RATE = (39.01e-3**2 - (7.94e-3 * np.cos(ANGLE)) ** 2) / (4 * 39.01e-3)  # u/w, m
FILM = {"film": 157e-9, "minimum_ratio": 0.796}
excesses = st.floats(-7, 9).map(lambda power: 10.0**power)
films = st.floats(-12, -4).map(lambda power: 10.0**power)
axes = st.floats(-6, -2).map(lambda power: 10.0**power)


def inner_6205(rpm: float) -> tuple[EllipticContact, dict[str, Any]]:
    """The heaviest contact of the 6205 under 1000 N, and its film."""
    rolling, transverse = race_curvatures(BEARING_6205, "inner", contact_angle=ANGLE)
    contact = elliptic_contact(
        curvature_rolling=rolling, curvature_transverse=transverse, load=620.630, modulus=113.187e9
    )
    motion = OIL | {"entrainment_speed": RATE * rpm * 2 * np.pi / 60}
    return contact, {
        "film": central_film(contact, **motion).thickness,
        "minimum_ratio": minimum_ratio(contact, **motion),
    }


def test_a_6205_by_another_program() -> None:
    """In the digits given; f to 1e-5 because m is given in few digits and the film in six."""
    for rpm, ratio, at_thinning in ((100, 0.7833, 0.586), (500, 0.7961, 0.559), (3000, 0.8104, 0.535)):
        contact, here = inner_6205(rpm)
        np.testing.assert_allclose(here["minimum_ratio"], ratio, atol=5e-5)
        a = np.asarray(contact.semi_axis_rolling)
        thinning = 1 + 3.06 * (here["film"] / contact.curvature_rolling / a**2) ** 0.58
        factor = starved_at_degree(contact, degree=thinning, **here).rolling_factor
        np.testing.assert_allclose(factor, at_thinning, atol=5e-4)
    contact, here = inner_6205(500)
    found = starved_at_degree(contact, degree=[1.01, 1.1, 1.2, 1.5, 2, 3, 5, 10], **here)
    np.testing.assert_allclose(found.film_factor, [0.33575, 0.65467, 0.80042, 1, 1, 1, 1, 1], atol=6e-6)
    fullness = [0.45659, 1.93836, 4.20740, 14.4349, 40.852, 125.23, 410.7, 1781]
    np.testing.assert_allclose(found.fullness, fullness, rtol=1.2e-4)  # the last has four digits
    factors = [0.05541, 0.19530, 0.33666, 0.60158, 0.76931, 0.87716, 0.94503, 0.98430]
    np.testing.assert_allclose(found.rolling_factor, factors, atol=6e-6)


def test_resistance_by_the_gap_in_the_digits_given() -> None:
    at = [0.5, 1, 2, 5, 10, 20, 50, 100, 1000]
    given = [0.060312, 0.112880, 0.200097, 0.373304, 0.525547, 0.662439, 0.793319, 0.859751, 0.973578]
    np.testing.assert_allclose(rolling_factor(at), given, atol=6e-7)
    inverse = [1.99874, 8.89029, 53.0961, 174.668, 464.335]
    np.testing.assert_allclose(fullness_at([0.2, 0.5, 0.8, 0.9, 0.95]), inverse, rtol=3e-6)


@given(power=st.floats(-300, 12))
def test_gap_and_resistance_are_inverse(power: float) -> None:
    """The far end loses the digits that 1 - g loses: 30/S of 1."""
    fullness = 10.0**power
    np.testing.assert_allclose(fullness_at(rolling_factor(fullness)), fullness, rtol=1e-14 + 1e-17 * fullness)
    assert rolling_factor(1.01 * fullness) > rolling_factor(fullness)


def test_ends_of_the_resistance() -> None:
    np.testing.assert_array_equal(rolling_factor([0.0, 1e300, np.inf]), [0.0, 1.0, 1.0])
    np.testing.assert_array_equal(fullness_at([0.0, 1.0]), [0.0, np.inf])
    assert np.all(np.isfinite(fullness_at([5e-324, np.nextafter(1, 0)])))


@pytest.mark.parametrize("degree", [1.00002, 1.003, 1.2, 2.0, 7.0])
def test_the_gap_beside_the_contact_is_that_of_hertz_pressure(degree: float) -> None:
    """The slope of the dry gap is x/R less that of the displacement by p0 sqrt(1 - s^2), p0 = E* a/(2 R).

    The displacement of an elastic half-plane under a line load falls as 2/(pi E* distance).
    """
    a, radius = 0.12e-3, 3.3e-3

    def slope(x: float) -> float:
        """Over s = sin t, which has no corner: in units of a/R."""
        pressed, _ = quad(lambda t: np.cos(t) ** 2 / (x - np.sin(t)), -np.pi / 2, np.pi / 2, epsabs=1e-12, limit=400)
        return x - pressed / np.pi

    # x = 1 + y^2, because the slope begins as a square root
    gap, _ = quad(lambda y: slope(1 + y**2) * 2 * y, 0, np.sqrt(degree - 1), epsabs=1e-13)
    contact = rolling_contact(semi_axis_rolling=a, curvature_rolling=1 / radius)
    found = meniscus_gap(contact, degree=degree, film=0.0)
    np.testing.assert_allclose(found, gap * a**2 / radius, rtol=1e-5, atol=1e-8 * a**2 / radius)  # of the quadrature


@given(excess=excesses)
def test_the_gap_in_40_digits(excess: float) -> None:
    """From where its two terms cancel to where its square is all."""
    degree = 1 + excess
    with mpmath.workdps(40):
        m = mpmath.mpf(degree)
        expected = float(m * mpmath.sqrt(m**2 - 1) - mpmath.acosh(m))
    contact = rolling_contact(semi_axis_rolling=1.0, curvature_rolling=2.0)
    np.testing.assert_allclose(meniscus_gap(contact, degree=degree, film=0.0), expected, rtol=2e-12)


@given(excess=excesses, film=films, a=axes)
def test_the_parts_are_those_of_the_definitions(excess: float, film: float, a: float) -> None:
    contact, degree = rolling_contact(semi_axis_rolling=a), 1 + excess
    factor = film_factor(contact, degree=degree, film=film)
    begins = 3.06 * (film / (310.0 * a**2)) ** 0.58
    np.testing.assert_allclose(factor, min(1.0, ((degree - 1) / begins) ** 0.29), rtol=1e-12)
    gap = meniscus_gap(contact, degree=degree, film=film)
    fullness = inlet_fullness(contact, degree=degree, film=film, minimum_ratio=0.7)
    np.testing.assert_allclose(fullness, gap / (0.7 * film), rtol=1e-11)


@given(excess=excesses, film=films, a=axes)
def test_the_degree_comes_back_from_what_it_leaves_of_rolling(excess: float, film: float, a: float) -> None:
    contact, given_degree = rolling_contact(semi_axis_rolling=a), 1 + excess
    there = starved_at_degree(contact, degree=given_degree, film=film, minimum_ratio=0.8)
    assume(there.rolling_factor < 0.9999)  # 1 - g loses digits, up to 1e-12 of S here
    back = starved_at_factor(contact, rolling_factor=there.rolling_factor, film=film, minimum_ratio=0.8)
    np.testing.assert_allclose(back.fullness, there.fullness, rtol=1e-11)
    again = inlet_fullness(contact, degree=back.degree, film=film, minimum_ratio=0.8)
    np.testing.assert_allclose(again, back.fullness, rtol=1e-8)  # m keeps few digits of m - 1
    np.testing.assert_allclose(back.film_factor, film_factor(contact, degree=back.degree, film=film), rtol=1e-15)
    assert back.rolling_factor == there.rolling_factor


def test_the_ends_of_degree_and_factor() -> None:
    ends = starved_at_degree(rolling_contact(), degree=[1.0, np.inf], **FILM)
    np.testing.assert_array_equal(
        [ends.film_factor, ends.rolling_factor, ends.fullness], [[0.0, 1.0], [0.0, 1.0], [0.0, np.inf]]
    )
    found = starved_at_factor(rolling_contact(), rolling_factor=[0.0, 1e-300, 1 - 1e-16, 1.0], **FILM)
    np.testing.assert_array_equal(found.degree[[0, 1, 3]], [1.0, 1.0, np.inf])
    assert 1e7 < found.degree[2] < np.inf
    np.testing.assert_array_equal(found.film_factor, [0.0, 0.0, 1.0, 1.0])


def test_without_load_or_film_the_inlet_is_flooded() -> None:
    for contact, film in ((rolling_contact(load=0.0, semi_axis_rolling=0.0), 1e-7), (rolling_contact(), 0.0)):
        for found in (
            starved_at_degree(contact, degree=[1.0, 1.2, np.inf], film=film, minimum_ratio=1.0),
            starved_at_factor(contact, rolling_factor=[0.0, 0.3, 1.0], film=film, minimum_ratio=1.0),
        ):
            np.testing.assert_array_equal(found.film_factor, 1.0)
            np.testing.assert_array_equal(found.rolling_factor, 1.0)
            np.testing.assert_array_equal(found.fullness, np.inf)
    np.testing.assert_array_equal(
        meniscus_gap(rolling_contact(load=0.0, semi_axis_rolling=0.0), degree=[1.0, np.inf], film=1e-7), 1e-7
    )


def test_the_ratio_of_the_films_is_that_of_both_fits() -> None:
    """Each fit by itself in the powers printed; and where they have no meaning it is 1."""
    contact, speed = rolling_contact(), 0.4
    stiff = 2 * 1.13e11
    u, g, w = 0.06 * speed * 310.0 / stiff, 2e-8 * stiff, 613.0 * 310.0**2 / stiff
    k = 1.1 / 0.12
    smallest = 3.63 * u**0.68 * g**0.49 * w**-0.073 * (1 - np.exp(-0.68 * k))
    central = 2.69 * u**0.67 * g**0.53 * w**-0.067 * (1 - 0.61 * np.exp(-0.73 * k))
    found = minimum_ratio(contact, entrainment_speed=-speed, **OIL)
    np.testing.assert_allclose(found, smallest / central, rtol=1e-12)
    assert minimum_ratio(contact, entrainment_speed=0.0, **OIL) == 1
    assert minimum_ratio(contact, entrainment_speed=0.4, viscosity=0.06, pressure_viscosity=0.0) == 1
    unloaded = rolling_contact(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    assert minimum_ratio(unloaded, entrainment_speed=0.4, **OIL) == 1
    with pytest.raises(InputError, match="give equal lengths"):
        minimum_ratio(rolling_contact(load=np.ones(3)), entrainment_speed=np.ones(2), **OIL)


def test_nonsense_is_refused() -> None:
    for degree in (0.999, -3.0, np.nan):
        there = partial(starved_at_degree, rolling_contact(), degree=degree, **FILM)
        refused(there, "lubricant.starvation_degree", f"{degree:g}", "inf is flooded")

    def starved(**changed: Any) -> object:
        return starved_at_factor(rolling_contact(), **({"rolling_factor": 0.5} | FILM | changed))

    refuses(starved, rolling_factor=1.1, film=-1e-9, minimum_ratio=0.0)
    refuses(starved, rolling_factor=np.nan)
    refused(lambda: starved(film=np.ones(2), rolling_factor=np.ones(3)), "equal lengths")
    refused(lambda: rolling_factor(-1), "fullness = -1")
