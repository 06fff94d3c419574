"""The gap between two undeformed bodies that touch in a point, and its slope along rolling."""

from dataclasses import dataclass

import numpy as np

from analytic.errors import InputError, require_positive
from analytic.scene import Array

OUTLINE = 0.99  # of the ball's radius: beyond it the gap is held, as it is so wide that oil there carries nothing


@dataclass(frozen=True, kw_only=True)
class Paraboloid:
    """x^2/(2 R_x) + y^2/(2 R_y): the shape of which Hertz's theory and all film formulas speak."""

    rolling_radius: float  # R_x, m
    transverse_radius: float  # R_y, m

    def __post_init__(self) -> None:
        require_positive(rolling_radius=self.rolling_radius, transverse_radius=self.transverse_radius)

    @property
    def radii(self) -> tuple[float, float]:
        """R_x and R_y at the point of contact, m."""
        return self.rolling_radius, self.transverse_radius

    @property
    def outline(self) -> tuple[float, float]:
        """How far the bodies reach along x and y, m: without end."""
        return np.inf, np.inf

    def gap(self, x: Array, y: Array) -> Array:
        """The gap, m, at x and y, m, which broadcast."""
        return x**2 / (2 * self.rolling_radius) + y**2 / (2 * self.transverse_radius)

    def slope(self, x: Array, y: Array) -> Array:
        """d gap/dx at x and y, m, which broadcast."""
        return np.broadcast_arrays(x / self.rolling_radius, y)[0]


@dataclass(frozen=True, kw_only=True)
class BallOnRace:
    """A ball in the groove of a race, both circles in every section; beyond the ball's outline the gap is held."""

    ball_radius: float  # r, m
    race_radius: float  # of the race along rolling, m: positive where convex (inner), negative where concave; inf: flat
    groove_radius: float  # across rolling, m; inf: no groove

    def __post_init__(self) -> None:
        require_positive(ball_radius=self.ball_radius)
        if not (self.race_radius > 0 or self.race_radius < -self.ball_radius):  # also where it is no number
            raise InputError(f"a ball of radius {self.ball_radius:g} m does not fit race_radius {self.race_radius:g} m")
        if not self.groove_radius > self.ball_radius:
            raise InputError(
                f"a ball of radius {self.ball_radius:g} m does not fit groove_radius {self.groove_radius:g} m"
            )

    @property
    def radii(self) -> tuple[float, float]:
        """R_x and R_y at the point of contact, m."""
        return 1 / (1 / self.ball_radius + 1 / self.race_radius), 1 / (1 / self.ball_radius - 1 / self.groove_radius)

    @property
    def outline(self) -> tuple[float, float]:
        """How far the bodies reach along x and y, m."""
        reach = OUTLINE * self.ball_radius
        return min(reach, OUTLINE * abs(self.race_radius)), reach

    def gap(self, x: Array, y: Array) -> Array:
        """The gap, m, at x and y, m, which broadcast and each lie within the outline."""
        race, _ = self._race(x, y)
        return _rise(np.minimum(x**2 + y**2, (OUTLINE * self.ball_radius) ** 2), self.ball_radius) - race

    def slope(self, x: Array, y: Array) -> Array:
        """d gap/dx at x and y, m, which broadcast and each lie within the outline."""
        _, race = self._race(x, y)
        square = np.minimum(x**2 + y**2, (OUTLINE * self.ball_radius) ** 2)
        within = x**2 + y**2 <= square
        return np.where(within, x / np.sqrt(self.ball_radius**2 - square), 0.0) - race

    def _race(self, x: Array, y: Array) -> tuple[Array, Array]:
        """Height of the race towards the ball over the tangent plane, m, and its slope along x."""
        groove = np.zeros_like(y) if np.isinf(self.groove_radius) else _rise(y**2, self.groove_radius)
        if np.isinf(self.race_radius):
            return groove, np.zeros_like(x)
        side = np.sign(self.race_radius)
        section = abs(self.race_radius) + side * groove  # radius of the race's circle at y
        return groove - side * _rise(x**2, section), -side * x / np.sqrt(section**2 - x**2)


def _rise(square: Array, radius: Array | float) -> Array:
    """radius - sqrt(radius^2 - square), without the loss of digits near the middle."""
    return square / (radius + np.sqrt(radius**2 - square))
