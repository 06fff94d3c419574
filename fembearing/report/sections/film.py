"""The film of a ball on a race, by formula and by numerical solution."""

from collections.abc import Sequence

from analytic.units import METRIC, Units, speed_words
from analytic.words import MILLINEWTON
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.film.scene_film import FilmNumbers
from fembearing.report.document import Head, Section, Table, Text, table_of
from fembearing.report.phrases import shown
from fembearing.report.report import Report

WORDS = (
    "This appendix compares the formulas of film and rolling with a numerical solution of the lubricated contact: "
    "Reynolds' equation with the oil's viscosity and density under pressure, elastic half spaces, and the true circles "
    "of ball and race. The verdicts compare the differences with the errors of the formulas in the uncertainty of the "
    "torque. The minimum film, which the torque does not take, has its own, by the error of the central film."
)
BODIES = {"half-space": "elastic half spaces", "meshed": "ball and race of true shape, by finite elements"}


def film_table(film: FilmNumbers, units: Units = METRIC) -> Table:
    """Each quantity with the difference of what the torque takes."""
    small = units.small_length
    force = MILLINEWTON if units is METRIC else units.force
    names = {
        "central_film": ("central film", small),
        "minimum_film": ("minimum film", small),
        "rolling_force": ("rolling force", force),
        "pressure_centre": ("pressure centre", small),
    }
    speed = speed_words(film.inner_speed, units)
    load = units.force.written(film.load, ".4g")
    heads = [
        Head("quantity", "name"),
        Head("formula"),
        Head("model"),
        Head("numerical", short="num."),
        Head("model/num.-1", fixed=True),
    ]
    heads += [Head("+-"), Head("order")]
    rows = [
        [
            f"{words}, {unit.name}",
            shown(each.formula, ".4g", unit.factor),
            f"{each.production * unit.factor:.4g}",
            f"{each.reference * unit.factor:.4g}",
            f"{shown(each.discrepancy, '+.1%')} {'*' if each.resolved else ' '}",
            shown(each.relative_uncertainty, ".1%"),
            shown(each.study and each.study.order, ".1f", absent="none"),
        ]
        for name, each in film.quantities.items()
        for words, unit in (names[name],)
    ]
    title = f"Film on the {film.pair} race{which_bearing(film.bearing)}: {load}, inner ring at {speed}"
    return table_of(title, heads, rows, _notes(film, units))


def _notes(film: FilmNumbers, units: Units) -> list[str]:
    """What the columns are, what was solved, and how far to trust it."""
    reach, check = film.reach, film.dissipated_force / film.quantities["rolling_force"].reference - 1
    return [
        "formula: [Nijenbanning1994], [Hamrock1977], [Biboulet2010]; model: as in the torque; +-: numerical "
        "uncertainty, 95 %; *: the difference exceeds it; order: observed on three grids. Pressure centre: its "
        "distance ahead of the contact's centre.",
        f"M = {film.loading:.4g}, L = {film.thickening:.3g}, lambda = {film.ellipticity:.3g}; entrainment "
        f"{film.entrainment_speed:.4g} m/s; oil reaches {units.length.written(reach.ahead, '.3g')} ahead and "
        f"{units.length.written(reach.behind, '.3g')} behind; flooded, isothermal, smooth; {BODIES[film.compliance]}.",
        f"The force from the viscous dissipation, equal for incompressible oil, differs by {check:+.1%}. "
        f"{film.seconds:.1f} s",
        f"Film and rolling force of the model within their stated 95 % errors: {film.verdict}. Minimum film within "
        f"that of the film: {film.quantities['minimum_film'].verdict}.",
    ]


def film_section(document: Report) -> Section:
    """The films of both races, and what they change in the torque; without blocks: none was solved."""
    tables = [film_table(film, document.units) for film in document.films]
    words = [] if document.film_change is None else [Text(_changed(document.film_change))]
    return Section("Film and rolling", [Text(WORDS, wide=True), *tables, *words] if tables else [])


def _changed(change: Sequence[float]) -> str:
    """What numerical films change in the torque;  change : at each operating point, relative."""
    ends = " to ".join(dict.fromkeys(f"{end:+.1%}" for end in (min(change), max(change))))
    return (
        f"With the numerical film and rolling force of the heaviest ball in all contacts the torque changes by {ends}. "
        "This is an estimate: lighter balls have other ratios."
    )
