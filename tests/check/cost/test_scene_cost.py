"""The ladders of a whole scene in one run."""

import json
from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import ContactAngle, Scene
from analytic.scenefile.read import load_scene
from fembearing.check.cost import scene_cost as cost
from fembearing.check.cost.formula_ladders import load_methods
from fembearing.check.cost.scene_cost import measure_cost
from fembearing.mesh.recipe import load_recipe
from fembearing.plain_types import plain


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene("6205-dry")


@pytest.mark.usefixtures("timed_once")
def test_every_ladder_is_run_or_absent_with_a_reason(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cost, "load_recipe", lambda _: replace(load_recipe("race"), levels=(1, 2)))
    given = replace(scene, contact_angle=ContactAngle(rule="given", value=0.21))
    steps: list[tuple[float, str]] = []
    found = measure_cost(given, tolerance=1e-12, progress=lambda *step: steps.append(step))
    assert [ladder.quantity for ladder in found.ladders] == [
        "Hertz contact",
        "load of the heaviest ball",
        "friction torque",
        "how balls turn",
        "sliding in the contacts",
        "roughness",
        "cage torque",
        "central film, inner",
        "rolling force, inner",
        "contact, inner",
    ]
    hertz, load, friction, turning, sliding, roughness, cage, film, force, contact = found.ladders
    assert "fixes the angle" in (load.absent or "")
    assert "no [surface]" in (roughness.absent or "")
    assert "[lubricant]" in (film.absent or "")
    assert "[lubricant]" in (force.absent or "")
    assert hertz.chosen is hertz.methods[-1]  # exact
    # No error there is known to be so small.
    assert friction.chosen is turning.chosen is sliding.chosen is cage.chosen is contact.chosen is None
    assert steps == sorted(steps, key=lambda step: step[0])
    assert "inner: mesh 2, about" in steps[-1][1]
    document = json.loads(json.dumps(plain(found), allow_nan=False))
    mesh = document["ladders"][9]["methods"][2]
    assert min(mesh["seconds"], mesh["predicted"], mesh["warm_up"]) > 0


def test_a_tolerance_must_be_positive(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"tolerance.*0"):
        measure_cost(scene, tolerance=0.0)


@pytest.mark.parametrize(("load", "methods"), [("radial_load", 1), ("axial_load", 5)])
def test_thrust_alone_is_a_method_where_there_is_thrust(load: str, methods: int) -> None:
    """No method is offered that has to fail; the same reference either way."""
    loads = {"operation.radial_load": "0 N", f"operation.{load}": "330 N"}
    found = load_methods(load_scene("6206", settings=loads)).methods
    assert len(found) == methods
    assert found[-1].may_refer
    assert all(np.all(np.isfinite(method.run())) for method in found)
