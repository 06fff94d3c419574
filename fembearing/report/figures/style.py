"""What all figures share: colours that a colour-blind reader tells apart, legends below the data, scales, the file."""

from io import BytesIO

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, ScalarFormatter

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
PAGE, WIDEST_COLUMN = 11.0, 3.4  # inches
DOTS = 110  # per inch
MANY = 25  # points on a line: more have no marks


def png(figure: Figure) -> bytes:
    """The figure as a file."""
    content = BytesIO()
    figure.savefig(content, dpi=DOTS, format="png")
    return content.getvalue()


def look_of(pair: str, geometry: str) -> tuple[str, str]:
    """Colour and mark of a contact."""
    return CONTACTS.get((pair, geometry), (BLACK, "x"))


def column_width(columns: int) -> float:
    """Inches, of panels side by side, together no wider than the page: letters then stay as large as drawn."""
    return min(WIDEST_COLUMN, PAGE / columns)


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
