"""Micro-slip of one ball on its two races by spin and conformity, in closed form for long contact ellipses.

Micro-slip is Coulomb sliding at every point of a contact that is much longer transverse to rolling than in its
direction. Then only the major axis counts: y follows it from -b to b, with the line load (3 Q/4 b)(1 - y^2/b^2). The
contact surface has the radius R. A ball that rolls with w_roll and spins with w_s slides by
    v(y) = w_roll y^2/(2 R) + w_s y - c
with the c that leaves no net friction force. The model needs sliding that is large compared with the elastic creep of
the surfaces, which `analytic.free_ball` has. A contact of finite length resists spin more: 2 % at b/a = 9, 57 % at a
circle. It also slides across, as rolling turns the ball about the normal of the curved surface: this is left out,
3.8 % of conformity without spin at b/a = 9.3 and 13 % at 4, and less with spin (`analytic.sliding.ellipse`). Rates are
per unit ring speed difference w, so every torque exists at standstill: it is slip power over w.
Source: [Johnson1985] sections 8.5 and 9.2. The moments are derived here. They are those of equations 2 to 7 of [Paper]
with each moment in its right place and a continuous limit.
"""

from typing import Literal, NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import ConvergenceError
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import Finite, NotNegative, Positive, formula
from analytic.oil.traction import PointLaw, eyring_stress, own_stress, thickened
from analytic.scene import SpinRule

LARGEST = float(np.finfo(np.float64).max)
FULL_SPIN = 0.5  # from this |eps| on one pure-rolling line has left the contact and the other is its centre
# Tolerance of the share of spin, and of the moments that it balances: the limit of Newton's quadratic steps.
ROUND_OFF = 4 * float(np.finfo(np.float64).eps)
SPIN_STIFFNESS = 0.9163  # d(M_spin/mu Q b)/d eps at eps = 0, its largest value
HeldSpin = Literal["balanced", "inner_control", "outer_control"]
RULES: dict[SpinRule, int] = {"balanced": 0, "inner_control": 1, "outer_control": 2}
MOST_STEPS = 200  # of a balance of spin; 4 to 8 are usual, and halving the bracket alone takes 60


@compiled
def half_distance(ratio: float) -> float:
    """d, half the distance of the pure-rolling lines in units of b, for eps >= 0; beyond eps = 1/2 its value there."""
    root = np.sqrt(1 - min(ratio, FULL_SPIN) ** 2)
    return 2 * root * np.sin(np.arcsin(1 / (2 * root**3)) / 3)


@compiled
def spin_moment(ratio: float, d: float) -> float:
    """M_spin/(mu Q b) for eps >= 0: 3 eps d (1 - eps^2 - d^2), the factorised bracket of `microslip_moments`.

    d : `half_distance`, as below
    """
    eps = min(ratio, FULL_SPIN)
    return 3 * eps * d * (1 - eps**2 - d**2)


@compiled
def spin_stiffness(ratio: float, d: float) -> float:
    """Derivative of `spin_moment` by eps. It falls from 0.916 to 0 at eps = 1/2; at most round-off is below 0."""
    if ratio >= FULL_SPIN:
        return 0.0
    bracket = 1 - ratio**2 - d**2
    return 3 * d * bracket - 12 * ratio**2 * d**3 / bracket


@compiled
def rolling_moment(ratio: float, d: float) -> float:
    """M_roll R/(mu Q b^2) for eps >= 0: the bracket of `microslip_moments` in eps and d; 0 from eps = 1/2 on."""
    if ratio >= FULL_SPIN:
        return 0.0
    cubes, fifths = 3 * ratio**2 + d**2, 5 * ratio**4 + 10 * ratio**2 * d**2 + d**4
    return max(0.1 - d * cubes / 2 + 0.3 * d * fifths, 0.0)


@compiled
def creep_number(ratio: float, d: float) -> float:
    """c 2 R/(w_roll b^2) of no net force for eps >= 0: -g1 g2; 0 where one line has left the contact."""
    return d**2 - ratio**2 if ratio < FULL_SPIN else 0.0


@compiled
def spin_to_roll(contact: ContactNumbers, spin_rate: float) -> float:
    """eps = (w_s/w_roll)(R/b); of a contact that is a point, the largest number if it spins, and 0 if it does not."""
    if spin_rate == 0.0:
        return 0.0
    ratio = spin_rate * contact.deformed_radius / (contact.rolling_rate * contact.semi_axis_transverse)
    return min(max(ratio, -LARGEST), LARGEST)


class Slip(NamedTuple):
    """What the slip of one contact does, with rates per unit ring speed w."""

    spin_rate: float  # w_s/w
    spin_moment: float  # N m, with the sign of the spin
    rolling_moment: float  # N m
    coefficient: float  # of the Coulomb friction that loses the same power at the same sliding; 0 without load
    slip_speed: float  # m/s, mean weighted by the pressure
    creep: float  # c/w, m


@compiled
def mean_pressure(contact: ContactNumbers) -> float:
    """Q/(pi a b), Pa; 0 where the contact is a point."""
    area = np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse
    return contact.load / area if area > 0.0 else 0.0


