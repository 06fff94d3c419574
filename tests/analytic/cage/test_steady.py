"""Closed forms of the cage: against statics and rigid-body mechanics."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from scipy.optimize import minimize

from analytic.cage.pocket import impact
from analytic.cage.steady import (
    LandGuidance,
    braking_torque,
    hanging_torque,
    require_loose_balls,
    whirl_force,
    whirl_number,
    whirl_speed,
)
from analytic.errors import InputError
from tests.analytic.cage.specimens import CAGE, RATE, W
from tests.refusals import refused, refuses

LAND = LandGuidance(radius=17e-3, half_clearance=0.02e-3, outside=False, speed=W, half_width=5e-3)
RADIUS, MASS = CAGE.ball_radius, CAGE.mass


def sliding_power(friction: float, angle: float, balls: int) -> float:
    """Statics of a cage on balls with equal normal forces: power lost at the place where all forces balance."""
    phi = 2 * np.pi * np.arange(balls) / balls
    axis = np.stack([-np.sin(angle) * np.cos(phi), -np.sin(angle) * np.sin(phi), np.full(balls, np.cos(angle))], axis=1)

    def loads(place: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        normal = np.array([np.cos(place[0]), np.sin(place[0]), 0])
        slip = -W * RATE * RADIUS * np.cross(axis, normal)
        speed = np.linalg.norm(slip, axis=1)
        return (place[1] * (normal + friction * slip / speed[:, None])).sum(axis=0), speed

    def unbalanced(place: np.ndarray) -> float:
        total = loads(place)[0] - [0, MASS * 9.80665, 0]
        return float((total[:2] ** 2).sum())

    computed = minimize(unbalanced, [np.pi / 2, MASS], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-18})
    return friction * computed.x[1] * loads(computed.x)[1].sum()


@pytest.mark.parametrize(("friction", "angle", "within"), [(0.1, 0.18, 5e-4), (0.3, 0.5, 7e-3)])
def test_rest_torque_agrees_with_statics(friction: float, angle: float, within: float) -> None:
    closed = hanging_torque(friction, MASS * 9.80665, RATE * RADIUS, angle)
    # The formula neglects that friction leans out of the plane: a relative error of mu^2 sin^2(al)/4.
    np.testing.assert_allclose(closed, sliding_power(friction, angle, 9) / W, rtol=within)


def test_the_torque_of_a_braked_cage_is_what_drag_and_sliding_lose() -> None:
    """Normal forces along the pitch circle balance the drag c w_c, and the balls' surfaces slide under them."""
    drag, orbit, spin, ring, mu = 2.3e-6, 21.0, 123.0, 52.0, 0.13
    force = drag * orbit / CAGE.pitch_radius
    lost = drag * orbit**2 + mu * force * spin * RADIUS
    found = braking_torque(drag, mu, orbit / ring, orbit, spin * RADIUS, CAGE.pitch_radius)
    np.testing.assert_allclose(found, lost / ring, rtol=1e-12)


def test_the_inertia_is_that_of_a_thin_ring_of_the_pockets() -> None:
    places = CAGE.pocket_places
    np.testing.assert_allclose(CAGE.inertia[0], MASS * np.mean(np.sum(places[:, :2] ** 2, axis=1)), rtol=1e-12)
    np.testing.assert_allclose(CAGE.inertia[1], MASS * np.mean(places[:, 1] ** 2), rtol=1e-12)
    assert replace(CAGE, axial_inertia=3e-6, transverse_inertia=5e-6).inertia == (3e-6, 5e-6)


def test_whirl_number_is_centrifugal_force_over_weight() -> None:
    """The cage centre circles with the radius nabla at w_b r/nabla."""
    ball_speed, nabla, gravity = 123.0, 0.17e-3 / 2, 9.5
    turns = ball_speed * RADIUS / nabla
    computed = whirl_number(ball_speed=ball_speed, ball_radius=RADIUS, half_clearance=nabla, gravity=gravity)
    np.testing.assert_allclose(computed, MASS * turns**2 * nabla / (MASS * gravity), rtol=1e-13)  # round-off
    on_earth = whirl_number(ball_speed=ball_speed, ball_radius=RADIUS, half_clearance=nabla)
    np.testing.assert_allclose(on_earth * 9.80665, computed * gravity, rtol=1e-13)
    weightless = whirl_number(ball_speed=[0.0, 7.0], ball_radius=RADIUS, half_clearance=1e-4, gravity=0.0)
    np.testing.assert_array_equal(weightless, [0.0, np.inf])
    with pytest.raises(InputError, match="half_clearance must be positive"):
        whirl_number(ball_speed=3.0, ball_radius=RADIUS, half_clearance=0.0)


def test_a_whirling_cage_moves_with_the_surfaces_of_its_balls() -> None:
    angle, nabla, spin = 0.31, 0.23e-3, 470.0
    whirl = whirl_speed(ball_speed=spin, ball_radius=RADIUS, contact_angle=angle, half_clearance=nabla)
    normal, up = np.array([0.6, 0.8, 0.0]), np.array([0.0, 0.0, 1.0])
    cage = np.cross(whirl * up, -nabla * normal)  # the cage is displaced against the normal
    surface = np.cross(-spin * np.cos(angle) * up, RADIUS * normal)  # mean over the balls, whose leaning cancels
    np.testing.assert_allclose(cage, surface, rtol=1e-12)
    centripetal = MASS * np.linalg.norm(np.cross((whirl + 31.0) * up, np.cross((whirl + 31.0) * up, nabla * normal)))
    computed = whirl_force(cage_mass=MASS, whirl=whirl, orbit_speed=31.0, half_clearance=nabla)
    np.testing.assert_allclose(computed, centripetal, rtol=1e-12)


