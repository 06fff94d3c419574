"""How closely the passes of a point with free balls settle."""

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection
from analytic.errors import ConvergenceError
from analytic.free_ball import sliding
from analytic.free_ball.passes import FreeModel
from analytic.free_ball.rounds import STEADY
from analytic.free_ball.sliding import free_settings, settled_points
from analytic.loads.ring_rounds import OPEN, SETTLED, RingLoads
from analytic.loads.ring_series import factors_of, ring_numbers
from analytic.oil.race_resistance import DRY, NO_OIL, RaceResistance
from analytic.scene import ContactAngle
from tests.analytic.free_ball.specimens import angular_contact


def test_the_last_pass_is_steady_to_the_digits_that_a_torque_needs() -> None:
    """Passes before it need not be, and the nodes of the last one change the forces."""
    bearing = angular_contact()
    ring, _ = ring_numbers(bearing, ContactAngle(rule="solved", free=None), down=None)
    settings = free_settings(bearing, creep="closed", inertia=(True, True))
    model = FreeModel(ring, RaceResistance(DRY, DRY, False, False, 0.07, 0.0), settings)
    push, speed = np.array([60.0, 170.0, 480.0]), np.array([610.0, 1450.0, 870.0])  # N, rad/s
    force = np.column_stack([push, np.zeros((push.size, 4))])
    loads = RingLoads(force, speed, (True, True), factors_of(ContactCorrection()))
    space, ends = settled_points(model, loads, NO_OIL, is_ring=False, allowed=np.full(push.size, 0.04))
    end, _, left, tolerance = ends.T[:4]
    np.testing.assert_array_equal(end, SETTLED)
    assert np.all(space.start.last >= 2)
    np.testing.assert_array_equal(tolerance, STEADY)
    assert np.all(left <= STEADY)


def test_a_series_that_does_not_settle_names_the_first_point_that_does_not() -> None:
    """The points behind it were not tried."""
    problem: Any = SimpleNamespace(is_ring=False, bearing=SimpleNamespace(ball_count=11))
    loads: Any = SimpleNamespace(force=np.array([[55.0], [407.0], [913.0], [77.0]]))
    ends = np.array([[SETTLED, 7, 1e-9, 1e-7], [OPEN, 200, 0.31, 0.07], [OPEN, 0, 5.0, 0.2], [SETTLED, 0, 0.0, 0.0]])
    with pytest.raises(ConvergenceError, match="37 N") as refusal:
        sliding._require_settled(problem, cast(Any, None), loads, cast(Any, None), ends)
    assert (refusal.value.residual, refusal.value.tolerance) == (0.31, 0.07)
