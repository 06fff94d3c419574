"""The compliance of the pair under one load and many: extrapolation, compliances of the load itself, single solves."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.contact.meshed_region import FADING, STIFFNESS, Boundary
from fembearing.check.contact.reference import (
    APART,
    BETWEEN,
    CURVED,
    CURVED_CELLS,
    LEAST,
    LEFT,
    NEARER,
    ORDER,
    PairSeries,
    estimates_of_pair,
    pair_series,
    sampling_loads,
    solve_reference,
)
from fembearing.check.contact.refinement import COMPARED, FORMAL_ORDERS, Wanted
from fembearing.fem.compliance import sampled_pair
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.twin import shared_axes
from fembearing.mesh.race import WIDEST_BLOCK
from fembearing.mesh.recipe import load_recipe

RECIPE = load_recipe("race")
ENDS = (95.0, 560.0)


@pytest.fixture(scope="module", params=[pytest.param("inner", marks=pytest.mark.nightly), "outer"])
def series(request: pytest.FixtureRequest, contacts: dict[str, Contact]) -> tuple[Contact, PairSeries]:
    contact = contacts[request.param]
    return contact, pair_series(contact, recipe=RECIPE, loads=ENDS)


@pytest.mark.parametrize("load", [131.0, 400.0])
def test_between_its_loads_it_agrees_with_a_compliance_sampled_there(
    series: tuple[Contact, PairSeries], load: float
) -> None:
    contact, over_load = series
    assert load not in over_load.sampled
    found, _ = over_load.under(load)
    axes = shared_axes((found.quantities.semi_axis_rolling, found.quantities.semi_axis_transverse))
    _, pair = sampled_pair(replace(contact, load=load), recipe=RECIPE, level=2, semi_axes=axes)
    direct = press_pair(pair, load=load)
    for name in COMPARED:
        # what the series states for it
        assert getattr(found.quantities, name) == pytest.approx(getattr(direct.quantities, name), rel=BETWEEN), name


def test_the_far_boundary_grows_with_the_block_of_each_load(contacts: dict[str, Contact]) -> None:
    """The radius of the ring limits the larger block of the heavier load alone."""
    contact = replace(
        contacts["inner"], rolling_radius=10.0e-3, contact_angle=0.0, shoulder=3.9e-3, far_shoulder=3.9e-3
    )
    over_load = pair_series(contact, recipe=RECIPE, loads=(200.0, 560.0))
    growths = []
    for load in over_load.sampled[:: len(over_load.sampled) - 1]:
        _, estimates = over_load.under(load)
        axes = over_load.blocks.block.at(load).semi_axes
        block = RECIPE.domain.extent * max(axes)
        growths.append(min(2 * block, WIDEST_BLOCK * contact.rolling_radius) / block)
        first, larger = (
            press_pair(each.at(load), load=load).quantities
            for each in (over_load.blocks.block, over_load.blocks.larger)
        )
        expected = (larger.peak_pressure / first.peak_pressure - 1) / (1 - growths[-1] ** -FADING)
        assert estimates["peak_pressure"].beyond == pytest.approx(expected, rel=1e-9), load
    light, heavy = growths
    assert heavy < 1.9 < light == 2


def test_samples_are_never_farther_apart_than_that_and_hold_both_ends() -> None:
    for low, high in ((95.0, 95.5), (10.0, 30.0), (3e-3, 870.0)):
        loads = sampling_loads((high, low, 0.4 * low + 0.6 * high))
        assert (loads[0], loads[-1]) == (low, high)
        assert max(np.divide(loads[1:], loads[:-1])) <= APART * (1 + 1e-12)


EXACT = {"semi_axis_rolling": 0.12e-3, "semi_axis_transverse": 0.7e-3, "peak_pressure": 2.1e9, "approach": 6.2e-6}
OFF = {"semi_axis_rolling": 3e-3, "semi_axis_transverse": -7e-3, "peak_pressure": 2e-3, "approach": 11e-3}
SIZE = (0.7 / 3.97) ** 2


def on_pixels(level: int, contact: Contact) -> Any:
    """A level whose values are off by a power of its cells, and the approach by its curved cells too."""
    values = {name: EXACT[name] * (1 + OFF[name] * level**-ORDER) for name in EXACT}
    values["approach"] /= 1 + CURVED_CELLS * SIZE / level**2
    quantities = Quantities(**values, stiffness=contact.load / values["approach"] ** 1.5)
    axes = EXACT["semi_axis_rolling"], EXACT["semi_axis_transverse"]
    return SimpleNamespace(level=level, contact=contact, quantities=quantities, semi_axes=axes)


@pytest.mark.parametrize("levels", [(1, 2), (1, 2, 3), (2, 3, 4)])
@pytest.mark.parametrize("shoulder", [2.9e-3, 0.9e-3])
def test_levels_are_extrapolated(contacts: dict[str, Contact], levels: tuple[int, ...], shoulder: float) -> None:
    contact = replace(contacts["inner"], ball_radius=3.97e-3, load=372.0, shoulder=shoulder)
    solved = [on_pixels(level, contact) for level in levels]
    found = estimates_of_pair(solved, dict.fromkeys(FORMAL_ORDERS, Boundary(beyond=0.02)), recipe=RECIPE, between=2e-4)
    assert list(found) == list(FORMAL_ORDERS)
    near = max(0.0, RECIPE.patch.margin_size - min(shoulder, contact.far_shoulder) / 0.7e-3)
    for name, value in EXACT.items():
        assert found[name].limit / value == pytest.approx(1.0, rel=1e-12), name  # round-off
        assert found[name].value / value == pytest.approx(1.02, rel=1e-12), name
        assert found[name].values == tuple(getattr(each.quantities, name) for each in solved)
        assert (found[name].order is None) == (len(levels) == 2)
        own = LEAST + (CURVED + NEARER * near) * SIZE + LEFT * abs(OFF[name]) * levels[-1] ** -ORDER
        assert found[name].mesh == pytest.approx(np.hypot(own, 2e-4), rel=1e-9), name
    assert found["stiffness"].limit == pytest.approx(372.0 / EXACT["approach"] ** 1.5, rel=1e-12)
    assert found["stiffness"].mesh == pytest.approx(STIFFNESS * found["approach"].mesh, rel=1e-12)


@pytest.mark.nightly
@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_finer_levels_agree_within_both_intervals(contacts: dict[str, Contact], pair: str) -> None:
    contact, recipe = contacts[pair], load_recipe("race")
    loose, tight = (solve_reference(contact, Wanted(recipe, accuracy=accuracy)) for accuracy in (5e-4, 1e-4))
    assert [mesh.level for mesh in loose.meshes] == [1, 2]
    assert [mesh.level for mesh in tight.meshes] == [1, 2, 3, 4]
    for name in COMPARED:
        one, other = loose.estimates[name], tight.estimates[name]
        assert one.total <= 5e-4, name
        assert abs(one.value / other.value - 1) < one.total + other.total, name
