"""Approach of ball and race over the load: by Hertz, and by Hertz corrected for finite geometry."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from annotated_types import MinLen

from analytic.rows import NotNegative, Positive, require_one_length
from analytic.scene import Contact
from fembearing.check.contact.hertz import corrected_hertz
from fembearing.fem.measure import Quantities

POINTS = 25
LEAST, MOST = 0.05, 1.5  # shares of the load that was solved


@dataclass(frozen=True, kw_only=True)
class ApproachCurve:
    """Approach over load; None outside the range of the correction's fit."""

    load: Annotated[tuple[Positive, ...], MinLen(1)]  # of the ball, N, ascending
    hertz: tuple[Positive, ...]  # m
    corrected: tuple[Positive | None, ...]  # m
    uncertainty: tuple[NotNegative | None, ...]  # of the corrected approach, relative half-width, 95 %

    def __post_init__(self) -> None:
        """Raises ValueError for lists of different lengths."""
        require_one_length(*vars(self).values())


def approach_over_load(contact: Contact, *, hertz: Quantities, correctable: bool) -> ApproachCurve:
    """The curve from 0.05 to 1.5 times the contact's load.

    hertz : the contact under its own load; semi-axes, peak pressure and approach are powers of the load
    correctable : whether the correction for finite geometry applies to this contact
    """
    factor = np.linspace(LEAST, MOST, POINTS)
    corrected: list[float | None] = [None] * POINTS
    uncertainty: list[float | None] = [None] * POINTS
    for point, times in enumerate(factor if correctable else ()):
        scaled = Quantities(
            semi_axis_rolling=hertz.semi_axis_rolling * times ** (1 / 3),
            semi_axis_transverse=hertz.semi_axis_transverse * times ** (1 / 3),
            peak_pressure=hertz.peak_pressure * times ** (1 / 3),
            approach=hertz.approach * times ** (2 / 3),
            stiffness=hertz.stiffness,
        )
        fitted, _ = corrected_hertz(replace(contact, load=contact.load * float(times)), hertz=scaled)
        if fitted is not None:
            corrected[point], uncertainty[point] = fitted.quantities.approach, fitted.uncertainty["approach"]
    return ApproachCurve(
        load=tuple((contact.load * factor).tolist()),
        hertz=tuple((hertz.approach * factor ** (2 / 3)).tolist()),
        corrected=tuple(corrected),
        uncertainty=tuple(uncertainty),
    )
