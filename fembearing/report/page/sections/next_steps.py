"""What to run or to change next."""

from typing import Any

from fembearing.report.document.contact import Contact
from fembearing.report.document.report import Report
from fembearing.report.phrases import place_of, quantities_of


def next_section(document: Report) -> dict[str, Any]:
    """The list of the section on what to run next."""
    return {"next_steps": next_steps(document)}


def next_steps(document: Report) -> list[tuple[str, str]]:
    """Why, and what to do; a command in the second begins with "fembearing"."""
    scene, torque = document.provenance.scene_content, document.torque
    uncertain = [] if torque is None else [point.uncertainty.numerical for point in torque.points]
    steps = [step for contact in document.contacts if contact.judged for step in _of_contact(document, contact)]
    rows = (
        (
            any(case.outcome == "wrong" for case in document.hard),
            "a hard case went wrong, on this machine or in this version",
            "tell its authors, and rely on no number until then",
        ),
        (
            not document.hard,
            "whether this installation gets hard cases right is not tried",
            "fembearing validate SCENE --hard",
        ),
        (not document.cost.measured, "what a tighter tolerance costs is not measured", "fembearing cost SCENE"),
        (
            torque is None,
            "there is no torque",
            "give [friction] coefficient, or [lubricant] and [surface], in the scene",
        ),
        (
            torque is not None and scene.friction_coefficient is not None,
            "friction does not depend on speed, oil or finish",
            "give [lubricant] and [surface] in place of the coefficient",
        ),
        (
            any(part is None or part > document.tolerance for part in uncertain),
            "the torque's numerical uncertainty exceeds the tolerance or is not known",
            "switch on what is left out, see the effects",
        ),
        (
            torque is not None,
            "the torque is not validated",
            "measure it on this bearing with load, speed, oil, its temperature and the finish known, and set it beside "
            "the total",
        ),
    )
    return steps + [(why, what) for applies, why, what in rows if applies]


def _of_contact(document: Report, contact: Contact) -> list[tuple[str, str]]:
    rows, names = document.verdicts_on(contact), quantities_of(contact)
    place = place_of(contact.pair, contact.geometry)

    def named(verdict: str) -> str:
        return ", ".join(names[name].name for name, row in rows.items() if row.verdict == verdict)

    steps = []
    if failed := named("fail"):
        remedy = (
            "the scene's tolerance is beyond Hertz here, and the correction's fit does not reach it: take the "
            "finite-element values, or a wider tolerance"
        )
        if contact.corrected:
            worst = max(abs(error) for _, error in contact.corrected.interpolation_error)
            remedy = f'effects.finite_geometry = "on" corrects Hertz, to {worst:.2%} of the finite elements here'
        steps.append((f"{place}: Hertz fails in {failed}", remedy))
    open_to_meshes, open_beyond = [], []
    for name, row in rows.items():
        if row.verdict == "undecided":
            from_tolerance = abs(abs(row.discrepancy) - document.tolerance)
            beyond = from_tolerance <= contact.convergence[name].domain  # which no finer mesh lowers
            (open_beyond if beyond else open_to_meshes).append(names[name].name)
    if open_to_meshes:
        finer = 100 * document.tolerance / 20
        steps.append(
            (
                f"{place}: undecided in {', '.join(open_to_meshes)}",
                f'fembearing contact SCENE --pair {contact.pair} --tolerance "{finer:.2g} %"',
            )
        )
    if open_beyond:
        steps.append(
            (
                f"{place}: undecided in {', '.join(open_beyond)}, as the size of the meshed block leaves it open",
                "no finer mesh decides it: ask for a tolerance farther from the discrepancy",
            )
        )
    if named("outside validity"):
        steps.append(
            (
                f"{place}: outside the validity of Hertz, see the warnings",
                "a smaller load or a wider groove; else take the finite-element values",
            )
        )
    return steps
