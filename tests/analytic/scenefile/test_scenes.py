"""The scenes in validation/scenes load and agree with independent calculations."""

from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus, hertz_contact
from analytic.makers import scene_band
from analytic.scene import ContactAngle
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

SCENES = Path(__file__).parents[3] / "validation" / "scenes"


def test_the_physical_scene() -> None:
    """Loaded angle of frictionless balls by an independent calculation; rolling grows with speed to more than a third
    of all."""
    scene = replace(load_scene(SCENES / "6205_physical.toml"), effects={"finite_geometry": "off"})
    ruled = friction_torque(replace(scene, spin_rule="balanced"))
    np.testing.assert_allclose(ruled.contact_angle, 0.3031, atol=0.5e-4)
    assert np.all(np.diff(ruled.torque.total) > 0)
    result = friction_torque(scene)
    # Spin pushes the balls across both grooves, with a part of their friction: at most 0.12 of the load.
    np.testing.assert_allclose(result.contact_angle, 0.3031, atol=0.1 * 0.12)
    assert np.all(np.diff(present(result.torque.rolling)) > 0)
    assert present(result.torque.rolling)[-1] > result.torque.total[-1] / 3


def test_the_hybrid_scene() -> None:
    """The ball has the mass of its material; contacts of a stiffer ball are smaller by Hertz's power of the modulus."""
    scene = load_scene(SCENES / "6205_hybrid.toml")
    assert scene.warnings == ()  # the mass of a steel ball would give one
    ceramic, steel = scene.bearing.ball_material, scene.bearing.inner.material
    np.testing.assert_allclose(scene.bearing.ball_mass / 2.04e-3, ceramic.density / 7850, rtol=0.01)  # Table 1 rounds
    # so that the loads are equal, the contacts those of Hertz and the rolling rates those of closed kinematics
    scene = replace(
        scene,
        spin_rule="balanced",
        contact_angle=ContactAngle(rule="given", value=0.29),
        effects={"finite_geometry": "off"},
    )
    result = friction_torque(scene)
    of_steel = friction_torque(replace(scene, bearing=replace(scene.bearing, ball_material=steel)))
    stiffer = contact_modulus(ceramic, steel) / contact_modulus(steel, steel)
    assert 1.15 < stiffer < 1.25  # by hand, 2 x 310/(310 + 206) but for Poisson's ratios
    for pair in ("inner", "outer"):
        ours, theirs = getattr(result, pair), getattr(of_steel, pair)
        np.testing.assert_allclose(ours.semi_axis_transverse, theirs.semi_axis_transverse * stiffer ** (-1 / 3))
        np.testing.assert_allclose(ours.peak_pressure, theirs.peak_pressure * stiffer ** (2 / 3))
    assert of_steel.torque.hysteresis is not None
    np.testing.assert_allclose(present(result.torque.hysteresis), of_steel.torque.hysteresis * stiffer ** (-1 / 3))


def test_the_radial_scene() -> None:
    """Load of the most loaded ball when the rings shift by d: the load is the sum of K (d cos psi - P_d/2)^1.5 cos psi.

    The thrust is left out here. It tilts the ring and adds 4 % to the most loaded ball.
    """
    scene = load_scene(SCENES / "6205_radial.toml")
    result = friction_torque(scene)
    bearing, azimuth = scene.bearing, 2 * np.pi * np.arange(9) / 9
    approach = 0.0  # of both contacts under 1 N
    for race in ("inner", "outer"):
        along, across = race_curvatures(bearing, race, contact_angle=0.0)
        modulus = contact_modulus(bearing.ball_material, bearing.inner.material)
        approach += float(hertz_contact(curvature_x=along, curvature_y=across, load=1.0, modulus=modulus).approach)

    def loads(shift: float) -> np.ndarray:
        return np.maximum((shift * np.cos(azimuth) - 10e-6) / approach, 0.0) ** 1.5

    shift = brentq(lambda shift: loads(shift) @ np.cos(azimuth) - 1500.0, 10e-6, 1e-3)
    np.testing.assert_allclose(result.ball_load, loads(shift).max(), rtol=0.05)  # thrust adds 4 %
    light = replace(scene, operation=replace(scene.operation, axial_load=np.full(3, 1.0)))
    alone = friction_torque(replace(light, effects={"finite_geometry": "off"}))
    np.testing.assert_allclose(alone.ball_load, loads(shift).max(), rtol=2e-3)  # 1 N tilts by sqrt(1/1500)
    np.testing.assert_allclose(result.inner.load, result.outer.load, rtol=5e-4)  # of that ball: 0.28 N at 1500 rpm
    decisions = {effect.name: effect.decision for effect in result.effects}
    assert (decisions["load_distribution"], decisions["centrifugal"], decisions["seals"]) == ("on", "on", "on")
    np.testing.assert_allclose(result.torque.total - result.torque.race, 5e-3, rtol=1e-9)
    band = scene_band(scene)
    assert np.all((result.torque.race > band.low / 2) & (result.torque.race < band.high))  # the order of magnitude


def test_the_high_speed_scene() -> None:
    """Centrifugal force F_c = m (d_m/2) (w R_i/d_m)^2 by hand, with R_i = 19.505 - 3.97 cos(0.2909) = 15.702 mm at the
    contact angle 0.2909 rad: 1.767, 7.070, 15.907 N. The outer race carries more than the inner race by its component
    along the mean of both normals.
    """
    scene = load_scene(SCENES / "6205_high_speed.toml")
    result = friction_torque(scene)
    decisions = {effect.name: effect.decision for effect in result.effects}
    assert (decisions["load_distribution"], decisions["centrifugal"], decisions["gyroscopic"]) == ("off", "on", "on")
    more = np.array([1.767, 7.070, 15.907]) * np.cos(result.contact_angle)
    np.testing.assert_allclose(result.outer.load - result.inner.load, more, rtol=2e-3)  # the angle differs by 0.0015
    axial = 9 * result.inner.load * np.sin(result.contact_angle)
    # Less than 400 N: by the mean angle for half of F_c, and by the friction that carries the gyroscopic moment.
    np.testing.assert_allclose(axial, 400.0, rtol=0.08)
    assert np.all(np.diff(result.torque.total) > 0)
    assert not any("gyroscopic moment" in warning for warning in result.warnings)
    band = scene_band(scene)
    assert np.all((result.torque.race > band.low / 2) & (result.torque.race < band.high))
