"""Warnings of a torque: of balls that carry enough to matter, and of no others."""

import numpy as np
import pytest

from analytic.effects.warnings import _film
from analytic.solve.records import BALL

LOAD = np.array([[310.0, 325.0], [2.9, 3.4]])  # N: the second ball carries 0.94 % inside and 1.05 % outside


@pytest.mark.parametrize(
    ("name", "words"), [("film_capped", "limited to the space"), ("film_extrapolated", "extrapolated")]
)
def test_the_film_of_a_ball_that_hardly_carries_is_not_warned_of(name: str, words: str) -> None:
    balls = np.zeros((1, 2), BALL)
    balls["load"], balls[name][0, 1] = LOAD, True
    assert list(_film(balls, 0)) == []
    (line,) = _film(balls, 1)
    assert words in line
    assert "outer race" in line
