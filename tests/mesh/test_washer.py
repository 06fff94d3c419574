"""The groove of a thrust washer in the mesh: straight, between lands that are parallel to the tangent plane."""

from dataclasses import replace

import numpy as np

from fembearing.mesh.race import race_height
from tests.contacts import INNER

WASHER = replace(
    INNER, rolling_radius=np.inf, contact_angle=np.pi / 2, shoulder=1.7e-3, far_shoulder=1.4e-3, groove_radius=4.2e-3
)


def test_a_washer_is_the_limit_of_ever_larger_rings() -> None:
    x, y = np.meshgrid(np.linspace(-2e-3, 2e-3, 5), np.linspace(-2.2e-3, 2.2e-3, 9))
    height = race_height(WASHER, x, y)
    for side in (1, -1):
        ring = race_height(replace(WASHER, rolling_radius=side * 1e3, contact_angle=0.0), x, y)
        np.testing.assert_allclose(height, ring, atol=1e-8)  # x^2/2R is 2e-9 m, rise^2/2R less
    profile = 4.2e-3 - np.sqrt(4.2e-3**2 - np.clip(y, -1.4e-3, 1.7e-3) ** 2)
    np.testing.assert_allclose(height, profile, rtol=1e-9, atol=1e-15)  # round-off of a small difference
