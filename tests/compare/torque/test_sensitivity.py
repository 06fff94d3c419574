"""Changes that follow from known powers and proportions; ends that are refused; what a scene does not have."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.compare.torque import sensitivity
from fembearing.compare.torque.sensitivity import Input, Sensitivity, sensitivity_of, variations, with_clearance
from fembearing.plain_types import plain
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed, scene
from tests.analytic.specimens import present

LOSSES = '[friction]\nhysteresis_loss = 0.006\n[losses]\nseals = "3 N mm"\n'


def changes(found: Sensitivity, name: str) -> np.ndarray:
    """(2, outputs): at the low end and the high one."""
    each = the(found, name)
    return np.array([each.change_low, each.change_high])


def the(found: Sensitivity, name: str) -> Input:
    (one,) = (each for each in found.inputs if each.name == name)
    return one


@pytest.fixture(scope="module")
def dry() -> Scene:
    """Without friction, its contact angle given: the balls' load is the thrust's share, whatever the contacts do."""
    scene = load_scene("6205-dry")
    return replace(
        scene, friction_coefficient=None, hysteresis_loss=None, contact_angle=ContactAngle(rule="given", value=0.31)
    )


@pytest.fixture(scope="module")
def pressures(dry: Scene) -> Sensitivity:
    return sensitivity_of(dry)


@pytest.fixture(scope="module")
def oiled() -> Scene:
    return scene(changed(SPEEDS, '["300 rpm", "100 rpm", "900 rpm"]', OILED) + LOSSES)


@pytest.fixture(scope="module")
def torques(oiled: Scene) -> Sensitivity:
    return sensitivity_of(oiled)


def test_peak_pressures_follow_hertz(pressures: Sensitivity) -> None:
    """p0 as Q^(1/3) and E*^(2/3); Q as 1/sin(al)."""
    assert [(output.quantity, output.pair) for output in pressures.outputs] == [
        ("peak_pressure", "inner"),
        ("peak_pressure", "outer"),
    ]
    ends = np.array([[0.9], [1.1]])
    np.testing.assert_allclose(changes(pressures, "axial load"), np.tile(ends ** (1 / 3) - 1, 2), rtol=1e-9)
    stiffer = np.array([[0.95], [1.05]]) ** (2 / 3) - 1
    np.testing.assert_allclose(changes(pressures, "Young's modulus"), np.tile(stiffer, 2), rtol=1e-9)
    lateral = ((1 - 0.3**2) / (1 - np.array([[0.285], [0.315]]) ** 2)) ** (2 / 3) - 1
    np.testing.assert_allclose(changes(pressures, "Poisson's ratio"), np.tile(lateral, 2), rtol=1e-9)
    # The angle also bends the race along rolling, by some hundredth of the change of its cosine.
    steeper = (np.sin(0.31) / np.sin(0.31 * ends)) ** (1 / 3) - 1
    np.testing.assert_allclose(changes(pressures, "contact angle"), np.tile(steeper, 2), rtol=0.1)


def test_balls_of_another_material_change_their_poisson_ratio_as_much_as_the_rings(dry: Scene) -> None:
    """1/E* is the sum of (1 - nu^2)/E of both bodies; p0 goes as E*^(2/3)."""
    ceramic = replace(dry.bearing.ball_material, youngs_modulus=310e9, poisson_ratio=0.26)
    ring = dry.bearing.inner.material
    found = sensitivity_of(replace(dry, bearing=replace(dry.bearing, ball_material=ceramic)))
    more = np.array([[-0.015], [0.0], [0.015]])
    low, same, high = (1 - (0.26 + more) ** 2) / 310e9 + (1 - (ring.poisson_ratio + more) ** 2) / ring.youngs_modulus
    expected = (same / np.array([low, high])) ** (2 / 3) - 1
    np.testing.assert_allclose(changes(found, "Poisson's ratio"), np.tile(expected, 2), rtol=1e-9)  # near 1


def test_a_groove_moves_its_own_race_alone(pressures: Sensitivity) -> None:
    for column, race in enumerate(("inner", "outer")):
        found = changes(pressures, f"conformity, {race}")
        np.testing.assert_allclose(found[:, 1 - column], 0, atol=1e-12)  # the angle is given: nothing else moves
        assert found[0, column] < -0.02 < 0.02 < found[1, column]  # an opener groove presses harder
        np.testing.assert_allclose(the(pressures, f"conformity, {race}").high, 0.005 + (4.13, 4.21)[column] / 7.94)


def test_without_friction_nothing_of_it_is_asked(pressures: Sensitivity) -> None:
    assert {each.name for each in pressures.inputs} == {
        *("axial load", "Young's modulus", "Poisson's ratio", "contact angle"),
        *("conformity, inner", "conformity, outer"),
    }


def test_parts_that_are_proportional_change_by_their_share(oiled: Scene, torques: Sensitivity) -> None:
    assert [round(output.inner_speed * 30 / np.pi) for output in torques.outputs if output.inner_speed] == [100, 900]
    ends = Operation(axial_load=np.full(2, 700.0), inner_speed=np.array([100.0, 900.0]) * np.pi / 30)
    parts = friction_torque(replace(oiled, operation=ends)).torque
    assert parts.hysteresis is not None
    np.testing.assert_allclose([output.value for output in torques.outputs], parts.total, rtol=1e-9)
    assert oiled.hysteresis_loss is not None
    ends_of_loss = np.array([0.003, 0.025]) / oiled.hysteresis_loss - 1  # docs/measured.md: what is in use
    share = ends_of_loss[:, None] * parts.hysteresis / parts.total
    np.testing.assert_allclose(changes(torques, "hysteresis loss"), share, rtol=1e-9)
    seals = np.array([-0.2, 0.2])[:, None] * 3e-3 / parts.total
    np.testing.assert_allclose(changes(torques, "declared seals"), seals, rtol=1e-9)


def test_every_input_is_moved_alone_to_both_ends_of_its_range(oiled: Scene) -> None:
    for variation in variations(oiled):
        assert variation.low < variation.value < variation.high
        assert variation.source
        for value in (variation.low, variation.high):
            moved = variation.scene_at(value)
            differing = {name for name, part in vars(oiled).items() if getattr(moved, name) != part}
            assert len(differing) == 1, variation.name


def test_a_longer_correlation_is_sampled_as_densely(oiled: Scene) -> None:
    """Else the curvature of the summits would change with the spacing and not with the surface."""
    (longer,) = (each for each in variations(oiled) if "correlation" in each.name)
    given, moved = (present(present(each.surface).autocorrelation) for each in (oiled, longer.scene_at(longer.high)))
    assert moved.length == longer.high
    assert moved.spacing / moved.length == pytest.approx(given.spacing / given.length, rel=1e-12)  # round-off


def test_inputs_stand_in_the_order_of_their_swing(torques: Sensitivity) -> None:
    swings = [np.abs(changes(torques, each.name)).max() for each in torques.inputs]
    assert swings == sorted(swings, reverse=True)
    assert the(torques, "viscosity").low == pytest.approx(0.054, rel=1e-12)
    assert changes(torques, "viscosity")[1, 1] > 0 > changes(torques, "viscosity")[0, 1]  # fast: the oil resists
    assert changes(torques, "oil temperature")[0, 1] > 0 > changes(torques, "oil temperature")[1, 1]


def test_a_given_coefficient_makes_all_speeds_one(dry: Scene) -> None:
    scene = replace(dry, friction_coefficient=0.08, cage=None, spin_rule="balanced")
    found = sensitivity_of(scene)
    assert len(found.outputs) == 1
    # All that slides does so with this coefficient, and the share of spin between the races stays. (Creep would take
    # more of the slip from a higher friction.)
    np.testing.assert_allclose(changes(found, "friction coefficient"), [[-0.2], [0.2]], rtol=1e-4)


def test_a_cage_that_its_balls_squeeze_stays_at_rest(dry: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """With balls that move freely each input would take as long as the torque's own motion of the cage."""
    effects = []

    def noted(scene: Scene):
        effects.append(friction_torque(scene).effects)
        return friction_torque(scene)

    monkeypatch.setattr(sensitivity, "friction_torque", noted)
    assert dry.cage is not None
    ball = dry.bearing.ball_diameter
    pocket = {"pocket_diameter": 1.003 * ball, "pocket_depth": 0.5015 * ball}
    tight = replace(dry.cage, **pocket, start="rest", duration=0.004, seeds=2)
    loads = Operation(axial_load=np.array([90.0]), radial_load=np.array([600.0]), inner_speed=np.array([210.0]))
    own = replace(
        dry, contact_angle=ContactAngle(rule="solved"), friction_coefficient=0.08, cage=tight, operation=loads
    )
    monkeypatch.setattr(sensitivity, "variations", lambda _: iter(()))
    decided = {each.name: each.decision for each in friction_torque(own).effects}
    assert decided["ball_dynamics"] == "on"
    sensitivity_of(own)
    for found in effects:
        assert {each.decision for each in found if each.name in ("cage_dynamics", "ball_dynamics")} == {"off"}


