"""Every plot of the page, in the order of its sections, and how a plot becomes part of the page."""

import base64
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple

from matplotlib.figure import Figure

from analytic.words import percent_of
from fembearing.report.figures.bearing import bearing_plot
from fembearing.report.figures.cage import cage_plot
from fembearing.report.figures.contacts import approach_plot, convergence_plot, pressure_plot
from fembearing.report.figures.cost import cost_figures
from fembearing.report.figures.measured import measured_plot
from fembearing.report.figures.prediction import prediction_plot
from fembearing.report.figures.ring import ring_plot
from fembearing.report.figures.sensitivity import sensitivity_plot
from fembearing.report.figures.style import svg
from fembearing.report.figures.torque import friction_plot, torque_plot
from fembearing.report.report import Report

PIXELS = 96  # of a page, per inch
Section = Literal[  # of an appendix, or the summary's drawing of the bearing
    "bearing", "torque", "measured", "contacts", "pictures", "meshes", "ring", "cage", "sensitivity", "cost"
]


@dataclass(frozen=True, kw_only=True)
class Plot:
    """One plot; `draw` gives the figure and its caption, or None and why there is nothing to draw."""

    section: Section  # at whose end it stands
    heading: str
    draw: Callable[[Report], tuple[Figure | list[Figure] | None, str]]


class ShownPlot(NamedTuple):
    """A plot as the template shows it; without a source the caption says why."""

    heading: str
    caption: str
    source: str | None = None  # a data address
    width: int = 0  # of the picture on a screen, pixels


def plots_of(document: Report, plots: Sequence[Plot]) -> dict[str, list[ShownPlot]]:
    """Every plot drawn, by section, in their order."""
    shown: dict[str, list[ShownPlot]] = {}
    for plot in plots:
        drawn, caption = plot.draw(document)
        figures = drawn if isinstance(drawn, list) else [drawn]
        for number, figure in enumerate(figures):
            heading, words = (f"{plot.heading}, continued", "") if number else (plot.heading, caption)
            shown.setdefault(plot.section, []).append(_shown(heading, words, figure))
    return shown


def _shown(heading: str, caption: str, figure: Figure | None) -> ShownPlot:
    if figure is None:
        return ShownPlot(heading, caption)
    width = round(PIXELS * figure.get_figwidth())
    return ShownPlot(heading, caption, embedded(svg(figure), "svg+xml"), width)


def embedded(content: bytes, kind: Literal["png", "svg+xml"] = "png") -> str:
    """A picture as an address that holds it."""
    return f"data:image/{kind};base64,{base64.b64encode(content).decode()}"


def _cost(document: Report) -> tuple[list[Figure], str]:
    """The figures of what accuracy costs, and its caption."""
    ran = " and its memory" if document.cost.measured else ", for the methods of this check"
    return cost_figures(document.cost.ladders, tolerance=document.tolerance), (
        f"Error of each method over its time{ran}. Formulas take milliseconds or less, fine meshes seconds. Bar: bound "
        "on the error; hollow: reference. Methods with error and bound below the dotted line are within the "
        f"tolerance, {percent_of(document.tolerance)}; ring: the cheapest of them. A line joins the results of one "
        "method on finer meshes or more points."
    )


PLOTS: tuple[Plot, ...] = (
    Plot(section="bearing", heading="The bearing to scale", draw=bearing_plot),
    Plot(section="contacts", heading="Stiffness: load over approach", draw=approach_plot),
    Plot(section="torque", heading="Torque by effect", draw=torque_plot),
    Plot(section="torque", heading="Friction, film and asperities", draw=friction_plot),
    Plot(section="torque", heading="95 % interval of the torque", draw=prediction_plot),
    Plot(section="measured", heading="Measured and computed torque", draw=measured_plot),
    Plot(section="ring", heading="Balls around the ring", draw=ring_plot),
    Plot(section="sensitivity", heading="One input at a time", draw=sensitivity_plot),
    Plot(section="cage", heading="Orbit of the cage and its forces", draw=cage_plot),
    Plot(section="meshes", heading="Order of convergence", draw=convergence_plot),
    Plot(section="pictures", heading="Pressure along both axes", draw=pressure_plot),
    Plot(section="cost", heading="Error against time", draw=_cost),
)
