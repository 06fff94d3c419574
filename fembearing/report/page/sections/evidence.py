"""What each quantity has been compared with, and what to run next."""

from typing import Any

from analytic.oil.film import FORMULA_UNCERTAINTY
from fembearing.report.page.sections.verdicts import verdicts_of
from fembearing.report.words import Told, place_of, quantities_of


def standing_section(document: Told) -> dict[str, Any]:
    return {"compared": _compared(document), "next_steps": next_steps(document)}


def _compared(document: Told) -> list[tuple[str, str, str]]:
    """Quantity, what it was compared with here, and what measurement says of it."""
    scene, film = document["provenance"]["scene_content"], f"{200 * FORMULA_UNCERTAINTY:.0f} %"
    rows = (
        (
            True,
            "approach, semi-axes, peak pressure, stiffness",
            "finite elements on the true shapes: cross-check, below",
            "not validated",
        ),
        (
            document["torque"] is not None,
            "friction torque",
            "the same formulas with finite-element contacts: cross-check, below",
            "not validated: no open measurement of such a bearing with complete conditions was found",
        ),
        (
            scene["lubricant"] is not None,
            "film thickness",
            "nothing in this report",
            f"the formula alone, by films of a ball on a disc: within {film} of them at 95 %",
        ),
        (
            scene["cage"] is not None,
            "cage: stiffness of the pocket; forces and torque",
            "finite elements: cross-check, below; forces and torque with nothing",
            "not validated",
        ),
    )
    return [(quantity, datum, found) for applies, quantity, datum, found in rows if applies]


def next_steps(document: Told) -> list[tuple[str, str]]:
    """Why, and what to do; a command in the second begins with "fembearing"."""
    scene, torque = document["provenance"]["scene_content"], document["torque"]
    points = [] if torque is None else torque["points"]
    uncertain = [point["uncertainty"]["numerical"] for point in points]
    found = [step for contact in document["contacts"] if contact["judged"] for step in _of_contact(document, contact)]
    rows = (
        (
            any(case["outcome"] == "wrong" for case in document["hard"]),
            "a hard case went wrong, on this machine or in this version",
            "tell its authors, and rely on no number before",
        ),
        (
            not document["hard"],
            "whether this installation gets hard cases right is not tried",
            "fembearing validate SCENE --hard",
        ),
        (not document["cost"]["measured"], "what a tighter tolerance costs is not measured", "fembearing cost SCENE"),
        (
            torque is None,
            "there is no torque",
            "give [friction] coefficient, or [lubricant] and [surface], in the scene",
        ),
        (
            torque is not None and scene["friction_coefficient"] is not None,
            "friction does not depend on speed, oil or finish",
            "give [lubricant] and [surface] in place of the coefficient",
        ),
        (
            any(part is None or part > document["tolerance"] for part in uncertain),
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
    return found + [(why, what) for applies, why, what in rows if applies]


def _of_contact(document: Told, contact: Told) -> list[tuple[str, str]]:
    rows, names, place = verdicts_of(document, contact), quantities_of(contact), place_of(contact)

    def named(verdict: str) -> str:
        return ", ".join(names[name].name for name, row in rows.items() if row["verdict"] == verdict)

    found = []
    if failed := named("fail"):
        corrected = contact["corrected"]
        remedy = (
            "the scene's tolerance is beyond Hertz here, and the correction's fit does not reach it: take the "
            "finite-element values, or a wider tolerance"
        )
        if corrected:
            worst = max(map(abs, corrected["interpolation_error"].values()))
            remedy = f'effects.finite_geometry = "on" corrects Hertz, to {worst:.2%} of the finite elements here'
        found.append((f"{place}: Hertz fails in {failed}", remedy))
    open_to_meshes, open_beyond = [], []
    for name, row in rows.items():
        if row["verdict"] == "undecided":
            from_tolerance = abs(abs(row["discrepancy"]) - document["tolerance"])
            beyond = from_tolerance <= contact["convergence"][name]["domain"]  # which no finer mesh lowers
            (open_beyond if beyond else open_to_meshes).append(names[name].name)
    if open_to_meshes:
        asked = 100 * document["tolerance"] / 20
        found.append(
            (
                f"{place}: undecided in {', '.join(open_to_meshes)}",
                f'fembearing contact SCENE --pair {contact["pair"]} --tolerance "{asked:.2g} %"',
            )
        )
    if open_beyond:
        found.append(
            (
                f"{place}: undecided in {', '.join(open_beyond)}, as the size of the meshed block leaves it open",
                "no finer mesh decides it: ask for a tolerance farther from the discrepancy",
            )
        )
    if named("outside validity"):
        found.append(
            (
                f"{place}: outside the validity of Hertz, see the warnings",
                "a smaller load or a wider groove; else take the finite-element values",
            )
        )
    return found
