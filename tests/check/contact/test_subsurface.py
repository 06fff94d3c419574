"""The stress under a contact: each side with its own material, and an uncertainty that covers the error."""

from dataclasses import replace

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings

from analytic.contact.subsurface import subsurface_maximum
from analytic.scene import Contact, Material
from fembearing.check.contact import subsurface as module
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.check.contact.subsurface import NAMES, compare_subsurface, comparison_below
from fembearing.fem.subsurface import Array, Side, SubsurfaceStress, subsurface_stress
from fembearing.mesh.recipe import load_recipe
from fembearing.plain_types import plain

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
    hertz = solution.hertz
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
    comparison = compare_subsurface(ideal, side=side)
    # With that side's material: exchanged, depths would be 3 % off
    assert comparison.hertz == closed_form(ideal, ratio=ratio)
    for name in NAMES:
        assert not comparison.exceeds_uncertainty[name]
        assert comparison.uncertainty[name] < 0.03 * comparison.fe[name]  # narrow enough to be useful


@SIDES
@settings(max_examples=8)  # a quarter of a second each
@given(upper=RATIOS, lower=RATIOS)
def test_every_poisson_ratio_has_its_interval(ideal: ContactSolution, side: Side, upper: float, lower: float) -> None:
    """Down to 0, where von Mises stress is greatest on the surface and a relative depth would be a division by 0."""
    changed = with_ratios(ideal, upper=upper, lower=lower, meshes=slice(0, 2))  # the coarse ones: they are quick
    comparison = compare_subsurface(changed, side=side)
    document = plain(comparison)
    truth = closed_form(ideal, ratio=upper if side == "upper" else lower)
    for name in NAMES:
        assert abs(comparison.fe[name] - truth[name]) <= comparison.uncertainty[name]
        assert 0 < comparison.uncertainty[name] < np.inf
        on_surface = 0.0 in (truth[name], comparison.fe[name])
        assert (document["discrepancy"][name] is None) == on_surface


@pytest.mark.parametrize(("side", "ratio"), [("upper", 0.0), ("lower", 0.4999)])
def test_the_interval_of_the_third_level_holds_and_is_narrow(ideal: ContactSolution, side: Side, ratio: float) -> None:
    assert ideal.meshes[-1].level == 3
    other = 0.29  # of the other body
    ratios = {"upper": ratio, "lower": other} if side == "upper" else {"upper": other, "lower": ratio}
    comparison = compare_subsurface(with_ratios(ideal, **ratios, meshes=slice(1, 3)), side=side)
    minor = min(ideal.hertz.semi_axis_rolling, ideal.hertz.semi_axis_transverse)
    for name in NAMES:
        assert not comparison.exceeds_uncertainty[name]
        scale = minor if "depth" in name else comparison.fe[name]
        assert comparison.uncertainty[name] < 0.03 * scale  # the second level is off by 2 % at most


def test_a_maximum_on_the_surface_has_no_relative_depth(ideal: ContactSolution) -> None:
    comparison = compare_subsurface(with_ratios(ideal, upper=0.0, lower=0.29, meshes=slice(1, 3)), side="upper")
    assert comparison.hertz["max_von_mises_depth"] == comparison.fe["max_von_mises_depth"] == 0
    assert comparison.discrepancy["max_von_mises_depth"] is None
    assert comparison.discrepancy["max_shear_depth"] is not None
    assert not comparison.exceeds_uncertainty["max_von_mises_depth"]
    assert comparison.uncertainty["max_von_mises_depth"] > 0


def test_a_discrepancy_beyond_its_uncertainty_exceeds_it() -> None:
    values = dict(zip(NAMES, (0.61e9, 75e-6, 1.1e9, 0.0), strict=True))
    other = dict(zip(NAMES, (0.62e9, 74e-6, 1.11e9, 3e-6), strict=True))
    widths = dict(zip(NAMES, (0.02e9, 0.9e-6, 0.009e9, 4e-6), strict=True))
    comparison = comparison_below("lower", hertz=values, fe=other, uncertainty=widths)
    assert [comparison.exceeds_uncertainty[name] for name in NAMES] == [False, True, True, False]
    assert comparison.discrepancy["max_von_mises_depth"] is None


