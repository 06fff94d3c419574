"""Friction of one ball that rolls and spins between its races by closed kinematics, integrated over both ellipses.

The stress follows pressure and sliding from point to point, and both directions of sliding. Rates are per unit ring
speed difference w and torques are slip power over w, as in `analytic.sliding.long_ellipse`. The law of traction takes
the true sliding speeds, which are |w| times as large.

Nodes: each level of LEVELS has twice those of the one before in each direction. A first level follows from the
tolerance (`analytic.solve.model.first_level`), and `missed_power` gives the error of a level by doubling.
"""

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record, Records
from analytic.oil.traction import PointLaw, with_numbers
from analytic.sliding.ellipse import (
    BALANCED,
    LEAST_GAIN,
    NO_SUMS,
    Slider,
    SlipSums,
    forceless_slip,
    quadrature_of,
    slider_of,
    slip_sums,
)
from analytic.sliding.long_ellipse import Slip, balanced_line, line_laws, line_slip

NEARLY_BALANCED = 1e-5  # net force over all friction while the share of spin is sought; the last search is exact
LAST_STEP = 1e-5  # of the share of spin: the power is least at the balance, so its error is the square of this step
MOST_STEPS = 100  # of the share of spin; 3 to 6 are usual
LEVELS = ((4, 4), (8, 8), (16, 16), (32, 32))  # nodes across a panel and along rolling
# Of each level: its own nodes, and those with twice as many across and along.
NODES = np.stack([quadrature_of(each) for n, m in LEVELS for each in ((n, m), (2 * n, m), (n, 2 * m))])


@compiled
def at_ring_speed(law: PointLaw, ring_speed: float) -> PointLaw:
    """The law over slip per unit ring speed; ring_speed : |w|, rad/s. At standstill it is that of slow sliding."""
    fluidity = law.fluidity if law.fluidity == np.inf else law.fluidity * ring_speed
    return with_numbers(law, law.boundary, fluidity)


@compiled
def _moment_and_slope(slider: Slider, sums: SlipSums) -> tuple[float, float]:
    """|M_spin|, N m, and its slope over |w_s|, N m s, along the c of no net force."""
    follows = sums.mixed**2 / sums.by_creep if sums.by_creep > 0.0 else 0.0
    return slider.transverse * sums.spin, slider.transverse**2 * max(sums.by_spin - follows, 0.0)


@compiled
def slips_over_contacts(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    ring_speed: float,
    spin_difference: float,
    rule: int,
    quadrature: Record,
) -> tuple[Slip, Slip, int]:
    """The slip of a ball on both races by integrals; arguments as `long_ellipse.line_slips`, and `ellipse.slip_sums`.

    The last is the number of integrals, 0 where one has no c. Secants in a bracket find the share of the spin on
    the inner race. It begins at that of `long_ellipse.balanced_line`.
    """
    inner, outer = slider_of(contacts[0]), slider_of(contacts[1])
    inner_law, outer_law = at_ring_speed(laws[0], ring_speed), at_ring_speed(laws[1], ring_speed)
    share, rest, lines = float(rule - 1), float(2 - rule), line_laws(contacts, laws)
    if rule == 0:
        share, rest = balanced_line(contacts, lines, ring_speed, spin_difference)
    creep = line_slip(contacts[0], lines[0], ring_speed, share * spin_difference)[0].creep
    other_creep = line_slip(contacts[1], lines[1], ring_speed, rest * spin_difference)[0].creep
    low, high, step, count = 0.0, 1.0, 1.0, 0
    older, older_left, halved, shares = np.nan, np.inf, False, rule == 0 and spin_difference > 0.0
    sums = other = NO_SUMS
    for _ in range(MOST_STEPS):
        nearly = NEARLY_BALANCED if shares and abs(step) > LAST_STEP else BALANCED
        spin, other_spin = share * spin_difference * inner.transverse, rest * spin_difference * outer.transverse
        creep, sums, number = forceless_slip(inner, inner_law, creep, spin, quadrature, nearly)
        other_creep, other, more = forceless_slip(outer, outer_law, other_creep, other_spin, quadrature, nearly)
        count += number + more
        if number == 0 or more == 0:
            count = 0
            break
        moment, slope = _moment_and_slope(inner, sums)
        other_moment, other_slope = _moment_and_slope(outer, other)
        left = moment - other_moment
        if not shares or abs(step) <= LAST_STEP or left == 0.0:
            break
        if left < 0.0:
            low = share
        else:
            high = share
        slopes = spin_difference * (slope + other_slope)
        if not np.isnan(older) and share != older:
            slopes = (left - older_left) / (share - older)
        stalls = abs(left) > LEAST_GAIN * abs(older_left)
        older, older_left = share, left
        step = -left / slopes if slopes > 0.0 else np.inf
        halved = (stalls and not halved) or not low <= share + step <= high
        if halved:
            step = (low + high) / 2 - share
        if sums.by_creep > 0.0:
            creep += sums.mixed / sums.by_creep * step * spin_difference * inner.transverse
        if other.by_creep > 0.0:
            other_creep -= other.mixed / other.by_creep * step * spin_difference * outer.transverse
        share, rest = share + step, rest - step
    return (
        _slip(contacts[0], inner, sums, share * spin_difference, ring_speed, creep),
        _slip(contacts[1], outer, other, -rest * spin_difference, ring_speed, other_creep),
        count,
    )


@compiled
def _slip(
    contact: ContactNumbers, slider: Slider, sums: SlipSums, rate: float, ring_speed: float, creep: float
) -> Slip:
    return Slip(
        rate,
        np.sign(rate) * slider.transverse * sums.spin,
        sums.rolling * slider.transverse**2 / (2 * contact.deformed_radius),
        sums.power / sums.unit if sums.unit > 0.0 else 0.0,
        ring_speed * sums.unit / contact.load if contact.load > 0.0 else 0.0,
        creep if contact.load > 0.0 else 0.0,
    )


@compiled
def missed_power(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    slips: tuple[Slip, Slip],
    ring_speed: float,
    nodes: Records,
    level: int,
) -> float:
    """Estimate of what a level of nodes misses of a ball's power over the ring speed, N m: twice what doubling changes.

    contacts, laws, slips : on inner and outer race, as `slips_over_contacts` found them;  nodes : NODES
    Nodes across and along are doubled apart, so that their errors do not cancel, at the slip of the level: its error
    counts in second order, as the power is least at the balance.
    """
    missed = 0.0
    for race in range(2):
        slip, law, slider = slips[race], at_ring_speed(laws[race], ring_speed), slider_of(contacts[race])
        spin = abs(slip.spin_rate) * slider.transverse
        own = slip_sums(slider, law, slip.creep, spin, nodes[3 * level]).power
        for doubled in (1, 2):
            missed += 2.0 * abs(slip_sums(slider, law, slip.creep, spin, nodes[3 * level + doubled]).power - own)
    return missed
