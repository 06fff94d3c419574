"""Film and rolling force of a lubricated contact: three grids of one ratio, extrapolated, with their uncertainty."""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from analytic.errors import ConvergenceError
from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.solver import RATIO, Solution, require_few_cells, solve_on_grids
from fembearing.grid_convergence import Estimate, observed_order

USUAL = 0.48  # refinement of the first grid
FORMAL = 2.0  # order of the scheme
LEAST_ORDER, MOST_ORDER = 1.0, 3.0  # to which an observed order is held
SHARE = 0.5  # of the last correction that is uncertain even where the order is the formal one
LEAST = 1e-3  # relative: an error common to all grids does not show in their differences
# Share of the central film's last correction that every quantity is uncertain by: errors of two signs cancel in the
# rolling force, and then its own correction is small by chance. The error of the force was at most 0.17 of it where
# this was chosen; validation/ehl/stated_uncertainty.py tests it on other contacts.
OF_FILM = 0.23


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
    grid_seconds: tuple[float, ...]  # until each grid was solved

    @property
    def seconds(self) -> float:
        """Of all grids."""
        return self.grid_seconds[-1]


def numerical_films(contact: LubricatedContact, *, refinement: float = USUAL) -> Iterator[NumericalFilm]:
    """Solve a contact on three grids and extrapolate; then with one finer grid each, as far as Newton's method settles.

    refinement : of the first grid: cells over those of the usual sizes, dimensionless
    Raises ConvergenceError where it does not settle on three grids, with M, L and lambda in its message, and InputError
    where they would have too many cells.
    """
    begun = time.perf_counter()
    require_few_cells(contact, refinement * RATIO**2)
    solutions: list[Solution] = []
    seconds: list[float] = []
    try:
        for solution in solve_on_grids(contact, refinement):
            solutions.append(solution)
            seconds.append(time.perf_counter() - begun)
            if len(solutions) > 2:
                yield NumericalFilm(
                    contact=contact,
                    **estimates_of(solutions[-3:]),
                    x=solution.grid.x,
                    y=solution.grid.y,
                    pressure=solution.pressure,
                    film=solution.film,
                    grid_seconds=tuple(seconds),
                )
    except ConvergenceError:
        if len(solutions) < 3:
            raise


def numerical_film(contact: LubricatedContact, *, refinement: float = USUAL) -> NumericalFilm:
    """The first of `numerical_films`, on three grids."""
    return next(numerical_films(contact, refinement=refinement))


def estimates_of(solutions: Sequence[Solution]) -> dict[str, Estimate]:
    """Each quantity of three grids, coarse to fine, extrapolated."""
    sizes = RATIO**2, RATIO, 1.0
    film = extrapolation(tuple(each.central_film for each in solutions), sizes)
    least = LEAST + OF_FILM * abs(1 - film.values[-1] / film.value)
    others = {
        name: extrapolation(tuple(getattr(each, name) for each in solutions), sizes, least=least)
        for name in ("minimum_film", "rolling_force", "dissipated_force", "pressure_centre")
    }
    low = others["minimum_film"]
    if low.value > film.value:  # on coarse grids: no film is thinnest in the centre
        low = replace(low, richardson=film.value)
    # The place of the least film moves with the cells, and its last change may be small by chance.
    change = abs(low.values[1] - low.values[0]) / RATIO / abs(low.value)
    return {"central_film": film, **others, "minimum_film": replace(low, mesh=max(low.mesh, change))}


def extrapolation(values: tuple[float, ...], sizes: tuple[float, ...], *, least: float = LEAST) -> Estimate:
    """A quantity on three grids, coarse to fine, for vanishing cells, by the formal order.

    sizes : of the cells, descending, any unit;  least : relative uncertainty
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
    return Estimate(
        values=values, order=order, richardson=limit, mesh=max(uncertain / abs(limit) + LEAST, least), settled=settled
    )