@compiled
def line_laws(
    contacts: tuple[ContactNumbers, ContactNumbers], laws: tuple[PointLaw, PointLaw]
) -> tuple[PointLaw, PointLaw]:
    """The laws at the mean pressures, which are all that `line_slip` needs: so the oil thickens but once."""
    return thickened(laws[0], mean_pressure(contacts[0])), thickened(laws[1], mean_pressure(contacts[1]))


@compiled
def line_slip(contact: ContactNumbers, law: PointLaw, ring_speed: float, spin_rate: float) -> tuple[Slip, float]:
    """The slip of a long ellipse with one coefficient, and the slope of its spin moment over w_s/w, N m.

    ring_speed : |w|, rad/s;  spin_rate : w_s/w. The coefficient is that of the law at the mean pressure and at the mean
    sliding speed |w| (M_roll w_roll + M_spin w_s)/(mu Q), whose slope over w_s/w is |w| M_spin/(mu Q).
    """
    eps, b, roll = abs(spin_to_roll(contact, spin_rate)), contact.semi_axis_transverse, contact.rolling_rate
    d = half_distance(eps)
    per_force, curved = b * spin_moment(eps, d), b**2 / contact.deformed_radius * rolling_moment(eps, d)
    speed = ring_speed * (per_force * abs(spin_rate) + curved * roll)
    area, pressure = np.pi * contact.semi_axis_rolling * b, mean_pressure(contact)
    if law.own == 0.0:
        stress, steepness = eyring_stress(law, pressure, speed)
    else:
        stress, steepness = own_stress(law, pressure, speed)
    force = law.boundary * contact.load + area * (stress - law.boundary * pressure)
    slope = area * steepness * ring_speed * per_force**2
    if spin_rate != 0.0:
        slope += force * b * spin_stiffness(eps, d) * eps / abs(spin_rate)
    else:
        slope += force * b * SPIN_STIFFNESS * spin_to_roll(contact, 1.0)
    return (
        Slip(
            spin_rate,
            np.copysign(force * per_force, spin_rate),
            force * curved,
            force / contact.load if contact.load > 0.0 else 0.0,
            speed,
            roll * b**2 / (2 * contact.deformed_radius) * creep_number(eps, d),
        ),
        slope,
    )


@compiled
def balanced_line(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    ring_speed: float,
    spin_difference: float,
) -> tuple[float, float]:
    """Shares of the spin on inner and outer race that make their moments opposite; NaN where they are not found.

    Newton's method in a bracket finds the share of the contact that can carry the larger moment. Only this share can be
    close to 0, and so it keeps its digits. Its moment less the other one grows with the share, from below 0 to above.
    """
    inner, _ = line_slip(contacts[0], laws[0], ring_speed, spin_difference)
    outer, _ = line_slip(contacts[1], laws[1], ring_speed, spin_difference)
    first = 1 if outer.spin_moment > inner.spin_moment else 0
    contact, law, other, other_law = contacts[first], laws[first], contacts[1 - first], laws[1 - first]
    stiff = inner.spin_moment * spin_to_roll(contacts[0], 1.0)
    stiff_other = outer.spin_moment * spin_to_roll(contacts[1], 1.0)
    if first == 1:
        stiff, stiff_other = stiff_other, stiff
    share = stiff_other / (stiff + stiff_other) if stiff + stiff_other > 0.0 else 0.5  # both moments linear in spin
    low, high, last, before = 0.0, 1.0, 1.0, 1.0
    for _ in range(MOST_STEPS):
        slip, slope = line_slip(contact, law, ring_speed, share * spin_difference)
        taken, slope_taken = line_slip(other, other_law, ring_speed, (1 - share) * spin_difference)
        left = slip.spin_moment - taken.spin_moment
        if abs(left) <= ROUND_OFF * slip.spin_moment:
            break
        if left < 0.0:
            low = share
        elif left > 0.0:
            high = share
        else:
            return np.nan, np.nan
        slopes = spin_difference * (slope + slope_taken)  # 0 where both spin in full
        step = -left / slopes if slopes > 0.0 else np.inf
        if not (low <= share + step <= high and abs(step) <= abs(before) / 2):
            step = (low + high) / 2 - share
        share, before, last = share + step, last, step
        if abs(step) <= ROUND_OFF * share:
            break
    return (share, 1 - share) if first == 0 else (1 - share, share)


@compiled
def line_slips(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    ring_speed: float,
    spin_difference: float,
    rule: int,
) -> tuple[Slip, Slip]:
    """The slip of a ball on both races by `line_slip`; rule : by `RULES`, which share of the spin each race takes.

    spin_difference : (w_s,i - w_s,o)/w, >= 0
    """
    share, rest, laws = float(rule - 1), float(2 - rule), line_laws(contacts, laws)
    if rule == 0:
        share, rest = balanced_line(contacts, laws, ring_speed, spin_difference)
    inner, _ = line_slip(contacts[0], laws[0], ring_speed, share * spin_difference)
    outer, _ = line_slip(contacts[1], laws[1], ring_speed, -rest * spin_difference)
    return inner, outer


