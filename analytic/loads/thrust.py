"""Pure thrust: every ball carries the same load at the same contact angle, at rest and at speed.

Assumes rigid rings apart from the contacts, and no radial load or moment. At rest, or slow, both races have one load
and one angle. At speed centrifugal force and gyroscopic moment make them differ: what `analytic.loads.ring` solves for
each ball under any load is here, with the same contacts, forces and share of the moment, one equation in one angle.
Angles are measured from the radial plane; the axial load presses the inner ring along the axis.
Source: [Harris2007] section 7 at rest; at speed [Jones1960] and [Harris2007b] section 3: the balance is that of the
forces on the ball.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import HertzContact, loaded_contact
from analytic.errors import ConvergenceError, InputError, require_finite, require_positive
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.race_contacts import unit_contacts
from analytic.loads.turning import PlacedBalls, RuledTurning, Turning
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import Array, Bearing, ContactAngle
from analytic.words import length_of

# ln(tan b) of every angle that a double can tell from 0 or from pi/2; tan b times any force ratio stays a double.
LEAST, MOST = -740.0, 600.0
# Newton's error in ln(tan b) is of the order of its last step's square: below this step it is round-off.
LAST_STEP = 1e-8
# The angles that a round holds change the next ones by less than 1e-3 at rest (curvatures; 3 or 4 rounds), by a tenth
# at most at speed (speeds and friction too; 4 or 5).
MOST_ROUNDS = 300
STEADYING = 30  # rounds, after which forces move halfway: some swing to and fro with the angles
ROUND_OFF = 4 * np.finfo(np.float64).eps


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

    axial_load : Fa, any shape, N, > 0
    correction : factors on Hertz's contacts, each a number or of the shape of axial_load; None leaves them as they are
    `given`: al = contact_angle.value, which is pi/2 in a thrust bearing. `solved`: al from
        Q = Fa/(Z sin al),  (A0 + delta_i(Q, al) + delta_o(Q, al)) cos al = A0 cos al0
    where A0 is the groove-centre distance and cos al0 = 1 - P_d/(2 A0), P_d the diametral clearance; P_d < 0 (preload)
    has no al0 and is solved in the same form. contact_angle.free replaces the al0 of the clearance.
    The left side falls as al grows from 0 to pi/2, so there is one root, bracketed in ln(tan al) at any load.
    Raises InputError for a load that is not positive, an angle outside its range, a clearance of 2 A0 or more,
    or a groove no wider than the ball. Whether the contact stays in the groove is not checked here: race_contact does.
    """
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    load = np.asarray(axial_load, dtype=np.float64)
    factors = correction or ContactCorrection()
    if contact_angle.rule == "given":
        if bearing.kind == "thrust":
            require_right_angle(contact_angle)
        elif contact_angle.value is None or not 0 < contact_angle.value < np.pi / 2:
            raise InputError(f"a given contact angle must lie between 0 and pi/2 rad, got {contact_angle.value!r}")
        angle = np.full_like(load, contact_angle.value)
        contacts = unit_contacts(bearing, inner_angle=angle, outer_angle=angle, correction=factors)
        return _at_rest(_balls(load / bearing.ball_count, np.tan(angle), contacts), free_angle=None)
    thrust = _Thrust(bearing, contact_angle, load)
    return _at_rest(thrust.followed(thrust.frozen(factors), factors), free_angle=thrust.free_angle)


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
    thrust = _Thrust(bearing, contact_angle, np.asarray(axial_load, dtype=np.float64))
    if thrust.free_angle is None:
        raise InputError(
            "the frozen stiffness is that of the free contact angle, which a preload of "
            f"{length_of(-bearing.diametral_clearance, '.6g')} on the diameter does not leave: use thrust_equilibrium, "
            "or give contact_angle.free"
        )
    return _at_rest(thrust.frozen(ContactCorrection()), free_angle=thrust.free_angle)


