"""Friction of one ball that rolls and spins between its races, by three methods from cheap to accurate.

- `single_coefficient`: each contact slides with one coefficient, that of its mean pressure and mean sliding speed. Its
  moments are the closed forms of `analytic.sliding.long_ellipse`. The error is 2 to 5 % of the torque by slip of a 6205
  where asperities carry much, and up to 18 % where they carry little and the oil's stress is the same everywhere
  (`validation/benchmarks/friction.py`).
- `along_axis`: the stress follows pressure and sliding from point to point, without the sliding transverse to the
  direction of rolling. The error is 4 to 5 % of the torque by slip of a 6205.
- `over_ellipse`: with sliding in both directions.
Rates are per unit ring speed difference w and torques are slip power over w, as in `analytic.sliding.long_ellipse`. The
law of traction takes the true sliding speeds, which are |w| times as large.
"""

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record
from analytic.oil.traction import PointLaw, with_numbers
from analytic.sliding.ellipse import BALANCED, NO_SUMS, Slider, SlipSums, forceless_slip, slider_of
from analytic.sliding.long_ellipse import Slip, balanced_line, line_laws, line_slip

NEARLY_BALANCED = 1e-7  # net force over all friction while the share of spin is sought; the last search is exact
LAST_STEP = 1e-6  # of the share of spin: the power is least at the balance, so its error is the square of this step
MOST_STEPS = 100  # of the share of spin; 3 to 6 are usual


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
    sideways: bool,
) -> tuple[Slip, Slip, int]:
    """The slip of a ball on both races by integrals; arguments as `long_ellipse.line_slips`, and `ellipse.slip_sums`.

    The last is the number of integrals, 0 where one has no c. Newton's method in a bracket finds the share of the spin
    on the inner race. It begins at that of `long_ellipse.balanced_line`.
    """
    inner, outer = slider_of(contacts[0]), slider_of(contacts[1])
    inner_law, outer_law = at_ring_speed(laws[0], ring_speed), at_ring_speed(laws[1], ring_speed)
    share, rest, lines = float(rule - 1), float(2 - rule), line_laws(contacts, laws)
    if rule == 0:
        share, rest = balanced_line(contacts, lines, ring_speed, spin_difference)
    creep = line_slip(contacts[0], lines[0], ring_speed, share * spin_difference)[0].creep
    other_creep = line_slip(contacts[1], lines[1], ring_speed, rest * spin_difference)[0].creep
    low, high, step, before, count = 0.0, 1.0, 1.0, 1.0, 0
    sums = other = NO_SUMS
    for _ in range(MOST_STEPS):
        nearly = NEARLY_BALANCED if rule == 0 and abs(step) > LAST_STEP else BALANCED
        spin, other_spin = share * spin_difference * inner.transverse, rest * spin_difference * outer.transverse
        creep, sums, number = forceless_slip(inner, inner_law, creep, spin, quadrature, sideways, nearly)
        other_creep, other, more = forceless_slip(
            outer, outer_law, other_creep, other_spin, quadrature, sideways, nearly
        )
        count += number + more
        if number == 0 or more == 0:
            count = 0
            break
        moment, slope = _moment_and_slope(inner, sums)
        other_moment, other_slope = _moment_and_slope(outer, other)
        left = moment - other_moment
        if rule != 0 or abs(step) <= LAST_STEP or left == 0.0:
            break
        if left < 0.0:
            low = share
        else:
            high = share
        slopes = spin_difference * (slope + other_slope)
        last = step
        step = -left / slopes if slopes > 0.0 else np.inf
        if not (low <= share + step <= high and abs(step) <= abs(before) / 2):
            step = (low + high) / 2 - share
        before = last
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
