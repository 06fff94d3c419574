"""The error of a long ellipse against its closed form."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ellipe

from analytic.loads.balls import LoadEffects, thrust_balls
from analytic.scene import Bearing, ContactAngle, Operation
from analytic.sliding.judge import BELOW_FULL_SPIN
from analytic.sliding.levers import long_ellipse_error


@pytest.mark.parametrize("ratio", [0.0, 1e-9, 3e-3, 0.21, 0.98, 1.0, 1.7])  # the last one is longer along rolling
def test_the_error_of_a_long_ellipse_is_that_of_its_perimeter(bearing_6205: Bearing, ratio: float) -> None:
    operation = Operation(axial_load=np.array([300.0, 1.3]), inner_speed=np.array([31.0, 2.0])).as_series()
    balls = thrust_balls(bearing_6205, ContactAngle(rule="given", value=0.3), operation, LoadEffects())
    contact = replace(balls.contact, semi_axis_x=ratio * balls.contact.semi_axis_y)
    expected = BELOW_FULL_SPIN * (ellipe(1 - min(ratio, 1.0) ** 2) - 1)
    np.testing.assert_allclose(long_ellipse_error(replace(balls, contact=contact)), expected, rtol=1e-12, atol=1e-14)