def no_spin_balance() -> ConvergenceError:
    """Of a ball whose spin moments on both races find no balance."""
    return ConvergenceError(
        iterations=MOST_STEPS,
        residual=float("nan"),
        tolerance=ROUND_OFF,
        unit="of the spin",
        problem="the balance of spin between both races",
        remedy="Check that loads, semi-axes, films and speeds of both contacts are of ordinary size.",
    )


class MicroslipTorque(NamedTuple):
    """Friction torque of one ball about the bearing axis, with its moments and rates."""

    spin: float  # N m
    conformity: float  # N m
    inner_spin_rate: float  # w_s,i/w, >= 0
    outer_spin_rate: float  # w_s,o/w, <= 0
    inner_spin_moment: float  # N m, with the sign of the spin
    outer_spin_moment: float  # N m, with the sign of the spin
    inner_rolling_moment: float  # N m, >= 0
    outer_rolling_moment: float  # N m, >= 0


@formula
def pure_rolling_lines(spin_to_roll: Finite) -> tuple[float, float]:
    """(g1, g2) with g1 <= g2: the points of the major axis without sliding, in units of b.

    spin_to_roll : eps = (w_s/w_roll)(R/b), any finite number
        g1 + g2 = -2 eps,  H(g2) - H(g1) = 2/3 with H(g) = g - g^3/3 (no net force)
    With g = -eps -/+ d this is d^3 - 3(1 - eps^2) d + 1 = 0. With p^2 = 1 - eps^2 its root in the contact is
        d = 2 p sin(arcsin(1/(2 p^3))/3)
    For |eps| >= 1/2 it is d = |eps|: one line stays at the centre, and the other has left the contact.
    """
    eps = abs(spin_to_roll)
    d = half_distance(eps) if eps < FULL_SPIN else eps
    return -spin_to_roll - d, -spin_to_roll + d


@formula
def microslip_moments(
    friction_force: NotNegative, semi_axis_transverse: NotNegative, deformed_radius: Positive, spin_to_roll: Finite
) -> tuple[float, float]:
    """(spin moment, rolling moment) of one contact, N m.

    friction_force : mu Q, N, >= 0;  semi_axis_transverse : b, m, >= 0;  deformed_radius : R, m, > 0
    spin_to_roll : eps = (w_s/w_roll)(R/b), any finite number; the spin moment is odd in it, the rolling moment even
        M_spin = (3/4) mu Q b [g1^2 (1 - g1^2/2) - g2^2 (1 - g2^2/2)]
        M_roll = mu Q b^2/(4 R) [2/5 + g1^3 (1 - 3 g1^2/5) - g2^3 (1 - 3 g2^2/5)]
    with the pure-rolling lines g1, g2. Without spin they are 0 and 0.0806 mu Q b^2/R; for |eps| >= 1/2 they are
    (3/8) mu Q b and 0. The contact loses the power M_spin w_s + M_roll w_roll, whose derivative by w_s is M_spin.
    """
    eps, pull = abs(spin_to_roll), friction_force * semi_axis_transverse
    d = half_distance(eps)
    curved = friction_force * semi_axis_transverse**2 / deformed_radius
    return pull * np.sign(spin_to_roll) * spin_moment(eps, d), curved * rolling_moment(eps, d)


@formula
def microslip_torque(
    contacts: tuple[ContactNumbers, ContactNumbers],
    friction_force: tuple[NotNegative, NotNegative],
    spin_difference: NotNegative,
    spin_rule: HeldSpin,
) -> MicroslipTorque:
    """Torque of one ball from its slip on both races, N m; NaN where the spin finds no balance.

    contacts : on the inner and the outer race, which roll;  friction_force : mu Q on both, N, >= 0
    spin_difference : (w_s,i - w_s,o)/w, >= 0; sin(al) if the contact angles are equal
    spin_rule `balanced`: the ball is free about the contact normal and takes the spin that leaves no moment on it,
        M_spin,i(w_s,i) + M_spin,o(w_s,o) = 0
    This is also the spin of least slip power. `inner_control`, `outer_control`: the named race does not spin.
    The slip power of both contacts over w is the sum of
        spin = M_spin,i w_s,i/w + M_spin,o w_s,o/w,  conformity = M_roll,i w_roll,i/w + M_roll,o w_roll,o/w
    For Z equal balls these are Z |M_spin| sin(al) (equation 10) and Z (M_ri R_o + M_ro R_i)/(2 r) (equation 11).
    """
    law = PointLaw(boundary=1.0)
    pressed = contacts[0]._replace(load=friction_force[0]), contacts[1]._replace(load=friction_force[1])
    inner, outer = line_slips(pressed, (law, law), 0.0, spin_difference, RULES[spin_rule])
    return MicroslipTorque(
        inner.spin_moment * inner.spin_rate + outer.spin_moment * outer.spin_rate,
        inner.rolling_moment * contacts[0].rolling_rate + outer.rolling_moment * contacts[1].rolling_rate,
        inner.spin_rate,
        outer.spin_rate,
        inner.spin_moment,
        outer.spin_moment,
        inner.rolling_moment,
        outer.rolling_moment,
    )
