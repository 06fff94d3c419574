"""What is resolved of Hertz's errors: the difference from finite elements against the uncertainty of the comparison."""

from collections.abc import Iterator

from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.phrases import contact_place, quantities_of
from fembearing.report.report import Report


def comparisons_of(document: Report) -> list[tuple[str, str]]:
    """Place of a contact, and a sentence."""
    judged = [contact for contact in document.contacts if contact.judged]
    return [(contact_place(contact), line) for contact in judged for line in _resolved(contact)]


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
