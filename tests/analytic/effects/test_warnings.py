"""Warnings of a torque: of balls that carry enough to matter, and of no others."""

import numpy as np
import pytest

from analytic.effects.warnings import _film
from analytic.oil.mixed import MixedContact

LOAD = np.array([[[310.0, 2.9]], [[325.0, 3.4]]])  # (2, 1, 2) N: the second ball carries 0.94 and 1.05 %


def film(**marked: np.ndarray) -> MixedContact:
    numbers = {name: np.full(LOAD.shape, 0.3) for name in ("asperity_share", "boundary_share", "area_fraction")}
    nothing = np.zeros(LOAD.shape, dtype=bool)
    flags = dict.fromkeys(("capped", "outside_range", "without_film"), nothing) | marked
    return MixedContact(film_thickness=np.full(LOAD.shape, 2e-7), **numbers, **flags)


@pytest.mark.parametrize(("name", "words"), [("capped", "limited to the space"), ("outside_range", "extrapolated")])
def test_the_film_of_a_ball_that_hardly_carries_is_not_warned_of(name: str, words: str) -> None:
    light = np.zeros(LOAD.shape, dtype=bool)
    light[..., 1] = True
    assert list(_film(film(**{name: light}), LOAD, 0)) == []
    (line,) = _film(film(**{name: light}), LOAD, 1)
    assert words in line
    assert "outer race" in line
