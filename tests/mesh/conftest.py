"""The two race contacts of a 6205, typed in by hand so that no formula stands between them and a mesh."""

import pytest

from analytic.scene import Contact, Material


@pytest.fixture(scope="session")
def contacts() -> dict[str, Contact]:
    steel = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="test")
    inner = Contact(
        pair="inner",
        ball_radius=3.97e-3,
        groove_radius=4.13e-3,
        rolling_radius=16.47e-3,
        shoulder=2.14e-3,
        contact_angle=0.303,
        load=372.0,
        ball_material=steel,
        race_material=steel,
    )
    outer = Contact(
        pair="outer",
        ball_radius=3.97e-3,
        groove_radius=4.21e-3,
        rolling_radius=-24.41e-3,
        shoulder=2.11e-3,
        contact_angle=0.303,
        load=372.0,
        ball_material=steel,
        race_material=steel,
    )
    return {"inner": inner, "outer": outer}
