"""A ball between two grooves: least energy by another method, and forces as derivatives of the energy."""

from typing import NamedTuple

import numpy as np
import pytest
from scipy.optimize import minimize

from analytic.loads.ball_balance import BallBalance, contact_tangent, gap_to_race, grooves_of, in_series, settled_ball
from analytic.loads.numbers import play_and_free_angle
from analytic.scene import Array, Bearing, ContactAngle

PLAY = 11e-6  # m
INNER, OUTER = 2.5e10, 2.3e10  # N/m^1.5
PLACES = np.array([[9e-6, 112e-6], [26e-6, -47e-6], [14e-6, 3e-6], [-31e-6, 20e-6]])  # loaded three times, then not
PUSH = np.array([[7.1, -0.6], [21.0, 0.4], [3.3, 0.0], [12.0, 0.2]])  # N


class Balls(NamedTuple):
    """n balls that have settled, with the fields of BallBalance."""

    energy: Array  # (n,)
    force: Array  # (n, 2)
    tangent: Array  # (n, 2, 2)
    inner_load: Array
    outer_load: Array
    inner_arm: Array  # (n, 2)
    outer_arm: Array


def ball(bearing: Bearing, places: np.ndarray, push: np.ndarray, *, near: tuple[float, float] = (0.0, 0.0)) -> Balls:
    softness = (INNER ** (-2 / 3), OUTER ** (-2 / 3))
    settled = [
        settled_ball(grooves_of(bearing, PLAY), tuple(place), softness, tuple(force), near)
        for place, force in zip(places, push, strict=True)
    ]
    assert all(each.left <= each.tolerance for each in settled)
    energy, force, tangent, *rest = (np.array(values) for values in zip(*(each[:7] for each in settled), strict=True))
    return Balls(energy, force, tangent[:, [[0, 1], [1, 2]]], *rest)


def stretched(vector: np.ndarray, length: float) -> float:
    return max(float(np.hypot(*vector)) - length, 0.0)


@pytest.mark.parametrize("push", [0 * PUSH, PUSH])
def test_a_ball_settles_where_its_energy_is_least(bearing_6205: Bearing, push: np.ndarray) -> None:
    lengths = [groove.groove_radius - bearing_6205.ball_radius for groove in (bearing_6205.inner, bearing_6205.outer)]
    balance = ball(bearing_6205, PLACES, push)
    for index, (place, force) in enumerate(zip(PLACES, push, strict=True)):
        span = place + np.array([bearing_6205.groove_centre_distance - PLAY, 0.0])

        def energy(offset: np.ndarray, span: np.ndarray = span, force: np.ndarray = force) -> float:
            centre = np.array([lengths[1], 0.0]) + offset * 1e-6
            springs = INNER * stretched(span - centre, lengths[0]) ** 2.5 + OUTER * stretched(centre, lengths[1]) ** 2.5
            return float(0.4 * springs - force @ (offset * 1e-6)) * 1e6

        options = {"xatol": 1e-9, "fatol": 1e-13, "maxiter": 4000, "maxfev": 4000}
        least = minimize(energy, np.array([1.0, span[1] * 0.6e6]), method="Nelder-Mead", options=options)
        np.testing.assert_allclose(balance.energy[index] * 1e6, least.fun, atol=1e-7)  # of 1e3 uJ: a simplex's accuracy


@pytest.mark.parametrize("push", [0 * PUSH, PUSH])
def test_force_and_tangent_are_derivatives_of_the_energy(bearing_6205: Bearing, push: np.ndarray) -> None:
    step = 3e-10  # m, against approaches of 3 um: differences are right to 1e-8
    balance = ball(bearing_6205, PLACES, push)
    for direction in (0, 1):
        shift = np.eye(2)[direction] * step
        above, below = (ball(bearing_6205, PLACES + sign * shift, push) for sign in (1, -1))
        force, tangent = (above.energy - below.energy) / (2 * step), (above.force - below.force) / (2 * step)
        np.testing.assert_allclose(balance.force[:, direction], force, atol=1e-5)  # N: round-off of 1 mJ over the step
        np.testing.assert_allclose(balance.tangent[:, :, direction], tangent, rtol=1e-5, atol=1e3)  # of 1e8 N/m
    assert np.all(balance.inner_load[:3] > 0.5)
    assert balance.inner_load[3] == 0
    np.testing.assert_allclose(np.hypot(*balance.force.T), balance.inner_load, rtol=1e-12)
    np.testing.assert_allclose(balance.outer_load[3], np.hypot(*push[3]), rtol=1e-12)
    if not push.any():
        np.testing.assert_array_equal(balance.inner_arm, balance.outer_arm)


