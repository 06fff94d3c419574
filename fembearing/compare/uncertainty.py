"""Numerical uncertainty of a quantity computed on three or more meshes.

Sources: P. J. Roache, Verification and Validation in Computational Science and Engineering (1998), for the
grid-convergence index; I. B. Celik et al., J. Fluids Eng. 130 (2008) 078001, for the observed order at
unequal ratios. Neither seen in the original; the formulas are checked on sequences of known order.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

FORMAL_ORDER = 2.0  # what the pressure's square-root edge allows in general; a higher one is observed but not relied on
REASONABLE_ORDER = (0.5, 5.0)  # quadratic cells give the approach order 4, the edge 2 to 3
SAFE, CAUTIOUS = 1.25, 3.0  # Roache's factors with an observed order and without


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A quantity on its finest mesh and how far it may be off. Uncertainties are relative half-widths."""

    values: tuple[float, ...]  # coarse to fine
    order: float | None  # observed; None where the meshes disagree without order
    richardson: float | None  # extrapolated value
    mesh: float  # from the grid-convergence index
    domain: float = 0.0  # from the size of the meshed region

    @property
    def value(self) -> float:
        return self.values[-1]

    @property
    def spread(self) -> float:
        """Largest difference between the last three meshes, relative."""
        last = self.values[-3:]
        return (max(last) - min(last)) / abs(self.value)

    @property
    def total(self) -> float:
        """Mesh and domain uncertainty added: nothing says that they are independent."""
        return self.mesh + self.domain


def estimate(values: Sequence[float], cell_sizes: Sequence[float]) -> Estimate:
    """Uncertainty of the last of `values`.

    values : on meshes from coarse to fine, any unit
    cell_sizes : representative, falling, same length, any unit
    The last three meshes decide.
    """
    fine = values[-1]
    order = observed_order(values[-3:], cell_sizes[-3:])
    change, ratio = abs(fine - values[-2]), cell_sizes[-2] / cell_sizes[-1]
    if order is None:
        richardson, change = None, max(values[-3:]) - min(values[-3:])
    else:
        richardson = fine + (fine - values[-2]) / (ratio**order - 1)
    reasonable = order is not None and REASONABLE_ORDER[0] <= order <= REASONABLE_ORDER[1]
    trusted = FORMAL_ORDER if order is None else min(order, FORMAL_ORDER)
    index = (SAFE if reasonable else CAUTIOUS) * change / (ratio**trusted - 1)
    return Estimate(values=tuple(values), order=order, richardson=richardson, mesh=index / abs(fine))


def observed_order(values: Sequence[float], cell_sizes: Sequence[float]) -> float | None:
    """p of value = exact + C size^p through three meshes; None where the values do not run one way or grow apart."""
    coarse, middle, fine = values
    sizes = np.asarray(cell_sizes, dtype=float) / cell_sizes[-1]
    first, second = middle - coarse, fine - middle
    if first * second <= 0:
        return None

    def misfit(order: float) -> float:
        powers = sizes**order
        return (powers[0] - powers[1]) / (powers[1] - powers[2]) - first / second

    low, high = 0.05, 20.0
    if misfit(low) * misfit(high) > 0:
        return None
    return float(brentq(misfit, low, high))
