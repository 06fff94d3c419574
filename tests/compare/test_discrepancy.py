"""One contact both ways: what is reported against what was solved."""

from dataclasses import replace

import pytest

from analytic.scene import Contact
from fembearing.compare.discrepancy import compare_contact
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.recipe import load_recipe


def test_the_far_boundary_is_what_a_nested_smaller_block_shows(contacts: dict[str, Contact]) -> None:
    """If the boundary's effect fades as one over the size, the smaller block shows it (ratio - 1) times."""
    contact, recipe = contacts["outer"], load_recipe("race")
    found = compare_contact(contact, recipe=recipe, tolerance=0.9)
    middle = found.meshes[-2]
    whole, small = (
        solve_on_mesh(contact, recipe=recipe, level=middle.level, semi_axes=middle.pair.semi_axes, trimmed=trimmed)
        for trimmed in (False, True)
    )
    ratio = whole.pair.lower.mesh.doflocs[2].min() / small.pair.lower.mesh.doflocs[2].min()
    assert ratio > 1.3
    for name, part in found.estimates.items():
        change = abs(getattr(whole.quantities, name) / getattr(small.quantities, name) - 1)
        assert part.domain == pytest.approx(change / (ratio - 1), rel=1e-6)  # round-off of the factorisation
        assert part.domain > 0


def test_an_ellipse_over_the_shoulder_is_not_judged(contacts: dict[str, Contact]) -> None:
    narrow = replace(contacts["inner"], shoulder=0.8e-3)  # the semi-axis is 0.93 mm
    found = compare_contact(narrow, recipe=load_recipe("race"), tolerance=0.9)
    assert found.verdict == "outside validity"
    assert "shoulder stands at 0.800 mm" in " ".join(found.warnings)
