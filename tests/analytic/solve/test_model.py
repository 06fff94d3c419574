"""A scene in the numbers of the kernel: what counts, the balls' weights, and copies that do not change each other."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import STANDARD_GRAVITY, ContactAngle, Losses, Scene
from analytic.solve.model import Model
from analytic.solve.model import model_of as model_in
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, thrust

SCENE = Scene(
    bearing=BEARING_6205,
    contact_angle=ContactAngle(rule="solved", free=0.26),
    operation=thrust(310.0, 470.0, 890.0),
    lubricant=OIL,
    surface=FINISH,
    losses=Losses(seals=3e-3, drag=0.8e-3),
)
DOWN = (0.48, -0.64, 0.6)


def model_of(scene: Scene, counted: dict[str, bool], *, free: bool = False, **options: Any) -> Model:
    return model_in(scene, counted, free=free, **options)


@pytest.mark.parametrize("down", [DOWN, None])
def test_weights_point_down_on_every_ball(down: Any) -> None:
    """Radial and axial part; the balls stand at 2 pi j/Z from x on. Without a direction x is down."""
    psi, (x, y, z) = 2 * np.pi * np.arange(9) / 9, down or (1.0, 0.0, 0.0)
    weight = BEARING_6205.ball_mass * STANDARD_GRAVITY
    expected = np.stack([weight * (x * np.cos(psi) + y * np.sin(psi)), np.full(9, weight * z)], axis=1)
    heavy, light = (model_of(replace(SCENE, down=down), {"weight": on}) for on in (True, False))
    np.testing.assert_allclose(heavy.balls["weight"], expected, rtol=1e-12, atol=1e-12 * weight)
    assert not np.any(light.balls["weight"])
