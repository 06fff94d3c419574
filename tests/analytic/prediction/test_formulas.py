"""What the uncertainty of the formulas does to the torque."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.oil.variation import GREASE_SPREAD, OIL_LOSS_FACTORS, Variation
from analytic.prediction.first_order import end_factors, moved_totals
from analytic.prediction.formulas import with_model_uncertainty
from analytic.prediction.spreads import DEFAULTS
from analytic.scene import Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

OILED_6206 = """
name = "6206"
tolerance = "5 %"
bearing.catalog = "6206"
operation = { radial_load = "2 kN", axial_load = "0 N", inner_speed = "1500 rpm", down = [1, 0, 0] }
lubricant = { name = "ISO VG 46", temperature = "70 degC" }
surface.finish = "ground and honed"
"""
SCENES = Path(__file__).parents[3] / "validation" / "scenes"


def test_of_dry_balls_only_the_law_of_elastic_rolling_is_uncertain() -> None:
    scene = load_scene("6205-dry")
    found = friction_torque(scene)
    assert found.row(0).uncertainty.model is None
    other = friction_torque(replace(scene, elastic_rolling="houpert")).torque
    assert np.all(present(other.hysteresis) > 2 * present(found.torque.hysteresis))
    assert present(with_model_uncertainty(scene, found).model_parts).keys() == {"elastic_rolling"}
    told = present(with_model_uncertainty(scene, found).model_uncertainty)
    # The change is that on coarser nodes, 3e-4 of it apart.
    np.testing.assert_allclose(told, other.total / found.torque.total - 1, rtol=1e-3)
    lossless = replace(scene, hysteresis_loss=0.0)
    assert with_model_uncertainty(lossless, friction_torque(lossless)).model_uncertainty is None


def test_films_moved_by_twice_the_standard_uncertainty_count() -> None:
    """A thinner film leaves asperities more of the load, a thicker one less; the larger change counts."""
    scene = load_scene(SCENES / "6205_paper_calibrated.toml")
    found = with_model_uncertainty(scene, friction_torque(scene))
    thin, thick = (
        friction_torque(scene, variation=Variation(film=np.exp(2 * sign * FORMULA_UNCERTAINTY))) for sign in (-1, 1)
    )
    more, less = (moved.torque.total / found.torque.total - 1 for moved in (thin, thick))
    assert np.all((more > 0) & (less < 0))
    parts, whole = present(found.model_parts), present(found.model_uncertainty)
    np.testing.assert_allclose(parts["film"], np.maximum(more, -less), rtol=1e-12)
    assert set(parts) == {"film", "traction", "gap", "surfaces", "starvation", "elastic_rolling"}  # no rolling in oil
    np.testing.assert_allclose(whole**2, sum(part**2 for part in parts.values()), rtol=1e-12)
    told = found.row(2).uncertainty
    assert told.model == whole[2]
    assert told.model_parts == {name: part[2] for name, part in parts.items()}


def test_the_other_parts_are_the_changes_by_other_formulas() -> None:
    """Each is computed here by hand, at a speed where the two formulas of rolling differ little."""
    scene = replace(with_reach(load_scene(SCENES / "6205_physical.toml"), 0.6), tolerance=1e-3)
    plain = friction_torque(scene)
    parts, same = present(with_model_uncertainty(scene, plain).model_parts), scene
    total = plain.torque.total
    measured = friction_torque(same, variation=Variation(asperity_share=1.0)).torque.total
    # Free balls differ by the solver error: a variation keeps the nodes of the torque.
    np.testing.assert_allclose(parts["gap"], measured / total - 1, rtol=0.01)
    pressed = friction_torque(same, variation=Variation(asperity_pressure=np.exp(-0.16))).torque.total
    np.testing.assert_allclose(parts["surfaces"], np.abs(pressed / total - 1), rtol=0.2)  # or by exp(0.16), alike
    assert np.all(parts["surfaces"] > 1e-3)
    rolling = present(plain.torque.rolling)
    # The factor hardly moves the balls, and all torques have the same quadrature: known to 1e-4 of the change.
    np.testing.assert_allclose(parts["rolling"], np.expm1(0.5 * 0.12) * rolling / total, rtol=1e-3)
    more, less = (with_reach(same, ahead) for ahead in (0.66, 0.3))
    changes = [np.abs(friction_torque(each).torque.total / total - 1) for each in (more, less)]
    np.testing.assert_allclose(parts["reach"], np.max(changes, axis=0), rtol=0.02)  # as for asperities
    assert np.all(parts["reach"] * total / rolling > 0.01)  # beyond half of the ball's radius the gap is wide


def with_reach(scene: Scene, ahead: float) -> Scene:
    oil = present(scene.lubricant)
    return replace(scene, lubricant=replace(oil, reach=replace(oil.reach, ahead=ahead)))


def test_without_thickening_the_closed_formula_has_its_own_error() -> None:
    """The numerical solutions begin at L = 2: without it the closed formula counts, with its larger uncertainty."""
    scene = load_scene(SCENES / "6205_physical.toml")
    thin = replace(
        scene, lubricant=replace(present(scene.lubricant), pressure_viscosity=0.0, traction="eyring_constant")
    )
    plain = friction_torque(thin)
    parts = present(with_model_uncertainty(thin, plain).model_parts)
    share = present(plain.torque.rolling) / plain.torque.total
    np.testing.assert_allclose(parts["rolling"], np.expm1(0.5) * share, rtol=1e-3)  # as above


def test_measured_friction_adds_to_a_6206_what_another_code_says() -> None:
    """6.5 N mm by load sharing after [Taylor2026], under 2 kN at 1500 rpm with VG 46 at 70 degC."""
    scene = parse_scene(OILED_6206, origin="here")
    found = friction_torque(scene)
    told = with_model_uncertainty(scene, found)
    added = present(told.model_parts)["gap"] * found.torque.total
    # That code has its own load distribution, 8 % apart, wider grooves, and the other of two formulas of the same
    # measurements.
    np.testing.assert_allclose(added, 6.5e-3, rtol=0.3)
    assert np.all(found.torque.total * (1 + present(told.model_uncertainty)) > found.torque.total + 6.5e-3)
    ends = present(moved_totals(scene, found))
    upper = found.torque.total * end_factors(ends.base, [ends.moved["model.gap"]])[1]
    # The end of 95 % is at 0.98 of the way of a step of 1.
    np.testing.assert_allclose(upper - found.torque.total, added, rtol=0.1)


def test_films_of_grease_have_a_factor_of_their_own() -> None:
    """A thinner or a thicker one by twice its standard uncertainty, whichever changes the torque more."""
    scene = load_scene(SCENES / "6205_physical.toml")
    grease = replace(present(scene.lubricant), supply="grease", surface_tension=0.027)
    scene = replace(scene, lubricant=grease, tolerance=1e-3)
    plain = friction_torque(scene)
    parts, same = present(with_model_uncertainty(scene, plain).model_parts), scene
    changes = [
        np.abs(friction_torque(same, variation=Variation(grease_film=factor)).torque.total / plain.torque.total - 1)
        for factor in (np.exp(-2 * GREASE_SPREAD), np.exp(2 * GREASE_SPREAD))
    ]
    # Free balls differ by the solver error, 3e-4 of the torque: a variation keeps the nodes of the torque.
    np.testing.assert_allclose(parts["grease_film"], np.maximum(*changes), atol=3e-4)
    assert parts["grease_film"].max() > 1e-3


def test_smooth_oil_of_constant_stress_does_not_care() -> None:
    scene = load_scene(SCENES / "6205_paper_calibrated.toml")
    assert scene.surface is not None
    smooth = replace(scene, surface=replace(scene.surface, rms_roughness=0.0))
    plain = friction_torque(smooth)
    parts = present(with_model_uncertainty(smooth, plain).model_parts)
    # But for the molecules of a film: of the load e^-h meets 0.035, and of the stress's share as much is lost.
    thin = np.exp(-2 * FORMULA_UNCERTAINTY) * np.minimum(present(plain.film.inner), present(plain.film.outer)) / 1e-9
    assert np.all(parts["film"] <= 20 * np.exp(-thin))
    assert parts["film"][-1] < 1e-9


def test_factors_within_which_a_loss_lies_evenly_have_the_deviation_of_an_even_logarithm() -> None:
    least, most = np.log(OIL_LOSS_FACTORS)
    every = np.linspace(least, most, 20001)  # evenly: its standard deviation is that of the distribution
    assert DEFAULTS["model.oil_losses"].deviation == pytest.approx(np.std(every), rel=1e-3)  # 1/20 000 by the ends
