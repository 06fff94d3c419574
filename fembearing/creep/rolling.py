"""Steady rolling with friction: where a contact sticks and slips, and what forces it transmits.

A point that rolls through the contact slips by s/V = v - du/dx: v is the slip of rigid bodies over the rolling speed V,
and u the displacement of the ball's surface along that of its race. u follows from the tractions by an `Influence`, and
these from the slip by the law of friction. The method is Kalker's [Kalker1990]; it knows no formula for a moment.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from analytic.scene import Array
from fembearing.creep.friction import SlidingLaw, settle
from fembearing.creep.half_space import Influence
from fembearing.creep.strips import Strips

TINY = 1e-300  # over which a change of slip is not 0
STICKS = 1e-9  # of the largest slip: below it a rectangle sticks


class Creepages(NamedTuple):
    """Slip of rigid bodies over the rolling speed, the ball's less the race's; x points to the leading edge.

    Along x it is along + along_bend y^2 - spin y, and along y across + (spin - 2 along_bend y) x: the bodies turn about
    the normal of the curved surface.
    """

    along: float = 0.0
    along_bend: float = 0.0  # 1/m^2
    across: float = 0.0
    spin: float = 0.0  # 1/m


@dataclass(frozen=True, kw_only=True, eq=False)
class RollingSurfaces:
    """Strips and what their tractions do to the slip."""

    strips: Strips
    gradient: Array  # (2, strips, cells + 1, 2 n) of the slip at the ends of the rectangles by tractions, 1/Pa

    @cached_property
    def patterns(self) -> Array:
        """(2, strips, cells + 1, 4) slip at the ends of the rectangles by each of the creepages being 1."""
        edges = self.strips.edges
        return _patterns(edges, np.broadcast_to(self.strips.middle[:, None], edges.shape))

    @cached_property
    def levers(self) -> Array:
        """(4, 2 n) force that belongs to each creepage, by unit tractions: areas times the patterns at the middles."""
        patterns = _patterns(self.strips.x, self.strips.y) * self.strips.area[..., None]
        return patterns.reshape(-1, 4).T

    @cached_property
    def stiffness(self) -> Array:
        """(n,) traction over slip of each rectangle alone, Pa."""
        n = self.strips.x.size
        own = self.gradient[:, :, 1:].reshape(2, n, 2, n)
        return 2 / (own[0, :, 0].diagonal() + own[1, :, 1].diagonal())

    def scaled(self, factor: float) -> "RollingSurfaces":
        """The same for a contact with all lengths `factor` times as large; exact for half spaces."""
        return RollingSurfaces(strips=self.strips.scaled(factor), gradient=self.gradient)


@dataclass(frozen=True, kw_only=True, eq=False)
class RollingFriction:
    """Tractions and slip of a contact in steady rolling. Maps are (strips, cells); x points to the leading edge."""

    strips: Strips
    creepages: Creepages
    pressure: Array  # Pa
    traction: Array  # (2, strips, cells) on the ball, along x and y, at the middles, Pa
    slip: Array  # (2, strips, cells) over the rolling speed, where it is taken
    behind: Array  # (strips, cells) how far behind the leading sides the slip was taken, over the length
    slides: Array  # (strips, cells) how far it should be: half where a rectangle slides, 0 where it sticks
    forces: Array  # (4,) on the ball that belong to the creepages; force times creepage is power over V; N, N m^2, N m
    response: Array  # (4, 4) of the forces to the creepages
    steps: int  # of Newton's method

    @property
    def force_along(self) -> float:
        """On the ball along x, N."""
        return float(self.forces[0])

    @property
    def force_across(self) -> float:
        """On the ball along y, N."""
        return float(self.forces[2])

    @property
    def bend_moment(self) -> float:
        """Forces on the ball along x times y^2, less those along y times 2 x y, N m^2."""
        return float(self.forces[1])

    @property
    def spin_moment(self) -> float:
        """On the ball about the contact's normal, N m."""
        return float(self.forces[3])

    @property
    def power(self) -> float:
        """Lost, over the rolling speed, N: minus all forces times their creepages."""
        return -float(self.forces @ np.array(self.creepages))

    @property
    def friction_power(self) -> float:
        """Lost where surfaces slip, over the rolling speed, N: equal to `power` but for the size of the rectangles."""
        return -float(np.sum(self.traction * self.slip * self.strips.area))

    @property
    def slip_share(self) -> float:
        """Share of the area that slips."""
        speed = np.hypot(*self.slip)
        area = self.strips.area
        return float(np.sum(area[speed > STICKS * np.max(speed)]) / np.sum(area))


