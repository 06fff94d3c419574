"""Decisions about the loads of the balls: the measure of unequal loads, and what is decided without solving twice."""

import numpy as np
import pytest

from analytic.effects.ledger import Ledger
from analytic.effects.loads import chosen_balls, load_distribution_ratio
from analytic.errors import InputError
from analytic.scene import Bearing, Operation
from tests.analytic.specimens import idling


def test_unequal_balls_add_up_to_the_radial_load_and_to_the_moment() -> None:
    """Loads Q (1 + e cos psi) summed: a radial load and a moment that bring e each bring 2 e together."""
    angle, pitch, uneven, load = 0.37, 39e-3, 0.23, 110.0
    psi = np.arange(7) * 2 * np.pi / 7
    balls = load * (1 + uneven * np.cos(psi))
    axial, across = balls.sum() * np.sin(angle), balls @ np.cos(psi)
    sideways = {"radial_load": across * np.cos(angle), "moment": across * np.sin(angle) * pitch / 2}
    for given in (("radial_load",), ("moment",), ("radial_load", "moment")):
        loads = {"radial_load": 0.0, "moment": 0.0} | {name: sideways[name] for name in given}
        ratio = load_distribution_ratio(axial_load=axial, contact_angle=angle, pitch_diameter=pitch, **loads)
        np.testing.assert_allclose(ratio, len(given) * uneven / 2, rtol=1e-12)  # round-off


def test_the_ratio_is_infinite_without_thrust_and_takes_magnitudes() -> None:
    loads = {"radial_load": [0.0, 3.0], "moment": 0.0, "contact_angle": 0.2, "pitch_diameter": 39e-3}
    np.testing.assert_array_equal(load_distribution_ratio(axial_load=0.0, **loads), [0.0, np.inf])
    with pytest.raises(InputError, match="axial_load must be at least 0"):
        load_distribution_ratio(axial_load=-5.0, **loads)


@pytest.mark.parametrize(("radial_load", "method"), [(0.0, "thrust"), (400.0, "ring")])
def test_a_radial_load_takes_the_ring(bearing_6205: Bearing, radial_load: float, method: str) -> None:
    scene = idling(bearing_6205)
    operation = Operation(axial_load=np.array([60.0]), inner_speed=np.array([1.7]), radial_load=radial_load).as_series()
    balls, warnings = chosen_balls(scene, operation, Ledger(scene, 1), correction=None)
    assert (balls.method, warnings) == (method, [])
    assert balls.load.shape == (2, 1, 1 if method == "thrust" else bearing_6205.ball_count)


def test_an_operation_becomes_a_series_once() -> None:
    series = Operation(axial_load=np.array([3.0, 5.0]), inner_speed=np.array([7.0])).as_series()
    assert {values.shape for values in vars(series).values()} == {(2,)}
    with pytest.raises(InputError, match="give at least one operating point"):
        Operation(axial_load=np.array([]), inner_speed=np.array([])).as_series()
    with pytest.raises(InputError, match="give equal lengths"):
        Operation(axial_load=np.ones(2), inner_speed=np.ones(3)).as_series()
