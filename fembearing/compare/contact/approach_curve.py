"""How far ball and race approach as the load grows: by Hertz, and by Hertz corrected for finite geometry."""

from dataclasses import dataclass, replace

import numpy as np

from analytic.scene import Array, Contact
from fembearing.compare.contact.corrected import corrected_hertz
from fembearing.fem.measure import Quantities

POINTS = 25
LEAST, MOST = 0.05, 1.5  # of the load that was solved


@dataclass(frozen=True, kw_only=True, eq=False)
class ApproachCurve:
    """Approach over load; NaN where the correction's fit does not reach."""

    load: Array  # (n,) of the ball, N, rising
    hertz: Array  # (n,) m
    corrected: Array  # (n,) m
    uncertainty: Array  # (n,) of the corrected, relative half-width, 95 %


def approach_over_load(contact: Contact, *, hertz: Quantities, correctable: bool) -> ApproachCurve:
    """From a twentieth of the contact's load to half more.

    hertz : of the contact under its own load: semi-axes, peak pressure and approach are powers of the load
    correctable : whether the correction is of such a contact, ball and race in their true shapes
    """
    factor = np.linspace(LEAST, MOST, POINTS)
    corrected, uncertainty = np.full(POINTS, np.nan), np.full(POINTS, np.nan)
    for point, times in enumerate(factor if correctable else ()):
        scaled = Quantities(
            semi_axis_rolling=hertz.semi_axis_rolling * times ** (1 / 3),
            semi_axis_transverse=hertz.semi_axis_transverse * times ** (1 / 3),
            peak_pressure=hertz.peak_pressure * times ** (1 / 3),
            approach=hertz.approach * times ** (2 / 3),
            stiffness=hertz.stiffness,
        )
        found, _ = corrected_hertz(replace(contact, load=contact.load * float(times)), hertz=scaled)
        if found is not None:
            corrected[point], uncertainty[point] = found.quantities.approach, found.uncertainty["approach"]
    return ApproachCurve(
        load=contact.load * factor,
        hertz=hertz.approach * factor ** (2 / 3),
        corrected=corrected,
        uncertainty=uncertainty,
    )
