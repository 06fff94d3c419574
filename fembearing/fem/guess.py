"""First guess of the contact ellipse. It sizes the first mesh; nothing else depends on it."""

from analytic.scene import Contact
from fembearing.fem.elasticity import require_elastic
from fembearing.fem.half_space import contact_modulus, hertz_ellipse


def expected_semi_axes(contact: Contact) -> tuple[float, float]:
    """Semi-axes in the rolling and the transverse direction, m: those of half spaces in place of the bodies.

    Raises InputError for a load, shape or material that no contact has.
    """
    require_elastic(contact)
    curvature_x = 1 / contact.ball_radius + 1 / contact.rolling_radius
    curvature_y = 1 / contact.ball_radius - 1 / contact.groove_radius
    return hertz_ellipse((curvature_x, curvature_y), load=contact.load, modulus=contact_modulus(contact))
