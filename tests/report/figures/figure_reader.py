"""What is drawn in a panel, read back as numbers."""

import json
from types import SimpleNamespace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from fembearing.quantities import METRIC, Units

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


def labels_of(axes: Axes) -> list[str]:
    """Of the legend."""
    legend = axes.get_legend()
    return [] if legend is None else [text.get_text() for text in legend.get_texts()]
