"""A starved inlet: the oil begins near the contact, which thins the film and takes away resistance to rolling.

One length tells how far the oil reaches: that of the meniscus ahead of the centre of the contact. The degree m is this
length over the semi-axis along rolling. At 1 the meniscus stands at the edge of the contact, and nothing is left of
film and rolling. An inlet is flooded where the oil reaches as far as the supply of the scene lets it, and no meniscus
lies farther ahead: a supply that ends within the contact leaves nothing at any degree.
    rolling   g = ln(1 + (m a - a)/s)/ln(1 + (X - a)/s), with the length X of a flooded inlet and s of `ehl_fit`
    film      f = min(1, [(m - 1)/(m* - 1)]^0.29), m* = 1 + 3.06 [(R_x/a)^2 h/R_x]^0.58
Films measured with grease (`analytic.oil.grease`) give f; rolling then loses as much as the film.
A contact without load or without a film counts as flooded. Rolling starves long before the film.
`validation/ehl/starved.py` compares both with numerical solutions: from m = 2 on g is 3 % too low to 9 % too high and
f 10 % too low to 6 % too high; from 1.3 to 2 g is 15 % too low to 34 % too high and f 7 % too low to 27 % too high.
Source of f: [Hamrock1977b], a fit to point contacts.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import InputError
from analytic.numerics.compilation import compiled
from analytic.oil.ehl_fit import inlet_lengths


class StarvedNumbers(NamedTuple):
    """The inlet of one contact."""

    degree: float  # m, >= 1; inf: without load or film
    film_factor: float  # f, starved over flooded central film, 0 to 1
    rolling_factor: float  # g, starved over flooded resistance to rolling, 0 to 1


FLOODED = StarvedNumbers(np.inf, 1.0, 1.0)
DRY = StarvedNumbers(1.0, 0.0, 0.0)
THINNING = 0.29  # power of f


@compiled
def thinning_excess(contact: ContactNumbers, film: float) -> float:
    """m* - 1; film : h, m, flooded, in the centre of a contact with load, > 0."""
    return 3.06 * (film / contact.curvature_rolling / contact.semi_axis_rolling**2) ** 0.58


@compiled
def film_factor(contact: ContactNumbers, degree: float, film: float) -> float:
    """f; film : as above."""
    return min(1.0, ((degree - 1) / thinning_excess(contact, film)) ** THINNING)


@compiled
def starved_by_degree(
    contact: ContactNumbers, degree: float, film: float, ahead: float, inlet_length: float
) -> StarvedNumbers:
    """What the degree leaves.

    film : h, m, flooded, in the centre;  ahead : X of a flooded inlet, m;  inlet_length : s, m
    """
    a = contact.semi_axis_rolling
    if a == 0.0 or film == 0.0:
        return StarvedNumbers(degree, 1.0, 1.0)
    if ahead <= a:
        return DRY
    if ahead <= degree * a:
        return StarvedNumbers(degree, film_factor(contact, ahead / a, film), 1.0)
    left = inlet_lengths(degree * a, a, inlet_length) / inlet_lengths(ahead, a, inlet_length)
    return StarvedNumbers(degree, film_factor(contact, degree, film), left)


@compiled
def starved_by_film(contact: ContactNumbers, factor: float, film: float) -> StarvedNumbers:
    """The degree that leaves this much of the film, and of rolling as much; factor : f, 1 or more where flooded."""
    if contact.semi_axis_rolling == 0.0 or film == 0.0 or factor >= 1.0:
        return FLOODED
    return StarvedNumbers(1 + thinning_excess(contact, film) * factor ** (1 / THINNING), factor, factor)


@compiled
def starved_by_factor(
    contact: ContactNumbers, factor: float, film: float, ahead: float, inlet_length: float
) -> StarvedNumbers:
    """The degree that leaves this much of rolling, and what it leaves of the film; the rest as for a degree."""
    a = contact.semi_axis_rolling
    if a == 0.0 or film == 0.0:
        return FLOODED
    if ahead <= a:
        return DRY
    excess = inlet_length * np.expm1(factor * inlet_lengths(ahead, a, inlet_length)) / a
    return StarvedNumbers(1 + excess, film_factor(contact, 1 + excess, film), factor)


def checked_degree(degree: float) -> float:
    """The degree. Raises InputError where it is below 1."""
    if not degree >= 1:
        raise InputError(
            f"lubricant.starvation_degree = {degree!r} must be at least 1, where the oil begins at the edge of the "
            "contact: usual are 1.1 to 10, and inf is flooded"
        )
    return float(degree)