def rolling_surfaces(strips: Strips, influence: Influence) -> RollingSurfaces:
    """What tractions on the strips do to the slip, by an influence."""
    moved = influence.by_traction(strips, *_points(strips))
    moved = moved.transpose(0, 2, 1, 3).reshape(2, len(strips.middle), strips.cells + 2, -1)
    gradient = (moved[:, :, :-1] - moved[:, :, 1:]) / strips.length[:, None, None]
    return RollingSurfaces(strips=strips, gradient=gradient)


def pressed_slip(strips: Strips, influence: Influence, pressure: Array) -> Array:
    """Slip over the rolling speed at the ends of the rectangles, as pressure moves unlike materials along each other.

    pressure : Pa, (strips, cells);  the slip is (2, strips, cells + 1)
    """
    moved = influence.by_pressure(strips, pressure, *_points(strips)).reshape(2, len(strips.middle), -1)
    return (moved[:, :, :-1] - moved[:, :, 1:]) / strips.length[:, None]


def rolling_friction(
    surfaces: RollingSurfaces,
    creepages: Creepages,
    *,
    pressure: Array,
    law: SlidingLaw,
    pressed: Array | float = 0.0,
    start: RollingFriction | None = None,
    follows: bool = True,
) -> RollingFriction:
    """Stick and slip of a contact that rolls steadily.

    pressure : Pa, (strips, cells), >= 0;  law : of the same pressure and speed, by `sliding_law`
    pressed : of `pressed_slip`;  start : of the same strips; None: no tractions
    follows : whether the places where slip is taken follow from what slipped at the start; else they are those of it
    Raises ConvergenceError where Newton's method ends short of it.
    """
    given, strips = np.array(creepages), surfaces.strips
    behind, traction = np.zeros(strips.x.shape), np.zeros(2 * strips.x.size)
    if start is not None:
        behind, traction = start.slides if follows else start.behind, start.traction.ravel()
    rigid = surfaces.patterns @ given + pressed
    patterns = between(surfaces.patterns, behind).reshape(traction.size, -1)
    found = settle(
        between(surfaces.gradient, behind).reshape(traction.size, -1),
        between(rigid, behind).ravel(),
        law,
        stiffness=surfaces.stiffness,
        patterns=patterns,
        start=traction,
    )
    ends = rigid + surfaces.gradient @ found.traction
    change = np.hypot(*np.diff(ends, axis=2))
    return RollingFriction(
        strips=strips,
        creepages=creepages,
        pressure=pressure,
        traction=found.traction.reshape(2, *strips.x.shape),
        slip=found.slip.reshape(2, *strips.x.shape),
        behind=behind,
        slides=np.minimum(1.0, np.hypot(*ends[:, :, 1:]) / np.maximum(change, TINY)) / 2,
        forces=surfaces.levers @ found.traction,
        response=surfaces.levers @ found.response,
        steps=found.steps,
    )


def between(ends: Array, behind: Array) -> Array:
    """Of each rectangle, from its ends along axis 2: ahead, but for the share `behind`."""
    share = behind.reshape(*behind.shape, *([1] * (ends.ndim - 3)))
    return ends[:, :, 1:] * (1 - share) + ends[:, :, :-1] * share


def _patterns(x: Array, y: Array) -> Array:
    """(2, ..., 4) slip along x and y by each of the creepages."""
    one, none = np.ones_like(x), np.zeros_like(x)
    along = np.stack([one, y**2, none, -y], axis=-1)
    across = np.stack([none, -2 * x * y, one, x], axis=-1)
    return np.stack([along, across])


def _points(strips: Strips) -> tuple[Array, Array]:
    """Middles of the rectangles of each strip, and of one more at both ends: x and y, (strips (cells + 2),)."""
    x = strips.x[:, :1] + strips.length[:, None] * np.arange(-1, strips.cells + 1)
    return x.ravel(), np.repeat(strips.middle, strips.cells + 2)
