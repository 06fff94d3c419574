"""First guess of the contact ellipse. It sizes the first mesh; nothing else depends on it."""

import numpy as np

from analytic.scene import Contact, Material
from fembearing.fem.elasticity import require_elastic


def plane_strain_modulus(material: Material) -> float:
    """E/(1 - nu^2), Pa."""
    return material.youngs_modulus / (1 - material.poisson_ratio**2)


def expected_semi_axes(contact: Contact) -> tuple[float, float]:
    """Semi-axes in the rolling and the transverse direction, m, within a few per cent of Hertz's.

    Raises InputError for a load, shape or material that no contact has.
    Source: the fits of [Brewe1977], as printed in many textbooks.
    """
    require_elastic(contact)
    curvature_x = 1 / contact.ball_radius + 1 / contact.rolling_radius
    curvature_y = 1 / contact.ball_radius - 1 / contact.groove_radius
    ratio = max(curvature_x / curvature_y, curvature_y / curvature_x)
    elongation = ratio ** (2 / np.pi)
    integral = 1 + (np.pi / 2 - 1) / ratio
    compliance = 1 / plane_strain_modulus(contact.ball_material) + 1 / plane_strain_modulus(contact.race_material)
    major = (3 * elongation**2 * integral * contact.load * compliance / (np.pi * (curvature_x + curvature_y))) ** (
        1 / 3
    )
    minor = major / elongation
    return (minor, major) if curvature_x >= curvature_y else (major, minor)
