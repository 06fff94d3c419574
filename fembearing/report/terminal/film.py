"""The film of a ball on a race as a table for a terminal of 80 characters."""

from rich.console import Console

from analytic.words import MICROMETRE, MILLINEWTON, RPM
from fembearing.quantities import METRIC
from fembearing.report.terminal.table import table_of
from fembearing.verify.film.scene_film import FilmNumbers

HEADS = ("quantity", "formula", "numerical", "formula/num.-1", "+-", "order")
SHOWN = {
    "central_film": ("central film", MICROMETRE),
    "minimum_film": ("minimum film", MICROMETRE),
    "rolling_force": ("rolling force", MILLINEWTON),
    "pressure_centre": ("pressure centre", MICROMETRE),
}


def print_film(out: Console, film: FilmNumbers) -> None:
    """Print each quantity by formula and by numerical solution."""
    speed = RPM.written(film.inner_speed, ".4g")
    title = f"Lubricated contact of the ball on the {film.pair} race: {film.load:.4g} N, inner ring at {speed}"
    table = table_of(HEADS, title=title, left=("quantity",), fixed=HEADS)
    for name, each in film.quantities.items():
        words, unit = SHOWN[name]
        table.add_row(
            f"{words}, {unit.name}",
            f"{each.formula * unit.factor:.4g}",
            f"{each.numerical * unit.factor:.4g}",
            f"{each.discrepancy:+.1%} {'*' if abs(each.discrepancy) > each.relative_uncertainty else ' '}",
            f"{each.relative_uncertainty:.1%}",
            "none" if each.order is None else f"{each.order:.1f}",
        )
    out.print(table)
    reach, check = film.reach, film.dissipated_force / film.rolling_force.numerical - 1
    out.print(
        "+-: numerical uncertainty, 95 %; *: the difference exceeds it; order: observed on three grids. Pressure "
        "centre: its distance ahead of the contact's centre.\n"
        f"M = {film.loading:.4g}, L = {film.thickening:.3g}, lambda = {film.ellipticity:.3g}; entrainment "
        f"{film.entrainment_speed:.4g} m/s; oil reaches {METRIC.length.written(reach.ahead, '.3g')} ahead and "
        f"{METRIC.length.written(reach.behind, '.3g')} behind; flooded, isothermal, smooth.\n"
        f"The force from the viscous dissipation, equal for incompressible oil, differs by {check:+.1%}. "
        f"{film.seconds:.1f} s\n",
        style="dim",
    )
