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
    FORCE_ROUND_OFF,
    LOOSE_BALL,
    LOOSE_RING,
    MOST_ROUNDS,
    OPEN,
    SETTLED,
    RingNumbers,
    _hold_forces,
    _place_by_load,
    beyond_groove,
    hold_contacts,
    settle_round,
    settle_ruled_ring,
)
from analytic.loads.ring_series import correct_balls, ring_numbers
from analytic.loads.state import ring_state
from analytic.loads.turning import TurningRule, ruled_forces
from analytic.numerics.records import Record, Records
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle
from tests.analytic.specimens import with_clearance

SOLVED = ContactAngle(rule="solved")
SERIES: dict[str, Any] = {
    "axial_load": np.array([310.0, 0.0, 22.0]),
    "radial_load_x": np.array([540.0, 870.0, -3.0]),
    "moment_y": np.array([-1.9, 0.0, 0.4]),
}
SPEED = 900.0
WANTED = (310.0, 540.0, -20.0, 30.0, -11.0)  # N, moments over R
LOOSE = (np.arange(9) == 4) * 1.0  # the ball that a radial load along x does not reach


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
    for name in ("inner_load", "outer_load"):
        first, mirrored = (getattr(each, name)[0] for each in found)
        np.testing.assert_allclose(mirrored, first, rtol=1e-6, atol=1e-8)  # N; rounds end at 1e-9 N
    assert found[0].inner_load.min() < weight


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


def test_a_ball_is_beyond_its_groove_past_a_right_angle_if_it_is_loaded(bearing_6205: Bearing) -> None:
    """The speed moves it there, unless the rings have moved by their play and half of the groove centres' distance."""
    grooves = numbers_of(bearing_6205).grooves
    by_load = grooves.play + grooves.distance / 2
    for angle, load, moved, expected in (
        (np.pi / 2 - 1e-3, 3.0, 0.0, 0.0),
        (np.pi / 2 + 1e-3, 3.0, 0.0, np.pi / 2 + 1e-3),
        (-np.pi / 2 - 1e-3, 3.0, 0.0, np.pi / 2 + 1e-3),
        (np.pi / 2 + 1e-3, 0.0, 0.0, 0.0),
        (np.pi / 2 + 1e-3, 3.0, 0.99 * by_load, np.pi / 2 + 1e-3),
        (np.pi / 2 + 1e-3, 3.0, 1.01 * by_load, np.pi / 2 + 1e-3),
    ):
        for race in (0, 1):
            ring, balls = at_rest(bearing_6205, (0.0,) * 5)
            ring.place[1] = moved  # along x, towards the first ball
            balls["angle"][3, race], balls["load"][3, race] = angle, load
            found = beyond_groove(grooves, ring, balls)
            assert found.angle == pytest.approx(expected, rel=1e-12)
            assert found.moved == pytest.approx(moved, rel=1e-12)
            assert found.is_by_load == (moved > by_load)


def test_a_ball_whose_groove_centres_have_passed_needs_no_load(bearing_6205: Bearing) -> None:
    """Rings that have moved by more than the centres are apart; the ball opposite to the load is on the other side."""
    grooves = numbers_of(bearing_6205).grooves
    apart = grooves.distance - grooves.play
    for moved, has_passed in ((-0.99 * apart, False), (-1.01 * apart, True)):
        ring, balls = at_rest(bearing_6205, (0.0,) * 5)
        ring.place[1] = moved
        balls["angle"][0] = np.pi
        found = beyond_groove(grooves, ring, balls)
        assert (found.angle, found.is_by_load) == ((np.pi, True) if has_passed else (0.0, False))


