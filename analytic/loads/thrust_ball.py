"""One ball under pure thrust, compiled: `analytic.loads.thrust` says what is solved.

b = al + p is the angle of load and friction together on a race, tan p = -F_t/Q. push is Fa/Z, N.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.factors import CorrectionNumbers, corrected
from analytic.contact.geometry import rolling_curvature
from analytic.contact.hertz import HertzContact, unit_hertz
from analytic.loads.numbers import BearingNumbers
from analytic.loads.race_contacts import put_unit, unit_contact_on
from analytic.loads.turning import TurningRule, ruled_forces
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record
from analytic.numerics.root import cube_root

# ln(tan b) of every angle that a double can tell from 0 or from pi/2; the square of tan b stays a double.
LEAST, MOST = -740.0, 340.0
# Newton's error in ln(tan b) is of the order of its last step's square: below this step it is round-off, and below the
# rough one it is less than what the next round changes.
LAST_STEP, ROUGH_STEP = 1e-8, 1e-3
MOST_STEPS = 200  # 4 to 8 are usual, and bisection alone takes 60
# The angles that a round holds change the next ones by less than 1e-3 at rest (curvatures; 3 or 4 rounds), by a tenth
# at most at speed (speeds and friction too; 4 or 5).
MOST_ROUNDS = 300
STEADYING = 30  # rounds, after which forces move halfway: some swing to and fro with the angles
SETTLED = 2e-13  # of the angles, what the next round would change: a thousand roundings


class ThrustedBall(NamedTuple):
    """A ball whose forces balance."""

    tangent: float  # tan b_i
    inner_angle: float  # al_i, rad
    outer_angle: float  # al_o
    inner_load: float  # Q_i, N
    outer_load: float  # Q_o


class ThrustPoint(NamedTuple):
    """The balls of a bearing under thrust, which are alike, and their contacts."""

    ball: ThrustedBall
    inner: HertzContact  # under 1 N
    outer: HertzContact
    change: float  # that the last round made, of ln(tan b); 0 where the rounds have settled


class Held(NamedTuple):
    """What one search for the angle holds."""

    inner_approach: float  # under 1 N, m
    outer_approach: float
    outward: float  # F_c Z/Fa
    inner_lean: float  # p_i, rad
    outer_lean: float  # p_o


@compiled
def balanced(bearing: BearingNumbers, push: float, held: Held, start: float, last_step: float) -> ThrustedBall:
    """The ball with contacts and forces held, by Newton's method in x = ln(tan b_i), bracketed; NaN if it fails.

    start : of tan b_i;  last_step : of x, the method ends below it
    Written delta_i cos al_i + delta_o cos al_o + play = L_i (1 - cos al_i) + L_o (1 - cos al_o), L = r_g - r, with a
    preload on the other side, the left side falls and the right side rises. The logarithms of both are nearly straight
    in x for loads from nothing to far above A0.
    """
    inner_turn, inner_side = np.cos(held.inner_lean), np.sin(held.inner_lean)
    outer_turn, outer_side = np.cos(held.outer_lean), np.sin(held.outer_lean)
    # delta under a load of (Fa/Z) cos p, m
    inner = held.inner_approach * cube_root(push * inner_turn) ** 2
    outer = held.outer_approach * cube_root(push * outer_turn) ** 2
    clearance, preload = max(bearing.play, 0.0), max(-bearing.play, 0.0)
    inner_length = bearing.inner.groove_radius - bearing.ball_radius
    outer_length = bearing.outer.groove_radius - bearing.ball_radius
    x, low, high = np.log(start), LEAST, MOST
    last = before = high - low
    for _ in range(MOST_STEPS):
        tangent = np.exp(x)
        relief = 1 / (1 + held.outward * tangent)  # tan b_o/tan b_i, which is d ln(tan b_o)/dx too
        of_inner = _distances(tangent, 1.0, (inner_turn, inner_side), inner, inner_length)
        of_outer = _distances(tangent * relief, relief, (outer_turn, outer_side), outer, outer_length)
        left = of_inner.pressed + of_outer.pressed + clearance
        right = of_inner.tilted + of_outer.tilted + preload
        value = np.log(right / left)
        slope = (of_inner.falls + of_outer.falls) / left + (of_inner.rises + of_outer.rises) / right
        if value < 0:
            low = x
        if value > 0:
            high = x
        step = -value / slope
        if not (low <= x + step <= high and abs(step) <= abs(before) / 2):
            step = (low + high) / 2 - x
        before, last = last, 0.0 if value == 0 else step
        x += last
        if abs(last) <= last_step:
            return ball_at(push, np.exp(x), held)
    return ThrustedBall(np.nan, np.nan, np.nan, np.nan, np.nan)


class _Distances(NamedTuple):
    """Radial distances of one race in the balance of `balanced`, m, and their rates in x."""

    pressed: float  # delta cos al
    tilted: float  # L (1 - cos al)
    falls: float  # minus the rate of the first
    rises: float  # rate of the second


@compiled
def _distances(tangent: float, rate: float, lean: tuple[float, float], alone: float, length: float) -> _Distances:
    """tangent : tan b;  rate : d ln(tan b)/dx;  lean : cos p, sin p;  alone : delta at b = pi/2;  length : r_g - r."""
    cosine = 1 / np.sqrt(1 + tangent**2)
    sine = tangent * cosine
    turn, side = lean
    cosine_al, sine_al = cosine * turn + sine * side, sine * turn - cosine * side
    turned = rate * sine * cosine  # db/dx
    approach = alone / cube_root(sine) ** 2
    return _Distances(
        approach * cosine_al,
        length * sine_al**2 / (1 + cosine_al),
        approach * (2 / 3 * cosine_al * rate * cosine**2 + sine_al * turned),
        length * sine_al * turned,
    )


@compiled
def ball_at(push: float, tangent: float, held: Held) -> ThrustedBall:
    """The ball whose forces along the axis and outward balance at tan b_i."""
    outer = tangent / (1 + held.outward * tangent)  # tan b_o
    return ThrustedBall(
        tangent,
        np.arctan(tangent) - held.inner_lean,
        np.arctan(outer) - held.outer_lean,
        push * np.cos(held.inner_lean) * np.sqrt(1 + tangent**2) / tangent,
        push * np.cos(held.outer_lean) * np.sqrt(1 + outer**2) / outer,
    )


@compiled
def in_groove(contact_angle: float) -> float:
    """Friction may drive a ball past a right angle before the rounds settle, or fail to."""
    return min(max(contact_angle, -np.pi / 2), np.pi / 2)


@compiled
def contacts_at(
    bearing: BearingNumbers, inner_angle: float, outer_angle: float, correction: CorrectionNumbers
) -> tuple[HertzContact, HertzContact]:
    """Of both races under 1 N."""
    inner = unit_contact_on(bearing.inner, inner_angle, correction.inner)
    return inner, unit_contact_on(bearing.outer, outer_angle, correction.outer)


@compiled
def first_contacts(bearing: BearingNumbers) -> tuple[HertzContact, HertzContact]:
    """Of both races under 1 N by Hertz, at the given angle, else the free one, and 0 where there is none."""
    angle = bearing.free_angle if np.isnan(bearing.given_angle) else bearing.given_angle
    angle = 0.0 if np.isnan(angle) else angle
    inner, outer = bearing.inner, bearing.outer
    return (
        unit_hertz(rolling_curvature(inner, angle), inner.curvature_transverse, inner.modulus),
        unit_hertz(rolling_curvature(outer, angle), outer.curvature_transverse, outer.modulus),
    )


@compiled
def frozen_point(
    bearing: BearingNumbers,
    first: tuple[HertzContact, HertzContact],
    push: float,
    correction: CorrectionNumbers,
    last_step: float,
) -> ThrustPoint:
    """At rest, with the contacts of the free angle.

    first : `first_contacts`;  last_step : as in `balanced`
    """
    inner, outer = corrected(first[0], correction.inner), corrected(first[1], correction.outer)
    # The start adds up what opens the angle: the play, the load on a bearing without play (or against its preload), a
    # load that dwarfs A0.
    distance, play = bearing.groove_centre_distance, bearing.play
    approach = (inner.approach + outer.approach) * cube_root(push) ** 2
    flat = (2 * approach / distance) ** (3 / 8)
    if play < 0:
        flat = min(flat, (approach / -play) ** 1.5)
    opened = np.sqrt(2 * max(play, 0.0) / distance) + flat + approach / distance
    ball = balanced(bearing, push, Held(inner.approach, outer.approach, 0.0, 0.0, 0.0), opened, last_step)
    return ThrustPoint(ball, inner, outer, 0.0 if ball.tangent > 0 else np.nan)


@compiled
def thrust_point(
    bearing: BearingNumbers,
    first: tuple[HertzContact, HertzContact],
    axial_load: float,
    rule: TurningRule,
    correction: CorrectionNumbers,
) -> ThrustPoint:
    """The balls under thrust, by the bearing's contact angle; at rest where the rule has no speed or no effect.

    first : `first_contacts`;  axial_load : Fa, N, > 0
    A solved angle takes rounds until one changes nothing; each holds contacts and forces of the last angles.
    """
    push = axial_load / bearing.ball_count
    if not np.isnan(bearing.given_angle):
        inner, outer = corrected(first[0], correction.inner), corrected(first[1], correction.outer)
        ball = ball_at(push, np.tan(bearing.given_angle), Held(inner.approach, outer.approach, 0.0, 0.0, 0.0))
        return ThrustPoint(ball, inner, outer, 0.0)
    point = frozen_point(bearing, first, push, correction, ROUGH_STEP)
    last, inner, outer, change = point.ball, point.inner, point.outer, 0.0  # no rate yet
    held = Held(inner.approach, outer.approach, 0.0, 0.0, 0.0)
    for rounds in range(MOST_ROUNDS):
        inner_angle, outer_angle = in_groove(last.inner_angle), in_groove(last.outer_angle)
        inner, outer = contacts_at(bearing, inner_angle, outer_angle, correction)
        forces = ruled_forces(bearing, rule, (inner_angle, outer_angle), (last.inner_load, last.outer_load))
        outward = forces.centrifugal / push
        inner_lean = -np.arctan(forces.inner_friction / last.inner_load)
        outer_lean = -np.arctan(forces.outer_friction / last.outer_load)
        if rounds >= STEADYING:
            outward = (outward + held.outward) / 2
            inner_lean, outer_lean = (inner_lean + held.inner_lean) / 2, (outer_lean + held.outer_lean) / 2
        held = Held(inner.approach, outer.approach, outward, inner_lean, outer_lean)
        ball = balanced(bearing, push, held, last.tangent, ROUGH_STEP)
        before, change = change, change_of(last, ball)
        # The changes fall at least as a geometric series: this is the next one.
        if change <= SETTLED or (before > 0 and change**2 / before <= SETTLED):
            inner, outer = contacts_at(bearing, in_groove(ball.inner_angle), in_groove(ball.outer_angle), correction)
            return ThrustPoint(ball, inner, outer, 0.0)
        last = ball
    return ThrustPoint(last, inner, outer, change)


@compiled
def change_of(last: ThrustedBall, ball: ThrustedBall) -> float:
    """Of the angles, and of ln(tan b_i), which rounds where it is large: at a light load on no clearance it is -10."""
    logarithm, start = np.log(ball.tangent), np.log(last.tangent)
    angles = max(abs(ball.inner_angle - last.inner_angle), abs(ball.outer_angle - last.outer_angle))
    return max(abs(logarithm - start) / (1 + abs(start)), angles)


@compiled
def settle_ruled_thrust(bearing: BearingNumbers, rule: TurningRule, axial_load: float, ball: Record) -> float:
    """Write load, angles and contacts under 1 N of a ball that stands for all; returns the change of `ThrustPoint`.

    axial_load : Fa, N, > 0
    """
    correction = CorrectionNumbers(ball.inner_factors, ball.outer_factors)
    return put_ball(ball, thrust_point(bearing, first_contacts(bearing), axial_load, rule, correction))


@compiled
def put_ball(ball: Record, found: ThrustPoint) -> float:
    """Write load, angles and contacts under 1 N of a ball; returns the change of the last round."""
    ball.load[0], ball.load[1] = found.ball.inner_load, found.ball.outer_load
    ball.angle[0], ball.angle[1] = found.ball.inner_angle, found.ball.outer_angle
    put_unit(ball.inner_unit, found.inner)
    put_unit(ball.outer_unit, found.outer)
    return found.change
