"""Central film thickness of a fully flooded elliptic contact, and its reduction by heating of the inlet.

Entrainment is in the direction of rolling. The formula is a fit to numerical solutions and joins four asymptotes: rigid
or elastic bodies, each with oil of constant or of pressure-dependent viscosity. It assumes smooth bodies and an
isothermal oil. Compressible oil flows through the contact in the same mass, so its film is thinner by the density ratio
there. The torque takes it so, with the correction of `analytic.oil.ehl_fit`, which numerical solutions gave.
All is computed in logarithms, so no power over- or underflows.
Source: [Nijenbanning1994]. The exponent s also appears with H_EI/H_RI in place of H_EI/H_EP, which changes the film by
5 to 8 %.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import Finite, NotNegative, Positive, formula

# Standard deviation of ln(film). Measured films of circular contacts spread by 12 to 17 % in the logarithm; those of
# `validation/film` by 11 % where they are thick enough to be measured well. In the limit of a wide ellipse, and a race
# is near it, the formula lies within -8 to +1 % of a 1-D solution for incompressible oil.
FORMULA_UNCERTAINTY = 0.15
FILM_FACTORS = float(np.exp(-2 * FORMULA_UNCERTAINTY)), float(np.exp(2 * FORMULA_UNCERTAINTY))  # 95 %: 0.74 and 1.35
FITTED_ELLIPTICITY = (0.03, 1.0)  # approximate range of the numerical solutions that were fitted
LOG_RI, LOG_RP, LOG_EI, LOG_EP, LOG_00 = (float(np.log(factor)) for factor in (145, 1.29, 3.18, 1.48, 1.8))
MOST_DENSE = 1.34  # of an oil under endless pressure, over that without
LOG_MOST_DENSE = float(np.log(MOST_DENSE))


class FilmAsymptotes(NamedTuple):
    """Logarithms of the asymptotic films in m, and of the ratio that says how they join."""

    rigid: float  # of H_RI
    elastic: float  # of H_EI
    unloaded: float  # of H_00
    piezoviscous: float  # of H_RP and H_EP together
    elastic_ratio: float  # ln(H_EI/H_EP)
    clearance: float  # of the largest gap that bodies and surroundings allow: no film is thicker
    ellipticity: float  # lambda itself, not its logarithm
    peak_pressure: float  # of p0, Hertz's, in Pa, if the oil is compressible; -inf if it is not


class Inflow(NamedTuple):
    """How oil enters a contact."""

    speed: NotNegative  # |u|, of entrainment, mean of both surfaces, m/s
    viscosity: Positive  # eta_0, at the inlet's temperature, Pa s
    pressure_viscosity: NotNegative  # alpha_p, likewise, 1/Pa
    compressible: bool = False
    largest_gap: float = np.inf  # m, > 0, such as half a pocket's clearance; inf: only the bodies limit it


class CentralFilm(NamedTuple):
    """The film of a contact."""

    thickness: float  # h, m
    ellipticity: float  # lambda = R_x/R_y
    capped: bool  # the formula gave more than the clearance, and the thickness is the clearance
    outside_range: bool  # ellipticity outside FITTED_ELLIPTICITY: the thickness is extrapolated


@formula
def density_ratio(pressure: NotNegative) -> float:
    """rho/rho_0 = (5.9e8 + 1.34 p)/(5.9e8 + p): density of an oil under the pressure p, Pa, >= 0, over that without.

    Source: [Dowson1966].
    """
    return (5.9e8 + MOST_DENSE * pressure) / (5.9e8 + pressure)


@formula
def asymptotes_of(contact: ContactNumbers, inflow: Inflow) -> FilmAsymptotes:
    """The asymptotes that `central_film` joins, in logarithms.

    Without speed all are -inf. Without load those of elastic bodies are inf. Without piezoviscosity the piezoviscous
    ones are -inf.
    """
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


@formula
def log_film_of(film: FilmAsymptotes, log_remaining: float) -> tuple[float, float]:
    """ln h and its derivative by log_remaining = ln(1 - s_a), where asperities carry the share s_a of the load.

    The film is that of the load F (1 - s_a) and the modulus E* (1 - s_a). Then W stays and U grows as 1/(1 - s_a).
    In metres the isoviscous asymptotes grow as powers of 1 - s_a (-2, -0.6 and -1/2), and the piezoviscous ones
    stay. Compressible oil is squeezed by its share (1 - s_a) p0 of the peak pressure. A film that fills the
    clearance grows no more.
    """
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
        log_film -= np.log(density_ratio(pressure))
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
        rigid, elastic, unloaded, piezoviscous, film.elastic_ratio, film.clearance, film.ellipticity, film.peak_pressure
    )


@formula
def central_film(
    contact: ContactNumbers,
    entrainment_speed: Finite,
    viscosity: Positive,
    pressure_viscosity: NotNegative,
    largest_gap: float = np.inf,
    compressible: bool = False,
) -> CentralFilm:
    """Film thickness in the centre of the contact.

    contact : with the load F and the curvatures 1/R_x (rolling) and 1/R_y (transverse); the semi-axes are used only
        where the oil is compressible, for p0
    entrainment_speed : u, mean of both surfaces, m/s, of either sign. At 0 there is no film
    viscosity : eta_0, Pa s, > 0, and pressure_viscosity : alpha_p, 1/Pa, >= 0, at the inlet's temperature
    largest_gap : m, > 0, limit by the surroundings, such as half a pocket's clearance. The film is never thicker than
        this, nor than 1/(1/R_x + 1/R_y): the rigid asymptote grows as F^-2 without limit at light loads
    compressible : the film is thinner by density_ratio at Hertz's peak pressure p0
    With E' = 2 E*, lambda = R_x/R_y, U = 2 eta_0 |u|/(E' R_x), W = F/(E' R_x^2), M = W U^(-3/4),
    L = alpha_p E' U^(1/4) and H = h/R_x U^(-1/2):
        H_RI = 145 (1 + 0.796 lambda^(14/15))^(-15/7) lambda^-1 M^-2
        H_RP = 1.29 (1 + 0.691 lambda)^(-2/3) L^(2/3)
        H_EI = 3.18 (1 + 0.006 ln lambda + 0.63 lambda^(4/7))^(-14/25) lambda^(-1/15) M^(-2/15)
        H_EP = 1.48 (1 + 0.006 ln lambda + 0.63 lambda^(4/7))^(-7/20) lambda^(-1/24) M^(-1/12) L^(3/4)
        H_00 = 1.8/lambda,  s = 1.5 (1 + exp(-1.2 H_EI/H_EP))
        H^s = [H_RI^(3/2) + (H_EI^-4 + H_00^-4)^(-3/8)]^(2 s/3) + (H_RP^-8 + H_EP^-8)^(-s/8)
    """
    inflow = Inflow(abs(entrainment_speed), viscosity, pressure_viscosity, compressible, largest_gap)
    film = asymptotes_of(contact, inflow)
    log_film, _ = log_film_of(film, 0.0)
    outside = film.ellipticity < FITTED_ELLIPTICITY[0] or film.ellipticity > FITTED_ELLIPTICITY[1]
    return CentralFilm(np.exp(log_film), film.ellipticity, log_film >= film.clearance, outside)


@formula
def minimum_ratio(
    contact: ContactNumbers, entrainment_speed: Finite, viscosity: Positive, pressure_viscosity: NotNegative
) -> float:
    """Minimum over central film of a flooded contact, h_min/h, at most 1.

    Arguments : as in central_film, with the semi-axes a (rolling) and b (transverse) too
    With E' = 2 E*, k = b/a, U = eta_0 |u|/(E' R_x), G = alpha_p E' and W = F/(E' R_x^2):
        (3.63/2.69) U^0.01 G^-0.04 W^-0.006 [1 - exp(-0.68 k)]/[1 - 0.61 exp(-0.73 k)]
    Without load, speed or piezoviscosity, where the fits have no meaning, it is 1. Source: [Hamrock1977].
    """
    stiff, a = 2 * contact.modulus, contact.semi_axis_rolling
    u = viscosity * abs(entrainment_speed) * contact.curvature_rolling / stiff
    g, w = pressure_viscosity * stiff, contact.load * contact.curvature_rolling**2 / stiff
    k = contact.semi_axis_transverse / a if a > 0.0 else 0.0
    if u == 0.0 or g == 0.0 or w == 0.0 or k == 0.0:  # the fits have no meaning
        return 1.0
    ratio = 3.63 / 2.69 * np.exp(0.01 * np.log(u) - 0.04 * np.log(g) - 0.006 * np.log(w))
    return min(ratio * -np.expm1(-0.68 * k) / (1 - 0.61 * np.exp(-0.73 * k)), 1.0)


@compiled
def shear_heat(viscosity: float, viscosity_temperature: float, speed: float, conductivity: float) -> float:
    """L_t = eta_0 beta u^2/k_f: how much shear at the inlet heats the oil.

    viscosity : eta_0, Pa s, > 0;  viscosity_temperature : beta = -d ln(eta)/dT, 1/K, >= 0
    speed : u, of entrainment, m/s;  conductivity : k_f, of the oil, W/(m K), > 0
    """
    return viscosity * viscosity_temperature * speed**2 / conductivity


@formula
def inlet_heating_factor(
    peak_pressure: NotNegative, modulus: Positive, thermal_loading: NotNegative, slide_to_roll: NotNegative
) -> float:
    """Film whose inlet is heated by its own shear, over the isothermal film, 0 to 1.

    peak_pressure : p0, Pa, >= 0;  modulus : E*, Pa, > 0
    thermal_loading : L_t = eta_0 beta u^2/k_f, >= 0 (see `shear_heat`)
    slide_to_roll : S, sliding over mean speed, >= 0
        [1 - 13.2 (p0/E') L_t^0.42]/[1 + 0.213 (1 + 2.23 S^0.83) L_t^0.64],  E' = 2 E*
    The numerator passes 0 near L_t = 160 at 2 GPa on steel; beyond that 0 is returned. The fit loses its meaning long
    before.
    Source: [Gupta1992].
    """
    log_loading = np.log(thermal_loading)
    shear = 0.213 * (1 + 2.23 * slide_to_roll**0.83) * np.exp(0.64 * log_loading)
    return max(1 - 13.2 * peak_pressure / (2 * modulus) * np.exp(0.42 * log_loading), 0.0) / (1 + shear)
