"""Losses that the scene declares: added, listed, estimated without their input, and no part of the races' torque."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.effects.warnings import too_fast
from analytic.errors import InputError
from analytic.oil.losses import stirred_oil
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Losses, Operation, Scene, ShearedPockets
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present


@pytest.fixture(scope="module")
def scene() -> Scene:
    """At 500 and 900 N."""
    series = Operation(axial_load=np.array([500.0, 900.0]), inner_speed=np.array([31.0, 47.0]))
    return replace(load_scene("6205-dry"), operation=series)


def test_declared_losses_are_added_and_listed(scene: Scene) -> None:
    plain = friction_torque(scene)
    assert plain.torque.declared is None
    both = friction_torque(replace(scene, losses=Losses(seals=5e-3, drag=2e-3)))
    np.testing.assert_allclose(present(both.torque.declared), 7e-3, rtol=1e-15)
    np.testing.assert_allclose(both.torque.total - plain.torque.total, 7e-3, rtol=1e-13)  # round-off
    np.testing.assert_array_equal(both.torque.race, plain.torque.race)
    # what is not known of the race is less of the total
    np.testing.assert_allclose(
        both.numerical_uncertainty * both.torque.total, plain.numerical_uncertainty * plain.torque.total, rtol=1e-13
    )
    told = {effect.name: effect for effect in both.effects}
    assert (told["seals"].decision, told["seals"].reason) == ("on", "declared by the scene")
    assert told["drag"].share == pytest.approx(2e-3 / both.torque.total[0], rel=1e-13)  # least torque at the light load
    assert told["spin"].share == np.max(present(both.torque.spin) / both.torque.total)
    one = friction_torque(replace(scene, losses=Losses(drag=0.0)))
    told = {effect.name: effect for effect in one.effects}
    assert (told["seals"].decision, told["seals"].share, told["seals"].reason) == ("off", None, "not declared")
    assert (told["drag"].decision, told["drag"].share) == ("on", 0.0)
    np.testing.assert_array_equal(present(one.torque.declared), 0.0)


def test_a_negative_loss_is_refused(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"losses\.drag must be at least 0"):
        friction_torque(replace(scene, losses=Losses(drag=-1e-3)))


OILED = """
name = "oiled"
tolerance = "5 %"
[bearing]
catalog = "7206 B"
contact_angle = { nominal = "40 deg" }
[operation]
axial_load = ["320 N", "510 N"]
inner_speed = ["7000 rpm", "9000 rpm"]
[lubricant]
name = "ISO VG 32"
temperature = "63 degC"
supply = "oil_jet"
[friction]
coefficient = 0.06
spin_rule = "balanced"
[losses]
drag = "1.3 N mm"
"""
FLOW = 'oil_flow = "0.4 l/min"\n'
LAND = 'land = { ring = "outer", diameter = "51 mm", clearance = "0.3 mm", width = "4 mm" }\n'
OIL_EFFECTS = ("through_flow", "cage_shear", "ball_drag")


def test_losses_of_the_oil_are_a_part_of_their_own() -> None:
    bare = friction_torque(parse_scene(OILED, origin="here"))
    scene = parse_scene(OILED + FLOW + LAND, origin="here")
    found, stirred = friction_torque(scene), present(stirred_oil(scene, scene.losses))
    assert bare.torque.oil is None
    oil, speed, viscosity = present(found.torque.oil), found.inner_speed, inlet_viscosity(present(scene.lubricant))
    parts = {
        "through_flow": stirred.through_flow(speed),
        "cage_shear": stirred.cage_shear(speed, viscosity.viscosity),
    }
    np.testing.assert_allclose(oil, sum(parts.values()), rtol=1e-14)
    np.testing.assert_allclose(found.torque.total, bare.torque.total + oil, rtol=1e-14)
    np.testing.assert_array_equal(found.torque.race, bare.torque.race)
    shares = {each.name: each for each in found.shares}
    for name, part in parts.items():
        assert (shares[name].decision, shares[name].share_is) == ("on", "part")
        assert shares[name].share == pytest.approx(np.max(part / found.torque.total), rel=1e-13)
    assert shares["ball_drag"].decision == "off"
    assert shares["ball_drag"].share is None  # losses.drag has it


def test_what_lacks_its_input_has_an_estimate_that_counts_where_it_exceeds_the_tolerance() -> None:
    scene = replace(parse_scene(OILED, origin="here"), losses=Losses())
    found = friction_torque(scene)
    shares = {each.name: each for each in found.shares}
    assert [shares[name].decision for name in OIL_EFFECTS] == ["off"] * 3
    assert [shares[name].share_is for name in OIL_EFFECTS] == ["bound"] * 3
    usual = replace(scene, losses=Losses(oil_share=0.02))  # as docs/effects.md has it
    drag = present(friction_torque(usual).torque.oil)
    assert shares["ball_drag"].share == pytest.approx(np.max(drag / found.torque.total), rel=1e-13)
    # the jet's oil: its heat by 20 K is the whole power, with that of its acceleration at the inner race
    race = 2 * present(stirred_oil(usual, usual.losses)).ball_rate * found.inner_speed.max()
    flow = found.torque.total[1] * found.inner_speed[1] / (2000 * 20 - race**2)  # kg/s
    accelerated = flow * race**2 / found.inner_speed[1] / found.torque.total[1]
    assert shares["through_flow"].share == pytest.approx(accelerated, rel=1e-12)
    warned = [words for words in found.warnings if "ball_drag is neglected" in words]
    assert bool(warned) == (present(shares["ball_drag"].share) > scene.tolerance)
    for supply in ("oil_spot", "grease"):
        oil = replace(present(scene.lubricant), supply=supply)
        shares = {each.name: each for each in friction_torque(replace(scene, lubricant=oil)).shares}
        assert [shares[name].share for name in OIL_EFFECTS] == [None] * 3


def test_a_loss_of_the_oil_without_its_input_can_be_off() -> None:
    scene = replace(parse_scene(OILED + '[effects]\nball_drag = "off"\n', origin="here"), losses=Losses())
    found, auto = friction_torque(scene), friction_torque(replace(scene, effects={}))
    off, estimated = ({each.name: each for each in each.shares}["ball_drag"] for each in (found, auto))
    assert (off.decision, off.share) == (estimated.decision, estimated.share) == ("off", present(off.share))
    assert off.reason.startswith("off in the scene")
    assert estimated.reason.startswith("losses.oil_share is not given: give")
    np.testing.assert_array_equal(found.torque.total, auto.torque.total)
    with pytest.raises(InputError, match='ball_drag = "off" contradicts its input'):
        friction_torque(replace(scene, losses=Losses(oil_share=0.03)))
    with pytest.raises(InputError, match=r'ball_drag = "on" is refused: losses\.oil_share is not given'):
        friction_torque(replace(scene, effects={"ball_drag": "on"}))


def test_a_speed_beyond_usual_practice_is_said() -> None:
    """n d_m of a 7206 B, 46 mm: 3.7e5 mm/min at 8000 rpm and 2.3e6 at 50 000 rpm."""
    for speed, supply, is_said in (
        ("8000 rpm", "oil_bath", False),
        ("8000 rpm", "grease", False),
        ("14000 rpm", "oil_bath", False),
        ("14000 rpm", "grease", True),
        ("50000 rpm", "oil_bath", True),
        ("50000 rpm", "oil_jet", True),
    ):
        text = OILED.replace('["7000 rpm", "9000 rpm"]', f'"{speed}"').replace('["320 N", "510 N"]', '"400 N"')
        scene = parse_scene(text.replace("oil_jet", supply), origin="here")
        said = too_fast(scene)
        assert (said is not None) == is_said, (speed, supply)
        if is_said:
            assert said in friction_torque(scene).warnings
    hybrid = replace(scene.bearing, ball_material=replace(scene.bearing.ball_material, density=3200.0))
    assert too_fast(replace(scene, bearing=hybrid)) is None  # 3e6 mm/min with an oil jet


def test_pockets_that_are_not_given_are_estimated_by_usual_ones() -> None:
    """0.025 ball diameters of clearance and 0.11 of thickness, those of the cage of [Paper]."""
    scene = replace(parse_scene(OILED, origin="here"), losses=Losses(), cage=None)  # it excludes losses.pockets
    found = friction_torque(scene)
    ball = scene.bearing.ball_diameter
    pockets = ShearedPockets(clearance=0.025 * ball, thickness=0.11 * ball)
    sheared = present(stirred_oil(scene, Losses(pockets=pockets))).cage_shear(
        found.inner_speed, inlet_viscosity(present(scene.lubricant)).viscosity
    )
    share = next(each.share for each in found.shares if each.name == "cage_shear")
    assert share == pytest.approx(np.max(sheared / found.torque.total), rel=1e-12)
