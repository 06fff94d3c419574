"""Compiled points of a scene with fixed effects: the numbers of the series, step by step, or no answer at all."""

from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene, torque_function
from analytic.function import AT_REST
from analytic.oil.variation import Variation
from analytic.prediction import settled as of_samples
from analytic.prediction.settled import settled_parts
from analytic.result import TorqueParts
from analytic.scene import Losses, Operation, Scene, SlidingMethod
from analytic.solve.records import NO_STEADY_ROTATION
from analytic.solve.solution import Solution, solved

SCENES = Path(__file__).parents[3] / "validation" / "scenes"
ROUND_OFF = 1e-11  # the ring settles to 1e-12 of its load, from two different starts
OTHER = Variation(film=0.83, rolling=1.21, asperity_pressure=1.7)


def settled(name: str, **changed: object) -> Scene:
    scene = load_scene(SCENES / f"{name}.toml" if (SCENES / f"{name}.toml").exists() else name)
    given = {"spin_rule": "balanced", "sliding": "along_axis", "effects": {}} | changed
    given["effects"] = {**AT_REST, **given["effects"]}  # pyright: ignore[reportGeneralTypeIssues]
    scene = replace(scene, **given)  # pyright: ignore[reportArgumentType]
    return friction_torque(scene).settled(scene)


def require_the_series(scene: Scene) -> None:
    own, series = settled_parts(scene, OTHER), friction_torque(scene, variation=OTHER).torque
    assert own is not None
    for name in (each.name for each in fields(TorqueParts)):
        mine, its = getattr(own, name), getattr(series, name)
        assert (mine is None) == (its is None), name
        if its is not None:
            np.testing.assert_allclose(mine, its, rtol=ROUND_OFF, atol=ROUND_OFF * series.total.max(), err_msg=name)


@pytest.mark.parametrize("radial", [0.0, 430.0])
@pytest.mark.parametrize(
    ("name", "sliding"),
    [("6205-dry", "single_coefficient"), ("paper_6205", "single_coefficient"), ("6205_physical", "along_axis")],
)
def test_every_part_is_that_of_the_series(name: str, sliding: str, radial: float) -> None:
    speed, axial = np.array([14.0, 0.0, -61.0]), np.array([380.0, 700.0, 910.0])
    loads = Operation(axial_load=axial, inner_speed=speed, radial_load=np.full(3, radial))
    require_the_series(settled(name, sliding=sliding, operation=loads, losses=Losses(seals=3e-3)))


@pytest.mark.parametrize("left_out", ["hysteresis", "rolling", "spin", "asperities", "finite_geometry"])
def test_what_is_off_stays_off(left_out: str) -> None:
    """Also in the function for time steps."""
    scene = settled("6205_physical", effects={left_out: "off"})
    require_the_series(scene)
    at = {"axial_load": 520.0, "inner_speed": 33.0}
    fixed = torque_function(scene)
    alone = replace(fixed.scene, operation=Operation(**{name: np.array([value]) for name, value in at.items()}))
    np.testing.assert_allclose(fixed(**at), friction_torque(alone).torque.total[0], rtol=ROUND_OFF)


@pytest.mark.parametrize("radial", [0.0, 430.0])
@pytest.mark.parametrize("sliding", ["free_ball", "closed_creep", "marched_creep"])
def test_balls_that_turn_freely_are_those_of_the_series(sliding: SlidingMethod, radial: float) -> None:
    """One of the points stands, one is so fast that inertia counts; each takes its own number of passes."""
    speed, axial = np.array([14.0, 0.0, -880.0]), np.array([380.0, 700.0, 910.0])
    loads = Operation(axial_load=axial, inner_speed=speed, radial_load=np.full(3, radial))
    own = {"creep": "off" if sliding == "free_ball" else "on"}
    scene = settled("6205_physical", spin_rule="free", sliding=sliding, operation=loads, effects=own, tolerance=0.02)
    assert scene.sliding == sliding
    require_the_series(replace(scene, losses=Losses(seals=3e-3)))


def test_free_balls_with_a_cage_and_a_given_coefficient() -> None:
    require_the_series(settled("6205-dry", spin_rule="free", sliding="marched_creep"))


def test_a_free_ball_that_does_not_settle_has_no_answer(monkeypatch: pytest.MonkeyPatch) -> None:
    free = settled("6205_physical", spin_rule="free", sliding="marched_creep")

    def skid(*given: Any, **more: Any) -> Solution:
        found = solved(*given, **more)
        found.points["status"][-1] = NO_STEADY_ROTATION
        return found

    monkeypatch.setattr(of_samples, "solved", skid)
    assert settled_parts(free, OTHER) is None


def test_what_only_the_series_computes_has_no_answer() -> None:
    over_the_ellipse = settled("6205_physical", sliding="over_ellipse")
    assert settled_parts(over_the_ellipse, OTHER) is None  # as many nodes as the error needs
    assert settled_parts(settled("thrust_rig_3mm"), OTHER) is None  # limits of the speed
    beyond = replace(over_the_ellipse, sliding="single_coefficient")
    far = Operation(axial_load=np.array([300.0, 9e6]), inner_speed=np.array([40.0, 40.0]))
    assert settled_parts(replace(beyond, operation=far), OTHER) is None  # off its race
