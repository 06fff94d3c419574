"""What the film formula's uncertainty does to the torque."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.scenefile.read import builtin_scene, load_scene
from analytic.torque import friction_torque, with_model_uncertainty

SCENES = Path(__file__).parents[2] / "validation" / "scenes"


def test_without_a_film_nothing_is_known() -> None:
    scene = load_scene(builtin_scene("6205"))
    found = friction_torque(scene)
    assert with_model_uncertainty(scene, found).model_uncertainty is None
    assert found.to_json()["points"][0]["uncertainty"]["model"] is None


def test_a_thinner_film_by_twice_the_standard_uncertainty_counts() -> None:
    """In the calibrated scene asperities carry a few per cent of the load: the thinner film is the worse one."""
    scene = load_scene(SCENES / "6205_paper_calibrated.toml")
    found = with_model_uncertainty(scene, friction_torque(scene))
    thin = friction_torque(scene, film_factor=1 - 2 * FORMULA_UNCERTAINTY)
    assert found.model_uncertainty is not None
    np.testing.assert_allclose(found.model_uncertainty, thin.torque.total / found.torque.total - 1, rtol=1e-12)
    assert found.to_json()["points"][2]["uncertainty"]["model"] == found.model_uncertainty[2]


def test_smooth_oil_of_constant_stress_does_not_care() -> None:
    scene = load_scene(SCENES / "6205_paper_calibrated.toml")
    assert scene.surface is not None
    smooth = replace(scene, surface=replace(scene.surface, rms_roughness=0.0))
    found = with_model_uncertainty(smooth, friction_torque(smooth)).model_uncertainty
    np.testing.assert_allclose(found, 0.0, atol=1e-12)  # e^-30 of a film of 30 nm is a molecule's


def test_the_same_effects_are_taken_again() -> None:
    """At a tolerance where asperities are left out they stay out, though a thinner film would call for them."""
    scene = replace(load_scene(SCENES / "6205_physical.toml"), tolerance=0.5)
    found = friction_torque(scene)
    out = {effect.name for effect in found.effects if effect.decision == "off"}
    again = friction_torque(found.settled(replace(scene, tolerance=1e-4)), film_factor=0.7)
    assert {effect.name for effect in again.effects if effect.decision == "off"} == out
    assert again.sliding == found.sliding