def test_springs_in_series_are_those_of_the_sum_of_their_softness() -> None:
    """(I^-1 + O^-1)^-1, for a soft direction across a stiff one; and two slack springs."""
    inner, outer = contact_tangent(3e7, 2e5, (0.8, 0.6)), contact_tangent(5e7, 1e5, (0.28, -0.96))
    whole = [np.array([[each[0], each[1]], [each[1], each[2]]]) for each in (inner, outer)]
    np.testing.assert_allclose(np.linalg.eigvalsh(whole[0]), [2e5, 3e7], rtol=1e-12)
    expected = np.linalg.inv(sum(np.linalg.inv(each) for each in whole))
    rr, ra, aa = in_series(inner, outer)
    np.testing.assert_allclose([[rr, ra], [ra, aa]], expected, rtol=1e-12)  # 1e-16 times the conditions of 150 and 500
    assert in_series((0.0, 0.0, 0.0), (0.0, 0.0, 0.0)) == (0.0, 0.0, 0.0)


def test_a_ball_is_moved_from_where_it_lies_without_its_force(bearing_6205: Bearing) -> None:
    """On the line of both groove centres, its outer contact as deep as that load presses it; else nothing moves it."""
    grooves, softness = grooves_of(bearing_6205, PLAY), (INNER ** (-2 / 3), OUTER ** (-2 / 3))
    for place, push in zip(PLACES, PUSH, strict=True):
        still, pushed = (
            settled_ball(grooves, tuple(place), softness, own, (0.0, 0.0)) for own in ((0.0, 0.0), (push[0], push[1]))
        )
        assert still.moved == (0.0, 0.0)
        if still.inner_load == 0:
            assert pushed.moved == (0.0, 0.0)
            continue
        line = np.array(still.outer_arm) / np.hypot(*still.outer_arm)
        before = line * (grooves.outer_length + softness[1] * still.outer_load ** (2 / 3))
        # The stretch by a load of 30 N is 1 um; its square root amplifies round-off of the places.
        np.testing.assert_allclose(np.array(pushed.outer_arm) - before, pushed.moved, atol=1e-15)
        assert np.hypot(*pushed.moved) > 1e-8


def test_a_ball_lies_in_the_middle_of_its_clearance_or_where_its_own_force_presses_it(bearing_6205: Bearing) -> None:
    grooves = grooves_of(bearing_6205, play_and_free_angle(bearing_6205, ContactAngle(rule="solved"))[0])
    clearance = bearing_6205.diametral_clearance / 2  # of the ball, between concentric races
    for own, share in (((0.0, 0.0), (0.5, 0.5)), ((1e-6, 0.0), (1.0, 0.0)), ((-1e-6, 0.0), (0.0, 1.0))):
        ball = settled_ball(grooves, (0.0, 0.0), (1.3e-9, 1.1e-9), own, (0.0, 0.0))
        loads = ball.inner_load, ball.outer_load
        gaps = [gap_to_race(grooves, ball.inner_arm, ball.outer_arm, loads, race) for race in range(2)]
        for race in range(2):
            if loads[race] == 0.0:
                np.testing.assert_allclose(gaps[race], share[race] * clearance, rtol=1e-3)  # of 0.1 pm of approach


@pytest.mark.parametrize("side", [1, -1])
def test_a_ball_lies_where_it_lay_when_a_race_lets_go_of_it(bearing_6205: Bearing, side: int) -> None:
    """Its contact angles, of which its speeds and so its own forces follow, do not jump."""
    grooves, softness, own = grooves_of(bearing_6205, PLAY), (1.3e-9, 1.1e-9), (side * 0.031, 0.017)

    def at(away: float) -> BallBalance:
        return settled_ball(grooves, (-away, 2e-6), softness, own, (0.0, 0.0))

    race = 0 if side > 0 else 1  # which its own force takes it off

    def load(away: float) -> float:
        found = at(away)
        return (found.inner_load, found.outer_load)[race]

    near, far = 0.0, 150e-6  # m
    assert load(near) > 0 == load(far)
    for _ in range(60):
        middle = (near + far) / 2
        near, far = (middle, far) if load(middle) > 0 else (near, middle)
    before, after = at(near - 1e-12), at(far + 1e-12)
    for name in ("inner_arm", "outer_arm"):
        first, then = getattr(before, name), getattr(after, name)
        assert np.arctan2(then[1], then[0]) == pytest.approx(np.arctan2(first[1], first[0]), abs=1e-6)
    lean = np.arctan2(after.inner_arm[1], after.inner_arm[0]) - np.arctan2(after.outer_arm[1], after.outer_arm[0])
    assert abs(lean) > 0.1
