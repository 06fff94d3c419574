"""The ladder of the cage: its closed form, its motion, and the bounds of each."""

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from analytic.cage.steady import DrivenCage
from analytic.errors import InputError
from analytic.scene import Operation, Scene
from analytic.scenefile.read import load_scene
from fembearing.check.cost import cage_ladder
from fembearing.check.cost.cage_ladder import cage_methods
from fembearing.check.cost.ladder import Ladder, measured
from tests.analytic.specimens import present

SPEEDS = np.array([31.0, -83.0, 47.0])


@pytest.fixture
def scene() -> Scene:
    scene = load_scene("6205-dry")
    assert scene.cage is not None
    operation = Operation(axial_load=np.array([700.0, 900.0, 1100.0]), inner_speed=SPEEDS)
    return replace(scene, operation=operation, cage=replace(scene.cage, steps_per_contact=44, seeds=5, duration=0.3))


def started(scene: Scene, start: Any) -> Scene:
    return replace(scene, cage=replace(present(scene.cage), start=start))


@pytest.mark.usefixtures("timed_once")
def test_a_cage_at_rest_has_its_closed_form(scene: Scene) -> None:
    """Without a start in the scene the motion starts from rest, and both methods describe the same cage."""
    found = measured(cage_methods(scene), tolerance=0.1)
    assert [method.name for method in found.methods] == [
        "closed form at rest",
        *(f"motion, {steps} steps a contact" for steps in (11, 22, 44, 88)),
    ]
    error = present(found.methods[0].error)
    assert error < 0.04  # 0.8 % in a longer motion; in one so short the disturbance still swings
    assert found.chosen is found.methods[0]  # seconds, for a thousandth of that
    assert found.methods[-1].bound is not None  # 3.6 %, by which the error may be off: at 5 % it would not be sure
    assert found.methods[0].known_error == pytest.approx(error + found.methods[-1].bound, rel=1e-12)
    assert 'from "rest", 2 seeds of 0.00639 s at -792.59 rpm' in found.reference  # the fastest point
    assert "117 times as long" in found.reference  # 5 seeds of 0.3 s over 2 of 0.00639 s


@pytest.mark.usefixtures("timed_once")
def test_the_closed_form_at_rest_is_not_chosen_for_a_whirling_cage(scene: Scene) -> None:
    found = measured(cage_methods(started(scene, "whirl")), tolerance=0.05)
    error = present(found.methods[0].error)
    assert error > 0.5  # it hits its balls with far more than its weight
    assert "motion" in present(found.chosen).name
    assert [method.bound is None for method in found.methods] == [True, True, False, False, False]


@pytest.mark.usefixtures("timed_once")
def test_no_motion_is_longer_than_in_the_scene(scene: Scene) -> None:
    """Without weight a slow cage takes hours to cross its pockets: the motion fails with the reason."""
    assert scene.cage is not None
    slow = Operation(axial_load=np.array([700.0]), inner_speed=np.array([1e-5]))
    found = measured(
        cage_methods(replace(scene, operation=slow, cage=replace(scene.cage, gravity="off"))), tolerance=0.05
    )
    assert [method.failed is None for method in found.methods] == [True, False, False, False, False]
    assert "too short: the cage crosses its pockets once in 2.1" in (found.methods[-1].failed or "")
    assert found.chosen is None


MOTIONS = {11.0: (7.0, 0.5), 22.0: (5.0, 0.4), 44.0: (4.0, 0.2), 88.0: (3.2, 0.16)}  # N m, by steps a contact


class Motion:
    """A torque, with an interval of `half` on either side."""

    def __init__(self, torque: float, half: float) -> None:
        self.torque, self.torque_interval = torque, (torque - half, torque + half)


def ladder_of_motions(motion: Callable[..., Any], scene: Scene, monkeypatch: pytest.MonkeyPatch) -> Ladder:
    monkeypatch.setattr(cage_ladder, "measured_motion", lru_cache(motion))
    return measured(cage_methods(scene), tolerance=0.31)


@pytest.mark.usefixtures("timed_once")
def test_the_bound_is_the_change_from_twice_the_step_and_half_the_interval(
    scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[tuple[DrivenCage, dict[str, Any]]] = []

    def motion(cage: DrivenCage, *, steps_per_contact: float, **rest: Any) -> Motion:
        calls.append((cage, rest))
        return Motion(*MOTIONS[steps_per_contact])

    found = ladder_of_motions(motion, started(scene, "sudden"), monkeypatch)
    bounds = [method.bound for method in found.methods[1:]]
    assert bounds[0] is None
    assert bounds[1:] == pytest.approx([2 / 5 + 0.4 / 5, 1 / 4 + 0.2 / 4, 0.8 / 3.2 + 0.16 / 3.2], rel=1e-12)
    errors = [method.error for method in found.methods[1:4]]
    assert errors == pytest.approx([3.8 / 3.2, 1.8 / 3.2, 0.8 / 3.2], rel=1e-12)
    cage, rest = calls[0]
    # The set duration is less than the cage takes to fall through its pockets, twice 0.1 mm.
    assert rest == {"start": "sudden", "seeds": 2, "duration": pytest.approx((4 * 0.1e-3 / 9.80665) ** 0.5, rel=1e-9)}
    # Rolling balls orbit at less than half the ring's speed and spin faster than it, all in its sense.
    assert cage.ring_speed == -83.0
    assert 0.35 < cage.orbit_speed / cage.ring_speed < 0.45
    assert 2.2 < cage.ball_speed / cage.ring_speed < 2.5
    assert cage.friction_coefficient == scene.friction_coefficient


@pytest.mark.usefixtures("timed_once")
def test_a_cage_without_contact_has_no_error(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    found = ladder_of_motions(lambda *_, **__: Motion(0.0, 0.0), scene, monkeypatch)
    assert [method.bound for method in found.methods[2:]] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"cage": None}, r"no \[cage\]"),
        ({"friction_coefficient": None}, "friction.coefficient"),
        ({"operation": Operation(axial_load=np.array([700.0]), inner_speed=np.array([0.0]))}, "stands still"),
    ],
)
def test_a_scene_without_such_a_ladder_says_why(scene: Scene, change: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        cage_methods(replace(scene, **change))
