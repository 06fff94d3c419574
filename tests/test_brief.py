"""`repr` of nouns and results: one line of 100 characters at most that says which it is."""

from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np
import pytest

import analytic
from analytic.brief import LONGEST, Brief, span
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


def test_the_line_says_which_it_is(checked: Validation) -> None:
    scene = parse_scene(TEXT, origin="here")
    result = torque_of_scene(scene)
    low, high = (f"{1e3 * result.friction.torque.total[point]:.4g}" for point in (0, 1))
    points = "2 points, 500 to 2000 rpm, 700 N axial"
    assert repr(scene) == f"Scene(a series, {scene.bearing.name}, {points}, tolerance 0.02)"
    assert repr(result.friction) == f"FrictionTorque(a series, {points}, {low} to {high} N mm)"
    assert f"{low} to {high} N mm" in repr(result)
    assert "tolerance 2 %" in repr(result)
    contact = checked.contacts[0]
    assert f"inner, real, {contact.contact.load:.4g} N, {contact.verdict}" in repr(contact)
    assert f"{len(checked.contacts)} contacts, {checked.verdict}" in repr(checked)
    assert "ball_count=9" in repr(analytic.bearing("6206"))


def test_a_long_name_is_cut_and_lines_are_joined() -> None:
    line = repr(replace(parse_scene(TEXT, origin="here"), name="first\nsecond " * 20))
    assert len(line) == LONGEST
    assert line.startswith("Scene(first second first")
    assert line.endswith("...)")


@pytest.mark.parametrize(
    ("values", "words"),
    [(np.array([3.0, 7.5]), "3 to 7.5"), (2.5, "2.5"), (np.array([4.0, 4.0]), "4"), (np.array([]), "0 values")],
)
def test_a_span(values: Any, words: str) -> None:
    assert span(values) == words


def test_operations_compare_as_before() -> None:
    """The base has no comparison of its own, by which all operations would be equal."""
    one, other = (analytic.operation(axial_load=load, inner_speed=50.0) for load in (300.0, 400.0))
    assert one == one
    assert one != other
