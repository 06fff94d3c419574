"""The standing of torques that were computed apart: the worst of them, with the points that have it."""

from dataclasses import replace

import numpy as np
import pytest

from analytic import friction_torque
from analytic.effects import Effects
from analytic.makers import beside_catalogue
from analytic.result import FrictionTorque
from analytic.scene import Operation, Scene
from analytic.scene_torque import SceneTorque
from analytic.scenefile.read import load_scene
from analytic.standing import worst_standing

Series = tuple[Scene, FrictionTorque]


@pytest.fixture(scope="module")
def good() -> Series:
    scene = load_scene("6206", settings={"friction.spin_rule": "balanced"})
    points = Operation(
        inner_speed=np.array([90.0, 110.0]), axial_load=np.zeros(2), radial_load=np.array([900.0, 1300.0])
    )
    scene = replace(scene, operation=points)
    return scene, friction_torque(scene)


def with_errors(series: Series, errors: list[float]) -> Series:
    scene, friction = series
    return scene, replace(friction, numerical_uncertainty=np.array(errors))


def with_pressures(series: Series, pressures: list[float]) -> Series:
    """Pressures on the outer race, Pa."""
    scene, friction = series
    peak = np.array([friction.limits.peak_pressure[0], pressures])
    return scene, replace(friction, limits=replace(friction.limits, peak_pressure=peak))


def test_of_one_series_it_is_that_of_the_torque(good: Series) -> None:
    for series, points in ((good, None), (with_errors(good, [0.02, 0.07]), 1)):
        scene, friction = series
        alone = SceneTorque(scene=scene, friction=friction, catalogue=beside_catalogue(scene)).standing
        found = worst_standing([series])
        assert (found.word, found.reason) == (alone.word, alone.reason)
        assert (found.points, found.size) == (points, 2)


def test_the_worst_series_decides_whatever_their_order(good: Series) -> None:
    loose, looser = with_errors(good, [0.02, 0.07]), with_errors(good, [0.11, 0.09])
    broken = with_pressures(good, [1.9e9, 4.7e9])
    for torques, line in (
        ([good, loose], "undecided at 1 of 4 points: the solver error is 7 %, tolerance 5 %"),
        ([loose, looser, good], "undecided at 3 of 6 points: the solver error is 11 %, tolerance 5 %"),
        ([looser, broken], "fail at 1 of 4 points: the peak pressure exceeds the static limit (outer race)"),
    ):
        for order in (torques, torques[::-1]):
            assert worst_standing(order).line("points") == line


def test_an_effect_is_named_once_with_its_largest_share(good: Series) -> None:
    """Where one series neglects it and another computes it, it is neglected."""

    def sized(share: float, decision: str) -> Series:
        scene, friction = good
        effects = {each.name: each for each in friction.effects}
        effects["ball_drag"] = replace(effects["ball_drag"], share=share, decision=decision, reason="not given")
        return scene, replace(friction, effects=Effects(lambda: effects))

    found = worst_standing([sized(0.21, "off"), good, sized(0.43, "on"), sized(0.13, "off")])
    assert found.word == "incomplete"
    assert found.line("points").startswith("incomplete: ball_drag (")
    assert "21 % of the torque" in found.reason
    assert "also neglected" not in found.reason
