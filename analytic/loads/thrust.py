"""Pure thrust: every ball carries the same load at the same contact angle, at rest and at speed.

Assumes rigid rings apart from the contacts, and no radial load or moment. At rest both races have one load and one
angle. At speed centrifugal force and gyroscopic moment make them differ: what `analytic.loads.ring` solves for
each ball under any load is here, with the same contacts, forces and share of the moment, one equation in one angle.
Angles are measured from the radial plane; the axial load presses the inner ring along the axis.
Source: [Harris2007] section 7 at rest; at speed [Jones1960] and [Harris2007b] section 3: the balance is that of the
forces on the ball.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection, CorrectionNumbers
from analytic.errors import ConvergenceError, InputError, require_finite, require_positive
from analytic.loads.numbers import bearing_numbers
from analytic.loads.state import ball_states, correct_balls, factors_of
from analytic.loads.thrust_ball import (
    LAST_STEP,
    MOST_ROUNDS,
    SETTLED,
    first_contacts,
    frozen_point,
    put_ball,
    settle_ruled_thrust,
)
from analytic.loads.turning import WHOLE_INERTIA, Inertia, TurningRule
from analytic.numerics.records import Records, as_records, record_of
from analytic.scene import Array, Bearing, ContactAngle
from analytic.words import length_of


def thrust_equilibrium(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    inner_speed: ArrayLike = 0.0,
    inertia: Inertia = WHOLE_INERTIA,
    correction: ContactCorrection | None = None,
) -> Records:
    """Load and contact angles of every ball under pure thrust, by the scene's rule.

    Parameters
    ----------
    bearing : Bearing
        Rings and balls; its grooves must be wider than the ball.
    contact_angle : ContactAngle
        Rule `given` or `solved`; `free`, where given, replaces the unloaded angle of the clearance, rad.
    axial_load : array_like
        Fa, N, > 0; broadcasts with the speed to (...).
    inner_speed : array_like
        w, rad/s, any sign.
    inertia : Inertia
        What counts of the balls' inertia, by closed kinematics.
    correction : ContactCorrection, optional
        Factors on Hertz's contacts, dimensionless, each a number or one for each point; None: Hertz as it is.

    Returns
    -------
    ndarray of `analytic.loads.state.BALL_STATE`, shape (...)
        Of one ball: `load`, N, and `angle`, rad, on inner and outer race, and `inner_unit`, `outer_unit`, its contacts
        under 1 N.

    Raises
    ------
    InputError
        A load is not positive, an angle is outside its range, the clearance is 2 A0 or more, or a groove is no wider
        than the ball. Whether the contact stays in the groove is not checked here: `race_contact` does.
    ConvergenceError
        The gyroscopic moment needs friction that no balance has.

    Notes
    -----
    `given`: al = contact_angle.value, which is pi/2 in a thrust bearing. `solved`, at rest: al from ::

        Q = Fa/(Z sin al),  (A0 + delta_i(Q, al) + delta_o(Q, al)) cos al = A0 cos al0

    where A0 is the groove-centre distance and cos al0 = 1 - P_d/(2 A0), P_d the diametral clearance; P_d < 0 (preload)
    has no al0 and is solved in the same form. The left side falls as al grows from 0 to pi/2, so there is one root,
    bracketed in ln(tan al) at any load. Source: [Harris2007] section 7.

    At speed load and friction across the groove of each race are a force Q/cos p at the angle b = al + p,
    tan p = -F_t/Q. Along the axis and outward the ball is at rest where ::

        Q_i sin b_i/cos p_i = Q_o sin b_o/cos p_o = Fa/Z,  cot b_o = cot b_i + F_c Z/Fa

    and the grooves' centres keep the radial distance of concentric rings ::

        (r_gi - r + delta_i) cos al_i + (r_go - r + delta_o) cos al_o = A0 cos al0

    Its left side falls as b_i grows. F_c and F_t are those of `analytic.loads.turning`.
    """
    require_finite(inner_speed=inner_speed)
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    require_given_angle(bearing, contact_angle)
    numbers = record_of(bearing_numbers(bearing, contact_angle))
    load, speed = (np.asarray(each, dtype=np.float64) for each in np.broadcast_arrays(axial_load, inner_speed))
    balls = ball_states(load.size)[:, None]
    correct_balls(balls, factors_of(correction or ContactCorrection()))
    changes = [
        settle_ruled_thrust(numbers, TurningRule(w, *inertia), force, ball)
        for ball, force, w in zip(as_records(balls[:, 0]), load.ravel(), speed.ravel(), strict=True)
    ]
    _require_settled(np.array(changes), load.ravel() / bearing.ball_count)
    return balls.reshape(load.shape)


def thrust_equilibrium_frozen(bearing: Bearing, contact_angle: ContactAngle, *, axial_load: ArrayLike) -> Records:
    """`thrust_equilibrium` at rest with contacts that stay those of the free angle: the text books' cheaper form.

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
    push = np.asarray(axial_load, dtype=np.float64) / bearing.ball_count
    balls, first = ball_states(push.size), first_contacts(numbers)
    as_hertz = CorrectionNumbers(balls[0]["inner_factors"], balls[0]["outer_factors"])
    changes = [
        put_ball(ball, frozen_point(numbers, first, each, as_hertz, LAST_STEP))
        for ball, each in zip(as_records(balls), push.ravel(), strict=True)
    ]
    _require_settled(np.array(changes), push.ravel())
    return balls.reshape(push.shape)


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


def _require_settled(changes: Array, push: Array) -> None:
    """Raise ConvergenceError where a change, (n,), is not 0; push : thrust on each ball, (n,), N"""
    is_open = ~(changes == 0)
    if is_open.any():
        raise unsettled(push[is_open], float(np.max(changes)), SETTLED)


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
