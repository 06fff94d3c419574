"""Errors of the peers against exact Hertz, and their table."""

from collections.abc import Iterable, Sequence
from typing import Any

from rich.console import Console
from rich.table import Table

from analytic import hertz_contact
from validation.peers.cases import Case

COLUMNS = {"approach": "delta", "semi_axis_x": "a", "semi_axis_y": "b", "peak_pressure": "p0"}


def exact_answers(cases: Iterable[Case]) -> dict[str, dict[str, float]]:
    """Hertz's answer to each case, SI; the tests check the formula against 40 digits."""
    exact = {}
    for case in cases:
        hertz = hertz_contact(
            curvature_x=case.curvature_x,
            curvature_y=case.curvature_y,
            load=case.load,
            modulus=case.youngs_modulus / (2 * (1 - case.poisson_ratio**2)),
        )
        exact[case.name] = {name: float(getattr(hertz, name)) for name in COLUMNS}
    return exact


def with_errors(rows: Sequence[dict[str, Any]], exact: dict[str, dict[str, float]]) -> list[dict[str, Any]]:
    """The rows with the relative error of each quantity and the worst error; failed rows stay as they are."""
    result = []
    for row in rows:
        if "failed" in row:
            result.append(row)
            continue
        errors = {name: row[name] / value - 1 for name, value in exact[row["case"]].items()}
        result.append({**row, "errors": errors, "worst": max(map(abs, errors.values()))})
    return result


def print_table(result: dict[str, Any]) -> None:
    out = Console(width=110)
    out.print(result["machine"])
    heads = [*(f"{word}, %" for word in COLUMNS.values()), "import, s", "solve, s", "MiB"]
    tables = dict.fromkeys((row["workflow"], row["case"]) for row in result["rows"])
    for workflow, name in tables:
        table = Table("peer", "step", "unknowns", *heads, title=f"{result['cases'][name]['title']}: {workflow}")
        for row in result["rows"]:
            if (row["workflow"], row["case"]) != (workflow, name):
                continue
            if "failed" in row:
                table.add_row(row["peer"], str(row["refinement"]), "failed")
                continue
            errors = [f"{100 * row['errors'][quantity]:+.4f}" for quantity in COLUMNS]
            seconds = [f"{row[clock]:.3g}" for clock in ("import_seconds", "solve_seconds")]
            memory = f"{row['memory'] / 2**20:.0f}" if row["memory"] else "-"
            table.add_row(row["peer"], str(row["refinement"]), str(row["unknowns"]), *errors, *seconds, memory)
        out.print(table)
    for peer, reason in result["skipped"].items():
        out.print(f"{peer} skipped: {reason}")
    for row in result["rows"]:
        if "failed" in row:
            name = f"{row['workflow']}: {row['peer']}, {row['case']}, refinement {row['refinement']}"
            out.print(f"{name} failed: {row['failed']}")
    out.print(f"Errors against exact Hertz. Solve times exclude imports. {result['seconds']:.0f} s in all.")
