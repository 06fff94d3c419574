"""Value and numerical uncertainty of a quantity computed on two or more meshes.

Sources: [Roache1998] for extrapolation and the grid-convergence index; [Oberkampf2010] for the factor and the order of
the index; [Celik2008] for the observed order at unequal ratios. The formulas are checked on sequences of known order.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from analytic.rows import NotNegative

# Chosen on random contacts whose exact answer is Hertz: seeds 0 to 59, 1000 to 1099, 5000 to 5019 and 7000 to 7099 of
# validation/benchmarks/intervals.py, which tests them on others.
HALF = 0.5
FINEST = (
    8e-5  # relative: the least uncertainty claimed; an error common to all meshes does not show in their differences
)
UNSTEADY = 3.0  # order assumed for the uncertainty of a quantity without a steady order; its value is not extrapolated
LEAST = 3e-4  # relative: added for such a quantity, as its last change may be small by chance
CAUTIOUS = 3.0  # Roache's factor where the order is not reliable
NEAR, TRUSTED = 0.1, 1.25  # Roache's factor 1.25 where the observed order is this close to the formal one, relative
LEAST_ORDER = 0.5  # an observed order below this is not used
SETTLES = 0.5  # meshes converge if the last change is below this share of the one before


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A quantity on its meshes, with its uncertainties as relative half-widths."""

    values: tuple[float, ...]  # coarse to fine, in the unit of the quantity
    order: float | None  # observed; None where the values are not monotonic or diverge
    richardson: float | None  # extrapolated; None where the order is not reliable
    mesh: NotNegative  # relative, from the meshes
    settled: bool = True  # whether the meshes converge
    # Roache's, relative: shown with `mesh`, part of no interval.
    grid_convergence_index: float | None = None
    beyond: float = 0.0  # share by which what lies outside the meshed block raises the value
    domain: NotNegative = 0.0  # relative, from the size of the meshed region

    @property
    def limit(self) -> float:
        """The value for vanishing cells, in the unit of the quantity; if not extrapolated, on the finest mesh."""
        return self.values[-1] if self.richardson is None else self.richardson

    @property
    def value(self) -> float:
        """The value for vanishing cells, with what lies outside the block, in the unit of the quantity."""
        return self.limit * (1 + self.beyond)

    @property
    def spread(self) -> float:
        """Largest difference between the last three meshes, relative."""
        last = self.values[-3:]
        return (max(last) - min(last)) / abs(self.value)

    @property
    def total(self) -> float:
        """Mesh and domain uncertainty, relative, in quadrature: cells and the size of the block err independently."""
        return math.hypot(self.mesh, self.domain)

    @property
    def uncertainty(self) -> float:
        """The same in the unit of the quantity."""
        return self.total * abs(self.value)


def mesh_allowed(accuracy: float, *, domain: float) -> float:
    """Mesh uncertainty with which the whole meets the accuracy, or half of the domain's: finer meshes hardly help.

    accuracy : of a quantity;  domain : its uncertainty from the size of the meshed region; all relative
    """
    return max(math.sqrt(max(accuracy**2 - domain**2, 0.0)), domain / 2)


def estimate(
    values: Sequence[float], cell_sizes: Sequence[float], *, formal_order: float | None, singular: bool = False
) -> Estimate:
    """Value and uncertainty from the last three of `values`, or from two, which show no order and count as converged.

    values : on meshes from coarse to fine, any unit
    cell_sizes : representative, descending, same length, any unit
    formal_order : of the error in the cell size; None: not extrapolated, and the uncertainty is the error that order 3
        would leave, plus 0.03 %
    singular : an edge of the solution spoils every order: not extrapolated, and the uncertainty is 3 times the last
        change, plus 0.03 %
    Where the last change is not below half of the one before, the uncertainty is 3 times the spread of the three, or
    3 times the error that the observed order leaves if that is larger.
    """
    *_, middle, fine = values
    change = fine - middle
    order, settled = None, True
    if len(values) > 2:
        order = observed_order(values[-3:], cell_sizes[-3:])
        settled = abs(change) < SETTLES * abs(middle - values[-3]) or change == 0
    ratio = cell_sizes[-2] / cell_sizes[-1]
    step = change / (ratio ** (formal_order or UNSTEADY) - 1)
    index = None if order is None else grid_convergence_index(change / fine, ratio, order=order, formal=formal_order)
    richardson = None
    if not settled:
        error = 0.0 if order is None else abs(change) / (ratio**order - 1)
        uncertainty = CAUTIOUS * max(error, max(values[-3:]) - min(values[-3:]))
    elif singular:
        uncertainty = CAUTIOUS * abs(change) + LEAST * abs(fine)
    elif formal_order is None:
        uncertainty = abs(step) + LEAST * abs(fine)
    else:
        richardson = fine + step
        uncertainty = HALF * abs(step)
    return Estimate(
        values=tuple(values),
        order=order,
        richardson=richardson,
        mesh=uncertainty / abs(fine) + FINEST,
        settled=settled,
        grid_convergence_index=index,
    )


def grid_convergence_index(change: float, ratio: float, *, order: float, formal: float | None) -> float:
    """F_s |change| / (r^p - 1) of the finest of three meshes, relative.

    change : finest value less the one before, over the finest
    ratio : r, of their cell sizes, above 1
    order, formal : observed and formal. Where they are near, p is the formal one and F_s = 1.25; otherwise p is the
        lower of the two, but at least 0.5, and F_s = 3. Without a formal order p is at most `UNSTEADY` and F_s = 3.
    """
    if formal is not None and abs(order / formal - 1) <= NEAR:
        return TRUSTED * abs(change) / (ratio**formal - 1)
    return CAUTIOUS * abs(change) / (ratio ** min(max(order, LEAST_ORDER), formal or UNSTEADY) - 1)


def observed_order(values: Sequence[float], cell_sizes: Sequence[float]) -> float | None:
    """p of value = exact + C size^p through three meshes; None where the values are not monotonic or diverge."""
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
    from scipy.optimize import brentq  # a tenth of a second to import, and only unequal meshes need it

    return float(brentq(misfit, low, high))
