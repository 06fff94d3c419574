"""A bearing whose ratings fit two sets of balls: the torque of both."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene_torque import torque_of_scene
from analytic.torque import friction_torque
from fembearing.plain_types import plain
from fembearing.report.torque import content_of
from tests.analytic.scenefile.scene_texts import changed, scene

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
