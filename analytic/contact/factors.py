"""Factors that turn Hertz's contact into one of the true geometry, at the same load.

The factors come from a finite-element solution, where they are the same for every load of a series, or from the fit in
`analytic.contact.finite_geometry`, which gives each load its own.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import HertzNumbers
from analytic.errors import require_positive
from analytic.numerics.compilation import compiled
from analytic.scene import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactFactors:
    """Size, pressure and approach of one contact over those of Hertz at the same load; 1 leaves Hertz's value.

    Each factor is a number, or an array with one element for each load.
    """

    semi_axis_rolling: float | Array = 1.0  # factor on a
    semi_axis_transverse: float | Array = 1.0  # factor on b
    approach: float | Array = 1.0  # factor on delta
    peak_pressure: float | Array | None = None  # None: pressure is a semi-ellipsoid over the new semi-axes

    def __post_init__(self) -> None:
        given = {name: value for name, value in vars(self).items() if value is not None}
        require_positive(**given)


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactCorrection:
    """The factors of both races."""

    inner: ContactFactors = ContactFactors()
    outer: ContactFactors = ContactFactors()

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
            return ContactFactors(
                **{n: change(v) if isinstance(v, np.ndarray) else v for n, v in vars(factors).items()}
            )

        return ContactCorrection(inner=side(self.inner), outer=side(self.outer))


class FactorNumbers(NamedTuple):
    """One `ContactFactors` in numbers, for compiled formulas."""

    semi_axis_rolling: float
    semi_axis_transverse: float
    approach: float
    peak_pressure: float  # NaN: that of a semi-ellipsoid


class CorrectionNumbers(NamedTuple):
    """The factors of both races."""

    inner: FactorNumbers
    outer: FactorNumbers


@compiled
def corrected(contact: HertzNumbers, factors: FactorNumbers) -> HertzNumbers:
    """Hertz's contact with the factors applied; the load and the exponent 3/2 stay.

    Semi-axes, approach and peak pressure are multiplied by their factors, and K = Q/delta^1.5. Without a factor for the
    peak pressure it is that of a semi-ellipsoid, p0 = 3 Q/(2 pi a b). Factors of 1 change no bit.
    """
    product, own = factors.semi_axis_rolling * factors.semi_axis_transverse, factors.peak_pressure
    return HertzNumbers(
        contact.semi_axis_x * factors.semi_axis_rolling,
        contact.semi_axis_y * factors.semi_axis_transverse,
        contact.peak_pressure / product if np.isnan(own) else contact.peak_pressure * own,
        contact.approach * factors.approach,
        contact.stiffness / (factors.approach * np.sqrt(factors.approach)),
    )


def factor_fields(factors: ContactFactors) -> tuple[float | Array, ...]:
    """The factors in the order of `FactorNumbers`."""
    values = vars(factors) | {"peak_pressure": np.nan if factors.peak_pressure is None else factors.peak_pressure}
    return tuple(values[name] for name in FactorNumbers._fields)
