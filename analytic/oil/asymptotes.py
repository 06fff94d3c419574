"""The asymptotic films that `analytic.oil.film.central_film` joins, and how they join; numbers and compiled formulas.

The formulas are computed in logarithms, so no power over- or underflows; `central_film` has them in words.
Source: [Nijenbanning1994]; compressible oil by [Dowson1966].
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.scene import Array

FITTED_ELLIPTICITY = (0.03, 1.0)  # approximate range of the numerical solutions that were fitted
LOG_RI, LOG_RP, LOG_EI, LOG_EP, LOG_00 = (float(np.log(factor)) for factor in (145, 1.29, 3.18, 1.48, 1.8))
MOST_DENSE = 1.34  # of an oil under endless pressure, over that without
LOG_MOST_DENSE = float(np.log(MOST_DENSE))


class FilmAsymptotes(NamedTuple):
    """Logarithms of the asymptotic films in m, and of the ratio that says how they join.

    The fields are numbers in compiled code; elsewhere they broadcast.
    """

    rigid: Any  # of H_RI
    elastic: Any  # of H_EI
    unloaded: Any  # of H_00
    piezoviscous: Any  # of H_RP and H_EP together
    elastic_ratio: Any  # ln(H_EI/H_EP)
    clearance: Any  # of the largest gap that bodies and surroundings allow: no film is thicker
    ellipticity: Any  # lambda itself, not its logarithm
    peak_pressure: Any  # of p0, Hertz's, in Pa, if the oil is compressible; -inf if it is not

    @property
    def outside_range(self) -> NDArray[np.bool_]:
        """Where the ellipticity is outside FITTED_ELLIPTICITY."""
        lowest, highest = FITTED_ELLIPTICITY
        ellipticity = np.asarray(self.ellipticity)
        return (ellipticity < lowest) | (ellipticity > highest)

    def log_film(self, log_remaining: ArrayLike) -> tuple[Array, Array]:
        """ln h and its derivative by log_remaining = ln(1 - s_a), where asperities carry the share s_a of the load.

        The film is that of the load F (1 - s_a) and the modulus E* (1 - s_a). Then W stays and U grows as 1/(1 - s_a).
        In metres the isoviscous asymptotes grow as powers of 1 - s_a (-2, -0.6 and -1/2), and the piezoviscous ones
        stay. Compressible oil is squeezed by its share (1 - s_a) p0 of the peak pressure. A film that fills the
        clearance grows no more.
        """
        value, slope = mapped(lambda *given: log_film_of(FilmAsymptotes(*given[:-1]), given[-1]), *self, log_remaining)
        return value, slope


class Inflow(NamedTuple):
    """How oil enters a contact, in numbers."""

    speed: float  # |u|, of entrainment, m/s
    viscosity: float  # eta_0, Pa s
    pressure_viscosity: float  # alpha_p, 1/Pa
    compressible: bool
    largest_gap: float  # m; inf: only the bodies limit it


@compiled
def density_under(pressure: float) -> float:
    """rho/rho_0 of `density_ratio`."""
    return (5.9e8 + MOST_DENSE * pressure) / (5.9e8 + pressure)


@compiled
def asymptotes_of(contact: ContactNumbers, inflow: Inflow) -> FilmAsymptotes:
    """The asymptotes that `central_film` joins, in logarithms."""
    rolling, transverse, stiff = contact.curvature_rolling, contact.curvature_transverse, 2 * contact.modulus
    log_rolling, log_stiff = np.log(rolling), np.log(stiff)
    moving = inflow.speed > 0.0
    # ln 0 = -inf where there is no load or no piezoviscosity
    log_u = np.log(2 * inflow.speed) + np.log(inflow.viscosity) + log_rolling - log_stiff if moving else 0.0
    log_m = np.log(contact.load) + 2 * log_rolling - log_stiff - 0.75 * log_u
    log_l = np.log(inflow.pressure_viscosity) + log_stiff + log_u / 4
    scale = log_u / 2 - log_rolling if moving else -np.inf  # ln of R_x U^(1/2)
    ellipticity = transverse / rolling
    log_ratio = np.log(ellipticity)
    elastic = np.log1p(0.006 * log_ratio + 0.63 * np.exp(4 / 7 * log_ratio))
    log_ri = LOG_RI - 15 / 7 * np.log1p(0.796 * np.exp(14 / 15 * log_ratio)) - log_ratio - 2 * log_m
    log_rp = LOG_RP - 2 / 3 * np.log1p(0.691 * ellipticity) + 2 / 3 * log_l
    log_ei = LOG_EI - 14 / 25 * elastic - log_ratio / 15
    log_ep = LOG_EP - 7 / 20 * elastic - log_ratio / 24 + 3 / 4 * log_l
    # Without load and piezoviscosity inf - inf: H_EP is not used then.
    log_ep_loaded = log_ep - log_m / 12 if log_l > -np.inf else -np.inf
    peak_pressure = -np.inf
    if inflow.compressible and contact.load > 0.0:  # without load there is no pressure
        area = np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse
        peak_pressure = np.log(1.5 * contact.load / area)
    return FilmAsymptotes(
        scale + log_ri if moving else -np.inf,  # not inf - inf without load
        scale + log_ei - 2 / 15 * log_m if moving else -np.inf,
        scale + LOG_00 - log_ratio,
        scale - np.logaddexp(-8 * log_rp, -8 * log_ep_loaded) / 8 if moving else -np.inf,
        # H_EI/H_EP as one expression: without load both are infinite, without piezoviscosity H_EP is 0.
        log_ei - log_ep - (2 / 15 - 1 / 12) * log_m,
        min(-np.log(rolling + transverse), np.log(inflow.largest_gap)),
        ellipticity,
        peak_pressure,
    )


@compiled
def log_film_of(film: FilmAsymptotes, log_remaining: float) -> tuple[float, float]:
    """ln h and its derivative by log_remaining, as `FilmAsymptotes.log_film` says."""
    rigid = 1.5 * (film.rigid - 2 * log_remaining)
    elastic, unloaded = -4 * film.elastic + 2.4 * log_remaining, -4 * film.unloaded + 2 * log_remaining
    # Differences of infinities without load or speed give no number, and are not used then.
    bodies = np.logaddexp(elastic, unloaded)
    both = np.logaddexp(rigid, -3 / 8 * bodies)
    isoviscous = 2 / 3 * both
    ratio = np.exp(film.elastic_ratio - 0.6 * log_remaining)
    fading = np.exp(-1.2 * ratio)
    s = 1.5 * (1 + fading)
    log_film = np.logaddexp(s * isoviscous, s * film.piezoviscous) / s
    if not log_film < film.clearance + LOG_MOST_DENSE:
        return film.clearance, 0.0
    weight, weight_rigid = np.exp(s * (isoviscous - log_film)), np.exp(rigid - both)
    slope = -2 * weight_rigid - (1 - weight_rigid) * (0.5 + 0.1 * np.exp(elastic - bodies))
    slope *= weight
    if fading > 0.0:  # s changes too: ds = 1.08 ratio fading per unit of log_remaining
        mixture = weight * (isoviscous - log_film) + (1 - weight) * (film.piezoviscous - log_film)
        slope += 1.08 * ratio * fading / s * mixture
    if film.peak_pressure > -np.inf:
        pressure = np.exp(film.peak_pressure + log_remaining)
        log_film -= np.log(density_under(pressure))
        slope -= pressure * (MOST_DENSE / (5.9e8 + MOST_DENSE * pressure) - 1 / (5.9e8 + pressure))
    if log_film < film.clearance:
        return log_film, slope
    return film.clearance, 0.0


@compiled
def thinned(film: FilmAsymptotes, log_factor: float) -> FilmAsymptotes:
    """All films times a factor, whose logarithm may be -inf; the clearance stays."""
    if log_factor == -np.inf:  # no film, although an asymptote without load is infinite
        rigid = elastic = unloaded = piezoviscous = -np.inf
    else:
        rigid, elastic = log_factor + film.rigid, log_factor + film.elastic
        unloaded, piezoviscous = log_factor + film.unloaded, log_factor + film.piezoviscous
    return FilmAsymptotes(
        rigid,
        elastic,
        unloaded,
        piezoviscous,
        film.elastic_ratio,
        film.clearance,
        film.ellipticity,
        film.peak_pressure,
    )
