"""Compiled points of a scene with fixed effects: the numbers of the series, step by step, or no answer at all."""

from dataclasses import fields, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic import friction_torque, load_scene, torque_function
from analytic.function import AT_REST
from analytic.oil.variation import Variation
from analytic.prediction import settled as of_samples
from analytic.prediction.settled import FreeStart, free_start, settle, settled_parts
from analytic.result import TorqueParts
from analytic.scene import Arrangement, Losses, Operation, Scene, SlidingMethod
from analytic.solve.records import BALL, NO_STEADY_ROTATION, POINT
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


FIXED: dict[str, Any] = {  # of a dry scene whose effects are settled
    "spin_rule": "balanced",
    "sliding": "single_coefficient",
    "effects": {"spin": "on", "conformity": "on", "hysteresis": "on", "load_distribution": "on"},
}


@pytest.fixture(scope="module")
def plain() -> Scene:
    return replace(load_scene("6205-dry"), cage=None, **FIXED)


def has_answer(scene: Scene, **changed: Any) -> bool:
    effects = {**scene.effects, **changed.pop("effects", {})}
    return settle(replace(scene, effects=effects, **changed), OTHER, None) is not None


def test_only_scenes_of_one_bearing_at_rest_have_an_answer(plain: Scene) -> None:
    assert has_answer(plain)
    for name in ("cage_dynamics", "ball_dynamics"):
        assert not has_answer(plain, effects={name: "on"})
        assert has_answer(plain, effects={name: "off"})
    assert not has_answer(plain, microslip="as_printed")
    assert not has_answer(plain, arrangement=Arrangement(kind="tandem", distance=0.02))


def test_unequal_loads_need_their_distribution(plain: Scene) -> None:
    for name, value in (("radial_load", 40.0), ("moment", 0.2)):
        unequal = replace(plain.operation, **{name: value})  # pyright: ignore[reportArgumentType]
        assert has_answer(plain, operation=unequal)
        assert not has_answer(plain, operation=unequal, effects={"load_distribution": "off"})
    assert has_answer(plain, effects={"load_distribution": "off"})


def test_methods_whose_nodes_follow_from_their_error_have_no_answer(plain: Scene) -> None:
    assert has_answer(plain, sliding="along_axis")
    assert not has_answer(plain, sliding="over_ellipse")
    for one in ("spin", "conformity"):  # one of both slides as well
        assert not has_answer(plain, sliding="over_ellipse", effects={one: "off"})
    assert has_answer(plain, sliding="over_ellipse", effects={"spin": "off", "conformity": "off"})


def test_balls_by_rule_are_no_start_of_free_ones(plain: Scene) -> None:
    assert free_start(plain) is None
    free = replace(plain, spin_rule="free", sliding="free_ball", effects={**plain.effects, "creep": "off"})
    start = free_start(free)
    assert start is not None
    assert np.all(start.passes > 0)
    still = replace(free, effects={**free.effects, "spin": "off", "conformity": "off"})
    assert free_start(still) is None


def started(
    moved: NDArray[np.float64], *, load: float = 0.0, passes: int = 2, lost: bool = False, aside: str = ""
) -> int:
    """How often a point is solved whose balls settle so far from their start; balls turn at a quarter of the pitch."""
    calls = []
    balls = np.zeros(
        len(moved),
        [(f"start_{name}", "f8", size) for name, size in zip(FreeStart._fields[1:], (4, 2, 2, 3), strict=True)],
    )
    work = SimpleNamespace(ring={"passes": 0}, balls=balls)

    def solve(_model: Any, _point: Any, **_: Any) -> Solution:
        calls.append(work.ring["passes"])
        work.balls["start_velocity"][:, 2] = moved * 0.04 / 4
        work.balls["start_load"][:, 1] += load
        found = np.zeros(1, POINT)
        found["status"] = NO_STEADY_ROTATION if lost and len(calls) == 1 else 0
        return Solution(points=found, balls=np.zeros((0, 0), BALL))

    start = FreeStart(np.array([5, passes]), *(np.zeros((2, len(moved), size)) for size in (4, 2, 2, 3)))
    numbers = SimpleNamespace(counted=SimpleNamespace(weight=aside == "weight"), tilt=np.nan)
    at = np.array([[300.0, float(aside == "radial_load"), float(aside == "moment"), 30.0, 0.0]])
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(of_samples, "solved", solve)
        of_samples._turn_freely(SimpleNamespace(numbers=numbers), at, start, 1, work, 0.04)  # pyright: ignore[reportArgumentType]
    assert calls[0] == passes
    assert calls[1:] in ([], [0])  # anew, by rule
    return len(calls)


@pytest.mark.parametrize(("share", "times"), [(0.0299, 1), (0.0301, 2)])
def test_balls_that_settle_far_from_their_start_begin_anew(share: float, times: int) -> None:
    """By 3 % of their speed along the orbit, a quarter of the pitch diameter, or of their load over the rule's."""
    assert started(np.full(3, share)) == started(np.full(3, -share)) == times
    assert started(np.zeros(3), load=share) == started(np.zeros(3), load=-share) == times
    assert started(np.zeros(3), lost=True) == 2
    assert started(np.full(3, share), passes=0) == 1  # a start that is not known


@pytest.mark.parametrize("name", ["radial_load", "moment", "weight"])
def test_of_a_ring_the_median_ball_decides_and_of_thrust_the_first(name: str) -> None:
    first, others = np.array([0.2, 0.0, 0.0]), np.array([0.0, 0.2, 0.2])
    assert (started(first), started(others)) == (2, 1)
    assert (started(first, aside=name), started(others, aside=name)) == (1, 2)
