"""What a contact of the true geometry changes in Hertz's: factors at the same load.

They come from outside, for example from a finite-element solution, and are the same for every load of a series.
"""

from dataclasses import dataclass

from analytic.errors import require_positive
from analytic.hertz import HertzContact


@dataclass(frozen=True, kw_only=True)
class ContactFactors:
    """One contact's size and approach over Hertz's at the same load; 1 leaves Hertz's as it is."""

    semi_axis_rolling: float = 1.0
    semi_axis_transverse: float = 1.0
    approach: float = 1.0

    def __post_init__(self) -> None:
        require_positive(
            semi_axis_rolling=self.semi_axis_rolling,
            semi_axis_transverse=self.semi_axis_transverse,
            approach=self.approach,
        )


@dataclass(frozen=True, kw_only=True)
class ContactCorrection:
    """The factors of both races."""

    inner: ContactFactors = ContactFactors()
    outer: ContactFactors = ContactFactors()


def corrected_contact(contact: HertzContact, factors: ContactFactors) -> HertzContact:
    """Hertz's contact with the factors applied; load, shape of the pressure (semi-ellipsoid) and exponent 3/2 stay.

    semi-axes and approach times their factors, p0 = 3 Q/(2 pi a b), K = Q/delta^1.5; factors of 1 change no bit.
    """
    return HertzContact(
        semi_axis_x=contact.semi_axis_x * factors.semi_axis_rolling,
        semi_axis_y=contact.semi_axis_y * factors.semi_axis_transverse,
        peak_pressure=contact.peak_pressure / (factors.semi_axis_rolling * factors.semi_axis_transverse),
        approach=contact.approach * factors.approach,
        stiffness=contact.stiffness * factors.approach**-1.5,
    )
