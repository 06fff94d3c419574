"""The picture of a speed record: seconds of every row in two trees, and the goals."""

from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.figure import Figure

mpl.use("agg")


def draw(result: dict[str, Any], path: Path) -> None:
    """One line for each row that is measured in seconds, the first on top."""
    rows = [row for row in result["rows"] if row["unit"] == "s"]
    figure = Figure(figsize=(9, 1.4 + 0.27 * len(rows)), layout="constrained")
    panel = figure.subplots()
    series = {
        "recorded_figure": (f"at {result['against'][:9]}", {"marker": "o", "color": "C7"}),
        "figure": (f"at {result['commit'][:9]}", {"marker": "o", "color": "C0"}),
        "goal": ("goal", {"marker": "|", "color": "C3", "markersize": 12}),
    }
    for name, (label, style) in series.items():
        points = [(row[name], place) for place, row in enumerate(rows) if row[name] is not None]
        if points:
            panel.plot(*zip(*points, strict=True), linestyle="", label=label, **style)
    panel.set_xscale("log")
    panel.set_xlabel("seconds")
    panel.set_yticks(range(len(rows)), [row["title"] for row in rows], fontsize="small")
    panel.invert_yaxis()
    panel.grid(axis="x", alpha=0.4)
    figure.legend(loc="outside lower center", ncols=len(series), fontsize="small")
    figure.savefig(path, dpi=130)
