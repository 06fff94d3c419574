"""Contacts by Hertz and by finite elements: their quantities, the pocket, the stress below, a series of loads."""

from collections.abc import Iterator, Sequence

from analytic.units import METRIC, MICRO, STIFFNESS, TANGENT, Units
from fembearing.check.comparison import Comparison
from fembearing.check.contact.load_series import LoadSeries, PocketLaw
from fembearing.check.contact.solution import ContactNumbers, sheet_in_series
from fembearing.check.contact.subsurface import SubsurfaceComparison
from fembearing.quantities import STRESSES
from fembearing.report.phrases import (
    AXES,
    capital,
    contact_title,
    digits,
    place_of,
    quantities_of,
    ring_line,
    shoulder_lines,
    shown,
    title_of,
)
from fembearing.report.report import Report
from fembearing.report.tables.table import Group, Head, Row, Table, table_of

OFF = "Hertz/FE-1"  # Hertz's over finite elements, less one
UNCERTAIN = "FE: finite elements; +-: their numerical uncertainty, 95 %; *: the difference exceeds it"


def contacts_of(document: Report, units: Units = METRIC) -> Table:
    """Every contact of a check with its verdicts."""
    return contact_table(document.contacts, units)


def contact_table(contacts: Sequence[ContactNumbers], units: Units = METRIC) -> Table:
    """A group for each contact with the verdicts on it, a row for each quantity."""
    heads = [Head("quantity", "name"), Head("Hertz", fixed=True), Head("FE", fixed=True), Head(OFF, fixed=True)]
    heads += [Head("+-", fixed=True), Head("order", fixed=True), Head("verdict", "verdict")]
    groups = [
        Group(list(_rows(contact, units)), contact_title(contact, units), _notes(contact, units))
        for contact in contacts
    ]
    words = (
        "order: observed on the meshes; twin: corrected by half spaces on the same cells; outside: outside the "
        "validity of Hertz"
    )
    return Table("Contacts", heads, groups, [f"{AXES}. {UNCERTAIN}; {words}."])


def _rows(contact: ContactNumbers, units: Units) -> Iterator[Row]:
    for name, quantity in quantities_of(contact, units).items():
        each, study, factor = contact.quantities[name], contact.estimates[name], quantity.shown.factor
        yield [
            quantity.heading,
            digits(each.production, factor),
            digits(each.reference, factor),
            _off(each),
            shown(each.relative_uncertainty, ".2%"),
            "twin" if study.corrected else shown(study.order, ".1f", absent="none"),
            each.verdict.removesuffix(" validity"),
        ]


def _off(each: Comparison) -> str:
    return f"{shown(each.discrepancy, '+.2%')} {'*' if each.resolved else ' '}"


def _notes(contact: ContactNumbers, units: Units) -> list[str]:
    """Hertz corrected for finite geometry, while verdicts are on Hertz as it is; shoulders, ring, and the method."""
    notes, corrected = [], contact.corrected
    if corrected is not None:
        values = ", ".join(
            f"{quantity.name} {quantity.shown.written(getattr(corrected.quantities, name), '.5g')} "
            f"({contact.interpolation_error[name]:+.2%})"
            for name, quantity in quantities_of(contact, units).items()
        )
        notes.append(
            f"Hertz corrected for finite geometry (interpolation error, over FE - 1): {values}; stated 95 % "
            f"uncertainty at most {max(corrected.uncertainty.values()):.2%}."
        )
    notes += shoulder_lines(contact, units)
    notes += [] if contact.ring is None else [ring_line(contact.ring, units)]
    return [*notes, f"{capital(contact.method)}, {contact.seconds:.1f} s"]


def pocket_table(contacts: Sequence[ContactNumbers], units: Units = METRIC) -> Table | None:
    """The stiffness K_pb by each model of the pocket, Hertz first; None without a cage."""
    pocket = [contact for contact in contacts if contact.pair == "pocket"]
    if not pocket:
        return None
    approach, stiffness, half_spaces = units.small_length, units.stiffness, pocket[0].hertz
    models = [("half spaces, Hertz", half_spaces, None)]
    models += [
        (
            place_of(each.pair, each.geometry).rpartition(", ")[2],
            each.reference,
            each.quantities["stiffness"].relative_uncertainty,
        )
        for each in pocket
    ]
    heads = [Head("model", "name"), Head(f"K_pb, {stiffness.name}"), Head("+-"), Head("over Hertz's, less 1")]
    heads += [Head(f"approach, {approach.name}")]
    rows = [
        [
            model,
            digits(values.stiffness, stiffness.factor, 4),
            shown(uncertainty, ".2%", absent=""),
            f"{values.stiffness / half_spaces.stiffness - 1:+.1%}",
            digits(values.approach, approach.factor, 4),
        ]
        for model, values, uncertainty in models
    ]
    load = units.force.written(pocket[0].load, ".4g")
    series = sheet_in_series(*pocket)
    notes = []
    if series is not None:
        sheet = units.tangent.written(series.stiffness, ".4g")
        notes.append(f"Sheet in series with the seat: {sheet} +- {series.uncertainty:.2%}, for cage.sheet_stiffness.")
    return table_of(f"Cage pocket: F = K_pb delta^1.5, at {load}", heads, rows, notes)


