"""Hertz point contact: two smooth elastic bodies pressed together without friction.

Assumes linear elasticity, a contact small compared with every radius of curvature, and a gap that is a paraboloid
(z = curvature_x x^2/2 + curvature_y y^2/2). x is the direction of rolling, y is transverse to it; either semi-axis may
be the longer one. A curvature is positive where the body is convex.
Source: [Johnson1985] section 4.2; elliptic integrals by the arithmetic-geometric mean, [DLMF] section 19.8.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import ConvergenceError, InputError, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import NotNegative, Positive, formula
from analytic.numerics.records import Real
from analytic.numerics.root import cube_root
from analytic.scene import Contact, Material

# Newton converges quadratically with |error_next| < 0.015 error^2, so a step below this leaves less than round-off.
LAST_STEP = 3e-7
MOST_STEPS = 20  # one or two are usual up to a ratio of 3000, three up to 1e12
LAST_TERM = 1e-17  # of a sum whose terms fall quadratically
NEAR_CIRCLE = 1e-4  # -ln s below which the slope of Newton's function is that of the circle to 1e-8
# Powers of ln(ratio)^2 in the start of Newton's method: fitted here, to 2.2e-7 up to a ratio of 1100.
START_ABOVE = (4 / 3, 0.118703435, 0.0025121474, 9.30218648e-06)
START_BELOW = (1.0, 0.093656896, 0.00212502223, 8.60234564e-06)


class HertzContact(NamedTuple):
    """The contact of two bodies, or of many: then every field has the broadcast shape of the arguments."""

    semi_axis_x: Real  # in the direction of rolling, m
    semi_axis_y: Real  # transverse, m
    peak_pressure: Real  # p0, at the centre, Pa
    approach: Real  # delta, of two points far inside the bodies, m
    stiffness: Real  # K = load / approach^1.5, N/m^1.5; finite at zero load too


@compiled
def elliptic_integrals(squared_ratio: float) -> tuple[float, float]:
    """(K, D/K) at m = 1 - squared_ratio, to a few roundings from the circle to the line.

    With the arithmetic and geometric means a and b of their predecessors, a_0 = 1, b_0 = sqrt(squared_ratio):
        K = pi/(2 a_N),  D/K = 1/2 + sum over n of 2^(n-1) c_n^2/m,  c_n = (a_(n-1) - b_(n-1))/2 = c_(n-1)^2/(4 a_n)
    All terms are positive, and none is divided by m: c_1^2/m = (1 - b_0)/(4 (1 + b_0)).
    """
    a, b = 1.0, np.sqrt(squared_ratio)
    part = (1 - b) / (4 * (1 + b))  # c_n^2/m
    share, weight = 0.5, 1.0
    while weight * part > LAST_TERM:
        share += weight * part
        a, b = (a + b) / 2, np.sqrt(a * b)
        part *= part * (1 - squared_ratio) / (4 * (a + b) ** 2)
        weight *= 2
    return np.pi / (a + b), share


class Ellipse(NamedTuple):
    """The shape of a contact."""

    squared_ratio: float  # s = (minor/major)^2
    integral_k: float  # K(m) at m = 1 - s
    integral_d: float  # D(m)


@compiled
def ellipse_of(log_curvature_ratio: float) -> Ellipse:
    """The ellipse for ln(larger/smaller curvature) >= 0, by Newton's method in t = -ln s; NaN if it fails.

    ln of the curvature ratio is an increasing convex function of t with slope 3/4 (circle) to 1 (line). So t lies
    between 1 and 4/3 times ln of the ratio, and Newton's method kept in that bracket cannot fail.
    The last step is so small that s, K and D follow it by their slopes: dK/dt = B/2, dD/dt = (B - s D)/(2 m).
    """
    square = log_curvature_ratio**2
    above = START_ABOVE[0] + square * (START_ABOVE[1] + square * (START_ABOVE[2] + square * START_ABOVE[3]))
    below = START_BELOW[0] + square * (START_BELOW[1] + square * (START_BELOW[2] + square * START_BELOW[3]))
    t = log_curvature_ratio * above / below
    for _ in range(MOST_STEPS):
        s = np.exp(-t)
        m = 1 - s
        integral_k, share = elliptic_integrals(s)
        integral_d, integral_b = share * integral_k, (1 - share) * integral_k
        ratio = integral_b / (s * integral_d)
        slope, growth = 0.75, 3 / 8 * integral_d  # of the circle, to within t; 0/0 there
        if t > NEAR_CIRCLE:
            slope = 1.5 - (ratio - 1) / (2 * m) * (1 / ratio + s)
            growth = (integral_b - s * integral_d) / (2 * m)
        step = (log_curvature_ratio - np.log(ratio)) / slope
        if abs(step) < LAST_STEP:
            return Ellipse(
                s * (1 - step * (1 - step / 2)), integral_k + step * integral_b / 2, integral_d + step * growth
            )
        t = min(max(t + step, log_curvature_ratio), 4 / 3 * log_curvature_ratio)
    return Ellipse(np.nan, np.nan, np.nan)


@formula
def unit_hertz(curvature_x: Positive, curvature_y: Positive, modulus: Positive) -> HertzContact:
    """The contact under 1 N; NaN where the ellipse does not settle.

    curvature_x, curvature_y : relative, along and across rolling, 1/m, > 0;  modulus : E*, Pa, > 0
    With s = (minor/major)^2 and the elliptic integrals K(m), D(m) = (K - E)/m and B(m) = K - D at m = 1 - s:
        B/(s D) = larger over smaller curvature
        major^3 = 3 Q D/(pi E* smaller curvature),  minor = sqrt(s) major
        p0 = 3 Q/(2 pi major minor),  delta = 3 Q K/(2 pi E* major)
    Curvature ratios from 1 (a circle, exactly) to 1e6 agree with 50-digit arithmetic to 1e-14.
    """
    x_is_minor = curvature_x >= curvature_y
    larger, smaller = max(curvature_x, curvature_y), min(curvature_x, curvature_y)
    ellipse = ellipse_of(np.log(larger / smaller))
    major = cube_root(3 * ellipse.integral_d / (np.pi * modulus * smaller))
    minor = np.sqrt(ellipse.squared_ratio) * major
    approach = 3 * ellipse.integral_k / (2 * np.pi * modulus * major)
    return HertzContact(
        minor if x_is_minor else major,
        major if x_is_minor else minor,
        3 / (2 * np.pi * major * minor),
        approach,
        1 / (approach * np.sqrt(approach)),
    )


@formula
def loaded_hertz(unit: HertzContact, load: NotNegative) -> HertzContact:
    """The contact under a load Q, N, >= 0, from that under 1 N: the ellipse keeps its shape.

    Semi-axes and pressure grow as Q^(1/3), the approach as Q^(2/3).
    """
    root = cube_root(load)
    return HertzContact(
        unit.semi_axis_x * root,
        unit.semi_axis_y * root,
        unit.peak_pressure * root,
        unit.approach * root**2,
        unit.stiffness,
    )


@formula
def _hertz(curvature_x: Positive, curvature_y: Positive, load: NotNegative, modulus: Positive) -> HertzContact:
    return loaded_hertz(unit_hertz(curvature_x, curvature_y, modulus), load)


def hertz_contact(
    *, curvature_x: ArrayLike, curvature_y: ArrayLike, load: ArrayLike, modulus: ArrayLike
) -> HertzContact:
    """Size, pressure and approach of an elliptic contact.

    Parameters
    ----------
    curvature_x, curvature_y : array_like
        Relative curvatures 1/R along and across rolling, summed over both bodies, 1/m, > 0.
    load : array_like
        Q, N, >= 0. At 0 the semi-axes, the pressure and the approach are 0.
    modulus : array_like
        Contact modulus ``E*``, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, Pa, > 0; not the E' = 2 E* of films.

    Returns
    -------
    HertzContact
        Each field has the broadcast shape of the arguments: m, Pa, N/m^1.5.

    Raises
    ------
    InputError
        An argument is negative, zero (load excepted) or not finite, or shapes do not broadcast.

    Notes
    -----
    The formulas of `unit_hertz`. Source: [Johnson1985] section 4.2.
    """
    return _settled(_hertz(curvature_x, curvature_y, load, modulus))


def _settled(contact: HertzContact) -> HertzContact:
    """The same; raises ConvergenceError where the ellipse is NaN."""
    if np.isnan(contact.semi_axis_x).any():
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=float("nan"),
            tolerance=LAST_STEP,
            unit="of ln(a/b)^2",
            problem="the ellipse",
            remedy="Check that the curvatures are of ordinary size.",
        )
    return contact


def loaded_contact(unit: HertzContact, *, load: ArrayLike) -> HertzContact:
    """`loaded_hertz` of contacts under 1 N; load : Q, N, >= 0, broadcasts with their fields."""
    return _settled(loaded_hertz(unit, load))


@lru_cache(maxsize=64)  # every step of an equilibrium needs it
def contact_modulus(first: Material, second: Material) -> float:
    """E* of two bodies in contact, Pa: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, [Johnson1985] equation 3.15b.

    Raises InputError if a Young's modulus is not positive or a Poisson ratio lies outside [-1, 0.5].
    """
    for material in (first, second):
        require_positive(youngs_modulus=material.youngs_modulus)
        if not -1 <= material.poisson_ratio <= 0.5:
            raise InputError(
                f"poisson_ratio of {material.name} must lie in [-1, 0.5], got {material.poisson_ratio!r}; "
                "metals have about 0.3"
            )
    return 1 / sum((1 - body.poisson_ratio**2) / body.youngs_modulus for body in (first, second))


def ball_share(ball: Material, race: Material) -> float:
    """Share of the ball in the compliance 1/E* of both bodies."""
    return contact_modulus(ball, race) * (1 - ball.poisson_ratio**2) / ball.youngs_modulus


def relative_curvatures(contact: Contact) -> tuple[float, float]:
    """Relative curvatures (rolling, transverse) of a ball in a groove, 1/m.

        rolling = 1/ball_radius + 1/rolling_radius,  transverse = 1/ball_radius - 1/groove_radius
    Raises InputError if a radius is not positive (the rolling radius: if it is 0), if the groove is not wider than the
    ball (conformity 0.5 is a line contact), or if a concave race has a rolling radius not larger than the ball's.
    """
    ball, groove, rolling = contact.ball_radius, contact.groove_radius, contact.rolling_radius
    require_positive(ball_radius=ball, groove_radius=groove)
    if not groove > ball:
        raise InputError(
            f"groove_radius {groove!r} m must exceed ball_radius {ball!r} m: at conformity 0.5 the contact is a line, "
            "not a point; bearings have groove_radius of 1.02 to 1.08 ball radii"
        )
    if not (rolling > 0 or rolling < -ball):  # refuses NaN too
        raise InputError(
            f"rolling_radius must be positive (inner race) or below -ball_radius = {-ball!r} m (outer race), "
            f"got {rolling!r} m"
        )
    return 1 / ball + 1 / rolling, (groove - ball) / (ball * groove)
