"""The pages that are signed: a selection of what the sections say, for any scene."""

from collections import Counter
from collections.abc import Iterator, Sequence

from analytic.columns import CONTACT
from analytic.oil.film import FILM_FACTORS
from analytic.scene_torque import SceneTorque
from analytic.scenefile.inputs import StatedInput
from analytic.units import METRIC
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.document import (
    Block,
    Bullets,
    Drawing,
    Facts,
    Head,
    Section,
    Signing,
    Table,
    Text,
    table_of,
    without_zero_angles,
)
from fembearing.report.phrases import MEASURED, angle_cell, digits, input_name, percent
from fembearing.report.report import Report
from fembearing.report.sections.contacts import contacts_at
from fembearing.report.sections.headline import check_headline
from fembearing.report.sections.inputs import facts_of
from fembearing.report.sections.limits import POINT, physical_table
from fembearing.report.sections.next import notes_of
from fembearing.report.sections.points import shown_places
from fembearing.report.sections.torque import torque_table

MOST_NAMED = 8  # assumed inputs that are named
MOST_NOTES, LONGEST = 5, 320  # notes, and letters of one and of a fact: the appendices have all
BLANK = "____________"
CONTACTS = (
    "Columns in %: Hertz less finite elements, over finite elements, \N{PLUS-MINUS SIGN} u_val. Details: appendix "
    "Contacts."
)


def summary_sections(document: Report, drawn: Sequence[Drawing] = ()) -> list[Section]:
    """The pages that are signed;  drawn : the bearing"""
    units, torque = document.units, document.solved
    facts = Facts([(name, _shortened(words)) for name, words in facts_of(document)])
    status = "" if torque is None else _status_of(torque.inputs)
    inputs = [Text(f"{status} Source of each: appendix Inputs and effects.", quiet=True)] if status else []
    return [
        Section("", [*check_headline(document).blocks, _verdicts(document)]),
        Section("Bearing and operation", [facts, *drawn, *inputs]),
        *([] if torque is None else [_torque(document, torque)]),
        Section(
            "Contacts: Hertz against finite elements",
            [_contacts(document), Text(f"{contacts_at(document)} {CONTACTS}", quiet=True)],
        ),
        Section("Limits of the bearing", [physical_table(document.physical, units)._replace(label="", notes=[POINT])]),
        *_notes(document),
        Section("Not validated by measurement", [Bullets(list(_unvalidated(document)))]),
        Section("Sign-off", _signing(document)),
    ]


def _verdicts(document: Report) -> Table:
    """Each kind of verdict in a word and a sentence."""
    verdict, torque = document.verdict, document.solved
    judged = (contact for contact in document.contacts if contact.judged)
    compared = Counter(each.verdict for contact in judged for each in contact.quantities.values())
    words = f"Contacts, Hertz against finite elements, tolerance {percent(document.tolerance)}: {_counted(compared)}."
    others = (f"{name.capitalize()}: {word}." for name, word in document.compared.items() if name != "contacts")
    assert verdict.comparison is not None  # contacts are always compared
    rows = [("comparison", verdict.comparison, " ".join([words, *others]))]
    check = None if torque is None else torque.verdicts.numerical
    if check is not None and verdict.numerical is not None:
        error, limit = percent(check.uncertainty), percent(check.tolerance)
        words = f"Solver error of the torque at most {error}, tolerance {limit}."
        rows.append(("numerical", verdict.numerical, words))
    limits = _counted(Counter(check.verdict for check in document.physical))
    rows.append(("physical", verdict.physical, f"Limits of the bearing: {limits}."))
    return table_of("Verdicts", [Head("kind", "name"), Head("verdict", "verdict"), Head("of", "text")], rows)


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


def _torque(document: Report, torque: SceneTorque) -> Section:
    """The torque at most 12 operating points, without what is said of it in the appendix."""
    places = shown_places(torque)
    table = torque_table(torque, document.scene.bearing.name, places, document.units)
    table = table._replace(label="", notes=table.notes[: 1 + (len(places) < len(torque.points))])
    words = "Same result as fembearing torque; details: appendix Torque at every operating point."
    return Section(f"Friction torque by effect, {document.units.torque.name}", [table, Text(words, quiet=True)])


def _contacts(document: Report) -> Table:
    """A row for each contact that is judged: what Hertz says, and how far it is from finite elements."""
    units = document.units
    heads = [
        Head("contact", "name"),
        Head(f"ball load, {units.force.name}"),
        Head("contact angle, deg (rad)"),
        Head(f"{CONTACT['peak_pressure'].heading(units)}: Hertz"),
        Head("finite elements"),
        *(Head(f"{quantity.name}, %") for quantity in CONTACT.values()),
        Head("verdict", "verdict"),
    ]
    rows = [_contact(document, each) for each in document.contacts if each.judged]
    return without_zero_angles(table_of("", heads, rows))


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


def _notes(document: Report) -> list[Section]:
    """The first notes and warnings; none without one."""
    notes, blocks = notes_of(document), list[Block]()
    if not notes:
        return []
    blocks.append(Bullets([_shortened(note) for note in notes[:MOST_NOTES]]))
    if len(notes) > MOST_NOTES:
        blocks.append(Text(f"{len(notes) - MOST_NOTES} more: appendix Warnings and next steps.", quiet=True))
    if document.units is not METRIC:
        blocks.append(Text("Notes and warnings are in metric units.", quiet=True))
    return [Section("Notes and warnings", blocks)]


def _unvalidated(document: Report) -> Iterator[str]:
    """What no measurement has confirmed."""
    scene = document.scene
    yield (
        "Contacts: each comparison is a cross-check of two models. Bodies are elastic, smooth, frictionless and at "
        "rest."
    )
    if document.solved is not None:
        yield f"Friction torque: {MEASURED}"
    if scene.lubricant is not None:
        low, high = FILM_FACTORS
        yield (
            "Film thickness: only the formula is compared with measurements, films of a ball on a disc; 95 % of them "
            f"are {low:.2f} to {high:.2f} times as thick."
        )
    if scene.cage is not None:
        yield (
            "Cage: forces and torque have no comparison; the stiffness of the pocket is compared with finite elements."
        )


def _signing(document: Report) -> list[Block]:
    """Who signs, and what."""
    details, origin = document.report, document.provenance
    return [
        Signing([("Author", details.author or ""), ("Checker", details.checker or "")]),
        Text(
            f"Revision: {details.revision or BLANK}, date: {details.date or BLANK}. Scene SHA-256: "
            f"{origin.scene_sha256}; computed {origin.date} by fembearing {origin.versions['fembearing']}."
        ),
    ]


def _shortened(words: str) -> str:
    """Words of bounded length, so that the summary stays on its pages."""
    return words if len(words) <= LONGEST else f"{words[:LONGEST]} ..."
