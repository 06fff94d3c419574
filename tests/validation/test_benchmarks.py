"""The scripts that measure the torque model: each runs with tiny counts and writes its results."""

import csv
import pickle
from pathlib import Path

import numpy as np
import pytest

from analytic.scene import Scene
from analytic.torque import friction_torque
from validation.benchmarks import friction as ladder
from validation.benchmarks import random_scenes


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


@pytest.mark.slow
def test_auto_is_compared_with_everything_on(run_script, tmp_path: Path) -> None:
    printed = run_script("benchmarks/effects.py", "--scenes", "2", "--out", tmp_path)
    assert "2 scenes, seeds 30000 to 30001" in printed
    written = rows(tmp_path / "effects.csv")
    assert [float(row["tolerance"]) for row in written] == [0.1, 0.01, 0.001] * 2
    assert all(abs(float(row["difference"])) < float(row["tolerance"]) for row in written)
    assert (tmp_path / "effects.png").stat().st_size > 0


@pytest.mark.parametrize("seed", [416, 1573, 648, 1156])
def test_the_bound_on_cheap_methods_holds_in_the_worst_scenes(seed: int) -> None:
    """The worst of 1500: just below full spin, constant stress, and oil that stiffens with the pressure cubed."""
    for trial in ladder.trials_of(seed):
        assert abs(trial.error) <= trial.bound, trial


def test_a_scene_and_its_result_can_be_pickled() -> None:
    scene: Scene = random_scenes.random_scene(np.random.default_rng(7))
    direct, sent = friction_torque(scene), pickle.loads(pickle.dumps(scene))
    assert sent.effects == scene.effects
    returned = pickle.loads(pickle.dumps(friction_torque(sent)))
    np.testing.assert_array_equal(returned.torque.total, direct.torque.total)
    assert returned.provenance == direct.provenance
    with pytest.raises(TypeError):  # still read-only
        returned.provenance["scene"] = "another"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("friction.py", "--errors", "--scenes", "3"), "seeds 40000 to 40002"),
        (("cage.py", "--duration", "0.013", "--bounces", "3"), "largest drift of the energy"),
    ],
)
def test_the_other_scripts_run(run_script, arguments: tuple[str, ...], words: str) -> None:
    script, *options = arguments
    assert words in run_script(f"benchmarks/{script}", *options)
