"""`repr` of nouns and results: one line of 100 characters at most that says which it is."""

from dataclasses import fields, is_dataclass
from typing import Any

from analytic.brief import LONGEST, Brief
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import parse_scene
from fembearing.check.validation import Validation
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed

TEXT = changed(SPEEDS, '["500 rpm", "2000 rpm"]', OILED)


def parts_of(thing: Any) -> list[Any]:
    """A dataclass, and every dataclass within its fields."""
    inside = [getattr(thing, field.name) for field in fields(thing)]
    inside += [each for part in inside if isinstance(part, tuple) for each in part]
    return [thing, *(each for part in inside if is_dataclass(part) for each in parts_of(part))]


def test_every_noun_and_result_has_one_short_line(checked: Validation) -> None:
    scene = parse_scene(TEXT, origin="here")
    things = [part for whole in (scene, torque_of_scene(scene), checked) for part in parts_of(whole)]
    brief = [each for each in things if isinstance(each, Brief)]
    kinds = {type(each).__name__ for each in brief}
    assert {"Scene", "Bearing", "FrictionTorque", "SceneTorque", "Validation", "ContactSolution"} <= kinds
    for each in brief:
        line = repr(each)
        assert line.startswith(f"{type(each).__name__}(")
        assert line.endswith(")")
        assert "\n" not in line
        assert len(line) <= LONGEST == 100
