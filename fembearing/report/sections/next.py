"""What to run or to change next."""

from collections.abc import Iterator

from fembearing.check.contact.scene_contact import place_of
from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.document import Bullets, Section
from fembearing.report.report import Report
from fembearing.report.sections.contacts import quantities_of
from fembearing.report.sections.limits import failures


def next_section(document: Report) -> Section:
    """All notes and warnings, and what to run or to change next."""
    notes = notes_of(document)
    said = [Bullets(notes, "Notes and warnings")] if notes else []
    judged = [each for each in document.contacts if each.judged]
    steps = [*(step for each in judged for step in _of_contact(document, each)), *_of_torque(document)]
    return Section("Warnings and next steps", [*said, Bullets(steps, "Next steps")])


def notes_of(document: Report) -> list[str]:
    """Limits that do not hold, what measurements show, the notes of the torque, and warnings."""
    measured = [] if document.measured is None else [document.measured.conclusions[0]]  # what is missed
    torque = () if document.solved is None else document.solved.notes
    return [*failures(document.physical), *measured, *torque, *document.warnings]


def _of_torque(document: Report) -> Iterator[str]:
    """The steps that the torque calls for."""
    torque = document.solved
    is_pair = torque is not None and torque.friction.pair is not None
    if torque is not None and torque.prediction is None:
        known = torque.interval is not None
        why = "95 % interval of the torque to first order; by samples" if known else "effect of the inputs not computed"
        yield f"{why}: fembearing validate SCENE --interval"
    if not document.cost.measured and not is_pair:
        yield "cost of a tighter tolerance not measured: fembearing cost SCENE"
    if torque is None:
        yield "no torque: give [friction] coefficient, or [lubricant] and [surface], in the scene"
        return
    if document.scene.friction_coefficient is not None:
        yield (
            "friction does not depend on speed, oil or finish: give [lubricant] and [surface] in place of the "
            "coefficient"
        )
    numerical = [point["uncertainty_numerical"] for point in torque.points]
    if any(part is None or part > document.tolerance for part in numerical):
        yield (
            "the torque's numerical uncertainty exceeds the tolerance: give a larger one, or look for the warnings of "
            "the torque"
        )
    yield (
        "the torque is not validated: measure it on this bearing with known load, speed, oil, oil temperature and "
        "finish, and compare it with the total"
    )


def _of_contact(document: Report, contact: ContactNumbers) -> Iterator[str]:
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
        yield f"{place}: Hertz fails in {failed}: {remedy}"
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
        yield f"{place}: undecided in {', '.join(open_to_meshes)}: {command}"
    if open_beyond:
        why = f"{place}: undecided in {', '.join(open_beyond)}, by the uncertainty from the size of the meshed block"
        yield f"{why}: a finer mesh does not help; give a tolerance farther from the discrepancy"
    if named("outside validity"):
        remedy = "give a smaller load or a wider groove, or use the finite-element values"
        yield f"{place}: outside the validity of Hertz, see the warnings: {remedy}"
