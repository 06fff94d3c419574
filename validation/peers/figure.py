"""The figure of the peers: error against cost."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

mpl.use("agg")

COSTS = {"solve_seconds": ("time to solve, s", 1.0), "memory": ("largest memory of the process, MiB", 1 / 2**20)}
MARKS = {"ours": ("o", "C0"), "tamaas": ("s", "C1"), "ngsolve": ("^", "C2"), "calculix": ("D", "C3")}
PER_CENT = 100.0


def draw(result: dict[str, Any], path: Path, *, names: dict[str, str]) -> None:
    """One row for each case, one column for each cost, one line for each peer and workflow; the ordinary one dotted."""
    cases = result["cases"]
    figure = Figure(figsize=(10, 0.8 + 3.6 * len(cases)), layout="constrained")
    panels = figure.subplots(len(cases), len(COSTS), squeeze=False, sharey="row")
    for row, (name, case) in zip(panels, cases.items(), strict=True):
        for panel, (cost, (label, unit)) in zip(row, COSTS.items(), strict=True):
            for peer, workflow in dict.fromkeys((each["peer"], each["workflow"]) for each in result["rows"]):
                mark, colour = MARKS[peer]
                ordinary = workflow == "ordinary"
                shown = [
                    each
                    for each in result["rows"]
                    if (each["peer"], each["workflow"], each["case"]) == (peer, workflow, name)
                ]
                points = [
                    (unit * each[cost], PER_CENT * each["worst"]) for each in shown if "worst" in each and each[cost]
                ]
                if points:
                    style = {"marker": mark, "color": colour, "linestyle": ":" if ordinary else "-"}
                    label_of = None if ordinary else names[peer]
                    panel.loglog(*zip(*points, strict=True), **style, label=label_of)
            panel.xaxis.set_major_formatter("{x:g}")
            panel.yaxis.set_major_formatter("{x:g}")
            if cost == "memory":  # spans little more than a factor of ten
                panel.set_xscale("log", base=2)
                panel.xaxis.set_major_formatter("{x:g}")
            panel.set_xlabel(label)
            panel.set_title(case["title"], fontsize="medium")
            panel.grid(which="major", alpha=0.4)
        row[0].set_ylabel("worst error of approach, semi-axes\nand peak pressure against Hertz, %")
    panels[0, 0].legend(fontsize="small")
    note = f"Two half spaces of steel; dotted: ordinary workflow. {result['machine']}. Time without imports."
    figure.supxlabel(note, fontsize="small")
    figure.savefig(path, dpi=130)
