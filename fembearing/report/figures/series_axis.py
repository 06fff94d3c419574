"""What the operating points of a document are drawn over: speed, load, or their numbers."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from analytic.scene import Array
from fembearing.report.figures.style import DECADE, MANY, plain_ticks
from fembearing.report.words import PER_MINUTE

MOST_TICKS = 8


@dataclass(frozen=True, kw_only=True, eq=False)
class SeriesAxis:
    """Operating points from left to right."""

    label: str
    values: Array  # (n,) where each point is drawn
    points: list[dict[str, Any]]  # of the document, in the same order
    joined: bool  # neighbours may be joined by a line: one quantity grows along the axis, and nothing else changes

    @property
    def mark(self) -> str:
        return "" if self.joined and len(self.points) > MANY else "o"

    def of(self, group: str, name: str) -> Array | None:
        """(n,) of `points[...][group][name]`; None where no point has it."""
        values = [point[group][name] for point in self.points]
        if all(value is None for value in values):
            return None
        return np.array([np.nan if value is None else value for value in values])

    def apply(self, panel: Axes) -> None:
        panel.set_xlabel(self.label)
        if not self.joined:
            names = [
                f"{point['inner_speed'] * PER_MINUTE:.4g} rpm\n{point['axial_load']:.4g} N" for point in self.points
            ]
            step = -(-len(names) // MOST_TICKS)
            panel.set_xticks(self.values[::step], names[::step], fontsize=8)
            panel.set_xlim(-0.6, len(names) - 0.4)
        elif self.values[0] > 0 and self.values[-1] > DECADE * self.values[0]:
            panel.set_xscale("log")
            if self.values.size <= MOST_TICKS:
                plain_ticks(panel, self.values)
            else:
                panel.xaxis.set_major_formatter("{x:g}")


def axis_of(points: list[dict[str, Any]]) -> SeriesAxis:
    """Over speed where the load is one and speeds differ; over load the other way round; else point by point."""
    speed = np.array([abs(point["inner_speed"]) for point in points]) * PER_MINUTE
    load = np.array([point["axial_load"] for point in points])
    for values, other, label in ((speed, load, "inner speed, rpm"), (load, speed, "axial load, N")):
        if len(points) > 1 and np.unique(values).size == len(points) and np.unique(other).size == 1:
            order = np.argsort(values)
            return SeriesAxis(label=label, values=values[order], points=[points[i] for i in order], joined=True)
    return SeriesAxis(label="operating point", values=np.arange(float(len(points))), points=points, joined=False)
