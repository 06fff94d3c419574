"""Mixed lubrication: oil film and asperities share the load of a rough contact.

The asperities carry the share s of the load and leave a mean gap between the surfaces, which the oil fills. The oil
carries 1 - s, as a smooth film under the load F (1 - s) between bodies of the modulus E* (1 - s). A film of about a
molecule lubricates no more: it leaves boundary friction.
Source: the shared load of [Johnson1972]; that the oil fills the mean gap follows from the flow, u times this gap.
"""

from math import erfc
from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import ConvergenceError
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import Finite, NotNegative, Positive, formula
from analytic.oil.film import FilmAsymptotes, log_film_of, thinned
from analytic.surface.gap import SMOOTH, GapNumbers, area_of, log_gap_of, log_sigma_of, rough_log_pressure

# Thickness over which a film turns into a layer of molecules that shears like a boundary film, a choice of this model:
# measured films follow the formula for films down to about 1 nm [Johnston1991].
MOLECULAR_FILM = 1e-9  # h_m, m
LAST_STEP = 1e-6  # of ln(s/(1 - s)): Newton's quadratic steps then leave some 1e-12
NO_SHARE = -40.0  # ln(s/(1 - s)): asperities carry less than round-off of the load
LEAST_FALL = 0.05  # of ln p over ln(1 - s), for a start also where the film fills its clearance
NEARLY_ALL = 40.0  # s is 1 in double precision
MOST_STEPS = 200  # each halves the bracket or the step before the last; 4 to 8 are usual


class MixedContact(NamedTuple):
    """A lubricated rough contact; an asperity_share of NaN: the root was not found."""

    asperity_share: float  # s, of the load, 0 to 1
    boundary_share: float  # s_b = s + (1 - s) exp(-h/h_m), of the load, 0 to 1
    film_thickness: float  # h, mean gap that the oil fills, m, >= 0
    area_fraction: float  # A_a/A_H, of the contact's area that asperities touch, 0 to 1
    capped: bool  # the film fills the clearance
    without_film: bool  # standstill


class SharedLoad(NamedTuple):
    """What asperities carry, and what they leave."""

    share: float  # s; NaN: not found
    log_height: float  # ln of the film thickness in m
    touched: float  # A_a/A_H


@compiled
def _inverse_cubic(value: float, slope: float, value_before: float, slope_before: float, step: float) -> float:
    """The next step to value 0, by a cubic x(value) through both points with their slopes; step : between them."""
    between = value - value_before
    chord, first, last = step / between, 1.0 / slope_before, 1.0 / slope
    cubic = (first + last - 2.0 * chord) / between**2
    square = (3.0 * chord - 2.0 * first - last) / between + 3.0 * cubic * between
    return -value * (last - value * (square - value * cubic))


@compiled
def likely_share(log_pressure: float, falls: float) -> float:
    """z of ln s = log_pressure + falls ln(1 - s), by two of Newton's steps; see `shared_load`."""
    z = min(log_pressure, log_pressure / falls)
    for _ in range(2):
        share = 1.0 / (1.0 + np.exp(-z))
        z += (log_pressure + np.logaddexp(0.0, -z) - falls * np.logaddexp(0.0, z)) / (1.0 - share + falls * share)
    return z


@compiled
def shared_load(film: FilmAsymptotes, gap: GapNumbers, log_softness: float, load: float) -> SharedLoad:
    """The load on film and asperities; log_softness : ln(A_H/F) in 1/Pa.

    Where both carry, the film is as thick as the gap that asperities leave. The unknown is z = ln(s/(1 - s)), which
    keeps the digits of s and 1 - s. The search begins where both would meet if ln h were linear in ln(1 - s), and ln p
    in ln h. Newton's method in a bracket follows, from the second step on with the point before: an inverse cubic. A
    film under the load 1 - s is at least that of rigid bodies, h_RI (1 - s)^-2, or fills its clearance, which bounds z.
    """
    log_film, thicker = log_film_of(film, 0.0)
    dry = log_film == -np.inf
    if gap.kind == SMOOTH:
        return SharedLoad(1.0 if dry and load > 0.0 else 0.0, log_film, 1.0 if dry else 0.0)
    if load == 0.0:
        return SharedLoad(0.0, log_film, 0.0)
    if dry:
        return SharedLoad(1.0, log_gap_of(gap, -log_softness)[0], area_of(gap, -log_softness))
    log_pressure, softer = rough_log_pressure(gap, log_film)
    z = min(max(likely_share(log_pressure + log_softness, max(thicker * softer, LEAST_FALL)), NO_SHARE), NEARLY_ALL)
    low, high, step, before, last_excess, last_slope = NO_SHARE, np.inf, np.inf, np.inf, 0.0, 0.0
    for number in range(MOST_STEPS):
        log_share, log_remaining = -np.logaddexp(0.0, -z), -np.logaddexp(0.0, z)
        height, thicker = log_film_of(film, log_remaining)
        log_gap, narrower = log_gap_of(gap, log_share - log_softness)
        excess = height - log_gap  # rises with z
        if excess == 0.0 or (abs(step) <= LAST_STEP and not np.isnan(excess)):
            return SharedLoad(np.exp(log_share), height, area_of(gap, log_share - log_softness))
        slope = -(np.exp(log_share) * thicker + np.exp(log_remaining) * narrower)
        if excess > 0.0:
            high = z
            no_share = z - excess / slope <= NO_SHARE
            if no_share and log_film >= log_gap_of(gap, NO_SHARE - log_softness)[0]:
                return SharedLoad(0.0, log_film, 0.0)
        else:
            low = z
            reach = (log_gap - film.rigid) / 2 if log_gap <= film.clearance else NEARLY_ALL
            high = min(high, max(reach, z) + 1.0)
            if height >= film.clearance:
                log_dry = log_gap_of(gap, -log_softness)[0]
                if log_dry >= film.clearance:
                    return SharedLoad(1.0, log_dry, area_of(gap, -log_softness))
        newton = -excess / slope
        trial = newton
        if number > 0:
            trial = _inverse_cubic(excess, slope, last_excess, last_slope, step)
            if not 0.3 < trial / newton < 3.0:  # both points are not of one smooth piece
                trial = newton
        if not (low <= z + trial <= high and abs(trial) <= abs(before) / 2):
            trial = (low + high) / 2 - z
        before, step, last_excess, last_slope = step, trial, excess, slope
        z += step
    return SharedLoad(np.nan, np.nan, np.nan)


