"""Loads that leave balls nearly free, none at all along the axis, preload: what is left out must still be little."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.effects.table import COMPUTED
from analytic.errors import InputError
from analytic.scene import Decision, Operation, Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque

OILED = """
name = "light"
tolerance = "1 %"
[bearing]
catalog = "paper_6205"
contact_angle = { rule = "solved" }
[operation]
inner_speed = "10 rpm"
LOADS
[lubricant]
viscosity = "0.06 Pa s"
pressure_viscosity = "2e-8 1/Pa"
eyring_stress = "5 MPa"
[surface]
rms_roughness = "0.1 um"
autocorrelation = { kind = "gaussian", length = "60 um", spacing = "2 um" }
hardness = "7.8 GPa"
[friction]
hysteresis_loss = 0.007
"""


def under(loads: str) -> Scene:
    return parse_scene(OILED.replace("LOADS", loads), origin="scene")


def assert_within_the_uncertainty(scene: Scene) -> None:
    """Whatever auto left out, and wherever the balls' weight points."""
    found = friction_torque(scene)
    for down in ((1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.6, -0.8)):
        full = friction_torque(replace(scene, effects=dict.fromkeys(COMPUTED, "on"), tolerance=3e-3, down=down))
        error = abs(found.torque.total / full.torque.total - 1)
        assert np.all(error <= found.numerical_uncertainty + full.numerical_uncertainty), down


@pytest.mark.parametrize(
    ("loads", "clearance"),
    [
        ('axial_load = "0.3 N"\nmoment = "1.46 N mm"', 20e-6),  # balls go free from a load distribution of 0.25 on
        pytest.param('axial_load = "0.05 N"\nradial_load = "20 N"', 20e-6, marks=pytest.mark.nightly),
        ('axial_load = "1 N"', -2e-6),  # a stiffer contact closes a preload's angle
        ('axial_load = "0 N"\nradial_load = "90 N"', 12e-6),
    ],
)
def test_what_auto_leaves_out_is_within_the_uncertainty(loads: str, clearance: float) -> None:
    scene = under(loads)
    wider = (clearance - scene.bearing.diametral_clearance) / 2
    outer = replace(scene.bearing.outer, bottom_radius=scene.bearing.outer.bottom_radius + wider)
    assert_within_the_uncertainty(replace(scene, bearing=replace(scene.bearing, outer=outer)))


def test_balls_that_a_slight_radial_load_lifts_roll_by_their_own_force() -> None:
    """A radial load of 0.16 of the thrust unloads four of nine balls of a steep contact angle."""
    scene = under('axial_load = "10 N"\nradial_load = "1.6 N"\ntilt = "free"')
    tall = {race: replace(getattr(scene.bearing, race), shoulder_half_width=3.9e-3) for race in ("inner", "outer")}
    scene = replace(
        scene,
        bearing=replace(scene.bearing, **tall),
        contact_angle=replace(scene.contact_angle, free=0.7),
        operation=replace(scene.operation, inner_speed=np.array([120 * np.pi / 30])),
    )
    assert_within_the_uncertainty(scene)
    found = friction_torque(scene)
    loose = friction_torque(replace(scene, tolerance=0.5))
    assert all(each.is_on(name) for each in (found, loose) for name in ("load_distribution", "centrifugal"))
    alone: dict[str, Decision] = {"unloaded_balls": "off"}  # which roll too
    stiff = friction_torque(replace(scene, effects=alone | {"centrifugal": "off", "gyroscopic": "off"}))
    lifted = friction_torque(replace(scene, effects=alone))
    assert np.all(stiff.torque.total < 0.9 * lifted.torque.total)  # what was once left out


def test_thrust_fades_beside_a_radial_load() -> None:
    none = friction_torque(under('axial_load = "0 N"\nradial_load = "1000 N"')).torque.total
    tiny = friction_torque(under('axial_load = "1e-9 N"\nradial_load = "1000 N"')).torque.total
    np.testing.assert_allclose(tiny, none, rtol=1e-6)  # tilts by the root of 1e-12 at most


def test_balls_without_load_cross_standstill() -> None:
    """Under a radial load alone half of the balls carry nothing, and their own force falls below every round-off."""
    scene = load_scene("validation/scenes/6205_physical.toml")
    speeds = np.array([0.0, 1e-12, 1e-9, 1e-8, 1e-7])
    aside = Operation(axial_load=np.zeros(5), inner_speed=speeds, radial_load=np.full(5, 1000.0))
    for decision in ("auto", "on"):
        found = friction_torque(replace(scene, operation=aside, effects={"centrifugal": decision})).torque.total
        np.testing.assert_allclose(found, found[0], rtol=0.01)  # of the rolling that speed adds


def test_no_load_at_all_is_refused() -> None:
    with pytest.raises(InputError, match=r"operation\.axial_load = '0 N' leaves a point without any load"):
        under('axial_load = "0 N"')


def test_a_film_is_never_negative_and_one_thinner_than_a_molecule_is_boundary_friction() -> None:
    """The creeping film is 0.02 nm or so, whatever the finish: no warning has to tell that no formula holds there."""
    scene = replace(under('axial_load = "900 N"'), effects={"asperities": "on"})
    still, creeping = (
        friction_torque(replace(scene, operation=replace(scene.operation, inner_speed=np.array([speed]))))
        for speed in (0.0, 1e-4)
    )
    for race in ("inner", "outer"):
        assert 0 <= getattr(still.film, race) < getattr(creeping.film, race) < 0.1e-9
        assert getattr(still.boundary_share, race) == 1
        assert 0.9 < getattr(creeping.boundary_share, race) < 1
    assert creeping.warnings == still.warnings == friction_torque(scene).warnings


def test_the_printed_equations_have_no_known_uncertainty() -> None:
    scene = replace(under('axial_load = "900 N"'), microslip="as_printed", effects={"spin": "off"})
    found = friction_torque(scene)
    assert np.all(np.isposinf(found.numerical_uncertainty))
    assert found.row(0).uncertainty.numerical is None


def test_the_method_of_sliding_is_judged_by_what_counts() -> None:
    """Without conformity the spin alone has to be right, and is."""
    scene = replace(under('axial_load = "1000 N"'), effects={"conformity": "off"})
    for tolerance in (0.03, 0.01, 0.003):
        found = friction_torque(replace(scene, tolerance=tolerance))
        assert np.all(found.numerical_uncertainty <= tolerance)


@pytest.mark.parametrize(
    ("axial", "free", "told"),
    [
        (
            0.03,
            0.63,
            r"0\.03 N: the weight of a ball, 0\.0199 N, moves its contact to 65\.\d* deg .* outer race's shoulder",
        ),
        (
            0.003,
            0.8,
            r"the weight of a ball, 0\.02 N, drives it 91\.\d* deg .* past 90 deg, under 0\.003 N: raise the load",
        ),
    ],
)
def test_a_ball_that_its_weight_moves_too_far_is_told_by_its_weight(axial: float, free: float, told: str) -> None:
    """At 10 rpm the weight is a thousand times the centrifugal force, which the words blamed once."""
    scene = replace(
        under(f'axial_load = "{axial} N"\ntilt = "free"'), down=(0.561, -0.824, 0.073), spin_rule="balanced"
    )
    with pytest.raises(InputError, match=told):
        friction_torque(replace(scene, contact_angle=replace(scene.contact_angle, free=free)))
