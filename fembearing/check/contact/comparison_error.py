"""The comparison error E against the validation uncertainty u_val, in the terms of [ASME2009].

E = S - D, of the simulation S less the datum D; u_val = sqrt(u_num^2 + u_input^2 + u_D^2). The model's error lies
within E +- u_val. Where |E| <= u_val the uncertainty hides it; otherwise it is resolved. All are half-widths at 95 %.
Here S is a closed form and D another model, finite elements: this is a cross-check, not a validation.
"""

import math
from dataclasses import dataclass

from analytic.rows import NotNegative
from fembearing.grid_convergence import Estimate

WHY = {  # the reason for each uncertainty
    "numerical": "0 (closed form, solved to round-off)",
    "input": "0 (dimensions, load and materials are the same in both models)",
    "reference": "that of the finite elements, from their meshes and their far boundary",
}


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """One quantity; all fields in its unit."""

    error: float  # E
    numerical: NotNegative  # u_num, of the simulation
    input: NotNegative  # u_input
    reference: NotNegative  # u_D
    total: NotNegative  # u_val
    resolved: bool  # |E| > u_val


def comparison_of(formula: float, part: Estimate) -> Comparison:
    """Compare a closed form's value with the estimate from the meshes."""
    return compared(formula - part.value, numerical=0.0, given=0.0, reference=part.total * abs(part.value))


def compared(error: float, *, numerical: float, given: float, reference: float) -> Comparison:
    """E against u_val, of u_num, u_input and u_D; all in the unit of the quantity."""
    total = math.hypot(numerical, given, reference)
    return Comparison(
        error=error, numerical=numerical, input=given, reference=reference, total=total, resolved=abs(error) > total
    )
