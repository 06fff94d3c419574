"""Pure thrust: every ball carries the same load at the same contact angle on both races.

Assumes rigid rings apart from the contacts, a slow bearing (no centrifugal force) and no radial load or moment.
Angles are measured from the radial plane; the axial load presses the inner ring along the axis.
Source: T. A. Harris and M. N. Kotzalas, Essential Concepts of Bearing Technology, 5th ed. (2007), section 7.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection, corrected_contact
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, loaded_contact
from analytic.errors import ConvergenceError, InputError, require_non_negative, require_positive
from analytic.scene import Array, Bearing, ContactAngle

# ln(tan al) of every angle that a double can tell from 0 or from pi/2.
LEAST, MOST = -740.0, 700.0
# Newton's error in ln(tan al) is of the order of its last step's square: below this step it is round-off.
LAST_STEP = 1e-8
# Newton takes 4 to 8 steps; halving that range down to the last step takes 37, and mixed steps no more than the sum.
MOST_STEPS = 200
# A curvature that follows the angle changes the next angle by less than 1e-3 of the change before; 3 or 4 rounds.
MOST_ROUNDS = 50
ROUND_OFF = 4 * np.finfo(np.float64).eps


@dataclass(frozen=True, kw_only=True, eq=False)
class ThrustEquilibrium:
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
    `given`: al = contact_angle.value. `solved`: al from
        Q = Fa/(Z sin al),  (A0 + delta_i(Q, al) + delta_o(Q, al)) cos al = A0 cos al0
    where A0 is the groove-centre distance and cos al0 = 1 - P_d/(2 A0), P_d the diametral clearance; P_d < 0 (preload)
    has no al0 and is solved in the same form. contact_angle.free replaces the al0 of the clearance.
    The left side falls as al grows from 0 to pi/2, so there is one root, bracketed in ln(tan al) at any load.
    Raises InputError for a load that is not positive, an angle outside its range, a clearance of 2 A0 or more,
    or a groove no wider than the ball. It does not ask whether the contact stays in the groove: race_contact does.
    """
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    load = np.asarray(axial_load, dtype=np.float64)
    factors = correction or ContactCorrection()
    if contact_angle.rule == "given":
        if contact_angle.value is None or not 0 < contact_angle.value < np.pi / 2:
            raise InputError(f"a given contact angle must lie between 0 and pi/2 rad, got {contact_angle.value!r}")
        tangent = np.full_like(load, np.tan(contact_angle.value))
        return _equilibrium(bearing, load, tangent, _units(bearing, tangent, factors), free_angle=None)
    play, free = play_and_free_angle(bearing, contact_angle)
    units = _units(bearing, np.asarray(np.tan(free or 0.0)), factors)
    tangent = _loaded_tangent(bearing, load, play=play, units=units)
    before = 0.0  # no rate yet
    for _ in range(MOST_ROUNDS):
        units, last = _units(bearing, tangent, factors), tangent
        tangent = _loaded_tangent(bearing, load, play=play, units=units, start=last)
        # Of ln(tan al), which rounds where it is large: at a light load on no clearance it is -10.
        change = float(np.max(np.abs(np.log(tangent / last)) / (1 + np.abs(np.log(last))), initial=0.0))
        # The changes fall at least as a geometric series: the next would be below round-off, that of the contacts too.
        if change <= ROUND_OFF or change**2 <= ROUND_OFF * before:
            return _equilibrium(bearing, load, tangent, units, free_angle=free)
        before = change
    raise _not_settled(MOST_ROUNDS, before)


