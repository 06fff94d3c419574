"""How well does one length of oil tell what starvation leaves? python validation/ehl/starved.py

Solves contacts of the range of the fit with oil from 1.3 semi-axes to the reach of the table, and compares the central
film and the rolling force, over those with the longest oil, with the factors of production. Writes starved.csv and
prints the largest differences.
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from rich.progress import track

from analytic.contact.rolling_contact import elliptic_contact
from analytic.errors import FembearingError
from analytic.oil.ehl_fit import inlet_length, regime_of
from analytic.oil.film import Inflow
from analytic.oil.starvation import starved_by_degree
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import numerical_film
from validation.ehl.run import contact_of, fitted_draws
from validation.study import numbers, out, progress, read, run, write

TABLE = Path(__file__).parent / "starved.csv"
SEED, CONTACTS = 71, 12  # no draws of the fit
DEGREES = (1.3, 1.4, 1.6, 2.0, 2.5, 4.0, 8.0)
REFINEMENT = 0.47  # of the first grid
NEAR = 2.0  # degree below which both factors are worse
# M, L, lambda, m; of film and rolling: numerical over that with the longest oil, and the factor of production
COLUMNS = ("loading", "thickening", "ellipticity", "degree", "film", "film_factor", "rolling", "rolling_factor")


def main() -> None:
    rows: list[dict[str, float]] = []
    for point in track(fitted_draws(CONTACTS, seed=SEED), "contacts", console=progress):
        try:
            rows += rows_of(point)
        except FembearingError as trouble:
            progress.print(str(trouble))
    write(rows, TABLE, COLUMNS, form=".4g")
    for name, is_near in (("m from 2", False), ("nearer", True)):
        here = [row for row in read(TABLE) if (float(row["degree"]) < NEAR) is is_near]
        for what in ("film", "rolling"):
            off = numbers(here, f"{what}_factor") / numbers(here, what) - 1
            out.print(f"{name}: {what} {off.min():+.1%} to {off.max():+.1%} in {off.size} contacts")


def rows_of(point: tuple[float, float, float]) -> Iterator[dict[str, float]]:
    """All degrees of one contact; a degree at which the solution does not settle is left out."""
    whole = contact_of(*point)
    assert whole is not None
    a, _ = whole.semi_axes
    flooded = numerical_film(whole, refinement=REFINEMENT)
    for degree in DEGREES:
        if degree * a >= whole.reach.ahead:
            continue
        reach = Reach(ahead=degree * a, behind=whole.reach.behind, side=whole.reach.side)
        try:
            starved = numerical_film(replace(whole, reach=reach), refinement=REFINEMENT)
        except FembearingError:
            continue
        film, rolling = factors(whole, degree, flooded.central_film.value)
        left = starved.central_film.value / flooded.central_film.value
        force = starved.rolling_force.value / flooded.rolling_force.value
        yield dict(zip(COLUMNS, (*map(float, point), degree, left, film, force, rolling), strict=True))


def factors(whole: LubricatedContact, degree: float, film: float) -> tuple[float, float]:
    """Of film and rolling by production; film : flooded, m."""
    rolling, across = whole.shape.radii
    contact = elliptic_contact(
        curvature_rolling=1 / rolling, curvature_transverse=1 / across, load=whole.load, modulus=whole.modulus
    )
    inflow = Inflow(whole.speed, whole.oil.viscosity, whole.oil.pressure_viscosity, True, np.inf)
    length = inlet_length(contact, inflow, regime_of(contact, inflow))
    starved = starved_by_degree(contact, degree, film, whole.reach.ahead, length)
    return starved.film_factor, starved.rolling_factor


if __name__ == "__main__":
    run(main)
