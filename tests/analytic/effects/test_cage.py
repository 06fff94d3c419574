"""Decisions about the cage: which method is used, and the reason."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic import friction_torque
from analytic.effects.cage import decide_cage
from analytic.effects.ledger import Effect, Ledger
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Operation, Scene
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import effect_of

RULED = replace(CAGED, spin_rule="balanced")  # closed kinematics: the speed of the balls by hand


RACE = np.array([4e-3, 6e-3])  # N m


def drive(scene: Scene, **changed: Any) -> Any:
    """A cage at two points, which whirls at the second one alone and is held by its balls; friction of 0.1."""
    known: dict[str, Any] = {
        "cage": scene.cage,
        "bearing": scene.bearing,
        "inner_speed": np.array([3.0, 52.0]),
        "is_squeezed": np.array([False, False]),
        "grip": SimpleNamespace(ball_lead=np.array([0.01e-3, -0.3e-3])),
        "room": 0.2e-3,
        "friction_coefficient": 0.1,
        "whirling_force": np.array([0.2, 0.5]),
        "pocket_friction": lambda _scene, _force: SimpleNamespace(coefficient=np.full(2, 0.1)),
        "grip_number": lambda _mu: np.array([0.3, 0.8]),
        "slides": lambda _mu: np.array([False, False]),
        "ball_speed": np.array([3.0, 40.0]),
        "ball_rate": 2.36,
        "shape": SimpleNamespace(half_clearance=0.1e-3),
        "gravity": 9.80665,
    }
    return SimpleNamespace(**(known | changed))


def decided(
    scene: Scene, race: NDArray[np.float64] = RACE, **changed: Any
) -> tuple[dict[str, Effect], NDArray[np.bool_]]:
    ledger = Ledger(scene, 2)
    free = decide_cage(scene, drive(scene, **changed), ledger, race=race)
    return ledger.made, free


STARTED = with_cage(replace(CAGED, effects={}), start="rest")
SLIDES: dict[str, Any] = {
    "slides": lambda _mu: np.array([False, True]),
    "grip_number": lambda _mu: np.array([0.3, 1.7]),
}


def test_a_whirl_counts_by_its_friction_against_all_balls() -> None:
    """mu F r w_b/w at the second point: 0.1 0.5 N 3.97 mm 2.36 of 6 N mm are 7.8 %; the first has no whirl."""
    made, free = decided(STARTED)
    motion = made["cage_dynamics"]
    assert (motion.decision, motion.share) == ("on", pytest.approx(0.1 * 0.5 * 3.97e-3 * 2.36 / 6e-3, rel=1e-12))
    assert "up to 7.8 % of the torque" in motion.reason
    assert not free.any()
    loose, _ = decided(replace(STARTED, tolerance=0.16))
    assert loose["cage_dynamics"].decision == "off"
    slow, _ = decided(STARTED, ball_speed=np.array([3.0, 7.8]))  # (w_b r)^2/(g nabla) of 0.98 is below 1
    assert "no whirl: whirl number 0.978 at most, limit 1" in slow["cage_dynamics"].reason
    fast, _ = decided(STARTED, ball_speed=np.array([3.0, 8.0]))  # 1.03
    assert fast["cage_dynamics"].decision == "on"
    nothing, _ = decided(STARTED, np.array([4e-3, 0.0]))  # races without torque
    assert nothing["cage_dynamics"].share == np.inf
    still, _ = decided(replace(STARTED, tolerance=0.16), np.array([0.0, 6e-3]))  # without a torque and without a whirl
    assert still["cage_dynamics"].decision == "off"
    asked, _ = decided(replace(STARTED, effects={"cage_dynamics": "on"}), ball_speed=np.array([3.0, 7.8]))
    assert asked["cage_dynamics"].reason == "on in the scene"


def test_a_cage_that_its_balls_squeeze_everywhere_has_no_motion_on_given_balls() -> None:
    made, free = decided(STARTED, is_squeezed=np.array([True, True]))
    told = "ball lead up to 0.3 mm, free clearance of the pockets 0.2 mm"
    assert made["cage_dynamics"].reason.startswith(f"{told}: the balls squeeze the cage")
    assert (made["ball_dynamics"].decision, made["ball_dynamics"].reason) == ("on", told)
    assert free.all()
    some, free = decided(STARTED, is_squeezed=np.array([False, True]))
    assert (some["cage_dynamics"].decision, some["ball_dynamics"].decision) == ("off", "on")  # no whirl at the first
    np.testing.assert_array_equal(free, [False, True])


def test_balls_move_where_a_whirl_needs_more_grip_than_they_have() -> None:
    made, free = decided(STARTED, **SLIDES)
    assert made["ball_dynamics"].reason == "grip number 1.7, balls slide above 0.9"
    np.testing.assert_array_equal(free, [False, True])
    held, free = decided(STARTED)
    assert held["ball_dynamics"].reason == "grip number 0.8 at most, balls roll below 0.9"
    assert not free.any()
    still, free = decided(STARTED, **SLIDES, inner_speed=np.array([3.0, 0.0]))  # nothing turns where they would slide
    assert (still["ball_dynamics"].decision, free.any()) == ("off", False)
    resting, free = decided(replace(STARTED, effects={"cage_dynamics": "off"}), **SLIDES)  # nothing whirls
    assert (resting["ball_dynamics"].reason, free.any()) == ("cage at rest, small forces on the balls", False)


def test_balls_that_the_scene_sets_free_move_wherever_they_turn() -> None:
    asked = replace(STARTED, effects={"ball_dynamics": "on"})
    _, free = decided(asked)
    np.testing.assert_array_equal(free, [True, True])
    _, free = decided(asked, inner_speed=np.array([3.0, 0.0]))
    np.testing.assert_array_equal(free, [True, False])
    _, free = decided(replace(STARTED, effects={"ball_dynamics": "off"}), **SLIDES)
    assert not free.any()
    with pytest.raises(InputError, match="friction of the races not computed"):
        decided(asked, friction_coefficient=None)


def test_auto_moves_balls_for_seconds_and_the_cage_for_minutes() -> None:
    """2 (seeds + 1) duration for each point that turns: up to 4 s with free balls, up to 500 s of the cage alone."""
    for duration, is_on in ((0.66, True), (0.67, False)):
        made, _ = decided(with_cage(STARTED, duration=duration), **SLIDES)
        assert (made["ball_dynamics"].decision == "on") == is_on
        assert ("1 points need 4.02 s of motion, limit 4 s" in made["ball_dynamics"].reason) != is_on
    assert made["ball_dynamics"].reason.startswith("grip number 1.7 at most, and skipped: ")
    for duration, is_on in ((41.0, True), (42.0, False)):
        made, _ = decided(with_cage(STARTED, duration=duration))
        assert (made["cage_dynamics"].decision == "on") == is_on
    one, _ = decided(with_cage(STARTED, duration=42.0), inner_speed=np.array([0.0, 52.0]))  # the other one stands
    assert one["cage_dynamics"].decision == "on"
    asked, _ = decided(with_cage(replace(STARTED, effects={"cage_dynamics": "on"}), duration=42.0))
    assert asked["cage_dynamics"].decision == "on"
    asked, _ = decided(with_cage(replace(STARTED, effects={"ball_dynamics": "on"}), duration=0.67), **SLIDES)
    assert asked["ball_dynamics"].decision == "on"


def test_no_cage_and_a_neglected_one_settle_all_of_it() -> None:
    for scene, given, words in (
        (replace(STARTED, cage=None), None, "no cage is given"),
        (replace(STARTED, effects={"cage": "off"}), drive(STARTED), "cage at rest, small forces"),
    ):
        ledger = Ledger(scene, 2)
        assert not decide_cage(scene, given, ledger, race=RACE).any()
        assert {ledger.made[name].decision for name in ("cage", "cage_dynamics", "ball_dynamics")} == {"off"}
        assert words in ledger.made["ball_dynamics"].reason


def assert_rests(result: FrictionTorque, reason: str) -> None:
    """The motion is left out for this reason, and nothing moved."""
    effect = effect_of(result, "cage_dynamics")
    assert effect.decision == "off"
    assert reason in effect.reason
    assert result.cage is not None
    assert not any(result.cage.motion)


def test_without_a_start_the_closed_form_is_used() -> None:
    result = friction_torque(RULED)
    assert_rests(result, "cage.start is not given")
    assert effect_of(result, "cage_dynamics").share is None
    assert not any("cage_dynamics" in warning for warning in result.warnings)


def test_a_cage_that_cannot_whirl_has_the_closed_form() -> None:
    slow = replace(RULED, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([20.0]) * RPM))
    # The whirl number above by (20/500)^2
    assert_rests(friction_torque(with_cage(slow, start="sudden")), "whirl number 0.392")


def test_a_motion_within_the_tolerance_is_left_out() -> None:
    assert_rests(
        friction_torque(with_cage(replace(CAGED, tolerance=0.9), start="sudden")),
        "within the budget of 45 %",
    )
    off = replace(with_cage(CAGED, start="sudden"), effects={**CAGED.effects, "cage_dynamics": "off"})
    assert_rests(friction_torque(off), "off in the scene")


def test_auto_does_not_move_a_long_series() -> None:
    many = Operation(axial_load=np.full(3000, 1000.0), inner_speed=np.linspace(100, 500, 3000) * RPM)
    result = friction_torque(with_cage(replace(CAGED, operation=many), start="rest"))
    assert_rests(result, "3000 points need 540 s of motion")  # twice 0.03 s for two seeds and another start
    assert any('effects.cage_dynamics = "on"' in warning for warning in result.warnings)


def test_with_more_steps_auto_allows_less_motion() -> None:
    """A second of motion in 25 times the steps is as much work as 25 s."""
    many = Operation(axial_load=np.full(150, 1000.0), inner_speed=np.linspace(100, 500, 150) * RPM)
    given = with_cage(replace(CAGED, operation=many), start="rest", steps_per_contact=1000)
    assert_rests(friction_torque(given), "27 s of motion, limit 20 s at 1000 steps")


def test_without_cage_or_with_the_cage_left_out_nothing_is_added() -> None:
    for left in (replace(CAGED, cage=None), replace(CAGED, effects={**CAGED.effects, "cage": "off"})):
        result = friction_torque(left)
        assert result.cage is None
        assert result.torque.cage is None
        assert effect_of(result, "cage").decision == effect_of(result, "cage_dynamics").decision == "off"
        assert set(vars(result.row(0).cage).values()) == {None}


def test_a_motion_needs_its_start() -> None:
    with pytest.raises(InputError, match=r'effects\.cage_dynamics = "on" is refused: cage\.start is not given'):
        friction_torque(replace(CAGED, effects={**CAGED.effects, "cage_dynamics": "on"}))
