"""What the surfaces of two half spaces do under tractions and pressures on rectangles.

Source: Boussinesq's and Cerruti's point forces, [Johnson1985] section 3.2, integrated over rectangles [Kalker1990].
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array, Material
from fembearing.creep.strips import Strips

TINY = 1e-300  # m: keeps the logarithm of a corner on an axis finite, where its factor is 0


class Influence(Protocol):
    """How far the surface of the ball moves along its race's, where tractions and pressure act on rectangles.

    A traction acts on the ball, and its opposite on the race. The rectangles are in the order of `Strips.x.ravel()`.
    """

    def by_traction(self, strips: Strips, x: Array, y: Array) -> Array:
        """Displacement of the ball less that of the race by a unit traction on one rectangle.

        x, y : points of the surface, m, (points,)
        It is along x and y, by traction along x and y, m/Pa, (2, 2, points, rectangles).
        """
        ...

    def by_pressure(self, strips: Strips, pressure: Array, x: Array, y: Array) -> Array:
        """Tangential displacement of the ball less that of the race by all pressure.

        pressure : on the rectangles, Pa, (strips, cells);  x, y : points of the surface, m, (points,)
        It is along x and y, m, (2, points); 0 for like materials.
        """
        ...


@dataclass(frozen=True, kw_only=True)
class HalfSpaces:
    """Ball and race as elastic half spaces; see `Influence`.

    Pressure moves the surfaces of unlike materials along each other. That tractions move them apart, and so change the
    pressure, is left out: with Dundurs' second constant beta the change is of the order of mu beta.
    """

    ball: Material
    race: Material

    def by_traction(self, strips: Strips, x: Array, y: Array) -> Array:
        """As `Influence` has it."""
        influence = np.empty((2, 2, x.size, strips.x.size))
        mixed = sum(body.poisson_ratio * _softness(body) for body in (self.ball, self.race))
        whole = _softness(self.ball) + _softness(self.race)
        for corners, strip in _corners(strips, x, y):
            along, across = corners.y * corners.log_x, corners.x * corners.log_y
            influence[0, 0][:, strip] = _over_sides(whole * along + (whole - mixed) * across)
            influence[1, 1][:, strip] = _over_sides(whole * across + (whole - mixed) * along)
            influence[0, 1][:, strip] = influence[1, 0][:, strip] = _over_sides(-mixed * corners.r)
        return influence

    def by_pressure(self, strips: Strips, pressure: Array, x: Array, y: Array) -> Array:
        """As `Influence` has it."""
        pulls = [(0.5 - body.poisson_ratio) * _softness(body) for body in (self.ball, self.race)]
        moved, flat = np.zeros((2, x.size)), pressure.ravel()
        if pulls[0] == pulls[1]:
            return moved
        for corners, strip in _corners(strips, x, y):
            log_r = np.log(corners.r + TINY)
            along = corners.y * log_r + np.abs(corners.x) * np.arctan2(corners.y, np.abs(corners.x))
            across = corners.x * log_r + np.abs(corners.y) * np.arctan2(corners.x, np.abs(corners.y))
            for axis, part in enumerate((along, across)):
                moved[axis] -= (pulls[0] - pulls[1]) * (_over_sides(part) @ flat[strip])
        return moved


@dataclass(frozen=True, kw_only=True, eq=False)
class _Corners:
    """Corners of the rectangles of one strip, seen from points: right and left sides, (2, points, cells + 1)."""

    x: Array
    y: Array

    @property
    def r(self) -> Array:
        return np.hypot(self.x, self.y)

    @property
    def log_x(self) -> Array:
        """asinh(x/|y|): ln(x + r) but for ln |y|, which has no part in a difference over x."""
        return np.sign(self.x) * np.log((np.abs(self.x) + self.r + TINY) / (np.abs(self.y) + TINY))

    @property
    def log_y(self) -> Array:
        return np.sign(self.y) * np.log((np.abs(self.y) + self.r + TINY) / (np.abs(self.x) + TINY))


def _corners(strips: Strips, x: Array, y: Array) -> Iterator[tuple[_Corners, slice]]:
    """Of the rectangles of each strip, and where these are among all."""
    for j in range(len(strips.middle)):
        sides = strips.middle[j] + strips.width[j] * np.array([-0.5, 0.5])
        along = x[None, :, None] - strips.edges[j][None, None, :]
        across = np.broadcast_to((y - sides[:, None])[:, :, None], (2, *along.shape[1:]))
        corners = _Corners(x=np.broadcast_to(along, across.shape), y=across)
        yield corners, slice(j * strips.cells, (j + 1) * strips.cells)


def _over_sides(antiderivative: Array) -> Array:
    """Integral over each rectangle, (points, cells), from its values at the corners."""
    over_y = antiderivative[0] - antiderivative[1]
    return over_y[:, :-1] - over_y[:, 1:]


def _softness(body: Material) -> float:
    """1/(2 pi G), 1/Pa."""
    if not -1 < body.poisson_ratio <= 0.5:
        raise InputError(f"poisson_ratio of {body.name} must lie in (-1, 0.5], got {body.poisson_ratio!r}")
    return (1 + body.poisson_ratio) / (np.pi * body.youngs_modulus)
