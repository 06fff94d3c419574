"""Central film thickness of a fully flooded elliptic contact, and its reduction by heating of the inlet.

Entrainment is in the direction of rolling. The formula is a fit to numerical solutions and joins four asymptotes: rigid
or elastic bodies, each with oil of constant or of pressure-dependent viscosity. It assumes smooth bodies and an
isothermal oil. Compressible oil flows through the contact in the same mass, so its film is thinner by the density ratio
there. The torque takes it so, with the correction of `analytic.oil.ehl_fit`, which numerical solutions gave.
Source: [Nijenbanning1994]. The exponent s also appears with H_EI/H_RI in place of H_EI/H_EP, which changes the film by
5 to 8 %.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.rolling_contact import ContactNumbers, EllipticContact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.oil.asymptotes import FilmAsymptotes, Inflow, asymptotes_of, density_under
from analytic.scene import Array

# Standard deviation of ln(film). Measured films of circular contacts spread by 12 to 17 % in the logarithm; those of
# `validation/film` by 11 % where they are thick enough to be measured well. In the limit of a wide ellipse, and a race
# is near it, the formula lies within -8 to +1 % of a 1-D solution for incompressible oil.
FORMULA_UNCERTAINTY = 0.15
FILM_FACTORS = float(np.exp(-2 * FORMULA_UNCERTAINTY)), float(np.exp(2 * FORMULA_UNCERTAINTY))  # 95 %: 0.74 and 1.35


@dataclass(frozen=True, kw_only=True, eq=False)
class CentralFilm:
    """The film of one or many contacts; every field has the broadcast shape of the arguments."""

    thickness: Array  # h, m
    ellipticity: Array  # lambda = R_x/R_y
    capped: NDArray[np.bool_]  # the formula gave more than the clearance, and the thickness is the clearance
    outside_range: NDArray[np.bool_]  # ellipticity outside asymptotes.FITTED_ELLIPTICITY: the thickness is extrapolated


@compiled
def smallest_ratio(contact: ContactNumbers, inflow: Inflow) -> float:
    """h_min/h of `minimum_ratio`."""
    stiff, a = 2 * contact.modulus, contact.semi_axis_rolling
    u = inflow.viscosity * inflow.speed * contact.curvature_rolling / stiff
    g, w = inflow.pressure_viscosity * stiff, contact.load * contact.curvature_rolling**2 / stiff
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


@compiled
def heated_part(peak_pressure: float, modulus: float, loading: float, slide_to_roll: float) -> float:
    """Film over the isothermal one, as `inlet_heating_factor` says; loading : L_t."""
    log_loading = np.log(loading)
    shear = 0.213 * (1 + 2.23 * slide_to_roll**0.83) * np.exp(0.64 * log_loading)
    return max(1 - 13.2 * peak_pressure / (2 * modulus) * np.exp(0.42 * log_loading), 0.0) / (1 + shear)


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
    if largest_gap is not None:
        require_positive(largest_gap=largest_gap)
    limit = np.inf if largest_gap is None else largest_gap
    inflow = entrainment_speed, viscosity, pressure_viscosity, float(compressible), limit
    return FilmAsymptotes(*_of_inflow(asymptotes_of, contact, *inflow))


def _of_inflow(
    formula: Callable[[ContactNumbers, Inflow], Any],
    contact: EllipticContact,
    entrainment_speed: ArrayLike,
    viscosity: ArrayLike,
    pressure_viscosity: ArrayLike,
    *others: ArrayLike,
) -> Array:
    """The formula of each contact; others : the last fields of `Inflow`; arguments and errors of central_film."""
    require_positive(viscosity=viscosity)
    require_non_negative(pressure_viscosity=pressure_viscosity)
    require_finite(entrainment_speed=entrainment_speed)

    def of_numbers(*given: float) -> Any:
        speed, eta, alpha, compressible, limit = given[9:]
        return formula(ContactNumbers(*given[:9]), Inflow(speed, eta, alpha, compressible != 0, limit))

    try:
        return mapped(of_numbers, *contact.fields, np.abs(entrainment_speed), viscosity, pressure_viscosity, *others)
    except ValueError as problem:
        raise InputError(
            "the arguments of a film have shapes that do not fit together: give equal lengths"
        ) from problem


def density_ratio(pressure: ArrayLike) -> Array:
    """rho/rho_0 = (5.9e8 + 1.34 p)/(5.9e8 + p): density of an oil under the pressure p, Pa, >= 0, over that without.

    Source: [Dowson1966].
    """
    require_non_negative(pressure=pressure)
    return mapped(density_under, pressure)


def minimum_ratio(
    contact: EllipticContact, *, entrainment_speed: ArrayLike, viscosity: ArrayLike, pressure_viscosity: ArrayLike
) -> Array:
    """Minimum over central film of a flooded contact, h_min/h, at most 1; fields and arguments broadcast.

    Arguments : as in central_film, with the semi-axes a (rolling) and b (transverse) too
    With E' = 2 E*, k = b/a, U = eta_0 |u|/(E' R_x), G = alpha_p E' and W = F/(E' R_x^2):
        (3.63/2.69) U^0.01 G^-0.04 W^-0.006 [1 - exp(-0.68 k)]/[1 - 0.61 exp(-0.73 k)]
    Without load, speed or piezoviscosity, where the fits have no meaning, it is 1. Source: [Hamrock1977].
    """
    return _of_inflow(smallest_ratio, contact, entrainment_speed, viscosity, pressure_viscosity, 0.0, np.inf)


def inlet_heating_factor(
    *, peak_pressure: ArrayLike, modulus: ArrayLike, thermal_loading: ArrayLike, slide_to_roll: ArrayLike
) -> Array:
    """Film whose inlet is heated by its own shear, over the isothermal film, 0 to 1; the arguments broadcast.

    peak_pressure : p0, Pa, >= 0;  modulus : E*, Pa, > 0
    thermal_loading : L_t = eta_0 beta u^2/k_f, >= 0 (see `shear_heat`)
    slide_to_roll : S, sliding over mean speed, >= 0
        [1 - 13.2 (p0/E') L_t^0.42]/[1 + 0.213 (1 + 2.23 S^0.83) L_t^0.64],  E' = 2 E*
    The numerator passes 0 near L_t = 160 at 2 GPa on steel; beyond that 0 is returned. The fit loses its meaning long
    before.
    Source: [Gupta1992].
    """
    require_non_negative(peak_pressure=peak_pressure, thermal_loading=thermal_loading, slide_to_roll=slide_to_roll)
    require_positive(modulus=modulus)
    return mapped(heated_part, peak_pressure, modulus, thermal_loading, slide_to_roll)
