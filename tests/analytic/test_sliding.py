"""What the rungs of sliding miss against the last of them, and the bounds on it."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects import COMPUTED
from analytic.scene import Bearing
from analytic.torque import friction_torque
from tests.analytic.specimens import drawn, without


@pytest.mark.parametrize("rung", ["single_coefficient", "along_axis"])
@pytest.mark.parametrize("seed", range(40, 44))
def test_a_rung_misses_no_more_than_it_says(bearing_6205: Bearing, seed: int, rung: Any) -> None:
    drawn_scene = drawn(bearing_6205, np.random.default_rng(seed), points=6)
    still = replace(drawn_scene.operation, radial_load=0.0)
    plain = without(replace(drawn_scene, operation=still), *COMPUTED[:4], "hysteresis", "rolling")
    exact = friction_torque(replace(plain, sliding="over_ellipse")).torque.total
    found = friction_torque(replace(plain, sliding=rung))
    assert np.all(np.abs(found.torque.total / exact - 1) <= found.numerical_uncertainty)
