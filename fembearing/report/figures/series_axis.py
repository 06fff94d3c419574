"""What the operating points of a document are drawn over: speed, a load, or their numbers."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from analytic.scene import Array
from fembearing.quantities import QUANTITIES, Units
from fembearing.report.figures.style import DECADE, MANY, plain_numbers, plain_ticks
from fembearing.report.phrases import LOADS, loads_of, present_loads, speed_words, varying_loads

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_TICKS = 8
STEEP = 35  # degrees: names of operating points below each other's ends


@dataclass(frozen=True, kw_only=True, eq=False)
class SeriesAxis:
    """Operating points from left to right."""

    label: str
    over: str  # the name of the coordinate that grows along it; empty where points follow each other
    units: Units
    values: Array  # (n,) where each point is drawn
    points: Sequence[TorquePoint]  # in the same order
    order: Sequence[int]  # their places among the points as they were given
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

    @property
    def names(self) -> list[str]:
        """What differs between operating points, of each of them."""
        speeds = len({point.inner_speed for point in self.points}) > 1
        loads = varying_loads(self.points) or ([] if speeds else present_loads(self.points))
        return [
            ", ".join(
                [
                    *([speed_words(point.inner_speed, self.units)] if speeds else []),
                    *([loads_of(point, loads, self.units)] if loads else []),
                ]
            )
            for point in self.points
        ]

    @property
    def fixed(self) -> str:
        """The loads and the speed that are the same at every operating point, in words."""
        loads = [name for name in present_loads(self.points) if name not in varying_loads(self.points)]
        speeds = {point.inner_speed for point in self.points}
        words = [loads_of(self.points[0], loads, self.units)] if loads else []
        return ", ".join([*words, *(speed_words(each, self.units) for each in speeds if len(speeds) == 1)])

    def apply(self, panel: "Axes") -> None:
        """Set label, ticks and scale of the horizontal axis of a panel."""
        panel.set_xlabel(self.label)
        if not self.joined:
            names = self.names
            step = -(-len(names) // MOST_TICKS)
            panel.set_xticks(self.values[::step], names[::step], rotation=STEEP, ha="right")
            panel.set_xlim(-0.6, len(names) - 0.4)
        elif self.values[0] > 0 and self.values[-1] > DECADE * self.values[0]:
            panel.set_xscale("log")
            if self.values.size <= MOST_TICKS:
                plain_ticks(panel, self.values)
            else:
                plain_numbers(panel.xaxis)


def axis_of(points: Sequence[TorquePoint], units: Units) -> SeriesAxis:
    """Over the speed or the load that changes, where nothing else does; else point by point."""
    series = {name: np.array([getattr(point, name) for point in points]) for name in ("inner_speed", *LOADS)}
    series["inner_speed"] = np.abs(series["inner_speed"])
    varying = {name: values for name, values in series.items() if np.unique(values).size > 1}
    if len(varying) == 1:
        ((name, values),) = varying.items()
        if np.unique(values).size == len(points):
            order = np.argsort(values)
            quantity = QUANTITIES[name].in_units(units)
            return SeriesAxis(
                label=f"inner speed, {quantity.shown.name}" if name == "inner_speed" else quantity.heading,
                over=name,
                units=units,
                values=values[order] * quantity.shown.factor,
                points=[points[i] for i in order],
                order=order.tolist(),
                joined=True,
            )
    place = np.arange(float(len(points)))
    every = [*range(len(points))]
    return SeriesAxis(
        label="operating point", over="", units=units, values=place, points=points, order=every, joined=False
    )