def test_the_forces_of_a_round_are_inertia_friction_and_weight_as_vectors(bearing_6205: Bearing) -> None:
    """Friction acts along t_i = (sin al_i, -cos al_i) and t_o = (-sin al_o, cos al_o), on the ring the other way."""
    ring, balls = at_rest(bearing_6205, WANTED)
    random = np.random.default_rng(3)
    balls["angle"], balls["weight"] = random.uniform(0.1, 0.6, (9, 2)), random.uniform(-0.02, 0.02, (9, 2))
    turning = random.uniform(0.1, 0.5, (3, 9))
    for name, values in zip(("centrifugal", "inner_friction", "outer_friction"), turning, strict=True):
        balls["turning"][name] = values
    ring.force, balls["own"] = 7.0, 0.3  # of the last round
    centrifugal, at_inner, at_outer = turning
    inner, outer = balls["angle"].T
    on_inner = at_inner[:, None] * np.stack([np.sin(inner), -np.cos(inner)], axis=1)
    on_outer = at_outer[:, None] * np.stack([-np.sin(outer), np.cos(outer)], axis=1)
    own = centrifugal[:, None] * [1.0, 0.0] + on_inner + on_outer + balls["weight"]
    of_ring = np.array(WANTED) - np.einsum("jki,jk->i", balls["travel"], on_inner)
    step = max(np.abs(own - 0.3).max(), np.abs(of_ring - 7.0).max())
    half, half_balls = ring.copy(), balls.copy()
    assert _hold_forces(ring, balls, 1.0) == pytest.approx(step, rel=1e-12)
    np.testing.assert_allclose(balls["own"], own, rtol=1e-12)
    np.testing.assert_allclose(balls["friction"], on_inner, rtol=1e-12)
    np.testing.assert_allclose(ring.force, of_ring, rtol=1e-12)
    assert _hold_forces(half, half_balls, 0.5) == pytest.approx(step / 2, rel=1e-12)
    np.testing.assert_allclose(half_balls["own"], (own + 0.3) / 2, rtol=1e-12)
    np.testing.assert_allclose(half.force, (of_ring + 7.0) / 2, rtol=1e-12)


@pytest.mark.parametrize("direction", [(1.0, 0.0), (0.0, -1.0), (0.6, 0.8)])
def test_the_change_of_one_balls_force_is_seen(bearing_6205: Bearing, direction: tuple[float, float]) -> None:
    """And a force of round-off beside that of another ball is none."""
    ring, balls = at_rest(bearing_6205, (0.0,) * 5)
    least = FORCE_ROUND_OFF * 0.4
    balls["weight"][2] = 0.4 * np.array(direction)
    for size, is_none in ((0.99 * least, True), (1.01 * least, False)):
        balls["own"] = 0.0
        balls["weight"][5] = size * np.array(direction)
        change = _hold_forces(ring, balls, 1.0)
        assert change == pytest.approx(0.4 * np.abs(direction).max(), rel=1e-12)
        np.testing.assert_array_equal(balls["own"][5], np.zeros(2) if is_none else balls["weight"][5])
    assert _hold_forces(ring, balls, 1.0) == 0.0  # nothing changes any more


@pytest.mark.parametrize("clearance", [20e-6, -14e-6])
def test_a_point_begins_where_one_ball_would_bear_the_load(bearing_6205: Bearing, clearance: float) -> None:
    """Along a radius by play and approach; along the axis, or by a tilt, where the centres are A0 and it apart."""
    bearing = with_clearance(bearing_6205, clearance)
    numbers = numbers_of(bearing)
    grooves = numbers.grooves

    def place(*load: float) -> tuple[Array, float]:
        ring, balls = at_rest(bearing, load)
        hold_contacts(numbers.bearing, balls)
        _place_by_load(grooves, ring, balls)
        return ring.place, float(balls["inner_unit"]["approach"][0] + balls["outer_unit"]["approach"][0])

    for freedom, force in ((0, 310.0), (0, -17.0), (1, 540.0), (2, -20.0), (3, 30.0), (4, -11.0)):
        load = np.zeros(5)
        load[freedom] = force
        found, softness = place(*load)
        approach = softness * abs(force) ** (2 / 3)
        reach = approach + max(grooves.play, 0.0)
        if freedom not in (1, 2):
            longest = (grooves.distance + approach) ** 2 - (grooves.distance - grooves.play) ** 2
            reach = np.sqrt(max(longest, 0.0))
        expected = np.zeros(5)
        expected[freedom] = np.copysign(reach, force)
        np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-15)  # a difference of squares
    both, softness = place(0.0, 300.0, 400.0, 0.0, 0.0)  # a part has the direction of its force
    np.testing.assert_allclose(both[2] / both[1], 4 / 3, rtol=1e-12)
    assert np.hypot(*both[1:3]) == pytest.approx(softness * 500 ** (2 / 3) + max(grooves.play, 0.0), rel=1e-12)
    mixed, softness = place(50.0, 0.0, 200.0, 0.0, 0.0)  # and the smaller one its share
    alone, _ = place(50.0, 0.0, 0.0, 0.0, 0.0)
    assert mixed[0] == pytest.approx(alone[0] / 4, rel=1e-12)
    assert mixed[2] == pytest.approx(softness * 200 ** (2 / 3) + max(grooves.play, 0.0), rel=1e-12)
    tilted, _ = place(0.0, 0.0, 50.0, 0.0, 200.0)
    assert tilted[4] == pytest.approx(place(0.0, 0.0, 0.0, 0.0, 200.0)[0][4], rel=1e-12)
