"""The level that an accuracy needs."""

from types import SimpleNamespace
from typing import Any

import pytest

from fembearing.compare.contact.mesh_refinement import _predicted_level
from fembearing.mesh.recipe import load_recipe

ORDER = 3.0  # of a semi-axis


def coarse_and_fine(change: float) -> list[Any]:
    """The first two levels, a semi-axis apart by `change`."""
    return [
        SimpleNamespace(level=1, shoulder=None, quantities=SimpleNamespace(semi_axis_rolling=0.7e-3 * (1 + change))),
        SimpleNamespace(level=2, shoulder=None, quantities=SimpleNamespace(semi_axis_rolling=0.7e-3)),
    ]


@pytest.mark.parametrize(("missed_by", "level"), [(0.4, 3), (1.7, 3), (2.6, 4), (90.0, 4)])
def test_a_level_is_skipped_where_it_would_miss_by_far(missed_by: float, level: int) -> None:
    """With order 3 the third level has (2/3)^3 of the second one's error; half of that is its interval."""
    limit = 1.3e-3
    interval = missed_by * limit - 8e-5  # less the least uncertainty claimed
    change = 2 * interval * (3 / 2) ** ORDER * (2**ORDER - 1)
    predicted = _predicted_level(
        coarse_and_fine(change), recipe=load_recipe("race"), allowed={"semi_axis_rolling": limit}
    )
    assert predicted == level
