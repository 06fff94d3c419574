"""Hertz's contact against its definition, 50-digit arithmetic, and a published table; its fitted formulas."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.integrate import quad

from analytic.contact.hertz import (
    HertzContact,
    contact_modulus,
    hertz_contact,
    loaded_contact,
    relative_curvatures,
)
from analytic.contact.hertz_fitted import fitted_error, hertz_contact_fitted
from analytic.contact.rolling_contact import deformed_radius, elliptic_contact
from analytic.errors import InputError
from analytic.scene import Contact, Material
from tests.contacts import INNER, PEEK, STEEL
from tests.refusals import refused, refuses
from tests.validation.hard.hertz_exact import hertz

FIELDS = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach", "stiffness")
HARRIS = Path(__file__).parents[3] / "validation" / "published" / "harris_table_6_1.csv"
LOAD, MODULUS = 613.0, 1.13e11  # N, Pa
LARGE, SMALL = 310.0, 9.7  # 1/m: a ball on the inner race of a small bearing
ROUND_OFF = 1e-13  # a few hundred roundings of a double


def contact(curvature_x: float = LARGE, curvature_y: float = SMALL, **changed: Any) -> HertzContact:
    arguments = {"load": LOAD, "modulus": MODULUS} | changed
    return hertz_contact(curvature_x=curvature_x, curvature_y=curvature_y, **arguments)


def ball_on_race(**changed: object) -> Contact:
    plain = replace(INNER, rolling_radius=15.85e-3, shoulder=2.3e-3, contact_angle=0.18, load=LOAD)
    return replace(plain, **changed)  # pyright: ignore[reportArgumentType]


def misfit(found: HertzContact, curvature_x: float, curvature_y: float, modulus: float = MODULUS) -> float:
    """Gap that the pressure leaves, relative to the approach; by the definition of the contact it is 0.

    The displacement is that of a half space at (x, y) inside the ellipse under p0 sqrt(1 - X^2/a^2 - Y^2/b^2). Polar
    coordinates about the point cancel Boussinesq's 1/distance. On a chord the pressure is the root of a quadratic, and
    its integral is the area of a half ellipse. The rest is periodic in the direction, so equal steps converge
    exponentially.
    """
    a, b, p0 = float(found.semi_axis_x), float(found.semi_axis_y), float(found.peak_pressure)
    direction = np.arange(20_000) * np.pi / 20_000  # 4000 would do for the ellipses here
    cosine, sine = np.cos(direction), np.sin(direction)
    worst = 0.0
    for x, y in ((0.0, 0.0), (0.71 * a, 0.13 * b), (-0.24 * a, 0.83 * b)):
        inside = 1 - (x / a) ** 2 - (y / b) ** 2
        slope, bend = x * cosine / a**2 + y * sine / b**2, (cosine / a) ** 2 + (sine / b) ** 2
        chord = np.pi / 2 * (inside + slope**2 / bend) / np.sqrt(bend)
        displacement = p0 * float(np.mean(chord)) / modulus
        gap = float(found.approach) - curvature_x * x**2 / 2 - curvature_y * y**2 / 2
        worst = max(worst, abs(displacement - gap) / float(found.approach))
    return worst


def carried_load(found: HertzContact) -> float:
    """Load under the pressure, N, by quadrature over the ellipse."""
    disc, _ = quad(lambda radius: 2 * np.pi * radius * np.sqrt(1 - radius**2), 0, 1)
    return float(found.peak_pressure * found.semi_axis_x * found.semi_axis_y * disc)


def reference(curvature_x: float, curvature_y: float) -> dict[str, float]:
    """In 100 digits."""
    found = hertz(mpmath.mpf(curvature_x), mpmath.mpf(curvature_y), mpmath.mpf(LOAD), mpmath.mpf(MODULUS))
    axes = ("minor", "major") if curvature_x > curvature_y else ("major", "minor")
    names = (*axes, "pressure", "approach", "stiffness")
    return {field: float(found[name]) for field, name in zip(FIELDS, names, strict=True)}


@pytest.mark.parametrize("ratio", [1 + 1e-12, 1 + 1e-7, 1.0003, 1.3, 4.1, 32.0, 700.0, 2.3e4, 1e6])
@pytest.mark.parametrize("x_is_larger", [True, False])
def test_every_ratio_agrees_with_many_digits(ratio: float, x_is_larger: bool) -> None:
    curvatures = (SMALL * ratio, SMALL) if x_is_larger else (SMALL, SMALL * ratio)
    found, expected = contact(*curvatures), reference(*curvatures)
    for field in FIELDS:
        np.testing.assert_allclose(getattr(found, field), expected[field], rtol=ROUND_OFF, err_msg=field)


@pytest.mark.parametrize("curvatures", [(LARGE, SMALL), (SMALL, LARGE), (LARGE, 0.93 * LARGE)])
def test_the_pressure_closes_the_gap_and_carries_the_load(curvatures: tuple[float, float]) -> None:
    found = contact(*curvatures)
    assert misfit(found, *curvatures) < 1e-11  # round-off of a mean of 20 000
    np.testing.assert_allclose(carried_load(found), LOAD, rtol=1e-9)  # quadrature


def test_harris_table() -> None:
    table = np.genfromtxt(HARRIS, delimiter=",", names=True, skip_header=2)
    curvature_sum, difference = 351.0, table["F_rho"]
    found = hertz_contact(
        curvature_x=curvature_sum * (1 + difference) / 2,
        curvature_y=curvature_sum * (1 - difference) / 2,
        load=LOAD,
        modulus=MODULUS,
    )
    unit = np.cbrt(3 * LOAD / (2 * curvature_sum * MODULUS))
    assert len(difference) > 20
    rounding = 4e-4  # four printed digits, some a unit off in the last: 3.2e-4 at worst
    np.testing.assert_allclose(found.semi_axis_y / unit, table["a_star"], rtol=rounding)
    np.testing.assert_allclose(found.semi_axis_x / unit, table["b_star"], rtol=rounding)
    np.testing.assert_allclose(found.approach / (unit**2 * curvature_sum / 2), table["delta_star"], rtol=rounding)


def test_a_contact_under_one_newton_gives_that_under_any_load() -> None:
    loads = np.array([0.0, 3.7e-5, LOAD])
    scaled, direct = loaded_contact(contact(load=1.0), load=loads), contact(load=loads)  # pyright: ignore[reportArgumentType]
    for field in FIELDS:
        np.testing.assert_allclose(getattr(scaled, field), getattr(direct, field), rtol=ROUND_OFF, err_msg=field)
    with pytest.raises(InputError, match="load must be at least 0"):
        loaded_contact(contact(), load=-2.0)


def test_a_bad_argument_is_named() -> None:
    refuses(contact, load=-3.5, curvature_x=0.0, curvature_y=[[5.0, -7.0]], modulus=float("inf"))
    refused(lambda: contact(load=[2.0, float("nan")]), "load", "nan", "index [1]")
    refused(lambda: contact(modulus="steel"), "modulus", "steel", "number")
    refused(lambda: contact(modulus=3j), "modulus", "real")
    refused(lambda: contact(load=[1.5, 2.5], modulus=[3e9, 4e9, 5e9]), "(2,)", "(3,)", "equal lengths")


def test_modulus_of_two_bodies() -> None:
    np.testing.assert_allclose(contact_modulus(STEEL, STEEL), 206e9 / (2 * (1 - 0.3**2)), rtol=ROUND_OFF)
    rigid = Material(name="rigid", youngs_modulus=1e30, poisson_ratio=0.21, density=3000.0, source="test")
    np.testing.assert_allclose(contact_modulus(rigid, PEEK), 3.6e9 / (1 - 0.38**2), rtol=ROUND_OFF)
    with pytest.raises(InputError, match=r"poisson_ratio of odd .* 0\.52"):
        contact_modulus(STEEL, Material(name="odd", youngs_modulus=3e9, poisson_ratio=0.52, density=1.5, source="test"))


def test_curvatures_of_a_ball_on_both_races() -> None:
    convex = relative_curvatures(ball_on_race())
    np.testing.assert_allclose(convex, (1 / 3.97e-3 + 1 / 15.85e-3, 1 / 3.97e-3 - 1 / 4.13e-3), rtol=1e-12)
    concave = relative_curvatures(ball_on_race(pair="outer", rolling_radius=-24.1e-3))
    assert concave[0] < 1 / 3.97e-3 < convex[0]


def test_an_impossible_ball_on_race_is_refused() -> None:
    for radius in (-3.9e-3, 0.0, float("nan")):
        refused(lambda: relative_curvatures(ball_on_race(rolling_radius=radius)), "rolling_radius", str(radius))  # noqa: B023
    for wrong in ({"groove_radius": 3.97e-3}, {"groove_radius": -4.13e-3}, {"ball_radius": 0.0}):
        refused(lambda: relative_curvatures(ball_on_race(**wrong)), *wrong)  # noqa: B023


RATIOS = np.geomspace(1, 100, 801)
# Least and largest relative error by the docstring; x is the minor axis here.
STATED = {
    "semi_axis_x": (-0.011, 0.012),
    "semi_axis_y": (-0.027, 0.021),
    "peak_pressure": (-0.011, 0.017),
    "approach": (-0.042, 0.027),
    "stiffness": (-0.040, 0.065),
}


def both(curvature_x: object, curvature_y: object, load: object = LOAD) -> tuple:
    arguments = {"curvature_x": curvature_x, "curvature_y": curvature_y, "load": load, "modulus": MODULUS}
    return hertz_contact_fitted(**arguments), hertz_contact(**arguments)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("field", STATED)
def test_the_stated_error_holds_and_is_reached(field: str) -> None:
    fitted, exact = both(SMALL * RATIOS, SMALL)
    errors = getattr(fitted, field) / getattr(exact, field) - 1
    least, largest = STATED[field]
    assert least <= errors.min() < 0.9 * least  # the docstring does not overstate it
    assert 0.9 * largest < errors.max() <= largest


def test_the_circle_is_exact() -> None:
    fitted, exact = both(SMALL, SMALL)
    for field in STATED:
        np.testing.assert_allclose(getattr(fitted, field), getattr(exact, field), rtol=1e-13)  # round-off


def test_pressure_carries_the_load_and_stiffness_fits_the_approach() -> None:
    """Load of a semi-ellipsoid, 2/3 pi a b p0; shapes broadcast, and either semi-axis may be the longer."""
    fitted, _ = both(np.array([[310.0], [3.1]]), SMALL, load=np.array([3.0, 41.0]))
    carried = 2 / 3 * np.pi * fitted.semi_axis_x * fitted.semi_axis_y * fitted.peak_pressure
    np.testing.assert_allclose(carried, [[3.0, 41.0]] * 2, rtol=1e-13)  # round-off
    np.testing.assert_allclose(fitted.stiffness * fitted.approach**1.5, [[3.0, 41.0]] * 2, rtol=1e-13)
    assert np.all((fitted.semi_axis_x < fitted.semi_axis_y) == [[True], [False]])


def test_the_bound_covers_the_error_and_is_at_most_half_larger() -> None:
    """At any ratio of the curvatures, in both orders and at any size; beyond the last knot it is infinite."""
    ratios = np.geomspace(1.05, 9e4, 4001)
    for curvatures in ((SMALL * ratios, SMALL), (0.3, 0.3 * ratios)):
        fitted, exact = both(*curvatures)
        names = ("semi_axis_x", "semi_axis_y", "peak_pressure", "approach")
        error = np.max([np.abs(getattr(fitted, name) / getattr(exact, name) - 1) for name in names], axis=0)
        bound = fitted_error(curvature_x=curvatures[0], curvature_y=curvatures[1])
        assert np.all(error < bound)
        assert np.all(bound < 1.5 * error)
    assert fitted_error(curvature_x=SMALL, curvature_y=SMALL) == 0
    assert fitted_error(curvature_x=2e5 * SMALL, curvature_y=SMALL) == np.inf


HERTZ = {"curvature_rolling": 310.0, "curvature_transverse": 14.7, "load": 613.0, "modulus": 1.13e11}


def test_the_contact_surface_lies_halfway_between_ball_and_groove() -> None:
    found = deformed_radius(groove_radius=[4.13e-3, 4.21e-3], ball_diameter=7.94e-3)
    halfway = [(1 / 3.97e-3 + 1 / groove) / 2 for groove in (4.13e-3, 4.21e-3)]
    np.testing.assert_allclose(found, 1 / np.array(halfway), rtol=1e-14)  # round-off


def test_the_elliptic_contact_is_that_of_hertz_and_a_point_without_load() -> None:
    found = elliptic_contact(**HERTZ | {"load": np.array([0.0, 613.0])})
    hertz = hertz_contact(curvature_x=310.0, curvature_y=14.7, load=613.0, modulus=1.13e11)
    np.testing.assert_array_equal(found.semi_axis_rolling, [0.0, hertz.semi_axis_x])
    np.testing.assert_array_equal(found.semi_axis_transverse, [0.0, hertz.semi_axis_y])


def test_a_bad_argument_of_an_elliptic_contact_is_named() -> None:
    refuses(lambda **wrong: elliptic_contact(**HERTZ | wrong), **dict.fromkeys(HERTZ, -1.0))
