"""Each contact's quantities by Hertz and by finite elements, and whether the difference counts."""

from collections.abc import Iterator
from typing import NamedTuple

from fembearing.report.document.contact import Contact
from fembearing.report.document.report import Report
from fembearing.report.document.table import OfQuantities
from fembearing.report.phrases import contact_place, place_of, quantities_of


class PocketModel(NamedTuple):
    """The pocket by one model."""

    name: str
    values: OfQuantities[float]
    uncertainty: float | None  # of its stiffness, relative; None where the model is a formula


class VerdictSection(NamedTuple):
    """What the section shows besides the document."""

    judged: list[Contact]
    comparisons: list[tuple[str, str]]  # place of a contact, and a sentence
    pocket: list[PocketModel]  # Hertz first; empty without a cage


def verdict_section(document: Report) -> VerdictSection:
    """The judged contacts, what is resolved of them, and the models of the pocket."""
    judged = [contact for contact in document.contacts if contact.judged]
    return VerdictSection(
        judged=judged,
        comparisons=[(contact_place(contact), line) for contact in judged for line in _resolved(document, contact)],
        pocket=_pocket(document.contacts),
    )


def _resolved(document: Report, contact: Contact) -> Iterator[str]:
    """In sentences, what |E| against u_val says of Hertz in one contact."""
    rows, names = document.verdicts_on(contact), quantities_of(contact)
    parts: dict[bool, list[str]] = {True: [], False: []}
    for name, quantity in names.items():
        row = rows[name]
        words = f"{quantity.name} {row.discrepancy:+.2%} +- {row.relative_uncertainty:.2%}"
        parts[row.comparison.resolved].append(words)
    if parts[True]:
        yield f"|E| > u_val: the difference is resolved, and is Hertz's error: {', '.join(parts[True])}."
    if parts[False]:
        yield f"|E| <= u_val: the difference is not resolved, Hertz's error is somewhere in {', '.join(parts[False])}."


def _pocket(contacts: list[Contact]) -> list[PocketModel]:
    """Each model of the pocket; none without a cage."""
    if len(contacts) < 4:
        return []
    return [
        PocketModel("Hertz: two half spaces", contacts[2].hertz, None),
        *(
            PocketModel(place_of(each.pair, each.geometry), each.fe, each.uncertainty.stiffness)
            for each in contacts[2:]
        ),
    ]
