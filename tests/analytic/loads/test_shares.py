"""What radial load, moment and inertia do beside the thrust, against the balls that the equilibrium gives."""

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.loads.balls import LoadEffects, ring_balls
from analytic.loads.ring import ring_equilibrium
from analytic.loads.shares import load_distribution_ratio, load_shares, load_waves, own_forces_of_lightest
from analytic.loads.thrust import thrust_equilibrium
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
    alone = Operation(axial_load=np.array([30.0]), inner_speed=np.array([10.0]), radial_load=90.0).as_series()
    exact = load_shares(bearing_6205, ContactAngle(rule="solved", free=0.18), alone)
    # Without the equilibrium of the thrust its load counts without its angle: 1/sin(0.18) = 5.6 times too little.
    assert 1 < found.centrifugal[1] / exact.centrifugal[0] < 5.6


STEEP = ContactAngle(rule="solved", free=0.7)


@pytest.mark.parametrize(
    ("axial", "radial", "moment", "expected", "error"),
    [
        # Ratios of the ring's equilibrium, computed elsewhere; the error of the closed form is of the order of waves^2.
        (10.0, 0.1, 0.0, {2: 0.9741}, 1.5e-3),
        (10.0, 0.0, 0.002, {0: 1.0339, 1: 1.0008, 2: 0.9590, 3: 0.9830, 4: 1.0404}, 2.5e-3),
        (1000.0, 20.0, 0.0, {}, 6e-4),
    ],
)
def test_waves_of_the_ball_loads_are_those_of_the_ring(
    bearing_6205: Bearing, axial: float, radial: float, moment: float, expected: dict[int, float], error: float
) -> None:
    thrust = thrust_equilibrium(bearing_6205, STEEP, axial_load=axial)
    first, second = load_waves(
        bearing_6205,
        axial_load=axial,
        radial_load=radial,
        moment=moment,
        contact_angle=thrust.contact_angle,
        approach=thrust.approach,
    )
    ring = ring_equilibrium(bearing_6205, STEEP, axial_load=axial, radial_load_x=radial, moment_y=moment)
    ratio = ring.inner_load / thrust.ball_load
    for ball, value in expected.items():
        assert ratio[ball] == pytest.approx(value, abs=5e-5)  # four digits are given
    closed = 1 + first * np.cos(ring.azimuth) + second * np.cos(2 * ring.azimuth)
    np.testing.assert_allclose(closed, ratio, atol=error)


def test_waves_that_are_not_small_unload_balls(bearing_6205: Bearing) -> None:
    operation = Operation(axial_load=np.array([10.0]), inner_speed=np.array([12.566]), radial_load=1.6).as_series()
    found = load_shares(bearing_6205, STEEP, operation)
    assert found.waves == pytest.approx([0.158 + 7.76], rel=1e-3)
    balls = ring_balls(bearing_6205, STEEP, operation, LoadEffects(centrifugal=False, gyroscopic=False))
    assert np.count_nonzero(balls.load[0] == 0) == 4  # of nine
    assert own_forces_of_lightest(bearing_6205, operation, balls) == (np.inf, np.inf, np.inf)


def test_the_lightest_ball_under_thrust_is_any(bearing_6205: Bearing) -> None:
    operation = Operation(axial_load=np.array([300.0]), inner_speed=np.array([700.0])).as_series()
    found = load_shares(bearing_6205, STEEP, operation)
    assert found.thrust is not None
    outward, across, weight = own_forces_of_lightest(bearing_6205, operation, found.thrust)
    np.testing.assert_allclose(weight, 2.04e-3 * 9.80665 / found.thrust.load[0, 0], rtol=1e-12)  # round-off
    np.testing.assert_allclose(outward, found.centrifugal, rtol=1e-12)  # round-off
    # Upright all of the friction counts, at the angle its axial part.
    np.testing.assert_allclose(across * np.cos(found.thrust.contact_angle[0, :, 0]), found.pull, rtol=1e-12)
