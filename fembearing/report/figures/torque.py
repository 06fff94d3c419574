"""The friction torque over the operating points, split by effect, with the paper's values."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.quantities import QUANTITIES
from fembearing.report.figures.series_axis import SeriesAxis, axis_of
from fembearing.report.figures.style import (
    BLACK,
    BLUE,
    GREEN,
    GREY,
    LETTERS,
    ORANGE,
    PURPLE,
    SKY,
    WIDTH,
    YELLOW,
    lettered,
)
from fembearing.report.report import Report

PARTS = {  # from the bottom, with words for the legend
    "spin": ("spin", BLUE),
    "conformity": ("conformity slip", SKY),
    "hysteresis": ("hysteresis", GREEN),
    "rolling": ("rolling against the oil", ORANGE),
    "cage": ("cage", PURPLE),
    "oil": ("oil outside the contacts", YELLOW),
    "declared": ("declared: seals, drag", GREY),
}
BAR = 0.6  # width
HIGH = 3.1  # inches
NO_TORQUE = "No torque: the scene gives neither a friction coefficient nor both lubricant and surface."


def torque_plot(document: Report) -> tuple[Figure | None, str]:
    """Parts stacked up to the total, with the uncertainty of the total."""
    if document.torque is None:
        return None, NO_TORQUE
    if len(document.torque.points) == 1:
        return None, ""  # a table says it
    axis = axis_of(document.torque.points, document.units)
    figure = Figure(figsize=(WIDTH, HIGH), layout="constrained")
    panel = figure.subplots()
    draw_parts(panel, axis)
    known = _total(panel, axis)
    axis.apply(panel)
    panel.set_ylabel(QUANTITIES["torque"].in_units(document.units).heading)
    panel.set_title(axis.fixed)
    panel.set_ylim(0, None)
    panel.grid(alpha=0.3)
    handles, words = panel.get_legend_handles_labels()
    figure.legend(handles, words, loc="outside right upper", frameon=False, fontsize=LETTERS)
    caption = "The parts of the torque, stacked: their upper edge is the total. "
    caption += f"{'Dashed' if axis.joined else 'Bars'}: its uncertainty, {known}."
    if document.cage_records:
        caption += " The cage is in it with its motion."
    return lettered(figure), caption


def draw_parts(panel: Axes, axis: SeriesAxis) -> None:
    """Draw the parts, stacked."""
    below = np.zeros(axis.values.size)
    for name, (words, colour) in PARTS.items():
        part = axis.of("torque", name)
        if part is None:
            continue
        above = below + axis.units.torque.factor * part
        if axis.joined:
            panel.fill_between(axis.values, below, above, color=colour, alpha=0.75, linewidth=0, label=words)
        else:
            panel.bar(axis.values, above - below, BAR, bottom=below, color=colour, alpha=0.75, label=words)
        below = above


def _total(panel: Axes, axis: SeriesAxis) -> str:
    """Draw the total with its uncertainty; gives what that uncertainty covers."""
    total = axis.of("torque", "total")
    assert total is not None  # the total is always there
    total = axis.units.torque.factor * total
    numerical, model = axis.of("uncertainty", "numerical"), axis.of("uncertainty", "model")
    half = sum((part for part in (numerical, model) if part is not None), start=np.zeros(total.size))
    low, high = total * (1 - half), total * (1 + half)
    if axis.joined:
        for edge, label in ((low, "its uncertainty"), (high, "_")):
            panel.plot(axis.values, edge, "--", color=BLACK, linewidth=0.8, label=label)
        panel.plot(axis.values, total, "-" + axis.mark, color=BLACK, markersize=4, label="total")
    else:
        panel.errorbar(
            axis.values, total, (total - low, high - total), fmt="o", color=BLACK, capsize=4, label="total, uncertainty"
        )
    words = [
        "numerical" if numerical is not None else "",
        "of the model's formulas at 95 %" if model is not None else "",
    ]
    return " and ".join(word for word in words if word) or "not known"
