"""The stress under a contact: each side with its own material, and an uncertainty that covers the error."""

from dataclasses import replace

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings

from analytic.contact.subsurface import subsurface_maximum
from analytic.scene import Contact, Material
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.check.contact.subsurface import NAMES, compare_subsurface
from fembearing.fem.subsurface import Side
from fembearing.mesh.recipe import load_recipe

RUBBERY = Material(name="rubbery", youngs_modulus=90e9, poisson_ratio=0.45, density=1.3, source="test")
SIDES = pytest.mark.parametrize("side", ["upper", "lower"])
RATIOS = st.floats(0.0, 0.4999)


@pytest.fixture(scope="module")
def ideal(contacts: dict[str, Contact]) -> ContactSolution:
    contact = replace(contacts["outer"], race_material=RUBBERY)
    return compare_contact(contact, recipe=load_recipe("hertzian"), tolerance=0.9)


def with_ratios(solution: ContactSolution, *, upper: float, lower: float, meshes: slice) -> ContactSolution:
    """Other Poisson ratios under the same pressure: Hertz's peak pressure and ellipse stay exact."""
    contact = solution.contact
    materials = {
        "ball_material": replace(contact.ball_material, poisson_ratio=upper),
        "race_material": replace(contact.race_material, poisson_ratio=lower),
    }
    chosen = tuple(replace(mesh, contact=replace(mesh.contact, **materials)) for mesh in solution.meshes[meshes])
    return replace(solution, contact=replace(contact, **materials), meshes=chosen)


def closed_form(solution: ContactSolution, *, ratio: float) -> dict[str, float]:
    hertz = solution.numbers.hertz
    closed = subsurface_maximum(
        peak_pressure=hertz.peak_pressure,
        semi_axis_x=hertz.semi_axis_rolling,
        semi_axis_y=hertz.semi_axis_transverse,
        poisson_ratio=ratio,
    )
    return {name: float(getattr(closed, name)) for name in NAMES}


@pytest.mark.parametrize(("side", "ratio"), [("upper", 0.3), ("lower", 0.45)])
def test_the_idealisation_meets_the_closed_form_within_its_uncertainty(
    ideal: ContactSolution, side: Side, ratio: float
) -> None:
    closed = closed_form(ideal, ratio=ratio)
    for name, each in compare_subsurface(ideal, side=side).quantities.items():
        assert each.production == closed[name]  # with that side's material: exchanged, depths would be 3 % off
        assert not each.resolved
        assert each.uncertainty < 0.03 * each.reference  # narrow enough to be useful


@SIDES
@settings(max_examples=8)  # a quarter of a second each
@given(upper=RATIOS, lower=RATIOS)
def test_every_poisson_ratio_has_its_interval(ideal: ContactSolution, side: Side, upper: float, lower: float) -> None:
    """Down to 0, where von Mises stress is greatest on the surface and a relative depth would be a division by 0."""
    changed = with_ratios(ideal, upper=upper, lower=lower, meshes=slice(0, 2))  # the coarse ones: they are quick
    truth = closed_form(ideal, ratio=upper if side == "upper" else lower)
    for name, each in compare_subsurface(changed, side=side).quantities.items():
        assert abs(each.reference - truth[name]) <= each.uncertainty
        assert 0 < each.uncertainty < np.inf
        assert each.discrepancy is None or 0.0 not in (truth[name], each.reference)


@pytest.mark.parametrize(("side", "ratio"), [("upper", 0.0), ("lower", 0.4999)])
def test_the_interval_of_the_third_level_holds_and_is_narrow(ideal: ContactSolution, side: Side, ratio: float) -> None:
    assert ideal.meshes[-1].level == 3
    other = 0.29  # of the other body
    ratios = {"upper": ratio, "lower": other} if side == "upper" else {"upper": other, "lower": ratio}
    hertz = ideal.numbers.hertz
    minor = min(hertz.semi_axis_rolling, hertz.semi_axis_transverse)
    comparison = compare_subsurface(with_ratios(ideal, **ratios, meshes=slice(1, 3)), side=side)
    for name, each in comparison.quantities.items():
        assert not each.resolved
        assert each.uncertainty < 0.03 * (minor if "depth" in name else each.reference)  # level 2 is off by 2 % at most


def test_a_maximum_on_the_surface_has_no_relative_depth(ideal: ContactSolution) -> None:
    comparison = compare_subsurface(with_ratios(ideal, upper=0.0, lower=0.29, meshes=slice(1, 3)), side="upper")
    depth = comparison.quantities["max_von_mises_depth"]
    assert depth.production == depth.reference == 0
    assert (depth.discrepancy, depth.resolved) == (None, False)
    assert depth.uncertainty > 0
    assert comparison.quantities["max_shear_depth"].discrepancy is not None
