"""The origin of a result: enough to run it again."""

import json
from dataclasses import replace

from analytic.scenefile.read import load_scene
from fembearing.provenance import provenance_of


def test_a_result_holds_its_scene_in_full() -> None:
    scene = load_scene("6205-dry")
    content = json.loads(json.dumps(provenance_of(scene).scene_content))
    assert content["operation"]["axial_load"] == scene.operation.axial_load.tolist()
    assert content["bearing"]["inner"]["groove_radius"] == scene.bearing.inner.groove_radius
    assert content["cage"]["material"]["youngs_modulus"] == 206e9
    assert content["friction_coefficient"] == scene.friction_coefficient


def test_the_hash_depends_on_the_scene_alone() -> None:
    scene = load_scene("6205-dry")
    again = load_scene("6205-dry")
    other = replace(scene, bearing=replace(scene.bearing, ball_diameter=scene.bearing.ball_diameter * (1 + 1e-12)))
    first, second, third = (provenance_of(one).scene_sha256 for one in (scene, again, other))
    assert first == second != third
