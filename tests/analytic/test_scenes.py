"""The scenes beside the paper load, and give what was found for them independently."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic.hertz import contact_modulus
from analytic.scene import Autocorrelation, ContactAngle
from analytic.scenefile import load_scene
from analytic.torque import friction_torque

SCENES = Path(__file__).parents[2] / "validation" / "scenes"


@pytest.mark.parametrize(
    ("length", "roughness", "slow", "fast"),
    [(150e-6, 1e-6, 17.9, 17.1), (180e-6, 1e-6, 16.1, 15.4), (150e-6, 0.1e-6, 7.8, 7.4)],
)
def test_the_calibrated_race_torque(length: float, roughness: float, slow: float, fast: float) -> None:
    """An independent calculation of the same fit, N mm at 100 and 500 rpm, three digits; 0.1 um at any length."""
    scene = load_scene(SCENES / "6205_paper_calibrated.toml")
    assert scene.surface is not None
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 20)
    surface = replace(scene.surface, autocorrelation=correlation, rms_roughness=roughness)
    race = 1e3 * friction_torque(replace(scene, surface=surface)).torque.race
    tolerance = 0.06 if roughness == 1e-6 else 0.11  # half a unit of the last digit; 0.07 lie between both lengths
    np.testing.assert_allclose(race[[0, -1]], [slow, fast], atol=tolerance)
    assert np.all(np.diff(race) < 0)


def test_the_physical_scene() -> None:
    """Loaded angle of an independent calculation; rolling grows with speed and is as large as what slides."""
    scene = load_scene(SCENES / "6205_physical.toml")
    found = friction_torque(replace(scene, effects={"finite_geometry": "off"}))
    np.testing.assert_allclose(found.contact_angle, 0.3031, atol=0.5e-4)
    assert found.torque.rolling is not None
    assert np.all(np.diff(found.torque.total) > 0)
    assert found.torque.rolling[-1] > 0.5 * found.torque.total[-1]


def test_the_hybrid_scene() -> None:
    """Its ball has its material's mass; contacts of a stiffer ball are smaller, as Hertz's law of the modulus says."""
    scene = load_scene(SCENES / "6205_hybrid.toml")
    assert scene.warnings == ()  # a mass left behind would be one
    ceramic, steel = scene.bearing.ball_material, scene.bearing.inner.material
    np.testing.assert_allclose(scene.bearing.ball_mass / 2.04e-3, ceramic.density / 7850, rtol=0.01)  # Table 1 rounds
    # so that loads are equal, and contacts Hertz's
    scene = replace(scene, contact_angle=ContactAngle(rule="given", value=0.29), effects={"finite_geometry": "off"})
    found = friction_torque(scene)
    of_steel = friction_torque(replace(scene, bearing=replace(scene.bearing, ball_material=steel)))
    stiffer = contact_modulus(ceramic, steel) / contact_modulus(steel, steel)
    assert 1.15 < stiffer < 1.25  # by hand, 2 x 310/(310 + 206) but for Poisson's ratios
    for pair in ("inner", "outer"):
        ours, theirs = getattr(found, pair), getattr(of_steel, pair)
        np.testing.assert_allclose(ours.semi_axis_transverse, theirs.semi_axis_transverse * stiffer ** (-1 / 3))
        np.testing.assert_allclose(ours.peak_pressure, theirs.peak_pressure * stiffer ** (2 / 3))
    assert found.torque.hysteresis is not None
    assert of_steel.torque.hysteresis is not None
    np.testing.assert_allclose(found.torque.hysteresis, of_steel.torque.hysteresis * stiffer ** (-1 / 3))
