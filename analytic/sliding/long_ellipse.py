"""Micro-slip of one ball on its two races by spin and conformity, in closed form for long contact ellipses.

Micro-slip is Coulomb sliding at every point of a contact that is much longer transverse to rolling than in its
direction. Then only the major axis counts: y follows it from -b to b, with the line load (3 Q/4 b)(1 - y^2/b^2). The
contact surface has the radius R. A ball that rolls with w_roll and spins with w_s slides by
    v(y) = w_roll y^2/(2 R) + w_s y - c
with the c that leaves no net friction force. The model needs sliding that is large compared with the elastic creep of
the surfaces (`levers.creep_numbers` well above 5). A contact of finite length resists spin more: 2 % at b/a = 9, 57 %
at a circle. Rates are per unit ring speed difference w, so every torque exists at standstill: it is slip power over w.
Source: [Johnson1985] sections 8.5 and 9.2. The moments are derived here. They are those of equations 2 to 7 of [Paper]
with each moment in its right place and a continuous limit.
"""

from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import Pair, RollingContact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import Array, SpinRule

FULL_SPIN = 0.5  # from this |eps| on one pure-rolling line has left the contact and the other is its centre
# Tolerance of the share of spin, and of the moments that it balances: the limit of Newton's quadratic steps.
ROUND_OFF = 4 * np.finfo(np.float64).eps


@dataclass(frozen=True, kw_only=True, eq=False)
class MicroslipTorque:
    """Friction torque of one ball about the bearing axis, with its moments and rates; arrays of one shape."""

    spin: Array  # N m
    conformity: Array  # N m
    inner_spin_rate: Array  # w_s,i/w, >= 0
    outer_spin_rate: Array  # w_s,o/w, <= 0
    inner_spin_moment: Array  # N m, with the sign of the spin
    outer_spin_moment: Array  # N m, with the sign of the spin
    inner_rolling_moment: Array  # N m, >= 0
    outer_rolling_moment: Array  # N m, >= 0

    @classmethod
    def of(
        cls,
        contacts: Pair,
        *,
        spin_rates: tuple[Array, Array],
        spin_moments: tuple[Array, Array],
        rolling_moments: tuple[Array, Array],
    ) -> "MicroslipTorque":
        """The torque of one ball, slip power over w, from its spin rates w_s/w and its moments on both races."""
        values = np.broadcast_arrays(
            spin_moments[0] * spin_rates[0] + spin_moments[1] * spin_rates[1],
            rolling_moments[0] * contacts[0].rolling_rate + rolling_moments[1] * contacts[1].rolling_rate,
            *spin_rates,
            *spin_moments,
            *rolling_moments,
        )
        return cls(**dict(zip((field.name for field in fields(cls)), values, strict=True)))


def pure_rolling_lines(spin_to_roll: ArrayLike) -> tuple[Array, Array]:
    """(g1, g2) with g1 <= g2: the points of the major axis without sliding, in units of b; shapes of spin_to_roll.

    spin_to_roll : eps = (w_s/w_roll)(R/b), any finite number
        g1 + g2 = -2 eps,  H(g2) - H(g1) = 2/3 with H(g) = g - g^3/3 (no net force)
    With g = -eps -/+ d this is d^3 - 3(1 - eps^2) d + 1 = 0. With p^2 = 1 - eps^2 its root in the contact is
        d = 2 p sin(arcsin(1/(2 p^3))/3)
    For |eps| >= 1/2 it is d = |eps|: one line stays at the centre, and the other has left the contact.
    """
    require_finite(spin_to_roll=spin_to_roll)
    ratio = np.asarray(spin_to_roll, dtype=np.float64)
    distance = np.where(np.abs(ratio) < FULL_SPIN, _half_distance(np.abs(ratio)), np.abs(ratio))
    return -ratio - distance, -ratio + distance


