"""The ring's equilibrium against its energy, the thrust closed form, and Euler's equation."""

from dataclasses import replace
from typing import Any

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given

from analytic.errors import InputError
from analytic.loads.ring import RingEquilibrium, ring_equilibrium
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium
from analytic.numerics.records import Records
from analytic.scene import Bearing, ContactAngle, Material
from tests.analytic.specimens import loaded_contacts, with_clearance
from tests.refusals import refused

SOLVED = ContactAngle(rule="solved")
MIXED: dict[str, Any] = {
    "axial_load": 310.0,
    "radial_load_x": 540.0,
    "radial_load_y": -170.0,
    "moment_x": 0.7,
    "moment_y": -1.9,
}


def reference_arm(bearing: Bearing) -> float:
    return bearing.inner.bottom_radius + bearing.inner.groove_radius


def force_and_moment(bearing: Bearing, balls: Records) -> np.ndarray:
    """(axial, x, y, moment about x, about y) of forces along the inner contacts' normals, by cross products."""
    angle, load = balls["angle"][..., 0], balls["load"][..., 0]
    azimuth = 2 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
    outward = np.stack([np.cos(azimuth), np.sin(azimuth), np.zeros_like(azimuth)], axis=-1)
    force = load[:, None] * (np.cos(angle)[:, None] * outward + np.sin(angle)[:, None] * [0.0, 0.0, 1.0])
    moment = np.cross(reference_arm(bearing) * outward, force).sum(axis=0)
    total = force.sum(axis=0)
    return np.array([total[2], total[0], total[1], moment[0], moment[1]])


def exact_energy(bearing: Bearing, equilibrium: RingEquilibrium, place: list) -> mpmath.mpf:
    """Elastic energy of the balls at a displacement, J, from vectors between the groove centres, in 40 digits."""
    axial, x, y, tilt_x, tilt_y = place
    inner_arm = mpmath.mpf(bearing.inner.bottom_radius) + mpmath.mpf(bearing.inner.groove_radius)
    outer_arm = mpmath.mpf(bearing.outer.bottom_radius) - mpmath.mpf(bearing.outer.groove_radius)
    grooves = mpmath.mpf(bearing.inner.groove_radius) + mpmath.mpf(bearing.outer.groove_radius)
    total = mpmath.mpf(0)
    for ball in range(bearing.ball_count):
        turn = 2 * mpmath.pi * ball / bearing.ball_count
        cosine, sine = mpmath.cos(turn), mpmath.sin(turn)
        # theta x p of a point p in the plane of the ring has only an axial part
        radial = inner_arm - outer_arm + x * cosine + y * sine
        along = axial + tilt_x * inner_arm * sine - tilt_y * inner_arm * cosine
        approach = mpmath.hypot(radial, along) - (grooves - mpmath.mpf(bearing.ball_diameter))
        if approach > 0:
            softness = sum(
                mpmath.mpf(float(race.stiffness[ball])) ** (mpmath.mpf(-2) / 3) for race in contacts(equilibrium)
            )
            total += mpmath.mpf(2) / 5 * softness ** mpmath.mpf(-1.5) * approach ** mpmath.mpf(2.5)
    return total


def contacts(equilibrium: RingEquilibrium) -> tuple:
    return loaded_contacts(equilibrium.balls)


@pytest.mark.parametrize("clearance", [31e-6, 2e-9, 0.0, -14e-6])
def test_pure_thrust_is_the_closed_form(bearing_6205: Bearing, clearance: float) -> None:
    bearing, loads = with_clearance(bearing_6205, clearance), 10.0 ** np.arange(-3, 9, 2)
    ring = ring_equilibrium(bearing, SOLVED, axial_load=loads)
    thrust = thrust_equilibrium(bearing, SOLVED, axial_load=loads)
    everywhere = np.ones(bearing.ball_count)
    tight = 1e-10  # TOLERANCE over the share of the load that a ball's force has along the axis
    for name in ("load", "angle"):
        expected = thrust[name][:, None] * everywhere[:, None]
        np.testing.assert_allclose(ring.balls[name], expected, rtol=tight)
    for of_ring, alike in zip(loaded_contacts(ring.balls), loaded_contacts(thrust), strict=True):
        for field, values in alike._asdict().items():
            np.testing.assert_allclose(getattr(of_ring, field), np.outer(values, everywhere), rtol=tight)
    mirrored = ring_equilibrium(bearing, SOLVED, axial_load=-loads)
    np.testing.assert_allclose(
        mirrored.balls["angle"][..., 0], -ring.balls["angle"][..., 0], rtol=1e-12
    )  # the same steps


