"""A plot of the page: where it stands, and how it is drawn from the document's numbers alone."""

import base64
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

from matplotlib.figure import Figure

from fembearing.report.figures.file import png

Document = dict[str, Any]  # what report.json holds: plain types, SI
Section = Literal["scene", "verdicts", "torque", "convergence", "pressure", "cost", "published", "hard", "provenance"]


@dataclass(frozen=True, kw_only=True)
class Plot:
    """One plot; `draw` gives the figure and its caption, or None and why there is nothing to draw."""

    section: Section
    heading: str
    draw: Callable[[Document], tuple[Figure | None, str]]


class Shown(NamedTuple):
    """A plot as the template shows it; without a source the caption says why."""

    heading: str
    caption: str
    source: str | None  # a data address


def plots_of(document: Document, plots: Sequence[Plot]) -> dict[str, list[Shown]]:
    """Every plot drawn, by section, in their order."""
    found: dict[str, list[Shown]] = {}
    for plot in plots:
        figure, caption = plot.draw(document)
        source = None if figure is None else embedded(png(figure))
        found.setdefault(plot.section, []).append(Shown(plot.heading, caption, source))
    return found


def embedded(content: bytes) -> str:
    """A PNG as an address that holds it."""
    return f"data:image/png;base64,{base64.b64encode(content).decode()}"
