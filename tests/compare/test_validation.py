"""The main job: which contacts a scene calls for, and which of them are judged."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import builtin_scene, load_scene
from fembearing.compare import validation as module
from fembearing.compare.validation import check_scene
from fembearing.progress import Progress


class AskedError(Exception):
    """In place of a solution."""


@pytest.mark.parametrize(("has_cage", "pairs"), [(True, ["inner real", "outer real", "pocket real", "pocket wall"]),
                                                 (False, ["inner real", "outer real"])])  # fmt: skip
def test_no_cage_means_no_pocket_solve(monkeypatch: pytest.MonkeyPatch, has_cage: bool, pairs: list[str]) -> None:
    asked: list[str] = []
    shares: list[float] = []

    def note(_: object, *, pair: str, geometry: str, progress: Progress, **__: Any) -> None:
        asked.append(f"{pair} {geometry}")
        progress(0.0, "first")
        progress(1.0, "last")

    def stop(*_: object, **__: object) -> None:
        raise AskedError

    monkeypatch.setattr(module, "solve_contact", note)
    monkeypatch.setattr(module, "with_ring", lambda found: found)
    monkeypatch.setattr(module, "change_of_torque", stop)
    scene = load_scene(builtin_scene("6205"))
    with pytest.raises(AskedError):
        check_scene(
            scene if has_cage else replace(scene, cage=None), progress=lambda share, _: shares.append(float(share))
        )
    assert asked == pairs
    assert shares == sorted(shares)  # one after the other, and the whole in the end
    assert (shares[0], shares[-1]) == (0.0, pytest.approx(1.0, abs=1e-12))  # round-off


def test_an_effect_that_cannot_be_had_is_refused_without_friction_too(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a coefficient there is no torque and no effect: asking for one is an error, not a wish to pass over."""

    def never(*_: object, **__: object) -> None:
        raise AssertionError("solved before it was refused")

    monkeypatch.setattr(module, "solve_contact", never)
    scene = replace(load_scene(builtin_scene("6205")), friction_coefficient=None, effects={"cage": "on"})
    with pytest.raises(InputError, match=r"friction\.coefficient is missing"):
        check_scene(scene)


def no_room_in_the_pocket(scene: Scene) -> Scene:
    assert scene.cage is not None
    return replace(scene, cage=replace(scene.cage, pocket_diameter=scene.bearing.ball_diameter))


@pytest.mark.parametrize(
    ("spoiled", "words"),
    [
        (lambda scene: replace(scene, effects={"rolling": "on"}), "effects.rolling"),  # which the contacts do not see
        (no_room_in_the_pocket, "pocket_diameter"),  # the third contact, after two that can be solved
    ],
    ids=["effect", "pocket"],
)
def test_what_cannot_be_had_is_refused_before_anything_is_solved(
    monkeypatch: pytest.MonkeyPatch, spoiled: Callable[[Scene], Scene], words: str
) -> None:
    def never(*_: object, **__: object) -> None:
        raise AssertionError("solved what was to be refused")

    monkeypatch.setattr(module, "solve_contact", never)
    with pytest.raises(InputError, match=words):
        check_scene(spoiled(load_scene(builtin_scene("6205"))))


def test_each_race_takes_its_own_contact_to_the_torque(monkeypatch: pytest.MonkeyPatch) -> None:
    taken: dict[str, str] = {}

    def note(_: Scene, *, inner: str, outer: str) -> None:
        taken.update(inner=inner, outer=outer)
        raise AskedError

    monkeypatch.setattr(module, "with_ring", lambda found: found)
    monkeypatch.setattr(module, "solve_contact", lambda _, *, pair, geometry, **__: f"{pair} {geometry}")
    monkeypatch.setattr(module, "change_of_torque", note)
    with pytest.raises(AskedError):
        check_scene(load_scene(builtin_scene("6205")))
    assert taken == {"inner": "inner real", "outer": "outer real"}
