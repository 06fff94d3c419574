"""The JSON Schemas of scene files and grid files: as shipped, and what they mark.

`python -m tests.analytic.scenefile.test_schema` writes them anew.
"""

import json
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft7Validator

from analytic import catalog
from analytic.scenefile import schema
from analytic.scenefile.keys import paths
from fembearing.sweep import schema as grid
from tests.analytic.scenefile.scene_texts import INLINE, OILED, PLAIN, changed

ROOT = Path(__file__).parents[3]
COMMAND = "python -m tests.analytic.scenefile.test_schema"
SCENES = [
    *(ROOT / "validation" / "scenes").glob("*.toml"),
    *(catalog.path("scenes", n) for n in catalog.names("scenes")),
]
SWEEP = {"scene": "my.toml", "axes": {"operation": {"axial_load": ["1 N", "2 N"]}}}


TWO_VISCOSITIES = (
    PLAIN + '[lubricant]\nbase_oil = "mineral"\nviscosity = ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]\n'
)


def text_of(content: dict[str, Any]) -> str:
    return json.dumps(content, indent=1, ensure_ascii=False) + "\n"


SHIPPED = {schema.FILE: schema.scene_schema, grid.FILE: grid.grid_schema}


@pytest.mark.parametrize("file", SHIPPED, ids=lambda file: file.name)
def test_the_shipped_schema_is_that_of_the_tables(file: Path) -> None:
    assert file.read_text("utf-8") == text_of(SHIPPED[file]()), f"{file.name} is old: run {COMMAND}"
    Draft7Validator.check_schema(json.loads(file.read_text("utf-8")))


def complaints(document: dict[str, Any], file: Path = schema.FILE) -> list[str]:
    return [error.message for error in Draft7Validator(json.loads(file.read_text("utf-8"))).iter_errors(document)]


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
def test_scenes_of_the_project_are_valid(scene: Path) -> None:
    assert complaints(tomllib.loads(scene.read_text("utf-8"))) == []


@pytest.mark.parametrize(
    "text", [PLAIN, INLINE, OILED, TWO_VISCOSITIES, changed('"100 rpm"', '"100 1/min"'), changed('"2 %"', "0.02")]
)
def test_what_the_reader_takes_is_valid(text: str) -> None:
    assert complaints(tomllib.loads(text)) == []


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
    assert sorted(keys(schema.scene_schema())) == sorted(paths())


def test_a_grid_is_valid_and_its_mistakes_are_marked() -> None:
    page = (ROOT / "docs" / "sweeps.md").read_text("utf-8")
    blocks = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    assert blocks
    for text in blocks:
        assert complaints(tomllib.loads(text), grid.FILE) == []
    quoted = {"axes": {"operation.axial_load": ["1 N"], "bearing.conformity": [0.51, 0.53], "pair": ["inner"]}}
    assert complaints(SWEEP | quoted | {"scene": {"operation": {}}}, grid.FILE) == []
    for wrong in (
        {"what": "heat"},
        {"axes": {}},
        {"axes": {"operation": {"axial_laod": ["1 N"]}}},
        {"axes": {"operation": {"axial_load": "1 N"}}},
        {"axes": {"operation": {"axial_load": {"from": "1 N", "to": "2 N"}}}},
        {"scene": {"operation": {"axial_laod": "1 N"}}},
        {"axis": {}},
    ):
        assert complaints(SWEEP | wrong, grid.FILE), wrong


if __name__ == "__main__":
    for file, made in SHIPPED.items():
        file.write_text(text_of(made()), "utf-8")
