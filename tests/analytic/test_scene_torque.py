"""What is said beside a torque: where it lies by the catalogue, its range, film ratio and other balls; its columns."""

from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.left_out import Places
from analytic.makers import BesideCatalogue, CatalogueBand
from analytic.scene import Scene
from analytic.scene_torque import (
    SceneTorque,
    torque_of_scene,
)
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.plain_types import plain
from fembearing.report.torque import content_of
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed, scene


def band_of(low: list[float], high: list[float]) -> BesideCatalogue:
    band = CatalogueBand(low=np.array(low), high=np.array(high), values=MappingProxyType({"SKF": np.array(low)}))
    return BesideCatalogue(band=band, note="")


@pytest.fixture(scope="module")
def oiled() -> Scene:
    return scene(changed(SPEEDS, '["300 rpm", "100 rpm", "900 rpm"]', OILED))


@pytest.fixture(scope="module")
def result(oiled: Scene) -> SceneTorque:
    return torque_of_scene(oiled, estimate=False)


def test_seals_and_drag_are_not_in_the_formulas_and_not_compared_with_them() -> None:
    """The seals of a 6205-2RS1, 67.9 N mm by SKF's formula, are most of its torque."""
    loads: dict[str, Any] = {"axial_load": "300 N", "radial_load": "200 N"}
    bare = torque_of_scene(load_scene("6205", **loads), estimate=False)
    sealed = torque_of_scene(
        load_scene("6205-2RS1", settings={"losses.seals": "estimate", "losses.oil_share": "2 %"}, **loads),
        estimate=False,
    )
    assert (sealed.friction.torque.total > 3 * bare.friction.torque.total).all()
    assert bare.standing.reason.startswith("inside the makers' formulas; ")
    assert sealed.standing.reason.startswith("inside the makers' formulas, without seals and drag; ")


def with_lost(result: SceneTorque, number: int) -> Places:
    """The points of a result with one more, which has no torque."""
    own = result.scene.operation.as_series()
    lost = {"axial_load": 5e9, "inner_speed": 30.0, "radial_load": 2.0, "moment": 0.3}
    loads = {name: np.insert(getattr(own, name), number, value) for name, value in lost.items()}
    return Places(operation=replace(own, **loads), failures={number: InputError("too heavy")})


def test_columns_hold_what_is_known_beside_the_torque_and_nothing_at_lost_points(result: SceneTorque) -> None:
    total = result.friction.torque.total
    bare = replace(result, catalogue=BesideCatalogue(band=None, note=""))
    assert not {"interval_low", "catalogue_high"} & bare.columns().keys()
    found = replace(
        bare,
        interval=np.array([0.7 * total, 1.6 * total]),
        catalogue=band_of((0.4 * total).tolist(), (3 * total).tolist()),
        without=with_lost(result, 1),
    ).to_dataset()
    for name, factor in (("interval_low", 0.7), ("interval_high", 1.6), ("catalogue_low", 0.4), ("catalogue_high", 3)):
        np.testing.assert_array_equal(found[name], np.insert(factor * total, 1, np.nan))
    np.testing.assert_array_equal(found["axial_load"], [700.0, 5e9, 700.0, 700.0])
    np.testing.assert_array_equal(found["torque_total"], np.insert(total, 1, np.nan))


def test_a_verdict_keeps_the_number_of_its_point_where_others_are_lost(result: SceneTorque) -> None:
    moved = replace(result, without=with_lost(result, 0)).verdicts.physical
    assert [each.point for each in moved] == [each.point + 1 for each in result.verdicts.physical]


def test_an_interval_that_is_no_number_is_shown_nowhere(result: SceneTorque) -> None:
    with pytest.raises(InputError, match=r"lower end of the 95 % interval of the friction torque is nan N m"):
        replace(result, interval=np.full((2, 3), np.nan))


TEXT = changed('contact_angle = { rule = "solved" }', "", changed('catalog = "paper_6205"', 'catalog = "6306"'))
SCENE = replace(scene(TEXT + "[friction]\ncoefficient = 0.07\n"), spin_rule="balanced")


def test_both_torques_are_shown() -> None:
    result, other = torque_of_scene(SCENE), SCENE.bearing.other_candidate
    assert other is not None
    alone = friction_torque(replace(SCENE, bearing=other)).torque.total
    shown = plain(content_of(result).other_candidate)
    assert (shown["ball_count"], shown["ball_diameter"]) == (8, pytest.approx(12e-3, rel=1e-9))
    np.testing.assert_allclose(shown["total"], alone, rtol=1e-12)  # round-off
    (sentence,) = [note for note in result.notes if "nearly as well" in note]
    for total in (result.friction.torque.total[0], alone[0]):
        assert f"{1e3 * total:.4g}" in sentence


def test_a_candidate_without_a_torque_leaves_the_other_one() -> None:
    """Its rings are so far apart that no contact angle closes them."""
    other = SCENE.bearing.other_candidate
    assert other is not None
    apart = replace(other, outer=replace(other.outer, bottom_radius=other.outer.bottom_radius + 1e-3))
    result = torque_of_scene(replace(SCENE, bearing=replace(SCENE.bearing, other_candidate=apart)))
    assert content_of(result).other_candidate is None
    assert sum("there is no torque" in warning for warning in result.friction.warnings) == 1
    assert np.all(result.friction.torque.total > 0)


def test_a_notebook_shows_interval_verdict_and_warnings_as_they_are(result: SceneTorque) -> None:
    ends = np.array([[0.011, 0.012, 0.013], [0.091, 0.092, 0.093]])
    warned = replace(result.friction, warnings=("a <b> warning",))
    text = replace(result, interval=ends, friction=warned)._repr_html_()
    assert "<th>interval low, N mm</th><th>interval high, N mm</th>" in text
    assert "<td>11</td><td>91</td>" in text
    assert f"<p>{result.standing.word}: " in text
    assert "a &lt;b&gt; warning" in text
