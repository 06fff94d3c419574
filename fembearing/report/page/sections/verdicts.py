"""Each contact's quantities by Hertz and by finite elements, and whether the difference counts."""

from collections.abc import Iterator
from typing import NamedTuple

from fembearing.report.contact import ContactRecord
from fembearing.report.phrases import contact_place, contact_title, digits, quantities_of, shown
from fembearing.report.report import Report
from fembearing.report.tables.table import Group, Head, Row, Table

HEADS = (
    Head("quantity", "name"),
    Head("S: Hertz"),
    Head("D: finite elements"),
    Head("E = S - D, of D"),
    Head("u_val, of D"),
    Head("|E| > u_val", "text"),
    Head("verdict", "verdict"),
    Head("Hertz, corrected"),
    Head("interpolation error"),
)


class VerdictSection(NamedTuple):
    """What the section shows besides the document."""

    judged: Table
    comparisons: list[tuple[str, str]]  # place of a contact, and a sentence
    is_corrected: bool  # whether any contact is corrected for finite geometry


def verdict_section(document: Report) -> VerdictSection:
    """The judged contacts, and what is resolved of them."""
    judged = [contact for contact in document.contacts if contact.judged]
    groups = [Group(list(_rows(document, contact)), contact_title(contact, document.units)) for contact in judged]
    return VerdictSection(
        judged=Table("verdicts on each contact", HEADS, groups),
        comparisons=[(contact_place(contact), line) for contact in judged for line in _resolved(document, contact)],
        is_corrected=any(contact.corrected for contact in judged),
    )


def _rows(document: Report, contact: ContactRecord) -> Iterator[Row]:
    verdicts, corrected = document.verdicts_on(contact), contact.corrected
    for name, quantity in quantities_of(contact, document.units).items():
        row, factor = verdicts[name], quantity.shown.factor
        yield [
            quantity.heading,
            digits(row.production, factor),
            digits(row.reference, factor),
            f"{row.discrepancy:+.2%}",
            f"{row.relative_uncertainty:.2%}",
            "yes" if row.comparison.resolved else "no",
            row.verdict,
            "-" if corrected is None else digits(corrected.values[name], factor),
            "-" if corrected is None else shown(corrected.interpolation_error[name], "+.2%"),
        ]


def _resolved(document: Report, contact: ContactRecord) -> Iterator[str]:
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
