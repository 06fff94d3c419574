"""The fits of F = K delta^n and of a sheet: exact laws, known errors, loads that follow no power law, a real sheet."""

import re
from dataclasses import replace
from itertools import product
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from analytic.contact.geometry import pocket_contact
from fembearing.check.contact.load_series import (
    LawData,
    PocketLaw,
    fit_law,
    fit_pocket_law,
    fit_tangents,
)
from fembearing.check.contact.solution import compare_contact
from fembearing.check.contact.warnings import sheet_warnings
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE, present


def data(load: np.ndarray, approach: np.ndarray, *, common: float = 0.0, crossing: float = 0.0) -> LawData:
    return LawData(
        load=load, approach=approach, common=np.full(load.size, common), crossing=np.full(load.size, crossing)
    )


@given(exponent=st.floats(1.0, 2.0), stiffness=st.floats(1e3, 1e12), count=st.integers(3, 9))
def test_an_exact_power_law_is_recovered(exponent: float, stiffness: float, count: int) -> None:
    load = np.geomspace(2.3, 710.0, count)
    law = present(fit_law(data(load, (load / stiffness) ** (1 / exponent))))
    np.testing.assert_allclose(law.exponent, exponent, rtol=1e-12)  # round-off
    np.testing.assert_allclose(law.stiffness, stiffness, rtol=1e-9)  # round-off, far from the loads
    assert present(law.exponent_uncertainty) < 1e-9
    assert present(law.stiffness_uncertainty) < 1e-8


@given(seed=st.integers(0, 2**32 - 1), range_of_loads=st.floats(3.0, 1e6))
def test_no_common_error_moves_the_exponent_farther_than_propagated(seed: int, range_of_loads: float) -> None:
    """With random signs, and with those of a tilt, which is the worst."""
    load = np.geomspace(1.9, 1.9 * range_of_loads, 8)
    signs = np.random.default_rng(seed).choice([-1.0, 1.0], (5, load.size))
    for sign in (*signs, np.sign(np.arange(load.size) - 3.5)):
        law = present(fit_law(data(load, (load / 2.5e10) ** (2 / 3) * (1 + 2e-3 * sign), common=2e-3)))
        # 1 %: propagation is linear, an error of 0.2 % is not quite
        assert abs(law.exponent - 1.5) <= 1.01 * law.propagated
        assert abs(np.log(law.stiffness / 2.5e10)) <= 1.01 * present(law.stiffness_uncertainty)


def test_off_mesh_errors_average_out_only_between_distant_loads() -> None:
    few, many, wide = (
        fit_law(data(load, load ** (2 / 3), crossing=3e-3))
        for load in (np.geomspace(10.0, 60.0, 7), np.geomspace(10.0, 60.0, 400), np.geomspace(10.0, 3600.0, 14))
    )
    assert few is not None
    np.testing.assert_allclose(present(many).propagated, few.propagated, rtol=0.35)  # as the loads fall into cells
    assert present(wide).propagated < few.propagated / 2


@pytest.mark.parametrize("slope", [0.61, 2 / 3])
def test_a_stiffness_is_as_uncertain_as_its_extrapolation_to_one_metre(slope: float) -> None:
    """An error that tilts the line moves ln K by its extrapolation from the loads to 1 m."""
    load = np.array([20.0, 90.0, 500.0])
    approach = 3e-7 * load**slope
    law = present(fit_law(data(load, approach, common=1e-4)))
    moved = [fit_law(data(load, approach * (1 + 1e-4 * np.array(signs)))) for signs in product((1, -1), repeat=3)]
    shifts = [abs(np.log(other.stiffness / law.stiffness)) for other in moved if other is not None]
    np.testing.assert_allclose(present(law.stiffness_uncertainty), max(shifts), rtol=3e-3)  # first order in 1e-4


def estimates(approach: np.ndarray, *, mesh: float) -> list[Estimate]:
    return [Estimate(values=(float(value),), order=None, richardson=None, mesh=mesh) for value in approach]


def springs_in_a_row(load: np.ndarray) -> np.ndarray:
    return (load / 6e10) ** (2 / 3) + 1e-8 * load


def stiffening_groove(load: np.ndarray) -> np.ndarray:
    return (load / 2.5e10) ** (2 / 3) * (1 - 1.8e-3 * load ** (1 / 3))


@pytest.mark.parametrize("law", [springs_in_a_row, stiffening_groove])
@pytest.mark.parametrize(
    ("count", "span"), [*product((3, 4), (3.0, 14.0, 100.0, 1000.0)), *product((5, 6, 9, 30), (3.0, 14.0))]
)
def test_tangents_of_other_laws_lie_within_their_intervals(law, count: int, span: float) -> None:
    """Curves that the fit cannot represent, with approaches as uncertain as in a series to 0.1 %."""
    load = np.geomspace(28.0 / span, 28.0, count)
    tangents = fit_tangents(data(load, law(load), common=5e-4), load, estimates(law(load), mesh=5e-4))
    step = 1e-4 * load
    for (tangent, uncertainty), exact in zip(tangents, 2 * step / (law(load + step) - law(load - step)), strict=True):
        assert abs(tangent / exact - 1) < present(uncertainty)


def test_two_loads_have_a_law_without_an_interval() -> None:
    """One law fits any two loads, but its tangents may be wrong by more than the approaches are uncertain."""
    load = np.array([2.0, 28.0])
    approach = springs_in_a_row(load)
    both = data(load, approach, common=1e-3)
    law = present(fit_law(both))
    np.testing.assert_allclose(law.stiffness * approach**law.exponent, load, rtol=1e-12)  # round-off
    assert law.exponent_uncertainty is None
    assert law.stiffness_uncertainty is None
    for (tangent, uncertainty), force, here in zip(
        fit_tangents(both, load, estimates(approach, mesh=1e-3)), load, approach, strict=True
    ):
        assert uncertainty is None
        np.testing.assert_allclose(tangent, law.exponent * force / here, rtol=1e-12)


