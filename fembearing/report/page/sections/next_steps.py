"""What to run or to change next."""

from collections.abc import Iterator
from typing import NamedTuple

from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.phrases import place_of, quantities_of
from fembearing.report.report import Report


class Step(NamedTuple):
    """What to do next."""

    why: str
    what: str  # a command begins with "fembearing"


class NextSection(NamedTuple):
    """The steps of the contacts; the template has the others."""

    steps: list[Step]
    uncertain: bool  # whether the torque's numerical uncertainty exceeds the tolerance or is not known


def next_section(document: Report) -> NextSection:
    """What to do next for each contact."""
    points = () if document.solved is None else document.solved.points
    numerical = [point["uncertainty_numerical"] for point in points]
    return NextSection(
        steps=[step for each in document.contacts if each.judged for step in _of_contact(document, each)],
        uncertain=any(part is None or part > document.tolerance for part in numerical),
    )


def _of_contact(document: Report, contact: ContactNumbers) -> Iterator[Step]:
    """The steps that the verdicts on one contact call for."""
    rows, names = contact.quantities, quantities_of(contact)
    place = place_of(contact.pair, contact.geometry, contact.bearing)

    def named(verdict: str) -> str:
        return ", ".join(names[name].name for name, row in rows.items() if row.verdict == verdict)

    if failed := named("fail"):
        remedy = (
            "Hertz does not reach the tolerance, and the contact is outside the fit for its correction: use the "
            "finite-element values, or a wider tolerance"
        )
        if contact.corrected:
            worst = max(abs(error) for error in contact.interpolation_error.values())
            remedy = f'effects.finite_geometry = "on" corrects Hertz, to {worst:.2%} of the finite elements here'
        yield Step(f"{place}: Hertz fails in {failed}", remedy)
    open_to_meshes, open_beyond = [], []
    for name, row in rows.items():
        if row.verdict == "undecided":
            from_tolerance = abs(abs(row.difference) - document.tolerance)
            beyond = from_tolerance <= contact.estimates[name].domain  # which no finer mesh lowers
            (open_beyond if beyond else open_to_meshes).append(names[name].name)
    if open_to_meshes:
        command = f'fembearing contact SCENE --pair {contact.pair} --tolerance "{100 * document.tolerance / 20:.2g} %"'
        if contact.bearing is not None:
            command = "leave out [arrangement], give the loads of this bearing, and solve this contact alone"
        yield Step(f"{place}: undecided in {', '.join(open_to_meshes)}", command)
    if open_beyond:
        why = f"{place}: undecided in {', '.join(open_beyond)}, by the uncertainty from the size of the meshed block"
        yield Step(why, "a finer mesh does not help: give a tolerance farther from the discrepancy")
    if named("outside validity"):
        remedy = "give a smaller load or a wider groove, or use the finite-element values"
        yield Step(f"{place}: outside the validity of Hertz, see the warnings", remedy)
