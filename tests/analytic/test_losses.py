"""Losses of the oil that the scene declares: the same by every way to a torque, and their range."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.function import torque_function
from analytic.oil.variation import NOMINAL
from analytic.prediction.formulas import with_model_uncertainty
from analytic.prediction.settled import level_of, settled_parts
from analytic.prediction.spreads import uncertain_inputs
from analytic.scene import Arrangement
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

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


def test_every_way_to_a_torque_has_the_losses_of_the_oil() -> None:
    """The function of the torque, the kernel of the interval, and a pair."""
    scene = parse_scene(OILED + FLOW + LAND, origin="here")
    found, function = friction_torque(scene), torque_function(scene)
    loads = {"axial_load": scene.operation.axial_load, "inner_speed": scene.operation.inner_speed}
    np.testing.assert_allclose(function.series(**loads), found.torque.total, rtol=1e-9)  # rounding of another order
    one = {name: float(values[1]) for name, values in loads.items()}
    np.testing.assert_allclose(function(**one), found.torque.total[1], rtol=1e-9)
    oil = present(scene.lubricant)
    warm = replace(scene, lubricant=replace(oil, temperature=oil.temperature + 21.0))
    np.testing.assert_allclose(
        function(**one, temperature=oil.temperature + 21.0), friction_torque(warm).torque.total[1], rtol=1e-9
    )
    parts = present(settled_parts(scene, NOMINAL, level_of(scene)))
    np.testing.assert_allclose(parts.total, found.torque.total, rtol=1e-9)
    np.testing.assert_allclose(present(parts.oil), present(found.torque.oil), rtol=1e-14)
    pair = replace(scene, arrangement=Arrangement(kind="tandem", distance=0.02))
    halved = replace(scene, operation=replace(scene.operation, axial_load=scene.operation.axial_load / 2))
    np.testing.assert_allclose(
        friction_torque(pair).torque.total, 2 * friction_torque(halved).torque.total, rtol=1e-6
    )  # of the balance of the pair
    np.testing.assert_allclose(present(friction_torque(pair).torque.oil), 2 * present(found.torque.oil), rtol=1e-14)


def test_the_range_of_the_through_flow_is_in_the_uncertainty_of_the_model() -> None:
    """From the speed of the cage to that of the inner race: half and twice of the torque."""
    scene = parse_scene(OILED + FLOW, origin="here")
    found = with_model_uncertainty(scene, friction_torque(scene))
    oil, total = present(found.torque.oil), found.torque.total
    np.testing.assert_allclose(present(found.model_parts)["oil_losses"], oil / total, rtol=1e-12)
    names = {each.key: each for each in uncertain_inputs(scene)}
    assert {"losses.oil_flow", "model.oil_losses"} <= set(names)
    assert names["model.oil_losses"].deviation == pytest.approx(np.log(2) / 3**0.5, rel=1e-14)
