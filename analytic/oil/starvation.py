"""A starved inlet: the oil begins near the contact, which thins the film and takes away resistance to rolling.

One number tells how far the oil reaches: the degree m, the distance from the centre of the contact to the meniscus
ahead of it, over the semi-axis along rolling. At 1 the meniscus stands at the edge of the contact, and nothing is left
of film and rolling. At inf the inlet is flooded. A contact without load or without a film counts as flooded.
The degree comes from the scene, or from an estimate of the rolling that is left. Films measured with grease
(`analytic.oil.grease`) give film and degree, and rolling loses as much as the film.
The film's factor is a fit to point contacts. The gap at the meniscus is that of a line contact, and so is the factor on
rolling: on a race they are a first estimate. Where the film begins to thin, rolling has already lost some 45 %.
Sources: [Hamrock1977b] for the film, [Biboulet2010a] for rolling.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import ContactNumbers, EllipticContact, contact_at
from analytic.errors import ConvergenceError, InputError, require_non_negative, require_positive
from analytic.numerics.compilation import compiled, rows_of
from analytic.scene import Array

LINE_EDGE = float(
    np.log(4 * np.sqrt(2) / 3)
)  # ln of the factor of (m - 1)^1.5, the gap next to the edge of a line contact
NEAR, FAR = 4.5e-4, 1e8  # of m - 1: nearer the terms of the gap cancel, farther it is m^2; either to 1e-12
LOG_NEAR, LOG_FAR = float(np.log(NEAR)), float(np.log(FAR))
LOG_THINNING = float(np.log(3.06))
LOG_2 = float(np.log(2))
MOST_STEPS = 200  # each halves the bracket or the step before the last; 3 to 6 are usual
LAST_STEP = 3e-8  # of ln(m - 1): Newton's quadratic steps then leave round-off


@dataclass(frozen=True, kw_only=True, eq=False)
class Starvation:
    """The inlets of one or many contacts; every field has the broadcast shape of the arguments."""

    degree: Array  # m, >= 1; inf: flooded
    film_factor: Array  # f, starved over flooded central film, 0 to 1
    fullness: Array  # S, gap at the meniscus over the flooded minimum film, >= 0; inf: flooded
    rolling_factor: Array  # g, starved over flooded resistance to rolling, 0 to 1


class StarvedNumbers(NamedTuple):
    """One `Starvation` in numbers, for compiled formulas; a degree of NaN: the root was not found."""

    degree: float
    film_factor: float
    fullness: float
    rolling_factor: float


FLOODED = StarvedNumbers(np.inf, 1.0, np.inf, 1.0)


@compiled
def log_reach(contact: ContactNumbers, film: float) -> float:
    """ln(R_x h/a^2) of a contact with load and film."""
    return np.log(film) - np.log(contact.curvature_rolling) - 2 * np.log(contact.semi_axis_rolling)


@compiled
def log_film_factor(log_excess: float, reach: float) -> float:
    """ln f of `film_factor`; log_excess : ln(m - 1);  reach : of `log_reach`."""
    return min(0.29 * (log_excess - LOG_THINNING - 0.58 * reach), 0.0)


@compiled
def log_line_gap(log_excess: float) -> float:
    """ln of the bracket in `meniscus_gap`, (sinh 2t - 2t)/2 with m = cosh t."""
    if log_excess < LOG_NEAR:
        # In powers of m - 1, from those of t: (4 sqrt 2/3) (m - 1)^1.5 [1 + 3/20 (m - 1) - 3/224 (m - 1)^2]
        near = np.exp(log_excess)
        return LINE_EDGE + 1.5 * log_excess + np.log1p(near * (3 / 20 - 3 / 224 * near))
    if log_excess > LOG_FAR:
        return 2 * np.logaddexp(0.0, log_excess)
    excess = np.exp(log_excess)
    root = np.sqrt(excess * (excess + 2))
    return np.log((1 + excess) * root - np.log1p(excess + root))


@compiled
def log_gap_ratio(log_excess: float, reach: float) -> float:
    """ln(h_a/h)."""
    return np.logaddexp(log_film_factor(log_excess, reach), log_line_gap(log_excess) - LOG_2 - reach)


@compiled
def _line_growth(log_excess: float, log_gap: float) -> float:
    """Slope of `log_line_gap`, which is log_gap there: 2 e sqrt(e (e + 2)) over the gap, from 1.5 to 2."""
    if log_excess < LOG_NEAR:
        return 1.5
    if log_excess > LOG_FAR:
        return 2.0
    excess = np.exp(log_excess)
    return 2 * excess * np.sqrt(excess * (excess + 2)) / np.exp(log_gap)


@compiled
def log_excess_at(log_gap: float, reach: float) -> float:
    """ln(m - 1) at which ln(h_a/h) is log_gap, by Newton's method in a bracket; NaN if it is not found.

    One of the two parts of h_a/h is at least half of the whole, which bounds m - 1 by each part alone. The part of the
    line lies between the larger of (4 sqrt 2/3) (m - 1)^1.5 and (m - 1)^2 and twice of it.
    """
    half, line = log_gap - LOG_2, log_gap + LOG_2 + reach
    low_line, high_line = line - 2 * LOG_2, line
    low = min((low_line - LINE_EDGE) / 1.5, low_line / 2)
    if half < 0.0:  # f is never above 1
        low = min(low, half / 0.29 + LOG_THINNING + 0.58 * reach)
    high = min((high_line - LINE_EDGE) / 1.5, high_line / 2)
    if log_gap < 0.0:
        high = min(high, log_gap / 0.29 + LOG_THINNING + 0.58 * reach)
    z, last, before = high, high - low, high - low
    for _ in range(MOST_STEPS):
        film, beside = log_film_factor(z, reach), log_line_gap(z)
        part = beside - LOG_2 - reach
        gap = np.logaddexp(film, part)
        slope = _line_growth(z, beside) * np.exp(part - gap)
        if film < 0.0:
            slope += 0.29 * np.exp(film - gap)
        if gap < log_gap:
            low = z
        elif gap > log_gap:
            high = z
        else:
            return z
        step = (log_gap - gap) / slope
        if not (low <= z + step <= high and abs(step) <= abs(before) / 2):
            step = (low + high) / 2 - z
        before, last = last, step
        z += step
        if abs(last) <= 1e-14 * abs(z) + LAST_STEP and not np.isnan(gap):
            return z
    return np.nan


@compiled
def rolling_left(fullness: float) -> float:
    """g(S) of `rolling_factor`."""
    few, inverse = min(fullness, 1.0), 1 / max(fullness, 1.0)  # above 1 in powers of 1/S, as S^2 may overflow
    return few * (few + 162.8 * inverse) / (few**2 + 193.1 * few * inverse + 1257 * inverse**2)


@compiled
def fullness_leaving(factor: float) -> float:
    """S at which g(S) is the factor."""
    half = (162.8 - 193.1 * factor) / 2
    root = np.sqrt(half**2 + (1 - factor) * 1257 * factor)
    return 1257 * factor / (half + root) if half > 0.0 else (root - half) / (1 - factor)


@compiled
def starved_by_degree(contact: ContactNumbers, degree: float, film: float, ratio: float) -> StarvedNumbers:
    """What the degree leaves, as `starved_at_degree` says; film : h, m, flooded;  ratio : h_min/h."""
    if contact.semi_axis_rolling == 0.0 or film == 0.0:
        return StarvedNumbers(degree, 1.0, np.inf, 1.0)
    reach, log_excess = log_reach(contact, film), np.log(degree - 1)
    fullness = np.exp(log_gap_ratio(log_excess, reach) - np.log(ratio)) if degree < np.inf else np.inf
    return StarvedNumbers(degree, np.exp(log_film_factor(log_excess, reach)), fullness, rolling_left(fullness))


@compiled
def starved_by_film(contact: ContactNumbers, log_factor: float, film: float, ratio: float) -> StarvedNumbers:
    """The degree that leaves this much of the film, and of rolling as much; log_factor : ln f, >= 0 where flooded."""
    if contact.semi_axis_rolling == 0.0 or film == 0.0 or log_factor >= 0.0:
        return FLOODED
    log_excess = LOG_THINNING + 0.58 * log_reach(contact, film) + log_factor / 0.29
    found = starved_by_degree(contact, 1 + np.exp(log_excess), film, ratio)
    return StarvedNumbers(found.degree, found.film_factor, found.fullness, found.film_factor)


@compiled
def starved_by_factor(contact: ContactNumbers, factor: float, film: float, ratio: float) -> StarvedNumbers:
    """The degree that leaves this much of rolling, as `starved_at_factor` says; the rest as for a degree."""
    if contact.semi_axis_rolling == 0.0 or film == 0.0:
        return FLOODED
    fullness = fullness_leaving(factor)
    if fullness == np.inf:
        return StarvedNumbers(np.inf, 1.0, fullness, factor)
    if fullness == 0.0:
        return StarvedNumbers(1.0, 0.0, fullness, factor)
    reach = log_reach(contact, film)
    degree = 1 + np.exp(log_excess_at(np.log(fullness) + np.log(ratio), reach))
    return StarvedNumbers(degree, np.exp(log_film_factor(np.log(degree - 1), reach)), fullness, factor)


@compiled
def _by_degree(rows: Array) -> Array:
    fields = np.empty((4, rows.shape[1]))
    for i in range(rows.shape[1]):
        found = starved_by_degree(contact_at(rows, 0, i), rows[9, i], rows[10, i], rows[11, i])
        for k in range(4):
            fields[k, i] = found[k]
    return fields


@compiled
def _by_factor(rows: Array) -> Array:
    fields = np.empty((4, rows.shape[1]))
    for i in range(rows.shape[1]):
        found = starved_by_factor(contact_at(rows, 0, i), rows[9, i], rows[10, i], rows[11, i])
        for k in range(4):
            fields[k, i] = found[k]
    return fields


@compiled
def _meniscus_gaps(rows: Array) -> Array:
    gaps = np.empty(rows.shape[1])
    for i in range(rows.shape[1]):
        contact, degree, film = contact_at(rows, 0, i), rows[9, i], rows[10, i]
        gaps[i] = starved_by_degree(contact, degree, film, 1.0).film_factor * film
        if contact.semi_axis_rolling > 0.0:
            beside = np.exp(log_line_gap(np.log(degree - 1))) * contact.semi_axis_rolling**2
            gaps[i] += beside * contact.curvature_rolling / 2
    return gaps


@compiled
def _rolling_factors(fullness: Array) -> Array:
    return np.array([rolling_left(each) for each in fullness])


@compiled
def _fullnesses(factor: Array) -> Array:
    return np.array([fullness_leaving(each) for each in factor])


def starved_at_degree(
    contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike, minimum_ratio: ArrayLike
) -> Starvation:
    """What the degree leaves of film and rolling; fields and arguments broadcast.

    contact : with the semi-axis a along rolling and the curvature 1/R_x; without load a = 0
    degree : m, >= 1, may be inf
    film : h, flooded, in the centre, m, >= 0;  minimum_ratio : h_min/h of `film.minimum_ratio`, > 0
    Raises InputError if an argument is out of range or if shapes do not broadcast.
    """
    require_positive(minimum_ratio=minimum_ratio)
    rows, shape = _rows(contact, checked_degrees(degree), film, minimum_ratio)
    return Starvation(**dict(zip(StarvedNumbers._fields, _by_degree(rows).reshape(4, *shape), strict=True)))


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
    rows, shape = _rows(contact, _factors(rolling_factor), film, minimum_ratio)
    fields = _by_factor(rows).reshape(4, *shape)
    if np.isnan(fields[0]).any():
        raise no_meniscus()
    return Starvation(**dict(zip(StarvedNumbers._fields, fields, strict=True)))


def no_meniscus() -> ConvergenceError:
    """The error where a degree is NaN."""
    return ConvergenceError(
        iterations=MOST_STEPS,
        residual=np.nan,
        tolerance=LAST_STEP,
        unit="of ln(m - 1)",
        problem="the distance of the meniscus from a starved contact",
        remedy="Check that film, semi-axis and curvature are of ordinary size.",
    )


def film_factor(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike) -> Array:
    """f = min(1, [(m - 1)/(m* - 1)]^0.29), m* = 1 + 3.06 [(R_x/a)^2 h/R_x]^0.58: starved over flooded central film.

    Arguments and errors : as in starved_at_degree
    """
    return starved_at_degree(contact, degree=degree, film=film, minimum_ratio=1.0).film_factor


def meniscus_gap(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike) -> Array:
    """h_a = f h + a^2/(2 R_x) [m sqrt(m^2 - 1) - ln(m + sqrt(m^2 - 1))], m: the gap of the bodies at the meniscus.

    The second term is the gap outside the contact of dry cylinders. Arguments and errors : as in starved_at_degree
    """
    rows, shape = _rows(contact, checked_degrees(degree), film)
    return _meniscus_gaps(rows).reshape(shape)


def inlet_fullness(contact: EllipticContact, *, degree: ArrayLike, film: ArrayLike, minimum_ratio: ArrayLike) -> Array:
    """S = h_a/h_min: the gap at the meniscus over the flooded minimum film; inf where the contact counts as flooded.

    Arguments and errors : as in starved_at_degree
    """
    return starved_at_degree(contact, degree=degree, film=film, minimum_ratio=minimum_ratio).fullness


def rolling_factor(fullness: ArrayLike) -> Array:
    """g(S) = (S^2 + 162.8 S)/(S^2 + 193.1 S + 1257): starved over flooded resistance to rolling, 0 to 1.

    fullness : S, >= 0, may be inf; the fit is for 2 and more. Source: equation 44 of [Biboulet2010a].
    """
    (s,), shape = rows_of(fullness)
    if not np.all(s >= 0):
        raise InputError(f"fullness = {fullness!r} must be at least 0: give inf for a flooded inlet")
    return _rolling_factors(s).reshape(shape)


def fullness_at(factor: ArrayLike) -> Array:
    """S at which g(S) is the factor: 0 at 0, inf at 1; the positive root of a quadratic.

    Raises InputError unless the factor is 0 to 1.
    """
    (g,), shape = rows_of(_factors(factor))
    return _fullnesses(g).reshape(shape)


def _factors(factor: ArrayLike) -> Array:
    g = np.asarray(factor, dtype=np.float64)
    if not np.all((g >= 0) & (g <= 1)):
        raise InputError(f"rolling_factor = {factor!r} must lie in 0 to 1: give 1 for a flooded inlet")
    return g


def checked_degrees(degree: ArrayLike) -> Array:
    """The degree as an array. Raises InputError where it is below 1."""
    m = np.asarray(degree, dtype=np.float64)
    if not np.all(m >= 1):
        raise InputError(
            f"lubricant.starvation_degree = {degree!r} must be at least 1, where the oil begins at the edge of the "
            "contact: usual are 1.1 to 10, and inf is flooded"
        )
    return m


def _rows(contact: EllipticContact, given: Array, film: ArrayLike, *others: ArrayLike) -> tuple[Array, tuple[int, ...]]:
    """Rows of the contact's fields, the degree or factor, the film and others, and the shape."""
    require_non_negative(film=film)
    try:
        return rows_of(*contact.fields, given, film, *others)
    except ValueError as problem:
        raise InputError(
            "the arguments of a starved inlet have shapes that do not fit together: give equal lengths"
        ) from problem
