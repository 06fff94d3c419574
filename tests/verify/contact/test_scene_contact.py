"""The contact that is compared is that of the most heavily loaded ball."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import RACES
from analytic.errors import InputError
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.verify.contact.scene_contact import contact_of


@pytest.fixture(scope="module")
def scene() -> Scene:
    """The 6205; the second point is the heavier one."""
    series = Operation(
        axial_load=np.array([300.0, 210.0]),
        inner_speed=np.array([30.0, 55.0]),
        radial_load=np.array([700.0, 1500.0]),
        moment=np.array([0.0, 1.3]),
    )
    return replace(load_scene("6205-dry"), contact_angle=ContactAngle(rule="solved"), operation=series)


def test_under_thrust_it_is_any_ball_at_the_heaviest_point(scene: Scene) -> None:
    loads = Operation(axial_load=np.array([300.0, 900.0]), inner_speed=np.array([30.0, 30.0]))
    thrust = replace(scene, operation=loads, effects=dict.fromkeys(("centrifugal", "gyroscopic"), "off"))
    expected = thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=900.0)
    for pair in ("inner", "outer"):
        contact = contact_of(thrust, pair=pair)
        np.testing.assert_allclose([contact.load, contact.contact_angle], [expected.ball_load, expected.contact_angle])
        assert contact_of(thrust, pair=pair, load=77.0) == replace(contact, load=77.0)


def test_under_a_radial_load_it_is_the_heaviest_of_the_ring(scene: Scene) -> None:
    ring = ring_equilibrium(scene.bearing, scene.contact_angle, axial_load=210.0, radial_load_x=1500.0, moment_y=1.3)
    heaviest = int(np.argmax(ring.inner_load))
    loads, angles = (ring.inner_load, ring.outer_load), (ring.inner_angle, ring.outer_angle)
    for race, load, angle in zip(RACES, loads, angles, strict=True):
        contact = contact_of(scene, pair=race)
        # centrifugal and gyroscopic effects, which this ring has not, are below 1e-3 of this load
        np.testing.assert_allclose(contact.load, load[heaviest], rtol=1e-3)
        np.testing.assert_allclose(contact.contact_angle, abs(angle[heaviest]), rtol=1e-2)
        assert contact.load > 5 * thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=210.0).ball_load


def test_at_speed_each_race_has_its_own_load_and_angle(scene: Scene) -> None:
    """The contact is that of closed kinematics, whatever turns the balls in the torque."""
    fast = replace(scene, operation=Operation(axial_load=np.array([400.0]), inner_speed=np.array([1570.0])))
    fast = replace(fast, spin_rule="balanced")
    torque = friction_torque(replace(fast, effects={"finite_geometry": "off"}))
    inner, outer = contact_of(fast, pair="inner"), contact_of(fast, pair="outer")
    np.testing.assert_allclose([inner.load, outer.load], [torque.inner.load[0], torque.outer.load[0]], rtol=1e-12)
    assert inner.contact_angle > outer.contact_angle + 0.02
    assert outer.load > inner.load + 10


def test_a_given_angle_cannot_carry_a_radial_load(scene: Scene) -> None:
    with pytest.raises(InputError, match=r'radial_load = 1500 N.*rule = "given"'):
        contact_of(replace(scene, contact_angle=ContactAngle(rule="given", value=0.2)), pair="inner")


def test_a_pocket_has_the_load_of_the_paper_and_needs_a_cage() -> None:
    caged = load_scene("paper_6205")
    pocket = contact_of(caged, pair="pocket")
    assert (pocket.pair, pocket.load) == ("pocket", 28.0)  # the largest force of the paper
    assert contact_of(caged, pair="pocket", load=3.5).load == 3.5
    with pytest.raises(InputError, match=r"no \[cage\]"):
        contact_of(replace(caged, cage=None), pair="pocket")