def thrust_equilibrium_frozen(
    bearing: Bearing, contact_angle: ContactAngle, *, axial_load: ArrayLike
) -> ThrustEquilibrium:
    """Loaded contact angle with contacts that stay those of the free angle: the text books' cheaper form.

    axial_load : Fa, any shape, N, > 0
    al from  A0 (cos al0/cos al - 1) = delta,  Fa/(Z sin al) = K delta^1.5,  K^(-2/3) = K_i^(-2/3) + K_o^(-2/3)
    with K_i and K_o at al0, where thrust_equilibrium lets the curvatures along rolling follow al.
    al of a 6205 from 0.18 rad: 1.7e-5 too large (relative) under 1000 N, less under less.
    Source: Harris and Kotzalas, section 7, there with K from charts; the printed form not seen.
    Raises InputError as thrust_equilibrium does, and for the rule `given` and a preload, which leave no free angle.
    """
    require_positive(axial_load=axial_load, ball_count=bearing.ball_count)
    load = np.asarray(axial_load, dtype=np.float64)
    if contact_angle.rule == "given":
        raise InputError(
            "the frozen stiffness solves for the loaded contact angle, which the rule 'given' gives: "
            "use thrust_equilibrium, or the rule 'solved'"
        )
    play, free = play_and_free_angle(bearing, contact_angle)
    if free is None:
        raise InputError(
            "the frozen stiffness is that of the free contact angle, which a preload of "
            f"{-bearing.diametral_clearance:.6g} m on the diameter does not leave: use thrust_equilibrium, "
            "or give contact_angle.free"
        )
    units = _units(bearing, np.asarray(np.tan(free)), ContactCorrection())
    tangent = _loaded_tangent(bearing, load, play=play, units=units)
    return _equilibrium(bearing, load, tangent, units, free_angle=free)


def free_angle(bearing: Bearing) -> float | None:
    """al0, rad: the contact angle at which play ends and load begins; None for a preloaded bearing.

    cos al0 = 1 - P_d/(2 A0), written 2 sin^2(al0/2) = P_d/(2 A0) to stay exact at small clearance.
    Raises InputError if a groove is no wider than the ball, or if P_d >= 2 A0 (nothing stops the rings).
    """
    for race in ("inner", "outer"):
        race_curvatures(bearing, race, contact_angle=0.0)  # refuses an impossible groove
    clearance, distance = bearing.diametral_clearance, bearing.groove_centre_distance
    if clearance < 0:
        return None
    if not clearance < 2 * distance:
        raise InputError(
            f"diametral clearance {clearance:.6g} m must be below 2 A0 = {2 * distance:.6g} m (A0 = r_gi + r_go - D): "
            "check bottom_radius of both rings and ball_diameter"
        )
    return float(2 * np.arcsin(np.sqrt(clearance / (4 * distance))))


def play_and_free_angle(bearing: Bearing, contact_angle: ContactAngle) -> tuple[float, float | None]:
    """(A0 (1 - cos al0), al0) in m and rad: from contact_angle.free, or else from the clearance.

    A preload has no al0 and a play of P_d/2 < 0. Raises InputError as free_angle does, and for an angle out of range.
    """
    free = contact_angle.free
    if free is None:
        return bearing.diametral_clearance / 2, free_angle(bearing)
    require_non_negative(free=free)
    if not free < np.pi / 2:
        raise InputError(f"the free contact angle must be below pi/2 rad, got {free!r}; is it in degrees?")
    return float(2 * bearing.groove_centre_distance * np.sin(free / 2) ** 2), free


def unit_contacts(
    bearing: Bearing, *, inner_angle: ArrayLike, outer_angle: ArrayLike, correction: ContactCorrection
) -> tuple[HertzContact, HertzContact]:
    """A ball on its inner and on its outer race under 1 N by Hertz, corrected; of the angles' shape, which is one.

    inner_angle, outer_angle : al_i, al_o, rad, in [0, pi/2]
    analytic.contact.hertz.loaded_contact makes of them contacts under load. Raises InputError as race_curvatures does.
    """
    pairs = (
        race_curvatures(bearing, "inner", contact_angle=inner_angle),
        race_curvatures(bearing, "outer", contact_angle=outer_angle),
    )
    along, across = (np.array(curvatures) for curvatures in zip(*pairs, strict=True))
    moduli = [contact_modulus(bearing.ball_material, ring.material) for ring in (bearing.inner, bearing.outer)]
    # One call for both races: most callers have few balls, and pay by the call.
    both = hertz_contact(
        curvature_x=along, curvature_y=across, load=1.0, modulus=np.reshape(moduli, (2,) + (1,) * (along.ndim - 1))
    )
    inner, outer = (HertzContact(**{name: field[race] for name, field in vars(both).items()}) for race in (0, 1))
    return corrected_contact(inner, correction.inner), corrected_contact(outer, correction.outer)