def microslip_moments(
    *,
    friction_force: ArrayLike,
    semi_axis_transverse: ArrayLike,
    deformed_radius: ArrayLike,
    spin_to_roll: ArrayLike,
) -> tuple[Array, Array]:
    """(spin moment, rolling moment) of one contact, N m; the arguments broadcast.

    friction_force : mu Q, N, >= 0;  semi_axis_transverse : b, m, >= 0;  deformed_radius : R, m, > 0
    spin_to_roll : eps = (w_s/w_roll)(R/b), any finite number; the spin moment is odd in it, the rolling moment even
        M_spin = (3/4) mu Q b [g1^2 (1 - g1^2/2) - g2^2 (1 - g2^2/2)]
        M_roll = mu Q b^2/(4 R) [2/5 + g1^3 (1 - 3 g1^2/5) - g2^3 (1 - 3 g2^2/5)]
    with the pure-rolling lines g1, g2. Without spin they are 0 and 0.0806 mu Q b^2/R; for |eps| >= 1/2 they are
    (3/8) mu Q b and 0. The contact loses the power M_spin w_s + M_roll w_roll, whose derivative by w_s is M_spin.
    """
    require_non_negative(friction_force=friction_force, semi_axis_transverse=semi_axis_transverse)
    require_positive(deformed_radius=deformed_radius)
    require_finite(spin_to_roll=spin_to_roll)
    ratio, half_length = np.asarray(spin_to_roll), np.asarray(semi_axis_transverse)
    friction = np.asarray(friction_force)
    spin = friction * half_length * np.sign(ratio) * _spin_moment(np.abs(ratio))
    return spin, friction * half_length**2 / np.asarray(deformed_radius) * _rolling_moment(np.abs(ratio))


def microslip_torque(
    contacts: Pair,
    *,
    friction_force: tuple[ArrayLike, ArrayLike],
    spin_difference: ArrayLike,
    spin_rule: SpinRule,
) -> MicroslipTorque:
    """Torque of one ball from its slip on both races, N m; all fields and arguments broadcast.

    contacts : on the inner and the outer race;  friction_force : mu Q on both, N, >= 0
    spin_difference : (w_s,i - w_s,o)/w, >= 0; sin(al) if the contact angles are equal
    spin_rule `balanced`: the ball is free about the contact normal and takes the spin that leaves no moment on it,
        M_spin,i(w_s,i) + M_spin,o(w_s,o) = 0
    This is also the spin of least slip power. `inner_control`, `outer_control`: the named race does not spin.
    The slip power of both contacts over w is the sum of
        spin = M_spin,i w_s,i/w + M_spin,o w_s,o/w,  conformity = M_roll,i w_roll,i/w + M_roll,o w_roll,o/w
    For Z equal balls these are Z |M_spin| sin(al) (equation 10) and Z (M_ri R_o + M_ro R_i)/(2 r) (equation 11).
    Raises InputError for a negative spin_difference or friction_force, a contact that does not roll, an unknown rule.
    """
    require_non_negative(spin_difference=spin_difference)
    for contact, force in zip(contacts, friction_force, strict=True):
        require_positive(rolling_rate=contact.rolling_rate)
        require_non_negative(friction_force=force)
    difference = np.asarray(spin_difference, dtype=np.float64)
    match spin_rule:
        case "balanced":
            shares = _balanced_shares(contacts, friction_force, difference)
        case "inner_control":
            shares = np.zeros_like(difference), np.ones_like(difference)
        case "outer_control":
            shares = np.ones_like(difference), np.zeros_like(difference)
        case _:
            raise InputError(f'spin_rule must be "balanced", "inner_control" or "outer_control", got {spin_rule!r}')
    rates = shares[0] * difference, -shares[1] * difference
    (inner_spin, inner_roll), (outer_spin, outer_roll) = (
        contact_moments(contact, friction_force=force, spin_rate=rate)
        for contact, force, rate in zip(contacts, friction_force, rates, strict=True)
    )
    return MicroslipTorque.of(
        contacts, spin_rates=rates, spin_moments=(inner_spin, outer_spin), rolling_moments=(inner_roll, outer_roll)
    )


def contact_moments(contact: RollingContact, *, friction_force: ArrayLike, spin_rate: ArrayLike) -> tuple[Array, Array]:
    """(spin moment, rolling moment), N m, of a contact that spins with w_s/w = spin_rate, by microslip_moments."""
    return microslip_moments(
        friction_force=friction_force,
        semi_axis_transverse=contact.semi_axis_transverse,
        deformed_radius=contact.deformed_radius,
        spin_to_roll=spin_to_roll_ratio(contact, spin_rate=spin_rate),
    )


def spin_to_roll_ratio(contact: RollingContact, *, spin_rate: ArrayLike) -> Array:
    """eps = (w_s/w_roll)(R/b) of a contact that spins with w_s/w = spin_rate; fields and spin_rate broadcast.

    For a contact that is a point, eps is the largest number if it spins, and 0 if it does not.
    """
    numerator = np.asarray(spin_rate) * np.asarray(contact.deformed_radius)
    denominator = np.asarray(contact.rolling_rate) * np.asarray(contact.semi_axis_transverse)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        return np.nan_to_num(numerator / denominator, nan=0.0)


