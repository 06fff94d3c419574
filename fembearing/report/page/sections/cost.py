"""What accuracy costs."""

from typing import Any

from fembearing.report.document.report import Report, Rung


def cost_section(document: Report) -> dict[str, Any]:
    """The table of the section on cost."""
    cost = document.cost
    return {
        "ladders": [(ladder, [_row(rung) for rung in ladder.rungs]) for ladder in cost.ladders],
        "measured": cost.measured,
        "seconds": f"{cost.seconds:.1f}",
    }


def _row(rung: Rung) -> dict[str, str]:
    error, bound, seconds = rung.error, rung.bound, rung.seconds
    return {
        "name": rung.name,
        "error": "failed" if rung.failed else "reference" if error is None else f"{100 * error:.2g} %",
        "bound": "" if bound is None else f"{100 * bound:.2g} %",
        "seconds": "" if seconds is None else f"{seconds:.2g}",
        "unknowns": str(rung.unknowns or ""),
        "remark": "enough for the tolerance" if rung.chosen else rung.failed or "",
    }
