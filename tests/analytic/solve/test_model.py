"""A scene in the numbers of the kernel: what counts, the balls' weights, and copies that do not change each other."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.scene import STANDARD_GRAVITY, ContactAngle, Losses, Scene
from analytic.sliding.long_ellipse import RULES
from analytic.solve.model import Counted, Model, first_level
from analytic.solve.model import model_of as model_in
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


def model_of(scene: Scene, counted: dict[str, bool], *, free: bool = False, **options: Any) -> Model:
    return model_in(scene, counted, free=free, **options)


def counted_in(model: Any) -> set[str]:
    return {name for name in Counted._fields if bool(getattr(model.numbers.counted, name))}


def test_a_model_has_the_numbers_of_its_scene() -> None:
    model = model_of(SCENE, {"spin": True, "rolling": True})
    assert counted_in(model) == {"spin", "rolling"}
    assert float(model.numbers.arm) == pytest.approx(15.53e-3 + 4.13e-3, rel=1e-12)  # of the groove's centre
    assert float(model.numbers.declared) == pytest.approx(3.8e-3, rel=1e-12)
    assert (model.temperature, bool(model.numbers.has_oil)) == (313.15, True)
    assert (model.is_free, model.tables.law.size) == (False, 0)
    dry = model_of(replace(SCENE, lubricant=None, surface=None, friction_coefficient=0.07, losses=Losses()), {})
    assert (dry.temperature, bool(dry.numbers.has_oil), float(dry.numbers.declared)) == (0.0, False, 0.0)


@pytest.mark.parametrize("rule", ["free", "balanced", "inner_control", "outer_control"])
def test_balls_by_rule_that_stand_for_free_ones_are_balanced(rule: Any) -> None:
    found = int(model_of(replace(SCENE, spin_rule=rule), {}).numbers.spin_rule)
    assert found == RULES["balanced" if rule == "free" else rule]


@pytest.mark.parametrize("down", [DOWN, None])
def test_weights_point_down_on_every_ball(down: Any) -> None:
    """Radial and axial part; the balls stand at 2 pi j/Z from x on. Without a direction x is down."""
    psi, (x, y, z) = 2 * np.pi * np.arange(9) / 9, down or (1.0, 0.0, 0.0)
    weight = BEARING_6205.ball_mass * STANDARD_GRAVITY
    expected = np.stack([weight * (x * np.cos(psi) + y * np.sin(psi)), np.full(9, weight * z)], axis=1)
    heavy, light = (model_of(replace(SCENE, down=down), {"weight": on}) for on in (True, False))
    np.testing.assert_allclose(heavy.balls["weight"], expected, rtol=1e-12, atol=1e-12 * weight)
    assert not np.any(light.balls["weight"])


def test_a_model_with_other_numbers_leaves_the_first_one_alone() -> None:
    model = model_of(SCENE, ALL)
    other = model.with_numbers(level=3, allowed=0.02)
    assert (int(other.numbers.level), float(other.numbers.allowed)) == (3, 0.02)
    assert (int(model.numbers.level), float(model.numbers.allowed)) == (
        first_level(SCENE.tolerance),
        SCENE.tolerance / 2,
    )


@pytest.mark.parametrize("name", ["rolling", "hysteresis", "asperities", "inlet_heating", "starvation"])
def test_an_effect_of_the_oil_reaches_what_it_acts_on(name: str) -> None:
    numbers = model_of(SCENE, {name: True}).numbers
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
    for race in (model.numbers.resistance.inner, model.numbers.resistance.outer):
        assert bool(race.starves) == starves


def test_factors_of_points_go_with_their_points() -> None:
    many = ContactCorrection(inner=ContactFactors(approach=np.array([1.01, 1.02, 1.03])))
    model = model_of(SCENE, {}, correction=many)
    assert len(model.tables.factors) == 3
    np.testing.assert_array_equal(model.at(np.array([2, 0])).tables.factors, model.tables.factors[[2, 0]])
    same = model_of(SCENE, {}, correction=ContactCorrection(outer=ContactFactors(approach=1.01)))
    assert same.at(np.array([2, 0])) is same
    assert len(model_of(SCENE, {}).tables.factors) == 0


def test_a_cage_counts_where_the_scene_has_one() -> None:
    with_cage = replace(SCENE, cage=STAMPED_CAGE)
    rooms = [
        float(model_of(scene, {"cage": on}).numbers.cage.room) for scene, on in ((with_cage, True), (with_cage, False))
    ]
    assert np.isfinite(rooms[0])
    assert np.isinf(rooms[1])
    assert np.isinf(float(model_of(SCENE, {"cage": True}).numbers.cage.room))
