"""The correction for finite geometry under thrust: its factors follow each load, and need no iteration."""

from dataclasses import replace

import numpy as np

from analytic.contact.finite_geometry import RaceCorrections, finite_geometry_factors, race_shape
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Array, Bearing, ContactAngle

NAMES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
SOLVED = ContactAngle(rule="solved", free=0.18)


def correction_under(bearing: Bearing, axial: Array) -> RaceCorrections:
    return corrections_of(bearing, thrust_equilibrium(bearing, SOLVED, axial_load=axial))


def test_factors_at_the_hertz_equilibrium_are_those_at_the_corrected_one(bearing_6205: Bearing) -> None:
    """Once more from the equilibrium of the corrected contacts: the iteration that `corrections_of` leaves out."""
    loads = np.array([50.0, 1000.0, 3000.0])
    first = correction_under(bearing_6205, loads)
    balls = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads, correction=first.correction)
    for race in ("inner", "outer"):
        shape = race_shape(bearing_6205, race, contact_angle=balls["angle"][:, 0], ball_load=balls["load"][:, 0])
        again = finite_geometry_factors(shape)
        for name in NAMES:
            before, after = (np.asarray(getattr(f, name)) for f in (getattr(first, race).factors, again.factors))
            np.testing.assert_allclose(after, before, rtol=1.5e-4)  # as the docstring of the module says
    hertz = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads)
    assert (np.abs(balls["angle"] / hertz["angle"] - 1) > 1e-4).all()  # there was something to leave out


def test_a_ball_without_load_has_factors_of_1(bearing_6205: Bearing) -> None:
    ring = ring_equilibrium(bearing_6205, SOLVED, axial_load=[10.0, 44.0], radial_load_x=[700.0, 900.0])
    found, unloaded = corrections_of(bearing_6205, ring.balls), ring.balls["load"] == 0
    assert unloaded.any()
    for side, race in enumerate((found.inner, found.outer)):
        np.testing.assert_array_equal(np.asarray(race.factors.approach) == 1, unloaded[..., side])


def test_unknown_shoulders_are_typical_ones_and_their_spread_is_uncertain(bearing_6205: Bearing) -> None:
    """Shoulders of 0.1 to 0.25 ball diameters, on one race alone; 0.1 is 1.4 to 1.8 mm off, 1.5 mm is 0.38 radii."""
    loads, groove = np.array([90.0, 1500.0]), bearing_6205.outer.groove_radius

    def with_outer(half_width: float | None) -> RaceCorrections:
        outer = replace(bearing_6205.outer, shoulder_half_width=half_width)
        return correction_under(replace(bearing_6205, outer=outer), loads)

    found = with_outer(None)
    assert not found.outer.covered.any()
    assert not found.warnings  # the uncertainty says it
    for height in (0.12, 0.19, 0.25):
        there = with_outer(float(np.sqrt(groove**2 - (groove - height * bearing_6205.ball_diameter) ** 2)))
        for name in NAMES:
            apart = np.abs(np.asarray(getattr(there.outer.factors, name)) - getattr(found.outer.factors, name))
            assert (apart <= found.outer.uncertainty[name]).all()
            np.testing.assert_array_equal(getattr(found.inner.factors, name), getattr(there.inner.factors, name))
            if height == 0.19:
                np.testing.assert_allclose(apart, 0.0, atol=1e-15)
            elif name == "approach":
                assert (apart > 1e-4).any()  # the shoulder acts
