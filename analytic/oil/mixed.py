"""Mixed lubrication: oil film and asperities share the load of a rough contact.

The asperities carry the share s of the load. The oil carries 1 - s, as a smooth film under the load F (1 - s) between
bodies of the modulus E* (1 - s). Both share one film thickness.
Source: [Johnson1972].
"""

from dataclasses import dataclass, fields, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import expit

from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_non_negative
from analytic.numerics.root import Sought, bracketed_root
from analytic.oil.film import FilmAsymptotes, film_asymptotes
from analytic.scene import Array
from analytic.surface.asperity_table import AsperityTable

# Of ln(s/(1 - s)). Newton's quadratic steps leave far less, and the table of the asperities is accurate to 1e-8.
LAST_STEP = 1e-7
FADED = 45.0  # standard deviations of summit height: there asperities carry e^-1000 of what they can carry
NEARLY_ALL = 40.0  # ln(s/(1 - s)): s is 1 in double precision
BLOCK = 4096  # contacts at a time: the arrays stay in the processor's cache


@dataclass(frozen=True, kw_only=True, eq=False)
class MixedContact:
    """One or many lubricated rough contacts; every field has the broadcast shape of the arguments."""

    asperity_share: Array  # s, of the load, 0 to 1
    film_thickness: Array  # h, between the mean planes, m; below 0 only where there is no film
    area_fraction: Array  # A_a/A_H, of the contact's area that asperities touch, 0 to 1
    asperity_load: Array  # s F, N
    capped: NDArray[np.bool_]  # the film fills the clearance
    outside_range: NDArray[np.bool_]  # the film formula is extrapolated in ellipticity
    without_film: NDArray[np.bool_]  # at standstill asperities carry all, which may differ from the limit u -> 0


def mixed_contact(
    contact: EllipticContact,
    *,
    entrainment_speed: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    asperities: AsperityTable | None,
    heating_factor: ArrayLike = 1.0,
    largest_gap: ArrayLike | None = None,
) -> MixedContact:
    """The share of the load that asperities carry, and the film thickness; fields and arguments broadcast.

    contact : smooth, with the area A_H = pi a b of its semi-axes
    entrainment_speed, viscosity, pressure_viscosity, largest_gap : as in `film.central_film`
    asperities : of both surfaces together, one table for all contacts; None: smooth
    heating_factor : on the film, >= 0, for the heating of the inlet
    s in [0, 1] and h solve
        p_a(h) A_H = s F,  h = heating_factor * film(F (1 - s), E* (1 - s))
    As s grows, the film grows and the pressure of the asperities falls, so there is one solution. Asperities carry the
    whole load if they do so even at largest_gap, and also without speed; then p_a(h) A_H = F gives h. If this h is
    positive, it is also the limit of slow running. Otherwise slow running tends to h = 0 and s = p_a(0) A_H/F < 1, and
    standstill is a jump from there. Without load there is no share. A smooth contact has a share only without speed,
    where h = 0 and s = 1.
    Raises InputError if an argument has the wrong sign or is not finite, if shapes do not broadcast, or if a semi-axis
    is 0 under load.
    """
    require_non_negative(heating_factor=heating_factor)
    asymptotes = film_asymptotes(
        contact,
        entrainment_speed=entrainment_speed,
        viscosity=viscosity,
        pressure_viscosity=pressure_viscosity,
        largest_gap=largest_gap,
    )
    force, area = np.asarray(contact.load, dtype=np.float64), contact.area
    try:
        with np.errstate(divide="ignore", invalid="ignore"):  # without load the softness is not used
            log_heating, log_softness = np.log(heating_factor), np.log(area) - np.log(force)
            thinned = {
                name: np.where(log_heating == -np.inf, -np.inf, log_heating + getattr(asymptotes, name))
                for name in ("rigid", "elastic", "unloaded", "piezoviscous")
            }
        parts = (*vars(replace(asymptotes, **thinned)).values(), log_softness, force)
        shape = np.broadcast(*parts).shape
        numbers = np.empty((len(parts), *shape))
        for row, part in enumerate(parts):
            numbers[row] = part
    except ValueError as problem:
        raise InputError(
            "the arguments of a mixed contact have shapes that do not fit together: give equal lengths"
        ) from problem
    if np.any(np.isneginf(numbers[-2])):  # ln 0 less the ln of a load
        raise InputError(
            "semi_axis_rolling or semi_axis_transverse is 0 under load: give the semi-axes of the smooth contact"
        )
    flat = numbers.reshape(len(parts), -1)
    blocks = [_shared(flat[:, start : start + BLOCK], asperities) for start in range(0, max(flat.shape[1], 1), BLOCK)]
    share, height, touched = (np.concatenate(rows).reshape(shape) for rows in zip(*blocks, strict=True))
    film, *_ = _unpacked(numbers)
    without_film = np.isneginf(film.rigid)
    return MixedContact(
        asperity_share=share,
        film_thickness=height,
        area_fraction=touched,
        asperity_load=share * force,
        capped=~without_film & (height >= np.exp(film.clearance)),
        outside_range=film.outside_range,
        without_film=without_film,
    )


