"""Film and rolling force of a lubricated contact: three grids of one ratio, extrapolated, with their uncertainty."""

import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.solver import Solution, solve_on_grids
from fembearing.grid_convergence import Estimate, observed_order

RATIO = 1.45  # of the cells of two grids
USUAL = 0.85  # refinement of the middle one
FORMAL = 2.0  # order of the scheme
LEAST_ORDER, MOST_ORDER = 1.0, 3.0  # to which an observed order is held
SHARE = 0.5  # of the last correction that is uncertain even where the order is the formal one
LEAST = 1e-3  # relative: an error common to all grids does not show in their differences
Quantity = Callable[[Solution], float]


@dataclass(frozen=True, kw_only=True, eq=False)
class NumericalFilm:
    """What the numerical solution of a lubricated contact says; maps are those of the finest grid, y >= 0."""

    contact: LubricatedContact
    central_film: Estimate  # m
    minimum_film: Estimate  # m
    rolling_force: Estimate  # F1, on each surface against its motion, N
    dissipated_force: Estimate  # F3, N: a second way to the same force
    pressure_centre: Estimate  # how far it lies ahead of the contact's centre, m
    x: Array  # (columns,) m, towards the outlet
    y: Array  # (rows,) m
    pressure: Array  # (columns, rows), Pa
    film: Array  # (columns, rows), m
    seconds: float

    @property
    def disagreement(self) -> float:
        """F3 over F1, less 1: they are equal without error of the grids."""
        return self.dissipated_force.value / self.rolling_force.value - 1


def numerical_film(contact: LubricatedContact, *, refinement: float = USUAL) -> NumericalFilm:
    """Solve a contact on three grids and extrapolate.

    Parameters
    ----------
    contact : LubricatedContact
        The problem, SI.
    refinement : float
        Of the middle grid: cells over those of the usual sizes, dimensionless.

    Returns
    -------
    NumericalFilm
        Each quantity with its relative uncertainty, and the maps of the finest grid.

    Raises
    ------
    ConvergenceError
        Where Newton's method does not settle; the message names M, L and lambda.
    """
    begun = time.perf_counter()
    refinements = refinement / RATIO, refinement, refinement * RATIO
    solutions = list(solve_on_grids(contact, refinements))
    sizes = tuple(1 / each for each in refinements)

    def extrapolated(quantity: Quantity) -> Estimate:
        return extrapolation(tuple(map(quantity, solutions)), sizes)

    finest = solutions[-1]
    return NumericalFilm(
        contact=contact,
        central_film=extrapolated(lambda each: each.central_film),
        minimum_film=extrapolated(lambda each: each.minimum_film),
        rolling_force=extrapolated(lambda each: each.rolling_force),
        dissipated_force=extrapolated(lambda each: each.dissipated_force),
        pressure_centre=extrapolated(lambda each: each.pressure_centre),
        x=finest.grid.x,
        y=finest.grid.y,
        pressure=finest.pressure,
        film=finest.film,
        seconds=time.perf_counter() - begun,
    )


def extrapolation(values: tuple[float, ...], sizes: tuple[float, ...]) -> Estimate:
    """A quantity on three grids, coarse to fine, for vanishing cells, by the formal order.

    sizes : of the cells, descending, any unit
    The uncertainty is half of the last correction, or what the observed order, held to 1 to 3, would change, if that is
    larger; where the values are not monotone, the last change.
    """
    coarse, middle, fine = values
    ratio = sizes[-2] / sizes[-1]
    order = observed_order(values, sizes)
    change = fine - middle
    limit = fine + change / (ratio**FORMAL - 1)
    uncertain = SHARE * abs(limit - fine)
    if order is None:
        uncertain = max(uncertain, abs(change), abs(middle - coarse) / ratio**FORMAL)
    else:
        held = min(max(order, LEAST_ORDER), MOST_ORDER)
        uncertain = max(uncertain, abs(fine + change / (ratio**held - 1) - limit))
    settled = bool(np.abs(change) <= np.abs(middle - coarse))
    return Estimate(values=values, order=order, richardson=limit, mesh=uncertain / abs(limit) + LEAST, settled=settled)
