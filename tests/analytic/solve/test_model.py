"""A scene in the numbers of the kernel: what counts, the balls' weights, and copies that do not change each other."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.free_ball.turning import FreeNumbers
from analytic.scene import STANDARD_GRAVITY, ContactAngle, Losses, Scene
from analytic.sliding.long_ellipse import RULES
from analytic.solve.model import Counted, model_of, weights_of
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, STAMPED_CAGE, thrust

SCENE = Scene(
    bearing=BEARING_6205,
    contact_angle=ContactAngle(rule="solved", free=0.26),
    operation=thrust(310.0, 470.0, 890.0),
    lubricant=OIL,
    surface=FINISH,
    losses=Losses(seals=3e-3, drag=0.8e-3),
)
ALL = dict.fromkeys(Counted._fields, True)
DOWN = (0.48, -0.64, 0.6)


def counted_in(model: Any) -> set[str]:
    return {name for name in Counted._fields if bool(getattr(model.numbers.counted, name))}


def test_a_model_has_the_numbers_of_its_scene() -> None:
    model = model_of(SCENE, {"spin": True, "rolling": True})
    assert counted_in(model) == {"spin", "rolling"}
    assert float(model.numbers.arm) == pytest.approx(15.53e-3 + 4.13e-3, rel=1e-12)  # of the groove's centre
    assert float(model.numbers.declared) == pytest.approx(3.8e-3, rel=1e-12)
    assert (model.temperature, bool(model.numbers.has_oil)) == (313.15, True)
    assert (model.creep, len(model.tables.quadratures), model.tables.law.size) == (None, 0, 0)
    assert not np.any(model.weights)
    dry = model_of(replace(SCENE, lubricant=None, surface=None, friction_coefficient=0.07, losses=Losses()), {})
    assert (dry.temperature, bool(dry.numbers.has_oil), float(dry.numbers.declared)) == (0.0, False, 0.0)


@pytest.mark.parametrize("rule", ["free", "balanced", "inner_control", "outer_control"])
def test_balls_by_rule_that_stand_for_free_ones_are_balanced(rule: Any) -> None:
    found = int(model_of(replace(SCENE, spin_rule=rule), {}).numbers.spin_rule)
    assert found == RULES["balanced" if rule == "free" else rule]


def test_weights_point_down_on_every_ball() -> None:
    """Radial and axial part; the balls stand at 2 pi j/Z from x on."""
    psi = 2 * np.pi * np.arange(9) / 9
    weight = BEARING_6205.ball_mass * STANDARD_GRAVITY
    radial = weight * (DOWN[0] * np.cos(psi) + DOWN[1] * np.sin(psi))
    expected = np.stack([radial, np.full(9, weight * DOWN[2])], axis=1)
    np.testing.assert_allclose(weights_of(BEARING_6205, DOWN), expected, rtol=1e-12, atol=1e-12 * weight)
    assert not np.any(weights_of(BEARING_6205, None))
    scene = replace(SCENE, down=DOWN)
    heavy, light = model_of(scene, {"weight": True}), model_of(scene, {})
    np.testing.assert_allclose(heavy.balls["weight"], expected, rtol=1e-12, atol=1e-12 * weight)
    assert not np.any(light.balls["weight"])
    np.testing.assert_array_equal(light.counting({"weight": True}).balls["weight"], heavy.balls["weight"])
    assert not np.any(heavy.counting({}).balls["weight"])
    turned = heavy.weighing(2 * expected)
    np.testing.assert_array_equal(turned.balls["weight"], 2 * expected)
    np.testing.assert_allclose(heavy.balls["weight"], expected, rtol=1e-12, atol=1e-12 * weight)


def test_a_model_with_other_numbers_leaves_the_first_one_alone() -> None:
    model = model_of(SCENE, ALL)
    other = model.with_numbers(passes=3, allowed=0.02)
    assert (int(other.numbers.passes), float(other.numbers.allowed)) == (3, 0.02)
    assert (int(model.numbers.passes), float(model.numbers.allowed)) == (0, 0.0)
    fewer = model.counting({"spin": True})
    assert counted_in(fewer) == {"spin"}
    assert counted_in(model) == set(Counted._fields)
    assert (bool(fewer.numbers.resistance.rolls), bool(fewer.numbers.resistance.elastic)) == (False, False)


@pytest.mark.parametrize("name", ["rolling", "hysteresis", "asperities", "inlet_heating", "starvation"])
def test_an_effect_of_the_oil_reaches_what_it_acts_on(name: str) -> None:
    numbers = model_of(SCENE, {}).counting({name: True}).numbers
    assert (bool(numbers.resistance.rolls), bool(numbers.resistance.elastic)) == (
        name == "rolling",
        name == "hysteresis",
    )
    for race in (numbers.resistance.inner, numbers.resistance.outer):
        acts = bool(race.asperities), bool(race.heats), bool(race.starves)
        assert acts == (name == "asperities", name == "inlet_heating", name == "starvation")


@pytest.mark.parametrize(
    ("changed", "starves"),
    [
        ({}, True),  # by the rings, from which oil returns
        ({"bearing": replace(BEARING_6205, bore_diameter=None, outside_diameter=None)}, False),
        (
            {
                "bearing": replace(BEARING_6205, bore_diameter=None, outside_diameter=None),
                "lubricant": replace(OIL, starvation_degree=3.0),
            },
            True,
        ),
        (
            {
                "bearing": replace(BEARING_6205, bore_diameter=None, outside_diameter=None),
                "lubricant": replace(OIL, supply="grease"),
            },
            True,
        ),
    ],
)
def test_inlets_starve_where_the_supply_of_oil_is_known(changed: dict[str, Any], starves: bool) -> None:
    model = model_of(replace(SCENE, **changed), ALL)
    again = model.counting({}).counting(ALL)
    for race in (again.numbers.resistance.inner, again.numbers.resistance.outer):
        assert bool(race.starves) == starves


def test_factors_of_points_go_with_their_points() -> None:
    many = ContactCorrection(inner=ContactFactors(approach=np.array([1.01, 1.02, 1.03])))
    model = model_of(SCENE, {}, correction=many)
    assert len(model.tables.factors) == 3
    np.testing.assert_array_equal(model.at(np.array([2, 0])).tables.factors, model.tables.factors[[2, 0]])
    same = model_of(SCENE, {}, correction=ContactCorrection(outer=ContactFactors(approach=1.01)))
    assert same.at(np.array([2, 0])) is same
    assert len(model_of(SCENE, {}).tables.factors) == 0


def test_balls_that_turn_freely_take_inertia_as_it_counts() -> None:
    model = model_of(SCENE, {"centrifugal": True})
    free = model.turning_freely(BEARING_6205, "closed")
    assert (free.creep, model.creep) == ("closed", None)
    assert len(free.tables.quadratures) > 1
    own = model_of(SCENE, {"centrifugal": True}, creep="closed")
    for name in FreeNumbers._fields:
        np.testing.assert_array_equal(getattr(free.numbers.free, name), getattr(own.numbers.free, name), err_msg=name)


def test_a_cage_counts_where_the_scene_has_one() -> None:
    with_cage = replace(SCENE, cage=STAMPED_CAGE)
    rooms = [
        float(model_of(scene, {"cage": on}).numbers.cage.room) for scene, on in ((with_cage, True), (with_cage, False))
    ]
    assert np.isfinite(rooms[0])
    assert np.isinf(rooms[1])
    assert np.isinf(float(model_of(SCENE, {"cage": True}).numbers.cage.room))
