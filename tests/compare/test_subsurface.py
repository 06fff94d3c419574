"""The stress under a contact both ways: each side with its own material, and an uncertainty that holds."""

from dataclasses import replace

import pytest

from analytic.scene import Contact, Material
from analytic.subsurface import subsurface_maximum
from fembearing.compare import subsurface as module
from fembearing.compare.discrepancy import ContactSolution, compare_contact
from fembearing.compare.subsurface import NAMES, compare_subsurface
from fembearing.fem.subsurface import Side
from fembearing.mesh.recipe import load_recipe

RUBBERY = Material(name="rubbery", youngs_modulus=90e9, poisson_ratio=0.45, density=1.3, source="test")


@pytest.fixture(scope="module")
def ideal(contacts: dict[str, Contact]) -> ContactSolution:
    contact = replace(contacts["outer"], race_material=RUBBERY)
    return compare_contact(contact, recipe=load_recipe("hertzian"), tolerance=0.9)


@pytest.mark.parametrize(("side", "ratio"), [("upper", 0.3), ("lower", 0.45)])
def test_the_idealisation_meets_the_closed_form_within_its_uncertainty(
    ideal: ContactSolution, side: Side, ratio: float
) -> None:
    found = compare_subsurface(ideal, side=side)
    closed = subsurface_maximum(
        peak_pressure=ideal.hertz.peak_pressure,
        semi_axis_x=ideal.hertz.semi_axis_rolling,
        semi_axis_y=ideal.hertz.semi_axis_transverse,
        poisson_ratio=ratio,  # of that side's material: exchanged, the depth would be 3 % off
    )
    for name in NAMES:
        assert found.hertz[name] == float(getattr(closed, name))
        assert abs(found.discrepancy(name)) < found.uncertainty[name]
        assert found.uncertainty[name] < 0.03  # and is of use


def test_json_has_the_numbers_of_both_sides(ideal: ContactSolution) -> None:
    found = compare_subsurface(ideal)
    told = found.to_json()
    assert told["side"] == "lower"
    for name in NAMES:
        assert told["discrepancy"][name] == pytest.approx(told["hertz"][name] / told["fe"][name] - 1, abs=1e-12)
    assert 3**0.5 < told["fe"]["max_von_mises"] / told["fe"]["max_shear"] < 2  # as of any stress: shear to tension


def test_the_far_boundary_and_a_chance_agreement_leave_their_share(
    ideal: ContactSolution, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two meshes that happen to agree are not sure to the last digit; the block's share is that of its quantity."""
    shares = {"semi_axis_rolling": 0.004, "semi_axis_transverse": 0.05, "peak_pressure": 0.011}
    estimates = ideal.estimates | {name: replace(ideal.estimates[name], domain=part) for name, part in shares.items()}
    agreed = dict(zip(NAMES, (0.61e9, 75e-6, 1.1e9, 68e-6), strict=True))
    monkeypatch.setattr(module, "_maxima", lambda *_, **__: agreed)
    found = compare_subsurface(replace(ideal, estimates=estimates)).uncertainty
    for name in NAMES:  # the minor semi-axis lies along rolling
        assert found[name] == pytest.approx((0.004 if "depth" in name else 0.011) + 3.8e-4, rel=1e-9)
