"""Numerical films over the regime of bearings, and what is fitted to them: python validation/ehl/run.py [--count N]

Solves lubricated contacts drawn over M, L and lambda, appends each to solutions.csv when it is done, and continues
where it stopped. Then it fits rolling force and central film and prints the errors of solutions that the fit has not
seen. --fit only fits.
"""

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Annotated, Any

import numpy as np
import typer
from scipy.stats.qmc import Halton

from analytic.contact.rolling_contact import elliptic_contact
from analytic.errors import ConvergenceError
from analytic.oil.film import central_film
from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import numerical_film
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import Paraboloid
from fembearing.fem.half_space import hertz_ellipse
from validation.study import Jobs, continued, out, read, run

HERE = Path(__file__).parent
TABLE, FIT, REACHES = HERE / "solutions.csv", HERE / "fit.json", HERE / "effective_reach.json"
PRODUCTION = HERE.parents[1] / "analytic" / "oil" / "ehl_coefficients.py"
VERSION = 1  # of the solver and of the settings below; rows of another one are solved again
SEED, COUNT = 20, 260
RANGES = {"loading": (5.0, 5e4), "thickening": (2.0, 20.0), "ellipticity": (0.02, 1.0)}  # M, L, lambda
# The oil, bodies and radius: M, L and lambda say all with Barus's law, and within 2 % with Roelands's
VISCOSITY, PRESSURE_VISCOSITY, MODULUS, RADIUS = 0.03, 2e-8, 113e9, 0.01  # Pa s, 1/Pa, E* in Pa, R_x in m
# Of the fit: M sqrt(lambda), L and lambda. Below, the pressure fills the whole inlet; most draws beyond do not settle
# on grids of this refinement.
FITTED = {"loading": (6.0, 4000.0), "thickening": (2.0, 20.0), "ellipticity": (0.02, 1.0)}
MIDDLE = (140.0, 6.3, 0.14)  # of these, about
MOST_PRESSURE = 4e9  # Pa: beyond, no steel bearing works
REACH = 12.0  # half lengths a of the contact, or of the thicker film: the rest of the inlet is a logarithm
REFINEMENT = 0.57  # of the first grid


# One solution, in Moes's numbers: films over R_x U^(1/2), forces over E' R_x^2 U. Its number in the sequence of draws;
# M, L and lambda; Hertz's pressure, Pa; reach X/(R_x U^(1/4)) of the oil, which is X/sqrt(lambda) wide to either side;
# relative uncertainties and orders of convergence; F^ at this reach; why there is no solution
COLUMNS = (
    *("number", "version", "loading", "thickening", "ellipticity", "peak_pressure", "reach"),
    *("central_film", "central_film_uncertainty", "central_film_order", "minimum_film", "minimum_film_uncertainty"),
    *("rolling_force", "rolling_force_uncertainty", "rolling_force_order", "dissipated_force", "seconds", "trouble"),
)
Row = SimpleNamespace


def drawn(count: int, *, seed: int = SEED) -> Array:
    """(count, 3) M, L and lambda: the first draws of a Halton sequence whose pressure a bearing can have."""
    lower, upper = np.log(np.array(list(RANGES.values()))).T
    points = np.exp(lower + (upper - lower) * Halton(3, seed=seed).random(4 * count))
    found = [each for each in points if contact_of(*each) is not None]
    return np.array(found[:count])


def fitted_draws(count: int, *, seed: int) -> list[tuple[float, float, float]]:
    """The first draws within the range of the fit; their M sqrt(lambda) is, too."""
    lowest, highest = FITTED["loading"]
    within = [tuple(each) for each in drawn(4 * count, seed=seed) if lowest <= each[0] * each[2] ** 0.5 <= highest]
    return within[:count]


