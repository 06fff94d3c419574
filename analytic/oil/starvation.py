"""A starved inlet: the oil begins near the contact, which thins the film and takes away resistance to rolling.

One number tells how far the oil reaches: the degree m, the distance from the centre of the contact to the meniscus
ahead of it, over the semi-axis along rolling. At 1 the meniscus stands at the edge of the contact, and nothing is left
of film and rolling. At inf the inlet is flooded. A contact without load or without a film counts as flooded.
The film's factor is a fit to point contacts. The gap at the meniscus is that of a line contact, and so is the factor on
rolling: on a race they are a first estimate. Where the film begins to thin, rolling has already lost some 45 %.
Sources: [Hamrock1977b] for the film, [Biboulet2010a] for rolling.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import Array

LINE_EDGE = np.log(4 * np.sqrt(2) / 3)  # ln of the factor of (m - 1)^1.5, the gap next to the edge of a line contact
NEAR, FAR = 4.5e-4, 1e8  # of m - 1: nearer the terms of the gap cancel, farther it is m^2; either to 1e-12


@dataclass(frozen=True, kw_only=True, eq=False)
class Starvation:
    """The inlets of one or many contacts; every field has the broadcast shape of the arguments."""

    degree: Array  # m, >= 1; inf: flooded
    film_factor: Array  # f, starved over flooded central film, 0 to 1
    fullness: Array  # S, gap at the meniscus over the flooded minimum film, >= 0; inf: flooded
    rolling_factor: Array  # g, starved over flooded resistance to rolling, 0 to 1


def starved_at_degree(
    contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike, minimum_ratio: ArrayLike
) -> Starvation:
    """What the degree leaves of film and rolling; fields and arguments broadcast.

    contact : with the semi-axis a along rolling and the curvature 1/R_x; without load a = 0
    degree : m, >= 1, may be inf
    film : h, flooded, in the centre, m, >= 0;  minimum_ratio : h_min/h of `film.minimum_ratio`, > 0
    Raises InputError if an argument is out of range or if shapes do not broadcast.
    """
    fullness = inlet_fullness(contact, degree=degree, film=film, minimum_ratio=minimum_ratio)
    shape = fullness.shape
    return Starvation(
        degree=np.broadcast_to(np.asarray(degree, dtype=np.float64), shape),
        film_factor=np.broadcast_to(film_factor(contact, degree=degree, film=film), shape),
        fullness=fullness,
        rolling_factor=rolling_factor(fullness),
    )


def starved_at_factor(
    contact: EllipticContact, *, rolling_factor: ArrayLike, film: ArrayLike, minimum_ratio: ArrayLike
) -> Starvation:
    """The degree that leaves this much of rolling, and what it leaves of the film; fields and arguments broadcast.

    rolling_factor : g, 0 to 1, such as `rolling.replenishment_factor`, as [:, None] with contacts (2, n, m)
    contact, film, minimum_ratio and errors : as in starved_at_degree
    S rises steadily with m, so there is one root of S(m) = S(g). Below g = 1e-5 m - 1 is less than round-off, and m
    and f are those of the edge. Contacts that count as flooded keep all of rolling, whatever g.
    """
    require_positive(minimum_ratio=minimum_ratio)
    reach, flooded = _reach(contact, film)
    wanted, reach, flooded, ratio = _together(fullness_at(rolling_factor), reach, flooded, minimum_ratio)
    wanted = np.where(flooded, np.inf, wanted)
    degree = np.where(wanted == 0, 1.0, np.inf)
    starved = (wanted > 0) & (wanted < np.inf)
    if starved.any():
        log_gap = np.log(wanted[starved]) + np.log(ratio[starved])
        degree[starved] = 1 + np.exp(_log_excess(log_gap, reach[starved]))
    return Starvation(
        degree=degree,
        film_factor=film_factor(contact, degree=degree, film=film),
        fullness=wanted,
        rolling_factor=np.where(flooded, 1.0, rolling_factor),
    )


def film_factor(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike) -> Array:
    """f = min(1, [(m - 1)/(m* - 1)]^0.29), m* = 1 + 3.06 [(R_x/a)^2 h/R_x]^0.58: starved over flooded central film.

    Arguments and errors : as in starved_at_degree
    """
    log_excess, reach, flooded = _together(_log_of_excess(degree), *_reach(contact, film))
    return np.where(flooded, 1.0, np.exp(_log_film_factor(log_excess, reach)))


def meniscus_gap(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike) -> Array:
    """h_a = f h + a^2/(2 R_x) [m sqrt(m^2 - 1) - ln(m + sqrt(m^2 - 1))], m: the gap of the bodies at the meniscus.

    The second term is the gap outside the contact of dry cylinders. Arguments and errors : as in starved_at_degree
    """
    factor = film_factor(contact, degree=degree, film=film)
    with np.errstate(invalid="ignore"):  # without load an infinite degree is no distance
        beside = np.exp(_log_line_gap(_log_of_excess(degree))) * np.asarray(contact.semi_axis_rolling) ** 2
    beside = np.where(np.asarray(contact.semi_axis_rolling) > 0, beside, 0.0)
    return factor * np.asarray(film) + beside * np.asarray(contact.curvature_rolling) / 2


def inlet_fullness(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike, minimum_ratio: ArrayLike) -> Array:
    """S = h_a/h_min: the gap at the meniscus over the flooded minimum film; inf where the contact counts as flooded.

    Arguments and errors : as in starved_at_degree
    """
    require_positive(minimum_ratio=minimum_ratio)
    reach, flooded = _reach(contact, film)
    log_excess, reach, flooded, ratio = _together(_log_of_excess(degree), reach, flooded, minimum_ratio)
    with np.errstate(over="ignore"):  # a flooded inlet
        return np.where(flooded, np.inf, np.exp(_log_gap(log_excess, reach) - np.log(ratio)))


def rolling_factor(fullness: ArrayLike) -> Array:
    """g(S) = (S^2 + 162.8 S)/(S^2 + 193.1 S + 1257): starved over flooded resistance to rolling, 0 to 1.

    fullness : S, >= 0, may be inf; the fit is for 2 and more. Source: equation 44 of [Biboulet2010a].
    """
    s = np.asarray(fullness, dtype=np.float64)
    if not np.all(s >= 0):
        raise InputError(f"fullness = {fullness!r} must be at least 0: give inf for a flooded inlet")
    few, inverse = np.minimum(s, 1.0), 1 / np.maximum(s, 1.0)  # above 1 in powers of 1/S, as S^2 may overflow
    return few * (few + 162.8 * inverse) / (few**2 + 193.1 * few * inverse + 1257 * inverse**2)


def fullness_at(factor: ArrayLike) -> Array:
    """S at which g(S) is the factor: 0 at 0, inf at 1; the positive root of a quadratic.

    Raises InputError unless the factor is 0 to 1.
    """
    g = np.asarray(factor, dtype=np.float64)
    if not np.all((g >= 0) & (g <= 1)):
        raise InputError(f"rolling_factor = {factor!r} must lie in 0 to 1: give 1 for a flooded inlet")
    half = (162.8 - 193.1 * g) / 2
    root = np.sqrt(half**2 + (1 - g) * 1257 * g)
    with np.errstate(divide="ignore"):
        return np.where(half > 0, 1257 * g / (np.abs(half) + root), (root - half) / (1 - g))


def _log_of_excess(degree: ArrayLike) -> Array:
    """ln(m - 1), -inf at the edge."""
    m = np.asarray(degree, dtype=np.float64)
    if not np.all(m >= 1):
        raise InputError(
            f"lubricant.starvation_degree = {degree!r} must be at least 1, where the oil begins at the edge of the "
            "contact: usual are 1.1 to 10, and inf is flooded"
        )
    with np.errstate(divide="ignore"):
        return np.log(m - 1)


def _reach(contact: EllipticContact, film: ArrayLike) -> tuple[Array, Array]:
    """ln(R_x h/a^2), and where the contact counts as flooded, with 0 there."""
    require_non_negative(film=film)
    a, curvature, h = _together(contact.semi_axis_rolling, contact.curvature_rolling, film)
    flooded = (a == 0) | (h == 0)
    a, h = np.where(flooded, 1.0, a), np.where(flooded, curvature, h)
    return np.log(h) - np.log(curvature) - 2 * np.log(a), flooded


def _together(*values: ArrayLike) -> tuple[Array, ...]:
    try:
        return tuple(np.broadcast_arrays(*(np.asarray(value) for value in values)))
    except ValueError as problem:
        raise InputError(
            "the arguments of a starved inlet have shapes that do not fit together: give equal lengths"
        ) from problem


def _log_film_factor(log_excess: Array, reach: Array) -> Array:
    return np.minimum(0.29 * (log_excess - np.log(3.06) - 0.58 * reach), 0.0)


def _log_gap(log_excess: Array, reach: Array) -> Array:
    """ln(h_a/h)."""
    return np.logaddexp(_log_film_factor(log_excess, reach), _log_line_gap(log_excess) - np.log(2) - reach)


def _log_line_gap(log_excess: Array) -> Array:
    """ln of the bracket in meniscus_gap, (sinh 2t - 2t)/2 with m = cosh t."""
    between = np.exp(np.clip(log_excess, np.log(NEAR), np.log(FAR)))
    root = np.sqrt(between * (between + 2))
    middle = np.log((1 + between) * root - np.log1p(between + root))
    far = 2 * np.logaddexp(0.0, log_excess)
    near = np.exp(np.minimum(log_excess, np.log(NEAR)))
    # In powers of m - 1, from those of t: (4 sqrt 2/3) (m - 1)^1.5 [1 + 3/20 (m - 1) - 3/224 (m - 1)^2]
    series = LINE_EDGE + 1.5 * log_excess + np.log1p(near * (3 / 20 - 3 / 224 * near))
    return np.where(log_excess < np.log(NEAR), series, np.where(log_excess > np.log(FAR), far, middle))


def _log_excess(log_gap: Array, reach: Array) -> Array:
    """ln(m - 1) at which ln(h_a/h) is log_gap."""

    def by_film(log_part: Array) -> Array:
        """Where f alone is as large; it never is above 1."""
        return np.where(log_part < 0, log_part / 0.29 + np.log(3.06) + 0.58 * reach, np.inf)

    def by_line(log_part: Array) -> Array:
        """Where the larger of (4 sqrt 2/3) (m - 1)^1.5 and (m - 1)^2, in place of the line's gap, is as large."""
        log_line = log_part + np.log(2) + reach
        return np.minimum((log_line - LINE_EDGE) / 1.5, log_line / 2)

    def excess_gap(z: Array) -> tuple[Array, Array]:
        gap = _log_gap(z, reach)
        film, line = _log_film_factor(z, reach), _log_line_gap(z)
        e = np.exp(np.clip(z, np.log(NEAR), np.log(FAR)))
        # d ln(line's gap)/dz: 2 e sqrt(e (e + 2)) over it, which goes from 1.5 to 2
        growth = 2 * e * np.sqrt(e * (e + 2)) / np.exp(_log_line_gap(np.log(e)))
        slope = 0.29 * (film < 0) * np.exp(film - gap) + growth * np.exp(line - np.log(2) - reach - gap)
        return gap - log_gap, slope

    # The line's gap lies between the larger one and twice of it; one of two parts is at least half of the whole.
    low = np.minimum(by_film(log_gap - np.log(2)), by_line(log_gap - 2 * np.log(2)))
    high = np.minimum(by_film(log_gap), by_line(log_gap))
    return bracketed_root(
        excess_gap,
        start=high,
        low=low,
        high=high,
        relative=1e-14,
        absolute=1e-12,
        sought=Sought(
            unit="of ln(m - 1)",
            problem="the distance of the meniscus from a starved contact",
            remedy="Check that film, semi-axis and curvature are of ordinary size.",
        ),
    )
