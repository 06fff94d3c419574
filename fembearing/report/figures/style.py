"""What all figures share: colours that a colour-blind reader tells apart, legends below the data, scales, the file."""

from collections.abc import Callable, Sequence
from io import BytesIO
from typing import Any, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, ScalarFormatter

from fembearing.report.document.contact import Contact

BLUE, ORANGE, GREEN, RED = "#0072B2", "#E69F00", "#009E73", "#D55E00"  # the palette of M. Okabe and K. Ito
PURPLE, SKY, YELLOW = "#CC79A7", "#56B4E9", "#F0E442"
BLACK, GREY = "black", "0.55"
CONTACTS = {  # pair and geometry -> colour and mark
    ("inner", "real"): (BLUE, "o"),
    ("outer", "real"): (RED, "s"),
    ("pocket", "real"): (GREEN, "^"),
    ("pocket", "wall"): (PURPLE, "D"),
}
DECADE = 10.0  # what spans more is drawn on a logarithmic scale
PAGE, WIDEST_COLUMN = 11.0, 3.4  # inches: panels together are no wider than the page, so that letters stay as large
DrawContact = Callable[[Axes, Contact], None]
DOTS = 110  # per inch
MANY = 25  # points on a line: more have no marks


def png(figure: Figure, *, sharp: bool = False) -> bytes:
    """The figure as a file; sharp : twice as many dots, for a narrow figure that is also printed."""
    return _saved(figure, dpi=2 * DOTS if sharp else DOTS, format="png")


def pdf(figure: Figure) -> bytes:
    """The figure as a file of lines and letters."""
    return _saved(figure, format="pdf")


def _saved(figure: Figure, **how: Any) -> bytes:
    content = BytesIO()
    figure.savefig(content, **how)
    return content.getvalue()


def look_of(pair: str, geometry: str) -> tuple[str, str]:
    """Colour and mark of a contact."""
    return CONTACTS.get((pair, geometry), (BLACK, "x"))


def contact_columns(
    contacts: Sequence[Contact],
    *rows: DrawContact,
    height: float,
    labels: tuple[str, str],
    shared: Literal["none", "col"] = "none",
) -> Figure:
    """Two panels for each contact, one above the other, with one legend for all.

    rows : what draws the upper and the lower panel;  labels : of the vertical axis of both rows
    shared : "col" where both panels of a contact have one horizontal axis
    """
    columns = len(contacts)
    figure = Figure(figsize=(min(WIDEST_COLUMN, PAGE / columns) * max(columns, 2), height), layout="constrained")
    panels = figure.subplots(2, columns, squeeze=False, sharex=shared, height_ratios=(1.3, 1))
    for row, draw, label in zip(panels, rows, labels, strict=True):
        row[0].set_ylabel(label)
        for panel, contact in zip(row, contacts, strict=True):
            draw(panel, contact)
            panel.tick_params(labelsize=8)
            panel.grid(alpha=0.3)
    handles, words = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=len(words), frameon=False, fontsize=9)
    return figure


def legend_below(panel: Axes, *, columns: int = 2, size: float = 8) -> None:
    """Under the axis' label, where no data are."""
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.17), ncols=columns, fontsize=size, frameon=False)


def scaled(panel: Axes, values: np.ndarray, *, axis: str = "y") -> None:
    """Logarithmic where values cross a decade and all are above 0; plain numbers at the ticks."""
    known = values[np.isfinite(values)]
    if known.size == 0 or known.min() <= 0 or known.max() < DECADE * known.min():
        return
    (panel.set_yscale if axis == "y" else panel.set_xscale)("log")
    if known.max() < 1e4 * known.min():
        (panel.yaxis if axis == "y" else panel.xaxis).set_major_formatter("{x:g}")


def plain_ticks(panel: Axes, ticks: np.ndarray) -> None:
    """Ticks of a logarithmic x-axis at the values themselves."""
    panel.set_xticks(ticks)
    panel.xaxis.set_major_formatter(ScalarFormatter())
    panel.xaxis.set_minor_formatter(NullFormatter())
