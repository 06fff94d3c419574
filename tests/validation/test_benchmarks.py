"""The scripts that measure the torque model: each runs with tiny counts and writes its results."""

import pickle

import numpy as np
import pytest

from analytic.scene import Scene
from analytic.torque import friction_torque
from validation.benchmarks import friction as ladder
from validation.benchmarks import random_scenes


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