@pytest.mark.parametrize(("clearance", "count"), [(20e-6, 9), (-14e-6, 7), (3e-6, 4)])
def test_the_load_is_the_gradient_of_the_elastic_energy(bearing_6205: Bearing, clearance: float, count: int) -> None:
    bearing = with_clearance(bearing_6205, clearance, ball_count=count)
    equilibrium = ring_equilibrium(bearing, SOLVED, **MIXED)
    with mpmath.workdps(40):
        place = [mpmath.mpf(float(value)) for value in equilibrium.displacement]

        def slope(place: list, freedom: int) -> mpmath.mpf:
            step = mpmath.mpf(10) ** -18 * (1 if freedom < 3 else 60)
            ends = [[*place[:freedom], place[freedom] + sign * step, *place[freedom + 1 :]] for sign in (1, -1)]
            above, below = (exact_energy(bearing, equilibrium, end) for end in ends)
            return (above - below) / (2 * step)

        reaction = [float(slope(place, freedom)) for freedom in range(5)]
        far = mpmath.mpf(10) ** -13
        tangent = np.empty((5, 5))
        for other in range(5):
            up, down = (
                [*place[:other], place[other] + sign * far, *place[other + 1 :]]
                for sign in (mpmath.mpf(1), mpmath.mpf(-1))
            )
            for freedom in range(5):
                tangent[freedom, other] = float((slope(up, freedom) - slope(down, freedom)) / (2 * far))
    np.testing.assert_allclose(reaction, list(MIXED.values()), rtol=1e-9)  # doubles hold the place to 1e-12 of 10 um
    scale = np.sqrt(np.outer(np.diag(tangent), np.diag(tangent)))
    np.testing.assert_allclose(equilibrium.stiffness / scale, tangent / scale, atol=1e-8)  # the differences' own error


@given(
    ball_count=st.integers(3, 20),
    clearance=st.floats(-20e-6, 40e-6),
    log_loads=st.tuples(*[st.floats(-6, 4)] * 5),
    signs=st.tuples(*[st.sampled_from([-1, 0, 1])] * 5),
)
def test_any_load_is_carried(
    bearing_6205: Bearing, ball_count: int, clearance: float, log_loads: tuple, signs: tuple
) -> None:
    bearing = with_clearance(bearing_6205, clearance, ball_count=ball_count)
    arms = np.array([1, 1, 1, reference_arm(bearing), reference_arm(bearing)])
    expected = np.array(signs) * 10.0 ** np.array(log_loads)
    given_loads: dict[str, Any] = dict(zip(MIXED, expected * arms, strict=True))
    equilibrium = ring_equilibrium(bearing, SOLVED, **given_loads)
    scale = np.abs(expected).max() + equilibrium.balls["load"][..., 0].max()
    rounding = 1e-15 * np.trace(equilibrium.stiffness[:3, :3]) * 1e-3  # round-off of a place of up to 1 mm, N
    balance = force_and_moment(bearing, equilibrium.balls) / arms
    np.testing.assert_allclose(balance, expected, rtol=0, atol=1e-11 * scale + rounding)


def test_no_load_leaves_the_play_and_a_preload_holds_its_balls(bearing_6205: Bearing) -> None:
    loose = ring_equilibrium(bearing_6205, SOLVED)
    assert not loose.balls["load"][..., 0].any()
    assert not loose.displacement.any()
    assert not loose.stiffness.any()
    tight = ring_equilibrium(with_clearance(bearing_6205, -14e-6), SOLVED)
    np.testing.assert_allclose(approaches(tight.balls).sum(axis=-1), 7e-6, rtol=1e-9)  # half on the diameter
    spun = ring_equilibrium(bearing_6205, SOLVED, inner_speed=410.0)
    assert not spun.balls["load"][..., 0].any()
    np.testing.assert_allclose(spun.balls["load"][..., 1], spun.balls["turning"]["centrifugal"], rtol=1e-12)