def agreeing(stress: SubsurfaceStress, curve: Array) -> SubsurfaceStress:
    """Stresses with fixed maxima and this curve of the shear stress."""
    return replace(
        stress,
        max_shear=curve,
        von_mises=0 * curve,
        greatest_shear=0.61e9,
        greatest_shear_depth=75e-6,
        greatest_von_mises=1.1e9,
        greatest_von_mises_depth=68e-6,
    )


@pytest.mark.parametrize(("lower_by", "reached"), [(0.9e-3, True), (1.1e-3, False)])
def test_a_second_maximum_as_great_is_in_the_interval(
    ideal: ContactSolution, monkeypatch: pytest.MonkeyPatch, lower_by: float, reached: bool
) -> None:
    """The stresses do not decide which of the two is greater: they are uncertain by 0.04 % each, and a share."""
    estimates = {name: replace(part, domain=1.2e-4) for name, part in ideal.estimates.items()}
    same = subsurface_stress(ideal.meshes[1])
    curve = 0 * same.depth
    curve[30] = (1 - lower_by) * 0.61e9
    same = agreeing(same, curve)
    monkeypatch.setattr(module, "subsurface_stress", lambda *_, **__: same)
    width = compare_subsurface(replace(ideal, estimates=estimates)).uncertainty["max_shear_depth"]
    away = abs(same.depth[30] - 75e-6)
    assert away > 0.1 * 75e-6  # farther than anything else
    assert (width >= away) == reached


def test_the_ends_of_a_curve_can_be_its_tops() -> None:
    depth = np.array([0.0, 0.2, 0.5, 0.9, 1.4])
    np.testing.assert_array_equal(module._tops(depth, np.array([3.1, 2.0, 2.7, 1.5, 2.9]), least=2.8), [0.0, 1.4])
    np.testing.assert_array_equal(module._tops(depth, np.array([1.1, 2.0, 2.7, 1.5, 1.2]), least=1.0), [0.5])


def test_the_far_boundary_and_a_chance_agreement_add_their_share(
    ideal: ContactSolution, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two meshes may agree by chance; the block's share is that of the related quantity."""
    shares = {"semi_axis_rolling": 0.004, "semi_axis_transverse": 0.05, "peak_pressure": 0.011}
    estimates = ideal.estimates | {name: replace(ideal.estimates[name], domain=part) for name, part in shares.items()}
    same = subsurface_stress(ideal.meshes[1])
    same = agreeing(same, 0 * same.depth)
    monkeypatch.setattr(module, "subsurface_stress", lambda *_, **__: same)
    uncertainty = compare_subsurface(replace(ideal, estimates=estimates)).uncertainty
    minor = ideal.reference.semi_axis_rolling
    for name, value, share in (
        ("max_shear", 0.61e9, 3.8e-4 + 0.011),
        ("max_von_mises", 1.1e9, 3.8e-4 + 0.011),
        ("max_shear_depth", 75e-6, 0.004),
        ("max_von_mises_depth", 68e-6, 0.004),
    ):
        least = 0.005 * minor if "depth" in name else 0.0  # the minor semi-axis lies along rolling
        assert uncertainty[name] == pytest.approx(value * share + least, rel=1e-9)


def test_a_change_between_cells_of_half_the_size_counts_as_between_those_of_two_thirds(
    ideal: ContactSolution, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At order 3: (1.5^3 - 1)/(2^3 - 1) of it."""
    first = replace(ideal, meshes=ideal.meshes[:2])
    assert [mesh.level for mesh in first.meshes] == [1, 2]
    fine = subsurface_stress(ideal.meshes[1])
    fine = agreeing(fine, 0 * fine.depth)
    both = {1: replace(fine, greatest_shear=0.64e9, greatest_shear_depth=71e-6), 2: fine}
    monkeypatch.setattr(module, "subsurface_stress", lambda mesh, **_: both[mesh.level])
    uncertainty = compare_subsurface(first).uncertainty
    monkeypatch.setattr(module, "subsurface_stress", lambda *_, **__: fine)
    least = compare_subsurface(first).uncertainty  # where nothing changes: 3e-4 of the stress, a depth by the ellipse
    assert uncertainty["max_shear"] - least["max_shear"] == pytest.approx(2.375 / 7 * 0.03e9 - 3e-4 * 0.61e9, rel=1e-9)
    minor = 0.005 * ideal.reference.semi_axis_rolling
    assert uncertainty["max_shear_depth"] - least["max_shear_depth"] == pytest.approx(
        2.375 / 7 * 4e-6 - minor, rel=1e-9
    )
