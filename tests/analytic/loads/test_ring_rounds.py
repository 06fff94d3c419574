"""The rounds of a ring: starts, forces that swing, and rounds that do not settle."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from analytic.errors import ConvergenceError
from analytic.loads.numbers import bearing_numbers
from analytic.loads.ring import ring_equilibrium
from analytic.loads.ring_balance import placed_balls
from analytic.loads.ring_rounds import (
    BY_LOAD,
    BY_PLACE,
    BY_POINT,
    LOOSE_BALL,
    LOOSE_RING,
    MOST_ROUNDS,
    OPEN,
    SETTLED,
    RingNumbers,
    hold_contacts,
    settle_round,
    settle_ruled_ring,
)
from analytic.loads.ring_series import ring_numbers
from analytic.loads.state import correct_balls, ring_state
from analytic.loads.turning import TurningRule, ruled_forces
from analytic.numerics.records import Record, Records
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle

SOLVED = ContactAngle(rule="solved")
SPEED = 900.0
WANTED = (310.0, 540.0, -20.0, 30.0, -11.0)  # N, moments over R
LOOSE = (np.arange(9) == 4) * 1.0  # the ball that a radial load along x does not reach


@pytest.mark.parametrize("start", [BY_PLACE, BY_POINT])
def test_the_equilibrium_does_not_depend_on_the_start(bearing_6205: Bearing, start: int) -> None:
    """From the place, or all, that other factors and loads gave."""
    numbers, rule = numbers_of(bearing_6205), TurningRule(SPEED, True, True)
    (cold, cold_balls), (warm, warm_balls) = (at_rest(bearing_6205, WANTED) for _ in range(2))
    assert settle_ruled_ring(numbers, rule, cold, cold_balls, BY_LOAD).end == SETTLED
    warm.load = 290.0, 555.0, -12.0, 31.0, -9.0
    correct_balls(warm_balls, np.full((1, 2, 4, 1), 0.97))
    assert settle_ruled_ring(numbers, rule, warm, warm_balls, BY_LOAD).end == SETTLED
    before = warm_balls["load"].copy()
    warm.load = WANTED
    correct_balls(warm_balls, np.ones((1, 2, 4, 1)))
    assert settle_ruled_ring(numbers, rule, warm, warm_balls, start).end == SETTLED
    found, expected = warm_balls["load"], cold_balls["load"]
    assert np.abs(found - before).max() > 1.0
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-10 * expected.max())  # tolerance of the residual
    np.testing.assert_allclose(warm_balls["angle"], cold_balls["angle"], rtol=0, atol=1e-10)


@pytest.mark.parametrize("remainder", [-3e-17, 4e-17])
def test_round_off_of_a_force_does_not_lead_a_ball_along_its_race(bearing_6205: Bearing, remainder: float) -> None:
    """Centrifugal force and friction cancel on a ball that nothing loads, beside balls that are pushed by 0.4 N."""
    force = np.array([0.4, 0.4, 0.4, 0.4, remainder, 0.4, 0.4, 0.4, 0.4])
    end, load = pressed(bearing_6205, lambda _: force)
    assert end == SETTLED
    assert (load[0, 4], load[1, 4]) == (0.0, 0.0)
    np.testing.assert_allclose(load[1, [3, 5]], 0.4, rtol=1e-12)


@pytest.mark.parametrize("falls", [1.0, 4.5, 13.0])
def test_forces_that_swing_to_and_fro_are_steadied(bearing_6205: Bearing, falls: float) -> None:
    """A ball that nothing else loads presses by F = 40 N - k F; whole steps would swing between 0 and 40 N for ever."""
    end, load = pressed(bearing_6205, lambda load: LOOSE * (40.0 - falls * load))
    assert end == SETTLED
    assert not load[0, 4]
    np.testing.assert_allclose(load[1, 4], 40.0 / (1 + falls), rtol=1e-10)


@pytest.mark.parametrize("share", [0.02, 0.98, 1.02, 7.0])
def test_friction_that_carries_a_gyroscopic_moment_is_at_most_the_load(bearing_6205: Bearing, share: float) -> None:
    """In proportion to the loads of both races, whose sum is here a share of the moment over the radius or more."""
    numbers, rule, angles = bearing_numbers(bearing_6205), TurningRule(SPEED, True, True), (0.21, 0.33)
    moment = ruled_forces(numbers, rule, angles, (1.0, 2.0)).gyroscopic
    loads = share * np.array([0.3, 0.7]) * moment / bearing_6205.ball_radius
    found = ruled_forces(numbers, rule, angles, (loads[0], loads[1]))
    assert moment > 0
    assert found.gyroscopic == moment
    expected = -loads / max(share, 1.0)
    np.testing.assert_allclose([found.inner_friction, found.outer_friction], expected, rtol=1e-12)


@pytest.mark.parametrize("rpm", [500.0, 700.0, 1000.0, 1720.0, 3000.0])
@pytest.mark.parametrize("lean", [0.0, 0.7])
def test_balls_of_an_upright_shaft_settle_alike_whichever_end_is_up(
    bearing_6205: Bearing, rpm: float, lean: float
) -> None:
    """Their weight lets unloaded balls rise up their grooves, from one race alone to both."""
    loads: dict[str, Any] = {"radial_load_x": 1000.0, "inner_speed": rpm * np.pi / 30}
    weight = bearing_6205.ball_mass * STANDARD_GRAVITY / np.hypot(1.0, lean)
    found = [
        ring_equilibrium(bearing_6205, SOLVED, **loads, ball_weight=(lean * weight, 0.0, side * weight))
        for side in (1, -1)
    ]
    first, mirrored = (each.balls["load"] for each in found)
    np.testing.assert_allclose(mirrored, first, rtol=1e-6, atol=1e-8)  # N; rounds end at 1e-9 N
    assert found[0].balls["load"][..., 0].min() < weight


def test_balls_and_forces_that_do_not_settle_are_reported(bearing_6205: Bearing) -> None:
    assert pressed(bearing_6205, lambda _: np.nan * LOOSE)[0] == LOOSE_BALL
    assert pressed(bearing_6205, lambda load: LOOSE * np.where(load < 20.0, 40.0, 3.0))[0] == OPEN
    ring, balls = at_rest(bearing_6205, (310.0, np.nan, 0.0, 0.0, 0.0))
    rule = TurningRule(SPEED, True, True)
    assert settle_ruled_ring(numbers_of(bearing_6205), rule, ring, balls, BY_LOAD).end == LOOSE_RING
    with pytest.raises(ConvergenceError, match=r"a ball between its races did not converge.*the ball's mass"):
        ring_equilibrium(bearing_6205, SOLVED, radial_load_x=310.0, inner_speed=1e160)  # a force of no number


def numbers_of(bearing: Bearing) -> RingNumbers:
    return ring_numbers(bearing, SOLVED)


def at_rest(bearing: Bearing, load: tuple[float, ...]) -> tuple[Record, Records]:
    """A ring under a load, N, that has not moved, and its balls."""
    ring = ring_state()
    ring.load = load
    return ring, placed_balls(bearing)


def pressed(bearing: Bearing, outward: Callable[[Array], Array]) -> tuple[int, Array]:
    """How the rounds end with outward forces, N, that follow the load on the outer race; and the loads, (2, Z)."""
    numbers, (ring, balls) = numbers_of(bearing), at_rest(bearing, (0.0, 310.0, 0.0, 0.0, 0.0))
    settle_ruled_ring(numbers, TurningRule(0.0, False, False), ring, balls, BY_LOAD)
    for number in range(MOST_ROUNDS):
        hold_contacts(numbers.bearing, balls)
        balls["turning"]["centrifugal"] = outward(balls["load"][:, 1])
        end = settle_round(numbers.grooves, ring, balls, number, 0.0).end
        if end != OPEN:
            return end, balls["load"].T
    return OPEN, balls["load"].T
