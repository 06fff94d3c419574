"""Film and rolling force beside a numerical solution: the production values are those of the torque."""

import numpy as np
import pytest

from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.film.scene_film import problem_of

BALLS = 9  # of a 6205


def scene_text(formula: str) -> str:
    """Full film, isothermal and flooded: what the numerical solution is."""
    return f"""name = "test"
tolerance = "5 %"
[bearing]
catalog = "6205"
[operation]
axial_load = "730 N"
inner_speed = "640 rpm"
[friction]
coefficient = 0.05
spin_rule = "balanced"
[lubricant]
name = "ISO VG 46"
temperature = "52C"
rolling_formula = "{formula}"
[effects]
inlet_heating = "off"
starvation = "off"
centrifugal = "off"
gyroscopic = "off"
finite_geometry = "off"
weight = "off"
"""


@pytest.mark.parametrize("formula", ["numerical", "biboulet", "houpert"])
def test_the_rolling_force_is_that_of_the_torque(formula: str) -> None:
    """Both surfaces of a contact carry it at the entrainment speed: the power of all balls is 2 Z F V on each race."""
    scene = parse_scene(scene_text(formula), origin="here")
    power = 0.0
    for pair in ("inner", "outer"):
        closed = problem_of(scene, pair)
        force, _ = closed.model_force()
        power += 2 * BALLS * force * abs(closed.inflow.speed)
    rolling = friction_torque(scene).torque.rolling
    assert rolling is not None
    # The torque takes the oil's reach at the unloaded contact angle, and the fit alone depends on it: 0.09 % here.
    np.testing.assert_allclose(power / closed.inner_speed, rolling, rtol=2e-3 if formula == "numerical" else 1e-6)
