"""Slip of one ball, or of one contact, by the kernel's functions, which a loop calls element by element."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import ContactNumbers
from analytic.oil.traction import PointLaw
from analytic.scene import Array, SpinRule
from analytic.sliding.as_printed import as_printed_slip
from analytic.sliding.ball import slips_over_contacts
from analytic.sliding.ellipse import quadrature_of
from analytic.sliding.long_ellipse import RULES, Slip, line_slips

FINE = (24, 24)  # the most nodes that the kernel slides by


class BallSlip(NamedTuple):
    """Slip on both races, whose fields are arrays of one shape, and what it costs."""

    inner: Any  # Slip of arrays
    outer: Any
    spin: Array  # N m, power over the ring speed
    conformity: Array
    sums: Array  # integrals that both contacts took; 0: none are needed, or they find no c

    @property
    def torque(self) -> Array:
        return self.spin + self.conformity


def ball_slip(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    *,
    ring_speed: ArrayLike,
    spin_difference: ArrayLike,
    spin_rule: SpinRule = "balanced",
    nodes: tuple[int, int] = FINE,
    line: bool = False,
    printed_radius: float | None = None,
) -> BallSlip:
    """Fields of contacts and laws broadcast with ring_speed, |w|, rad/s, and spin_difference, (w_s,i - w_s,o)/w, >= 0.

    line : by one friction coefficient along the axis;  printed_radius : of the ball, m: the moments are those that
        are printed
    """
    given = (*contacts[0], *contacts[1], *laws[0], *laws[1], ring_speed, spin_difference)
    second, end = 18 + len(laws[0]), 18 + 2 * len(laws[0])
    numbers = np.broadcast_arrays(*given)
    fields = np.empty((13, *numbers[0].shape))
    for at in np.ndindex(numbers[0].shape):
        n = [float(number[at]) for number in numbers]
        pair = ContactNumbers(*n[:9]), ContactNumbers(*n[9:18])
        resist = PointLaw(*n[18:second]), PointLaw(*n[second:end])
        speed, difference = n[end:]
        if line:
            slips, sums = line_slips(pair, resist, speed, difference, RULES[spin_rule]), 0
        else:
            *slips, sums = slips_over_contacts(pair, resist, speed, difference, RULES[spin_rule], quadrature_of(nodes))
        if printed_radius is not None:
            slips = [as_printed_slip(one, slip, printed_radius) for one, slip in zip(pair, slips, strict=True)]
        fields[(slice(None), *at)] = (*slips[0], *slips[1], sums)
    inner, outer = Slip(*fields[:6]), Slip(*fields[6:12])
    spin = np.asarray(inner.spin_moment * inner.spin_rate + outer.spin_moment * outer.spin_rate)
    rolls = inner.rolling_moment * contacts[0].rolling_rate + outer.rolling_moment * contacts[1].rolling_rate
    return BallSlip(inner, outer, spin, np.asarray(rolls), fields[12])


def contact_slip(contact: ContactNumbers, law: PointLaw, spin_rate: float, **given: Any) -> Slip:
    """Of one contact that takes this spin, w_s/w, of either sign: one race of a ball whose other race does not spin."""
    rule: SpinRule = "inner_control" if spin_rate < 0 else "outer_control"
    found = ball_slip((contact, contact), (law, law), spin_difference=abs(spin_rate), spin_rule=rule, **given)
    return found.outer if spin_rate < 0 else found.inner
