"""A loaded contact of a ball with its race or its cage pocket, for the formulas of film, rolling and sliding.

x points in the direction of rolling, y transverse to it, z along the load. All fields of a contact broadcast: they have
one entry for each ball, race or operating point. What resists sliding is not a field but a separate argument.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.hertz import hertz_contact
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.scene import Array

Numbers = Array | float


@dataclass(frozen=True, kw_only=True, eq=False)
class EllipticContact:
    """Two elastic bodies under load.

    Raises InputError if a field has the wrong sign or is not finite, or if the fields do not broadcast.
    """

    load: Numbers  # Q, N, >= 0
    semi_axis_rolling: Numbers  # a, m, >= 0, and not 0 under load
    semi_axis_transverse: Numbers  # b, m, >= 0, and not 0 under load
    curvature_rolling: Numbers  # 1/R_x, relative, the sum of both bodies, in the direction of rolling, 1/m, > 0
    curvature_transverse: Numbers  # 1/R_y, relative, transverse to rolling, 1/m, > 0
    modulus: Numbers  # E*, Pa, > 0

    def __post_init__(self) -> None:
        require_non_negative(
            load=self.load,
            semi_axis_rolling=self.semi_axis_rolling,
            semi_axis_transverse=self.semi_axis_transverse,
        )
        require_positive(
            curvature_rolling=self.curvature_rolling,
            curvature_transverse=self.curvature_transverse,
            modulus=self.modulus,
        )
        shapes = [np.shape(value) for value in vars(self).values()]
        try:
            np.broadcast_shapes(*shapes)
        except ValueError as problem:
            raise InputError(
                f"{', '.join(vars(self))} of a contact have shapes {', '.join(map(str, shapes))}: give equal lengths"
            ) from problem

    @property
    def fields(self) -> tuple[Numbers, ...]:
        """Nine numbers in the order of `ContactNumbers`, which broadcast; NaN where the contact does not have them."""
        return (
            self.load,
            self.semi_axis_rolling,
            self.semi_axis_transverse,
            self.curvature_rolling,
            self.curvature_transverse,
            self.modulus,
            np.nan,
            np.nan,
            np.nan,
        )

    @property
    def area(self) -> Array:
        """A_H = pi a b, m^2."""
        return np.pi * np.asarray(self.semi_axis_rolling) * np.asarray(self.semi_axis_transverse)

    @property
    def mean_pressure(self) -> Array:
        """Q/A_H, Pa; 0 where the contact is a point."""
        load, area = np.broadcast_arrays(np.asarray(self.load, dtype=np.float64), self.area)
        return np.divide(load, area, out=np.zeros(area.shape), where=area > 0)


@dataclass(frozen=True, kw_only=True, eq=False)
class RollingContact(EllipticContact):
    """A ball that rolls on its race. Rates are per unit ring speed w, so they exist at standstill too."""

    deformed_radius: Numbers  # R, transverse radius of the contact surface, m, > 0
    rolling_rate: Numbers  # w_roll/w, >= 0; at 0 it only spins, which `sliding.ellipse` allows

    def __post_init__(self) -> None:
        super().__post_init__()
        require_positive(deformed_radius=self.deformed_radius)
        require_non_negative(rolling_rate=self.rolling_rate)

    @property
    def fields(self) -> tuple[Numbers, ...]:
        return (*super().fields[:6], self.deformed_radius, self.rolling_rate, np.nan)

    @property
    def ball_diameter(self) -> Array:
        """D, m: the ball is convex, so 2/D is the mean curvature 1/R of both bodies and half their difference 1/R_y."""
        return 2 / (1 / np.asarray(self.deformed_radius) + np.asarray(self.curvature_transverse) / 2)


Pair = tuple[RollingContact, RollingContact]  # a ball on the inner and on the outer race


class ContactNumbers(NamedTuple):
    """One `RollingContact` in numbers, for compiled formulas; rates are per unit ring speed."""

    load: float  # Q, N
    semi_axis_rolling: float  # a, m
    semi_axis_transverse: float  # b, m
    curvature_rolling: float  # 1/R_x, relative, 1/m
    curvature_transverse: float  # 1/R_y, relative, 1/m
    modulus: float  # E*, Pa
    deformed_radius: float  # R, transverse radius of the contact surface, m
    rolling_rate: float  # w_roll/w
    entrainment: float  # u/w, of both surfaces relative to the contact, m


def elliptic_contact(
    *, curvature_rolling: ArrayLike, curvature_transverse: ArrayLike, load: ArrayLike, modulus: ArrayLike
) -> EllipticContact:
    """The contact of two bodies with the semi-axes of `hertz_contact`.

    The arguments broadcast. Their ranges are those of the fields, and the errors those of `hertz_contact`.
    """
    require_positive(curvature_rolling=curvature_rolling, curvature_transverse=curvature_transverse)
    hertz = hertz_contact(curvature_x=curvature_rolling, curvature_y=curvature_transverse, load=load, modulus=modulus)
    return EllipticContact(
        load=np.asarray(load, dtype=np.float64),
        semi_axis_rolling=hertz.semi_axis_x,
        semi_axis_transverse=hertz.semi_axis_y,
        curvature_rolling=np.asarray(curvature_rolling, dtype=np.float64),
        curvature_transverse=np.asarray(curvature_transverse, dtype=np.float64),
        modulus=np.asarray(modulus, dtype=np.float64),
    )


def deformed_radius(*, groove_radius: ArrayLike, ball_diameter: ArrayLike) -> Array:
    """Transverse radius R of the contact surface, m: 2 f D/(2 f + 1) with f = r_g/D; the arguments broadcast.

    groove_radius, ball_diameter : r_g, D, m, > 0
    Bodies of equal elasticity meet halfway: the curvature of the surface is the mean of those of ball and groove.
    """
    require_positive(groove_radius=groove_radius, ball_diameter=ball_diameter)
    conformity = np.asarray(groove_radius, dtype=np.float64) / np.asarray(ball_diameter, dtype=np.float64)
    return 2 * conformity * np.asarray(ball_diameter, dtype=np.float64) / (2 * conformity + 1)
