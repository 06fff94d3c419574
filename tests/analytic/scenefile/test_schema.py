"""The JSON Schemas of scene files and grid files: what they take, and what they mark."""

import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft7Validator

from analytic import catalog
from analytic.scenefile.keys import scene_table
from analytic.scenefile.schema import scene_schema
from fembearing.sweep.schema import grid_schema
from tests.analytic.scenefile.scene_texts import PLAIN, changed

ROOT = Path(__file__).parents[3]
SCENES = [
    *(ROOT / "validation" / "scenes").glob("*.toml"),
    *(catalog.path("scenes", n) for n in catalog.names("scenes")),
]
SWEEP = {"scene": "my.toml", "axes": {"operation": {"axial_load": ["1 N", "2 N"]}}}


GRID, SCENE = grid_schema(), scene_schema()


@pytest.mark.parametrize("schema", [SCENE, GRID], ids=["scene", "grid"])
def test_a_schema_is_one(schema: dict[str, Any]) -> None:
    Draft7Validator.check_schema(json.loads(json.dumps(schema)))


def complaints(document: dict[str, Any], schema: dict[str, Any] = SCENE) -> list[str]:
    return [error.message for error in Draft7Validator(schema).iter_errors(document)]


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
def test_scenes_of_the_project_are_valid(scene: Path) -> None:
    assert complaints(tomllib.loads(scene.read_text("utf-8"))) == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (changed("catalog", "catalogue"), ("catalogue",)),
        (changed("tolerance", "tolerence"), ("tolerence",)),
        (changed('"700 N"', "700"), ("700",)),
        (changed('"700 N"', '"700"'), ("700",)),
        (changed('"2 %"', "2"), ("2 is not valid",)),
        (changed('"solved"', '"sloved"'), ("sloved",)),
        (changed('name = "a series"', ""), ("'name' is a required property",)),
        (PLAIN + '[effects]\nspin = "yes"', ("yes", "auto")),
        (PLAIN + "[cage]\nseeds = 2.5", ("2.5",)),
        (PLAIN + '[lubricant]\nsupply = "oil"', ("oil_bath",)),
    ],
)
def test_a_mistake_is_marked(text: str, words: tuple[str, ...]) -> None:
    found = complaints(tomllib.loads(text))
    assert all(any(word in message for message in found) for word in words), found


def keys(table: dict[str, Any], before: str = "") -> Iterator[str]:
    for name, inside in table["properties"].items():
        choices = inside.get("anyOf", [inside])
        tables = [choice for choice in choices if choice.get("type") == "object"]
        if len(tables) < len(choices):
            yield before + name
        for choice in tables:
            yield from keys(choice, f"{before}{name}.")


def test_the_schema_has_the_keys_of_the_reader() -> None:
    assert sorted(keys(SCENE)) == sorted(scene_table().paths())


def test_a_grid_is_valid_and_its_mistakes_are_marked() -> None:
    page = (ROOT / "docs" / "sweeps.md").read_text("utf-8")
    blocks = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert blocks
    for text in blocks:
        assert complaints(tomllib.loads(text), GRID) == []
    quoted = {"axes": {"operation.axial_load": ["1 N"], "bearing.conformity": [0.51, 0.53], "pair": ["inner"]}}
    assert complaints(SWEEP | quoted | {"scene": {"operation": {}}}, GRID) == []
    for wrong in (
        {"what": "heat"},
        {"axes": {}},
        {"axes": {"operation": {"axial_laod": ["1 N"]}}},
        {"axes": {"operation": {"axial_load": "1 N"}}},
        {"axes": {"operation": {"axial_load": {"from": "1 N", "to": "2 N"}}}},
        {"scene": {"operation": {"axial_laod": "1 N"}}},
        {"axis": {}},
    ):
        assert complaints(SWEEP | wrong, GRID), wrong
