"""Balls of production: which differ, what holds them, and marched creep against sliding in the limit of no creep."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.oil.traction import PointLaw
from analytic.scene import ContactAngle, Scene
from fembearing.verify.creep import production as module
from fembearing.verify.creep.production import (
    ALIKE,
    PASSES,
    _distinct,
    _held,
    _law,
    by_formula,
    by_march,
    models_of,
    produced,
)
from tests.verify.creep.test_scene_creep import THRUST, UNEQUAL, scene_of

STATE = np.dtype([("load", "f8", 2), ("angle", "f8", 2)])
CONTACT = np.dtype([("power", "f8"), *((name, "f8") for name in PointLaw._fields)])


@pytest.fixture(scope="module")
def scene() -> Scene:
    return scene_of(THRUST)


def states(loads: list[tuple[float, float]], angle: float = 0.3) -> tuple[Any, Any]:
    """Balls under these loads, and their contacts, whose power is a thousandth of them."""
    found, contacts = np.zeros(len(loads), STATE), np.zeros((len(loads), 2), CONTACT)
    found["load"], found["angle"] = loads, angle
    contacts["power"], contacts["boundary"] = 1e-3 * np.array(loads), 0.09
    return found, contacts


def test_balls_that_differ_come_with_the_heaviest_first(scene: Scene) -> None:
    """A pair of mirror images, which differ by less than a millionth, counts twice; one ball is off its inner race."""
    pair = (301.0, 302.0)
    alike, unlike = (tuple(np.array(pair) * (1 + share * ALIKE)) for share in (0.9, -10))
    loads = [(120.0, 121.0), pair, (0.0, 400.0), alike, unlike, (350.0, 210.0)]
    found = _distinct(scene, *states(loads), 67.0, inertia=True)
    assert [ball.load for ball in found] == pytest.approx([350.0, 302.0, unlike[1], 121.0])
    assert [ball.number for ball in found] == [1, 2, 1, 1]
    assert [ball.torque for ball in found] == pytest.approx([0.56, 0.603, sum(unlike) / 1e3, 0.241])
    assert found[0].turning.held.axial is not None  # the ring stays where production places it
    assert (found[0].turning.speed, found[0].turning.inertia) == (67.0, True)


def test_one_ball_stands_for_all_of_a_bearing_under_thrust(scene: Scene) -> None:
    (ball,) = _distinct(scene, *states([(240.0, 241.0)]), -67.0, inertia=False)
    assert ball.number == scene.bearing.ball_count
    assert ball.turning.held.axial is None
    assert ball.turning.held.thrust == pytest.approx(730.0 / scene.bearing.ball_count)
    assert (ball.turning.speed, ball.turning.inertia) == (67.0, False)  # of either direction


def test_balls_that_all_leave_a_race_are_refused(scene: Scene) -> None:
    with pytest.raises(InputError, match="no ball touches both races: give a larger load, or less speed"):
        _distinct(scene, *states([(0.0, 400.0), (0.0, 310.0)]), 67.0, inertia=True)


@pytest.mark.parametrize("angle", [0.27, -0.27])
def test_a_ring_in_its_place_presses_the_ball_as_production_does(scene: Scene, angle: float) -> None:
    """Pressed towards -z it is the mirror image of one that is pressed towards +z."""
    held, mirrored = _held(scene, states([(240.0, 240.0)], angle)[0][0], alone=False)
    assert mirrored == (angle < 0)
    lie = held.at_rest()
    np.testing.assert_allclose(lie.angles, abs(angle), rtol=1e-9)  # of differences of lengths
    np.testing.assert_allclose(lie.loads, 240.0, rtol=1e-6)


def test_under_thrust_alone_the_ring_is_free_along_the_axis(scene: Scene) -> None:
    """A ball at the angle of its own thrust rests there."""
    angle = float(np.arcsin(730.0 / 9 / 240.0))
    held, _ = _held(scene, states([(240.0, 240.0)], angle)[0][0], alone=True)
    assert held.axial is None
    np.testing.assert_allclose(held.at_rest().angles, angle, rtol=1e-6)


def test_a_given_angle_is_kept(scene: Scene) -> None:
    given = replace(scene, contact_angle=ContactAngle(rule="given", value=0.54))
    held, mirrored = _held(given, states([(240.0, 240.0)], -0.54)[0][0], alone=True)
    assert (held.angle, held.radial, mirrored) == (0.54, None, False)


def test_a_law_of_the_kernel_is_one_per_speed_of_the_ring() -> None:
    law = PointLaw(boundary=0.02, limit=0.05, eyring=4e6, fluidity=3.2, share=0.9, alpha=2.7e-8, exponent=0.6)
    for speed in (80.0, -80.0):
        assert _law(law._asdict(), speed) == law._replace(fluidity=0.04)


@pytest.mark.parametrize("off", ["spin", "conformity"])
def test_a_slip_without_one_of_its_parts_is_refused(scene: Scene, off: str) -> None:
    with pytest.raises(InputError, match=rf'effects\.{off} = "off" neglects a part of the slip: use "auto"'):
        models_of(replace(scene, effects={off: "off"}))


@pytest.mark.parametrize(
    ("kind", "gyroscopic", "centrifugal", "turns", "flies"),
    [
        ("radial", True, True, True, True),
        ("radial", True, False, False, False),
        ("radial", False, True, False, False),  # the reference has both or none
        ("thrust", True, False, True, False),  # at 90 degrees the races hold no centrifugal force
        ("thrust", False, False, False, False),
    ],
)
def test_inertia_counts_as_a_whole(
    scene: Scene,
    monkeypatch: pytest.MonkeyPatch,
    kind: str,
    gyroscopic: bool,
    centrifugal: bool,
    turns: bool,
    flies: bool,
) -> None:
    told: list[tuple[dict[str, bool], dict[str, Any]]] = []
    can = {"gyroscopic": gyroscopic, "centrifugal": centrifugal, "weight": True, "finite_geometry": True, "spin": False}
    monkeypatch.setattr(module, "possible", lambda _: can)
    monkeypatch.setattr(module, "model_of", lambda _, counted, **how: told.append((counted, how)))
    bearing: Any = replace(scene.bearing, kind=kind)
    models_of(replace(scene, bearing=bearing))
    assert [how for _, how in told] == [{"judges": False}, {"creep": "marched", "passes": PASSES}]
    for counted, _ in told:
        assert (counted["gyroscopic"], counted["centrifugal"]) == (turns, flies)
        left = counted["weight"], counted["finite_geometry"], counted["spin"], counted["conformity"]
        assert left == (False, False, True, True)


@pytest.mark.parametrize("operation", [THRUST, UNEQUAL.format(-3)])
def test_with_little_friction_all_slides_and_the_march_is_the_formula(operation: str) -> None:
    production = produced(scene_of(operation, friction="coefficient = 2e-4"))
    for marched, formula in zip(by_march(production), by_formula(production), strict=True):
        assert marched.slip_share > 0.99
        for name in ("spin_creepage", "spin_moment", "rolling_moment", "torque"):
            # A long ellipse instead of one that is nine times as long as wide. It lacks the turn by conformity, which
            # matters the more to the moment of rolling the less spin leaves of it.
            loose = {"rolling_moment": 0.25, "torque": 0.1}.get(name, 0.08)
            np.testing.assert_allclose(getattr(marched, name), getattr(formula, name), rtol=loose, err_msg=name)
        # Against slip by spin and conformity at the ends of the contact, which is about 1e-2.
        np.testing.assert_allclose(marched.creepage_along, formula.creepage_along, atol=3e-4)
        push = 2e-4 * production.heaviest[0]["load"].max()
        assert abs(marched.transverse_force) < 0.3 * push
        assert abs(marched.creepage_across) < 3e-4


def test_with_much_friction_nearly_all_sticks() -> None:
    production = produced(scene_of(THRUST, friction="coefficient = 1.5"))
    for found in by_march(production):
        assert 0 < found.slip_share < 0.4
