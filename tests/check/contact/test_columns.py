"""A comparison with a number that is not finite is no result; `test_discrepancy` has that of a whole contact."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from analytic.errors import InputError
from fembearing.check.contact.load_series import LoadPoint
from fembearing.check.contact.meshed_region import RingStructure
from fembearing.check.contact.subsurface import NAMES, comparison_below
from fembearing.grid_convergence import Estimate

APPROACH = Estimate(values=(5.9e-6, 5.93e-6), order=3.1, richardson=5.94e-6, mesh=2e-4)
POINT = LoadPoint(
    load=372.0,
    approach=APPROACH,
    others={},
    hertz_approach=6.004e-6,
    tangent=9.4e7,
    tangent_uncertainty=None,  # left out, which is no fault
    verdict="pass",
)
BELOW = comparison_below(
    "lower",
    hertz=dict(zip(NAMES, (0.61e9, 75e-6, 1.1e9, 0.0), strict=True)),
    fe=dict(zip(NAMES, (0.62e9, 74e-6, 1.11e9, 3e-6), strict=True)),
    uncertainty=dict(zip(NAMES, (0.02e9, 0.9e-6, 0.009e9, 4e-6), strict=True)),
)
RING = RingStructure(approach=-0.2125e-6, share=-0.0407, mesh=6e-9, domain=1.5e-9, reach=0.3e-9, uncertainty=7.8e-9)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda: replace(POINT, hertz_approach=math.inf), "the approach by Hertz is inf, under 372 N"),
        (lambda: replace(POINT, tangent=math.nan), "the tangent is nan, under 372 N"),
        (
            lambda: replace(POINT, approach=replace(APPROACH, mesh=math.inf)),
            "uncertainty of the approach is inf",
        ),
        (
            lambda: replace(BELOW, fe=BELOW.fe | {"max_von_mises": math.nan}),
            "the max von mises is nan, finite elements, below the lower surface",
        ),
        (
            lambda: replace(RING, uncertainty=math.nan),
            "the uncertainty is nan, ring: the numbers of the scene",
        ),
    ],
)
def test_a_number_that_is_not_finite_is_refused(change: Callable[[], Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        change()