def long_ellipse_creep(contact: RollingContact, *, spin_rate: ArrayLike) -> Array:
    """c/w of no net force on a contact that spins with w_s/w = spin_rate, m: -w_roll b^2/(2 R) g1 g2.

    0 for a contact that is a point, and where one line has left the contact.
    """
    eps = np.abs(spin_to_roll_ratio(contact, spin_rate=spin_rate))
    product = np.where(eps < FULL_SPIN, _half_distance(eps) ** 2 - np.minimum(eps, FULL_SPIN) ** 2, 0.0)
    length = np.asarray(contact.semi_axis_transverse)
    return np.asarray(contact.rolling_rate) * length**2 / (2 * np.asarray(contact.deformed_radius)) * product


def _balanced_shares(
    contacts: Pair, friction_force: tuple[ArrayLike, ArrayLike], difference: Array
) -> tuple[Array, Array]:
    """Shares of w_s,i - w_s,o on inner and outer race that make their moments opposite; they add up to 1.

    Newton's method in a bracket finds the share of the contact that can carry the larger moment. Only this share can be
    close to 0, and so it keeps its digits. Its moment less the other one grows with the share, from below 0 to above.
    """
    limit_inner, limit_outer, ratio_inner, ratio_outer = np.broadcast_arrays(
        *(
            np.asarray(force) * np.asarray(contact.semi_axis_transverse)
            for contact, force in zip(contacts, friction_force, strict=True)
        ),
        *(spin_to_roll_ratio(contact, spin_rate=difference) for contact in contacts),
    )
    swap = limit_outer > limit_inner
    limit, limit_other = np.where(swap, limit_outer, limit_inner), np.where(swap, limit_inner, limit_outer)
    ratio, ratio_other = np.where(swap, ratio_outer, ratio_inner), np.where(swap, ratio_inner, ratio_outer)
    stiff, stiff_other = limit * ratio, limit_other * ratio_other
    total = stiff + stiff_other
    share = np.divide(stiff_other, total, out=np.full_like(total, 0.5), where=total > 0)  # both moments linear in spin

    def excess(share: Array) -> tuple[Array, Array]:
        eps, eps_other = ratio * share, ratio_other * (1 - share)
        moment = limit * _spin_moment(eps)
        left = moment - limit_other * _spin_moment(eps_other)
        slope = stiff * _spin_stiffness(eps) + stiff_other * _spin_stiffness(eps_other)  # 0 where both spin in full
        return np.where(np.abs(left) <= ROUND_OFF * moment, 0.0, left), slope

    share = bracketed_root(
        excess,
        start=share,
        low=np.zeros_like(share),
        high=np.ones_like(share),
        relative=ROUND_OFF,
        sought=Sought(
            unit="of the spin",
            problem="the balance of spin between both races",
            remedy="Check that loads, semi-axes and friction coefficients of both contacts are of ordinary size.",
        ),
    )
    return np.where(swap, 1 - share, share), np.where(swap, share, 1 - share)


def _half_distance(ratio: Array) -> Array:
    """d, half the distance of the pure-rolling lines in units of b, for eps >= 0; beyond eps = 1/2 its value there."""
    root = np.sqrt(1 - np.minimum(ratio, FULL_SPIN) ** 2)
    return 2 * root * np.sin(np.arcsin(1 / (2 * root**3)) / 3)


def _spin_moment(ratio: Array) -> Array:
    """M_spin/(mu Q b) for eps >= 0: 3 eps d (1 - eps^2 - d^2), the factorised bracket of `microslip_moments`."""
    eps, d = np.minimum(ratio, FULL_SPIN), _half_distance(ratio)
    return 3 * eps * d * (1 - eps**2 - d**2)


def _spin_stiffness(ratio: Array) -> Array:
    """Derivative of `_spin_moment` by eps. It falls from 0.916 to 0 at eps = 1/2; at most round-off is below 0."""
    eps, d = np.minimum(ratio, FULL_SPIN), _half_distance(ratio)
    bracket = 1 - eps**2 - d**2
    return np.where(ratio < FULL_SPIN, 3 * d * bracket - 12 * eps**2 * d**3 / bracket, 0.0)


def _rolling_moment(ratio: Array) -> Array:
    """M_roll R/(mu Q b^2) for eps >= 0: the bracket of `microslip_moments` in eps and d; 0 from eps = 1/2 on."""
    eps, d = np.minimum(ratio, FULL_SPIN), _half_distance(ratio)
    cubes, fifths = 3 * eps**2 + d**2, 5 * eps**4 + 10 * eps**2 * d**2 + d**4
    return np.where(ratio < FULL_SPIN, np.maximum(0.1 - d * cubes / 2 + 0.3 * d * fifths, 0.0), 0.0)
