"""The same scene and seeds give the same numbers, but for times, memory and where they come from."""

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from fembearing.check.contact import scene_contact
from fembearing.check.validation import Validation
from fembearing.mesh.recipe import Recipe
from fembearing.plain_types import plain
from fembearing.provenance import MEMORY, ORIGIN, TIMES, VARYING, repeatable
from fembearing.report.folder import validate
from fembearing.report.report import report_of
from tests.analytic.scenefile.scene_texts import MINE, scene

pytestmark = pytest.mark.slow  # two checks of a scene


@pytest.fixture(scope="module")
def twice(shallow: Callable[[str], Recipe]) -> list[Validation]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(scene_contact, "load_recipe", shallow)
        return [validate(replace(scene(MINE), tolerance=0.9)) for _ in range(2)]


def told(result: Validation) -> dict[str, Any]:
    return json.loads(json.dumps(plain(report_of(result))))


def test_two_runs_differ_in_times_memory_and_origin_alone(twice: list[Validation]) -> None:
    first, second = map(told, twice)
    assert repeatable(first) == repeatable(second)
    assert first["cost"]["seconds"] != second["cost"]["seconds"]  # they did run twice
    assert len(json.dumps(repeatable(first))) > 0.6 * len(json.dumps(first))  # and most of it is compared


def test_what_is_not_compared_is_named_in_one_place(twice: list[Validation]) -> None:
    content = told(twice[0])
    assert {"seconds", "peak_memory", "date", "command", "versions"} <= VARYING == {*TIMES, *MEMORY, *ORIGIN}
    for kept in ("scene_content", "scene_sha256", "seeds"):
        assert repeatable(content)["provenance"][kept] == content["provenance"][kept]
    assert repeatable(content)["contacts"][0]["quantities"] == content["contacts"][0]["quantities"]
    assert repeatable([{"seconds": 3.0, "error": 0.1}, 5]) == [{"error": 0.1}, 5]


def test_nothing_here_is_random_and_the_numbers_say_so(twice: list[Validation]) -> None:
    assert told(twice[0])["provenance"]["seeds"] == {}
