"""What radial load, moment and inertia do beside the thrust, against the balls that the equilibrium gives."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.loads.balls import LoadEffects, ring_balls
from analytic.loads.shares import load_distribution_ratio, load_shares
from analytic.scene import Bearing, ContactAngle, Operation


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


def test_shares_are_those_of_the_heaviest_ball_of_the_ring(bearing_6205: Bearing) -> None:
    """The centrifugal force, m w_m^2 d_m/2, over the load that the equilibrium of the ring gives that ball."""
    angle = ContactAngle(rule="solved", free=0.18)
    operation = Operation(
        axial_load=np.array([400.0, 5.0]), inner_speed=np.array([900.0, 900.0]), radial_load=np.array([0.0, 800.0])
    ).as_series()
    found = load_shares(bearing_6205, angle, operation)
    still = LoadEffects(centrifugal=False, gyroscopic=False)
    balls = ring_balls(bearing_6205, angle, operation, still)
    inner = balls.load[0]
    orbit, load = 900.0 * balls.motion.cage_speed[np.arange(2), inner.argmax(axis=1)], inner.max(axis=1)
    force = bearing_6205.ball_mass * orbit**2 * bearing_6205.pitch_diameter / 2
    thrust, radial = found.centrifugal * load / force
    assert thrust == pytest.approx(1.0, rel=1e-6)  # the same ball, by another equilibrium
    assert 1 < radial < 5 / 4.37  # with clearance the heaviest ball carries up to the usual 5 Fr/Z


def test_without_thrust_nothing_bounds_how_unequal_the_balls_are(bearing_6205: Bearing) -> None:
    operation = Operation(axial_load=np.array([0.0, 30.0]), inner_speed=np.array([10.0, 10.0]), radial_load=90.0)
    found = load_shares(bearing_6205, ContactAngle(rule="solved", free=0.18), operation.as_series())
    assert found.thrust is None
    np.testing.assert_array_equal(np.isinf(found.unequal), [True, False])
    assert np.all(found.centrifugal > 0)
