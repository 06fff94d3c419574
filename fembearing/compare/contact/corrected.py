"""Hertz corrected for finite geometry: the production model's next rung, on a contact that its fit has not seen."""

from dataclasses import dataclass

from analytic.contact.finite_geometry import contact_shape, finite_geometry_factors
from analytic.scene import Contact
from fembearing.fem.measure import Quantities


@dataclass(frozen=True, kw_only=True)
class CorrectedHertz:
    """The corrected values, and how far off the fit says that they may be."""

    quantities: Quantities
    uncertainty: dict[str, float]  # keyed by quantity, relative half-width, 95 %


def corrected_hertz(contact: Contact, *, hertz: Quantities) -> tuple[CorrectedHertz | None, tuple[str, ...]]:
    """The corrected contact, or None and why the fit does not reach it.

    hertz : what is corrected
    """
    found = finite_geometry_factors(contact_shape(contact))
    if not found.covered:
        return None, tuple(f"{contact.pair}: {warning}" for warning in found.warnings)
    factors = {name: float(getattr(found.factors, name)) for name in found.uncertainty}
    values = {name: factor * getattr(hertz, name) for name, factor in factors.items()}
    uncertainty = {name: float(half_width) for name, half_width in found.uncertainty.items()}
    return CorrectedHertz(
        quantities=Quantities(**values, stiffness=hertz.stiffness * factors["approach"] ** -1.5),
        uncertainty=uncertainty | {"stiffness": 1.5 * uncertainty["approach"]},  # K = Q/delta^1.5
    ), ()
