"""What each quantity of the report has been compared with."""

from typing import Any

from analytic.oil.film import FORMULA_UNCERTAINTY
from fembearing.report.document.report import Report


def use_section(document: Report) -> dict[str, Any]:
    """The table of the section on intended use."""
    return {"compared": _compared(document)}


def _compared(document: Report) -> list[tuple[str, str, str]]:
    """Quantity, what it was compared with here, and what measurement says of it."""
    scene, film = document.provenance.scene_content, f"{200 * FORMULA_UNCERTAINTY:.0f} %"
    rows = (
        (
            True,
            "approach, semi-axes, peak pressure, stiffness",
            "finite elements on the true shapes: cross-check, below",
            "not validated",
        ),
        (
            document.torque is not None,
            "friction torque",
            "the same formulas with finite-element contacts: cross-check, below",
            "not validated: no open measurement of such a bearing with complete conditions was found",
        ),
        (
            scene.lubricant is not None,
            "film thickness",
            "nothing in this report",
            f"the formula alone, by films of a ball on a disc: within {film} of them at 95 %",
        ),
        (
            scene.cage is not None,
            "cage: stiffness of the pocket; forces and torque",
            "finite elements: cross-check, below; forces and torque with nothing",
            "not validated",
        ),
    )
    return [(quantity, datum, measured) for applies, quantity, datum, measured in rows if applies]
