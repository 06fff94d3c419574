"""What the operating points of a torque are drawn over: speed, a load, or their numbers."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from analytic.figures.style import DECADE, MANY, plain_numbers, plain_ticks
from analytic.scene import Array
from analytic.units import Units, coordinate_unit, load_words, speed_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Columns = Mapping[str, Array]  # (n,) SI, by the names of a torque's columns
SPEED, LOADS = "inner_speed", ("axial_load", "radial_load", "moment")
MOST_TICKS = 8
APART = 0.1  # of a logarithmic axis: nearer ticks run into each other
STEEP = 35  # degrees: names of operating points below each other's ends


@dataclass(frozen=True, kw_only=True, eq=False)
class SeriesAxis:
    """Operating points from left to right."""

    label: str
    over: str  # the coordinate that grows along it; empty where points follow each other
    units: Units
    values: Array  # (n,) where each point is drawn
    order: NDArray[np.intp]  # (n,) places of the points among those that were given
    columns: Columns  # in this order
    joined: bool  # neighbours may be joined by a line: one quantity grows along the axis, and nothing else changes

    @property
    def mark(self) -> str:
        """Of each point; none where many are joined."""
        return "" if self.joined and self.values.size > MANY else "o"

    @property
    def spans_a_decade(self) -> bool:
        """Whether the axis is logarithmic."""
        low, high = self.values[0], self.values[-1]
        return bool(self.joined and low > 0 and high >= DECADE * low * (1 - 1e-9))  # round-off of a unit

    def of(self, name: str) -> Array | None:
        """(n,) of a column; None where no point has a number."""
        values = self.columns.get(name)
        return None if values is None or np.all(np.isnan(values)) else values

    @property
    def _varying(self) -> list[str]:
        """The loads that differ between operating points."""
        return [name for name in LOADS if np.unique(self.columns[name]).size > 1]

    @property
    def _present(self) -> list[str]:
        """The loads that are not 0 everywhere; the axial one where all are."""
        return [name for name in LOADS if np.any(self.columns[name])] or ["axial_load"]

    def _words(self, place: int, names: list[str]) -> list[str]:
        return [load_words(name, float(self.columns[name][place]), self.units) for name in names]

    @property
    def names(self) -> list[str]:
        """What differs between operating points, of each of them."""
        speeds = np.unique(self.columns[SPEED]).size > 1
        loads = self._varying or ([] if speeds else self._present)
        return [
            ", ".join(([speed_words(speed, self.units)] if speeds else []) + self._words(place, loads))
            for place, speed in enumerate(self.columns[SPEED].tolist())
        ]

    @property
    def fixed(self) -> str:
        """The loads and the speed that are the same at every operating point, in words."""
        words = self._words(0, [name for name in self._present if name not in self._varying])
        speeds = np.unique(self.columns[SPEED]).tolist()
        return ", ".join(words + ([speed_words(speeds[0], self.units)] if len(speeds) == 1 else []))

    def apply(self, panel: "Axes") -> None:
        """Set label, ticks and scale of the horizontal axis of a panel."""
        panel.set_xlabel(self.label)
        if not self.joined:
            names = self.names
            step = -(-len(names) // MOST_TICKS)
            panel.set_xticks(self.values[::step], names[::step], rotation=STEEP, ha="right")
            panel.set_xlim(-0.6, len(names) - 0.4)
        elif self.spans_a_decade:
            panel.set_xscale("log")
            steps = np.diff(np.log(self.values))
            if self.values.size <= MOST_TICKS and steps.min() >= APART * steps.sum():
                plain_ticks(panel, self.values)
            else:
                plain_numbers(panel.xaxis)


def axis_of(columns: Columns, units: Units) -> SeriesAxis:
    """Over the speed or the load that changes, where nothing else does; else point by point.

    columns : with inner_speed, rad/s, axial_load and radial_load, N, and moment, N m
    """
    size = columns[SPEED].size
    series = {SPEED: np.abs(columns[SPEED])} | {name: columns[name] for name in LOADS}
    varying = [name for name, values in series.items() if np.unique(values).size > 1]
    if len(varying) == 1 and np.unique(series[varying[0]]).size == size:
        (over,) = varying
        order, unit = np.argsort(series[over]), coordinate_unit(over, units)
        label, values, joined = f"{over.replace('_', ' ')}, {unit.name}", unit.number(series[over][order]), True
    else:
        over, order, label, values, joined = "", np.arange(size), "operating point", np.arange(float(size)), False
    ordered = {name: each[order] for name, each in columns.items()}
    return SeriesAxis(label=label, over=over, units=units, values=values, order=order, columns=ordered, joined=joined)
