"""One contact both ways: what is reported against what was solved."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact, Material
from fembearing.compare import discrepancy as module
from fembearing.compare.discrepancy import compare_contact, hertz_quantities
from fembearing.compare.reference import estimates_of
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


def test_meshes_go_on_as_long_as_one_more_could_decide(contacts: dict[str, Contact]) -> None:
    """A PEEK pocket is so wide that its far boundary takes a fifth of 5 %: three meshes are then too few."""
    peek = Material(name="peek", youngs_modulus=3.6e9, poisson_ratio=0.38, density=1300.0, source="test")
    pocket = replace(
        contacts["inner"],
        pair="pocket",
        groove_radius=4.07e-3,
        rolling_radius=-4.07e-3,
        shoulder=4.07e-3,
        contact_angle=0.0,
        load=28.0,
        race_material=peek,
    )
    found = compare_contact(pocket, recipe=load_recipe("race"), tolerance=0.05)
    pressure, domain = estimates_of(found.meshes[:3])["peak_pressure"], found.estimates["peak_pressure"].domain
    assert pressure.mesh < 0.2 * 0.05  # a small share of the tolerance, at which meshing would end
    assert abs(found.hertz.peak_pressure / pressure.value - 1) + pressure.mesh + domain > 0.05  # yet undecided
    assert len(found.meshes) == 4
    assert found.verdict == "pass"


@pytest.mark.parametrize(("room", "valid"), [(1.04, False), (1.06, True)])  # semi-axes from the middle to the shoulder
def test_an_ellipse_within_a_twentieth_of_its_shoulder_is_not_judged(
    contacts: dict[str, Contact], monkeypatch: pytest.MonkeyPatch, room: float, valid: bool
) -> None:
    contact = contacts["inner"]
    solved = replace(hertz_quantities(contact), semi_axis_transverse=0.9e-3)

    def canned(_: Contact, *, level: int, **__: Any) -> Any:
        whole = SimpleNamespace(
            lower=SimpleNamespace(far=np.array([])), semi_axes=(0.1e-3, 0.9e-3)
        )  # no far boundary to look into
        return SimpleNamespace(level=level, quantities=solved, pair=whole)

    monkeypatch.setattr(module, "fitted_solution", lambda *_, **__: canned(contact, level=2))
    monkeypatch.setattr(module, "solve_on_mesh", canned)
    found = compare_contact(replace(contact, shoulder=room * 0.9e-3), recipe=load_recipe("race"), tolerance=0.4)
    assert found.valid == valid
    assert found.verdict == ("pass" if valid else "outside validity")
    assert any("shoulder stands" in warning for warning in found.warnings) != valid
