"""The bearing that most of these tests use."""

import pytest

from analytic.scene import Bearing, Groove, Material


@pytest.fixture(scope="session")
def bearing_6205() -> Bearing:
    """Table 1 of the paper, typed in here a second time, so that a slip in the catalog shows."""
    steel = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="test")
    return Bearing(
        name="6205",
        ball_count=9,
        ball_diameter=7.94e-3,
        ball_mass=2.04e-3,
        ball_material=steel,
        inner=Groove(bottom_radius=15.53e-3, groove_radius=4.13e-3, shoulder_half_width=3.1e-3, material=steel),
        outer=Groove(bottom_radius=23.48e-3, groove_radius=4.21e-3, shoulder_half_width=3.1e-3, material=steel),
        bore_diameter=25e-3,
        outside_diameter=52e-3,
    )
