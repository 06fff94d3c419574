"""Every plot and picture of the page, in the order of its sections, as blocks of a document."""

import base64
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from matplotlib.figure import Figure

from analytic.units import METRIC
from analytic.words import percent_of
from fembearing.report.document import Block, Drawing, Text, View
from fembearing.report.figures.bearing import bearing_plot
from fembearing.report.figures.cage import cage_plot
from fembearing.report.figures.contacts import approach_plot, convergence_plot, pressure_plot
from fembearing.report.figures.cost import cost_figures
from fembearing.report.figures.height_map import height_map_plot
from fembearing.report.figures.measured import measured_plot
from fembearing.report.figures.prediction import prediction_plot
from fembearing.report.figures.ring import ring_plot
from fembearing.report.figures.sensitivity import sensitivity_plot
from fembearing.report.figures.style import svg
from fembearing.report.figures.torque import friction_plot, torque_plot
from fembearing.report.report import Report
from fembearing.report.sections.contacts import contact_place, contact_title

PIXELS = 96  # of a page, per inch
SENTENCE_END = re.compile(r"(?<=[.]) (?=[A-Z])")
Section = Literal[  # of an appendix, or the summary's drawing of the bearing
    "bearing", "inputs", "torque", "measured", "contacts", "pictures", "meshes", "ring", "cage", "sensitivity", "cost"
]


@dataclass(frozen=True, kw_only=True)
class Plot:
    """One plot; `draw` gives the figure and its caption, or None and why there is nothing to draw."""

    section: Section  # at whose end it stands
    heading: str
    draw: Callable[[Report], tuple[Figure | list[Figure] | None, str]]


def plots_of(document: Report, plots: Sequence[Plot]) -> dict[str, list[Block]]:
    """Every plot drawn, by section, in their order; where there is nothing to draw, why."""
    shown: dict[str, list[Block]] = {}
    for plot in plots:
        drawn, caption = plot.draw(document)
        figures = drawn if isinstance(drawn, list) else [drawn]
        for number, figure in enumerate(figures):
            heading, words = (f"{plot.heading}, continued", "") if number else (plot.heading, caption)
            blocks = shown.setdefault(plot.section, [])
            if figure is not None:
                blocks.append(drawing_of(figure, words, heading))
            elif words:
                blocks.append(Text(words, wide=True, quiet=True))
    return shown


def drawing_of(figure: Figure, caption: str, heading: str = "") -> Drawing:
    """A figure as a block of a page."""
    return Drawing(embedded(svg(figure), "svg+xml"), caption, heading, width=round(PIXELS * figure.get_figwidth()))


def pictures_of(document: Report, folder: Path) -> dict[str, list[Block]]:
    """The pictures that lie beside report.json, by section; a sentence that several share stands in the first."""
    said: set[str] = set()
    shown: dict[str, list[Block]] = {}
    for picture in document.pictures:
        sentences = [each for each in SENTENCE_END.split(picture.caption) if each not in said]
        said |= {*sentences}
        caption, contact = " ".join(sentences), document.contact_of(picture)
        title = contact_title(contact)
        content = (folder / picture.file).read_bytes()
        if picture.kind == "view":
            shown.setdefault("pictures", []).append(View(content.decode(), caption, title))
        elif picture.kind in ("film", "creep"):
            shown.setdefault(picture.kind, []).append(Drawing(embedded(content), caption, contact_place(contact)))
        else:
            shown.setdefault("pictures", []).append(Drawing(embedded(content), caption, title, beside=True))
    turning = shown.get("pictures", [])
    turning.sort(key=lambda block: isinstance(block, View))  # those to turn stand last
    if turning and document.units is not METRIC:
        turning.insert(0, Text("Scales and captions of the pictures are in metric units.", wide=True, quiet=True))
    return shown


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
    Plot(section="inputs", heading="The measured surface", draw=height_map_plot),
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