def _equilibrium(
    bearing: Bearing, load: Array, tangent: Array, units: tuple[HertzContact, HertzContact], *, free_angle: float | None
) -> ThrustEquilibrium:
    ball_load = _ball_load(bearing, load, tangent)
    inner, outer = (loaded_contact(unit, load=ball_load) for unit in units)
    return ThrustEquilibrium(
        free_angle=free_angle, contact_angle=np.arctan(tangent), ball_load=ball_load, inner=inner, outer=outer
    )


def _units(bearing: Bearing, tangent: Array, factors: ContactCorrection) -> tuple[HertzContact, HertzContact]:
    angle = np.arctan(tangent)
    return unit_contacts(bearing, inner_angle=angle, outer_angle=angle, correction=factors)


def _ball_load(bearing: Bearing, load: Array, tangent: Array) -> Array:
    """Q = Fa/(Z sin al), N."""
    return load * np.hypot(1, tangent) / (bearing.ball_count * tangent)


def _loaded_tangent(
    bearing: Bearing,
    load: Array,
    *,
    play: float,
    units: tuple[HertzContact, HertzContact],
    start: Array | None = None,
) -> Array:
    """tan al of the equilibrium, of the load's shape, by Newton in ln(tan al) kept in a bracket.

    play : A0 (1 - cos al0), negative under preload, m
    units : both contacts under 1 N, held: delta_i + delta_o = Q^(2/3) of theirs
    Written delta cos al + play = A0 (1 - cos al), with a preload on the other side: ln of the left falls, ln of the
    right rises with ln(tan al), both nearly straight for loads from nothing to far above A0. Without a start what opens
    the angle is added up: the play, the load on a bearing without play (or against its preload), a load that dwarfs A0.
    """
    distance, play, preload = bearing.groove_centre_distance, max(play, 0.0), max(-play, 0.0)
    alone = (units[0].approach + units[1].approach) * np.cbrt(load / bearing.ball_count) ** 2  # delta of Q = Fa/Z, m
    if start is None:
        flat = (2 * alone / distance) ** (3 / 8)
        flat = np.minimum(flat, (alone / preload) ** 1.5) if preload else flat
        logarithm = np.log(np.sqrt(2 * play / distance) + flat + alone / distance)
    else:
        logarithm = np.log(start)
    largest = np.inf
    low, high = np.full_like(logarithm, LEAST), np.full_like(logarithm, MOST)
    for _ in range(MOST_STEPS):
        tangent = np.exp(logarithm)
        secant = np.hypot(1, tangent)
        cosine, sine = 1 / secant, tangent / secant
        closing = alone * np.cbrt(sine) ** -2 * cosine  # delta cos al
        opening = distance * sine**2 / (1 + cosine)  # A0 (1 - cos al), without the difference of two large numbers
        left, right = closing + play, opening + preload
        slope = closing * (2 / 3 * cosine**2 + sine**2) / left + distance * sine**2 * cosine / right
        step = np.log(left / right) / slope
        low, high = np.where(step > 0, logarithm, low), np.where(step < 0, logarithm, high)
        newton = (logarithm + step >= low) & (logarithm + step <= high)
        step = np.where(newton, step, (low + high) / 2 - logarithm)
        logarithm = logarithm + step
        largest = float(np.max(np.abs(step), initial=0.0))
        if largest <= LAST_STEP:
            return np.exp(logarithm)
    raise _not_settled(MOST_STEPS, largest)


def _not_settled(iterations: int, residual: float) -> ConvergenceError:
    return ConvergenceError(
        iterations=iterations,
        residual=residual,
        tolerance=LAST_STEP,
        unit="of ln(tan al)",
        problem="the loaded contact angle",
        remedy="Check the axial load, the clearance and the materials for a slipped unit.",
    )
