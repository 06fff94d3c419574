"""What a race of a scene resists: by what its parts are made of, and a ball that rolls off a race both ways."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.contact.geometry import race_curvatures
from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.numbers import free_angle
from analytic.oil.ehl_fit import effective_reach, gap_force
from analytic.oil.race_resistance import (
    SMOOTH_FORM,
    RaceResistance,
    gap_law_of,
    gap_off_race,
    left_of_unloaded,
    resistance_of,
    torque_off_race,
)
from analytic.oil.variation import NOMINAL, Variation
from analytic.oil.viscosity import oil_numbers
from analytic.scene import ContactAngle, Scene
from analytic.surface.gap import SMOOTH_GAP
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, dry
from tests.contacts import STEEL

SCENE = replace(
    dry(BEARING_6205),
    contact_angle=ContactAngle(rule="given", value=0.31),
    friction_coefficient=None,
    lubricant=OIL,
    surface=FINISH,
)
RACES = ("inner", "outer")


def resistance(scene: Scene = SCENE, variation: Variation = NOMINAL, **off: Any) -> RaceResistance:
    return resistance_of(scene, (SMOOTH_FORM, SMOOTH_FORM), lambda name: name not in off, variation)


@pytest.mark.parametrize(
    ("rule", "angle"),
    [
        (ContactAngle(rule="given", value=0.31), 0.31),
        (ContactAngle(rule="solved", free=0.22), 0.22),
        (ContactAngle(rule="solved"), free_angle(BEARING_6205)),
    ],
)
def test_the_reach_of_the_oil_is_that_at_the_unloaded_angle(rule: ContactAngle, angle: float) -> None:
    found = resistance(replace(SCENE, contact_angle=rule))
    for race in RACES:
        reach = effective_reach(BEARING_6205, race, reach=OIL.reach.ahead, contact_angle=angle)  # pyright: ignore[reportArgumentType]
        assert getattr(found, race).supply.ahead == pytest.approx(reach, rel=1e-12)


def test_a_gap_law_is_that_of_rough_surfaces_in_oil() -> None:
    bodies = (STEEL, STEEL)
    assert gap_law_of(SCENE, bodies) is not SMOOTH_GAP
    assert gap_law_of(replace(SCENE, surface=None), bodies) is SMOOTH_GAP
    assert gap_law_of(replace(SCENE, friction_coefficient=0.07), bodies) is SMOOTH_GAP


@pytest.mark.parametrize("race", [0, 1])
def test_a_ball_off_a_race_resists_by_the_force_in_its_gap(race: int) -> None:
    """2 f u/w at each surface, by the reach of its race; and the gap comes back from the torque."""
    found, oil, speed, entrainment, gap = (
        resistance(variation=Variation(unloaded_balls=1.3), starvation=0),
        oil_numbers(OIL),
        -74.0,
        9.1e-3,
        6e-6,
    )
    rolling, transverse = race_curvatures(BEARING_6205, RACES[race], contact_angle=0.31)  # pyright: ignore[reportArgumentType]
    contact = ContactNumbers(0.0, 0.0, 0.0, float(rolling), float(transverse), 1.13e11, np.nan, np.nan, np.nan)
    torque = torque_off_race(found, oil, race, contact, entrainment, gap, speed)
    ahead = getattr(found, RACES[race]).supply.ahead
    force = gap_force(oil.viscosity * 74.0 * entrainment, 1 / float(rolling), float(transverse / rolling), gap, ahead)
    assert torque == pytest.approx(1.3 * 2 * force * entrainment, rel=1e-12)
    assert gap_off_race(found, oil, race, contact, entrainment, torque, speed) == pytest.approx(gap, rel=1e-9)
    assert gap_off_race(found, oil, race, contact, entrainment, 0.0, speed) == np.inf
    assert gap_off_race(found, oil, race, contact, entrainment, torque, 0.0) == np.inf
    starved, rate = resistance(variation=Variation(unloaded_balls=1.3)), getattr(found, RACES[race]).supply.rate
    left = torque_off_race(starved, oil, race, contact, entrainment, gap, speed) / torque
    assert left == pytest.approx(np.exp(-rate * 74.0 * oil.viscosity / oil.density), rel=1e-12)
    assert gap_off_race(starved, oil, race, contact, entrainment, left * torque, speed) == pytest.approx(gap, rel=1e-9)


def test_balls_without_load_do_not_starve_by_a_degree() -> None:
    """It is the place of a meniscus ahead of a contact, and they have none."""
    given = replace(SCENE, lubricant=replace(OIL, starvation_degree=1.4))
    assert left_of_unloaded(resistance(given), oil_numbers(OIL), 0, 74.0) == 1.0
    assert left_of_unloaded(resistance(), oil_numbers(replace(OIL, viscosity=1e4)), 0, 740.0) == 0.0
