"""How well does one length of oil tell what starvation leaves? python validation/ehl/starved.py

Solves contacts of the range of the fit with oil from 1.3 semi-axes to the reach of the table, and compares the central
film and the rolling force, over those with the longest oil, with the factors of production. Writes starved.csv and
prints the largest differences.
"""

import csv
from dataclasses import dataclass, fields, replace
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.progress import track

from analytic.contact.rolling_contact import elliptic_contact
from analytic.errors import FembearingError
from analytic.oil.ehl_fit import inlet_length, regime_of
from analytic.oil.film import Inflow
from analytic.oil.starvation import starved_by_degree
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import numerical_film
from validation.ehl.run import FITTED, contact_of, drawn

HERE = Path(__file__).parent
SEED, CONTACTS = 71, 12  # no draws of the fit
DEGREES = (1.3, 1.4, 1.6, 2.0, 2.5, 4.0, 8.0)
REFINEMENT = 0.7
NEAR = 2.0  # degree below which both factors are worse


@dataclass(frozen=True, kw_only=True)
class Row:
    """One contact with little oil; factors over the contact with the longest oil."""

    loading: float  # M
    thickening: float  # L
    ellipticity: float  # lambda
    degree: float  # m
    film: float  # numerical
    film_factor: float  # of production
    rolling: float
    rolling_factor: float


def main() -> None:
    console = Console(stderr=True)
    rows: list[Row] = []
    lowest, highest = FITTED["loading"]
    points = [p for p in drawn(4 * CONTACTS, seed=SEED) if lowest <= p[0] * p[2] ** 0.5 <= highest][:CONTACTS]
    for point in track(points, "contacts", console=console):
        try:
            rows += rows_of(point)
        except FembearingError as trouble:
            console.print(str(trouble))
    with (HERE / "starved.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow([field.name for field in fields(Row)])
        writer.writerows([f"{value:.4g}" for value in vars(row).values()] for row in rows)
    for name, here in (
        ("m from 2", [r for r in rows if r.degree >= NEAR]),
        ("nearer", [r for r in rows if r.degree < NEAR]),
    ):
        for what, factor in (("film", "film_factor"), ("rolling", "rolling_factor")):
            off = np.array([getattr(row, factor) / getattr(row, what) - 1 for row in here])
            Console().print(f"{name}: {what} {off.min():+.1%} to {off.max():+.1%} in {off.size} contacts")


def rows_of(point: tuple[float, float, float]) -> list[Row]:
    """All degrees of one contact; a degree at which the solution does not settle is left out."""
    whole = contact_of(*point)
    assert whole is not None
    a, _ = whole.semi_axes
    flooded = numerical_film(whole, refinement=REFINEMENT)
    found = []
    for degree in DEGREES:
        if degree * a >= whole.reach.ahead:
            continue
        reach = Reach(ahead=degree * a, behind=whole.reach.behind, side=whole.reach.side)
        try:
            starved = numerical_film(replace(whole, reach=reach), refinement=REFINEMENT)
        except FembearingError:
            continue
        film_factor, rolling_factor = factors(whole, degree, flooded.central_film.value)
        found.append(
            Row(
                **dict(zip(("loading", "thickening", "ellipticity"), map(float, point), strict=True)),
                degree=degree,
                film=starved.central_film.value / flooded.central_film.value,
                film_factor=film_factor,
                rolling=starved.rolling_force.value / flooded.rolling_force.value,
                rolling_factor=rolling_factor,
            )
        )
    return found


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
    main()
