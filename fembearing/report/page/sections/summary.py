"""The document that is signed: the first two pages, for any scene."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from analytic.scene_torque import SceneTorque
from analytic.scenefile.inputs import StatedInput
from analytic.standing import Standing
from analytic.verdicts import NumericalCheck
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.contact.solution import ContactNumbers
from fembearing.quantities import CONTACT, Units
from fembearing.report.headline import ends_of
from fembearing.report.page.sections.bearing import Facts, facts_of
from fembearing.report.phrases import (
    angle_cell,
    between,
    digits,
    input_name,
    percent,
)
from fembearing.report.report import Report
from fembearing.report.tables.points import heaviest_point, point_name, shown_places
from fembearing.report.tables.table import Head, Table, table_of, without_zero_angles
from fembearing.report.tables.torque import torque_table
from fembearing.report.tables.verdicts import POINT, failures, physical_table

MOST_NAMED = 8  # assumed inputs that the summary names
OTHER_LOADS = (
    "Ball load and angle are for Hertz's contacts. The torque includes the fit for finite geometry, so the table of "
    "balls differs slightly."
)
MOST_NOTES, LONGEST = 5, 320  # notes of the summary, and letters of one and of a fact: the appendices have all


class Figure(NamedTuple):
    """A number that stands out, and what it belongs to."""

    name: str
    value: str
    spread: str
    place: str


class Box(NamedTuple):
    """One kind of verdict."""

    kind: str
    verdict: str
    words: str


class SignOff(NamedTuple):
    """Who signs; an empty text is a blank to fill in."""

    people: list[tuple[str, str]]
    revision: str
    date: str


class Summary(NamedTuple):
    """What the first two pages show."""

    figures: list[Figure]
    standing: Standing | None  # how far to trust the torque; None: there is none
    boxes: list[Box]
    overall: str
    reason: str
    inputs: str
    torque: Table | None
    physical: Table
    contacts: Table
    contacts_at: str
    findings: list[str]
    notes: list[str]
    every_note: list[str]  # in full, for the appendix
    facts: Facts
    sign_off: SignOff


def summary_of(document: Report) -> Summary:
    """The summary of a report."""
    torque = document.solved
    measured = [] if document.measured is None else [document.measured.conclusions[0]]  # what is missed
    notes = [*failures(document.physical), *measured, *([] if torque is None else torque.notes), *document.warnings]
    boxes = _boxes(document)
    return Summary(
        figures=[] if torque is None else _figures(torque, document.units),
        standing=None if torque is None else torque.standing,
        boxes=boxes,
        overall=document.verdict.overall,
        reason=document.verdict.reason,
        inputs="" if torque is None else _status_of(torque.inputs),
        torque=None if torque is None else _torque(document, torque),
        physical=physical_table(document.physical, document.units)._replace(notes=[POINT]),
        contacts=_contacts(document),
        contacts_at=_contacts_at(document),
        findings=[finding.words for finding in document.findings],
        notes=[_shortened(note) for note in notes[:MOST_NOTES]],
        every_note=notes,
        facts=[(name, _shortened(words)) for name, words in facts_of(document)],
        sign_off=SignOff(
            people=[("Author", document.report.author or ""), ("Checker", document.report.checker or "")],
            revision=document.report.revision or "",
            date=document.report.date or "",
        ),
    )


def _figures(torque: SceneTorque, units: Units) -> list[Figure]:
    """The total: the one, or the largest and the smallest of a series."""
    points = torque.points
    totals = [point["torque_total"] for point in points]
    largest, smallest = totals.index(max(totals)), totals.index(min(totals))
    if len(points) == 1:
        return [_figure("Friction torque", torque, 0, units)]
    if largest == smallest:
        return [
            _figure("Friction torque", torque, 0, units)._replace(
                place=f"the same at all {len(points)} operating points"
            )
        ]
    return [_figure("Largest friction torque", torque, largest, units), _figure("Smallest", torque, smallest, units)]


def _figure(name: str, torque: SceneTorque, index: int, units: Units) -> Figure:
    point = torque.points[index]
    ends = ends_of(point)
    power = point["torque_total"] * abs(point["inner_speed"])
    spread = "not known" if ends is None else f"{between(ends, units.torque)} {units.torque.name}"
    spread = f"95 % interval {spread}; {power:.3g} W"
    value = f"{digits(point['torque_total'], units.torque.factor, 4)} {units.torque.name}"
    return Figure(name, value, spread, point_name(torque.points, index, units))


def _boxes(document: Report) -> list[Box]:
    """Each kind of verdict in a word and a sentence."""
    verdict, torque = document.verdict, document.solved
    judged = (contact for contact in document.contacts if contact.judged)
    compared = Counter(each.verdict for contact in judged for each in contact.quantities.values())
    words = f"Contacts, Hertz against finite elements, tolerance {percent(document.tolerance)}: {_counted(compared)}."
    others = (f"{name.capitalize()}: {word}." for name, word in document.compared.items() if name != "contacts")
    assert verdict.comparison is not None  # contacts are always compared
    boxes = [Box("Comparison", verdict.comparison, " ".join([words, *others]))]
    check = None if torque is None else torque.verdicts.numerical
    if check is not None and verdict.numerical is not None:
        boxes.append(Box("Numerical", verdict.numerical, _numerical(check)))
    limits = f"Limits of the bearing: {_counted(Counter(check.verdict for check in document.physical))}."
    return [*boxes, Box("Physical", verdict.physical, limits)]


def _numerical(check: NumericalCheck) -> str:
    return f"Solver error of the torque at most {percent(check.uncertainty)}, tolerance {percent(check.tolerance)}."


def _counted(verdicts: Counter[str]) -> str:
    return ", ".join(f"{count} {verdict}" for verdict, count in verdicts.items())


def _status_of(inputs: Sequence[StatedInput]) -> str:
    """How many inputs are given, printed, derived and assumed, and the names of those that are assumed."""
    counts = Counter(each.status for each in inputs)
    assumed = [input_name(each.key) for each in inputs if each.status == "assumed"]
    words = ", ".join(f"{count} {status}" for status, count in counts.items())
    if not assumed:
        return f"{len(inputs)} inputs: {words}."
    more = f" and {len(assumed) - MOST_NAMED} more" if len(assumed) > MOST_NAMED else ""
    return f"{len(inputs)} inputs: {words}. Assumed: {', '.join(assumed[:MOST_NAMED])}{more}."


def _torque(document: Report, torque: SceneTorque) -> Table:
    """The torque at most 12 operating points, without what is said of it in the appendix."""
    places = shown_places(torque)
    table = torque_table(torque, document.scene.bearing.name, places, document.units)
    return table._replace(notes=table.notes[: 1 + (len(places) < len(torque.points))])


def _contacts(document: Report) -> Table:
    """A row for each contact that is judged: what Hertz says, and how far it is from finite elements."""
    units = document.units
    pressure = CONTACT["peak_pressure"].in_units(units)
    heads = [
        Head("contact", "name"),
        Head(f"ball load, {units.force.name}"),
        Head("contact angle, deg (rad)"),
        Head(f"{pressure.heading}: Hertz"),
        Head("finite elements"),
        *(Head(f"{quantity.name}, %") for quantity in CONTACT.values()),
        Head("verdict", "verdict"),
    ]
    rows = [_contact(document, each) for each in document.contacts if each.judged]
    return without_zero_angles(table_of("contacts", heads, rows))


def _contact(document: Report, contact: ContactNumbers) -> list[str]:
    found, shown = contact.quantities, document.units.pressure
    return [
        "cage pocket" if contact.pair == "pocket" else f"{contact.pair} race{which_bearing(contact.bearing)}",
        digits(contact.load, document.units.force.factor, 4),
        "-" if contact.pair == "pocket" else angle_cell(contact.contact_angle),
        digits(found["peak_pressure"].production, shown.factor, 4),
        digits(found["peak_pressure"].reference, shown.factor, 4),
        *(
            f"{100 * each.difference:+.2f} \N{PLUS-MINUS SIGN} {100 * each.uncertainty / each.reference:.2f}"
            for each in (found[name] for name in CONTACT)
        ),
        contact.verdict,
    ]


def _contacts_at(document: Report) -> str:
    """Which ball and which operating point the contacts belong to."""
    if document.solved is None:
        return "Races: the heaviest ball of all operating points."
    points = document.solved.points
    if document.solved.friction.pair is not None:
        return "Races: the heaviest ball of each bearing, at any operating point. Ball loads are for Hertz's contacts."
    place = f"Races: the heaviest ball, at {point_name(points, heaviest_point(points), document.units)}."
    change = document.torque_change
    if change is None or change.finite_geometry is not None:
        return place
    return f"{place} {OTHER_LOADS}"


def _shortened(words: str) -> str:
    """Words of bounded length, so that the summary stays on its pages."""
    return words if len(words) <= LONGEST else f"{words[:LONGEST]} ..."
