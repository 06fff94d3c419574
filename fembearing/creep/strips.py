"""A contact cut into strips along rolling, and each strip into rectangles of constant traction.

x points along rolling towards the leading edge, where the surfaces enter the contact; y points across.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from analytic.errors import require_positive
from analytic.scene import Array

# Slip is known midway between the middles of a rectangle and of the next one ahead. A row of constant tractions then
# sticks over a length that begins LEAD rectangles ahead of the first and ends TRAIL ahead of the rear of the last: the
# limit of long rows in plane strain, where force and centroid are those of the square roots at both ends. Rectangles so
# placed have no error of first order in their length. A test repeats the calculation.
LEAD, TRAIL = 0.325347, 0.174653


@dataclass(frozen=True, kw_only=True, eq=False)
class Strips:
    """The area of a contact in `count` strips of `cells` rectangles each."""

    middle: Array  # (count,) y of the strips, increasing, m
    width: Array  # (count,) across, m
    rear: Array  # (count,) x of the trailing edge on each strip, m
    front: Array  # (count,) x of the leading edge, m
    cells: int  # rectangles of a strip

    @cached_property
    def length(self) -> Array:
        """(count,) of a rectangle along rolling, m."""
        return (self.front - self.rear) / (self.cells + LEAD - TRAIL)

    @cached_property
    def edges(self) -> Array:
        """(count, cells + 1) x of the ends of the rectangles, m, increasing."""
        return (self.rear - TRAIL * self.length)[:, None] + self.length[:, None] * np.arange(self.cells + 1)

    @cached_property
    def x(self) -> Array:
        """(count, cells) of the middles of the rectangles, m."""
        return (self.edges[:, 1:] + self.edges[:, :-1]) / 2

    @cached_property
    def y(self) -> Array:
        """(count, cells) of the middles of the rectangles, m."""
        return np.repeat(self.middle[:, None], self.cells, axis=1)

    @cached_property
    def area(self) -> Array:
        """(count, cells) of the rectangles, m^2."""
        return np.repeat((self.length * self.width)[:, None], self.cells, axis=1)

    def scaled(self, factor: float) -> "Strips":
        """The same strips, with all lengths `factor` times as large."""
        sizes = {name: factor * getattr(self, name) for name in ("middle", "width", "rear", "front")}
        return replace(self, **sizes)


def ellipse_strips(
    *, semi_axis_rolling: float, semi_axis_transverse: float, count: int, cells: int, sides: Sequence[float] = ()
) -> Strips:
    """Strips over an ellipse, narrower where slip turns round and at the ends.

    semi_axis_rolling, semi_axis_transverse : a, b, m, > 0;  count, cells : of strips, about, and of rectangles on each
    sides : y where slip turns round, m, increasing: two strips meet there; those outside the ellipse are left out
    A strip reaches as far along rolling as the root mean square of the ellipse over its width: the load of Hertz's
    pressure on it is then exact.
    """
    require_positive(semi_axis_rolling=semi_axis_rolling, semi_axis_transverse=semi_axis_transverse)
    inside = [side / semi_axis_transverse for side in sides if abs(side) < semi_axis_transverse]
    zones = np.array([-1.0, *inside, 1.0])
    counts = np.maximum(np.diff(np.round(np.cumsum([0.0, *np.diff(zones)]) * count / 2)), 1).astype(int)
    borders = [np.array([-1.0])]
    for first, last, number in zip(zones[:-1], zones[1:], counts, strict=True):
        even = np.arange(1, number + 1) / number
        borders.append(first + (last - first) * (even + np.sin(np.pi / 2 * even) ** 2) / 2)
    meets = np.concatenate(borders)
    half = semi_axis_rolling * np.sqrt(1 - np.diff(meets**3) / 3 / np.diff(meets))
    return Strips(
        middle=semi_axis_transverse * (meets[1:] + meets[:-1]) / 2,
        width=semi_axis_transverse * np.diff(meets),
        rear=-half,
        front=half,
        cells=cells,
    )


def hertz_pressure(strips: Strips, *, load: float) -> Array:
    """Mean pressure of Hertz on the rectangles of `ellipse_strips`, Pa, (count, cells); load : Q, N, >= 0.

    On each strip it is an ellipse over x. What lies ahead of the first rectangle is added to it, and the sum is Q.
    """
    half = strips.front[:, None]
    ends = np.clip(strips.edges / half, -1, 1)
    ends[:, -1] = 1
    carried = np.diff((ends * np.sqrt(1 - ends**2) + np.arcsin(ends)) / 2, axis=1) * half**2 / strips.length[:, None]
    return carried * load / np.sum(carried * strips.area)
