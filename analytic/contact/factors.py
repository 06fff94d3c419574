"""Factors that turn Hertz's contact into one of the true geometry, at the same load.

The factors come from a finite-element solution, where they are the same for every load of a series, or from the fit in
`analytic.contact.finite_geometry`, which gives each load its own.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import HertzContact
from analytic.errors import require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Real
from analytic.scene import Array


class ContactFactors(NamedTuple):
    """Size, pressure and approach of one contact over those of Hertz at the same load; 1 leaves Hertz's value.

    Each factor is a number, or an array with one element for each load.
    """

    semi_axis_rolling: Real = 1.0  # factor on a
    semi_axis_transverse: Real = 1.0  # factor on b
    approach: Real = 1.0  # factor on delta
    peak_pressure: Real = np.nan  # NaN: pressure is a semi-ellipsoid over the new semi-axes


AS_HERTZ = ContactFactors()


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactCorrection:
    """The factors of both races; raises InputError for one that is not positive."""

    inner: ContactFactors = AS_HERTZ
    outer: ContactFactors = AS_HERTZ

    def __post_init__(self) -> None:
        for side in (self.inner, self.outer):
            given = side._asdict()
            if np.isnan(side.peak_pressure).all():
                del given["peak_pressure"]
            require_positive(**given)

    def mapped(self, change: Callable[[Array], Array]) -> "ContactCorrection":
        """A copy with a change applied to every factor that is an array.

        Parameters
        ----------
        change : callable
            Takes and returns an array of factors, dimensionless, of one shape.

        Returns
        -------
        ContactCorrection
            Factors that are numbers stay.
        """

        def side(factors: ContactFactors) -> ContactFactors:
            return ContactFactors(*(change(each) if isinstance(each, np.ndarray) else each for each in factors))

        return ContactCorrection(inner=side(self.inner), outer=side(self.outer))


class CorrectionNumbers(NamedTuple):
    """The factors of both races, for compiled formulas."""

    inner: ContactFactors
    outer: ContactFactors


@compiled
def corrected(contact: HertzContact, factors: ContactFactors) -> HertzContact:
    """Hertz's contact with the factors applied; the load and the exponent 3/2 stay.

    Semi-axes, approach and peak pressure are multiplied by their factors, and K = Q/delta^1.5. Without a factor for the
    peak pressure it is that of a semi-ellipsoid, p0 = 3 Q/(2 pi a b). Factors of 1 change no bit.
    """
    product, own = factors.semi_axis_rolling * factors.semi_axis_transverse, factors.peak_pressure
    return HertzContact(
        contact.semi_axis_x * factors.semi_axis_rolling,
        contact.semi_axis_y * factors.semi_axis_transverse,
        contact.peak_pressure / product if np.isnan(own) else contact.peak_pressure * own,
        contact.approach * factors.approach,
        contact.stiffness / (factors.approach * np.sqrt(factors.approach)),
    )
