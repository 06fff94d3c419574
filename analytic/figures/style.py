"""What all figures share: colours that a colour-blind reader tells apart, letters, scales."""

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:  # charts in a browser take the colours alone
    from matplotlib.axes import Axes
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, RED = "#0072B2", "#E69F00", "#009E73", "#D55E00"  # the palette of M. Okabe and K. Ito
PURPLE, SKY, YELLOW = "#CC79A7", "#56B4E9", "#F0E442"
BLACK, GREY = "black", "0.55"
DECADE = 10.0  # what spans more is drawn on a logarithmic scale
WIDTH = 7.2  # inches, of every figure: that of the text on a printed page, so that letters keep their size there
TITLE, LETTERS = 9, 8  # points
MANY = 25  # points on a line: more have no marks
SIDE_BY_SIDE = 4  # panels at most


def lettered(figure: "Figure") -> "Figure":
    """The same figure, with titles, axes and ticks in the letters that all figures have."""
    for panel in figure.axes:
        panel.title.set_fontsize(TITLE)
        panel.xaxis.label.set_fontsize(LETTERS)
        panel.yaxis.label.set_fontsize(LETTERS)
        panel.tick_params(labelsize=LETTERS)
    return figure


def give_title(figure: "Figure", words: str, **look: Any) -> None:
    """Put words above a figure. Between dollars, which a name may have, matplotlib would read a formula."""
    figure.suptitle(words.replace("$", r"\$"), wrap=True, **look)


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
    fine = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0)
    subs = next((subs for most, subs in ((3, fine), (15, (1, 2, 5)), (100, (1, 3))) if high < most * low), (1,))
    axis.set_major_locator(LogLocator(subs=subs))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())


def plain_ticks(panel: "Axes", ticks: np.ndarray) -> None:
    """Ticks of a logarithmic x-axis at the values themselves."""
    from matplotlib.ticker import NullFormatter, ScalarFormatter

    panel.set_xticks(ticks)
    panel.xaxis.set_major_formatter(ScalarFormatter())
    panel.xaxis.set_minor_formatter(NullFormatter())
