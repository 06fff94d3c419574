"""The law of a ball in the sheet of a pocket: its own data, springs in a row, and an independent solution."""

import re
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.contact.geometry import pocket_contact
from fembearing.check.contact.load_series import LawData, PocketLaw, compare_series, fit_pocket_law
from fembearing.check.contact.refinement import Wanted, solve_reference
from fembearing.check.contact.solution import compare_contact
from fembearing.check.contact.warnings import sheet_warnings
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE, present


def data_of(load: np.ndarray, approach: np.ndarray, *, common: float = 0.0) -> LawData:
    zero = np.zeros_like(load)
    return LawData(load=load, approach=approach, common=zero + common, crossing=zero)


def approach_of(law: PocketLaw, load: Any) -> Any:
    """m, under a load, N."""
    return (load / law.stiffness) ** (2 / 3) + load / law.sheet


def test_two_springs_in_a_row_are_found_again() -> None:
    load = np.array([0.9, 4.2, 11.0, 29.0])
    exact = (load / 6.1e10) ** (2 / 3) + load / 1.27e8
    law = present(fit_pocket_law(data_of(load, exact)))
    assert law.stiffness == pytest.approx(6.1e10, rel=1e-9)
    assert law.sheet == pytest.approx(1.27e8, rel=1e-9)
    assert present(law.sheet_uncertainty) < 1e-9
    np.testing.assert_allclose(approach_of(law, load), exact, rtol=1e-12)


def test_the_uncertainty_covers_approaches_that_are_off() -> None:
    """All within their half-width, with the most unfavourable signs and with others."""
    load, off = np.array([0.9, 4.2, 11.0, 29.0]), 3e-3
    exact = (load / 6.1e10) ** (2 / 3) + load / 1.27e8
    for signs in ((1, 1, 1, 1), (1, -1, 1, -1), (1, 1, -1, -1), (-1, 1, 1, -1)):
        law = present(fit_pocket_law(data_of(load, exact * (1 + off * np.array(signs)), common=off)))
        assert abs(law.stiffness / 6.1e10 - 1) < present(law.stiffness_uncertainty)
        assert abs(law.sheet / 1.27e8 - 1) < present(law.sheet_uncertainty)


def test_one_load_or_no_bending_has_no_law_and_two_loads_no_uncertainty() -> None:
    load = np.array([2.0, 17.0])
    assert fit_pocket_law(data_of(load[:1], np.array([1e-7]))) is None
    assert fit_pocket_law(data_of(load, (load / 6e10) ** 0.6)) is None
    law = present(fit_pocket_law(data_of(load, (load / 6.1e10) ** (2 / 3) + load / 1.27e8)))
    assert law.stiffness_uncertainty is None
    assert law.sheet_uncertainty is None


@pytest.mark.nightly
def test_the_sheet_bends_as_a_shell_and_the_law_holds_between_its_loads() -> None:
    """k against Reissner's shallow spherical cap, 1/k = sqrt(3 (1 - nu^2)) R/(4 E t^2) [Timoshenko1959]."""
    sheet = 0.45e-3
    contact = pocket_contact(BEARING_6205, replace(STAMPED_CAGE, pocket_depth=3.9e-3, wall_thickness=sheet), load=28.0)
    recipe = load_recipe("wall")
    series = compare_series(contact, recipe=recipe, loads=[0.5, 2.0, 8.0], tolerance=0.9)
    law = present(series.pocket_law)
    shell = 4 * 206e9 * sheet**2 / (np.sqrt(3 * (1 - 0.3**2)) * (4.07e-3 + sheet / 2))
    assert law.sheet == pytest.approx(shell, rel=0.15)  # the shell is a tenth of its radius thick, not thin
    other = replace(contact, load=4.1)
    single = solve_reference(other, Wanted(recipe, accuracy=0.02, quantities=("approach",)))
    # 1 %: the law departs by 0.3 % from its loads, whose approaches are uncertain by 0.5 %
    assert approach_of(law, 4.1) == pytest.approx(single.estimates["approach"].value, rel=1e-2)


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
