"""Contacts by Hertz and by finite elements: their quantities, the pocket, the stress below, a series of loads."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from analytic.columns import CONTACT, STRESSES
from analytic.labelled import Column
from analytic.units import METRIC, MICRO, STIFFNESS, TANGENT, Units
from analytic.words import angle_of, percent_of
from fembearing.check.comparison import Comparison
from fembearing.check.contact.meshed_region import RingStructure
from fembearing.check.contact.scene_contact import POCKET_LOAD, place_of
from fembearing.check.contact.solution import ContactNumbers, sheet_in_series
from fembearing.check.contact.subsurface import SubsurfaceComparison
from fembearing.report.document import Bullets, Group, Head, Row, Section, Table, Text, table_of
from fembearing.report.phrases import AXES, capital, digits, shown
from fembearing.report.sections.points import heaviest_point, point_name

if TYPE_CHECKING:  # a contact alone needs neither the check of a scene nor a series of loads
    from fembearing.check.contact.load_series import LoadSeries, PocketLaw
    from fembearing.report.report import Report

AT_THE_CENTRE = CONTACT["peak_pressure"]._replace(short="pressure at y = 0")

RESOLVED = (
    "Is the difference resolved? According to ASME V&V 20, with Hertz as S, finite elements as D and E = S - D: the "
    "error of the model lies within E +- u_val, with u_val^2 = u_num^2 + u_input^2 + u_D^2, all half-widths at 95 %."
)
PARTS = (
    "u_num, of S, is 0 (closed form, solved to round-off).",
    "u_input, of S, is 0 (dimensions, load and materials are the same in both models).",
    "u_D is that of the finite elements, from their meshes and their far boundary. D is a model too: its difference "
    "from the real bearing is not in u_D, so this is a cross-check.",
)
OTHER_LOADS = (
    "Ball load and angle are for Hertz's contacts. The torque includes the fit for finite geometry, so the table of "
    "balls differs slightly."
)
POCKET = (
    "The thick seat is the contact alone, as in Hertz. The sheet also bends on its rim: this deflection is "
    "proportional to F, not to F^(2/3), so that its K_pb holds at this load only, and there is no verdict. The ball "
    "presses on the pole of half a pocket, along its axis; the stiffness at other places is not computed. A seat is a "
    "cavity: its approach grows with the logarithm of the counted size, here 8 major semi-axes."
)
OFF = "Hertz/FE-1"  # Hertz's over finite elements, less one
UNCERTAIN = "FE: finite elements; +-: their numerical uncertainty, 95 %; *: the difference exceeds it"


def contacts_section(document: "Report") -> Section:
    """Every contact of a check with its verdicts, and whether the differences are resolved."""
    units, tolerance = document.units, percent_of(document.tolerance)
    words = (
        "This appendix compares Hertz's closed forms with an elastic finite-element solution on meshes of the true "
        "ball, grooves and cage pocket. A value passes if its discrepancy plus the numerical uncertainty of the "
        f"reference is within {tolerance}. {contacts_at(document)}"
    )
    return Section(
        "Contacts",
        [
            Text(words, wide=True),
            contact_table(document.contacts, units),
            Text(" ".join(_explained(document, tolerance)), wide=True, quiet=True),
            Text(RESOLVED, wide=True),
            Bullets([*PARTS, *comparisons_of(document)], wide=True),
            *pocket_tables(document.contacts, units),
        ],
    )


def _explained(document: "Report", tolerance: str) -> Iterator[str]:
    """What the verdicts are on."""
    yield (
        f"Stiffness: load over approach^1.5. Pass: |Hertz/FE-1| and its uncertainty together within {tolerance}; fail: "
        "their difference beyond it; undecided: between, or the meshes do not converge; shown: no verdict. Verdicts "
        "are on uncorrected Hertz."
    )
    if any(contact.corrected for contact in document.contacts):
        yield (
            "The correction for finite geometry is a fit to the same finite elements on other contacts, so its "
            "difference from them here is an interpolation error, not an independent check."
        )
    if any(contact.ring for contact in document.contacts):
        yield (
            "The ring is bonded to a rigid seat, as with an interference fit on a stiff shaft or in a stiff housing. "
            "It has no verdict."
        )


def contacts_at(document: "Report") -> str:
    """Which ball and which operating point the contacts belong to."""
    if document.solved is None:
        return "Races: the heaviest ball of all operating points."
    points = document.solved.points
    if document.solved.friction.pair is not None:
        return "Races: the heaviest ball of each bearing, at any operating point. Ball loads are for Hertz's contacts."
    place = f"Races: the heaviest ball, at {point_name(points, heaviest_point(points), document.units)}."
    change = document.torque_change
    return place if change is None or change.finite_geometry is not None else f"{place} {OTHER_LOADS}"


def contact_table(contacts: Sequence[ContactNumbers], units: Units = METRIC) -> Table:
    """A group for each contact with the verdicts on it, a row for each quantity."""
    heads = [Head("quantity", "name"), Head("Hertz", fixed=True), Head("FE", fixed=True), Head(OFF, fixed=True)]
    heads += [Head("+-", fixed=True), Head("order", fixed=True), Head("verdict", "verdict")]
    groups = [
        Group(list(_rows(contact, units)), contact_title(contact, units), _notes(contact, units))
        for contact in contacts
    ]
    words = "order: observed on three meshes or more, if it is; outside: outside the validity of Hertz"
    return Table("Contacts", heads, groups, [f"{AXES}. {UNCERTAIN}; {words}."])


def _rows(contact: ContactNumbers, units: Units) -> Iterator[Row]:
    for name, quantity in quantities_of(contact).items():
        each, study, factor = contact.quantities[name], contact.estimates[name], quantity.shown(units).factor
        yield [
            quantity.heading(units),
            digits(each.production, factor),
            digits(each.reference, factor),
            _off(each),
            shown(each.relative_uncertainty, ".2%"),
            shown(study.order, ".1f", absent="-"),
            each.verdict.removesuffix(" validity"),
        ]


def _off(each: Comparison) -> str:
    return f"{shown(each.discrepancy, '+.2%')} {'*' if each.resolved else ' '}"


def _notes(contact: ContactNumbers, units: Units) -> list[str]:
    """Hertz corrected for finite geometry, while verdicts are on Hertz as it is; shoulders, ring, and the method."""
    notes, corrected = [], contact.corrected
    if corrected is not None:
        values = ", ".join(
            f"{quantity.name} {quantity.shown(units).written(getattr(corrected.quantities, name), '.5g')} "
            f"({contact.interpolation_error[name]:+z.2%})"
            for name, quantity in quantities_of(contact).items()
        )
        notes.append(
            f"Hertz corrected for finite geometry (interpolation error, over FE - 1): {values}; stated 95 % "
            f"uncertainty at most {max(corrected.uncertainty.values()):.2%}."
        )
    notes += shoulder_lines(contact, units)
    notes += [] if contact.ring is None else [ring_line(contact.ring, units)]
    return [*notes, f"{capital(contact.method)}, {contact.seconds:.1f} s"]


def pocket_tables(contacts: Sequence[ContactNumbers], units: Units = METRIC) -> list[Table]:
    """The stiffness K_pb by each model of the pocket, Hertz first; none without a cage."""
    pocket = [contact for contact in contacts if contact.pair == "pocket"]
    if not pocket:
        return []
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
    notes = [f"At {load}, the largest ball-cage force of the 6205 in [Paper]."] if pocket[0].load == POCKET_LOAD else []
    if series is not None:
        sheet = units.tangent.written(series.stiffness, ".4g")
        notes.append(f"Sheet in series with the seat: {sheet} +- {series.uncertainty:.2%}, for cage.sheet_stiffness.")
    return [table_of(f"Cage pocket: F = K_pb delta^1.5, at {load}", heads, rows, [*notes, POCKET])]


def contact_sections(
    contact: ContactNumbers, below: SubsurfaceComparison | None, units: Units = METRIC
) -> list[Section]:
    """One contact, and the stress below it where it is known."""
    stress = [] if below is None else [subsurface_table(below, units)]
    limit = f"Hertz, tolerance of the scene {percent_of(contact.tolerance)}"
    verdict = [Text(f"{limit}: {contact.verdict}")] if contact.judged else []
    return [Section("", [contact_table([contact], units), *stress, *verdict])]


def subsurface_table(below: SubsurfaceComparison, units: Units = METRIC) -> Table:
    """Where fatigue begins, in the body under the ball."""
    heads = [Head("quantity", "name"), *(Head(name, fixed=True) for name in ("Hertz", "FE", OFF, "+-"))]
    rows = []
    for name, quantity in STRESSES.items():
        unit, each = quantity.shown(units), below.quantities[name]
        is_depth = name.endswith("depth")
        rows.append(
            [
                quantity.heading(units),
                digits(each.production, unit.factor, 4),
                digits(each.reference, unit.factor, 4),
                _off(each),
                unit.written(each.uncertainty, ".2g") if is_depth else shown(each.relative_uncertainty, ".2%"),
            ]
        )
    return table_of("Greatest stress under the centre, in the lower body", heads, rows)


def series_sections(series: "LoadSeries", units: Units = METRIC) -> list[Section]:
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
    table = table_of(title, [Head(name) for name in names], rows, [*_law(series), *_series_notes(series)])
    verdict = "no verdict" if series.verdict == "shown" else series.verdict
    return [Section("", [table, Text(f"{verdict}: tolerance {percent_of(series.tolerance)}")])]


def _law(series: "LoadSeries") -> Iterator[str]:
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


def _sheet_law(law: "PocketLaw", *, largest: float) -> Iterator[str]:
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


def _series_notes(series: "LoadSeries") -> Iterator[str]:
    yield f"F: load; delta: approach; tangent: dF/d(delta), from a fit to all loads. {UNCERTAIN}."
    meshes = "mesh" if series.meshes == 1 else "meshes"
    yield f"Finite elements, {series.geometry}, {series.meshes} {meshes} for all loads, {series.seconds:.1f} s"


def quantities_of(contact: ContactNumbers) -> dict[str, Column]:
    """The quantities of a contact; where a shoulder cuts it off, the pressure is largest there and not at y = 0."""
    return CONTACT | {"peak_pressure": AT_THE_CENTRE} if contact.shoulder else CONTACT


def title_of(pair: str, geometry: str, contact_angle: float, load: str, bearing: str | None = None) -> str:
    """Place and load, for the head of a table or a picture."""
    angle = "" if pair == "pocket" else f" at {angle_of(contact_angle)}"
    return f"{capital(place_of(pair, geometry, bearing))}{angle}: {load}"


def contact_title(contact: "ContactNumbers", units: Units = METRIC) -> str:
    """Place and load of a contact, for the head of its table."""
    load = units.force.written(contact.load, ".4g")
    return title_of(contact.pair, contact.geometry, contact.contact_angle, load, contact.bearing)


def contact_place(contact: "ContactNumbers") -> str:
    """The place of a contact, as it begins a sentence."""
    return capital(place_of(contact.pair, contact.geometry, contact.bearing))


def ring_line(ring: "RingStructure", units: Units = METRIC) -> str:
    """What the ring adds to the approach, in one sentence."""
    return (
        f"Ring on a rigid seat: approach {units.small_length.written(ring.approach, '+.3g')} ({ring.share:+.1%} of "
        f"the contact's), +- {units.small_length.written(ring.uncertainty, '.1g')}: structure, not contact."
    )


def shoulder_lines(contact: "ContactNumbers", units: Units = METRIC) -> list[str]:
    """What a contact does at the shoulders that cut it off, a sentence each; none where it ends before them."""
    shoulder = contact.shoulder
    if shoulder is None:
        return []
    centroid, share, line = shoulder.centroid, shoulder.strip_share, shoulder.strip_line_load
    ends = [units.length.written(y, ".4g") for y in sorted(shoulder.cuts)]
    nearer = units.length.written(shoulder.cuts[0], ".4g")
    if len(ends) == 1:
        where, edge = f"Cut off at the shoulder, y = {ends[0]}, on one side", "the shoulder"
    else:
        where, edge = f"Cut off at both shoulders, y = {ends[0]} and y = {ends[1]}", f"the shoulder at y = {nearer}"
    half = (
        f": half of the contact is meshed; semi-axes about the centroid of the load, at y = "
        f"{units.length.written(centroid.reference, '.3g')} (+-{centroid.relative_uncertainty:.1%} of that)"
    )
    return [
        f"{where}{half if shoulder.half else ''}.",
        f"Edge load: the strip of {units.length.written(shoulder.strip_width, '.3g')} beside {edge} carries "
        f"{share.reference:.2%} of the load (+-{share.relative_uncertainty:.1%} of that), "
        f"{units.line_load.written(line.reference, '.4g')} or {line.reference / shoulder.hertz_line_load:.3g} times "
        "Hertz's greatest line load. The pressure shown is that at y = 0; the pressure at the edge is unbounded.",
    ]


def comparisons_of(document: "Report") -> list[str]:
    """What is resolved of Hertz's errors, a sentence for each contact and answer."""
    judged = [contact for contact in document.contacts if contact.judged]
    return [f"{contact_place(contact)}: {line}" for contact in judged for line in _resolved(contact)]


def _resolved(contact: ContactNumbers) -> Iterator[str]:
    """In sentences, what |E| against u_val says of Hertz in one contact."""
    rows, names = contact.quantities, quantities_of(contact)
    parts: dict[bool, list[str]] = {True: [], False: []}
    for name, quantity in names.items():
        row = rows[name]
        words = f"{quantity.name} {row.discrepancy:+.2%} +- {row.relative_uncertainty:.2%}"
        parts[row.resolved].append(words)
    if parts[True]:
        yield f"|E| > u_val, difference resolved, error of Hertz: {', '.join(parts[True])}."
    if parts[False]:
        yield f"|E| <= u_val, difference not resolved, error of Hertz within {', '.join(parts[False])}."
