"""Samples whose free balls begin near where they settle, against the same scenes computed from the rule."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.special import ndtri
from scipy.stats import qmc

import analytic
from analytic.errors import InputError
from analytic.oil.variation import Variation
from analytic.prediction import evaluation, starts
from analytic.prediction.evaluation import Problem, evaluated, problem_of
from analytic.prediction.settled import FreeStart, free_start, settled_parts
from analytic.prediction.spreads import NUMERICAL, uncertain_inputs
from analytic.prediction.variants import varied_scene
from analytic.scene import Array, Operation, Scene
from analytic.torque import friction_torque

SCENE = Path(__file__).parents[3] / "validation" / "scenes" / "6205_physical.toml"
# Of the total: balls settle to 3e-4 of their friction and forces, and films stay those of the start.
NEARLY = 3e-3


def running(axial: float, speeds: list[float], radial: float) -> Scene:
    loads = {"axial_load": axial, "radial_load": radial}
    operation = Operation(inner_speed=np.array(speeds), **{k: np.full(len(speeds), v) for k, v in loads.items()})
    return replace(analytic.load_scene(SCENE), operation=operation)


def drawn(scene: Scene, count: int) -> tuple[Problem, Array]:
    problem = problem_of(scene, friction_torque(scene), uncertain_inputs(scene))
    cube = qmc.LatinHypercube(len(problem.inputs), rng=np.random.default_rng(29))
    return problem, ndtri(cube.random(count))


def varied(problem: Problem, score: Array) -> tuple[Scene, Variation]:
    values = {each.key: float(each.at(part)) for each, part in zip(problem.inputs, score, strict=True)}
    del values[NUMERICAL]
    return varied_scene(problem.scene, values)


@pytest.fixture(scope="module")
def thrust() -> tuple[Problem, Array]:
    return drawn(running(870.0, [13.0, -49.0], 0.0), 12)


def require_cold(problem: Problem, scores: Array) -> None:
    assert problem.starts is not None
    warm = evaluated(replace(problem, numerical=np.zeros_like(problem.numerical)), scores)[0]
    for score, torque in zip(scores, warm, strict=True):
        scene, variation = varied(problem, score)
        alone = friction_torque(scene, variation=variation).torque
        np.testing.assert_allclose(torque[0], alone.total, rtol=NEARLY)
        # What shifts between both parts by the same slip is a larger share of each.
        for name in ("spin", "conformity"):
            shift = torque[problem.parts.index(name)] - getattr(alone, name)
            np.testing.assert_array_less(np.abs(shift), NEARLY * alone.total)


def test_samples_are_those_of_cold_starts_under_thrust(thrust: tuple[Problem, Array]) -> None:
    require_cold(*thrust)


def test_samples_are_those_of_cold_starts_where_every_ball_has_its_own_load() -> None:
    require_cold(*drawn(running(640.0, [37.0], 410.0), 3))


def test_neither_order_nor_company_changes_a_sample(thrust: tuple[Problem, Array]) -> None:
    problem, scores = thrust
    whole, back, last = (evaluated(problem, some)[0] for some in (scores, scores[::-1], scores[-1:]))
    np.testing.assert_array_equal(whole, back[::-1])
    np.testing.assert_array_equal(whole[-1:], last)


def test_the_starts_are_near_where_samples_settle(thrust: tuple[Problem, Array]) -> None:
    """They follow the inputs: half a standard deviation away what is left of the change is of second order."""
    problem, _ = thrust
    assert problem.starts is not None
    where = [each.key for each in problem.inputs].index("lubricant.viscosity")
    score = np.zeros(len(problem.inputs))
    score[where] = 0.5
    moved, nominal = problem.starts.at(score), problem.starts.nominal
    settled = free_start(*varied(problem, score), moved)
    assert settled is not None
    change = np.linalg.norm(settled.velocity - nominal.velocity)
    assert np.linalg.norm(settled.velocity - moved.velocity) < 0.3 * change


@pytest.mark.parametrize("off", [np.nan, 4e-4])  # m per unit ring speed, of 1e-2
def test_a_start_that_is_no_start_is_left_for_the_rule(thrust: tuple[Problem, Array], off: float) -> None:
    problem, scores = thrust
    scene, variation = varied(problem, scores[0])
    assert problem.starts is not None
    lost = problem.starts.at(scores[0])
    lost.velocity[1] += off
    found, cold = settled_parts(scene, variation, lost), settled_parts(scene, variation)
    assert found is not None
    assert cold is not None
    assert found.total[1] == cold.total[1]  # its start is lost
    assert found.race[1] == cold.race[1]
    assert found.total[0] != cold.total[0]  # its own is not
    np.testing.assert_allclose(found.total[0], cold.total[0], rtol=NEARLY)


def test_an_input_whose_scene_has_no_torque_moves_no_start(
    thrust: tuple[Problem, Array], monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, _ = thrust
    real = starts.free_start

    def refuses(scene: Scene, variation: Variation, start: FreeStart | None = None) -> FreeStart | None:
        if scene.lubricant != problem.scene.lubricant:
            raise InputError("no such oil")
        return real(scene, variation, start)

    monkeypatch.setattr(starts, "free_start", refuses)
    keys = [each.key for each in problem.inputs]
    found = starts.starts_of(lambda score: evaluation.moved_scene(problem.scene, problem.inputs, score), len(keys))
    assert found is not None
    for key, slope in zip(keys, found.slopes.velocity, strict=True):
        assert np.any(slope) != key.startswith("lubricant"), key
