"""Plots of a validation: how the meshes converge, and what accuracy costs."""

from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from fembearing.compare.cost import Ladder
from fembearing.compare.discrepancy import ContactSolution
from fembearing.compare.validation import Validation
from fembearing.report.wording import QUANTITIES, place_of

DOTS = 110  # per inch
MARKS = "os^D"
# Where the names of a ladder's rungs stand, points from theirs: the formulas of all pairs nearly coincide.
BESIDE = ((5, 5, "left"), (5, -11, "left"), (-5, 5, "right"))
SAME = 1e-6  # relative: what is nearer to its limit is drawn here


def convergence_figure(result: Validation) -> Figure:
    """Each quantity's distance from its extrapolated value against the number of unknowns."""
    figure = Figure(figsize=(11, 6.4), layout="constrained")
    panels = figure.subplots(2, 3, sharex=True).ravel()
    for panel, (name, shown) in zip(panels, QUANTITIES.items(), strict=False):
        for mark, contact in zip(MARKS, result.contacts, strict=False):
            _convergence(panel, contact, name, mark)
        cut = name == "peak_pressure" and any(contact.shoulder for contact in result.contacts)
        panel.set(title=f"{shown.name}{', cut off: at y = 0' if cut else ''}", xscale="log", yscale="log")
        panel.grid(alpha=0.3, which="both")
        panel.xaxis.set_minor_formatter(NullFormatter())  # over one decade they would run into each other
    panels[3].set_xlabel("unknowns")
    panels[4].set_xlabel("unknowns")
    for panel in (panels[0], panels[3]):
        panel.set_ylabel("distance from the limit, %")
    panels[-1].set_axis_off()
    panels[-1].legend(*panels[0].get_legend_handles_labels(), loc="center", frameon=False)
    return figure


def _convergence(panel: Axes, contact: ContactSolution, name: str, mark: str) -> None:
    part = contact.estimates[name]
    distance = 100 * np.maximum(np.abs(np.array(part.values) / part.limit - 1), SAME)
    unknowns = [mesh.unknowns for mesh in contact.meshes]
    if part.richardson is None:  # its own finest mesh is the limit
        unknowns, distance = unknowns[:-1], distance[:-1]
    style = "--" if part.richardson is None else "-"
    panel.plot(unknowns, distance, style + mark, label=place_of(contact), markersize=5)


def cost_figure(ladders: list[Ladder], *, tolerance: float) -> Figure:
    """Error of each rung against its median time."""
    figure = Figure(figsize=(11, 4.2), layout="constrained")
    axes = figure.subplots()
    for mark, (right, up, side), ladder in zip(MARKS, BESIDE, ladders, strict=False):
        shown = [
            (rung.seconds, 100 * max(rung.error, SAME), rung.name.removeprefix("finite elements, "))
            for rung in ladder.rungs
            if rung.error is not None and rung.seconds is not None
        ]
        seconds, errors, names = zip(*shown, strict=True)
        (line,) = axes.plot(seconds, errors, "-" + mark, label=ladder.quantity)
        for place, name in zip(zip(seconds, errors, strict=True), names, strict=True):
            colour = line.get_color()
            axes.annotate(
                name, place, xytext=(right, up), textcoords="offset points", ha=side, fontsize=8, color=colour
            )
    axes.axhline(100 * tolerance, color="red", linestyle=":", label=f"tolerance {tolerance:.3g}")
    axes.set(xscale="log", yscale="log", xlabel="time, s", ylabel="error, %")
    axes.grid(alpha=0.3, which="both")
    axes.legend(frameon=False)
    return figure


def png(figure: Figure) -> bytes:
    """The figure as a file."""
    content = BytesIO()
    figure.savefig(content, dpi=DOTS, format="png")
    return content.getvalue()