@pytest.mark.parametrize("count", [1, 2])
def test_a_repeated_load_is_not_redundant(count: int) -> None:
    load = np.array([9.0, 310.0])[:count]
    given = np.repeat(load, 3)
    approach = estimates(given ** (2 / 3), mesh=1e-3)
    repeated = LawData.of(given, approach, [0.0] * given.size)
    assert not repeated.redundant
    law = fit_law(repeated)
    assert (law is None) == (count == 1)
    assert law is None or law.exponent_uncertainty is None


def test_off_mesh_errors_of_distant_loads_add_as_squares_and_of_near_ones_as_they_are() -> None:
    """The slope over two loads, ln(d2/d1)/ln(F2/F1), changes by the errors of both ends."""
    for ratio, growth in ((1.2, 2.0), (40.0, np.sqrt(2))):  # ln 1.2 is below the 0.3 of a cell that begins at 10.0
        load = np.exp(0.3 * 8 + 0.01) * np.array([1.0, ratio])
        law = present(fit_law(data(load, (load / 2.5e10) ** (2 / 3), crossing=3e-3)))
        slope = growth * 3e-3 / np.log(ratio)
        assert law.propagated == pytest.approx(1.5**2 * slope, rel=1e-9)  # n = 1/slope
    both = present(fit_law(data(load, (load / 2.5e10) ** (2 / 3), crossing=3e-3, common=1e-3)))
    assert both.propagated - law.propagated == pytest.approx(1.5**2 * 2e-3 / np.log(40.0), rel=1e-9)


def approach_of(law: PocketLaw, load: Any) -> Any:
    """m, under a load, N."""
    return (load / law.stiffness) ** (2 / 3) + load / law.sheet


def test_two_springs_in_a_row_are_found_again() -> None:
    load = np.array([0.9, 4.2, 11.0, 29.0])
    exact = (load / 6.1e10) ** (2 / 3) + load / 1.27e8
    law = present(fit_pocket_law(data(load, exact)))
    assert law.stiffness == pytest.approx(6.1e10, rel=1e-9)
    assert law.sheet == pytest.approx(1.27e8, rel=1e-9)
    assert present(law.sheet_uncertainty) < 1e-9
    np.testing.assert_allclose(approach_of(law, load), exact, rtol=1e-12)


def test_the_uncertainty_covers_approaches_that_are_off() -> None:
    """All within their half-width, with the most unfavourable signs and with others."""
    load, off = np.array([0.9, 4.2, 11.0, 29.0]), 3e-3
    exact = (load / 6.1e10) ** (2 / 3) + load / 1.27e8
    for signs in ((1, 1, 1, 1), (1, -1, 1, -1), (1, 1, -1, -1), (-1, 1, 1, -1)):
        law = present(fit_pocket_law(data(load, exact * (1 + off * np.array(signs)), common=off)))
        assert abs(law.stiffness / 6.1e10 - 1) < present(law.stiffness_uncertainty)
        assert abs(law.sheet / 1.27e8 - 1) < present(law.sheet_uncertainty)


def test_one_load_or_no_bending_has_no_law_and_two_loads_no_uncertainty() -> None:
    load = np.array([2.0, 17.0])
    assert fit_pocket_law(data(load[:1], np.array([1e-7]))) is None
    assert fit_pocket_law(data(load, (load / 6e10) ** 0.6)) is None
    law = present(fit_pocket_law(data(load, (load / 6.1e10) ** (2 / 3) + load / 1.27e8)))
    assert law.stiffness_uncertainty is None
    assert law.sheet_uncertainty is None


def test_a_sheet_that_yields_under_the_centre_is_warned_of() -> None:
    """With the largest pressure and its place; a node that bears no force does not count."""
    contact = pocket_contact(BEARING_6205, STAMPED_CAGE, load=28.0)
    mesh: Any = SimpleNamespace(
        contact=contact,
        quantities=SimpleNamespace(peak_pressure=0.7e8),
        x=np.array([0.0, 0.3e-3, 0.9e-3]),
        y=np.array([0.0, 0.4e-3, 0.0]),
        pressure=np.array([0.7e8, 1.3e8, 9e8]),
        force=np.array([2.0, 3.0, -1.0]),
    )
    assert len(list(sheet_warnings(mesh, hertz=1.3e8))) == 1
    _, message = sheet_warnings(mesh, hertz=1.5e8)
    assert "pocket: under 28 N the sheet yields at the centre, where 0.07 GPa are 47 % of Hertz's" in message
    assert "the largest pressure, 0.13 GPa, is 0.5 mm from there" in message
    assert "\n" not in message


@pytest.mark.nightly
def test_a_thin_sheet_bears_the_ball_on_a_ring() -> None:
    """A sheet of 0.1 mm under 28 N, by the mean square distance of its load: above that of an even pressure, r^2/2."""
    contact = pocket_contact(BEARING_6205, replace(STAMPED_CAGE, wall_thickness=0.1e-3), load=28.0)
    found = compare_contact(contact, recipe=load_recipe("wall"), tolerance=0.05)
    (message,) = (warning for warning in found.numbers.warnings if "yields at the centre" in warning)
    mesh = found.meshes[-1]
    square = np.sum(mesh.force * (mesh.x**2 + mesh.y**2)) / mesh.force.sum()
    said = re.search(r"GPa, is (\S+) mm from there", message)
    assert said is not None
    assert 0.55 < square / (float(said[1]) * 1e-3) ** 2 < 1  # Hertz's pressure has 0.4, a ring alone 1
