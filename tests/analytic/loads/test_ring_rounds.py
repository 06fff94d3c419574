"""The rounds of a ring: compiled ones against those by any `Turning`, starts, and rounds that do not settle."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection
from analytic.errors import ConvergenceError
from analytic.loads.kinematics import BallKinematics
from analytic.loads.numbers import bearing_numbers
from analytic.loads.ring import RingEquilibrium, ring_equilibrium
from analytic.loads.ring_balance import point_of, ring_points, ring_work
from analytic.loads.ring_rounds import (
    BY_LOAD,
    BY_PLACE,
    BY_POINT,
    LOOSE_RING,
    SETTLED,
    RingLoad,
    RingNumbers,
    settle_ruled_ring,
)
from analytic.loads.ring_series import RowsOfBalls
from analytic.loads.turning import PlacedBalls, RuledTurning, TurningForces, TurningRule
from analytic.scene import Array, Bearing, ContactAngle

SOLVED = ContactAngle(rule="solved")
SERIES: dict[str, Any] = {
    "axial_load": np.array([310.0, 0.0, 22.0]),
    "radial_load_x": np.array([540.0, 870.0, -3.0]),
    "moment_y": np.array([-1.9, 0.0, 0.4]),
}
SPEED = 900.0
LOOSE = (np.arange(9) == 4) * 1.0  # the ball that a radial load along x does not reach


class ByRule:
    """The rule's forces, given round by round."""

    accuracy = 0.0

    def __init__(self, bearing: Bearing, points: int) -> None:
        speed = np.full(points, SPEED)
        self.rule = RuledTurning(bearing=bearing, inner_speed=speed, centrifugal=True, gyroscopic=True)

    def forces(self, balls: PlacedBalls) -> TurningForces:
        return self.rule.forces(balls)

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        return self.rule.motion(inner_angle, outer_angle)


class Pressing(ByRule):
    """Outward forces, N, that follow the load on the outer race."""

    def __init__(self, bearing: Bearing, outward: Callable[[Array], Array]) -> None:
        super().__init__(bearing, 1)
        self.outward = outward

    def forces(self, balls: PlacedBalls) -> TurningForces:
        nothing = np.zeros_like(balls.inner_load)
        return TurningForces(
            centrifugal=nothing + self.outward(balls.outer_load),
            inner_friction=nothing,
            outer_friction=nothing,
            gyroscopic=nothing,
        )


def test_forces_given_round_by_round_lead_to_the_same_equilibrium(bearing_6205: Bearing) -> None:
    by_rule = ring_equilibrium(bearing_6205, SOLVED, **SERIES, inner_speed=SPEED)
    by_rounds = ring_equilibrium(
        bearing_6205, SOLVED, **SERIES, inner_speed=SPEED, turning=ByRule(bearing_6205, len(SERIES["axial_load"]))
    )
    for name, values in vars(by_rule).items():
        if name not in ("free_angle", "inner", "outer"):
            close = 1e-12 * np.abs(values).max()  # the same steps
            np.testing.assert_allclose(getattr(by_rounds, name), values, rtol=0, atol=close, err_msg=name)


def test_a_point_does_not_know_the_others(bearing_6205: Bearing) -> None:
    series = ring_equilibrium(bearing_6205, SOLVED, **SERIES, inner_speed=SPEED)
    for point in range(3):
        alone = ring_equilibrium(
            bearing_6205, SOLVED, **{name: values[point] for name, values in SERIES.items()}, inner_speed=SPEED
        )
        np.testing.assert_array_equal(alone.inner_load, series.inner_load[point])
        np.testing.assert_array_equal(alone.displacement, series.displacement[point])


@pytest.mark.parametrize("start", [BY_PLACE, BY_POINT])
def test_the_equilibrium_does_not_depend_on_the_start(bearing_6205: Bearing, start: int) -> None:
    """From the place, or all, that other factors and loads gave."""
    ring = ring_of(bearing_6205)
    rule, factors = TurningRule(SPEED, True, True), np.ones((2, 4, 1))
    wanted = RingLoad(np.array([310.0, 540.0, -20.0, 30.0, -11.0]), rule, factors)
    other = RingLoad(np.array([290.0, 555.0, -12.0, 31.0, -9.0]), rule, 0.97 * factors)
    points, work = ring_points(2, 9), ring_work(9)
    cold, warm = point_of(points, 0), point_of(points, 1)
    assert settle_ruled_ring(ring, wanted, cold, work, BY_LOAD).end == SETTLED
    assert settle_ruled_ring(ring, other, warm, work, BY_LOAD).end == SETTLED
    before = warm.load.copy()
    assert settle_ruled_ring(ring, wanted, warm, work, start).end == SETTLED
    assert np.abs(warm.load - before).max() > 1.0
    np.testing.assert_allclose(warm.load, cold.load, rtol=0, atol=1e-10 * cold.load.max())  # tolerance of the residual
    np.testing.assert_allclose(warm.angle, cold.angle, rtol=0, atol=1e-10)


@pytest.mark.parametrize("remainder", [-3e-17, 4e-17])
def test_round_off_of_a_force_does_not_lead_a_ball_along_its_race(bearing_6205: Bearing, remainder: float) -> None:
    """Centrifugal force and friction cancel on a ball that nothing loads, beside balls that are pushed by 0.4 N."""
    force = np.array([0.4, 0.4, 0.4, 0.4, remainder, 0.4, 0.4, 0.4, 0.4])
    ring = pressed(bearing_6205, lambda _: force)
    assert (ring.inner_load[4], ring.outer_load[4]) == (0.0, 0.0)
    np.testing.assert_allclose(ring.outer_load[[3, 5]], 0.4, rtol=1e-12)


def test_forces_that_swing_to_and_fro_are_steadied(bearing_6205: Bearing) -> None:
    """A ball that nothing else loads presses by F = 40 N - F; whole steps would swing between 0 and 40 N for ever."""
    ring = pressed(bearing_6205, lambda load: LOOSE * (40.0 - load))
    assert not ring.inner_load[4]
    np.testing.assert_allclose(ring.outer_load[4], 20.0, rtol=1e-10)


def test_balls_and_forces_that_do_not_settle_are_reported(bearing_6205: Bearing) -> None:
    with pytest.raises(ConvergenceError, match=r"a ball between its races did not settle.*the ball's mass"):
        pressed(bearing_6205, lambda _: np.nan * LOOSE)
    with pytest.raises(ConvergenceError, match=r"own forces in the ring's equilibrium did not settle in 200"):
        pressed(bearing_6205, lambda load: LOOSE * np.where(load < 20.0, 40.0, 3.0))
    ring, point, work = ring_of(bearing_6205), point_of(ring_points(1, 9), 0), ring_work(9)
    no_number = RingLoad(np.array([310.0, np.nan, 0.0, 0.0, 0.0]), TurningRule(SPEED, True, True), np.ones((2, 4, 1)))
    assert settle_ruled_ring(ring, no_number, point, work, BY_LOAD).end == LOOSE_RING


def ring_of(bearing: Bearing) -> RingNumbers:
    rows = RowsOfBalls(
        bearing=bearing,
        play=9e-6,
        correction=ContactCorrection(),
        turning=ByRule(bearing, 1),
        speed=np.full(1, SPEED),
    )
    return RingNumbers(bearing_numbers(bearing), rows.numbers, 0.1)


def pressed(bearing: Bearing, outward: Callable[[Array], Array]) -> RingEquilibrium:
    return ring_equilibrium(bearing, SOLVED, radial_load_x=310.0, turning=Pressing(bearing, outward))
