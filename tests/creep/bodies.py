"""Materials and a contact, typed in by hand so that no formula of `analytic` takes part."""

from typing import NamedTuple

import numpy as np

from analytic.oil.traction import PointLaw
from analytic.scene import Array, Material
from fembearing.creep.friction import sliding_law
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.rolling import (
    Creepages,
    RollingFriction,
    RollingSurfaces,
    pressed_slip,
    rolling_friction,
    rolling_surfaces,
)
from fembearing.creep.strips import Strips, ellipse_strips, hertz_pressure
from tests.contacts import NITRIDE, STEEL

LIKE = HalfSpaces(ball=STEEL, race=STEEL)
HYBRID = HalfSpaces(ball=NITRIDE, race=STEEL)
LOAD, ROLLING, TRANSVERSE = 371.0, 1.023e-4, 9.448e-4  # N, m: about the inner race of a 6205 under 1000 N
RADIUS, SPEED_RADIUS = 4.05e-3, 3.2e-3  # m: R of the contact surface; rolling speed over w_roll


def of_modulus(poisson_ratio: float, shear_modulus: float) -> Material:
    return Material(
        name="test",
        youngs_modulus=2 * (1 + poisson_ratio) * shear_modulus,
        poisson_ratio=poisson_ratio,
        density=1e3,
        source="test",
    )


class Case(NamedTuple):
    """A contact of the 6205's size on a grid."""

    surfaces: RollingSurfaces
    pressure: Array
    pressed: Array

    def rolls(self, creepages: Creepages, friction: float, start: RollingFriction | None = None) -> RollingFriction:
        return rolling_friction(
            self.surfaces,
            creepages,
            pressure=self.pressure,
            law=sliding_law(PointLaw(boundary=friction), pressure=self.pressure, speed=0.7),
            pressed=self.pressed,
            start=start,
        )


def case(strips: Strips, influence: HalfSpaces = LIKE) -> Case:
    pressure = hertz_pressure(strips, load=LOAD)
    return Case(rolling_surfaces(strips, influence), pressure, pressed_slip(strips, influence, pressure))


def race_strips(count: int, cells: int, sides: tuple[float, ...] = ()) -> Strips:
    return ellipse_strips(
        semi_axis_rolling=ROLLING, semi_axis_transverse=TRANSVERSE, count=count, cells=cells, sides=sides
    )


def conformity(spin: float, along: float) -> Creepages:
    """Of a curved contact; spin : w_s R/(w_roll b);  along : y/b where it does not slip."""
    bend = -1 / (2 * RADIUS * SPEED_RADIUS)
    return Creepages(-bend * (along * TRANSVERSE) ** 2, bend, 0.0, spin * TRANSVERSE / RADIUS / SPEED_RADIUS)


def forces(found: RollingFriction) -> Array:
    """Along, across, spin over a thousandth of a metre."""
    return np.array([found.force_along, found.force_across, found.spin_moment * 1e3])