@compiled
def stepped_share(share: float, film_ratio: float, step: float) -> float:
    """The share of the load on asperities between two laws: s (erfc(lambda/2)/s)^step, at most 1.

    share : s, of the shared load;  film_ratio : lambda, the smooth film over the rms height of both surfaces, >= 0
    step : 0: s as it is; 1 and more: the law of friction measured in a ball-on-disc rig [Taylor2026]; -1 and less: as
        far to the other side
    Both laws are 1 without film and fall to 0 in a thick one; where s is 0 it remains so.
    """
    measured = erfc(film_ratio / 2.0)
    if share == 0.0 or measured == 0.0:
        return share
    return min(share * (measured / share) ** min(max(step, -1.0), 1.0), 1.0)


@formula
def mixed_contact(
    contact: ContactNumbers,
    film: FilmAsymptotes,
    gap: GapNumbers,
    film_factor: NotNegative = 1.0,
    pressure_factor: Positive = 1.0,
    share_step: Finite = 0.0,
) -> MixedContact:
    """The share of the load that asperities carry, and the film thickness.

    contact : smooth, with the area A_H = pi a b of its semi-axes;  film : `asymptotes_of` it
    gap : of both surfaces together
    film_factor : on the film, >= 0, for a heated or starved inlet and for the uncertainty of the film
    pressure_factor : on the asperities' pressure at any gap, > 0, for the uncertainty of the surfaces
    share_step : from this share to a measured law, for its uncertainty, see `stepped_share`; film and touched area
        remain, and asperities press harder
    s in [0, 1] solves
        gap(s F/A_H) = film_factor * film(F (1 - s), E* (1 - s))
    As s grows, the film grows and the gap falls, so there is one solution. As the speed falls to 0 so does the film,
    while asperities that carry all leave a gap: s grows to 1, its value at standstill. Asperities also carry all where
    they do so at the largest gap that bodies and surroundings allow. Without load there is no share. A smooth contact
    has a share only without speed, where h = 0 and s = 1.
    The boundary share counts the oil's part too as far as its film is only a molecule thick: h_m = 1 nm.
    """
    factored = thinned(film, np.log(film_factor))
    area = np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse
    log_softness = np.log(area * pressure_factor) - np.log(contact.load) if contact.load > 0.0 else 0.0
    share, log_height, touched = shared_load(factored, gap, log_softness, contact.load)
    if share_step != 0.0 and share > 0.0 and gap.kind != SMOOTH:
        film_ratio = np.exp(log_film_of(factored, 0.0)[0] - log_sigma_of(gap))
        share = stepped_share(share, film_ratio, share_step)
    height, without = np.exp(log_height), factored.rigid == -np.inf
    boundary = share + (1.0 - share) * np.exp(-height / MOLECULAR_FILM)
    capped = not without and height >= np.exp(film.clearance)
    return MixedContact(share, boundary, height, touched, capped, without)


@formula
def oil_beside(mixed: MixedContact) -> tuple[float, float]:
    """Share of the contact's area where oil shears, and its thickness there, m: h/(1 - A_a/A_H).

    Oil shears where neither asperities touch nor its film is only a molecule thick.
    """
    beside = 1.0 - mixed.area_fraction
    area = 0.0 if mixed.without_film else beside * -np.expm1(-mixed.film_thickness / MOLECULAR_FILM)
    return area, mixed.film_thickness / beside if beside > 0.0 else 0.0


def no_shared_load() -> ConvergenceError:
    """Of a contact whose film and asperities find no common load."""
    return ConvergenceError(
        iterations=MOST_STEPS,
        residual=np.nan,
        tolerance=LAST_STEP,
        unit="of ln(s/(1 - s))",
        problem="the load shared by film and asperities",
        remedy="Check that load, speed, viscosity and roughness are of ordinary size.",
    )