# The formula with a land is for balls at all azimuths. None of nine is exactly where the lead is largest: 2 % less.
@pytest.mark.parametrize(("land", "room", "within"), [(np.inf, 0.055, 1e-3), (0.02, 0.09, 0.03)])
def test_balls_may_lead_until_no_place_of_the_cage_clears_them(land: float, room: float, within: float) -> None:
    """The farthest ball from its pocket, least of all places and rotations of a cage that a land may hold."""
    phi, lead = 2 * np.pi * np.arange(9) / 9, 0.11  # mm
    balls = lead * np.sin(phi)[:, None] * np.stack([-np.sin(phi), np.cos(phi)], axis=1)

    def worst(place: np.ndarray) -> float:
        centre = place[:2] * min(1.0, land / max(float(np.hypot(*place[:2])), 1e-12))
        pockets = centre + place[2] * np.stack([-np.sin(phi), np.cos(phi)], axis=1)
        return float(np.linalg.norm(balls - pockets, axis=1).max())

    options = {"xatol": 1e-9, "fatol": 1e-12, "maxiter": 4000}
    needed = min(
        minimize(worst, start, method="Nelder-Mead", options=options).fun
        for start in ([-0.01, 0.0, 0.0], [-0.03, 0.01, 0.01], [-0.06, 0.02, 0.0])
    )
    np.testing.assert_allclose(needed, room, rtol=within)
    for offset, sign in ((0.0, -1), (0.3, 1)):
        given = {"ball_lead": sign * lead, "centre_offset": offset, "land_half_clearance": land}
        require_loose_balls(**given, half_clearance=1.001 * room + offset)
        with pytest.raises(InputError, match="beyond the clearance"):
            require_loose_balls(**given, half_clearance=0.999 * room + offset)


def test_step_follows_the_shortest_impact() -> None:
    stiffer = replace(CAGE, stiffness=7 * CAGE.stiffness)
    np.testing.assert_allclose(CAGE.contact_time / stiffer.contact_time, 7**0.4, rtol=1e-12)
    slow = replace(CAGE, ball_speed=0.0)  # it falls through the clearance and hits with at least a third of its mass
    assert slow.impact_speed == pytest.approx(np.sqrt(2 * 9.80665 * 0.2e-3), rel=1e-12)
    for balls, share in ((1, 3), (2, 3), (9, 9)):
        hit = impact(mass=MASS / share, speed=slow.impact_speed, stiffness=CAGE.stiffness)
        assert replace(slow, ball_count=balls).contact_time == pytest.approx(hit.duration, rel=1e-12)
    still = replace(CAGE, ball_speed=0.0, gravity=(0.0, 0.0, 0.0))
    assert still.contact_time == np.inf


def test_an_impossible_cage_is_refused() -> None:
    wrong = {"half_clearance": 0.0, "friction_coefficient": -0.1, "ball_count": 0, "pocket_axis": "sideways"}
    not_finite = {"mass": float("nan"), "orbit_speed": float("inf"), "transverse_inertia": float("nan")}
    refuses(partial(replace, CAGE), **wrong, **not_finite, axial_inertia=-1e-6, ball_lead=-0.21e-3)
    refused(lambda: replace(CAGE, centre_offset=0.2e-3), "clamp the ball")
    refused(lambda: replace(CAGE, ball_lead=0.13e-3, land=LAND), "ball_lead 0.13 mm", "below 0.12 mm")


def test_the_free_path_ends_at_the_first_ball() -> None:
    """There, one ball is exactly at the end of its clearance and none beyond."""
    cage = replace(CAGE, ball_lead=0.07e-3, centre_offset=0.03e-3)
    for direction in ([0.6, -0.8, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.36, 0.48 / 0.6]):
        along = np.array(direction) / np.linalg.norm(direction)
        pockets = cage.pocket_places + cage.middle + cage.free_path(along) * along
        shells = [cage.ball_places(0.0) - pockets + side * np.array([0, 0, 0.03e-3]) for side in (1, -1)]
        farthest = max(np.linalg.norm(shell, axis=1).max() for shell in shells)
        np.testing.assert_allclose(farthest, cage.half_clearance, rtol=1e-12)  # round-off


@pytest.mark.parametrize("lead", [0.03e-3, -0.1e-3])
def test_the_free_path_ends_at_the_land(lead: float) -> None:
    """From the middle between the balls, or where the land stops the cage on its way there."""
    cage = replace(CAGE, ball_lead=lead, half_clearance=2e-3, land=LAND)
    expected = [-np.clip(lead / 2, -LAND.half_clearance, LAND.half_clearance), 0.0, 0.0]
    np.testing.assert_allclose(cage.middle, expected, atol=1e-18)
    for direction in (np.array([0.6, -0.8, 0.0]), np.array([0.48, 0.36, 0.8]), np.array([-0.8, 0.36, -0.48])):
        end = cage.middle + cage.free_path(direction) * direction
        np.testing.assert_allclose(np.hypot(*end[:2]), LAND.half_clearance, rtol=1e-12)
    along = np.array([0.0, 0.0, 1.0])  # which no land stops
    np.testing.assert_allclose(cage.free_path(along), cage.half_clearance, rtol=0.01)


def test_balls_orbit_and_lead_on_one_side() -> None:
    cage = replace(CAGE, ball_lead=0.07e-3)
    quarter = cage.ball_places(np.pi / 2)
    led = np.pi / 2 + 0.07e-3 / cage.pitch_radius  # the first ball, where the lead is largest
    np.testing.assert_allclose(quarter[0], cage.pitch_radius * np.array([np.cos(led), np.sin(led), 0]), atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(quarter, axis=1), cage.pitch_radius, rtol=1e-12)
