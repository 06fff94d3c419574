"""The word for a torque and for several: each by its own cause, in the order fail, incomplete, undecided, check."""

import re
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.effects import Effect, Effects
from analytic.makers import CatalogueBand, beside_catalogue
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import Operation, Scene
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.template import scene_text
from analytic.standing import Standing, standing_of, worst_standing
from analytic.verdicts import NumericalCheck, PhysicalCheck, Verdicts

GOOD = PhysicalCheck(
    name="peak_pressure", where="inner race", point=0, value=1.7e9, limit=4.2e9, unit="Pa", verdict="pass", note=""
)
SOLVED = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.05)
TOTAL = np.array([0.021, 0.037])
BAND = CatalogueBand(
    low=np.array([0.017, 0.033]),
    high=np.array([0.029, 0.041]),
    values=MappingProxyType({"SKF": np.array([0.02, 0.04])}),
)
BARE = "inside the makers' formulas, without seals and drag; "


@pytest.fixture(scope="module")
def scene() -> Scene:
    return replace(load_scene("6205-dry"), tolerance=0.05, effects={})


def found(scene: Scene, **changed: Any) -> Standing:
    given: dict[str, Any] = {"numerical": SOLVED, "physical": (GOOD,), "band": BAND, "total": TOTAL}
    given |= {"shares": {"drag": 0.02}, "oil": None, "declared": None} | changed
    others = {name: given[name] for name in ("oil", "declared")}
    torque = TorqueParts(
        total=given["total"], race=given["total"], spin=None, conformity=None, hysteresis=None, **others
    )
    verdicts = Verdicts(numerical=given["numerical"], physical=given["physical"])
    effects = [
        Effect(name=name, decision="off", share=share, reason=f"no {name}") for name, share in given["shares"].items()
    ]
    return standing_of(scene, torque=torque, effects=effects, verdicts=verdicts, band=given["band"])


def test_each_cause_has_its_word_and_names_itself(scene: Scene) -> None:
    beyond = replace(GOOD, value=4.7e9, verdict="fail")
    loose = NumericalCheck(verdict="not reached", uncertainty=0.083, tolerance=0.05)
    lacking = {"drag": 0.02, "cage": 0.31, "weight": 0.07}
    for changed, word, reason in (
        ({}, "check", "inside the makers' formulas"),
        ({"total": np.array([0.015, 0.031])}, "check", "below the makers' formulas"),
        ({"total": np.array([0.021, 0.047])}, "check", "in part above the makers' formulas"),
        ({"total": np.array([0.121, 0.137]), "declared": np.full(2, 0.1)}, "check", BARE),
        ({"total": np.array([0.121, 0.137]), "declared": np.full(2, 0.07), "oil": np.full(2, 0.03)}, "check", BARE),
        ({"total": np.array([0.029, 0.041]), "oil": np.full(2, 0.02)}, "check", "below the makers' formulas, without"),
        ({"band": None}, "check", "no maker's formula"),
        ({"numerical": loose}, "undecided", "solver error is 8.3 %, tolerance 5 %"),
        ({"physical": (replace(GOOD, verdict="unknown"),)}, "undecided", "limit is not known"),
        ({"shares": lacking, "numerical": loose}, "incomplete", "neglected, 31 % of the torque, tolerance 5 %:"),
        ({"shares": lacking}, "incomplete", 'no cage; effects.cage = "off" accepts this; also neglected: weight'),
        ({"physical": (beyond,), "shares": lacking}, "fail", "peak pressure exceeds the static limit (inner race)"),
    ):
        standing = found(scene, **changed)
        assert standing.word == word
        assert reason in standing.reason


def test_an_estimated_loss_of_the_oil_is_named_and_decides_only_where_it_is_large() -> None:
    """A 6206 in an oil bath: the oil around the balls takes some 3 % of the torque at 3.5 kN and 3700 rpm."""
    choice: Any = {"radial_load": "3.5 kN", "speed": "3700 rpm", "oil": "ISO VG 68"}
    scene = replace(parse_scene(scene_text("6206", **choice), origin="here"), tolerance=0.02)
    result = torque_of_scene(scene, estimate=False)
    assert result.standing.word == "check"
    assert re.search(r"; without ball_drag, some [23](\.\d)? % by usual values; ", result.standing.reason)
    accepted = replace(result, scene=replace(scene, effects={**scene.effects, "ball_drag": "off"}))
    assert "ball_drag" not in accepted.standing.reason


@pytest.mark.parametrize(
    ("share", "word"), [(0.04, "check"), (0.19, "check"), (0.21, "incomplete"), (np.inf, "incomplete")]
)
def test_the_size_of_an_estimate_decides(scene: Scene, share: float, word: str) -> None:
    standing = found(scene, shares={"through_flow": share})
    assert standing.word == word
    assert ("through_flow" in standing.reason) == (share > scene.tolerance)


def test_what_is_there_and_of_unknown_size_makes_a_torque_incomplete(scene: Scene) -> None:
    """Seals that rub and nobody declares; not a shield."""
    shielded = replace(scene, bearing=replace(scene.bearing, seals="2Z", seals_rub=False))
    rubbing = replace(scene, bearing=replace(scene.bearing, seals="2RS1", seals_rub=True))
    for changed, word, reason in (
        (shielded, "check", "inside"),
        (
            rubbing,
            "incomplete",
            'larger than the torque, tolerance 5 %: no seals; losses.seals = "0 N mm" accepts this',
        ),
    ):
        standing = found(changed, shares={"seals": None})
        assert standing.word == word
        assert reason in standing.reason


def test_a_speed_beyond_usual_practice_is_named_with_every_word(scene: Scene) -> None:
    """n d_m of a 6205, 39 mm, is 5.5e6 mm/min at 14 700 rad/s."""
    fast = replace(scene, operation=replace(scene.operation, inner_speed=0 * scene.operation.inner_speed + 14.7e3))
    for changed, word in (({}, "check"), ({"shares": {"cage": 0.31}}, "incomplete")):
        standing, usual = found(fast, **changed), found(scene, **changed)
        assert standing.word == usual.word == word
        assert standing.reason.startswith("n d_m = 5.4")
        assert standing.reason.endswith(usual.reason)


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
