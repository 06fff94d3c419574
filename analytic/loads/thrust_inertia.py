"""Pure thrust at speed: all balls alike, pushed outward by centrifugal force and turned by the gyroscopic moment.

What `analytic.loads.ring` solves for each ball under any load, with the same contacts, forces and share of the moment, is for
balls that are alike one equation in one angle. Angles are measured from the radial plane.
Source: A. B. Jones, J. Basic Eng. 82 (1960) 309-320, and T. A. Harris and M. N. Kotzalas, Advanced Concepts of Bearing
Technology, 5th ed. (2007), section 3 (neither seen: the balance is that of the forces on the ball).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import HertzContact, loaded_contact
from analytic.errors import ConvergenceError, require_finite
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.thrust import play_and_free_angle, thrust_equilibrium, unit_contacts
from analytic.numerics.root import bracketed_root
from analytic.scene import Array, Bearing, ContactAngle

# The angles that a round holds for curvatures, speeds and friction change the next ones by a tenth at most; 4 or 5.
MOST_ROUNDS = 50
ROUND_OFF = 4 * np.finfo(np.float64).eps
# Newton's error in ln(tan b) is of the order of its last step's square: below this step it is round-off.
LAST_STEP = 1e-8
WIDEST = 300.0  # of ln(tan b): angles from 1e-130 to what no double can tell from pi/2


@dataclass(frozen=True, kw_only=True, eq=False)
class ThrustAtSpeed:
    """Every ball of a bearing under thrust; arrays have the shape (n,) of load and speed."""

    inner_load: Array  # Q_i, N
    outer_load: Array  # Q_o, N
    inner_angle: Array  # al_i, rad
    outer_angle: Array  # al_o, rad, below al_i
    inner: HertzContact
    outer: HertzContact


def thrust_at_speed(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    inner_speed: ArrayLike,
    centrifugal: bool = True,
    gyroscopic: bool = True,
    correction: ContactCorrection | None = None,
) -> ThrustAtSpeed:
    """Loads and contact angles of the balls on both races; load and speed broadcast to (n,).

    axial_load : Fa, N, > 0;  inner_speed : w, rad/s, any sign;  contact_angle : rule "solved", as thrust_equilibrium
    correction : factors on Hertz's contacts, each a number or (n,); None leaves them as they are
    On each race friction across the groove is mu = M_g/(r (Q_i + Q_o)) times the load, so that what presses there acts
    at the angle b = al + p, tan p = mu, as Q/cos p. Along the axis and outward the ball is at rest where
        Q_i sin b_i = Q_o sin b_o = (Fa/Z) cos p,  cot b_o = cot b_i + F_c Z/Fa
    and the grooves' centres keep the radial distance of concentric rings,
        (r_gi - r + delta_i) cos al_i + (r_go - r + delta_o) cos al_o = A0 cos al0
    Its left side falls as b_i grows. F_c and M_g are those of analytic.loads.ring.
    Raises InputError as thrust_equilibrium does, ConvergenceError where the gyroscopic moment asks for friction that no
    balance has.
    """
    require_finite(inner_speed=inner_speed)
    load, speed = np.broadcast_arrays(np.asarray(axial_load, np.float64), np.asarray(inner_speed, np.float64))
    factors = correction or ContactCorrection()
    start = thrust_equilibrium(bearing, contact_angle, axial_load=load, correction=correction)
    play, _ = play_and_free_angle(bearing, contact_angle)
    push = load / bearing.ball_count
    angle = np.stack([start.contact_angle, start.contact_angle])
    normal = np.stack([start.ball_load, start.ball_load])
    logarithm, change = np.log(np.tan(start.contact_angle)), 0.0  # no rate yet
    for _ in range(MOST_ROUNDS):
        inner, outer = unit_contacts(
            bearing, inner_angle=np.abs(angle[0]), outer_angle=np.abs(angle[1]), correction=factors
        )
        motion = ball_kinematics(
            inner_speed=speed,
            inner_angle=angle[0],
            outer_angle=angle[1],
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball_diameter,
        )
        outward = centrifugal * bearing.ball_mass * bearing.pitch_diameter / 2 * motion.cage_speed**2 / push
        friction = gyroscopic * np.abs(_gyroscopic_moment(bearing, motion, angle.mean(axis=0)))
        leaned = np.arctan(friction / (bearing.ball_radius * normal.sum(axis=0)))  # p
        before, last = change, logarithm
        logarithm = _balanced(
            bearing,
            alone=np.stack([inner.approach, outer.approach]) * np.cbrt(push * np.cos(leaned)) ** 2,
            outward=outward,
            leaned=leaned,
            play=play,
            start=last,
        )
        tangent = np.exp(logarithm)
        leaning = np.stack([tangent, tangent / (1 + outward * tangent)])  # tan b
        held, angle = angle, np.arctan(leaning) - leaned
        normal = push * np.cos(leaned) * np.hypot(1, leaning) / leaning
        change = np.maximum(np.abs(logarithm - last) / (1 + np.abs(last)), np.abs(angle - held).max(axis=0))
        change = float(np.max(change, initial=0.0))
        # The changes fall at least as a geometric series: the next would be below round-off.
        if change <= ROUND_OFF or change**2 <= ROUND_OFF * before:
            return ThrustAtSpeed(
                inner_load=normal[0],
                outer_load=normal[1],
                inner_angle=angle[0],
                outer_angle=angle[1],
                inner=loaded_contact(inner, load=normal[0]),
                outer=loaded_contact(outer, load=normal[1]),
            )
    raise ConvergenceError(
        iterations=MOST_ROUNDS,
        residual=change,
        tolerance=float(ROUND_OFF),
        unit="of ln(tan al)",
        problem="the contact angle of balls at speed",
        remedy="Raise the load or lower the speed; check speed and ball mass for a slipped unit.",
    )


def _gyroscopic_moment(bearing: Bearing, motion: BallKinematics, pitch: Array) -> Array:
    """M_g = (m D^2/10) w_b w_m sin(pitch), N m."""
    return bearing.ball_mass * bearing.ball_diameter**2 / 10 * motion.ball_speed * motion.cage_speed * np.sin(pitch)


def _balanced(bearing: Bearing, *, alone: Array, outward: Array, leaned: Array, play: float, start: Array) -> Array:
    """ln(tan b_i), (n,), with contacts, forces and friction held.

    alone : (2, n) delta under a load of (Fa/Z) cos p, m;  outward : F_c Z/Fa;  leaned : p, rad;  start : a guess
    Written delta_i cos al_i + delta_o cos al_o + play = L_i (1 - cos al_i) + L_o (1 - cos al_o), L = r_g - r, with a
    preload on the other side, the logarithms of both sides are nearly straight in ln(tan b_i).
    """
    lengths = np.array([bearing.inner.groove_radius, bearing.outer.groove_radius]) - bearing.ball_radius
    lengths = lengths.reshape(2, *(1,) * start.ndim)
    slack, preload = max(play, 0.0), max(-play, 0.0)
    turn, across = np.cos(leaned), np.sin(leaned)

    def rising(logarithm: Array) -> tuple[Array, Array]:
        tangent = np.exp(logarithm)
        relief = 1 / (1 + outward * tangent)  # tan b_o/tan b_i, which is d ln(tan b_o)/d ln(tan b_i) too
        both, rates = np.stack([tangent, tangent * relief]), np.stack([np.ones_like(relief), relief])
        cosine = 1 / np.hypot(1, both)
        sine = both * cosine
        along, aside = cosine * turn + sine * across, sine * turn - cosine * across  # cos and sin of al
        turned = rates * sine * cosine  # d b/d ln(tan b_i)
        approach = alone * np.cbrt(sine) ** -2
        left = np.sum(approach * along, axis=0) + slack
        right = np.sum(lengths * aside**2 / (1 + along), axis=0) + preload
        falls = np.sum(approach * (2 / 3 * along * rates * cosine**2 + aside * turned), axis=0)
        rises = np.sum(lengths * aside * turned, axis=0)
        return np.log(right / left), falls / left + rises / right

    return bracketed_root(
        rising,
        start=start,
        low=np.full_like(start, -WIDEST),
        high=np.full_like(start, WIDEST),
        relative=0.0,
        absolute=LAST_STEP,
        unit="of ln(tan al)",
        problem="the contact angle of balls at speed",
        remedy="Check the load, the speed and the clearance for a slipped unit.",
    )
