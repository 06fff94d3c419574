"""How balls drive a cage: on both sides of each limit, and what its part of a torque says."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.cage import torque
from analytic.cage.drive import LARGEST_GRIP, CageDrive, RaceGrip, cage_drive, pocket_stiffness_of, resting_cage
from analytic.cage.pocket import PocketFriction, friction_in_pocket
from analytic.cage.statistics import CageStatistics, OtherStart
from analytic.cage.steady import rest_torque, sliding_torque
from analytic.cage.torque import (
    CagePart,
    _bistable,
    _provenance,
    _with_grip,
    cage_friction,
    may_squeeze,
    resting_force,
    squeezed_torque,
)
from analytic.contact.hertz import hertz_contact
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, LoadEffects, loaded_balls
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import ContactAngle, Land, Operation
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, present
from tests.contacts import STEEL

SPEEDS = np.array([500.0, -740.0, 0.0]) * RPM
SOLVED = ContactAngle(rule="solved", free=0.18)


def balls_under(radial: list[float]) -> LoadedBalls:
    """At SPEEDS; without radial load balls are alike."""
    thrust = np.array([1000.0, 800.0, 900.0])
    operation = Operation(axial_load=thrust, inner_speed=SPEEDS, radial_load=np.array(radial))
    return loaded_balls(BEARING_6205, SOLVED, operation.as_series(), LoadEffects())


ALIKE, AROUND = balls_under([0.0, 0.0, 0.0]), balls_under([500.0, 330.0, 140.0])


def driven_by(balls: LoadedBalls, friction: Any = 0.1, **cage: Any) -> CageDrive:
    return cage_drive(with_cage(CAGED, **cage), balls, friction, SPEEDS)


def led(*lead: float) -> CageDrive:
    """In 0.2 mm of clearance; lead : mm."""
    return driven_by(ALIKE).leading(1e-3 * np.array(lead))


@pytest.mark.parametrize("ratio", [0.35, 0.04])  # ball over pitch diameter: the larger change is above, and below
def test_the_axis_of_a_ball_changes_its_speed_between_no_spin_on_the_outer_and_on_the_inner_race(ratio: float) -> None:
    """By closed kinematics at three pitches: those of both controls, and along the contact, where balls only roll."""
    angle = 0.61
    pitches = [np.arctan2(np.sin(angle), np.cos(angle) + side * ratio) for side in (1, -1)]
    outer, none, inner = (
        float(
            ball_kinematics(
                inner_speed=1.0,
                inner_angle=angle,
                outer_angle=angle,
                pitch_diameter=1.0,
                ball_diameter=ratio,
                pitch=pitch,
            ).ball_speed
        )
        for pitch in (pitches[0], angle, pitches[1])
    )
    one = np.ones(3)
    drive = replace(
        driven_by(ALIKE),
        orbit_rate=one * (1 - ratio * np.cos(angle)) / 2,
        ball_rate=one * outer,
        contact_angle=one * angle,
    )
    expected = max(1 - none / outer, inner / outer - 1)
    np.testing.assert_allclose(drive.spread_by_axis, expected, rtol=1e-9)
    assert (expected == 1 - none / outer) == (ratio < 0.1)


@pytest.mark.parametrize("balls", [ALIKE, AROUND])
def test_free_balls_get_the_friction_of_their_load_and_the_loads_of_their_point(balls: LoadedBalls) -> None:
    mu = np.random.default_rng(3).uniform(0.05, 0.15, balls.load.shape)
    operation = Operation(
        axial_load=np.array([1000.0, 800.0, 900.0]),
        inner_speed=SPEEDS,
        radial_load=np.zeros(3) if balls is ALIKE else np.array([500.0, 330.0, 140.0]),
    )
    scene = replace(CAGED, contact_angle=SOLVED, operation=operation)
    races = driven_by(balls, mu).races(scene, 1)
    pulled = np.sum((mu * balls.load)[:, 1], axis=-1)
    np.testing.assert_allclose(races.friction, pulled / balls.load[:, 1].sum(axis=-1), rtol=1e-12)
    assert races.inner_speed == SPEEDS[1]
    each = races.contacts.load.shape[1] // balls.load.shape[2]
    np.testing.assert_allclose(races.contacts.load[:, ::each], balls.load[:, 1], rtol=1e-9)
    unloaded = replace(balls, load=balls.load * np.reshape([1.0, 0.0], (2, 1, 1)))
    if balls is ALIKE:
        assert driven_by(unloaded, mu).races(scene, 1).friction[1] == 0


def test_a_ball_without_grip_is_named_unless_its_ring_stands_still() -> None:
    friction = np.full((2, 3, 9), 7.0)
    friction[:, 1, 6] = friction[:, 2, 3] = 0
    friction[0, 0, 2] = 0  # the other race holds this one
    drive = driven_by(AROUND)
    grip = replace(drive.grip, friction=friction)
    with pytest.raises(InputError, match=r"ball 7 of 9 has a load of 0 N on both races at -740 rpm"):
        grip.require_grip(SPEEDS)
    friction[:, 1, 6] = 7.0
    grip.require_grip(SPEEDS)
    replace(grip, friction=None).require_grip(SPEEDS)


def test_balls_slide_from_the_largest_grip_number_on() -> None:
    mu = np.full(3, 0.1)
    number = driven_by(ALIKE).grip_number(mu)
    # The number goes with 1/mu of the races.
    for share in (0.999, 1.001):
        grip = driven_by(ALIKE, 0.1 * np.reshape(number, (3, 1)) / (share * LARGEST_GRIP))
        sliding = grip.slides(mu)
        np.testing.assert_array_equal(sliding[:2], share > 1)


def test_a_cage_is_squeezed_where_the_lead_reaches_its_room() -> None:
    assert led(0.1999, -0.2001, -0.1999).is_squeezed.tolist() == [False, True, False]
    drive = driven_by(ALIKE, land=Land(ring="outer", clearance=0.03e-3, width=9e-3))
    np.testing.assert_allclose(drive.room, 0.115e-3, rtol=1e-9)


def test_a_cage_at_rest_has_the_numbers_of_its_scene() -> None:
    for gravity, along in (("along", True), ("across", False), ("off", False)):
        drive = driven_by(ALIKE, gravity=gravity, drag=3e-6)
        cage = resting_cage(drive.bearing, drive.cage)
        pull = 0.0 if gravity == "off" else 9.80665
        assert (cage.lies_along, cage.gravity, cage.drag, drive.gravity) == (along, pull, 3e-6, pull)
        assert cage.pitch_radius == pytest.approx(39.01e-3 / 2, rel=1e-12)
        # Without gravity a thousandth of the weight presses the film.
        np.testing.assert_allclose(resting_force(drive), 6.58e-3 * max(pull, 9.80665e-3), rtol=1e-12)


def test_the_stiffness_of_a_pocket_is_that_of_hertz_unless_it_is_given() -> None:
    drive = driven_by(ALIKE)
    curvature = 2 / 7.94e-3 - 2 / 8.14e-3
    modulus = STEEL.youngs_modulus / (2 * (1 - STEEL.poisson_ratio**2))
    hertz = hertz_contact(curvature_x=curvature, curvature_y=curvature, load=2.0, modulus=modulus)
    assert pocket_stiffness_of(drive.bearing, drive.cage) == pytest.approx(float(hertz.stiffness), rel=1e-9)
    assert pocket_stiffness_of(drive.bearing, replace(drive.cage, pocket_stiffness=7.7e9)) == 7.7e9


def test_lead_that_may_reach_the_room_is_warned_of_at_the_farthest_point() -> None:
    drive = led(0.05, -0.15, 0.1)
    assert may_squeeze(drive, 1e-3 * np.array([0.19, 0.1999, 0.1])) == ()
    (warning,) = may_squeeze(drive, 1e-3 * np.array([0.21, 0.23, 0.22]))
    assert "at -740 rpm balls lead by 0.15 mm, at most by 0.23 mm, free clearance of the pockets 0.2 mm" in warning
    (warning,) = may_squeeze(drive, 1e-3 * np.array([0.21, 0.1, 0.22]))
    assert "at 0 rpm" in warning
    squeezed = led(0.25, -0.15, 0.1)  # which has a warning of its own
    assert may_squeeze(squeezed, 1e-3 * np.array([0.26, 0.16, 0.11])) == ()


def test_squeezed_balls_slide_on_the_cage_with_the_friction_under_their_force() -> None:
    drive = led(0.203, -0.21, 0.1)
    found, mu = squeezed_torque(CAGED, drive), np.full(3, 0.1)
    force = 9 * drive.squeezing_force(mu)[:, 0]
    assert force[2] == found[2] == 0
    assert np.all(force[:2] > 0)
    np.testing.assert_allclose(found, 0.1 * force * drive.ball_rate * 3.97e-3, rtol=1e-12)
    unknown = replace(CAGED, friction_coefficient=None)  # which nothing asks for where there is room
    np.testing.assert_array_equal(squeezed_torque(unknown, led(0.1, 0.1, 0.1)), 0.0)


def test_balls_squeeze_no_harder_than_their_races_hold_them_where_that_is_known() -> None:
    drive, mu = led(0.203, -0.21, 0.1), np.full(3, 0.1)
    free = replace(drive, grip=replace(drive.grip, friction=None)).squeezing_force(mu)
    held = drive.squeezing_force(mu)
    assert np.all(held[:2] < free[:2])
    np.testing.assert_array_equal(held, np.minimum(free, present(drive.grip.carried(mu))))


def part_of(drive: CageDrive) -> CagePart:
    return cage_friction(CAGED, drive, moves=False)


def test_a_squeezed_cage_also_carries_its_weight() -> None:
    drive = led(0.203, -0.21, 0.1)
    part, mu = part_of(drive), np.full(3, 0.1)
    rest = rest_torque(
        friction_coefficient=0.1,
        cage_mass=6.58e-3,
        ball_rate=drive.ball_rate,
        ball_radius=3.97e-3,
        contact_angle=drive.contact_angle,
    )
    force = 9 * drive.squeezing_force(mu)[:, 0]
    squeezed = sliding_torque(friction_coefficient=0.1, force=force, ball_rate=drive.ball_rate, ball_radius=3.97e-3)
    np.testing.assert_allclose(part.torque, rest + squeezed, rtol=1e-9)
    np.testing.assert_allclose(part.mean_force, 6.58e-3 * 9.80665 / np.hypot(1, 0.1) + force, rtol=1e-9)
    np.testing.assert_allclose(part.unsure, [part.torque[0], part.torque[1], 0.0], rtol=1e-12)
    carried = present(drive.grip.carried(mu))[:, 0]
    np.testing.assert_allclose(part.grip_share, part.mean_force / (9 * carried), rtol=1e-12)
    assert part.unknown == ()
    (warning,) = part.warnings
    assert "at -740 rpm balls lead on one side of the bearing and lag on the other by 0.21 mm" in warning
    assert "that of a rigid cage, +- 100 %" in warning
    assert part.provenance == (
        "closed form at rest, squeezed by balls that lead at 2 of 3 points, friction by friction.coefficient"
    )
    assert [part.row(point).state for point in range(3)] == ["squeezed", "squeezed", "rest"]


def statistics(**changed: Any) -> CageStatistics:
    values: dict[str, Any] = {
        "torque": 3e-4, "torque_interval": (2e-4, 5e-4), "drag_torque": 0.0, "damping_torque": 1e-5,
        "signed_moment": 4e-6, "mean_force": 16.0, "max_force": 21.0, "max_force_interval": (20.0, 23.0),
        "block_maxima": (21.0,), "block": 1e-3, "duration": 0.02, "state": "whirl", "whirl_speed": 31.0,
        "wobble": 1e-6, "start": "whirl", "other": None,
    }  # fmt: skip
    return CageStatistics(**(values | changed))


def moved(*states: str | None, part: CagePart | None = None, **changed: Any) -> CagePart:
    """A part whose cage moved in these states; None: by the closed form."""
    motion = tuple(None if state is None else statistics(state=state) for state in states)
    return replace(part_of(led(0.0, 0.0, 0.0)) if part is None else part, motion=motion, **changed)


def test_a_whirl_on_given_balls_uses_the_grip_of_its_number() -> None:
    part = moved("whirl", "rest", None, grip_number=np.array([0.31, 0.52, 0.73]), grip_share=np.array([0.1, 0.2, 0.3]))
    assert part.is_moving_given_balls.tolist() == [True, False, False]
    np.testing.assert_array_equal(part.used_grip, [0.31, 0.2, 0.3])
    free = replace(part, race_excess=np.array([1e-5, np.nan, np.nan]))
    assert free.is_moving_given_balls.tolist() == [False, False, False]


def test_half_of_both_intervals_is_uncertain() -> None:
    motion = (statistics(race_excess_interval=(1e-5, 7e-5)), None, statistics())
    part = replace(part_of(led(0.0, 0.0, 0.0)), motion=motion)
    np.testing.assert_allclose(part.half_interval, [1.8e-4, 0.0, 1.5e-4], rtol=1e-12)


def test_some_points_keep_their_order_and_their_motion() -> None:
    part = moved("whirl", "rest", None, torque=np.array([1.0, 2.0, 3.0]))
    some = part.of_points(np.array([2, 0]))
    assert some.torque.tolist() == [3.0, 1.0]
    assert some.motion == (part.motion[2], part.motion[0])
    assert some.provenance == part.provenance


@pytest.mark.parametrize("used", [0.89, 0.91, np.nan])
def test_what_the_races_may_take_of_a_whirl_is_uncertain_up_to_the_limit_of_grip(used: float) -> None:
    """The number is set by the mass of the cage; without the friction of the races it is not known."""
    mu, added = np.full(3, 0.1), np.array([3e-4, 4e-4, 5e-4])
    number = driven_by(ALIKE).grip_number(mu)
    friction = 0.1 * np.where(SPEEDS == 0, 1.0, number / used)
    drive = driven_by(ALIKE, None if np.isnan(used) else np.reshape(friction, (3, 1)))
    part = moved("whirl", "rest", None, torque=added, grip_number=drive.grip_number(mu))
    found = _with_grip(part, drive)
    if used < 0.9:
        np.testing.assert_allclose(found.unsure[0], 0.3 * used / 0.9 * 3e-4, rtol=1e-9)
        assert found.unknown == ()
    else:
        assert found.unsure[0] == np.inf
        (reason,) = found.unknown
        assert ("at 500 rpm not known" if np.isnan(used) else "uses 91 % of the grip of the races at 500 rpm") in reason
    np.testing.assert_array_equal(found.unsure[1:], 0.0)
    free = replace(part, race_excess=np.array([1e-5, np.nan, np.nan]), unsure=np.array([7e-6, 0.0, 0.0]))
    assert _with_grip(free, drive).unsure.tolist() == [7e-6, 0.0, 0.0]  # their own motion shows it


def test_only_another_state_makes_a_second_steady_motion() -> None:
    same = statistics(other=OtherStart(start="rest", state="whirl", torque=3e-4))
    other = statistics(other=OtherStart(start="rest", state="rest", torque=6e-5))
    assert _bistable([None, same, statistics()], SPEEDS) == ()
    (warning,) = _bistable([None, other, same], SPEEDS)
    assert 'at -740 rpm cage.start = "whirl" leads to whirl, 0.3 N mm, and "rest" to rest, 0.06 N mm' in warning, (
        warning
    )


LAND = Land(ring="outer", clearance=0.3e-3, width=9e-3)


@pytest.mark.parametrize(
    ("cage", "moves", "freely", "words"),
    [
        ({}, False, 0, "closed form at rest, friction by oil"),
        ({"land": LAND}, False, 0, "closed form at rest, without land, friction by oil"),
        ({}, True, 0, 'motion from "whirl", 40 steps a contact, pocket stiffness by Hertz, friction by oil'),
        ({"pocket_stiffness": 7e9}, True, 0, "pocket stiffness by given approach, friction"),
        ({"sheet_stiffness": 1.3e8}, True, 0, "by Hertz with a sheet of 130 N/um, friction"),
        ({}, False, 2, "by Hertz, with balls that move freely at 2 of 3 points, friction"),
    ],
)
def test_the_provenance_names_what_was_computed(cage: dict[str, Any], moves: bool, freely: int, words: str) -> None:
    drive, friction = driven_by(ALIKE, start="whirl", **cage), PocketFriction(coefficient=np.zeros(3), source="oil")
    assert words in _provenance(drive, friction, moves=moves, freely=np.arange(3) < freely)


def test_squeezed_points_are_counted_without_those_of_free_balls() -> None:
    friction = PocketFriction(coefficient=np.zeros(3), source="oil")
    words = _provenance(led(0.3, 0.3, 0.0), friction, moves=True, freely=np.arange(3) == 1)
    assert ", squeezed by balls that lead at 1 of 3 points, with balls that move freely at 1 of 3 points" in words


def test_the_grip_of_a_race_counts_loads_above_0_alone() -> None:
    grip: RaceGrip = driven_by(AROUND, 0.07).grip
    np.testing.assert_allclose(present(grip.friction), 0.07 * AROUND.load, rtol=1e-12)
    unloaded = replace(AROUND, load=np.where(np.arange(9) == 4, 0.0, AROUND.load))
    friction = present(driven_by(unloaded, np.where(np.arange(9) == 4, np.nan, 0.07)).grip.friction)
    assert np.all(friction[..., 4] == 0)
    assert np.all(friction[..., 5] > 0)


OILED = replace(CAGED, friction_coefficient=None, lubricant=OIL, surface=FINISH, contact_angle=SOLVED)


@pytest.mark.parametrize("moves", [False, True])
def test_the_oil_of_a_pocket_carries_the_largest_force_that_the_cage_may_have(
    monkeypatch: pytest.MonkeyPatch, moves: bool
) -> None:
    """The whirl of a cage that moves, its weight, or the squeezing of balls that lead too far; each of nine balls."""
    monkeypatch.setattr(torque, "_moved", lambda *_: (None, statistics()))
    drive = led(0.1, -0.21, 0.0)
    part = cage_friction(OILED, drive, moves=moves)
    weight = 6.58e-3 * 9.80665
    squeezing = 9 * drive.squeezing_force(np.zeros(3))[:, 0]
    whirling = 6.58e-3 * (drive.ball_speed * 3.97e-3 / 0.1e-3 + drive.orbit_speed) ** 2 * 0.1e-3
    assert squeezing[1] > whirling[1] > whirling[0] > 100 * weight
    force = np.array([whirling[0] if moves else weight, squeezing[1], weight])
    expected = friction_in_pocket(OILED, load=force / 9, surface_speed=drive.ball_speed * 3.97e-3)
    np.testing.assert_allclose(part.friction_coefficient, expected.coefficient, rtol=1e-12)
    assert np.ptp(part.friction_coefficient) > 0


def test_a_cage_moves_where_it_turns_and_has_room_or_where_its_balls_are_free(monkeypatch: pytest.MonkeyPatch) -> None:
    called: list[tuple[int, bool]] = []
    found = statistics(race_excess_torque=7e-5, signed_moment=4e-6)

    def move(_: Any, point: int, friction: float, races: Any) -> tuple[None, CageStatistics]:
        assert friction == 0.1
        called.append((point, races is not None))
        return None, found

    monkeypatch.setattr(torque, "_moved", move)
    drive = replace(led(0.1, -0.25, 0.1), cage=present(with_cage(CAGED, drag=3e-6, start="whirl").cage))
    scene = replace(CAGED, contact_angle=SOLVED)
    rest = cage_friction(scene, drive, moves=False)
    assert (called, rest.motion) == ([], (None, None, None))
    np.testing.assert_allclose(rest.signed_moment, 3e-6 * drive.orbit_speed * [1, -1, 0], rtol=1e-12)
    given = cage_friction(scene, drive, moves=True)
    assert called == [(0, False)]
    assert given.motion == (found, None, None)
    np.testing.assert_array_equal(given.race_excess, np.nan)
    np.testing.assert_array_equal(given.torque, [found.torque, *rest.torque[1:]])
    np.testing.assert_array_equal(given.mean_force, [found.mean_force, *rest.mean_force[1:]])
    np.testing.assert_array_equal(given.signed_moment, [4e-6, *rest.signed_moment[1:]])
    assert given.is_squeezed.tolist() == [False, True, False]
    for moves in (False, True):
        called.clear()
        free = cage_friction(scene, drive, moves=moves, frees=np.array([False, True, True]))
        assert called == [(0, False)] * moves + [(1, True)]
        assert [each is not None for each in free.races] == [False, True, False]
        np.testing.assert_array_equal(free.race_excess, [np.nan, 7e-5, np.nan])
        assert free.torque[1] == pytest.approx(found.torque + 7e-5, rel=1e-12)
        # Squeezing may still build up to the closed form.
        assert free.unsure[1] == pytest.approx(rest.torque[1] - free.torque[1], rel=1e-12)
        assert free.unsure[2] == 0
        assert free.is_squeezed.tolist() == [False, False, False]
        assert not any("squeeze" in warning for warning in free.warnings)
    roomy = cage_friction(scene, drive, moves=False, frees=np.array([True, False, False]))
    assert roomy.unsure[0] == 0
