"""The search for scenes that break their stated uncertainty: what it draws, and that it sees a wrong statement."""

from collections.abc import Callable
from dataclasses import replace
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.errors import ConvergenceError, InputError
from analytic.result import FrictionTorque
from analytic.scenefile.read import parse_scene


@pytest.fixture(scope="module")
def adversary(script: Callable[[str], ModuleType]) -> ModuleType:
    return script("adversary")


def place(adversary: ModuleType, seed: int) -> tuple[float, ...]:
    return tuple(np.random.default_rng(seed).random(adversary.INPUTS).tolist())


def test_every_place_is_a_valid_scene_file_and_the_corners_are_reached(adversary: ModuleType) -> None:
    texts = [adversary.scene_text(place(adversary, seed), tolerance=0.01) for seed in range(300)]
    scenes = [parse_scene(text, origin="drawn") for text in texts]
    oils = [scene.lubricant.viscosity for scene in scenes if scene.lubricant is not None]
    assert min(float(scene.operation.axial_load[0]) for scene in scenes) < 0.3  # N
    assert min(float(scene.operation.inner_speed[0]) for scene in scenes) < 2e-3  # rad/s: 0.02 rpm
    assert max(oils) > 0.9  # Pa s
    assert 0.6 < np.mean([scene.surface is not None for scene in scenes]) < 0.95


def test_a_statement_that_is_too_narrow_is_seen(adversary: ModuleType, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same scene, whose `auto` is right, with a thousandth of its uncertainty."""
    here = place(adversary, 5)
    honest = adversary.trials_at(here)
    assert all(trial.ratio <= 1 for trial in honest)
    assert any(trial.error > adversary.ROUND_OFF for trial in honest)
    original = adversary.friction_torque

    def boasting(scene: Any) -> FrictionTorque:
        result = original(scene)
        return replace(result, numerical_uncertainty=1e-3 * result.numerical_uncertainty)

    monkeypatch.setattr(adversary, "friction_torque", boasting)
    assert any(trial.ratio > 1 for trial in adversary.trials_at(here))


def test_the_worst_place_comes_first_and_once(adversary: ModuleType) -> None:
    trial = adversary.Trial(place=(0.1,), tolerance=0.01, error=2e-3, stated=1e-3)
    worse, unknown = replace(trial, place=(0.2,), error=5e-3), replace(trial, place=(0.3,), stated=np.inf)
    found = adversary.worst_places([trial, unknown, worse, replace(trial, tolerance=0.05, error=1e-3)])
    assert [each.place for each in found] == [(0.2,), (0.1,), (0.3,)]
    assert [each.ratio for each in found] == [5.0, 2.0, 0.0]  # what is unknown is no violation
    assert replace(trial, error=np.nan).ratio > 1  # no number is one


def test_a_refusal_and_a_computation_that_fails_are_told_apart(
    adversary: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    def failing(problem: Exception) -> Callable[[Any], FrictionTorque]:
        def raised(_: Any) -> FrictionTorque:
            raise problem

        return raised

    monkeypatch.setattr(adversary, "friction_torque", failing(InputError("too fast")))
    assert adversary.trials_at(place(adversary, 5)) is None
    stuck = ConvergenceError(iterations=3, residual=1.0, tolerance=0.1)
    monkeypatch.setattr(adversary, "friction_torque", failing(stuck))
    assert adversary.trials_at(place(adversary, 5)) == []
