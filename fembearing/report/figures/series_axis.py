"""What the operating points of a document are drawn over: speed, a load, or their numbers."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from analytic.result import COORDINATES
from analytic.scene import Array
from fembearing.quantities import RPM
from fembearing.report.document.torque import Point
from fembearing.report.figures.style import DECADE, MANY, plain_ticks
from fembearing.report.phrases import LOADS, loads_of, present_loads, varying_loads

MOST_TICKS = 8
SPEED = f"inner speed, {RPM.name}"


@dataclass(frozen=True, kw_only=True, eq=False)
class SeriesAxis:
    """Operating points from left to right."""

    label: str
    values: Array  # (n,) where each point is drawn
    points: Sequence[Point]  # in the same order
    joined: bool  # neighbours may be joined by a line: one quantity grows along the axis, and nothing else changes

    @property
    def mark(self) -> str:
        """Of each point; none where many are joined."""
        return "" if self.joined and len(self.points) > MANY else "o"

    def of(self, group: str, name: str) -> Array | None:
        """(n,) of one number of a group of every point; None where no point has it."""
        values = [getattr(getattr(point, group), name) for point in self.points]
        if all(value is None for value in values):
            return None
        return np.array([np.nan if value is None else value for value in values])

    def apply(self, panel: Axes) -> None:
        """Set label, ticks and scale of the horizontal axis of a panel."""
        panel.set_xlabel(self.label)
        if not self.joined:
            shown = varying_loads(self.points) or present_loads(self.points)
            names = [f"{RPM.written(point.inner_speed, '.4g')}\n{loads_of(point, shown)}" for point in self.points]
            step = -(-len(names) // MOST_TICKS)
            panel.set_xticks(self.values[::step], names[::step], fontsize=8)
            panel.set_xlim(-0.6, len(names) - 0.4)
        elif self.values[0] > 0 and self.values[-1] > DECADE * self.values[0]:
            panel.set_xscale("log")
            if self.values.size <= MOST_TICKS:
                plain_ticks(panel, self.values)
            else:
                panel.xaxis.set_major_formatter("{x:g}")


def axis_of(points: Sequence[Point]) -> SeriesAxis:
    """Over the speed or the load that changes, where nothing else does; else point by point."""
    series = {SPEED: np.array([abs(point.inner_speed) for point in points]) * RPM.factor}
    for name in LOADS:
        label = f"{COORDINATES[name].meaning}, {COORDINATES[name].unit}"
        series[label] = np.array([getattr(point, name) for point in points])
    varying = {label: values for label, values in series.items() if np.unique(values).size > 1}
    if len(varying) == 1:
        ((label, values),) = varying.items()
        if np.unique(values).size == len(points):
            order = np.argsort(values)
            return SeriesAxis(label=label, values=values[order], points=[points[i] for i in order], joined=True)
    return SeriesAxis(label="operating point", values=np.arange(float(len(points))), points=points, joined=False)
