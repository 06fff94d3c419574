"""Decisions about the loads of the balls: what is decided without solving twice."""

import numpy as np
import pytest

from analytic.effects.ledger import Ledger
from analytic.effects.loads import chosen_balls
from analytic.errors import InputError
from analytic.scene import Bearing, Operation
from tests.analytic.specimens import idling


@pytest.mark.parametrize(("radial_load", "method"), [(0.0, "thrust"), (400.0, "ring")])
def test_a_radial_load_takes_the_ring(bearing_6205: Bearing, radial_load: float, method: str) -> None:
    scene = idling(bearing_6205)
    operation = Operation(axial_load=np.array([60.0]), inner_speed=np.array([1.7]), radial_load=radial_load).as_series()
    found = chosen_balls(scene, operation, Ledger(scene, 1), correction=None)
    assert (found.balls.method, found.warnings, found.farthest) == (method, (), None)
    assert found.balls.load.shape == (2, 1, 1 if method == "thrust" else bearing_6205.ball_count)


def test_an_operation_becomes_a_series_once() -> None:
    series = Operation(axial_load=np.array([3.0, 5.0]), inner_speed=np.array([7.0])).as_series()
    assert {values.shape for values in vars(series).values()} == {(2,)}
    with pytest.raises(InputError, match="give at least one operating point"):
        Operation(axial_load=np.array([]), inner_speed=np.array([])).as_series()
    with pytest.raises(InputError, match="give equal lengths"):
        Operation(axial_load=np.ones(2), inner_speed=np.ones(3)).as_series()
