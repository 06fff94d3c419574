"""The law of a ball in the sheet of a pocket: its own data, springs in a row, and an independent solution."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import pocket_contact
from fembearing.mesh.recipe import load_recipe
from fembearing.progress import silent
from fembearing.verify.contact.load_series import compare_series
from fembearing.verify.contact.pocket_law import fit_pocket_law
from fembearing.verify.contact.power_law import LawData
from fembearing.verify.contact.reference import solve_reference
from fembearing.verify.contact.warnings import annular_warning
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE, present


def data_of(load: np.ndarray, approach: np.ndarray, *, common: float = 0.0) -> LawData:
    zero = np.zeros_like(load)
    return LawData(load=load, approach=approach, common=zero + common, crossing=zero)


def test_two_springs_in_a_row_are_found_again() -> None:
    load = np.array([0.9, 4.2, 11.0, 29.0])
    exact = (load / 6.1e10) ** (2 / 3) + load / 1.27e8
    law = present(fit_pocket_law(data_of(load, exact)))
    assert law.stiffness == pytest.approx(6.1e10, rel=1e-9)
    assert law.sheet == pytest.approx(1.27e8, rel=1e-9)
    assert present(law.sheet_uncertainty) < 1e-9
    np.testing.assert_allclose(law.approach(load), exact, rtol=1e-12)


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


@pytest.mark.slow
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
    single = solve_reference(other, recipe=recipe, accuracy=0.02, quantities=("approach",), progress=silent)
    # 1 %: the law departs by 0.3 % from its loads, whose approaches are uncertain by 0.5 %
    assert float(law.approach(4.1)) == pytest.approx(single.estimates["approach"].value, rel=1e-2)


def test_a_sheet_that_yields_under_the_centre_is_warned_of() -> None:
    contact = pocket_contact(BEARING_6205, STAMPED_CAGE, load=28.0)
    assert annular_warning(contact, peak=0.8e8, hertz=1.5e8) == ""
    message = annular_warning(contact, peak=0.7e8, hertz=1.5e8)
    assert "pocket: 0.07 GPa at the centre is 47 % of Hertz's" in message
    assert "\n" not in message
