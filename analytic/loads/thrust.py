"""Pure thrust: every ball carries the same load at the same contact angle, at rest and at speed.

Assumes rigid rings apart from the contacts, and no radial load or moment. At rest, or slow, both races have one load
and one angle. At speed centrifugal force and gyroscopic moment make them differ: what `analytic.loads.ring` solves for
each ball under any load is here, with the same contacts, forces and share of the moment, one equation in one angle.
Angles are measured from the radial plane; the axial load presses the inner ring along the axis.
Source: [Harris2007] section 7 at rest; at speed [Jones1960] and [Harris2007b] section 3: the balance is that of the
forces on the ball.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection, correction_fields, correction_of
from analytic.contact.hertz import HertzContact, hertz_fields, loaded_hertz
from analytic.errors import ConvergenceError, InputError, require_finite, require_positive
from analytic.loads.numbers import BearingNumbers, bearing_numbers
from analytic.loads.thrust_ball import (
    LAST_STEP,
    MOST_ROUNDS,
    SETTLED,
    ThrustPoint,
    first_contacts,
    frozen_point,
    thrust_point,
)
from analytic.loads.turning import RuledTurning, TurningRule
from analytic.numerics.elements import mapped
from analytic.numerics.records import record_of
from analytic.scene import Array, Bearing, ContactAngle
from analytic.words import length_of


@dataclass(frozen=True, kw_only=True, eq=False)
class ThrustEquilibrium(Brief):
    """Every ball of a bearing under thrust; arrays have the shape (n,) of the axial load."""

    free_angle: float | None  # al0, rad; None where there is none: rule "given", or preload
    contact_angle: Array  # al, loaded, rad
    ball_load: Array  # Q = Fa/(Z sin al), the same on both races, N
    inner: HertzContact
    outer: HertzContact

    @property
    def approach(self) -> Array:
        """delta_i + delta_o, m."""
        return self.inner.approach + self.outer.approach


@dataclass(frozen=True, kw_only=True, eq=False)
class ThrustAtSpeed:
    """Every ball of a bearing under thrust; arrays have the shape (n,) of load and speed."""

    inner_load: Array  # Q_i, N
    outer_load: Array  # Q_o, N
    inner_angle: Array  # al_i, rad
    outer_angle: Array  # al_o, rad, below al_i
    inner: HertzContact
    outer: HertzContact


def thrust_equilibrium(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    correction: ContactCorrection | None = None,
) -> ThrustEquilibrium:
    """Loaded contact angle and ball load under pure thrust, by the scene's rule.

    Parameters
    ----------
    bearing : Bearing
        Rings and balls; its grooves must be wider than the ball.
    contact_angle : ContactAngle
        Rule `given` or `solved`; `free`, where given, replaces the unloaded angle of the clearance, rad.
    axial_load : array_like, any shape
        Fa, N, > 0.
    correction : ContactCorrection, optional
        Factors on Hertz's contacts, dimensionless, each a number or of the shape of axial_load; None: Hertz as it is.

    Returns
    -------
    ThrustEquilibrium
        Angle, rad, load, N, and Hertz's contact on both races, of the shape of axial_load.

    Raises
    ------
    InputError
        A load is not positive, an angle is outside its range, the clearance is 2 A0 or more, or a groove is no wider
        than the ball. Whether the contact stays in the groove is not checked here: `race_contact` does.

    Notes
    -----
    `given`: al = contact_angle.value, which is pi/2 in a thrust bearing. `solved`: al from ::

        Q = Fa/(Z sin al),  (A0 + delta_i(Q, al) + delta_o(Q, al)) cos al = A0 cos al0

    where A0 is the groove-centre distance and cos al0 = 1 - P_d/(2 A0), P_d the diametral clearance; P_d < 0 (preload)
    has no al0 and is solved in the same form. The left side falls as al grows from 0 to pi/2, so there is one root,
    bracketed in ln(tan al) at any load. Source: [Harris2007] section 7.
    """
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    require_given_angle(bearing, contact_angle)
    numbers = record_of(bearing_numbers(bearing, contact_angle))
    factors = correction_fields(correction or ContactCorrection())
    return _at_rest(numbers, _settled(_thrust_points(numbers, axial_load, 0.0, factors, (False, False))))


def thrust_equilibrium_frozen(
    bearing: Bearing, contact_angle: ContactAngle, *, axial_load: ArrayLike
) -> ThrustEquilibrium:
    """Loaded contact angle with contacts that stay those of the free angle: the text books' cheaper form.

    axial_load : Fa, any shape, N, > 0
    al from  A0 (cos al0/cos al - 1) = delta,  Fa/(Z sin al) = K delta^1.5,  K^(-2/3) = K_i^(-2/3) + K_o^(-2/3)
    with K_i and K_o at al0, where thrust_equilibrium lets the curvatures along rolling follow al.
    al of a 6205 from 0.18 rad: 1.7e-5 too large (relative) under 1000 N, less under less.
    Source: [Harris2007] section 7, there with K from charts.
    Raises InputError as thrust_equilibrium does, and for the rule `given` and a preload, which leave no free angle.
    """
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    if contact_angle.rule == "given":
        raise InputError(
            "the frozen stiffness solves for the loaded contact angle, which the rule 'given' gives: "
            "use thrust_equilibrium, or the rule 'solved'"
        )
    numbers = record_of(bearing_numbers(bearing, contact_angle))
    if np.isnan(numbers.free_angle):
        raise InputError(
            "the frozen stiffness is that of the free contact angle, which a preload of "
            f"{length_of(-bearing.diametral_clearance, '.6g')} on the diameter does not leave: use thrust_equilibrium, "
            "or give contact_angle.free"
        )
    first, correction = first_contacts(numbers), correction_of(correction_fields(ContactCorrection()))

    def of_number(load: float) -> tuple[float, ...]:
        push = load / bearing.ball_count
        return _fields_of(frozen_point(numbers, first, push, correction, LAST_STEP), push)

    return _at_rest(numbers, _settled(mapped(of_number, axial_load)))


def thrust_at_speed(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    inner_speed: ArrayLike,
    turning: RuledTurning | None = None,
    correction: ContactCorrection | None = None,
) -> ThrustAtSpeed:
    """Loads and contact angles of the balls on both races; load and speed broadcast to (n,).

    axial_load : Fa, N, > 0;  inner_speed : w, rad/s, any sign;  contact_angle : rule "solved", as thrust_equilibrium
    turning : what acts on the balls because they turn; None: centrifugal force and gyroscopic moment by closed
        kinematics
    correction : factors on Hertz's contacts, each a number or (n,); None leaves them as they are
    On each race load and friction across the groove are a force Q/cos p at the angle b = al + p, tan p = -F_t/Q. Along
    the axis and outward the ball is at rest where
        Q_i sin b_i/cos p_i = Q_o sin b_o/cos p_o = Fa/Z,  cot b_o = cot b_i + F_c Z/Fa
    and the grooves' centres keep the radial distance of concentric rings,
        (r_gi - r + delta_i) cos al_i + (r_go - r + delta_o) cos al_o = A0 cos al0
    Its left side falls as b_i grows. F_c and F_t are those of `turning`.
    Raises InputError as thrust_equilibrium does, ConvergenceError where the gyroscopic moment needs friction that no
    balance has.
    """
    require_finite(inner_speed=inner_speed)
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    numbers, factors = record_of(bearing_numbers(bearing, contact_angle)), correction or ContactCorrection()
    if turning is None:
        speed = np.asarray(inner_speed, dtype=np.float64)
        turning = RuledTurning(bearing=bearing, inner_speed=speed, centrifugal=True, gyroscopic=True)
    inertia = turning.centrifugal, turning.gyroscopic
    fields = _settled(_thrust_points(numbers, axial_load, turning.inner_speed, correction_fields(factors), inertia))
    _, inner_angle, outer_angle, inner_load, outer_load = fields[:5]
    inner, outer = _loaded(fields)
    return ThrustAtSpeed(
        inner_load=inner_load,
        outer_load=outer_load,
        inner_angle=inner_angle,
        outer_angle=outer_angle,
        inner=inner,
        outer=outer,
    )


def require_given_angle(bearing: Bearing, contact_angle: ContactAngle) -> None:
    """Raise InputError for a given contact angle outside its range; that of a thrust bearing is 90 degrees."""
    if bearing.kind == "thrust":
        if contact_angle.rule != "given" or contact_angle.value != np.pi / 2:
            raise InputError(
                "a thrust bearing has a contact angle of 90 degrees under every load: give "
                f"ContactAngle(rule='given', value=pi/2), got rule {contact_angle.rule!r}, value "
                f"{contact_angle.value!r}"
            )
    elif contact_angle.rule == "given" and not (contact_angle.value and 0 < contact_angle.value < np.pi / 2):
        raise InputError(f"a given contact angle must lie between 0 and pi/2 rad, got {contact_angle.value!r}")


def _at_rest(numbers: BearingNumbers, fields: Array) -> ThrustEquilibrium:
    inner, outer = _loaded(fields)
    return ThrustEquilibrium(
        free_angle=None if np.isnan(numbers.free_angle) else numbers.free_angle,
        contact_angle=fields[1],
        ball_load=fields[3],
        inner=inner,
        outer=outer,
    )


def _loaded(fields: Array) -> tuple[HertzContact, HertzContact]:
    """The contacts of both races under their loads."""
    return hertz_fields(fields[5:10]), hertz_fields(fields[10:15])


def _settled(fields: Array) -> Array:
    """The first 15 of `_fields_of`; raises ConvergenceError where the change is not 0."""
    open_rounds = ~(fields[-1] == 0)
    if open_rounds.any():
        raise unsettled(fields[-2][open_rounds], float(np.max(fields[-1])), SETTLED)
    return fields[:-2]


def unsettled(push: Array, change: float, accuracy: float) -> ConvergenceError:
    """Of balls under thrust; push : of each ball, N;  change : of the last round, of ln(tan al)."""
    return ConvergenceError(
        iterations=MOST_ROUNDS,
        residual=change,
        tolerance=float(accuracy),
        unit="of ln(tan al)",
        problem=f"the contact angle, under {np.min(push):.4g} N of thrust on each ball at least,",
        remedy="Raise the load or lower the speed: a race that hardly presses a ball cannot drive it.",
    )


def _fields_of(point: ThrustPoint, push: float) -> tuple[float, ...]:
    """(17,) ball, contacts of inner and outer race, thrust on each ball, change."""
    inner, outer = loaded_hertz(point.inner, point.ball.inner_load), loaded_hertz(point.outer, point.ball.outer_load)
    return *point.ball, *inner, *outer, push, point.change


def _thrust_points(
    numbers: BearingNumbers, load: ArrayLike, speed: ArrayLike, factors: Sequence[ArrayLike], inertia: tuple[bool, bool]
) -> Array:
    """(17, ...) of `_fields_of`; inertia : whether centrifugal force and gyroscopic moment count"""
    first = first_contacts(numbers)

    def of_numbers(load: float, speed: float, *factors: float) -> tuple[float, ...]:
        rule = TurningRule(speed, *inertia)
        return _fields_of(thrust_point(numbers, first, load, rule, correction_of(factors)), load / numbers.ball_count)

    return mapped(of_numbers, load, speed, *factors)
