"""Value and numerical uncertainty of a quantity computed on two or more meshes.

Sources: P. J. Roache, Verification and Validation in Computational Science and Engineering (1998), for extrapolation
and the grid-convergence index; W. L. Oberkampf and C. J. Roy, Verification and Validation in Scientific Computing
(2010), for which factor and order the index takes; I. B. Celik et al., J. Fluids Eng. 130 (2008) 078001, for the
observed order at unequal ratios. None seen in the original; the formulas are checked on sequences of known order.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

# Chosen on random contacts whose exact answer is Hertz, seeds 0 to 59, 1000 to 1099, 5000 to 5019 and 7000 to 7099 of
# validation/benchmarks/intervals.py, which tries them on others.
HALF = 0.5
FINEST = 8e-5  # relative: nothing closer is claimed; what all meshes share does not show in their difference
UNSTEADY = 3.0  # order granted to a quantity that has no steady one, without moving its value
LEAST = 3e-4  # relative: added for such a quantity, whose last change may be small by chance
CAUTIOUS = 3.0  # Roache's factor where no order can be relied on
NEAR, TRUSTED = 0.1, 1.25  # of the formal order, and Roache's factor where the observed one is no farther from it
LEAST_ORDER = 0.5  # below, an observed order is that of no scheme
SETTLES = 0.5  # the last change, over the one before, from which meshes do not settle


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A quantity on its meshes and how far its value may be off. Uncertainties are relative half-widths."""

    values: tuple[float, ...]  # coarse to fine
    order: float | None  # observed; None where the values do not run one way or grow apart
    richardson: float | None  # extrapolated with the formal order; None where that is not known or not to be relied on
    mesh: float  # from the meshes
    settled: bool = True  # whether the meshes close in on a value
    index: float | None = None  # Roache's grid-convergence index, relative: shown beside `mesh`, and in no interval
    beyond: float = 0.0  # by which share an endless meshed region would raise the value
    domain: float = 0.0  # from the size of the meshed region

    @property
    def limit(self) -> float:
        """For vanishing cells, as far as that can be had."""
        return self.values[-1] if self.richardson is None else self.richardson

    @property
    def value(self) -> float:
        """For vanishing cells and an endless region."""
        return self.limit * (1 + self.beyond)

    @property
    def spread(self) -> float:
        """Largest difference between the last three meshes, relative."""
        last = self.values[-3:]
        return (max(last) - min(last)) / abs(self.value)

    @property
    def total(self) -> float:
        """Mesh and domain uncertainty added: nothing says that they are independent."""
        return self.mesh + self.domain


def estimate(
    values: Sequence[float], cell_sizes: Sequence[float], *, formal_order: float | None, singular: bool = False
) -> Estimate:
    """Value and uncertainty from the last three of `values`, or from two, which show no order and count as settled.

    values : on meshes from coarse to fine, any unit
    cell_sizes : representative, falling, same length, any unit
    formal_order : with which the error falls as soon as cells are small; None: not extrapolated, and the uncertainty is
        what order 3 would leave, and 0.03 % more
    singular : the solution has an edge that spoils every order: not extrapolated, and the uncertainty is 3 times the
        last change, and 0.03 % more
    Where the last change is not well below the one before, the uncertainty is 3 times the spread of the three, or what
    the observed order leaves where that is more.
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
        left = 0.0 if order is None else abs(change) / (ratio**order - 1)
        uncertainty = CAUTIOUS * max(left, max(values[-3:]) - min(values[-3:]))
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
        index=index,
    )


def grid_convergence_index(change: float, ratio: float, *, order: float, formal: float | None) -> float:
    """F_s |change| / (r^p - 1), of the finest of three meshes, relative.

    change : finest value less the one before, over the finest
    ratio : r, of their cell sizes, above 1
    order, formal : observed and formal; p is the formal one with F_s = 1.25 where they are near, else the lower of the
        two with F_s = 3, but no less than 0.5. Without a formal order F_s is 3 and p at most `UNSTEADY`.
    """
    if formal is not None and abs(order / formal - 1) <= NEAR:
        return TRUSTED * abs(change) / (ratio**formal - 1)
    return CAUTIOUS * abs(change) / (ratio ** min(max(order, LEAST_ORDER), formal or UNSTEADY) - 1)


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
