"""Pure thrust: every ball carries the same load at the same contact angle on both races.

Assumes rigid rings apart from the contacts, a slow bearing (no centrifugal force) and no radial load or moment.
Angles are measured from the radial plane; the axial load presses the inner ring along the axis.
Source: T. A. Harris and M. N. Kotzalas, Essential Concepts of Bearing Technology, 5th ed. (2007), section 7.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.optimize.elementwise import bracket_root, find_root

from analytic.contact import Race, race_curvatures
from analytic.correction import ContactCorrection, corrected_contact
from analytic.errors import ConvergenceError, InputError, require_non_negative, require_positive
from analytic.hertz import HertzContact, contact_modulus, hertz_contact
from analytic.scene import Array, Bearing, ContactAngle

# Of ln(tan al): four round-offs of a double, so that the angle is right to about 1e-15 relative.
ROOT_TOLERANCE = 4 * np.finfo(np.float64).eps
# ln(tan al) of every angle that a double can tell from 0 or from pi/2.
LEAST, MOST = -740.0, 700.0
# Bisection alone narrows that range to the tolerance in 61 steps; bracketing and mixed steps take no more than 200.
MOST_STEPS = 200


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
    correction : factors on Hertz's contacts; None leaves them as they are
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
        return _equilibrium(bearing, load, np.full_like(load, np.tan(contact_angle.value)), factors, free_angle=None)
    free = free_angle(bearing) if contact_angle.free is None else contact_angle.free
    if free is None:
        play = bearing.diametral_clearance / 2
    else:
        require_non_negative(free=free)
        if not free < np.pi / 2:
            raise InputError(f"the free contact angle must be below pi/2 rad, got {free!r}; is it in degrees?")
        play = 2 * bearing.groove_centre_distance * np.sin(free / 2) ** 2
    return _equilibrium(bearing, load, _loaded_tangent(bearing, load, play, factors), factors, free_angle=free)


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


def _equilibrium(
    bearing: Bearing, load: Array, tangent: Array, factors: ContactCorrection, *, free_angle: float | None
) -> ThrustEquilibrium:
    ball_load, inner, outer = _contacts(bearing, load, tangent, factors)
    return ThrustEquilibrium(
        free_angle=free_angle, contact_angle=np.arctan(tangent), ball_load=ball_load, inner=inner, outer=outer
    )


def _contacts(
    bearing: Bearing, load: Array, tangent: Array, factors: ContactCorrection
) -> tuple[Array, HertzContact, HertzContact]:
    """Ball load and both contacts at a loaded angle; the tangent keeps angles near 0 and pi/2 exact."""
    ball_load = load * np.hypot(1, tangent) / (bearing.ball_count * tangent)
    inner, outer = _contact(bearing, "inner", ball_load, tangent), _contact(bearing, "outer", ball_load, tangent)
    return ball_load, corrected_contact(inner, factors.inner), corrected_contact(outer, factors.outer)


def _contact(bearing: Bearing, race: Race, ball_load: Array, tangent: Array) -> HertzContact:
    along, across = race_curvatures(bearing, race, contact_angle=np.arctan(tangent))
    groove = bearing.inner if race == "inner" else bearing.outer
    modulus = contact_modulus(bearing.ball_material, groove.material)
    return hertz_contact(curvature_x=along, curvature_y=across, load=ball_load, modulus=modulus)


def _loaded_tangent(bearing: Bearing, load: Array, play: float, factors: ContactCorrection) -> Array:
    """tan al of the equilibrium; play is A0 (1 - cos al0), negative under preload, m."""
    distance = bearing.groove_centre_distance

    def excess(log_tangent: Array, load: Array) -> Array:
        """(A0 + delta) cos al - A0 cos al0, m, without the difference of two large numbers."""
        tangent = np.exp(log_tangent)
        cosine = 1 / np.hypot(1, tangent)
        _, inner, outer = _contacts(bearing, load, tangent, factors)
        return (inner.approach + outer.approach) * cosine + play - distance * (tangent * cosine) ** 2 / (1 + cosine)

    low, high = np.full_like(load, -2.0), np.full_like(load, -1.0)  # bearings have angles of 0.13 to 0.35 rad
    bracket = bracket_root(excess, low, high, args=(load,), xmin=LEAST, xmax=MOST)
    root = find_root(
        excess,
        bracket.bracket,
        args=(load,),
        tolerances={"xrtol": ROOT_TOLERANCE, "xatol": ROOT_TOLERANCE},
        maxiter=MOST_STEPS,
    )
    if not (np.all(bracket.success) and np.all(root.success)):
        raise ConvergenceError(
            iterations=int(np.max(root.nit)),
            residual=float(np.max(np.abs(root.f_x))),
            tolerance=float(ROOT_TOLERANCE),
            unit="m",
            problem="the loaded contact angle",
            remedy="Check the axial load, the clearance and the materials for a slipped unit.",
        )
    return np.exp(root.x)
