"""The ladders of a whole scene in one run."""

import json
from dataclasses import replace

import pytest

from analytic.errors import InputError
from analytic.scene import ContactAngle, Scene
from analytic.scenefile.read import builtin_scene, load_scene
from fembearing.compare.cost import scene_cost as cost
from fembearing.compare.cost.scene_cost import measure_cost
from fembearing.mesh.recipe import load_recipe


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene(builtin_scene("6205"))


@pytest.mark.usefixtures("timed_once")
def test_every_ladder_is_run_or_said_to_be_absent(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "load_recipe", lambda _: replace(load_recipe("race"), levels=(1, 2)))
    given = replace(scene, contact_angle=ContactAngle(rule="given", value=0.21))
    told_of: list[tuple[float, str]] = []
    found = measure_cost(given, tolerance=1e-12, progress=lambda *step: told_of.append(step))
    assert [ladder.quantity for ladder in found.ladders] == [
        "Hertz contact",
        "load of the heaviest ball",
        "friction torque",
        "roughness",
        "cage torque",
        "contact, inner",
    ]
    hertz, load, friction, roughness, cage, contact = found.ladders
    assert "holds the angle" in (load.absent or "")
    assert "no [surface]" in (roughness.absent or "")
    assert hertz.chosen is hertz.rungs[-1]  # exact
    assert friction.chosen is cage.chosen is contact.chosen is None  # nothing there is known that well
    assert told_of == sorted(told_of, key=lambda step: step[0])
    assert "inner: mesh 2, about" in told_of[-1][1]
    told = json.loads(json.dumps(found.to_json(), allow_nan=False))
    assert {"ladders", "tolerance", "cost", "warnings", "provenance"} == told.keys()
    assert {"quantity", "reference", "absent", "rungs", "choices"} == told["ladders"][5].keys()
    mesh = told["ladders"][5]["rungs"][2]
    assert {"name", "error", "seconds", "memory", "chosen"} < mesh.keys()
    assert mesh["seconds"] > 0
    assert mesh["predicted"] > 0
    assert mesh["warm_up"] > 0
    assert told["provenance"]["scene"] == scene.name


def test_a_tolerance_must_be_positive(scene: Scene) -> None:
    with pytest.raises(InputError, match="tolerance must be positive"):
        measure_cost(scene, tolerance=0.0)
