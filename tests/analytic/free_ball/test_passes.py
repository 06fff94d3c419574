"""How closely the passes of a point with free balls settle."""

import numpy as np

from analytic.free_ball.rounds import STEADY
from analytic.solve.model import model_of
from analytic.solve.records import SETTLED
from analytic.solve.solution import points_of, solved
from tests.analytic.free_ball.specimens import COUNTED, angular_contact, dry_scene


def test_the_last_pass_is_steady_to_the_digits_that_a_torque_needs() -> None:
    """Passes before it need not be, and the nodes of the last one change the forces."""
    push, speed = np.array([60.0, 170.0, 480.0]), np.array([610.0, 1450.0, 870.0])  # N, rad/s
    scene = dry_scene(angular_contact(), None, 0.07, load=push, speed=speed)
    found = solved(model_of(scene, COUNTED, creep="closed", allowed=0.04), points_of(scene.operation, 0.0)).points
    np.testing.assert_array_equal(found["status"], SETTLED)
    assert np.all(found["passes"] >= 2)
    np.testing.assert_array_equal(found["tolerance"], STEADY)
    assert np.all(found["left"] <= STEADY)
