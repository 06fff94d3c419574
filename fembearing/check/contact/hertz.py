"""The production model of a contact: Hertz, and Hertz corrected for finite geometry."""

from dataclasses import dataclass

from analytic.contact.finite_geometry import contact_shape, finite_geometry_factors
from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.scene import Contact
from fembearing.fem.measure import Quantities


@dataclass(frozen=True, kw_only=True)
class CorrectedHertz:
    """The corrected quantities with the uncertainty of the fitted correction."""

    quantities: Quantities
    uncertainty: dict[str, float]  # keyed by quantity, relative half-width, 95 %


def hertz_quantities(contact: Contact) -> Quantities:
    """Hertz's semi-axes, peak pressure, approach and stiffness of a contact."""
    curvature_x, curvature_y = relative_curvatures(contact)
    ellipse = hertz_contact(
        curvature_x=curvature_x,
        curvature_y=curvature_y,
        load=contact.load,
        modulus=contact_modulus(contact.ball_material, contact.race_material),
    )
    return Quantities(
        semi_axis_rolling=float(ellipse.semi_axis_x),
        semi_axis_transverse=float(ellipse.semi_axis_y),
        peak_pressure=float(ellipse.peak_pressure),
        approach=float(ellipse.approach),
        stiffness=float(ellipse.stiffness),
    )


def corrected_hertz(contact: Contact, *, hertz: Quantities) -> tuple[CorrectedHertz | None, tuple[str, ...]]:
    """The corrected contact, or None with the reasons why the contact is outside the range of the fit.

    hertz : the quantities to correct
    """
    correction = finite_geometry_factors(contact_shape(contact))
    if not correction.covered:
        return None, tuple(f"{contact.pair}: {warning}" for warning in correction.warnings)
    factors = {name: float(getattr(correction.factors, name)) for name in correction.uncertainty}
    values = {name: factor * getattr(hertz, name) for name, factor in factors.items()}
    uncertainty = {name: float(half_width) for name, half_width in correction.uncertainty.items()}
    return CorrectedHertz(
        quantities=Quantities(**values, stiffness=hertz.stiffness * factors["approach"] ** -1.5),
        uncertainty=uncertainty | {"stiffness": 1.5 * uncertainty["approach"]},  # K = Q/delta^1.5
    ), ()
