"""Films measured with grease: the printed laws, how they mix, and what they do in a bearing."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.oil.grease import axial_share_of, log_greased_film
from analytic.prediction.formulas import with_model_uncertainty
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

GREASED = """
name = "greased"
tolerance = "2 %"
[bearing]
catalog = "6206"
[operation]
axial_load = "310 N"
inner_speed = "3400 rpm"
[lubricant]
name = "SKF GJN"
temperature = "61 degC"
[surface]
finish = "superfinished"
[friction]
spin_rule = "balanced"
"""


@pytest.fixture(scope="module")
def scene() -> Scene:
    return parse_scene(GREASED, origin="here")


def test_the_laws_are_as_printed() -> None:
    """Axial: 0.054 (eta b u)^-0.29; radial: 1.8 (eta u/sigma)^-0.31 [Shetty2024]; both: their logarithms by weight."""
    shear, width, tension = 0.0321 * 6.6, 0.93e-3, 0.0171
    axial, radial, both = (np.exp(log_greased_film(shear, width, tension, share)) for share in (1.0, 0.0, 0.36))
    np.testing.assert_allclose(axial, 0.641, rtol=1e-3)  # by hand: eta b u = 1.970e-4
    np.testing.assert_allclose(radial, 0.8248, rtol=1e-3)  # eta u/sigma = 12.39
    np.testing.assert_allclose(both, axial**0.36 * radial**0.64, rtol=1e-12)


def test_a_moment_counts_as_its_force_on_the_pitch_diameter() -> None:
    assert axial_share_of(300.0, -100.0, 0.0, 0.04) == pytest.approx(0.75)
    assert axial_share_of(300.0, 0.0, -2.0, 0.04) == pytest.approx(0.75)
    assert axial_share_of(0.0, 0.0, 0.0, 0.04) == 1.0


def test_film_and_rolling_of_a_greased_bearing_are_starved_as_measured(scene: Scene) -> None:
    """With the width and the speed of the contact from the result and from the geometry."""
    found, oil = friction_torque(scene), present(scene.lubricant)
    flooded = friction_torque(replace(scene, effects={"starvation": "off"}))
    assert "measured" in found.provenance["inlets"]
    smooth = found.boundary_share.inner
    assert np.all(present(smooth) < 1e-3)  # so that the film is that of a smooth contact
    orbit, ball = scene.bearing.pitch_diameter / 2, scene.bearing.ball_radius
    across = ball * np.cos(found.contact_angle)
    speed = scene.operation.inner_speed * (orbit - across) * (orbit + across) / (2 * orbit)
    for race in ("inner", "outer"):
        width = getattr(found, race).semi_axis_transverse
        expected = 0.054 * (oil.viscosity * width * speed) ** -0.29
        ratio = present(getattr(found.film, race)) / present(getattr(flooded.film, race))
        # The load on asperities, below 1e-3 of all, lifts the film a little.
        np.testing.assert_allclose(ratio, expected, rtol=2e-3)
    left = present(found.torque.rolling) / present(flooded.torque.rolling)
    assert 0.5 < left < 0.9
    parts = present(with_model_uncertainty(scene, found).model_parts)
    more = np.minimum(np.expm1(0.3), 1 / left - 1)  # up to the flooded film
    change = np.maximum(more, -np.expm1(-0.3)) * present(found.torque.rolling) / found.torque.total
    np.testing.assert_allclose(parts["grease_film"], change, rtol=0.02)  # sliding changes a little too


def test_a_size_that_was_not_measured_is_told(scene: Scene) -> None:
    large = parse_scene(GREASED.replace('"6206"', '"6215"'), origin="here")
    told = [warning for warning in friction_torque(large).warnings if "films with grease are extrapolated" in warning]
    assert len(told) == 1
    assert not any("grease" in warning for warning in friction_torque(scene).warnings)
