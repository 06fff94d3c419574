"""What the uncertainty of the formulas does to the torque."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.oil.variation import Variation
from analytic.prediction.first_order import end_factors, moved_totals
from analytic.prediction.formulas import with_model_uncertainty
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
    assert found.rows[0]["uncertainty_model"] is None
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
    told = found.rows[2]
    assert told["uncertainty_model"] == whole[2]
    assert all(told[f"uncertainty_model_{name}"] == part[2] for name, part in parts.items())


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
