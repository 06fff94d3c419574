"""The comparison error E against the validation uncertainty u_val, in the terms of [ASME2009].

E = S - D, of the simulation S less the datum D; u_val = sqrt(u_num^2 + u_input^2 + u_D^2). The model's error lies
within E +- u_val. Where |E| <= u_val the uncertainty hides it; otherwise it is resolved. All are half-widths at 95 %.
Here S is a closed form and D another model, finite elements: this is a cross-check, not a validation.
"""

import math
from dataclasses import asdict, dataclass
from typing import Any

from fembearing.grid_convergence import Estimate

WHY = {  # the reason for each uncertainty
    "numerical": "0, as the closed form is solved to round-off",
    "input": "0, as both models take the same dimensions, load and materials, whose errors do not set them apart",
    "reference": "that of the finite elements, from their meshes and their far boundary",
}


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """One quantity; all fields in its unit."""

    error: float  # E
    numerical: float  # u_num, of the simulation
    input: float  # u_input
    reference: float  # u_D

    @property
    def total(self) -> float:
        """u_val."""
        return math.hypot(self.numerical, self.input, self.reference)

    @property
    def is_resolved(self) -> bool:
        return abs(self.error) > self.total

    def to_json(self) -> dict[str, Any]:
        return asdict(self) | {"total": self.total, "resolved": self.is_resolved}


def comparison_of(formula: float, part: Estimate) -> Comparison:
    """Compare a closed form's value with the estimate from the meshes."""
    return Comparison(error=formula - part.value, numerical=0.0, input=0.0, reference=part.total * abs(part.value))
