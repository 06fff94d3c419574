"""Friction coefficients over the operating points, and where they come from: film thickness and asperities."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.scene import Array
from fembearing.report.figures.series_axis import SeriesAxis, axis_of
from fembearing.report.figures.style import BLUE, GREEN, GREY, LETTERS, RED, WIDTH, lettered, scaled
from fembearing.report.figures.torque import NO_TORQUE
from fembearing.report.report import Report

LOOKS = {"inner": (BLUE, "o", "-"), "outer": (RED, "s", "--"), "pocket": (GREEN, "^", ":")}  # lines may lie on another
HIGH = 2.6  # inches
PARTED = 3.0  # film over roughness, from which hardly a summit touches: a rule of thumb
NOTHING_SLIDES = "No friction coefficient: no sliding was computed."


def friction_plot(document: Report) -> tuple[Figure | None, str]:
    """Coefficients; where a film was computed, its thickness over the roughness, and the load on asperities."""
    if document.torque is None:
        return None, NO_TORQUE
    if len(document.torque.points) == 1:
        return None, ""  # a table says it
    axis, gap = axis_of(document.torque.points, document.units), document.torque.gap_roughness
    coefficients = {name: values for name in LOOKS if (values := axis.of("friction_coefficient", name)) is not None}
    if not coefficients:
        return None, NOTHING_SLIDES
    races = ("inner", "outer")
    films = {name: values / gap for name in races if gap and (values := axis.of("film", name)) is not None}
    shares = {name: 100 * values for name in races if (values := axis.of("asperity_share", name)) is not None}
    shown = [(coefficients, "friction coefficient", "Friction")]
    caption = "Friction coefficient of the heaviest ball on each race"
    caption += ", and of ball on pocket." if "pocket" in coefficients else "."
    if films:
        shown.append((films, "film over roughness", "Film"))
        caption += (
            " Film: central thickness over the rms roughness of both surfaces together; few asperities touch above "
            f"{PARTED:g}."
        )
    if shares:
        shown.append((shares, "load on asperities, %", "Asperities"))
        caption += " Asperities: share of the load on asperities, with boundary friction."
    if not films and not shares:
        caption += " No film: the scene gives a constant coefficient of the races."
    figure = Figure(figsize=(WIDTH, HIGH), layout="constrained")
    panels = figure.subplots(1, len(shown), squeeze=False)[0]
    for panel, (curves, label, title) in zip(panels, shown, strict=True):
        _curves(panel, axis, curves)
        panel.set_ylabel(label)
        panel.set_title(title)
        if title == "Film" and panel.get_ylim()[0] < PARTED < panel.get_ylim()[1]:
            panel.axhline(PARTED, color=GREY, linewidth=1, linestyle="-.", label="summits part, about")
    handles = {words: line for panel in panels for line, words in zip(*panel.get_legend_handles_labels(), strict=True)}
    figure.legend(
        handles.values(), handles.keys(), loc="outside lower center", ncols=4, frameon=False, fontsize=LETTERS
    )
    return lettered(figure), caption


def _curves(panel: Axes, axis: SeriesAxis, curves: dict[str, Array]) -> None:
    """One line for each contact, on a scale that fits all of them."""
    for name, values in curves.items():
        colour, mark, line = LOOKS[name]
        style = f"{line if axis.joined else ''}{mark if axis.mark else ''}"
        panel.plot(axis.values, values, style, color=colour, markersize=5, label=name)
    every = np.concatenate(list(curves.values()))
    scaled(panel, every)
    if panel.get_yscale() == "linear":
        panel.set_ylim(0, 1.15 * max(float(np.nanmax(every)), 1e-12))
    axis.apply(panel)
    panel.grid(alpha=0.3)
