"""How the meshes of a validation converge, as a plot."""

from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from fembearing.report.wording import QUANTITIES, Told, place_of

DOTS = 110  # per inch
MARKS = "os^D"
SAME = 1e-6  # relative: what is nearer to its limit is drawn here


def convergence_figure(document: Told) -> Figure:
    """Each quantity's distance from its extrapolated value against the number of unknowns."""
    contacts = document["contacts"]
    figure = Figure(figsize=(11, 6.4), layout="constrained")
    panels = figure.subplots(2, 3, sharex=True).ravel()
    for panel, (name, shown) in zip(panels, QUANTITIES.items(), strict=False):
        for mark, contact in zip(MARKS, contacts, strict=False):
            _convergence(panel, contact, name, mark)
        cut = name == "peak_pressure" and any(contact["shoulder"] for contact in contacts)
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


def _convergence(panel: Axes, contact: Told, name: str, mark: str) -> None:
    part = contact["convergence"][name]
    values, richardson = part["values"], part["richardson"]
    limit = values[-1] if richardson is None else richardson
    distance = 100 * np.maximum(np.abs(np.array(values) / limit - 1), SAME)
    unknowns = [mesh["unknowns"] for mesh in contact["meshes"]]
    if richardson is None:  # its own finest mesh is the limit
        unknowns, distance = unknowns[:-1], distance[:-1]
    style = "--" if richardson is None else "-"
    panel.plot(unknowns, distance, style + mark, label=place_of(contact), markersize=5)


def png(figure: Figure) -> bytes:
    """The figure as a file."""
    content = BytesIO()
    figure.savefig(content, dpi=DOTS, format="png")
    return content.getvalue()
