"""Table and figure of all numbers that the model is compared with."""

import csv
from collections.abc import Iterator, Sequence
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike

from validation.measured.anchor import Anchor

mpl.use("agg")

COLOURS = {"measured": "C0", "second hand": "C2", "maker's formula": "C1", "formula": "0.5", "trend": "C4"}
RANGES = ("theirs", "ours", "E_percent", "u_val_percent")


def anchors_page(anchors: Sequence[Anchor]) -> str:
    """anchors.md, in markdown; every number in it is computed."""
    return "\n".join(_lines(anchors)) + "\n"


def _lines(anchors: Sequence[Anchor]) -> Iterator[str]:
    yield "# All anchors"
    yield ""
    yield (
        "Ranges over the points of a source, E = ours - theirs over theirs, u_val standard. First what is missed by "
        "more than 2 u_val; then what has no stated uncertainty, from the largest ratio on; then what is within. "
        "Q D: load times ball diameter. Nothing is fitted to what it is compared with here, and none of these "
        "comparisons validates the torque of a whole bearing."
    )
    yield ""
    yield "| what | from | kind | theirs | ours | E, % | u_val, % | beyond 2 u_val | what it is worth |"
    yield "| --- " * 9 + "|"
    for each in anchors:
        unit = "" if each.unit == "1" else f" {each.unit}"
        error, u_val = 100 * each.error, each.relative_uncertainty
        judged = "- | -" if u_val is None else f"{_ends(100 * u_val, '.1f')} | {each.missed} of {error.size}"
        yield (
            f"| {each.what} | {each.source} | {each.kind} | {_ends(each.theirs)}{unit} | {_ends(each.ours)}{unit} | "
            f"{_ends(error, '+.1f')} | {judged} | {each.worth} |"
        )
    yield ""
    yield "![Ours over theirs for every number that the model is compared with](anchors.png)"


def _ends(values: ArrayLike, form: str = ".4g") -> str:
    return " to ".join(dict.fromkeys(f"{end:{form}}" for end in (np.nanmin(values), np.nanmax(values))))


def write_anchors(anchors: Sequence[Anchor], path: Path) -> None:
    """One row for each anchor; ranges over its points, E and u_val over theirs."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file)
        columns = (f"{name}_{end}" for name in RANGES for end in ("low", "high"))
        writer.writerow(("what", "source", "kind", "unit", "points", *columns, "beyond_2_u_val", "worth"))
        for each in anchors:
            u_val = each.relative_uncertainty
            found = [each.theirs, each.ours, 100 * each.error] + ([] if u_val is None else [100 * u_val])
            ends = [f"{end:.4g}" for values in found for end in (np.nanmin(values), np.nanmax(values))]
            judged = ["", "", ""] if u_val is None else [each.missed]
            writer.writerow((each.what, each.source, each.kind, each.unit, each.error.size, *ends, *judged, each.worth))


def draw_anchors(anchors: Sequence[Anchor], path: Path) -> None:
    figure = Figure(figsize=(11, 14), layout="constrained")
    _draw(figure.subplots(), anchors)
    figure.savefig(path, dpi=110, metadata={"Software": None})


def _draw(axes: Axes, anchors: Sequence[Anchor]) -> None:
    for place, each in enumerate(reversed(anchors)):
        ratio, u_val = 1 + each.error, each.relative_uncertainty
        if u_val is not None:
            axes.barh(place, 4 * u_val.max(), left=1 - 2 * u_val.max(), height=0.8, color="0.88")
        axes.plot([ratio.min(), ratio.max()], [place] * 2, "|-", color=COLOURS[each.kind], lw=3, solid_capstyle="butt")
        if each.missed:
            axes.plot(ratio[np.argmax(np.abs(each.error))], place, "kx", ms=7)
    names = [f"{each.what}\n{each.source} ({each.kind})" for each in reversed(anchors)]
    axes.set_yticks(range(len(anchors)), names, fontsize=6)
    axes.set_ylim(-0.7, len(anchors) - 0.3)
    axes.axvline(1, color="k", lw=0.8)
    axes.set_xscale("log")
    ticks = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5]
    axes.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
    axes.minorticks_off()
    axes.grid(visible=True, axis="x", color="0.9")
    axes.set_axisbelow(True)
    axes.set_xlabel("ours over theirs; grey: 2 u_val; cross: missed")
