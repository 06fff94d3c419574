"""Table and figure of the peers: errors against exact Hertz, seconds and memory."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from analytic import hertz_contact
from validation.study import figure, out, save, show

COLUMNS = {"approach": "delta", "semi_axis_x": "a", "semi_axis_y": "b", "peak_pressure": "p0"}
COSTS = {"solve_seconds": ("time to solve, s", 1.0), "memory": ("largest memory of the process, MiB", 1 / 2**20)}
MARKS = {"ours": ("o", "C0"), "tamaas": ("s", "C1"), "ngsolve": ("^", "C2"), "calculix": ("D", "C3")}


def exact_answer(case: dict[str, Any]) -> dict[str, float]:
    """Hertz's answer to a case, SI; the tests check the formula against 100 digits."""
    modulus = case["youngs_modulus"] / (2 * (1 - case["poisson_ratio"] ** 2))
    known = {name: case[name] for name in ("curvature_x", "curvature_y", "load")}
    hertz = hertz_contact(**known, modulus=modulus)
    return {name: float(getattr(hertz, name)) for name in COLUMNS}


def with_errors(rows: Sequence[dict[str, Any]], exact: dict[str, dict[str, float]]) -> Iterator[dict[str, Any]]:
    """The rows with the relative error of each quantity and the worst error; failed rows stay as they are."""
    for row in rows:
        if "failed" in row:
            yield row
        else:
            errors = {name: row[name] / value - 1 for name, value in exact[row["case"]].items()}
            yield {**row, "errors": errors, "worst": max(map(abs, errors.values()))}


def print_table(result: dict[str, Any]) -> None:
    out.print(result["machine"])
    heads = ("peer", "step", "unknowns", *(f"{word}, %" for word in COLUMNS.values()), "import, s", "solve, s", "MiB")
    for name, case in result["cases"].items():
        rows = (_cells(row) for row in result["rows"] if row["case"] == name and "failed" not in row)
        show(heads, rows, case["title"])
    for peer, reason in result["skipped"].items():
        out.print(f"{peer} skipped: {reason}")
    for row in result["rows"]:
        if "failed" in row:
            out.print(f"{row['peer']}, {row['case']}, refinement {row['refinement']} failed: {row['failed']}")
    out.print(f"Errors against exact Hertz. Solve times exclude imports. {result['seconds']:.0f} s in all.")


def _cells(row: dict[str, Any]) -> tuple[object, ...]:
    errors = (f"{100 * row['errors'][quantity]:+.4f}" for quantity in COLUMNS)
    seconds = (f"{row[clock]:.3g}" for clock in ("import_seconds", "solve_seconds"))
    memory = f"{row['memory'] / 2**20:.0f}" if row["memory"] else "-"
    return row["peer"], row["refinement"], row["unknowns"], *errors, *seconds, memory


def draw(result: dict[str, Any], path: Path, *, names: dict[str, str]) -> None:
    """Error against cost: one row for each case, one column for each cost, one line for each peer."""
    cases = result["cases"]
    drawn = figure(10, 0.8 + 3.6 * len(cases))
    panels = drawn.subplots(len(cases), len(COSTS), squeeze=False, sharey="row")
    for row, (name, case) in zip(panels, cases.items(), strict=True):
        for panel, (cost, (label, unit)) in zip(row, COSTS.items(), strict=True):
            solved = [each for each in result["rows"] if each["case"] == name and "worst" in each and each[cost]]
            for peer in dict.fromkeys(each["peer"] for each in solved):
                mark, colour = MARKS[peer]
                points = [(unit * each[cost], 100 * each["worst"]) for each in solved if each["peer"] == peer]
                panel.loglog(*zip(*points, strict=True), marker=mark, color=colour, label=names[peer])
            if cost == "memory":  # spans little more than a factor of ten
                panel.set_xscale("log", base=2)
            panel.xaxis.set_major_formatter("{x:g}")
            panel.yaxis.set_major_formatter("{x:g}")
            panel.set_xlabel(label)
            panel.set_title(case["title"], fontsize="medium")
            panel.grid(which="major", alpha=0.4)
        row[0].set_ylabel("worst error of approach, semi-axes\nand peak pressure against Hertz, %")
    panels[0, 0].legend(fontsize="small")
    drawn.supxlabel(f"Two half spaces of steel. {result['machine']}. Time without imports.", fontsize="small")
    save(drawn, path)
