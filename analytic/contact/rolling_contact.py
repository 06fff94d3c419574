"""A loaded contact of a ball with its race or its cage pocket, for the formulas of film, rolling and sliding.

x points in the direction of rolling, y transverse to it, z along the load. What resists sliding is not a field but a
separate argument.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import loaded_hertz, unit_hertz
from analytic.numerics.elements import NotNegative, Positive, formula


class ContactNumbers(NamedTuple):
    """Two elastic bodies under load; the last three fields are of a ball that rolls on its race.

    Rates are per unit ring speed w, so they exist at standstill too.
    """

    load: NotNegative  # Q, N
    semi_axis_rolling: NotNegative  # a, m; not 0 under load
    semi_axis_transverse: NotNegative  # b, m; not 0 under load
    curvature_rolling: Positive  # 1/R_x, relative, the sum of both bodies, in the direction of rolling, 1/m
    curvature_transverse: Positive  # 1/R_y, relative, transverse to rolling, 1/m
    modulus: Positive  # E*, Pa
    deformed_radius: float = np.nan  # R, transverse radius of the contact surface, m, > 0
    rolling_rate: float = np.nan  # w_roll/w, >= 0; at 0 it only spins, which `sliding.ellipse` allows
    entrainment: float = np.nan  # u/w, of both surfaces relative to the contact, m


@formula
def elliptic_contact(
    curvature_rolling: Positive, curvature_transverse: Positive, load: NotNegative, modulus: Positive
) -> ContactNumbers:
    """The contact of two bodies with Hertz's semi-axes; 1/m, N and Pa, as the fields."""
    hertz = loaded_hertz(unit_hertz(curvature_rolling, curvature_transverse, modulus), load)
    a, b, none = hertz.semi_axis_x, hertz.semi_axis_y, np.nan
    return ContactNumbers(load, a, b, curvature_rolling, curvature_transverse, modulus, none, none, none)


@formula
def deformed_radius(groove_radius: Positive, ball_diameter: Positive) -> float:
    """Transverse radius R of the contact surface, m: 2 f D/(2 f + 1) with f = r_g/D.

    groove_radius, ball_diameter : r_g, D, m, > 0
    Bodies of equal elasticity meet halfway: the curvature of the surface is the mean of those of ball and groove.
    """
    conformity = groove_radius / ball_diameter
    return 2 * conformity * ball_diameter / (2 * conformity + 1)
