"""What a larger block says of the far boundary: where the effect of its size is known, and on still larger blocks."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import solve_on_mesh
from fembearing.fem.twin import TwinSolution, twin_factors, twin_on_level
from fembearing.mesh import race
from fembearing.mesh.recipe import load_recipe
from fembearing.verify.contact.meshed_region import (
    FADING,
    LEFT_BY_MESHES,
    UNCERTAIN,
    boundary_effect,
    boundary_effect_with_twin,
)

ENDLESS = Quantities(
    semi_axis_rolling=0.12e-3, semi_axis_transverse=0.7e-3, peak_pressure=2.1e9, approach=6.2e-6, stiffness=2.4e10
)


def block(size: float) -> Any:
    """Semi-axes and pressure have a limit, which they near with the assumed power; approach and stiffness have none."""
    left = 3e-3 * size**-FADING
    quantities = Quantities(
        semi_axis_rolling=ENDLESS.semi_axis_rolling * (1 - left),
        semi_axis_transverse=ENDLESS.semi_axis_transverse * (1 + 2 * left),
        peak_pressure=ENDLESS.peak_pressure * (1 - 3 * left),
        approach=ENDLESS.approach * (1 - 2e-3 * np.log(size)),
        stiffness=ENDLESS.stiffness * (1 + 3e-3 * np.log(size)),
    )
    mesh = SimpleNamespace(doflocs=np.array([[0.0, size], [0.3, 0.0]]))
    return SimpleNamespace(quantities=quantities, shoulder=None, pair=SimpleNamespace(lower=SimpleNamespace(mesh=mesh)))


@pytest.mark.parametrize(("size", "further"), [(2.5, 5.0), (3.0, 4.6)])
def test_semi_axes_and_pressure_are_those_of_an_endless_block(size: float, further: float) -> None:
    near = block(size)
    effects = boundary_effect(near, block(further))
    for name in ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure"):
        value = getattr(near.quantities, name) * (1 + effects[name].beyond)
        assert value == pytest.approx(getattr(ENDLESS, name), rel=1e-9)  # round-off
        assert effects[name].domain == pytest.approx(UNCERTAIN * abs(effects[name].beyond), rel=1e-12)


@pytest.mark.parametrize(("size", "further"), [(2.5, 5.0), (3.0, 4.6)])
def test_the_approach_is_that_of_the_larger_block(size: float, further: float) -> None:
    near, far = block(size), block(further)
    effects = boundary_effect(near, far)
    for name in ("approach", "stiffness"):
        value = getattr(near.quantities, name) * (1 + effects[name].beyond)
        assert value == pytest.approx(getattr(far.quantities, name), rel=1e-12)  # round-off
        assert effects[name].domain == pytest.approx(LEFT_BY_MESHES * abs(effects[name].beyond), rel=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("pair", ["inner", "outer", "long"])
def test_the_first_level_predicts_larger_blocks_on_the_second(
    contacts: dict[str, Contact], monkeypatch: pytest.MonkeyPatch, pair: str
) -> None:
    """A block 2.9 times as large for semi-axes and pressure, to their limit; the one twice as large for the approach.

    On the outer race the approach has no limit: the largest block changes it again. The long ellipse has 33 times its
    width, where the first level is off by what the twins do not correct.
    """
    recipe = load_recipe("race")
    long = replace(contacts["inner"], groove_radius=0.5026 * 2 * contacts["inner"].ball_radius, load=7.3)
    contact = long if pair == "long" else contacts[pair]
    coarse = twin_on_level(contact, recipe=recipe, level=1, start=expected_semi_axes(contact, geometry="real"))
    assert coarse is not None
    stated = boundary_effect_with_twin(coarse, recipe=recipe)

    def corrected(further: float) -> dict[str, float]:
        monkeypatch.setattr(race, "FURTHER", further)
        extended = further > 1
        mesh = solve_on_mesh(contact, recipe=recipe, level=2, semi_axes=coarse.ellipse, extended=extended)
        return TwinSolution(mesh=mesh, factors=twin_factors(mesh, recipe=recipe, extended=extended)).corrected

    block, near, far = (corrected(further) for further in (1.0, 2.0, 2.9))
    for name in ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure"):
        beyond = (far[name] / block[name] - 1) / (1 - 2.9**-FADING)
        assert abs(beyond - stated[name].beyond) < stated[name].domain < 5e-4, name
    approach = stated["approach"]
    assert abs(near["approach"] / block["approach"] - 1 - approach.beyond) < approach.domain < 5e-4
    assert pair != "outer" or abs(far["approach"] / near["approach"] - 1) > abs(approach.beyond) / 4
