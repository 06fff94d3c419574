"""The contact that is compared is that of the most heavily loaded ball."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.geometry import RACES
from analytic.errors import InputError
from analytic.loads.ring import ring_equilibrium
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Arrangement, Contact, ContactAngle, Operation, Pair, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.check.contact.scene_contact import (
    as_meshed,
    balls_of,
    bearings_of,
    contact_of,
    recipe_of,
    traced_to_load,
    which_bearing,
)
from fembearing.mesh.recipe import load_recipe


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
        np.testing.assert_allclose([contact.load, contact.contact_angle], [expected["load"][0], expected["angle"][0]])
        assert contact_of(thrust, pair=pair, load=77.0) == replace(contact, load=77.0)


def test_a_load_of_single_precision_is_a_double(scene: Scene) -> None:
    """NumPy would compute the whole contact in the precision of the load."""
    single: Any = np.float32(77.25)
    contact = contact_of(scene, pair="inner", load=single)
    assert contact == contact_of(scene, pair="inner", load=77.25)
    assert type(contact.load) is float


def test_under_a_radial_load_it_is_the_heaviest_of_the_ring(scene: Scene) -> None:
    ring = ring_equilibrium(scene.bearing, scene.contact_angle, axial_load=210.0, radial_load_x=1500.0, moment_y=1.3)
    heaviest = ring.balls[int(np.argmax(ring.balls["load"][:, 0]))]
    alone = thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=210.0)["load"][0]
    for race, load, angle in zip(RACES, heaviest["load"], heaviest["angle"], strict=True):
        contact = contact_of(scene, pair=race)
        # centrifugal and gyroscopic effects, which this ring has not, are below 1e-3 of this load
        np.testing.assert_allclose(contact.load, load, rtol=1e-3)
        np.testing.assert_allclose(contact.contact_angle, abs(angle), rtol=1e-2)
        assert contact.load > 5 * alone


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


@pytest.mark.parametrize(
    ("loads", "words"),
    [
        ({}, "operation.axial_load = 300 N: too wide"),
        ({"radial_load": [-900.0, 700.0]}, "operation.axial_load = 300 N, operation.radial_load = 900 N: too wide"),
        ({"moment": [0.2, -1.5]}, "operation.axial_load = 300 N, operation.moment = 1500 N mm: too wide"),
    ],
)
def test_a_refusal_names_the_loads_that_the_scene_gives(
    scene: Scene, loads: dict[str, list[float]], words: str
) -> None:
    points: dict[str, Any] = {name: np.array(values) for name, values in loads.items()}
    operation = Operation(axial_load=np.array([300.0, 210.0]), inner_speed=np.array([30.0, 55.0]), **points)
    with (
        pytest.raises(InputError, match=rf"^{words}$"),
        traced_to_load(replace(scene, operation=operation), pair="inner", load=None),
    ):
        raise InputError("too wide")


@pytest.mark.parametrize(
    ("pair", "load", "words"),
    [("inner", 77.0, "load = 77 N"), ("pocket", None, "load = 28 N"), ("pocket", 3.0, "load = 3 N")],
)
def test_a_refusal_names_the_load_that_was_asked_for(scene: Scene, pair: Pair, load: float | None, words: str) -> None:
    with pytest.raises(InputError, match=rf"^{words}: too wide$"), traced_to_load(scene, pair=pair, load=load):
        raise InputError("too wide")


def test_a_sheet_takes_the_place_of_a_pocket_alone() -> None:
    assert recipe_of("wall", pair="pocket").geometry == "wall"
    assert recipe_of("ring", pair="outer").geometry == "real"
    with pytest.raises(InputError, match="'wall' is that of a pocket; the outer race"):
        recipe_of("wall", pair="outer")


def test_words_that_are_none_are_refused(scene: Scene) -> None:
    pair: Any = "middle"
    geometry: Any = "flat"
    with pytest.raises(InputError, match="pair = 'middle' is no contact of a ball; give inner, outer or pocket"):
        contact_of(scene, pair=pair, load=3.0)
    with pytest.raises(InputError, match="geometry = 'flat' is not known; give real or hertzian or wall or ring"):
        recipe_of(geometry, pair="inner")


def test_half_spaces_have_no_shoulder(contacts: dict[str, Contact]) -> None:
    for geometry, kept in (("race", True), ("hertzian", False)):
        meshed = as_meshed(contacts["inner"], recipe=load_recipe(geometry))
        expected = contacts["inner"] if kept else replace(contacts["inner"], shoulder=np.inf, far_shoulder=np.inf)
        assert meshed == expected


def test_a_pair_has_no_contact_of_its_own(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"\[arrangement\] has two bearings"):
        balls_of(replace(scene, arrangement=Arrangement(kind="O", preload=130.0, distance=0.031)))


def test_the_bearings_of_a_pair_share_the_thrust(scene: Scene) -> None:
    """At every point one pulls against the other: the difference of their thrusts is the load."""
    loads = Operation(axial_load=np.array([90.0, -70.0, 500.0]), inner_speed=np.array([30.0, 40.0, 50.0]))
    ((name, points),) = ((each.name, each.points.tolist()) for each in bearings_of(replace(scene, operation=loads)))
    assert (name, points) == (None, [0, 1, 2])
    pair = replace(scene, operation=loads, arrangement=Arrangement(kind="O", preload=60.0, distance=0.031))
    first, second = bearings_of(pair)
    assert (first.name, second.name) == ("first", "second")
    for each in (first, second):
        assert each.scene.arrangement is None
        assert each.points.tolist() == [0, 1, 2]
        np.testing.assert_array_equal(each.scene.operation.inner_speed, loads.inner_speed)
    taken = first.scene.operation.axial_load - second.scene.operation.axial_load
    np.testing.assert_allclose(taken, loads.axial_load, rtol=1e-6)  # that of the equilibrium's root
    assert which_bearing(None) == ""
    assert which_bearing("second") == " of the second bearing"
