"""Hertz point contact: two smooth elastic bodies pressed together without friction.

Assumes linear elasticity, a contact small compared with every radius of curvature, and a gap that is a paraboloid
(z = curvature_x x^2/2 + curvature_y y^2/2). x is the direction of rolling, y is transverse to it; either semi-axis may
be the longer one. A curvature is positive where the body is convex.
Source: [Johnson1985] section 4.2; elliptic integrals in the forms of [Carlson1995] and [DLMF] sections 19.2 and 19.25.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ellipe, ellipkm1, elliprd

from analytic.brief import Brief
from analytic.errors import ConvergenceError, InputError, require_non_negative, require_positive
from analytic.scene import Array, Contact, Material

# Newton converges quadratically with |error_next| < 0.015 error^2, so a step below this leaves less than round-off.
LAST_STEP = 1e-7
# The start is 1.7 from the root at a ratio of 1e6, 4.8 at 1e12: four or five steps reach round-off, the rest is margin.
MOST_STEPS = 20
# The difference (K - E)/m loses digits as m goes to 0: below this m Carlson's form is used, at ten times the cost.
NEARLY_ROUND = 0.5
NEAR_CIRCLE = 1e-4  # -ln s below which the slope of Newton's function is that of the circle to 1e-8


@dataclass(frozen=True, kw_only=True, eq=False)
class HertzContact(Brief):
    """The contact of one or many pairs of bodies; every field has the broadcast shape of the arguments."""

    semi_axis_x: Array  # in the direction of rolling, m
    semi_axis_y: Array  # transverse, m
    peak_pressure: Array  # p0, at the centre, Pa
    approach: Array  # delta, of two points far inside the bodies, m
    stiffness: Array  # K = load / approach^1.5, N/m^1.5; finite at zero load too

    def reshape(self, shape: tuple[int, ...]) -> "HertzContact":
        """The same contacts with fields of another shape."""
        return HertzContact(**{name: field.reshape(shape) for name, field in vars(self).items()})


def hertz_contact(
    *, curvature_x: ArrayLike, curvature_y: ArrayLike, load: ArrayLike, modulus: ArrayLike
) -> HertzContact:
    """Size, pressure and approach of an elliptic contact; all arguments broadcast.

    curvature_x, curvature_y : relative curvatures 1/R, summed over both bodies, rolling and transverse, 1/m, > 0
    load : Q, N, >= 0 (at 0 the semi-axes, the pressure and the approach are 0)
    modulus : E*, with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, Pa, > 0; not the E' = 2 E* of the film formulas

    With s = (minor/major)^2 and the elliptic integrals K(m), D(m) = (K - E)/m and B(m) = K - D at m = 1 - s:
        B/(s D) = larger over smaller curvature
        major^3 = 3 Q D/(pi E* smaller curvature),  minor = sqrt(s) major
        p0 = 3 Q/(2 pi major minor),  delta = 3 Q K/(2 pi E* major)
    Curvature ratios from 1 (a circle, exactly) to 1e6 agree with 50-digit arithmetic to 1e-14.
    Raises InputError if an argument is negative, zero (load excepted), not finite, or if shapes do not broadcast.
    """
    rolling, transverse, force, stiff = contact_arguments(
        curvature_x=curvature_x, curvature_y=curvature_y, load=load, modulus=modulus
    )
    log_ratio = np.log(np.asarray(curvature_x) / np.asarray(curvature_y))  # not broadcast: solved once per geometry
    squared_ratio = _squared_axis_ratio(np.abs(log_ratio))
    integral_k, integral_d = _integrals(squared_ratio)

    # Sizes at unit load times powers of the load: the stiffness stays finite and there is no 0/0 at zero load.
    root = np.cbrt(force)
    major = np.cbrt(3 * integral_d / (np.pi * stiff * np.minimum(rolling, transverse)))
    minor = np.sqrt(squared_ratio) * major
    approach = 3 * integral_k / (2 * np.pi * stiff * major)
    x_is_minor = log_ratio >= 0
    return HertzContact(
        semi_axis_x=root * np.where(x_is_minor, minor, major),
        semi_axis_y=root * np.where(x_is_minor, major, minor),
        peak_pressure=root * 3 / (2 * np.pi * major * minor),
        approach=root**2 * approach,
        stiffness=approach**-1.5,
    )


def loaded_contact(unit: HertzContact, *, load: ArrayLike) -> HertzContact:
    """The contact under any load, from the same contact under 1 N; load broadcasts with the fields of `unit`.

    load : Q, N, >= 0
    Semi-axes and pressure grow as Q^(1/3), the approach as Q^(2/3): the ellipse keeps its shape.
    Raises InputError if a load is negative or not finite.
    """
    require_non_negative(load=load)
    root = np.cbrt(np.asarray(load, dtype=np.float64))
    return HertzContact(
        semi_axis_x=unit.semi_axis_x * root,
        semi_axis_y=unit.semi_axis_y * root,
        peak_pressure=unit.peak_pressure * root,
        approach=unit.approach * root**2,
        stiffness=unit.stiffness * np.ones_like(root),
    )


def contact_arguments(
    *, curvature_x: ArrayLike, curvature_y: ArrayLike, load: ArrayLike, modulus: ArrayLike
) -> tuple[Array, Array, Array, Array]:
    """(curvature_x, curvature_y, load, modulus) as arrays of one shape; raises what hertz_contact raises."""
    require_positive(curvature_x=curvature_x, curvature_y=curvature_y, modulus=modulus)
    require_non_negative(load=load)
    given = [np.asarray(value, dtype=np.float64) for value in (curvature_x, curvature_y, load, modulus)]
    try:
        rolling, transverse, force, stiff = np.broadcast_arrays(*given, subok=False)
    except ValueError as problem:
        shapes = ", ".join(str(value.shape) for value in given)
        raise InputError(
            f"curvature_x, curvature_y, load, modulus have shapes {shapes}: give equal lengths"
        ) from problem
    return rolling, transverse, force, stiff


def _integrals(squared_ratio: Array) -> tuple[Array, Array]:
    """(K, D) at m = 1 - squared_ratio, to a few roundings from the circle to the line."""
    parameter = 1 - squared_ratio
    integral_k = ellipkm1(squared_ratio)
    nearly_round = parameter < NEARLY_ROUND
    if not np.any(nearly_round):
        return integral_k, (integral_k - ellipe(parameter)) / parameter
    difference = np.asarray(integral_k - ellipe(parameter))
    integral_d = np.divide(difference, parameter, out=difference, where=~nearly_round)
    integral_d[nearly_round] = elliprd(0.0, np.asarray(squared_ratio)[nearly_round], 1.0) / 3
    return integral_k, integral_d


def _squared_axis_ratio(log_curvature_ratio: Array) -> Array:
    """s = (minor/major)^2 for ln(larger/smaller curvature) >= 0, by Newton's method in t = -ln s.

    ln of the curvature ratio is an increasing convex function of t with slope 3/4 (circle) to 1 (line). So t lies
    between 1 and 4/3 times ln of the ratio, and Newton's method kept in that bracket cannot fail.
    It starts at s = ratio^(-4/pi), the fit of [Hamrock1983].
    """
    t, least, most, largest = 4 / np.pi * log_curvature_ratio, log_curvature_ratio, 4 / 3 * log_curvature_ratio, np.inf
    for _ in range(MOST_STEPS):
        s = np.exp(-t)
        integral_k, integral_d = _integrals(s)
        ratio = (integral_k - integral_d) / (s * integral_d)
        # 0/0 at the circle, where the slope is 3/4 to within t^2
        bend = 2 * np.expm1(-np.maximum(t, NEAR_CIRCLE))
        slope = np.where(t < NEAR_CIRCLE, 0.75, 1.5 + (ratio - 1) / bend * (1 / ratio + s))
        step = (log_curvature_ratio - np.log(ratio)) / slope
        t = np.minimum(np.maximum(t + step, least), most)
        largest = np.max(np.abs(step), initial=0.0)
        if largest < LAST_STEP:
            return np.exp(-t)
    raise ConvergenceError(
        iterations=MOST_STEPS,
        residual=float(largest),
        tolerance=LAST_STEP,
        unit="of ln(a/b)^2",
        problem="the ellipse",
        remedy="Check that the curvatures are of ordinary size.",
    )


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
