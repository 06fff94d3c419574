"""Loads of the balls alone, without their friction."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.races import loaded_balls_of
from analytic.scene import Bearing, Operation
from analytic.torque import friction_torque
from tests.analytic.specimens import idling


@pytest.mark.parametrize(("radial_load", "method"), [(0.0, "thrust"), (400.0, "ring")])
def test_a_radial_load_takes_the_ring(bearing_6205: Bearing, radial_load: float, method: str) -> None:
    operation = Operation(axial_load=np.array([60.0]), inner_speed=np.array([1.7]), radial_load=radial_load)
    scene = replace(
        idling(bearing_6205), operation=operation, effects={"load_distribution": "on"} if radial_load else {}
    )
    balls = loaded_balls_of(scene)
    assert balls.method == method
    assert balls.load.shape == (2, 1, 1 if method == "thrust" else bearing_6205.ball_count)
    heaviest = friction_torque(scene).ball_load
    np.testing.assert_allclose(balls.load.max(), heaviest, rtol=1e-9)  # solved to 1e-12, with the same effects
