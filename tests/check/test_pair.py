"""The check of a pair: the heaviest ball of each bearing, its contacts, its friction, and how they are named."""

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check import validation
from fembearing.check.contact import scene_contact
from fembearing.check.contact.scene_contact import bearings_of
from fembearing.check.torque_change import change_of_torque
from fembearing.check.validation import Validation, check_scene
from fembearing.report.folder import report_page
from fembearing.report.report import Report, report_of
from tests.analytic.specimens import present

if TYPE_CHECKING:
    from fembearing.mesh.recipe import Recipe

PAIR = """
name = "a pair"
tolerance = "5 %"
cage = "none"
[bearing]
catalog = "7205 BEP"
[arrangement]
kind = "O"
preload = "230 N"
[operation]
axial_load = ["170 N", "410 N"]
inner_speed = "1300 rpm"
[friction]
coefficient = 0.07
"""
RACES = [("first", "inner"), ("first", "outer"), ("second", "inner"), ("second", "outer")]


@pytest.fixture(scope="module")
def scene() -> Scene:
    return parse_scene(PAIR, origin="here")


@pytest.fixture(scope="module")
def pair(scene: Scene, shallow: "Callable[[str], Recipe]") -> Validation:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(scene_contact, "load_recipe", shallow)
        return check_scene(scene, tolerance=0.9)


@pytest.fixture(scope="module")
def document(pair: Validation) -> Report:
    return report_of(pair)


def test_each_bearing_has_both_races_and_its_heaviest_ball(pair: Validation) -> None:
    """The balance of both rows together gives the same load as that of each bearing under the loads it takes."""
    assert [(solved.numbers.bearing, solved.numbers.pair) for solved in pair.contacts] == RACES
    both = present(present(pair.torque).friction.pair).equilibrium
    heaviest = both.ball_load.max(axis=1)
    for place, of_bearing in enumerate((pair.contacts[:2], pair.contacts[2:])):
        found = max(solved.contact.load for solved in of_bearing)
        assert found == pytest.approx(heaviest[place], rel=0.01)  # that has the fit for finite geometry, below 1 %


def test_the_balls_are_those_of_hertz_where_the_balance_is(scene: Scene) -> None:
    """Under unequal loads of the balls too, without the friction across the grooves that free balls have."""
    operation = replace(scene.operation, radial_load=np.array([130.0, 90.0]))
    off = {"finite_geometry": "off", "weight": "off"}  # the balance of a pair has no weight of its balls
    by_hertz = replace(scene, operation=operation, spin_rule="balanced", effects=off)
    first, second = bearings_of(by_hertz)
    assert (first.name, second.name) == ("first", "second")
    loads = [scene_contact.contact_of(each.scene, pair="outer").load for each in (first, second)]
    both = present(friction_torque(by_hertz).pair).equilibrium.ball_load
    np.testing.assert_allclose(loads, both.max(axis=1), rtol=1e-6)  # what the iterations leave
    assert both[0].argmax() == 1  # the axial load presses on the first bearing
    assert both[1].argmax() == 0  # and relieves the second


def test_the_torque_changes_by_the_contacts_of_the_heavier_bearing(pair: Validation) -> None:
    production = present(pair.torque).friction
    first, second = pair.contacts[:2], pair.contacts[2:]
    expected, exchanged = (
        change_of_torque(pair.scene, production, inner=inner, outer=outer).corrected.torque.total
        for inner, outer in (first, second)
    )
    change = present(pair.torque_change)
    np.testing.assert_array_equal(change.corrected.torque.total, expected)
    assert np.all(expected != exchanged)
    assert change.is_solved.tolist() == [False, True]


def test_friction_is_that_of_each_bearing_at_its_point_of_the_pair(pair: Validation) -> None:
    assert [(creep.numbers.bearing, creep.place) for creep in pair.creep] == [("first", 1), ("second", 0)]
    first = pair.creep[0].numbers
    torque = present(pair.torque).friction.torque
    slides = sum(float(part[1]) for part in (torque.spin, torque.conformity) if part is not None)
    assert pair.creep_change == pytest.approx(first.change * slides / torque.total[1], rel=1e-12)  # round-off


def test_numbers_and_page_name_the_bearing(document: Report) -> None:
    assert [(contact.bearing, contact.pair) for contact in document.contacts] == RACES
    text = " ".join(report_page(document).split())
    for bearing, race in RACES:
        assert f"Ball on {race} race of the {bearing} bearing at" in text
        assert f"Friction on the {race} race of the {bearing} bearing" in text
    assert "Bearings of the pair, back to back (O)" in text
    assert "two 7205 BEP" in text


def test_without_friction_each_bearing_has_its_physical_limits(
    scene: Scene, pair: Validation, monkeypatch: pytest.MonkeyPatch
) -> None:
    known = iter(pair.contacts)  # which are the same without friction, as their rings
    monkeypatch.setattr(validation, "solve_contact", lambda *_, **__: next(known))
    monkeypatch.setattr(validation, "with_ring", lambda contact: contact)
    found = check_scene(replace(scene, friction_coefficient=None), tolerance=0.9)
    assert [check.where for check in found.verdicts.physical] == [
        f"{race} race of the {bearing} bearing" for bearing, race in RACES
    ]


def test_the_cost_of_methods_is_that_of_one_bearing(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"\[arrangement\] has two bearings"):
        check_scene(scene, cost=True)
