"""The main job: which contacts a scene calls for, and which of them are judged."""

from dataclasses import replace
from typing import Any

import pytest

from analytic.scenefile import builtin_scene, load_scene
from fembearing.compare import validation as module
from fembearing.compare.validation import check_scene


class AskedError(Exception):
    """In place of a solution."""


@pytest.mark.parametrize(("has_cage", "pairs"), [(True, ["inner real", "outer real", "pocket real", "pocket wall"]),
                                                 (False, ["inner real", "outer real"])])  # fmt: skip
def test_no_cage_means_no_pocket_solve(monkeypatch: pytest.MonkeyPatch, has_cage: bool, pairs: list[str]) -> None:
    asked: list[str] = []

    def note(_: object, *, pair: str, geometry: str, **__: Any) -> None:
        asked.append(f"{pair} {geometry}")

    def stop(*_: object, **__: object) -> None:
        raise AskedError

    monkeypatch.setattr(module, "solve_contact", note)
    monkeypatch.setattr(module, "change_of_torque", stop)
    scene = load_scene(builtin_scene("6205"))
    with pytest.raises(AskedError):
        check_scene(scene if has_cage else replace(scene, cage=None))
    assert asked == pairs
