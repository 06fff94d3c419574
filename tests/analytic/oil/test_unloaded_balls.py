"""Balls without load that roll in oil: what they cost, and when they count."""

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

from analytic.oil.ehl_fit import effective_reach
from analytic.oil.rolling import replenishment_factor
from analytic.scene import Scene, Supply
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from tests.analytic.specimens import present

RADIAL = """
name = "radial"
tolerance = "5 %"
[bearing]
catalog = "6207"
clearance = "14 um"
[operation]
radial_load = "830 N"
inner_speed = "900 rpm"
[lubricant]
name = "ISO VG 46"
temperature = "52 degC"
[surface]
finish = "ground and honed"
[friction]
spin_rule = "balanced"
[effects]
centrifugal = "off"
gyroscopic = "off"
weight = "off"
"""


@pytest.fixture(scope="module")
def scene() -> Scene:
    return parse_scene(RADIAL, origin="here")


def without(scene: Scene) -> Scene:
    return replace(scene, effects={**scene.effects, "unloaded_balls": "off"})


def test_the_balls_out_of_the_load_are_summed(scene: Scene) -> None:
    """Under a radial load the gap of a ball follows from the place of the ring alone."""
    found, bare = friction_torque(scene), friction_torque(without(scene))
    ring, bearing, oil = present(found.ring), scene.bearing, present(scene.lubricant)
    count = bearing.ball_count
    moved = present(ring.displacement)[0, 1]  # along x
    around = 2 * np.pi * np.arange(count) / count
    speed, torque = scene.operation.inner_speed[0], 0.0
    viscosity = oil.viscosity  # at the temperature of the oil, which is that of the scene
    for azimuth, load in zip(around, ring.load[0, 0], strict=True):
        if load > 0:
            continue
        gap = (bearing.diametral_clearance / 2 - moved * np.cos(azimuth)) / 2
        for race, sign in (("inner", 1), ("outer", -1)):
            groove, ball = getattr(bearing, race), bearing.ball_radius
            orbit = bearing.pitch_diameter / 2
            radius = 1 / (1 / ball + sign / (orbit - sign * ball))
            ellipticity = radius * (1 / ball - 1 / groove.groove_radius)
            ahead = effective_reach(bearing, race, reach=0.9, contact_angle=0.0)  # pyright: ignore[reportArgumentType]
            entrainment = (orbit - ball) * (orbit + ball) / (2 * orbit)
            force = 6 * np.pi * viscosity * speed * entrainment * radius / ((3 + 2 * ellipticity) * ellipticity**0.5)
            force *= np.log(1 + ahead**2 / (7.5 * gap * radius))
            torque += 2 * force * entrainment
    torque *= replenishment_factor(
        bore_diameter=present(bearing.bore_diameter),
        outside_diameter=present(bearing.outside_diameter),
        ring_speed=speed,
        kinematic_viscosity=viscosity / oil.density,
        supply="oil_bath",
    )
    added = present(found.torque.rolling) - present(bare.torque.rolling)
    # The reach is that of the free contact angle, here 0.1 rad, whose cosine narrows the groove by 0.5 %.
    np.testing.assert_allclose(added, torque, rtol=5e-3)
    assert added / bare.torque.total > 0.02


def test_they_starve_as_the_others_do(scene: Scene) -> None:
    """A cold bath leaves them the same share of rolling as the loaded balls, whose share is the factor's own."""
    thick = replace(scene, lubricant=replace(present(scene.lubricant), viscosity=1.9))

    def rolling(each: Scene, **effects: Literal["on", "off"]) -> float:
        counted = replace(each, effects={**each.effects, "inlet_heating": "off", **effects})
        return float(present(friction_torque(counted).torque.rolling)[0])

    flooded, starved = rolling(thick, starvation="off"), rolling(thick, starvation="on")
    alone, loaded = rolling(thick, starvation="off", unloaded_balls="off"), rolling(thick, unloaded_balls="off")
    assert flooded > 1.2 * alone  # they roll
    assert starved < 0.6 * flooded
    # Loads do not follow rolling, and both factors are one: to the digits of the sums.
    assert starved / flooded == pytest.approx(loaded / alone, rel=1e-9)


@pytest.mark.parametrize("supply", ["oil_jet", "oil_spot", "grease"])
def test_only_a_bath_has_oil_around_them(scene: Scene, supply: Supply) -> None:
    oil = replace(present(scene.lubricant), supply=supply)
    found = friction_torque(replace(scene, lubricant=oil))
    effect = {each.name: each for each in found.effects}["unloaded_balls"]
    assert (effect.decision, supply in effect.reason) == ("off", True)
    np.testing.assert_array_equal(
        found.torque.total, friction_torque(without(replace(scene, lubricant=oil))).torque.total
    )


def test_rolling_does_not_jump_where_a_ball_is_barely_pressed(scene: Scene) -> None:
    """Centrifugal force presses the balls out of the load on the outer race, from nothing on: their mass varies."""
    pressed = replace(scene, effects={**scene.effects, "centrifugal": "on"})
    masses = scene.bearing.ball_mass * np.array([1e-9, 1e-7, 1e-5, 1e-3, 0.03, 0.3, 1.0])

    def rolling(mass: float) -> float:
        bearing = replace(pressed.bearing, ball_mass=mass)
        return float(present(friction_torque(replace(pressed, bearing=bearing)).torque.rolling)[0])

    found = np.array([rolling(mass) for mass in masses])
    free = float(present(friction_torque(scene).torque.rolling)[0])
    np.testing.assert_allclose(found[0], free, rtol=1e-4)  # the force moves the other balls and the ring a little
    # A force against a race only adds there: the sum over both gaps is least in the middle. But it relieves the inner
    # race of loaded balls, by less than 1e-3.
    assert np.all(np.diff(found) > -1e-3 * free)
