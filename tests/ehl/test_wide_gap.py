"""Rolling force of a ball a gap off its race: the numerical solution by its limits, production's formula by it."""

import numpy as np
import pytest

from analytic.contact.geometry import Race
from analytic.scenefile.read import load_scene
from fembearing.ehl.shape import Paraboloid
from validation.ehl.wide_gap import ball_on, extrapolated, force_at, formula


@pytest.mark.parametrize("ellipticity", [0.031, 0.62])
def test_a_narrow_gap_has_the_slope_of_the_far_field(ellipticity: float) -> None:
    """f grows by S/2 for each e-fold of 1/h: the length of the inlet is sqrt(h R_x), and rigid bodies know no other."""
    shape, slope = Paraboloid(rolling_radius=1.0, transverse_radius=1 / ellipticity), 12 * np.pi
    slope /= (3 + 2 * ellipticity) * ellipticity**0.5
    narrow, wide = (force_at(shape, gap, reach=20.0, side=20.0 / ellipticity**0.5) for gap in (1.3e-4, 2.6e-3))
    # The reach is 390 lengths sqrt(h R_x) of the wider gap; cells err by the rest.
    np.testing.assert_allclose(narrow - wide, slope / 2 * np.log(20), rtol=0.02)


def test_lengths_have_no_scale() -> None:
    shape = Paraboloid(rolling_radius=1.0, transverse_radius=9.0)
    found = [force_at(shape, 0.004 * size, reach=0.5 * size**0.5, side=1.5 * size**0.5) for size in (1.0, 0.3)]
    np.testing.assert_allclose(found[0], found[1], rtol=1e-9)  # a parabola looks alike at every gap


@pytest.mark.parametrize(
    ("designation", "race", "gap", "most"),
    [("6207", "inner", 6e-4, 0.04), ("6207", "outer", 2e-3, 0.05), ("6303", "inner", 1.5e-2, 0.06)],
)
def test_the_formula_is_within_its_stated_error(designation: str, race: Race, gap: float, most: float) -> None:
    """Bearings that it is not fitted to; most : the error stated at such a gap, with that of the cells."""
    bearing = load_scene(designation).bearing
    shape, reach, side = ball_on(bearing, race)
    force, change = extrapolated(shape, gap, reach=reach, side=side)
    assert change < 0.01 * force
    assert abs(formula(bearing, race, shape, gap) / force - 1) < most
