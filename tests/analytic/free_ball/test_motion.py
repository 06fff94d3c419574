"""How a free ball and its races move against each other."""

import numpy as np

from analytic.loads.kinematics import ball_kinematics
from tests.analytic.free_ball.specimens import angular_contact, under_thrust


def test_entrainment_and_rolling_are_those_of_the_closed_kinematics() -> None:
    """Of a ball that hardly slips, with the same pitch, in steep contacts: 3e-3 is what slip leaves."""
    bearing = angular_contact()
    balls = under_thrust(bearing, None, load=100.0, speed=1500.0, friction=0.05, creep="closed")
    inner, outer = balls.angle
    radius = float(balls.motion["inner_radius"] + bearing.ball_radius * np.cos(inner))
    own = ball_kinematics(
        inner_speed=1.0,
        inner_angle=inner,
        outer_angle=outer,
        pitch_diameter=2 * radius,
        ball_diameter=bearing.ball_diameter,
        pitch=balls.motion["pitch"],
    )
    assert float(inner) > 0.7  # so that cosines are not 1
    for name in ("inner_entrainment", "outer_entrainment", "inner_rolling_rate", "outer_rolling_rate"):
        np.testing.assert_allclose(balls.motion[name], getattr(own, name), rtol=3e-3, err_msg=name)
