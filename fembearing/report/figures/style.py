"""What all figures share: colours that a colour-blind reader tells apart, legends below the data, scales, the file."""

from collections.abc import Callable, Sequence
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np

from fembearing.quantities import Units

if TYPE_CHECKING:  # charts in a browser take the colours alone
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

    from fembearing.check.contact.solution import ContactNumbers

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
WIDTH = 7.2  # inches, of every figure: that of the text on a printed page, so that letters keep their size there
TITLE, LETTERS = 9, 8  # points
SIDE_BY_SIDE = 4  # panels at most
UPPER, LOWER = 1.6, 1.2  # inches: heights of the two panels of a contact
HEADS = 0.7  # inches: titles of a row of contacts, and names of its axes
DrawContact = Callable[["Axes", "ContactNumbers", Units], None]
DOTS = 192  # per inch: twice those of a screen
MANY = 25  # points on a line: more have no marks


def png(figure: "Figure") -> bytes:
    """The figure as a file."""
    return _saved(figure, dpi=DOTS, format="png")


def pdf(figure: "Figure") -> bytes:
    """The figure as a file of lines and letters."""
    return _saved(figure, format="pdf")


def svg(figure: "Figure") -> bytes:
    """The figure as a picture of lines and letters, the same in every run."""
    from matplotlib import rc_context

    with rc_context({"svg.hashsalt": "fembearing"}):
        return _saved(figure, format="svg", metadata={"Date": None})


def _saved(figure: "Figure", **how: Any) -> bytes:
    content = BytesIO()
    figure.savefig(content, **how)
    return content.getvalue()


def lettered(figure: "Figure") -> "Figure":
    """The same figure, with titles, axes and ticks in the letters that all figures have."""
    for panel in figure.axes:
        panel.title.set_fontsize(TITLE)
        panel.xaxis.label.set_fontsize(LETTERS)
        panel.yaxis.label.set_fontsize(LETTERS)
        panel.tick_params(labelsize=LETTERS)
    return figure


def look_of(pair: str, geometry: str) -> tuple[str, str]:
    """Colour and mark of a contact."""
    return CONTACTS.get((pair, geometry), (BLACK, "x"))


def contact_columns(
    contacts: "Sequence[ContactNumbers]",
    *rows: DrawContact,
    units: Units,
    labels: tuple[str, str],
    shared: bool = False,
) -> "Figure":
    """Two panels for each contact, one above the other, contacts side by side, with one legend for all.

    rows : what draws the upper and the lower panel;  labels : of the vertical axis of both
    shared : both panels of a contact have one horizontal axis
    """
    from matplotlib.figure import Figure

    storeys = -(-len(contacts) // SIDE_BY_SIDE)
    columns = -(-len(contacts) // storeys)
    figure = Figure(figsize=(WIDTH, 0.3 + storeys * (HEADS + UPPER + LOWER)), layout="constrained")
    grid = figure.add_gridspec(2 * storeys, columns, height_ratios=(UPPER, LOWER) * storeys)
    for number, contact in enumerate(contacts):
        storey, column = divmod(number, columns)
        above = None
        for row, (draw, label) in enumerate(zip(rows, labels, strict=True)):
            panel = figure.add_subplot(grid[2 * storey + row, column], sharex=above if shared else None)
            above = above or panel
            draw(panel, contact, units)
            panel.set_ylabel("" if column else label)
            panel.grid(alpha=0.3)
    handles, words = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=SIDE_BY_SIDE, frameon=False, fontsize=LETTERS)
    return lettered(figure)


def scaled(panel: "Axes", values: np.ndarray, *, axis: str = "y") -> None:
    """Logarithmic where values cross a decade and all are above 0; plain numbers at the ticks."""
    known = values[np.isfinite(values)]
    if known.size == 0 or known.min() <= 0 or known.max() < DECADE * known.min():
        return
    (panel.set_yscale if axis == "y" else panel.set_xscale)("log")
    if known.max() < 1e4 * known.min():
        plain_numbers(panel.yaxis if axis == "y" else panel.xaxis)


def plain_numbers(axis: "Axis") -> None:
    """Powers of ten, written out, on a logarithmic axis with limits; between them as many ticks as have room."""
    from matplotlib.ticker import LogLocator, NullFormatter

    low, high = axis.get_view_interval()
    subs = (1.0, 2.0, 5.0) if high < 15 * low else (1.0, 3.0) if high < 100 * low else (1.0,)
    axis.set_major_locator(LogLocator(subs=subs))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())


def plain_ticks(panel: "Axes", ticks: np.ndarray) -> None:
    """Ticks of a logarithmic x-axis at the values themselves."""
    from matplotlib.ticker import NullFormatter, ScalarFormatter

    panel.set_xticks(ticks)
    panel.xaxis.set_major_formatter(ScalarFormatter())
    panel.xaxis.set_minor_formatter(NullFormatter())
