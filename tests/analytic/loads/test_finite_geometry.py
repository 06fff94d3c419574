"""The correction for finite geometry under thrust: its factors follow each load, and need no iteration."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.finite_geometry import finite_geometry_factors, race_shape
from analytic.loads.balls import LoadEffects, ring_balls, thrust_balls
from analytic.loads.finite_geometry import corrections_of, thrust_correction
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Bearing, ContactAngle, Operation

NAMES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
SOLVED = ContactAngle(rule="solved", free=0.18)
STILL = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)


def test_factors_at_the_hertz_equilibrium_are_those_at_the_corrected_one(bearing_6205: Bearing) -> None:
    """Once more from the equilibrium of the corrected contacts: the iteration that thrust_correction leaves out."""
    loads = np.array([50.0, 1000.0, 3000.0])
    first = thrust_correction(bearing_6205, SOLVED, axial_load=loads)
    balls = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads, correction=first.correction)
    for race in ("inner", "outer"):
        shape = race_shape(bearing_6205, race, contact_angle=balls.contact_angle, ball_load=balls.ball_load)
        again = finite_geometry_factors(shape)
        for name in NAMES:
            before, after = (np.asarray(getattr(f, name)) for f in (getattr(first, race).factors, again.factors))
            np.testing.assert_allclose(after, before, rtol=1.5e-4)  # as the docstring of the module says
    hertz = thrust_equilibrium(bearing_6205, SOLVED, axial_load=loads)
    assert (np.abs(balls.contact_angle / hertz.contact_angle - 1) > 1e-4).all()  # there was something to leave out


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_loaded_balls_take_the_factors_of_their_loads(bearing_6205: Bearing, race: str) -> None:
    loads = np.array([90.0, 400.0])
    thrust = Operation(axial_load=loads, inner_speed=np.zeros(2))
    alike = corrections_of(bearing_6205, thrust_balls(bearing_6205, SOLVED, thrust, STILL))
    expected = getattr(thrust_correction(bearing_6205, SOLVED, axial_load=loads), race).factors
    for name in NAMES:
        np.testing.assert_array_equal(getattr(getattr(alike, race).factors, name), getattr(expected, name))
    aside = Operation(axial_load=loads / 9, inner_speed=np.zeros(2), radial_load=np.array([700.0, 900.0]))
    balls = ring_balls(bearing_6205, SOLVED, aside, replace(STILL, load_distribution=True))
    approach = np.asarray(getattr(corrections_of(bearing_6205, balls), race).factors.approach)
    assert np.any(balls.load == 0)
    np.testing.assert_array_equal(approach == 1, balls.load[0] == 0)


def test_unknown_shoulders_are_typical_ones_and_their_spread_is_uncertain(bearing_6205: Bearing) -> None:
    """Shoulders of 0.1 to 0.25 ball diameters, on one race alone; 0.1 is 1.4 to 1.8 mm off, 1.5 mm is 0.38 radii."""
    loads = np.array([90.0, 1500.0])
    outer = replace(bearing_6205.outer, shoulder_half_width=None)
    found = thrust_correction(replace(bearing_6205, outer=outer), SOLVED, axial_load=loads)
    known = thrust_correction(bearing_6205, SOLVED, axial_load=loads)
    for name in NAMES:
        np.testing.assert_array_equal(getattr(found.inner.factors, name), getattr(known.inner.factors, name))
    assert not found.outer.covered.any()
    assert not found.warnings  # the uncertainty says it
    groove, spread = bearing_6205.outer.groove_radius, {name: np.zeros(2) for name in NAMES}
    for height in (0.12, 0.16, 0.19, 0.22, 0.25):
        width = float(np.sqrt(groove**2 - (groove - height * bearing_6205.ball_diameter) ** 2))
        at = replace(bearing_6205, outer=replace(bearing_6205.outer, shoulder_half_width=width))
        there = thrust_correction(at, SOLVED, axial_load=loads).outer
        for name in NAMES:
            apart = np.abs(np.asarray(getattr(there.factors, name)) - getattr(found.outer.factors, name))
            spread[name] = np.maximum(spread[name], apart)
            assert (apart <= found.outer.uncertainty[name]).all()
            if height == 0.19:
                np.testing.assert_allclose(apart, 0.0, atol=1e-15)
    assert (spread["approach"] > 1e-4).any()  # the shoulder acts