def test_few_balls_carry_thrust_alone(bearing_6205: Bearing) -> None:
    for count in (1, 2):
        bearing = replace(bearing_6205, ball_count=count)
        equilibrium = ring_equilibrium(bearing, SOLVED, axial_load=430.0)
        expected = thrust_equilibrium(bearing, SOLVED, axial_load=430.0)["load"][0]
        np.testing.assert_allclose(equilibrium.balls["load"][..., 0], np.full(count, expected), rtol=1e-10)
        with pytest.raises(InputError, match=f"ball_count = {count} .* at least 3 balls"):
            ring_equilibrium(bearing, SOLVED, axial_load=430.0, radial_load_x=2.0)


@pytest.mark.parametrize("load", [MIXED, {"axial_load": 640.0}, {"radial_load_x": 810.0, "moment_x": 0.3}])
def test_a_turning_ball_is_in_balance_by_newton_and_euler(bearing_6205: Bearing, load: dict) -> None:
    """Newton and Euler for each ball, as vectors: contact forces, shared friction, orbit and precession."""
    equilibrium = ring_equilibrium(bearing_6205, SOLVED, **load, inner_speed=1900.0)
    mass, radius, pitch = bearing_6205.ball_mass, bearing_6205.ball_radius, bearing_6205.pitch_diameter
    ring_total = np.zeros(5)
    for ball, azimuth in zip(equilibrium.balls, equilibrium.azimuth, strict=True):
        outward = np.array([np.cos(azimuth), np.sin(azimuth), 0.0])
        forward, axis = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0]), np.array([0.0, 0.0, 1.0])
        # Directions away from the inner contact and towards the outer one
        to_inner, to_outer = (np.cos(angle) * outward + np.sin(angle) * axis for angle in ball["angle"])
        at_inner, at_outer = -radius * to_inner, radius * to_outer
        # No slip at both contacts, no spin at the outer one
        outer = ball["angle"][1]
        pitch_angle = np.arctan2(np.sin(outer), np.cos(outer) + 2 * radius / pitch)
        spin = np.sin(pitch_angle) * outward - np.cos(pitch_angle) * axis
        inner_speed, outer_speed = (np.cross(spin, arm) @ forward for arm in (at_inner, at_outer))
        inner_radius, outer_radius = (pitch / 2 + arm @ outward for arm in (at_inner, at_outer))
        # (w - c) R_i = b inner_speed and -c R_o = b outer_speed for cage c and ball b
        cage, spin_rate = np.linalg.solve(
            [[inner_radius, inner_speed], [outer_radius, outer_speed]], [1900.0 * inner_radius, 0.0]
        )
        centrifugal = mass * pitch / 2 * cage**2
        np.testing.assert_allclose(ball["turning"]["centrifugal"], centrifugal, rtol=1e-9)
        change = np.cross(cage * axis, 0.4 * mass * radius**2 * spin_rate * spin)  # of angular momentum
        share = ball["load"] / ball["load"].sum()
        couple = change @ forward / radius  # what friction at one contact would have to be
        friction = [
            part * couple * np.cross(forward, arm) / radius
            for part, arm in zip(share, (at_inner, at_outer), strict=True)
        ]
        moment = np.cross(at_inner, friction[0]) + np.cross(at_outer, friction[1])
        np.testing.assert_allclose(moment, change, atol=1e-9 * np.abs(change).max() + 1e-15)
        push = ball["load"][0] * to_inner + friction[0]  # on the ring it is the other way round
        total = push - ball["load"][1] * to_outer + friction[1]
        np.testing.assert_allclose(total, -centrifugal * outward, atol=1e-8 * ball["load"].sum())
        lever = np.cross(reference_arm(bearing_6205) * outward, push)
        ring_total += [push[2], push[0], push[1], lever[0], lever[1]]
    expected = np.array([load.get(name, 0.0) for name in MIXED])
    np.testing.assert_allclose(ring_total, expected, atol=1e-7 * np.abs(expected).max())


