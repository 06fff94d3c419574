"""How a ball lies between its grooves, against distances and forces as vectors, radial and axial."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.contact.geometry import RACES
from fembearing.creep.place import HeldBall, Lie, UnitContact, free_lengths, unit_under
from tests.analytic.specimens import BEARING_6205

CENTRE = BEARING_6205.outer.bottom_radius - BEARING_6205.outer.groove_radius
FREE = sum(free_lengths(BEARING_6205))
UNITS = UnitContact(2e-6, 2e-5, 1.9e-7), UnitContact(3e-6, 1e-5, 1.7e-7)  # unlike, m under 1 N
THRUST = HeldBall(bearing=BEARING_6205, centre=CENTRE, thrust=83.0, radial=FREE * np.cos(0.2))
RING = replace(THRUST, thrust=0.0, axial=1.04 * FREE * np.sin(0.2))
GIVEN = HeldBall(bearing=BEARING_6205, centre=CENTRE, thrust=83.0, angle=0.47)
UNEVEN = Lie((0.27, 0.34), (212.0, 187.0), CENTRE + 0.2e-3)  # as with friction and inertia


def along(angle: float) -> NDArray[np.float64]:
    return np.array([np.cos(angle), np.sin(angle)])


def approach(k: int, angle: float, load: float) -> float:
    return unit_under(BEARING_6205, RACES[k], angle).approach * load ** (2 / 3)


def test_a_ball_without_load_touches_both_grooves() -> None:
    inner, outer = free_lengths(BEARING_6205)
    assert inner + outer == pytest.approx(BEARING_6205.groove_centre_distance, rel=1e-12)
    bottom = CENTRE + outer + BEARING_6205.ball_radius  # a ball on the bottom of the outer groove
    assert bottom == pytest.approx(BEARING_6205.outer.bottom_radius, rel=1e-12)


def test_thrust_at_rest_finds_its_angle_and_its_load() -> None:
    lie = THRUST.at_rest()
    (angle, other), (load, again) = lie.angles, lie.loads
    assert (angle, load) == (other, again)
    assert load * np.sin(angle) == pytest.approx(83.0, rel=1e-12)  # round-off
    whole = FREE + approach(0, angle, load) + approach(1, angle, load)
    assert whole * np.cos(angle) == pytest.approx(THRUST.radial, rel=1e-9)  # the angle's last step is 1e-10 rad
    ball = free_lengths(BEARING_6205)[1] + approach(1, angle, load)
    assert lie.orbit == pytest.approx(CENTRE + ball * np.cos(angle), rel=1e-12)


def test_a_ring_in_its_place_squeezes_the_ball_by_what_its_centre_is_farther_away() -> None:
    lie = RING.at_rest()
    centre = np.array([RING.radial, RING.axial])
    angle, load = lie.angles[0], lie.loads[0]
    np.testing.assert_allclose(along(angle), centre / np.hypot(*centre), rtol=1e-12)
    squeezed = approach(0, angle, load) + approach(1, angle, load)
    assert squeezed == pytest.approx(np.hypot(*centre) - FREE, rel=1e-9)  # of a difference of lengths
    assert replace(RING, axial=0.0).at_rest().loads == (0.0, 0.0)  # too near to press


def test_a_given_angle_carries_the_thrust() -> None:
    lie = GIVEN.at_rest()
    assert lie.angles == (0.47, 0.47)
    np.testing.assert_allclose(lie.loads, 83.0 / np.sin(0.47), rtol=1e-12)
    assert GIVEN.coordinates(lie, UNITS).size == GIVEN.lacks(lie, (1.0, 2.0), 3.0).size == 0
    assert GIVEN.lie(np.zeros(0), UNITS) == lie


def arms() -> list[NDArray[np.float64]]:
    """From the inner groove's centre to the ball's, backwards, and from the outer one's to the ball's."""
    return [
        (length + unit.approach * load ** (2 / 3)) * along(angle)
        for length, unit, load, angle in zip(
            free_lengths(BEARING_6205), UNITS, UNEVEN.loads, UNEVEN.angles, strict=True
        )
    ]


@pytest.mark.parametrize("held", [THRUST, RING], ids=["thrust", "ring"])
def test_coordinates_are_the_places_of_ball_and_inner_groove(held: HeldBall) -> None:
    inner, outer = arms()
    found = held.coordinates(UNEVEN, UNITS)
    np.testing.assert_allclose(found[:2], outer, rtol=1e-12)  # round-off
    np.testing.assert_allclose(found[2:], [] if held is RING else [outer[1] + inner[1]], rtol=1e-12)


@pytest.mark.parametrize("held", [THRUST, RING], ids=["thrust", "ring"])
def test_angles_and_loads_follow_from_the_coordinates(held: HeldBall) -> None:
    """The groove of the inner ring lies where both arms end."""
    inner, outer = arms()
    whole = replace(held, radial=inner[0] + outer[0], axial=None if held is THRUST else inner[1] + outer[1])
    lie = whole.lie(whole.coordinates(UNEVEN, UNITS), UNITS)
    np.testing.assert_allclose(lie.angles, UNEVEN.angles, rtol=1e-12)
    np.testing.assert_allclose(lie.loads, UNEVEN.loads, rtol=1e-9)  # of a difference of lengths
    assert lie.orbit == pytest.approx(CENTRE + outer[0], rel=1e-12)
    off = whole.lie(np.array([0.9 * outer[0], 0.9 * outer[1], inner[1] + outer[1]]), UNITS)
    assert off.loads[1] == 0.0  # nearer to the outer groove's centre than a ball without load
    assert off.loads[0] > UNEVEN.loads[0]


def test_a_step_under_thrust_is_a_step_to_first_order_on_either_side_of_the_middle() -> None:
    inner, outer = arms()
    for side in (1.0, -1.0):
        held = replace(THRUST, radial=inner[0] + outer[0])
        place = np.array([outer[0], side * outer[1], side * (inner[1] + outer[1])])
        step = 1e-8 * np.array([0.7, -0.4, 1.3])
        change = (held.moved(place, step) - held.moved(place, -step)) / 2
        np.testing.assert_allclose(change, step, rtol=1e-6)  # the square of the step over the arms


def test_a_ring_in_its_place_and_a_step_too_far_go_straight() -> None:
    inner, outer = arms()
    place, step = np.array([outer[0], outer[1]]), np.array([3e-6, -5e-6])
    np.testing.assert_array_equal(RING.moved(place, step), place + step)
    held = replace(THRUST, radial=inner[0] + outer[0])
    place, step = np.append(place, inner[1] + outer[1]), np.array([0.0, 0.0, -4 * inner[1]])  # past the inner centre
    np.testing.assert_array_equal(held.moved(place, step), place + step)


@pytest.mark.parametrize("held", [THRUST, RING], ids=["thrust", "ring"])
def test_what_the_equilibrium_lacks_is_the_sum_of_forces(held: HeldBall) -> None:
    """Each race pushes the ball against n, which points to it, and friction acts along t: n turned by a quarter."""
    across, outward = (7.3, -4.1), 5.9
    ball, ring = np.array([outward, 0.0]), -held.thrust
    for sign, angle, load, friction in zip((-1.0, 1.0), UNEVEN.angles, UNEVEN.loads, across, strict=True):
        n = sign * along(angle)
        by_race = -load * n + friction * np.array([-n[1], n[0]])
        ball += by_race
        if sign < 0:
            ring += float(by_race[1])  # the ring is pushed as much the other way
    expected = ball if held is RING else [*ball, ring]
    np.testing.assert_allclose(held.lacks(UNEVEN, across, outward), expected, rtol=1e-12)
