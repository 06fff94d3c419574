"""The stiffness of each contact: load over approach, and how far each model is from Hertz."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.report.figures.plot import Document
from fembearing.report.figures.style import BLACK, BLUE, RED, column_width
from fembearing.report.words import place_of

MICRO = 1e6
CAPTION = (
    "Above: load of the ball over its approach, by Hertz, by Hertz corrected for finite geometry as far as its fit "
    "reaches, and by finite elements at the load that was solved. Below: approach over Hertz's, less one, with the "
    "95 % intervals of the fit and of the finite elements: a contact that gives way less than Hertz says is stiffer."
)


def approach_plot(document: Document) -> tuple[Figure | None, str]:
    """A column for each contact."""
    contacts = document["contacts"]
    figure = Figure(figsize=(column_width(len(contacts)) * max(len(contacts), 2), 6.2), layout="constrained")
    above, below = figure.subplots(2, len(contacts), squeeze=False, height_ratios=(1.3, 1))
    for panel, contact in zip(above, contacts, strict=True):
        _curve(panel, contact)
    for panel, contact in zip(below, contacts, strict=True):
        _apart(panel, contact)
    above[0].set_ylabel("load, N")
    below[0].set_ylabel("approach over Hertz's,\nless 1, %")
    handles, labels = above[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=len(labels), frameon=False, fontsize=9)
    return figure, CAPTION


def _curve(panel: Axes, contact: dict[str, Any]) -> None:
    curve, found = contact["approach_curve"], contact["fe"]["approach"]
    load = np.array(curve["load"])
    panel.plot(MICRO * np.array(curve["hertz"]), load, color=BLACK, label="Hertz")
    panel.plot(MICRO * _known(curve["corrected"]), load, "--", color=BLUE, label="Hertz, corrected for finite geometry")
    panel.errorbar(
        MICRO * found,
        contact["load"],
        xerr=MICRO * found * contact["uncertainty"]["approach"],
        fmt="o",
        color=RED,
        markersize=5,
        label="finite elements",
    )
    place = place_of(contact).replace(", ", ",\n")
    panel.set_title(f"{place[0].upper()}{place[1:]}", fontsize=9)
    panel.set(xlabel="approach, µm", xlim=(0, None), ylim=(0, None))
    panel.tick_params(labelsize=8)
    panel.grid(alpha=0.3)


def _apart(panel: Axes, contact: dict[str, Any]) -> None:
    curve, found = contact["approach_curve"], contact["fe"]["approach"]
    load, hertz = np.array(curve["load"]), np.array(curve["hertz"])
    corrected, half = _known(curve["corrected"]), _known(curve["uncertainty"])
    panel.axhline(0, color=BLACK)
    if np.isfinite(corrected).any():
        low, high = (100 * (corrected * (1 + side * half) / hertz - 1) for side in (-1, 1))
        panel.fill_between(load, low, high, color=BLUE, alpha=0.2, linewidth=0)
        panel.plot(load, 100 * (corrected / hertz - 1), "--", color=BLUE)
    ratio = found / contact["hertz"]["approach"]
    panel.errorbar(
        contact["load"],
        100 * (ratio - 1),
        yerr=100 * ratio * contact["uncertainty"]["approach"],
        fmt="o",
        color=RED,
        markersize=5,
        capsize=4,
    )
    panel.set(xlabel="load, N", xlim=(0, None))
    panel.margins(y=0.25)
    panel.tick_params(labelsize=8)
    panel.grid(alpha=0.3)


def _known(values: list[float | None]) -> np.ndarray:
    return np.array([np.nan if value is None else value for value in values])
