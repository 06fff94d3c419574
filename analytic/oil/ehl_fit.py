"""Central film and rolling force fitted to numerical solutions of lubricated contacts, compiled.

The solutions and the command that makes them are in `validation/ehl`; `analytic.oil.ehl_coefficients` has what it
fitted. With Moes's numbers M, L and lambda, U = 2 eta_0 u/(E' R_x), and the length X of the oil ahead of the contact:
    rolling force  f = E' R_x^2 U S ln(1 + (X_e - a)/s),  S = 6 pi/((3 + 2 lambda) sqrt(lambda))
    inlet's length s = R_x U^(1/4) exp(-G(M, L, lambda)),  a: Hertz's semi-axis along rolling
    central film   h = h_formula exp(C(M, L, lambda))
With N = M sqrt(lambda), G and C are polynomials of third degree in ln N, ln L and ln lambda, and of first degree in
ln L and ln lambda over N, which matters for light loads. Far ahead of the contact the bodies are rigid, and the force
grows by S for each e-fold of X; without oil ahead of the contact it is 0. X_e is the reach that gives a paraboloid the
force of a ball in its groove; it depends on the geometry alone.
Outside the range of the solutions, N 6 to 4000, L 2 to 20 and lambda 0.02 to 1, the closed formulas hold. Both are
blended over a factor of 1.5 in each number.
"""

from itertools import product
from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.oil import ehl_coefficients as fitted
from analytic.oil.film import Inflow
from analytic.scene import Array, Bearing

BLEND = float(np.log(1.5))  # over which a number of Moes leaves the range
(LOW_N, HIGH_N), (LOW_L, HIGH_L), (LOW_LAMBDA, HIGH_LAMBDA) = (
    (float(np.log(low)), float(np.log(high))) for low, high in fitted.RANGES.values()
)
MIDDLE_N, MIDDLE_L, MIDDLE_LAMBDA = (float(np.log(each)) for each in fitted.MIDDLE)
# C of `gap_force`, fitted to numerical solutions of both races of seven bearings, with h/R_x of 1e-4 to 3e-2: the error
# is -8 to +12 % at the widest gap, 5 % at a third of it, and 3 % rms (`validation/ehl/wide_gap.py`).
GAP_CONSTANT = 7.5
LEAST_GAP = 1e-4  # over R_x, of these solutions: a narrower gap counts as this one
UNKNOWN_WIDTH = 0.8  # of a groove over the ball's radius, where the scene has no shoulders: a height of 0.2 D
# Of the four numbers in each term of the reach, as `validation/ehl/effective_reach.py` orders them
REACH_POWERS = np.array([powers for powers in product(range(5), repeat=4) if sum(powers) <= 4])
ROLLING, FILM = np.array(fitted.ROLLING), np.array(fitted.FILM)


class OilSupply(NamedTuple):
    """How oil comes to the inlets of a bearing, in numbers. With no degree, no rate and no grease they are flooded."""

    mean_diameter: float  # of the bearing, m, for the inlets' heat
    degree: float  # m of `analytic.oil.starvation`; NaN: not given
    rate: float  # of `rolling.replenishment_rate`; NaN: no ring diameters
    ahead: float  # length of the oil in the inlet of a paraboloid with the same rolling force, m
    behind: float  # likewise in the outlet, m
    tension: float  # that the oil bears in the outlet, Pa; 0: it is ventilated
    churned: bool = False  # grease in a deep groove bearing, where no degree is given: by the films measured there
    surface_tension: float = 1.0  # of the grease's oil, N/m
    axial_share: float = 1.0  # of the load, of the operating point
    grease_film: float = 0.0  # added to ln f of the measured films


class Regime(NamedTuple):
    """Moes's numbers of a contact, as logarithms."""

    loading: float  # ln N
    thickening: float  # ln L
    ellipticity: float  # ln lambda


@compiled
def covered(regime: Regime) -> float:
    """Share of the fit, 0 to 1: 1 within the range of the solutions, 0 beyond a factor of 1.5."""
    n, thick, shape = regime.loading, regime.thickening, regime.ellipticity
    beyond = max(LOW_N - n, n - HIGH_N, LOW_L - thick, thick - HIGH_L, LOW_LAMBDA - shape, shape - HIGH_LAMBDA)
    if not beyond < BLEND:  # also where a number is infinite or none
        return 0.0
    left = 1 - max(beyond, 0.0) / BLEND
    return left * left * (3 - 2 * left)


@compiled
def polynomial(coefficients: Array, regime: Regime) -> float:
    """G or C; coefficients : in the order of `terms` in `validation/ehl/run.py`."""
    n, thick, shape = regime.loading - MIDDLE_N, regime.thickening - MIDDLE_L, regime.ellipticity - MIDDLE_LAMBDA
    total, place, by_n = 0.0, 0, 1.0
    for i in range(4):
        by_thick = by_n
        for j in range(4 - i):
            term = by_thick
            for _ in range(4 - i - j):
                total += coefficients[place] * term
                place += 1
                term *= shape
            by_thick *= thick
        by_n *= n
    light = coefficients[place] + coefficients[place + 1] * thick + coefficients[place + 2] * shape
    return total + light * np.exp(-regime.loading)


