"""Central film thickness of a fully flooded elliptic contact, and its reduction by heating of the inlet.

Entrainment is in the direction of rolling. The formula is a fit to numerical solutions and joins four asymptotes: rigid
or elastic bodies, each with oil of constant or of pressure-dependent viscosity. It assumes smooth bodies and an
isothermal oil. Compressible oil flows through the contact in the same mass, so its film is thinner by the density ratio
there; it is off by default, because measured films are thicker than the formula already.
Source: [Nijenbanning1994]. The exponent s also appears with H_EI/H_RI in place of H_EI/H_EP, which changes the film by
5 to 8 %.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array

# Standard deviation of ln(film). Measured films of circular contacts spread by 12 to 17 % in the logarithm; those of
# `validation/film.py` by 11 % where they are thick enough to be measured well. In the limit of a wide ellipse, and a
# race is near it, the formula lies within -8 to +1 % of a 1-D solution for incompressible oil.
FORMULA_UNCERTAINTY = 0.15
FILM_FACTORS = float(np.exp(-2 * FORMULA_UNCERTAINTY)), float(np.exp(2 * FORMULA_UNCERTAINTY))  # 95 %: 0.74 and 1.35
FITTED_ELLIPTICITY = (0.03, 1.0)  # approximate range of the numerical solutions that were fitted


@dataclass(frozen=True, kw_only=True, eq=False)
class CentralFilm:
    """The film of one or many contacts; every field has the broadcast shape of the arguments."""

    thickness: Array  # h, m
    ellipticity: Array  # lambda = R_x/R_y
    capped: NDArray[np.bool_]  # the formula gave more than the clearance, and the thickness is the clearance
    outside_range: NDArray[np.bool_]  # ellipticity outside FITTED_ELLIPTICITY: the thickness is extrapolated


@dataclass(frozen=True, kw_only=True, eq=False)
class FilmAsymptotes:
    """Logarithms of the asymptotic films in m, and of the ratio that says how they join; the fields broadcast."""

    rigid: Array  # of H_RI
    elastic: Array  # of H_EI
    unloaded: Array  # of H_00
    piezoviscous: Array  # of H_RP and H_EP together
    elastic_ratio: Array  # ln(H_EI/H_EP)
    clearance: Array  # of the largest gap that bodies and surroundings allow: no film is thicker
    ellipticity: Array  # lambda itself, not its logarithm
    peak_pressure: Array  # of p0, Hertz's, in Pa, if the oil is compressible; -inf if it is not

    @property
    def outside_range(self) -> NDArray[np.bool_]:
        """Where the ellipticity is outside FITTED_ELLIPTICITY."""
        lowest, highest = FITTED_ELLIPTICITY
        return (self.ellipticity < lowest) | (self.ellipticity > highest)

    def log_film(self, log_remaining: Array | float) -> tuple[Array, Array]:
        """ln h and its derivative by log_remaining = ln(1 - s_a), where asperities carry the share s_a of the load.

        The film is that of the load F (1 - s_a) and the modulus E* (1 - s_a). Then W stays and U grows as 1/(1 - s_a).
        In metres the isoviscous asymptotes grow as powers of 1 - s_a (-2, -0.6 and -1/2), and the piezoviscous ones
        stay. Compressible oil is squeezed by its share (1 - s_a) p0 of the peak pressure. A film that fills the
        clearance grows no more.
        """
        rigid = 1.5 * (self.rigid - 2 * log_remaining)
        elastic, unloaded = -4 * self.elastic + 2.4 * log_remaining, -4 * self.unloaded + 2 * log_remaining
        with np.errstate(over="ignore", invalid="ignore"):  # inf - inf without load or speed: not used then
            bodies = np.logaddexp(elastic, unloaded)
            both = np.logaddexp(rigid, -3 / 8 * bodies)
            isoviscous = 2 / 3 * both
            ratio = np.exp(self.elastic_ratio - 0.6 * log_remaining)
            fading = np.exp(-1.2 * ratio)
            s = 1.5 * (1 + fading)
            film = np.logaddexp(s * isoviscous, s * self.piezoviscous) / s
            weight, weight_rigid = np.exp(s * (isoviscous - film)), np.exp(rigid - both)
            slope = -2 * weight_rigid - (1 - weight_rigid) * (0.5 + 0.1 * np.exp(elastic - bodies))
            # s changes too: ds = 1.08 ratio fading per unit of log_remaining
            mixture = weight * (isoviscous - film) + (1 - weight) * (self.piezoviscous - film)
            slope = weight * slope + np.where(fading > 0, 1.08 * ratio * fading / s * mixture, 0.0)
        if np.any(self.peak_pressure > -np.inf):
            pressure = np.exp(self.peak_pressure + log_remaining)
            film = film - np.log(density_ratio(pressure))
            slope = slope - pressure * (1.34 / (5.9e8 + 1.34 * pressure) - 1 / (5.9e8 + pressure))
        return np.minimum(film, self.clearance), np.where(film < self.clearance, slope, 0.0)


def central_film(
    contact: EllipticContact,
    *,
    entrainment_speed: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    largest_gap: ArrayLike | None = None,
    compressible: bool = False,
) -> CentralFilm:
    """Film thickness in the centre of the contact; fields and arguments broadcast.

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
    The formula is computed in logarithms, so no power over- or underflows.
    Raises InputError if an argument has the wrong sign or is not finite, or if shapes do not broadcast.
    """
    asymptotes = film_asymptotes(
        contact,
        entrainment_speed=entrainment_speed,
        viscosity=viscosity,
        pressure_viscosity=pressure_viscosity,
        largest_gap=largest_gap,
        compressible=compressible,
    )
    log_film, clearance, ellipticity, outside_range = np.broadcast_arrays(
        asymptotes.log_film(0.0)[0], asymptotes.clearance, asymptotes.ellipticity, asymptotes.outside_range
    )
    return CentralFilm(
        thickness=np.exp(log_film),
        ellipticity=ellipticity,
        capped=log_film >= clearance,
        outside_range=outside_range,
    )


def film_asymptotes(
    contact: EllipticContact,
    *,
    entrainment_speed: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    largest_gap: ArrayLike | None = None,
    compressible: bool = False,
) -> FilmAsymptotes:
    """The asymptotes that central_film joins, in logarithms; arguments and errors are those of central_film.

    Without speed all are -inf. Without load those of elastic bodies are inf. Without piezoviscosity the piezoviscous
    ones are -inf.
    """
    require_positive(viscosity=viscosity)
    require_non_negative(pressure_viscosity=pressure_viscosity)
    require_finite(entrainment_speed=entrainment_speed)
    if largest_gap is not None:
        require_positive(largest_gap=largest_gap)
    rolling, transverse, load, modulus = (
        np.asarray(value, dtype=np.float64)
        for value in (contact.curvature_rolling, contact.curvature_transverse, contact.load, contact.modulus)
    )
    stiff = 2 * modulus  # E'
    speed = 2 * np.abs(np.asarray(entrainment_speed, dtype=np.float64))
    try:
        ellipticity, log_rolling = transverse / rolling, np.log(rolling)
        log_stiff = np.log(stiff)
        with np.errstate(divide="ignore"):  # ln 0 where there is no load, no speed or no piezoviscosity
            log_u = np.log(speed) + np.log(viscosity) + log_rolling - log_stiff
            log_w = np.log(load) + 2 * log_rolling - log_stiff
            log_alpha = np.log(pressure_viscosity) + log_stiff
        moving = speed > 0
        log_u = np.where(moving, log_u, 0.0)
        log_m, log_l = log_w - 0.75 * log_u, log_alpha + log_u / 4
        scale = log_u / 2 - log_rolling  # ln of R_x U^(1/2)
        log_ratio = np.log(ellipticity)
        elastic = np.log1p(0.006 * log_ratio + 0.63 * ellipticity ** (4 / 7))
        log_ri = np.log(145) - 15 / 7 * np.log1p(0.796 * ellipticity ** (14 / 15)) - log_ratio - 2 * log_m
        log_rp = np.log(1.29) - 2 / 3 * np.log1p(0.691 * ellipticity) + 2 / 3 * log_l
        log_ei = np.log(3.18) - 14 / 25 * elastic - log_ratio / 15
        log_ep = np.log(1.48) - 7 / 20 * elastic - log_ratio / 24 + 3 / 4 * log_l
        with np.errstate(invalid="ignore"):  # inf - inf without load and piezoviscosity: H_EP is not used then
            log_ep_loaded = np.where(log_l == -np.inf, -np.inf, log_ep - log_m / 12)
        piezoviscous = -np.logaddexp(-8 * log_rp, -8 * log_ep_loaded) / 8
        clearance = -np.log(rolling + transverse)
        if largest_gap is not None:
            clearance = np.minimum(clearance, np.log(largest_gap))
        with np.errstate(divide="ignore"):  # without load there is no pressure
            peak_pressure = np.log(1.5 * contact.mean_pressure) if compressible else np.asarray(-np.inf)
        np.broadcast_shapes(clearance.shape, log_m.shape, log_l.shape)  # raises ValueError if shapes do not fit
        return FilmAsymptotes(
            rigid=np.where(moving, scale + log_ri, -np.inf),
            elastic=np.where(moving, scale + log_ei - 2 / 15 * log_m, -np.inf),
            unloaded=np.where(moving, scale + np.log(1.8) - log_ratio, -np.inf),
            piezoviscous=np.where(moving, scale + piezoviscous, -np.inf),
            # H_EI/H_EP as one expression: without load both are infinite, without piezoviscosity H_EP is 0.
            elastic_ratio=log_ei - log_ep - (2 / 15 - 1 / 12) * log_m,
            clearance=clearance,
            ellipticity=ellipticity,
            peak_pressure=peak_pressure,
        )
    except ValueError as problem:
        raise InputError(
            "the arguments of a film have shapes that do not fit together: give equal lengths"
        ) from problem


def density_ratio(pressure: ArrayLike) -> Array:
    """rho/rho_0 = (5.9e8 + 1.34 p)/(5.9e8 + p): density of an oil under the pressure p, Pa, >= 0, over that without.

    Source: [Dowson1966].
    """
    require_non_negative(pressure=pressure)
    p = np.asarray(pressure)
    return (5.9e8 + 1.34 * p) / (5.9e8 + p)


def minimum_ratio(
    contact: EllipticContact, *, entrainment_speed: ArrayLike, viscosity: ArrayLike, pressure_viscosity: ArrayLike
) -> Array:
    """Minimum over central film of a flooded contact, h_min/h, at most 1; fields and arguments broadcast.

    Arguments : as in central_film, with the semi-axes a (rolling) and b (transverse) too
    With E' = 2 E*, k = b/a, U = eta_0 |u|/(E' R_x), G = alpha_p E' and W = F/(E' R_x^2):
        (3.63/2.69) U^0.01 G^-0.04 W^-0.006 [1 - exp(-0.68 k)]/[1 - 0.61 exp(-0.73 k)]
    Without load, speed or piezoviscosity, where the fits have no meaning, it is 1. Source: [Hamrock1977].
    """
    require_positive(viscosity=viscosity)
    require_non_negative(pressure_viscosity=pressure_viscosity)
    require_finite(entrainment_speed=entrainment_speed)
    stiff, rolling = 2 * np.asarray(contact.modulus), np.asarray(contact.curvature_rolling)
    load, a = np.asarray(contact.load), np.asarray(contact.semi_axis_rolling)
    try:
        speed = np.asarray(viscosity) * np.abs(np.asarray(entrainment_speed)) * rolling / stiff
        material, relative_load = np.asarray(pressure_viscosity) * stiff, load * rolling**2 / stiff
        k = np.asarray(contact.semi_axis_transverse) / np.where(a > 0, a, 1.0)
        fits = (speed > 0) & (material > 0) & (relative_load > 0) & (k > 0)
        u, g, w = (np.where(fits, value, 1.0) for value in (speed, material, relative_load))
        ratio = 3.63 / 2.69 * u**0.01 * g**-0.04 * w**-0.006
        ratio = ratio * -np.expm1(-0.68 * k) / (1 - 0.61 * np.exp(-0.73 * k))
    except ValueError as problem:
        raise InputError(
            "the arguments of a film have shapes that do not fit together: give equal lengths"
        ) from problem
    return np.where(fits, np.minimum(ratio, 1.0), 1.0)


def inlet_heating_factor(
    *, peak_pressure: ArrayLike, modulus: ArrayLike, thermal_loading: ArrayLike, slide_to_roll: ArrayLike
) -> Array:
    """Film whose inlet is heated by its own shear, over the isothermal film, 0 to 1; the arguments broadcast.

    peak_pressure : p0, Pa, >= 0;  modulus : E*, Pa, > 0
    thermal_loading : L_t = eta_0 beta u^2/k_f, >= 0 (see `thermal_loading`)
    slide_to_roll : S, sliding over mean speed, >= 0
        [1 - 13.2 (p0/E') L_t^0.42]/[1 + 0.213 (1 + 2.23 S^0.83) L_t^0.64],  E' = 2 E*
    The numerator passes 0 near L_t = 160 at 2 GPa on steel; beyond that 0 is returned. The fit loses its meaning long
    before.
    Source: [Gupta1992].
    """
    require_non_negative(peak_pressure=peak_pressure, thermal_loading=thermal_loading, slide_to_roll=slide_to_roll)
    require_positive(modulus=modulus)
    loading, strain = np.asarray(thermal_loading), np.asarray(peak_pressure) / (2 * np.asarray(modulus))
    shear = 0.213 * (1 + 2.23 * np.asarray(slide_to_roll) ** 0.83) * loading**0.64
    return np.maximum(1 - 13.2 * strain * loading**0.42, 0.0) / (1 + shear)


def thermal_loading(
    *, viscosity: ArrayLike, viscosity_temperature: ArrayLike, entrainment_speed: ArrayLike, conductivity: ArrayLike
) -> Array:
    """L_t = eta_0 beta u^2/k_f: how much shear at the inlet heats the oil; the arguments broadcast.

    viscosity : eta_0, Pa s, > 0;  viscosity_temperature : beta = -d ln(eta)/dT, 1/K, >= 0
    entrainment_speed : u, m/s;  conductivity : k_f, of the oil, W/(m K), > 0
    """
    require_positive(viscosity=viscosity, conductivity=conductivity)
    require_non_negative(viscosity_temperature=viscosity_temperature)
    require_finite(entrainment_speed=entrainment_speed)
    heat = np.asarray(viscosity) * np.asarray(viscosity_temperature) * np.asarray(entrainment_speed) ** 2
    return heat / np.asarray(conductivity)
