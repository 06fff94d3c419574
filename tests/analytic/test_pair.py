"""The torque of a pair: sums over both bearings, each under the loads that it takes."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.errors import InputError
from analytic.pair import pair_in_series
from analytic.result import FrictionTorque, PairPart
from analytic.scene import Arrangement, Losses, Operation, Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

TEXT = """\
name = "pair"
tolerance = "5 %"
[bearing]
ball_count = 13
ball_diameter = "7.938 mm"
pitch_diameter = "39.1 mm"
conformity = 0.52
width = "15 mm"
inner = { shoulder_half_width = "3.9 mm" }
outer = { shoulder_half_width = "3.9 mm" }
contact_angle = { nominal = "25 deg" }
[operation]
axial_load = "90 N"
inner_speed = "700 rpm"
[friction]
coefficient = 0.083
hysteresis_loss = 0.006
[effects]
weight = "off"
creep = "off"
"""


@pytest.fixture(scope="module")
def scene() -> Scene:
    return parse_scene(TEXT, origin="here")


def paired(scene: Scene, axial: Any, *, speed: Any = 70.0, radial: float = 0.0, **given: Any) -> Scene:
    known: dict[str, Any] = {"kind": "O"}
    thrust = np.array(axial, ndmin=1)
    operation = Operation(axial_load=thrust, inner_speed=np.array(speed), radial_load=radial).as_series()
    return replace(scene, operation=operation, arrangement=Arrangement(**(known | given)))


def alone(scene: Scene, axial: Any, *, speed: float = 70.0) -> FrictionTorque:
    operation = Operation(axial_load=np.array(axial, ndmin=1), inner_speed=np.array(speed)).as_series()
    return friction_torque(replace(scene, arrangement=None, operation=operation))


def pair_of(found: FrictionTorque) -> PairPart:
    assert found.pair is not None
    return found.pair


def test_a_pair_without_load_has_twice_the_torque_of_one_under_the_preload(scene: Scene) -> None:
    slow = 0.5  # rad/s: without centrifugal force
    found = friction_torque(paired(scene, 0.0, speed=slow, preload=240.0))
    one = alone(scene, 240.0, speed=slow)
    np.testing.assert_allclose(found.torque.total, 2 * one.torque.total, rtol=1e-4)  # the preload is met to 1e-4
    for name in ("spin", "conformity", "hysteresis"):
        part, single = (present(getattr(each.torque, name)) for each in (found, one))
        np.testing.assert_allclose(part, 2 * single, rtol=2e-4)
    np.testing.assert_allclose(pair_of(found).total[0], pair_of(found).total[1], rtol=1e-9)
    np.testing.assert_allclose(found.ball_load, one.ball_load, rtol=1e-4)


def test_tandem_is_twice_one_under_half_the_load(scene: Scene) -> None:
    found = friction_torque(paired(scene, [120.0, 700.0], kind="tandem"))
    np.testing.assert_allclose(found.torque.total, 2 * alone(scene, [60.0, 350.0]).torque.total, rtol=1e-6)


def test_parts_are_sums_over_both_bearings(scene: Scene) -> None:
    found = friction_torque(paired(scene, [0.0, 300.0], radial=110.0, preload=150.0))
    pair = pair_of(found)
    first, second = (present(each) for each in pair.bearings)
    for name in ("total", "race", "spin", "hysteresis"):
        both = present(getattr(first.torque, name)) + present(getattr(second.torque, name))
        np.testing.assert_allclose(present(getattr(found.torque, name)), both, rtol=1e-14)
    np.testing.assert_array_equal(pair.total, [first.torque.total, second.torque.total])
    np.testing.assert_array_equal(first.axial_load, pair.equilibrium.axial_load[0])
    np.testing.assert_array_equal(found.axial_load, [0.0, 300.0])
    np.testing.assert_array_equal(found.radial_load, 110.0)
    # what belongs to one ball is that of the heaviest: with an axial load, of the first bearing
    assert found.ball_load[1] == max(first.ball_load[1], second.ball_load[1]) == first.ball_load[1]
    np.testing.assert_array_equal(found.inner.load[1], first.inner.load[1])
    errors = [each.numerical_uncertainty * each.torque.total for each in (first, second)]
    np.testing.assert_allclose(found.numerical_uncertainty * found.torque.total, sum(errors), rtol=1e-12)


def test_a_relieved_bearing_at_rest_is_named_and_left_out(scene: Scene) -> None:
    losses = Losses(seals=3e-3)
    found = friction_torque(replace(paired(scene, [20.0, 2000.0], preload=80.0, speed=0.0), losses=losses))
    pair = pair_of(found)
    assert pair.equilibrium.is_pressed.tolist() == [[True, True], [True, False]]
    assert present(pair.bearings[1]).inner_speed.size == 1
    assert [points.tolist() for points in pair.points] == [[0, 1], [0]]
    assert pair.total[1, 1] == 3e-3  # its seals rub on
    np.testing.assert_allclose(present(found.torque.declared), 6e-3, rtol=1e-15)
    np.testing.assert_allclose(found.torque.total, pair.total.sum(axis=0), rtol=1e-15)
    one = alone(replace(scene, losses=losses), 2000.0, speed=0.0)
    np.testing.assert_allclose(found.torque.total[1], one.torque.total[0] + 3e-3, rtol=1e-6)
    assert any("the loads relieve the second bearing of the pair at 1 of 2" in each for each in found.warnings)
    loaded = friction_torque(paired(scene, 20.0, preload=80.0, speed=0.0))
    assert not any("relieve" in each for each in loaded.warnings)


def test_a_bearing_that_is_pressed_the_other_way_is_its_mirror_image() -> None:
    """Tight bearings take thrust both ways: much thrust turns the second one round."""
    tight = parse_scene(TEXT.replace('contact_angle = { nominal = "25 deg" }', 'clearance = "-8 um"'), origin="here")
    tight = replace(tight, effects={"load_distribution": "on"})  # of which little comes to the torque
    found = friction_torque(paired(tight, 1500.0, radial=60.0, preload=40.0))
    loads, second = pair_of(found).equilibrium, present(pair_of(found).bearings[1])
    assert loads.axial_load[1, 0] < -100
    np.testing.assert_array_equal(second.axial_load, -loads.axial_load[1])
    np.testing.assert_array_equal(second.moment, -loads.moment[1])
    np.testing.assert_allclose(second.ball_load, loads.ball_load[1], rtol=1e-2)  # its contacts are corrected anew


def test_a_cage_counts_twice() -> None:
    cage = '[cage]\npocket_clearance = "0.2 mm"\nwall_thickness = "0.9 mm"\nmass = "6 g"\nmaterial = "peek"\n'
    found = friction_torque(paired(parse_scene(TEXT + cage, origin="here"), [50.0, 300.0], preload=150.0))
    apart = [present(each) for each in pair_of(found).bearings]
    np.testing.assert_allclose(present(found.torque.cage), sum(present(each.torque.cage) for each in apart), rtol=1e-14)
    assert present(found.cage).torque.shape == (2,)
    assert len(present(found.cage).motion) == len(found.rows) == 2


def test_factors_of_each_point_are_refused(scene: Scene) -> None:
    given, many = paired(scene, [20.0, 50.0], preload=80.0), ContactFactors(approach=np.array([1.01, 1.02]))
    with pytest.raises(InputError, match="which a pair of bearings does not take"):
        friction_torque(given, correction=ContactCorrection(inner=many))
    softer = ContactCorrection(inner=ContactFactors(approach=1.1), outer=ContactFactors(approach=1.1))
    changed = friction_torque(given, correction=softer).torque.total / friction_torque(given).torque.total
    assert np.all(np.abs(changed - 1) > 1e-4)


def test_a_pair_whose_inner_rings_press_on_no_ball_is_refused(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"neither inner ring .* raise the preload"):
        friction_torque(paired(scene, 1e-3, speed=900.0, kind="tandem"))


def test_a_tandem_on_one_ball_of_each_row_has_an_axial_stiffness(scene: Scene) -> None:
    """Nothing holds its shaft across the radial load; more balls, of which none is loaded, hold it no better."""

    def stiffness(balls: int) -> float:
        bearing = replace(scene.bearing, ball_count=balls)
        pair = paired(replace(scene, bearing=bearing), 7.0, speed=0.001, radial=30.0, kind="tandem")
        assert pair.arrangement is not None
        return float(pair_in_series(pair, pair.arrangement, None).equilibrium.stiffness[0])

    np.testing.assert_allclose(stiffness(5), stiffness(13), rtol=1e-6)  # of the stiffness across, 1e-14 of the largest
