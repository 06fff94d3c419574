"""Hertz, corrected and not, over the load; pressure along the axes."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.contact.hertz import (
    AXES,
    POSITIONS,
    Axis,
    approach_over_load,
    corrected_hertz,
    hertz_profile,
    hertz_quantities,
    nodal_profile,
)
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.mesh.recipe import load_recipe
from fembearing.plain_types import plain
from tests.analytic.specimens import present


def test_the_curve_of_hertz_agrees_with_hertz_at_every_load(contacts: dict[str, Contact]) -> None:
    contact = contacts["inner"]
    curve = approach_over_load(contact, hertz=hertz_quantities(contact), correctable=False)
    solved = [hertz_quantities(replace(contact, load=float(load))).approach for load in curve.load]
    np.testing.assert_allclose(curve.hertz, solved, rtol=1e-12)
    np.testing.assert_allclose(curve.load[:: len(curve.load) - 1], (0.05 * 372, 1.5 * 372), rtol=1e-12)
    assert plain(curve)["corrected"] == [None] * len(curve.load)


def test_the_curve_of_the_correction_agrees_with_single_contacts(contacts: dict[str, Contact]) -> None:
    contact = contacts["outer"]
    curve = approach_over_load(contact, hertz=hertz_quantities(contact), correctable=True)
    for point in (3, 20):
        single = replace(contact, load=float(curve.load[point]))
        single_corrected, _ = corrected_hertz(single, hertz=hertz_quantities(single))
        assert single_corrected is not None
        np.testing.assert_allclose(present(curve.corrected[point]), single_corrected.quantities.approach, rtol=1e-12)
        np.testing.assert_allclose(
            present(curve.uncertainty[point]), single_corrected.uncertainty["approach"], rtol=1e-12
        )
    factor = np.array(curve.corrected) / np.array(curve.hertz) - 1
    assert np.all(np.diff(factor) < 0)  # the larger the contact, the stiffer it is compared with Hertz
    assert np.all(factor < 0)


def test_the_curve_of_the_correction_ends_with_the_range_of_the_fit(contacts: dict[str, Contact]) -> None:
    # A semi-axis of 1.9 mm leaves less than 15 % of it
    narrow = replace(contacts["inner"], shoulder=1.7e-3, load=3000.0)
    curve = approach_over_load(narrow, hertz=hertz_quantities(narrow), correctable=True)
    semi_axis = hertz_quantities(narrow).semi_axis_transverse * (np.array(curve.load) / 3000) ** (1 / 3)
    is_known = [value is not None for value in curve.corrected]
    np.testing.assert_array_equal(is_known, 1.15 * semi_axis <= 1.7e-3)
    assert 0 < sum(is_known) < len(curve.load)


@pytest.fixture(scope="module")
def solution(contacts: dict[str, Contact]) -> ContactSolution:
    return compare_contact(contacts["outer"], recipe=load_recipe("race"), tolerance=0.9)


def carried(position: np.ndarray, pressure: np.ndarray, *, along: float, across: float) -> float:
    """Load of a pressure that is the same on ellipses of one shape: 2 pi (across/along) integral of p s ds, N.

    p^2 is about straight in s^2 there: p s ds is integrated as half p d(s^2), exactly for that from node to node.
    """
    square, low, high = position**2, pressure[:-1], pressure[1:]
    mean = 2 / 3 * (low**2 + low * high + high**2) / np.maximum(low + high, 1e-300)  # of the root of a straight line
    return float(np.pi * across / along * np.sum(mean * np.diff(square)))


@pytest.mark.parametrize("axis", AXES)
def test_the_pressure_on_either_axis_carries_the_load(solution: ContactSolution, axis: Axis) -> None:
    profile, measured = nodal_profile(solution.meshes[-1], axis), solution.numbers.reference
    along, across = measured.semi_axis_rolling, measured.semi_axis_transverse
    if axis == "transverse":
        along, across = across, along
    load = carried(np.array(profile.position), np.array(profile.pressure), along=along, across=across)
    np.testing.assert_allclose(load, solution.contact.load, rtol=0.015)  # nodes scatter by 0.5 %, more at the edge
    assert profile.position[0] == 0
    np.testing.assert_allclose(profile.pressure[0], measured.peak_pressure, rtol=5e-3)  # a node, and a fit to many
    assert np.all(np.diff(profile.position) > 0)
    assert np.all(np.array(profile.pressure)[np.array(profile.position) > 1.05 * along] == 0)
    assert along < profile.position[-1] <= 1.2 * solution.meshes[-1].pair.semi_axes[AXES.index(axis)] * 1.01


@pytest.mark.parametrize("axis", AXES)
def test_hertz_carries_the_load_and_ends_at_its_edge(solution: ContactSolution, axis: Axis) -> None:
    profile, hertz = hertz_profile(solution.numbers.hertz, axis), solution.numbers.hertz
    along, across = hertz.semi_axis_rolling, hertz.semi_axis_transverse
    if axis == "transverse":
        along, across = across, along
    load = carried(np.array(profile.position), np.array(profile.pressure), along=along, across=across)
    np.testing.assert_allclose(load, solution.contact.load, rtol=1e-9)  # exact for an ellipse
    assert (profile.pressure[0], profile.pressure[-1]) == (hertz.peak_pressure, 0)
    np.testing.assert_allclose(profile.position[-1], along, rtol=1e-12)


def test_the_error_of_the_correction_is_relative_to_the_reference(solution: ContactSolution) -> None:
    found = solution.numbers
    corrected, reference = vars(present(found.corrected).quantities), vars(found.reference)
    assert set(found.interpolation_error) == set(reference)
    for name, error in found.interpolation_error.items():
        assert reference[name] * (1 + error) == pytest.approx(corrected[name], rel=1e-12), name  # round-off


def test_many_nodes_are_thinned_with_ends_and_centre(solution: ContactSolution) -> None:
    mesh = solution.meshes[-1]
    x = np.linspace(-1.1, 1.1, 501) * mesh.semi_axes[0]
    force = np.ones(501)
    force[250 + 6] = 0.0  # a node that does not touch, with noise of the fit
    many = replace(mesh, x=x, y=np.append(np.zeros(500), 1e-3), force=force, pressure=np.arange(501.0))
    profile = nodal_profile(many, "rolling")
    assert len(profile.position) <= POSITIONS
    assert 0.0 in profile.position
    assert (profile.position[0], profile.position[-1]) == (x[0], x[499])  # the last node is off the axis
    kept = np.searchsorted(x, profile.position)
    np.testing.assert_array_equal(profile.pressure, np.where(force[kept] > 0, kept, 0.0))
    whole = replace(many, x=x[::12], y=np.zeros(42), force=force[::12], pressure=np.arange(42.0))
    assert len(nodal_profile(whole, "rolling").position) == 42  # few enough