def subsurface_table(below: SubsurfaceComparison, units: Units = METRIC) -> Table:
    """Where fatigue begins, in the body under the ball."""
    heads = [Head("quantity", "name"), *(Head(name, fixed=True) for name in ("Hertz", "FE", OFF, "+-"))]
    rows = []
    for name, metric in STRESSES.items():
        quantity = metric.in_units(units)
        unit, each = quantity.shown, below.quantities[name]
        is_depth = name.endswith("depth")
        rows.append(
            [
                quantity.heading,
                digits(each.production, unit.factor, 4),
                digits(each.reference, unit.factor, 4),
                _off(each),
                unit.written(each.uncertainty, ".2g") if is_depth else shown(each.relative_uncertainty, ".2%"),
            ]
        )
    return table_of("Greatest stress under the centre, in the lower body", heads, rows)


def series_table(series: LoadSeries, units: Units = METRIC) -> Table:
    """Each load with approach and tangent stiffness; the law through all of them."""
    small, tangent = units.small_length, units.tangent
    names = (f"load, {units.force.name}", f"Hertz, {small.name}", f"FE, {small.name}", OFF, "+-")
    names += (f"tangent FE, {tangent.name}", "+-", "Hertz")
    rows = [
        [
            f"{units.force.number(point.load):.4g}",
            digits(point.approach.production, small.factor),
            digits(point.approach.reference, small.factor),
            _off(point.approach),
            shown(point.approach.relative_uncertainty, ".2%"),
            digits(point.tangent, tangent.factor, 4),
            shown(point.tangent_uncertainty, ".2%"),
            digits(point.hertz_tangent, tangent.factor, 4),
        ]
        for point in series.points
    ]
    title = title_of(series.pair, series.geometry, series.contact_angle, f"{len(series.points)} loads")
    return table_of(title, [Head(name) for name in names], rows, [*_law(series), *_series_notes(series)])


def _law(series: LoadSeries) -> Iterator[str]:
    law = series.law
    if law is None:
        return
    stiffness, exponent = f"{law.stiffness * 1e-9:.5g} GN/m^{law.exponent:.4f}", f"{law.exponent:.4f}"
    if law.stiffness_uncertainty is not None:
        stiffness += f" +- {law.stiffness_uncertainty:.2%}"
    assumed = law.exponent_uncertainty is None
    exponent += " (power law assumed)" if assumed else f" +- {law.exponent_uncertainty:.4f}"
    yield (
        f"F = K delta^n: K {stiffness}, n {exponent} by finite elements; "
        f"{STIFFNESS.written(series.hertz_stiffness, '.5g')} and 1.5 by Hertz."
    )
    if series.pocket_law is not None:
        yield from _sheet_law(series.pocket_law, largest=max(point.load for point in series.points))


def _sheet_law(law: PocketLaw, *, largest: float) -> Iterator[str]:
    """The law of the sheet of a pocket, and the keys of a scene that take it; largest : load of the series, N."""
    local, sheet = STIFFNESS.written(law.stiffness, ".5g"), TANGENT.written(law.sheet, ".5g")
    if law.stiffness_uncertainty is not None:
        local += f" +- {law.stiffness_uncertainty:.2%}"
    if law.sheet_uncertainty is not None:
        sheet += f" +- {law.sheet_uncertainty:.2%}"
    contact = MICRO.written((largest / law.stiffness) ** (2 / 3), ".4g")
    yield f"delta = (F/K)^(2/3) + F/k, contact and sheet in series: K {local}, k {sheet}. In a scene:"
    yield f'cage.pocket_approach = {{ load = "{largest:.4g} N", approach = "{contact}" }}'
    yield f'cage.sheet_stiffness = "{TANGENT.written(law.sheet, ".4g")}"'


def _series_notes(series: LoadSeries) -> Iterator[str]:
    yield f"F: load; delta: approach; tangent: dF/d(delta), from a fit to all loads. {UNCERTAIN}."
    meshes = "mesh" if series.meshes == 1 else "meshes"
    yield f"Finite elements, {series.geometry}, {series.meshes} {meshes} for all loads, {series.seconds:.1f} s"
