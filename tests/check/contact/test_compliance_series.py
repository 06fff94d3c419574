"""A series by the compliance of the pair: against compliances sampled at the load itself, and against single solves."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.contact.compliance import (
    APART,
    BETWEEN,
    PairSeries,
    ends_before_shoulder,
    pair_series,
    sampling_loads,
)
from fembearing.check.contact.load_series import compare_series
from fembearing.check.contact.meshed_region import FADING, STIFFNESS
from fembearing.check.contact.refinement import COMPARED, Wanted, solve_reference
from fembearing.fem.compliance import pair_compliance
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.twin import shared_axes
from fembearing.grid_convergence import CAUTIOUS, LEAST
from fembearing.mesh.race import WIDEST_BLOCK
from fembearing.mesh.recipe import Recipe, load_recipe
from tests.analytic.specimens import present

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
    direct = press_pair(pair_compliance(replace(contact, load=load), recipe=RECIPE, level=2, semi_axes=axes), load=load)
    for name in COMPARED:
        # what the series states for it
        assert getattr(found.quantities, name) == pytest.approx(getattr(direct.quantities, name), rel=BETWEEN), name


@pytest.mark.nightly
@pytest.mark.parametrize("load", [131.0, 400.0])
def test_it_agrees_with_meshes_of_that_load(series: tuple[Contact, PairSeries], load: float) -> None:
    """With far boundary and sides, on levels to 3, within both uncertainties; those of the series are below 0.1 %.

    The stiffness, load over the 1.5th power of the approach, has 1.5 times the uncertainty of the approach.
    """
    contact, over_load = series
    _, estimates = over_load.under(load)
    single = solve_reference(replace(contact, load=load), Wanted(RECIPE, accuracy=5e-4))
    for name, part in single.estimates.items():
        assert abs(estimates[name].value / part.value - 1) < estimates[name].total + part.total, name
        assert estimates[name].total < 1e-3 * (STIFFNESS if name == "stiffness" else 1), name


def test_the_far_boundary_grows_with_the_block_of_each_load(contacts: dict[str, Contact]) -> None:
    """The radius of the ring limits the larger block of the heavier load alone."""
    contact = replace(
        contacts["inner"], rolling_radius=10.0e-3, contact_angle=0.0, shoulder=3.9e-3, far_shoulder=3.9e-3
    )
    over_load = pair_series(contact, recipe=RECIPE, loads=(200.0, 560.0))
    growths = []
    for load in over_load.sampled[:: len(over_load.sampled) - 1]:
        _, estimates = over_load.under(load)
        axes = over_load.coarse.at(load).semi_axes
        block = RECIPE.domain.extent * max(axes)
        growths.append(min(2 * block, WIDEST_BLOCK * contact.rolling_radius) / block)
        first, larger = (
            press_pair(each.at(load), load=load).quantities for each in (over_load.coarse, over_load.beyond)
        )
        expected = (larger.peak_pressure / first.peak_pressure - 1) / (1 - growths[-1] ** -FADING)
        assert estimates["peak_pressure"].beyond == pytest.approx(expected, rel=1e-9), load
    light, heavy = growths
    assert heavy < 1.9 < light == 2


def test_a_light_load_has_neither_far_boundary_nor_sides(contacts: dict[str, Contact]) -> None:
    contact = replace(contacts["outer"], groove_radius=4.9e-3)
    over_load = pair_series(contact, recipe=RECIPE, loads=(1e-4, 2e-4))
    assert not over_load.sides
    _, estimates = over_load.under(1.5e-4)
    for name in COMPARED:
        assert abs(estimates[name].beyond) < 2e-4, name  # the contact is 0.1 % of its ball


def test_samples_are_never_farther_apart_than_that_and_hold_both_ends() -> None:
    for low, high in ((95.0, 95.5), (10.0, 30.0), (3e-3, 870.0)):
        loads = sampling_loads((high, low, 0.4 * low + 0.6 * high))
        assert (loads[0], loads[-1]) == (low, high)
        assert max(np.divide(loads[1:], loads[:-1])) <= APART * (1 + 1e-12)


def test_loads_near_the_shoulder_are_solved_on_meshes(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    """All quantities of the others are there; the law goes through all. A load over the shoulder is not judged."""
    contact = replace(contacts["inner"], shoulder=0.9e-3, far_shoulder=0.9e-3, contact_angle=0.0)
    loads = [70.0, 200.0, 400.0]  # ellipses of 0.53, 0.76 and 0.96 mm
    assert [ends_before_shoulder(replace(contact, load=load)) for load in loads] == [True, True, False]
    found = compare_series(contact, recipe=shallow("race"), loads=loads, tolerance=0.9)
    assert [len(point.quantities) for point in found.points] == [5, 5, 1]
    assert found.law is not None
    assert [point.approach.verdict for point in found.points] == ["pass", "pass", "outside validity"]
    assert "from 400 N on the contact reaches its shoulder" in " ".join(found.warnings)
    over = present(found.points[2].approach.study)
    assert over.richardson is None  # there no order is assumed
    assert over.mesh >= CAUTIOUS * abs(1 - over.values[0] / over.values[1]) + LEAST