@compiled
def regime_of(contact: ContactNumbers, inflow: Inflow) -> Regime:
    """Of a contact; infinite without load, motion or thickening."""
    stiffness, rolling = 2 * contact.modulus, contact.curvature_rolling
    log_speed = np.log(2 * inflow.viscosity * inflow.speed * rolling / stiffness)
    shape = np.log(contact.curvature_transverse / rolling)
    loading = np.log(contact.load * rolling**2 / stiffness) - 0.75 * log_speed + shape / 2
    return Regime(
        loading if log_speed > -np.inf else np.inf,  # not inf - inf without load
        np.log(inflow.pressure_viscosity * stiffness) + log_speed / 4,
        shape,
    )


@compiled
def inlet_length(contact: ContactNumbers, inflow: Inflow, regime: Regime) -> float:
    """s, m; regime : of the contact and the inflow; beyond the range of the solutions it counts as its end."""
    radius = 1 / contact.curvature_rolling
    unit = radius * np.sqrt(np.sqrt(inflow.viscosity * inflow.speed / (contact.modulus * radius)))
    inside = Regime(
        min(max(regime.loading, LOW_N), HIGH_N),
        min(max(regime.thickening, LOW_L), HIGH_L),
        min(max(regime.ellipticity, LOW_LAMBDA), HIGH_LAMBDA),
    )
    return unit * np.exp(-polynomial(ROLLING, inside))


@compiled
def inlet_lengths(ahead: float, semi_axis: float, length: float) -> float:
    """ln(1 + (X - a)/s), the e-folds of oil in an inlet; lengths in one unit, X at least a."""
    return np.log1p((ahead - semi_axis) / length)


@compiled
def fitted_force(contact: ContactNumbers, inflow: Inflow, regime: Regime, supply: OilSupply) -> float:
    """f, N; regime : of the contact and the inflow, within the range.

    The outlet counts where the far field of pressure, mirrored, is above the oil's tension: beyond x with
    x^3 = 48 eta_0 u R_x^2/((3 + 2 lambda) tension).
    """
    radius, ellipticity, a = 1 / contact.curvature_rolling, np.exp(regime.ellipticity), contact.semi_axis_rolling
    shear = inflow.viscosity * inflow.speed
    lengths = inlet_lengths(max(supply.ahead, a), a, inlet_length(contact, inflow, regime))
    if supply.tension > 0.0:
        breaks = 48 * shear * radius**2 / ((3 + 2 * ellipticity) * supply.tension)
        lengths += max(np.log(supply.behind) - np.log(breaks) / 3, 0.0)
    return 12 * np.pi * shear * radius / ((3 + 2 * ellipticity) * np.sqrt(ellipticity)) * lengths


@compiled
def gap_force(shear: float, radius: float, ellipticity: float, gap: float, ahead: float) -> float:
    """f of a ball that rolls a gap off its race, N: rigid bodies, oil of constant viscosity, ventilated outlet.

    shear : eta_0 u, N/m;  radius : R_x, m;  ellipticity : lambda;  gap : h, m;  ahead : X_e, m
        f = (S/2) eta_0 u R_x ln(1 + X_e^2/(C h R_x)),  S = 12 pi/((3 + 2 lambda) sqrt(lambda))
    For a narrow gap it is the far field of a contact, S ln(X_e/sqrt(h R_x)) less a constant; for a wide one it goes as
    the area of the oil over the gap. Left out are the elastic bodies and the heat of the oil.
    """
    lengths = np.log1p(ahead * ahead / (GAP_CONSTANT * max(gap, LEAST_GAP * radius) * radius)) / 2
    return 12 * np.pi * shear * radius / ((3 + 2 * ellipticity) * np.sqrt(ellipticity)) * lengths


@compiled
def gap_of_force(shear: float, radius: float, ellipticity: float, force: float, ahead: float) -> float:
    """h of `gap_force`, m, for a force f > 0, N; the other arguments as there. A gap may be narrower than its least."""
    lengths = force * (3 + 2 * ellipticity) * np.sqrt(ellipticity) / (12 * np.pi * shear * radius)
    return ahead * ahead / (GAP_CONSTANT * radius * np.expm1(2 * lengths))


@compiled
def film_correction(regime: Regime) -> float:
    """C of the film, which fades outside the range."""
    share = covered(regime)
    return share * polynomial(FILM, regime) if share > 0.0 else 0.0


def effective_reach(bearing: Bearing, race: Race, *, reach: float, contact_angle: float) -> float:
    """X_e of a ball on a race, m.

    reach : of the oil from the centre of the contact along rolling, over the ball's radius
    contact_angle : rad, about which the ball lies in the groove
    Rigid bodies, true circles of ball and race, oil between the shoulders; geometry beyond the range of the fit counts
    as its end.
    """
    ball, groove = bearing.ball_diameter / 2, bearing.inner if race == "inner" else bearing.outer
    thrust = bearing.kind == "thrust"  # whose balls touch the bottom of the groove of a flat washer
    curved = 0.0 if thrust else ball / (groove.bottom_radius * (1 if race == "inner" else -1))
    near, far = groove.half_widths
    width = UNKNOWN_WIDTH if near is None or far is None else (near + far) / 2 / ball
    width *= 1.0 if thrust else np.cos(contact_angle)
    point = np.array([curved, 1 - ball / groove.groove_radius, width, reach])
    lower, upper = np.array(fitted.REACH_LOWER), np.array(fitted.REACH_UPPER)
    inside = np.clip(point, lower, upper)
    for each in (lower, upper, inside):
        each[1:3] = np.log(each[1:3])
    scaled = (2 * inside - lower - upper) / (upper - lower)
    terms = np.prod(scaled**REACH_POWERS, axis=1)
    return float(reach * ball * np.exp(terms @ np.array(fitted.REACH)))
