"""Starved inlets: definitions in other forms, limits, both ways to the degree, and a numerical solution."""

from dataclasses import replace
from typing import Any

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given

from analytic.contact.rolling_contact import ContactNumbers
from analytic.oil.film import minimum_ratio
from analytic.oil.starvation import (
    FLOODED,
    checked_degree,
    film_factor,
    starved_by_degree,
    starved_by_factor,
    starved_by_film,
)
from fembearing.ehl.film import numerical_film
from tests.analytic.specimens import rolling_contact
from tests.refusals import refused
from validation.ehl.run import contact_of
from validation.ehl.starved import factors

OIL: dict[str, Any] = {"viscosity": 0.06, "pressure_viscosity": 2e-8}
A, RADIUS = 0.12e-3, 3.2e-3  # m
CONTACT = ContactNumbers(
    load=613.0,
    curvature_rolling=1 / RADIUS,
    curvature_transverse=17.0,
    modulus=113e9,
    semi_axis_rolling=A,
    semi_axis_transverse=1.1e-3,
)
FILM, AHEAD, LENGTH = 157e-9, 3.1e-3, 0.037e-3  # m
degrees = st.floats(-6, 1.3).map(lambda power: 1 + 10.0**power)  # up to 21, within the oil of a flooded inlet


@given(degree=degrees)
def test_the_factor_on_rolling_in_40_digits(degree: float) -> None:
    """A ratio of two logarithms, also where the oil is next to the edge of the contact."""
    with mpmath.workdps(40):
        a, s = mpmath.mpf(A), mpmath.mpf(LENGTH)
        left = mpmath.log(1 + (mpmath.mpf(degree) * a - a) / s) / mpmath.log(1 + (mpmath.mpf(AHEAD) - a) / s)
    found = starved_by_degree(CONTACT, degree, FILM, AHEAD, LENGTH)
    # m a - a loses digits as m - 1 does
    np.testing.assert_allclose(found.rolling_factor, float(left), rtol=1e-14 / (degree - 1) + 1e-13)


@given(degree=degrees)
def test_the_degree_comes_back_from_what_it_leaves_of_rolling(degree: float) -> None:
    there = starved_by_degree(CONTACT, degree, FILM, AHEAD, LENGTH)
    back = starved_by_factor(CONTACT, there.rolling_factor, FILM, AHEAD, LENGTH)
    np.testing.assert_allclose(back, there, rtol=1e-13 / (degree - 1) + 1e-12)  # as above


def test_the_film_begins_to_thin_at_the_distance_of_the_fit() -> None:
    begins = 1 + 3.06 * (RADIUS * FILM / A**2) ** 0.58
    assert film_factor(CONTACT, begins * (1 + 1e-9), FILM) == 1
    half = film_factor(CONTACT, 1 + (begins - 1) / 2, FILM)
    np.testing.assert_allclose(half, 2**-0.29, rtol=1e-12)


@pytest.mark.parametrize("ahead", [0.01 * A, 0.93 * A, A])
def test_oil_that_ends_within_the_contact_leaves_nothing(ahead: float) -> None:
    """At any degree and any factor; just beyond the edge next to nothing is left of the film."""
    for degree in (1.0, 1.3, np.inf):
        assert starved_by_degree(CONTACT, degree, FILM, ahead, LENGTH) == (1.0, 0.0, 0.0)
    assert starved_by_factor(CONTACT, 0.8, FILM, ahead, LENGTH) == (1.0, 0.0, 0.0)
    edge = starved_by_degree(CONTACT, np.inf, FILM, A * (1 + 1e-9), LENGTH)
    assert edge.film_factor == pytest.approx((1e-9 / 0.4) ** 0.29, rel=0.1)  # m* - 1 is 0.44 here


def test_without_load_or_film_the_inlet_is_flooded() -> None:
    unloaded = CONTACT._replace(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    for contact, film in ((unloaded, FILM), (CONTACT, 0.0)):
        assert starved_by_degree(contact, 1.2, film, AHEAD, LENGTH)[1:] == (1.0, 1.0)
        assert starved_by_factor(contact, 0.3, film, AHEAD, LENGTH)[1:] == (1.0, 1.0)


def test_a_measured_film_tells_the_degree_that_leaves_it() -> None:
    """Back by the law of the film; rolling loses as much, and a film that is whole is flooded."""
    for factor in (0.23, 0.71):
        found = starved_by_film(CONTACT, factor, FILM)
        assert film_factor(CONTACT, found.degree, FILM) == pytest.approx(factor, rel=1e-12)
        assert (found.film_factor, found.rolling_factor) == (factor, factor)
    unloaded = CONTACT._replace(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    for contact, factor, film in (
        (CONTACT, 1.0, FILM),
        (CONTACT, 1.3, FILM),
        (CONTACT, 0.4, 0.0),
        (unloaded, 0.4, FILM),
    ):
        assert starved_by_film(contact, factor, film) == FLOODED


@pytest.mark.parametrize(
    ("degree", "film", "rolling"),
    [pytest.param(3.1, 0.07, 0.09, marks=pytest.mark.nightly), pytest.param(1.5, 0.27, 0.34, marks=pytest.mark.slow)],
)
def test_a_numerical_solution_with_little_oil(degree: float, film: float, rolling: float) -> None:
    """Tolerances: the largest differences of validation/ehl/starved.py, on other contacts."""
    whole = contact_of(170.0, 7.3, 0.13)
    assert whole is not None
    little = replace(whole, reach=replace(whole.reach, ahead=degree * whole.semi_axes[0]))
    flooded, starved = numerical_film(whole), numerical_film(little)
    film_left, rolling_left = factors(whole, degree, flooded.central_film.value)
    assert film_left == pytest.approx(starved.central_film.value / flooded.central_film.value, rel=film)
    assert rolling_left == pytest.approx(starved.rolling_force.value / flooded.rolling_force.value, rel=rolling)
    assert rolling_left < 0.8  # and not flooded, to which the tolerance would be blind


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
    # a fit to thick oils: with G below some 10 it would leave more at the side than in the centre
    assert minimum_ratio(contact, entrainment_speed=0.4, viscosity=0.06, pressure_viscosity=1 / stiff) == 1
    assert minimum_ratio(contact, entrainment_speed=0.4, viscosity=0.06, pressure_viscosity=0.0) == 1
    unloaded = rolling_contact(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    assert minimum_ratio(unloaded, entrainment_speed=0.4, **OIL) == 1


def test_a_degree_within_the_contact_is_refused() -> None:
    for degree in (0.999, -3.0, np.nan):
        refused(
            lambda degree=degree: checked_degree(degree), "lubricant.starvation_degree", f"{degree:g}", "inf is flooded"
        )