def contact_of(loading: float, thickening: float, ellipticity: float) -> LubricatedContact | None:
    """The contact of given M, L and lambda; None where its pressure is beyond that of bearings."""
    relative = (thickening / (PRESSURE_VISCOSITY * 2 * MODULUS)) ** 4
    load = loading * relative**0.75 * 2 * MODULUS * RADIUS**2
    a, b = hertz_ellipse((1 / RADIUS, ellipticity / RADIUS), load=load, modulus=MODULUS)
    if 1.5 * load / (np.pi * a * b) > MOST_PRESSURE:
        return None
    thick = RADIUS * relative**0.25 * (2 + thickening**0.75) ** 0.5
    reach = REACH * float(np.hypot(a, thick))
    return LubricatedContact(
        load=load,
        modulus=MODULUS,
        shape=Paraboloid(rolling_radius=RADIUS, transverse_radius=RADIUS / ellipticity),
        speed=relative * MODULUS * RADIUS / VISCOSITY,
        oil=Oil(viscosity=VISCOSITY, pressure_viscosity=PRESSURE_VISCOSITY),
        reach=Reach(ahead=reach, behind=reach, side=max(reach / ellipticity**0.5, 2.5 * b)),
    )


def solved(task: tuple[int, tuple[float, float, float]]) -> Iterator[dict[str, Any]]:
    """The row of one draw, by its number."""
    number, point = task
    contact = contact_of(*point)
    assert contact is not None
    begun = time.perf_counter()
    row: dict[str, Any] = dict.fromkeys(COLUMNS, np.nan) | dict(zip(COLUMNS, (number, VERSION, *point), strict=False))
    row["peak_pressure"] = contact.peak_pressure
    row["reach"] = contact.reach.ahead / (RADIUS * contact.relative_speed**0.25)
    try:
        film = numerical_film(contact, refinement=REFINEMENT)
    except ConvergenceError as trouble:
        yield row | {"seconds": time.perf_counter() - begun, "trouble": str(trouble)}
        return
    scales = dict.fromkeys(("central_film", "minimum_film"), contact.film_scale)
    for name, scale in (scales | {"rolling_force": contact.force_scale}).items():
        part = getattr(film, name)
        row |= {name: part.value / scale, f"{name}_uncertainty": part.total, f"{name}_order": part.order or np.nan}
    del row["minimum_film_order"]
    row["dissipated_force"] = film.dissipated_force.value / contact.force_scale
    yield row | {"seconds": time.perf_counter() - begun, "trouble": ""}


def known() -> list[Row]:
    """The rows of this version in the table, with COLUMNS as attributes."""
    kinds: dict[str, Any] = dict.fromkeys(COLUMNS, float) | {"number": int, "version": int, "trouble": str}
    rows = [Row(**{name: kinds[name](text) for name, text in row.items()}) for row in read(TABLE)]
    return [row for row in rows if row.version == VERSION]


def loading_of(row: Row) -> float:
    """N = M sqrt(lambda): the loading of the ellipse."""
    return row.loading * row.ellipticity**0.5


def semi_axis_of(row: Row) -> float:
    """a/(R_x U^(1/4))."""
    contact = contact_of(row.loading, row.thickening, row.ellipticity)
    assert contact is not None
    return contact.semi_axes[0] / (RADIUS * contact.relative_speed**0.25)


def terms(rows: list[Row]) -> Array:
    """(rows, terms) of the fit, in the order in which `analytic.oil.ehl_fit` takes them."""
    values = np.array([[loading_of(row), row.thickening, row.ellipticity] for row in rows])
    n, thick, shape = np.log(values / MIDDLE).T
    cubic = [n**i * thick**j * shape**k for i in range(4) for j in range(4 - i) for k in range(4 - i - j)]
    return np.column_stack([*cubic, *(each / values[:, 0] for each in (np.ones_like(n), thick, shape))])


def formula_film(row: Row) -> float:
    """Moes's H by the closed formula for compressible oil, of which the fit is a correction: its asymptotes stay."""
    contact = contact_of(row.loading, row.thickening, row.ellipticity)
    assert contact is not None
    film = central_film(
        elliptic_contact(
            curvature_rolling=1 / RADIUS,
            curvature_transverse=row.ellipticity / RADIUS,
            load=contact.load,
            modulus=MODULUS,
        ),
        entrainment_speed=contact.speed,
        viscosity=VISCOSITY,
        pressure_viscosity=PRESSURE_VISCOSITY,
        compressible=True,
    )
    return float(film.thickness) / contact.film_scale