def test_equal_speeds_are_told_apart_by_their_loads(dry: Scene) -> None:
    loads = Operation(axial_load=np.array([700.0, 200.0, 1300.0]), inner_speed=np.full(3, 30.0))
    outputs = sensitivity_of(replace(dry, friction_coefficient=0.08, cage=None, operation=loads)).outputs
    assert [output.axial_load for output in outputs] == [200.0, 1300.0]


def test_an_end_that_is_refused_is_left_open_and_told(dry: Scene) -> None:
    tight = replace(dry.bearing.inner, groove_radius=0.503 * dry.bearing.ball_diameter)
    found = sensitivity_of(replace(dry, bearing=replace(dry.bearing, inner=tight)))
    conformity = the(found, "conformity, inner")
    assert conformity.change_low is None
    assert conformity.change_high is not None
    assert "must exceed the ball radius" in conformity.refused[0]
    told = plain(found)
    (entry,) = (each for each in told["inputs"] if each["name"] == "conformity, inner")
    assert (entry["change_low"], entry["refused"]) == (None, list(conformity.refused))


def test_clearance_is_moved_by_the_outer_groove(oiled: Scene, torques: Sensitivity) -> None:
    wider = with_clearance(oiled.bearing, 27e-6)
    np.testing.assert_allclose(wider.diametral_clearance, 27e-6, rtol=1e-9)
    assert wider.inner == oiled.bearing.inner
    np.testing.assert_allclose(the(torques, "diametral clearance").low, 15e-6, rtol=1e-9)


def test_loads_move_together() -> None:
    scene = load_scene("6205-dry")
    both = replace(scene, operation=replace(scene.operation, radial_load=300.0))
    (loads,) = (each for each in variations(both) if "load" in each.name)
    assert loads.name == "axial load, with it radial load"
    moved = loads.scene_at(loads.high).operation
    np.testing.assert_allclose(moved.axial_load, 1100, rtol=1e-12)
    np.testing.assert_allclose(moved.radial_load, 330, rtol=1e-12)
