"""Friction of a ball in its pocket where the film formula holds: a wide pocket, thin oil, a high load."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.cage.pocket import friction_in_pocket
from analytic.contact.rolling_contact import elliptic_contact
from analytic.oil.film import central_film
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from tests.analytic.specimens import FINISH, OIL, STAMPED_CAGE, present
from tests.refusals import refused, refuses

BALL, POCKET = 3.97e-3, 6.95e-3  # m, radii: the paper's pocket
RADIUS = 1 / (1 / BALL - 1 / POCKET)
LOAD, SPEED = 4.7, np.array([0.31, 0.83])  # N, m/s
THIN = replace(OIL, viscosity=0.0043, pressure_viscosity=0.0, eyring_stress=63e6, compressible=False)


@pytest.fixture
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="given", value=0.18),
        operation=Operation(axial_load=np.array([900.0]), inner_speed=np.array([31.0])),
        cage=replace(STAMPED_CAGE, pocket_diameter=2 * POCKET, pocket_depth=POCKET),
        lubricant=THIN,
        surface=replace(FINISH, rms_roughness=0.0),
    )


def contact(scene: Scene) -> tuple[float, float]:
    """E*, Pa, and the area of the contact, m^2, by the closed form of Hertz for spheres."""
    softness = sum(
        (1 - body.poisson_ratio**2) / body.youngs_modulus
        for body in (scene.bearing.ball_material, scene.bearing.ball_material)
    )
    return 1 / softness, np.pi * (3 * LOAD * RADIUS * softness / 4) ** (2 / 3)


def film(scene: Scene, entrainment_speed: np.ndarray) -> np.ndarray:
    pocket = elliptic_contact(
        curvature_rolling=1 / RADIUS, curvature_transverse=1 / RADIUS, load=LOAD, modulus=contact(scene)[0]
    )
    computed = central_film(
        pocket, entrainment_speed=entrainment_speed, viscosity=THIN.viscosity, pressure_viscosity=0.0
    )
    assert not np.any(computed.capped)
    return computed.thickness


def with_molecules(scene: Scene, shear: np.ndarray | float) -> np.ndarray:
    """The coefficient of oil with this shear stress, Pa; films of 7 to 13 nm are a molecule to e^-7 and less."""
    molecular = np.exp(-film(scene, SPEED / 2) / 1e-9)
    return FINISH.boundary_friction * molecular + shear * contact(scene)[1] / LOAD * (1 - molecular)


def test_smooth_surfaces_shear_the_oil_in_their_contact(scene: Scene) -> None:
    """Newton's tau = eta v/h, as the stress of thin oil is far below that of Eyring; v slides and v/2 entrains."""
    computed = friction_in_pocket(scene, load=LOAD, surface_speed=SPEED)
    shear = THIN.viscosity * SPEED / film(scene, SPEED / 2)
    assert np.all(shear < 0.005 * present(THIN.eyring_stress))
    # Tolerance: asinh(x)/x = 1 - x^2/6
    np.testing.assert_allclose(computed.coefficient, with_molecules(scene, shear), rtol=1e-5)
    assert computed.warnings == ()
    assert computed.source == "mixed lubrication"


def test_the_softer_body_determines_the_contact_area(scene: Scene) -> None:
    """A cage with 1/97 of the modulus: the area is proportional to the sum of both compliances to the power 2/3."""
    cage = scene.cage
    assert cage is not None
    soft = replace(cage.material, youngs_modulus=cage.material.youngs_modulus / 97)
    scene = replace(scene, lubricant=replace(THIN, traction="eyring_constant"))
    steel = friction_in_pocket(scene, load=LOAD, surface_speed=SPEED).coefficient
    scene = replace(scene, cage=replace(cage, material=soft))
    computed = friction_in_pocket(scene, load=LOAD, surface_speed=SPEED).coefficient
    # Thin films on steel are a molecule to 9e-4, with boundary friction in place of 0.18 there.
    np.testing.assert_allclose(computed / steel, (98 / 2) ** (2 / 3), rtol=1e-3)


def test_the_friction_of_a_pocket_needs_oil_and_surface_or_a_coefficient(scene: Scene) -> None:
    for missing in ("lubricant", "surface"):
        bare = replace(scene, **{missing: None})
        refused(lambda: friction_in_pocket(bare, load=LOAD, surface_speed=0.3), "not known")  # noqa: B023
        races = friction_in_pocket(replace(bare, friction_coefficient=0.07), load=LOAD, surface_speed=0.3)
        assert (float(races.coefficient), races.source) == (0.07, "friction.coefficient")
    assert scene.cage is not None
    own = replace(scene, cage=replace(scene.cage, friction_coefficient=0.0), friction_coefficient=0.07)
    found = friction_in_pocket(own, load=LOAD, surface_speed=0.3)
    assert (float(found.coefficient), found.source) == (0.0, "cage.friction_coefficient")
    refused(lambda: friction_in_pocket(replace(scene, cage=None), load=LOAD, surface_speed=0.3), "no [cage]")
    given = {"load": LOAD, "surface_speed": 0.3}
    refuses(lambda **wrong: friction_in_pocket(scene, **(given | wrong)), load=0.0, surface_speed=-0.1)