def thrust_at_speed(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike,
    inner_speed: ArrayLike,
    turning: Turning | None = None,
    near: tuple[Array, Array] | None = None,
    correction: ContactCorrection | None = None,
) -> ThrustAtSpeed:
    """Loads and contact angles of the balls on both races; load and speed broadcast to (n,).

    axial_load : Fa, N, > 0;  inner_speed : w, rad/s, any sign;  contact_angle : rule "solved", as thrust_equilibrium
    turning : what acts on the balls because they turn; None: centrifugal force and gyroscopic moment by closed
        kinematics
    near : contact angles and loads, (2, n), rad and N, that the search begins at; None: those at rest
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
    load, speed = np.broadcast_arrays(np.asarray(axial_load, np.float64), np.asarray(inner_speed, np.float64))
    require_positive(axial_load=load, ball_count=bearing.ball_count)
    factors = (correction or ContactCorrection()).mapped(np.ravel)
    thrust = _Thrust(bearing, contact_angle, load.ravel())
    start = thrust.followed(thrust.frozen(factors), factors) if near is None else thrust.near(*near, factors)
    if turning is None:
        turning = RuledTurning(bearing=bearing, inner_speed=speed.ravel(), centrifugal=True, gyroscopic=True)
    balls = thrust.followed(start, factors, turning=turning)
    inner, outer = (
        loaded_contact(contact, load=of_race).reshape(load.shape)
        for contact, of_race in zip(balls.contacts, balls.load, strict=True)
    )
    return ThrustAtSpeed(
        inner_load=balls.load[0].reshape(load.shape),
        outer_load=balls.load[1].reshape(load.shape),
        inner_angle=balls.angle[0].reshape(load.shape),
        outer_angle=balls.angle[1].reshape(load.shape),
        inner=inner,
        outer=outer,
    )


def require_right_angle(contact_angle: ContactAngle) -> None:
    """Raise InputError unless this is the contact angle of a thrust bearing: given, 90 degrees."""
    if contact_angle.rule != "given" or contact_angle.value != np.pi / 2:
        raise InputError(
            "a thrust bearing has a contact angle of 90 degrees under every load: give "
            f"ContactAngle(rule='given', value=pi/2), got rule {contact_angle.rule!r}, value {contact_angle.value!r}"
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class _Balls:
    """The balls under thrust, and the contacts that they were solved with; an axis of both races is in front."""

    tangent: Array  # (n,) tan b_i
    angle: Array  # (2, n) al, rad
    load: Array  # (2, n) Q, N
    contacts: tuple[HertzContact, HertzContact]  # (n,) under 1 N


class _Thrust:
    """A bearing under thrust by the rule `solved`."""

    def __init__(self, bearing: Bearing, contact_angle: ContactAngle, load: Array) -> None:
        self.bearing, self.push = bearing, load / bearing.ball_count  # Fa/Z, N
        self.play, self.free_angle = play_and_free_angle(bearing, contact_angle)

    def frozen(self, factors: ContactCorrection) -> _Balls:
        """At rest, with the contacts of the free angle, or of the angle 0 where there is no free angle."""
        angle = np.asarray(self.free_angle or 0.0)
        contacts = unit_contacts(self.bearing, inner_angle=angle, outer_angle=angle, correction=factors)
        # The start adds up what opens the angle: the play, the load on a bearing without play (or against its preload),
        # a load that dwarfs A0.
        distance = self.bearing.groove_centre_distance
        approach = (contacts[0].approach + contacts[1].approach) * np.cbrt(self.push) ** 2
        flat = (2 * approach / distance) ** (3 / 8)
        if self.play < 0:
            flat = np.minimum(flat, (approach / -self.play) ** 1.5)
        opened = np.sqrt(2 * max(self.play, 0.0) / distance) + flat + approach / distance
        return self.balanced(contacts, start=opened, outward=np.zeros(()), lean=np.zeros(()))

    def near(self, angle: Array, load: Array, factors: ContactCorrection) -> _Balls:
        """Balls that are nearly at these contact angles, rad, under these loads, N; both (2, n)."""
        contacts = unit_contacts(
            self.bearing, inner_angle=np.abs(angle[0]), outer_angle=np.abs(angle[1]), correction=factors
        )
        return _Balls(tangent=np.tan(np.clip(angle[0], 1e-6, 1.5)), angle=angle, load=load, contacts=contacts)

    def followed(
        self,
        balls: _Balls,
        factors: ContactCorrection,
        *,
        turning: Turning | None = None,
    ) -> _Balls:
        """Rounds from these balls on, until a round changes nothing; each holds contacts and forces of the last angles.

        turning : whose forces a round holds; None at rest
        """
        change = 0.0  # no rate yet
        accuracy = ROUND_OFF if turning is None else max(ROUND_OFF, turning.accuracy)
        held = np.zeros(()), np.zeros(())  # forces of the last round
        for rounds in range(MOST_ROUNDS):
            last, before = balls, change
            # Friction may drive a ball past a right angle before the rounds settle, or fail to.
            within = np.minimum(np.abs(last.angle), np.pi / 2)
            contacts = unit_contacts(self.bearing, inner_angle=within[0], outer_angle=within[1], correction=factors)
            outward, lean = np.zeros(()), np.zeros(())
            if turning is not None:
                forces = turning.forces(_placed(last, contacts))
                friction = np.stack([forces.inner_friction, forces.outer_friction])
                outward, lean = forces.centrifugal / self.push, -np.arctan(friction / last.load)
                if rounds >= STEADYING:
                    outward, lean = (outward + held[0]) / 2, (lean + held[1]) / 2
                held = outward, lean
            balls = self.balanced(contacts, start=last.tangent, outward=outward, lean=lean)
            # Of ln(tan b_i), which rounds where it is large: at a light load on no clearance it is -10.
            logarithm, start = np.log(balls.tangent), np.log(last.tangent)
            steps = np.maximum(
                np.abs(logarithm - start) / (1 + np.abs(start)), np.abs(balls.angle - last.angle).max(axis=0)
            )
            change = float(np.max(steps, initial=0.0))
            # The changes fall at least as a geometric series: the next one, also of the contacts, is below round-off.
            # Balls that turn freely keep the motion of the last round, so that this round must change nothing.
            next_change = change**2 / before if accuracy == ROUND_OFF and before > 0 else change
            if min(change, next_change) <= accuracy:
                return balls
        at_speed = "" if turning is None else " of balls at speed"
        raise ConvergenceError(
            iterations=MOST_ROUNDS,
            residual=change,
            tolerance=float(accuracy),
            unit="of ln(tan al)",
            problem=f"the contact angle{at_speed}, under {np.min(self.push):.4g} N of thrust on each at least,",
            remedy="Raise the load or lower the speed: a race that hardly presses a ball cannot drive it.",
        )

    def balanced(
        self, contacts: tuple[HertzContact, HertzContact], *, start: Array, outward: Array, lean: Array
    ) -> _Balls:
        """The balls with contacts and forces held, by Newton's method in ln(tan b_i), bracketed.

        contacts : under 1 N;  start : of tan b_i;  outward : F_c Z/Fa;  lean : p, rad, () or (2, n)
        Written delta_i cos al_i + delta_o cos al_o + play = L_i (1 - cos al_i) + L_o (1 - cos al_o), L = r_g - r, with
        a preload on the other side, the left side falls and the right side rises. The logarithms of both are nearly
        straight in ln(tan b_i) for loads from nothing to far above A0.
        """
        bearing, start = self.bearing, np.log(np.broadcast_to(start, self.push.shape))
        lengths = np.array([bearing.inner.groove_radius, bearing.outer.groove_radius]) - bearing.ball_radius
        lengths = lengths.reshape(2, *(1,) * start.ndim)
        clearance, preload = max(self.play, 0.0), max(-self.play, 0.0)
        turn, side = np.cos(lean), np.sin(lean)
        units = np.stack([np.broadcast_to(contact.approach, start.shape) for contact in contacts])
        alone = units * np.cbrt(self.push * turn) ** 2  # delta under a load of (Fa/Z) cos p, m

        def rising(logarithm: Array) -> tuple[Array, Array]:
            tangent = np.exp(logarithm)
            relief = 1 / (1 + outward * tangent)  # tan b_o/tan b_i, which is d ln(tan b_o)/d ln(tan b_i) too
            both, rates = np.stack([tangent, tangent * relief]), np.stack([np.ones_like(relief), relief])
            cosine = 1 / np.hypot(1, both)
            sine = both * cosine
            cosine_al, sine_al = cosine * turn + sine * side, sine * turn - cosine * side
            turned = rates * sine * cosine  # d b/d ln(tan b_i)
            approach = alone * np.cbrt(sine) ** -2
            left = np.sum(approach * cosine_al, axis=0) + clearance
            right = np.sum(lengths * sine_al**2 / (1 + cosine_al), axis=0) + preload
            falls = np.sum(approach * (2 / 3 * cosine_al * rates * cosine**2 + sine_al * turned), axis=0)
            rises = np.sum(lengths * sine_al * turned, axis=0)
            return np.log(right / left), falls / left + rises / right

        tangent = np.exp(
            bracketed_root(
                rising,
                start=start,
                low=np.full_like(start, LEAST),
                high=np.full_like(start, MOST),
                relative=0.0,
                absolute=LAST_STEP,
                sought=Sought(
                    unit="of ln(tan al)",
                    problem="the loaded contact angle",
                    remedy="Check the load, the speed, the clearance and the materials for a slipped unit.",
                ),
            )
        )
        return _balls(self.push, tangent, contacts, outward=outward, lean=lean)


def _balls(
    push: Array,
    tangent: Array,
    contacts: tuple[HertzContact, HertzContact],
    *,
    outward: Array | float = 0.0,
    lean: Array | float = 0.0,
) -> _Balls:
    """The balls whose forces balance at b_i.

    push : Fa/Z, N;  tangent : tan b_i;  contacts : under 1 N;  outward : F_c Z/Fa;  lean : p, rad
    """
    both = np.stack([tangent, tangent / (1 + outward * tangent)])  # tan b
    return _Balls(
        tangent=tangent,
        angle=np.arctan(both) - lean,
        load=push * np.cos(lean) * np.hypot(1, both) / both,
        contacts=contacts,
    )


def _placed(balls: _Balls, contacts: tuple[HertzContact, HertzContact]) -> PlacedBalls:
    return PlacedBalls(
        points=np.arange(balls.tangent.size),
        inner_angle=np.clip(balls.angle[0], -np.pi / 2, np.pi / 2),
        outer_angle=np.clip(balls.angle[1], -np.pi / 2, np.pi / 2),
        inner_load=balls.load[0],
        outer_load=balls.load[1],
        inner=contacts[0],
        outer=contacts[1],
    )


def _at_rest(balls: _Balls, *, free_angle: float | None) -> ThrustEquilibrium:
    inner, outer = (loaded_contact(contact, load=balls.load[0]) for contact in balls.contacts)
    return ThrustEquilibrium(
        free_angle=free_angle, contact_angle=balls.angle[0], ball_load=balls.load[0], inner=inner, outer=outer
    )
