"""Torque, friction coefficients and films over the operating points, and the torques of several scenes."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from analytic.errors import require_packages
from analytic.figures.series_axis import SeriesAxis
from analytic.figures.style import BLUE, DECADE, GREEN, GREY, LETTERS, ORANGE, PURPLE, RED, SKY, WIDTH, lettered, scaled
from analytic.figures.torque import (
    BAR,
    HIGH,
    DrawnTorque,
    bars_figure,
    finish,
    is_logarithmic,
    lengths,
    logarithmic_torques,
    panel_of,
    torque_figure,
)
from analytic.scene import Array
from analytic.units import coordinate_unit
from fembearing.report.report import Report

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NO_TORQUE = "No torque: the scene has neither a friction coefficient nor both lubricant and surface."
NOTHING_SLIDES = "No friction coefficient: no sliding was computed."
LOOKS = {"inner": (BLUE, "o", "-"), "outer": (RED, "s", "--"), "pocket": (GREEN, "^", ":")}  # lines may lie on another
PARTED = 3.0  # film over roughness, from which hardly a summit touches: a rule of thumb
FRICTION_HIGH = 2.6  # inches
BESIDE = 0.08  # of the distance of two operating points, between scenes
OF_SCENES = [(colour, line) for line in ("-", "--", ":") for colour in (BLUE, RED, GREEN, ORANGE, PURPLE, SKY)]


def torque_plot(document: Report) -> "tuple[Figure | None, str]":
    """The torque by effect over the operating points, as `fembearing torque --out` draws it."""
    if document.solved is None:
        return None, NO_TORQUE
    if len(document.solved.points) == 1:
        return None, ""  # a table says it
    drawn = document.solved.drawn.known
    band = "Band" if is_logarithmic(drawn) else "Dashed" if drawn.axis.joined else "Bars"
    caption = "Parts of the torque and their total. " if band == "Band" else "Stacked parts of the torque. "
    known = "its 95 % interval from solver, inputs and formulas" if drawn.has_interval else "its uncertainty"
    caption += f"{band}: {known}."
    caption += " The part of the cage includes its motion." if document.cage_records else ""
    if drawn.bands:
        caption += f" Red: {', '.join(drawn.bands)}, the makers' formulas for an open bearing of this size."
    return torque_figure(drawn), caption


def compared_figure(scenes: Mapping[str, DrawnTorque]) -> "Figure":
    """The torques of several scenes: a line for each over speed or load, with its 95 % interval.

    Where each has one operating point, a bar of parts for each.
    scenes : by name; the figure has the units of the first
    """
    require_packages("a figure", "matplotlib")
    units = next(iter(scenes.values())).units
    known = {name: replace(each.known, units=units) for name, each in scenes.items()}
    labels = {
        name: each.title if each.title.startswith(f"{name},") else f"{name}: {each.title}"
        for name, each in known.items()
    }
    if all(each.total.size == 1 for each in known.values()):
        names = [label.replace(", ", ",\n", 1) for label in labels.values()]
        return bars_figure(_together(known), names, "Torques of several scenes")
    series = [each.axis for each in known.values() if each.total.size > 1]
    over = series[0].over if len({axis.over for axis in series}) == 1 else ""
    figure, panel = panel_of(HIGH + BAR * len(known))
    places, torques = [], []
    for number, (name, each) in enumerate(known.items()):
        colour, line = OF_SCENES[number % len(OF_SCENES)]
        x = np.arange(1.0, 1 + each.total.size) + BESIDE * number
        if over:
            x = coordinate_unit(over, units).number(np.abs(each.axis.columns[over]))
        if over and x.size > 1:
            panel.plot(x, each.total, line + each.axis.mark, color=colour, markersize=4, label=labels[name])
            panel.fill_between(x, *each.ends, color=colour, alpha=0.12, linewidth=0)
        else:
            look = {"fmt": "o", "color": colour, "capsize": 3, "markersize": 4}
            panel.errorbar(x, each.total, lengths(each), label=labels[name], **look)
        places.append(x)
        torques += [each.total, *each.ends]
    _scale(panel, np.concatenate(places), np.concatenate(torques), joined=bool(over))
    panel.set_xlabel(series[0].label if over else "operating point")
    panel.set_ylabel(next(iter(known.values())).heading)
    panel.grid(alpha=0.3)
    finish(figure, "Torques of several scenes, with 95 % intervals", columns=1)
    return figure


def _scale(panel: "Axes", x: Array, torques: Array, *, joined: bool) -> None:
    """Logarithmic axes over a decade of speed or load; else torques from 0, over numbers of points if not joined."""
    if joined and x.min() > 0 and x.max() >= DECADE * x.min() * (1 - 1e-9):  # round-off of a unit
        scaled(panel, x, axis="x")
        logarithmic_torques(panel, torques)
        return
    panel.set_ylim(0, None)
    if not joined:
        panel.set_xticks(np.arange(1, 1 + int(x.max())))


def _together(scenes: Mapping[str, DrawnTorque]) -> DrawnTorque:
    """The first point of each scene as one series."""
    first = next(iter(scenes.values()))
    names = {name: None for each in scenes.values() for name in each.columns}
    makers = {name: None for each in scenes.values() for name in each.makers}
    unknown = np.array([np.nan])

    def joined(name: str, of: Sequence[Mapping[str, Array]]) -> Array:
        return np.concatenate([each.get(name, unknown)[:1] for each in of])

    columns, formulas = [each.columns for each in scenes.values()], [each.makers for each in scenes.values()]
    return replace(
        first,
        columns={name: joined(name, columns) for name in names},
        makers={name: joined(name, formulas) for name in makers},
    )


def friction_plot(document: Report) -> "tuple[Figure | None, str]":
    """Coefficients; where a film was computed, its thickness over the roughness, and the load on asperities."""
    if document.solved is None:
        return None, NO_TORQUE
    if len(document.solved.points) == 1:
        return None, ""  # a table says it
    axis = document.solved.drawn.known.axis
    gap = document.solved.friction.gap_roughness
    coefficients = {name: values for name in LOOKS if (values := axis.of(f"friction_coefficient_{name}")) is not None}
    if not coefficients:
        return None, NOTHING_SLIDES
    races = ("inner", "outer")
    films = {name: values / gap for name in races if gap and (values := axis.of(f"film_{name}")) is not None}
    shares = {name: 100 * values for name in races if (values := axis.of(f"asperity_share_{name}")) is not None}
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
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH, FRICTION_HIGH), layout="constrained")
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


def _curves(panel: "Axes", axis: SeriesAxis, curves: dict[str, Array]) -> None:
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
