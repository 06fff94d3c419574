"""What is drawn in a panel, read back as numbers."""

import json
from itertools import combinations
from types import SimpleNamespace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.container import ErrorbarContainer
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from numpy.typing import NDArray

from analytic.units import METRIC, Units

Array = NDArray[np.float64]


def as_document(content: dict[str, Any], units: Units = METRIC) -> Any:
    """A document of a few keys, typed in by hand, that is read by its attributes."""
    document = json.loads(json.dumps(content), object_hook=lambda table: SimpleNamespace(**table))
    document.units = units
    return document


def line_of(axes: Axes, label: str) -> Line2D:
    """The one line with this label, or else whose label begins so."""
    named = {str(line.get_label()): line for line in axes.get_lines()}
    if label in named:
        return named[label]
    (found,) = (line for name, line in named.items() if name.startswith(label))
    return found


def points_of(line: Line2D) -> Array:
    """(n, 2)"""
    return np.column_stack([np.asarray(line.get_xdata(), dtype=float), np.asarray(line.get_ydata(), dtype=float)])


def area_of(axes: Axes, label: str) -> tuple[Array, Array, Array]:
    """x, and the lower and upper edge there, of an area filled between two lines."""
    (found,) = (each for each in axes.collections if isinstance(each, PolyCollection) and each.get_label() == label)
    corners = np.asarray(found.get_paths()[0].vertices, dtype=float)
    x = np.unique(corners[:, 0])
    heights = [corners[corners[:, 0] == each, 1] for each in x]
    return x, np.array([each.min() for each in heights]), np.array([each.max() for each in heights])


def bars_of(axes: Axes, label: str, *, axis: int = 1) -> Array:
    """(n, 2) both ends of the error bars with this label, along y or, axis 0, x."""
    (found,) = (each for each in axes.containers if isinstance(each, ErrorbarContainer) and each.get_label() == label)
    (bars,) = found.lines[2]
    return np.sort([np.asarray(ends)[:, axis] for ends in bars.get_segments()], axis=1)


def require_legible(figure: Figure) -> None:
    """Fail where words lie on others or leave the page; leaning ones may stand closer than their boxes."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    ticks = [
        (axis, tick, panel.axison)
        for panel in figure.axes
        for axis in (panel.xaxis, panel.yaxis)
        for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks())
    ]
    hidden = {
        label
        for axis, tick, is_shown in ticks
        for label in (tick.label1, tick.label2)
        if not is_shown or not min(axis.get_view_interval()) <= tick.get_loc() <= max(axis.get_view_interval())
    }
    texts = [each for each in figure.findobj(Text) if isinstance(each, Text) and each not in hidden]
    shown = [each for each in texts if each.get_visible() and each.get_text().strip()]
    boxes = [(each, each.get_window_extent(canvas.get_renderer())) for each in shown]
    width, height = figure.get_size_inches() * figure.dpi
    for text, box in boxes:
        assert box.x0 >= 0 <= box.y0, text
        assert box.x1 <= width, text
        assert box.y1 <= height, text
    for (text, one), (other, two) in combinations(boxes, 2):
        leaning = text.get_rotation() % 90 and other.get_rotation() % 90
        assert leaning or not one.overlaps(two), f"{text} lies on {other}"


def labels_of(axes: Axes) -> list[str]:
    """Of the legend."""
    legend = axes.get_legend()
    return [] if legend is None else [text.get_text() for text in legend.get_texts()]