def _shared(numbers: Array, asperities: AsperityTable | None) -> tuple[Array, Array, Array]:
    """Share, film thickness and area fraction of the contacts in the columns of numbers."""
    film, log_softness, load = _unpacked(numbers)
    log_alone, loaded = film.log_film(0.0)[0], load > 0
    dry = np.isneginf(log_alone)
    if asperities is None:
        return np.where(dry & loaded, 1.0, 0.0), np.exp(log_alone), np.where(dry, 1.0, 0.0)
    least = asperities.separation(np.where(loaded, -log_softness, 0.0))[0]  # h if asperities carry all
    carried = loaded & (dry | (least >= np.exp(film.clearance)))
    share, height = np.where(carried, 1.0, 0.0), np.where(carried, least, np.exp(log_alone))
    sharing = loaded & ~carried
    if sharing.any():
        share[sharing], height[sharing] = _balanced(numbers[:, sharing], log_alone[sharing], least[sharing], asperities)
    return share, height, asperities.area_fraction(height)


def _unpacked(numbers: Array) -> tuple[FilmAsymptotes, Array, Array]:
    """The film, ln(A_H/F) and F from the rows of numbers."""
    *film, log_softness, load = numbers
    names = (field.name for field in fields(FilmAsymptotes))
    return FilmAsymptotes(**dict(zip(names, film, strict=True))), log_softness, load


def _balanced(numbers: Array, log_alone: Array, least: Array, asperities: AsperityTable) -> tuple[Array, Array]:
    """s and h where both carry: the film is as thick as the separation at which asperities carry their share.

    The unknown is z = ln(s/(1 - s)), which keeps the digits of s and 1 - s. Over z, asinh(h/sigma_s) of film and
    separation are nearly straight lines, one rising and one falling. log_alone: ln h without asperities; least: h
    without oil, m. Both bound h from below.
    """
    film, log_softness, _ = _unpacked(numbers)
    deviation = asperities.summits.height_deviation

    def excess(z: Array) -> tuple[Array, Array]:
        log_share, log_remaining = -np.logaddexp(0.0, -z), -np.logaddexp(0.0, z)
        log_h, slope = film.log_film(log_remaining)
        needed, needed_slope = asperities.separation(log_share - log_softness)
        h = np.exp(log_h)
        rising = -np.exp(log_share) * slope * h / np.hypot(deviation, h)
        falling = np.exp(log_remaining) * needed_slope / np.hypot(deviation, needed)
        return np.arcsinh(h / deviation) - np.arcsinh(needed / deviation), rising - falling

    thick = np.minimum(log_alone + np.log(4), film.clearance)  # no film under half of the load or more is thicker
    log_share = asperities.log_pressure(np.exp(np.stack([log_alone, thick]))) + log_softness
    low = np.minimum(log_share[1], 0.0) - 1e-6  # the inverse of the table is accurate to 1e-8
    # The start: ln(1/(1 - s)) at which the oil's film is as thick as the separation with the whole load on asperities.
    log_needed = np.log(np.maximum(least, 1e-3 * deviation))
    grown = np.maximum((log_needed - film.elastic) / 0.6, (log_needed - film.unloaded) / 0.5)
    grown = np.maximum(np.minimum(grown, (log_needed - film.rigid) / 2), 0.3)
    start = grown + np.log(-np.expm1(-grown))
    # Asperities carry at most what they carry at the film of the full load, and nothing at FADED deviations.
    log_faded = np.log(asperities.summits.mean_height + FADED * deviation)
    high = np.maximum((log_faded - film.rigid) / 2, 0.0) + NEARLY_ALL
    little = log_share[0] < -0.5
    most = log_share[0] - np.log1p(-np.exp(np.minimum(log_share[0], -0.5)))
    z = bracketed_root(
        excess,
        start=np.where(little, most, np.clip(start, low, high)),
        low=low,
        high=np.where(little, most + 1e-6, high),
        relative=1e-12,
        absolute=LAST_STEP,
        sought=Sought(
            unit="of ln(s/(1 - s))",
            problem="the load shared by film and asperities",
            remedy="Check that load, speed, viscosity and roughness are of ordinary size.",
        ),
    )
    return expit(z), np.exp(film.log_film(-np.logaddexp(0.0, z))[0])