@pytest.mark.parametrize("across", [1e-4, 3e-4, 9e-4])
def test_a_ring_that_hardly_touches_settles_under_a_moment(bearing_6205: Bearing, across: float) -> None:
    """Two balls carry it; full Newton steps would swing to and fro between pairs of balls."""
    loose = with_clearance(bearing_6205, 22e-6)
    found = ring_equilibrium(loose, SOLVED, axial_load=1e-3, moment_x=0.224, moment_y=across)
    borne = force_and_moment(loose, found.balls)
    # The largest load is 18 N; 1e-9 of it, and of the moments, is what the balance leaves
    np.testing.assert_allclose(borne, [1e-3, 0.0, 0.0, 0.224, across], atol=2e-8)


@pytest.mark.parametrize(
    ("angle", "changed", "words"),
    [
        (SOLVED, {"moment_x": float("nan")}, ("moment_x", "nan")),
        (SOLVED, {"inner_speed": [3.0, float("inf")]}, ("inner_speed", "inf", "index [1]")),
        (ContactAngle(rule="given", value=0.18), {}, ("rule 'given'", "'solved'")),
        (ContactAngle(rule="solved", free=18.0), {}, ("free", "18.0", "degrees")),
        (SOLVED, {"radial_load_x": 1e9}, ("1e+06 kN", "lower the load")),
        (SOLVED, {"inner_speed": [70.0, 1e5]}, ("954930 rpm", "lower the speed")),
    ],
)
def test_impossible_input_is_refused(bearing_6205: Bearing, angle, changed, words) -> None:
    refused(lambda: ring_equilibrium(bearing_6205, angle, axial_load=5.0, **changed), *words)


def test_a_weight_that_sinks_balls_through_soft_races_is_named(bearing_6205: Bearing) -> None:
    """Balls at the top hang on the inner race and are past the centre of the outer groove: 1 kPa, 2 mN each."""
    soft = Material(name="jelly", source="a guess", youngs_modulus=1.3e3, poisson_ratio=0.31, density=7.8e3)
    rings = replace(bearing_6205, inner=replace(bearing_6205.inner, material=soft))
    rings = replace(rings, outer=replace(rings.outer, material=soft))
    with pytest.raises(InputError, match=r"weight of the balls, 0\.18 N, moves the rings by .* stiffer materials"):
        ring_equilibrium(rings, SOLVED, axial_load=1e-5, inner_speed=1.05, ball_weight=(0.02, 0.0, 0.0))


def test_a_ball_that_its_weight_drives_along_its_groove_is_named(bearing_6205: Bearing) -> None:
    """20 mN against a thrust of 3 mN, which is a thousand times the centrifugal force at 10 rpm."""
    steep = ContactAngle(rule="solved", free=0.8)
    weight = (0.02 * 0.561, -0.02 * 0.824, 0.02 * 0.073)
    given: dict[str, Any] = {"axial_load": 3e-3, "ball_weight": weight, "inner_speed": 1.05}
    with pytest.raises(InputError, match=r"weight of a ball, 0\.02 N, drives it .* past 90 deg, under 0\.003 N"):
        ring_equilibrium(bearing_6205, steep, **given)


@pytest.mark.parametrize(("load", "speed"), [(1.1e5, 100.0), (1.9e5, 0.0)])
def test_a_load_that_no_groove_bears_is_named_at_any_speed(bearing_6205: Bearing, load: float, speed: float) -> None:
    rated = replace(bearing_6205, static_load_rating=7850.0)
    with pytest.raises(InputError, match="lower the load") as refusal:
        ring_equilibrium(rated, SOLVED, axial_load=5.0, radial_load_x=load, inner_speed=speed)
    assert f"radial load of {load / 1e3:g} kN, {load / 7850:.2g} times the static load rating C0" in str(refusal.value)
