"""Each contact's quantities by Hertz and by finite elements, and whether the difference counts."""

from typing import Any

from fembearing.quantities import CONTACT, Quantity
from fembearing.report.document.contact import Contact
from fembearing.report.document.report import Report, VerdictRow
from fembearing.report.phrases import (
    AXES,
    capital,
    digits,
    place_of,
    quantities_of,
    ring_line,
    shoulder_lines,
    title_of,
)


def verdict_section(document: Report) -> dict[str, Any]:
    """Tables and sentences of the section on verdicts."""
    contacts = document.contacts
    judged = [contact for contact in contacts if contact.judged]
    return {
        "axes": AXES,
        "verdicts": [(contact_title(contact), _rows(document, contact)) for contact in judged],
        "comparisons": [(contact_place(contact), _resolved(document, contact)) for contact in judged],
        "uncertainties": document.uncertainties,
        "shoulders": [(contact_place(contact), line) for contact in contacts for line in shoulder_lines(contact)],
        "rings": [(contact_place(contact), ring_line(contact.ring)) for contact in contacts if contact.ring],
        "pocket": _pocket(contacts),
        "pocket_load": f"{contacts[-1].load:g}",
        "interpolated": any(contact.corrected for contact in judged),
    }


def contact_title(contact: Contact) -> str:
    """Place and load of a contact, as they stand over its rows."""
    return title_of(contact.pair, contact.geometry, contact.contact_angle, f"{contact.load:.4g} N")


def contact_place(contact: Contact) -> str:
    """The place of a contact, as it begins a sentence."""
    return capital(place_of(contact.pair, contact.geometry))


def _rows(document: Report, contact: Contact) -> list[dict[str, Any]]:
    rows = document.verdicts_on(contact)
    return [
        {
            "quantity": quantity.heading,
            "production": digits(rows[name].production * quantity.shown.factor),
            "reference": digits(rows[name].reference * quantity.shown.factor),
            "discrepancy": f"{rows[name].discrepancy:+.2%}",
            "uncertainty": f"{_relative(rows[name]):.2%}",
            "resolved": "yes" if rows[name].comparison.resolved else "no",
            "verdict": rows[name].verdict,
            **_corrected(contact, name, quantity),
        }
        for name, quantity in quantities_of(contact).items()
    ]


def _relative(row: VerdictRow) -> float:
    """u_val over the reference."""
    return row.comparison.total / abs(row.reference)


def _corrected(contact: Contact, name: str, quantity: Quantity) -> dict[str, str]:
    """Hertz corrected for finite geometry, and its interpolation error."""
    corrected = contact.corrected
    if not corrected:
        return {"corrected": "-", "interpolation": "-"}
    value = corrected.values[name] * quantity.shown.factor
    return {"corrected": digits(value), "interpolation": f"{corrected.interpolation_error[name]:+.2%}"}


def _resolved(document: Report, contact: Contact) -> list[str]:
    """In sentences, what |E| against u_val says of Hertz in one contact."""
    rows, names = document.verdicts_on(contact), quantities_of(contact)
    parts: dict[bool, list[str]] = {True: [], False: []}
    for name, quantity in names.items():
        error, u_val = rows[name].discrepancy, _relative(rows[name])
        parts[rows[name].comparison.resolved].append(f"{quantity.name} {error:+.2%} +- {u_val:.2%}")
    sentences = []
    if parts[True]:
        sentences.append(f"|E| > u_val: the difference is resolved, and is Hertz's error: {', '.join(parts[True])}.")
    if parts[False]:
        sentences.append(
            f"|E| <= u_val: the difference is not resolved, Hertz's error is somewhere in {', '.join(parts[False])}."
        )
    return sentences


def _pocket(contacts: list[Contact]) -> list[dict[str, Any]]:
    """K_pb by each model, and the approach at the load; empty without a cage."""
    if len(contacts) < 4:
        return []
    seat, sheet = contacts[2:]
    formula = seat.hertz
    rows = [("Hertz: two half spaces", formula, None)]
    rows += [(place_of(each.pair, each.geometry), each.fe, each.uncertainty.stiffness) for each in (seat, sheet)]
    return [
        {
            "model": model,
            "stiffness": digits(values.stiffness * CONTACT["stiffness"].shown.factor, 4),
            "uncertainty": "" if uncertainty is None else f"{uncertainty:.2%}",
            "approach": digits(values.approach * CONTACT["approach"].shown.factor, 4),
            "change": f"{values.stiffness / formula.stiffness - 1:+.1%}",
        }
        for model, values, uncertainty in rows
    ]
