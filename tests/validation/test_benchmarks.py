"""Scenes and results go to other processes."""

import pickle

import numpy as np
import pytest

from analytic.scene import Scene
from analytic.torque import friction_torque
from validation.benchmarks import random_scenes


def test_a_scene_and_its_result_can_be_pickled() -> None:
    scene: Scene = random_scenes.random_scene(np.random.default_rng(7))
    direct, sent = friction_torque(scene), pickle.loads(pickle.dumps(scene))
    assert sent.effects == scene.effects
    returned = pickle.loads(pickle.dumps(friction_torque(sent)))
    np.testing.assert_array_equal(returned.torque.total, direct.torque.total)
    assert returned.provenance == direct.provenance
    with pytest.raises(TypeError):  # still read-only
        returned.provenance["scene"] = "another"
