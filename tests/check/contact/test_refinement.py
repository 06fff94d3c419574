"""The time of a level, in seconds and in words."""

from types import SimpleNamespace
from typing import Any

import pytest

from analytic.words import about
from fembearing.check.contact.refinement import predicted_seconds


def solved(unknowns: int, *, level: int = 2, seconds: float = 7.0) -> Any:
    return SimpleNamespace(unknowns=unknowns, level=level, seconds=seconds)


@pytest.mark.parametrize(("unknowns", "power", "tolerance"), [(1, 0, 1e-2), (10**9, 6, 1e-3)])
def test_few_unknowns_cost_the_set_up_and_many_the_square_of_their_number(
    unknowns: int, power: int, tolerance: float
) -> None:
    """They grow as the cube of the level; the tolerance is the share of the other parts."""
    assert predicted_seconds(3, known=solved(unknowns)) == pytest.approx(7.0 * 1.5**power, rel=tolerance)


def test_a_duration_has_one_digit_and_minutes_from_a_minute_and_a_half_on() -> None:
    for seconds, words in ((0.034, "0.03 s"), (7.4, "7 s"), (83.0, "80 s"), (89.9, "90 s"), (91.0, "2 min")):
        assert about(seconds) == f"about {words}"
    assert about(310.0) == "about 5 min"