def fitted(target: Array, weight: Array, rows: list[Row]) -> tuple[Array, Array]:
    """Coefficients of the terms, and the relative error that each solution has in the fit to all others.

    weight : relative change of the quantity per change of the target. Errors are made even by it.
    """
    values = terms(rows)
    orthogonal, triangle = np.linalg.qr(values * weight[:, None])
    coefficients = np.linalg.solve(triangle, orthogonal.T @ (target * weight))
    leverage = (orthogonal**2).sum(axis=1)
    error = weight * (values @ coefficients - target) / (1 - leverage)
    return coefficients, error


def fit(rows: list[Row]) -> dict[str, Any]:
    """Both fits with their left-out errors.

    rolling force  F^ = S ln(1 + (X - a)/s),  s = R_x U^(1/4) exp(-G),  S = 6 pi/((3 + 2 lambda) sqrt(lambda))
    central film   H = H_formula exp(C);  G and C: the terms
    """
    ellipticity = np.array([row.ellipticity for row in rows])
    slope = 6 * np.pi / ((3 + 2 * ellipticity) * ellipticity**0.5)
    force = np.array([row.rolling_force for row in rows])
    beyond = np.array([row.reach - semi_axis_of(row) for row in rows])
    level = np.log(np.expm1(force / slope) / beyond)
    film = np.log([row.central_film / formula_film(row) for row in rows])
    result: dict[str, Any] = {"version": VERSION, "solutions": len(rows)}
    gain = -np.expm1(-force / slope) * slope / force  # relative change of the force per change of G
    for name, target, weight in (("rolling_force", level, gain), ("central_film", film, np.ones(len(rows)))):
        coefficients, error = fitted(target, weight, rows)
        result[name] = {
            "coefficients": [float(f"{each:.8g}") for each in coefficients],
            "left_out_rms": float(np.sqrt((error**2).mean())),
            "left_out_95": float(np.quantile(np.abs(error), 0.95)),
            "left_out_largest": float(np.abs(error).max()),
        }
    return result


def write_production(result: dict[str, Any]) -> None:
    """The module of coefficients that production takes."""
    reach = json.loads(REACHES.read_text())
    numbers = {
        "RANGES": FITTED,
        "MIDDLE": MIDDLE,
        "ROLLING": tuple(result["rolling_force"]["coefficients"]),
        "FILM": tuple(result["central_film"]["coefficients"]),
        "REACH_LOWER": tuple(reach["lower"]),
        "REACH_UPPER": tuple(reach["upper"]),
        "REACH": tuple(round(each, 7) for each in reach["coefficients"]),
    }
    text = '"""Coefficients of `analytic.oil.ehl_fit`, written by `python validation/ehl/run.py`."""\n\n'
    PRODUCTION.write_text(text + "".join(f"{name} = {each!r}\n" for name, each in numbers.items()))
    subprocess.run([sys.executable, "-m", "ruff", "format", "--quiet", PRODUCTION], check=True)


def main(count: int = COUNT, processes: Jobs = 1, fit_only: Annotated[bool, typer.Option("--fit")] = False) -> None:
    """Solve what is missing of the first `count` draws, then fit."""
    if not fit_only:
        draws = {(str(n), str(VERSION)): (n, tuple(point)) for n, point in enumerate(drawn(count))}
        continued(TABLE, COLUMNS, draws, solved, jobs=processes)
    lowest, highest = FITTED["loading"]
    rows = [row for row in known() if not row.trouble and lowest <= loading_of(row) <= highest]
    result = fit(rows)
    FIT.write_text(json.dumps(result, indent=1) + "\n")
    write_production(result)
    out.print_json(data=result)


if __name__ == "__main__":
    run(main)
