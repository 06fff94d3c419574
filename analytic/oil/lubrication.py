"""A lubricated contact of a ball with its race: film, shared load, traction and resistance to rolling."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.oil.ehl_coefficients import RANGES
from analytic.oil.ehl_fit import OilSupply, Regime, covered, film_correction, fitted_force, regime_of
from analytic.oil.film import FITTED_ELLIPTICITY, Inflow, asymptotes_of, thinned
from analytic.oil.inlets import InletNumbers, inflow_of, inlet_of
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.rolling import houpert_rolling, hydrodynamic_rolling
from analytic.oil.traction import PointLaw, mixed_traction
from analytic.oil.variation import FIT_SHARE, Variation
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Array, Lubricant
from analytic.surface.gap import SMOOTH, GapForm, GapNumbers

# R_x/R_y of the numerical solutions. Their correction of the closed formula, whose range ends at 0.03, changes by 1.2 %
# at most down to here; below, its limit of an endless ellipse is known: `analytic.oil.film.FORMULA_UNCERTAINTY`.
LEAST_SOLVED = RANGES["ellipticity"][0]
SHORTEST = 3.0  # semi-axes: with less oil ahead the elastic gap is below that of the fit's far field


class Lubrication(NamedTuple):
    """What all contacts of a race share besides the oil, and what counts in them."""

    gap: GapForm
    boundary_friction: float
    supply: OilSupply
    asperities: bool  # they carry load
    heats: bool  # shear heats the inlets
    starves: bool  # oil does not return in time
    film: float  # factors on what the formulas give
    traction: float
    asperity_pressure: float
    share_step: float  # towards the measured share of asperities, see `mixed.stepped_share`
    rolling: float
    rolling_error: float  # of the closed formula; the fit has the power FIT_SHARE of it
    heating: float  # power of the factors for heating
    film_is_fitted: bool  # else by Nijenbanning
    rolling_is_fitted: bool  # else by Houpert, or by Biboulet
    houpert: bool


class LubricatedContact(NamedTuple):
    """A contact at its speed."""

    mixed: MixedContact
    law: PointLaw
    inlet: InletNumbers
    rolling_torque: float  # about the bearing axis, N m
    film_extrapolated: bool  # the ellipse is not of a shape that the film formula was fitted to
    # Longer along rolling than across, so fast that rigid bodies resist less, or with little oil ahead
    rolling_extrapolated: bool


@compiled
def rolling_force_of(
    contact: ContactNumbers, inflow: Inflow, regime: Regime, supply: OilSupply, fitted: bool, houpert: bool
) -> tuple[float, float, bool]:
    """f of a flooded, isothermal contact, N; the share of the fit in it; whether the closed formula is extrapolated.

    fitted, houpert : as `Lubrication` has them;  the other arguments as in `rolling_torque_of`
    """
    share = covered(regime) if fitted else 0.0
    force, outside = 0.0, False
    if share < 1.0:
        if houpert:
            found = houpert_rolling(contact, inflow.viscosity, inflow.pressure_viscosity, inflow.speed)
        else:
            found = hydrodynamic_rolling(contact, inflow.viscosity, inflow.speed)
        force, outside = found.force, found.outside_range
    if share > 0.0:
        force += share * (fitted_force(contact, inflow, regime, supply) - force)
    return force, share, outside


@compiled
def rolling_torque_of(
    contact: ContactNumbers,
    oil: OilNumbers,
    inlet: InletNumbers,
    lubrication: Lubrication,
    regime: Regime,
    ring_speed: float,
) -> tuple[float, bool]:
    """Torque by hydrodynamic rolling about the bearing axis, N m, and whether the formula is extrapolated.

    regime : of the contact at its speed; the other arguments as in `lubricated_contact`
    """
    inflow = inflow_of(contact, oil, ring_speed)
    force, share, outside = rolling_force_of(
        contact, inflow, regime, lubrication.supply, lubrication.rolling_is_fitted, lubrication.houpert
    )
    left = lubrication.rolling * lubrication.rolling_error ** (1 - share * (1 - FIT_SHARE))
    if lubrication.heats:
        left *= inlet.rolling_heating**lubrication.heating
    if lubrication.starves:
        left *= inlet.starvation.rolling_factor
    longer = contact.curvature_rolling < contact.curvature_transverse
    short = share > 0.0 and lubrication.supply.ahead < SHORTEST * contact.semi_axis_rolling
    return left * 2.0 * force * contact.entrainment, outside or longer or short


@compiled
def lubricated_contact(
    contact: ContactNumbers,
    peak_pressure: float,
    oil: OilNumbers,
    lubrication: Lubrication,
    cubics: Array,
    ring_speed: float,
) -> LubricatedContact:
    """A contact of a ball with its race in oil.

    cubics : the splines of the gap law
    peak_pressure : p0, Pa;  ring_speed : w, rad/s, of either sign
    mixed.asperity_share of NaN: the root was not found
    """
    inflow = inflow_of(contact, oil, ring_speed)
    film, regime = asymptotes_of(contact, inflow), regime_of(contact, inflow)
    if lubrication.film_is_fitted:
        film = thinned(film, film_correction(regime))
    inlet = inlet_of(contact, peak_pressure, oil, film, lubrication.supply, regime, ring_speed)
    thinner = lubrication.film
    if lubrication.heats:
        thinner *= inlet.film_heating**lubrication.heating
    if lubrication.starves:
        thinner *= inlet.starvation.film_factor
    kind = lubrication.gap.kind if lubrication.asperities else SMOOTH
    gap = GapNumbers(kind, cubics, lubrication.gap.truncated, lubrication.gap.elastic)
    mixed = mixed_contact(contact, film, gap, thinner, lubrication.asperity_pressure, lubrication.share_step)
    rolling, rolling_extrapolated = rolling_torque_of(contact, oil, inlet, lubrication, regime, ring_speed)
    return LubricatedContact(
        mixed,
        mixed_traction(oil, lubrication.boundary_friction, mixed, lubrication.traction),
        inlet,
        rolling,
        film.ellipticity > FITTED_ELLIPTICITY[1]
        or film.ellipticity < (LEAST_SOLVED if lubrication.film_is_fitted else FITTED_ELLIPTICITY[0]),
        rolling_extrapolated,
    )


def lubrication_of(
    gap: GapForm,
    supply: OilSupply,
    lubricant: Lubricant,
    *,
    boundary_friction: float,
    is_on: Callable[[str], bool],
    variation: Variation,
) -> Lubrication:
    """What counts in the contacts of a race.

    gap : of ball and race;  supply : of the bearing;  is_on : whether an effect counts
    """
    still = 1.0 - min(max(variation.starvation, -1.0), 1.0)  # power of the replenishment factor
    known = supply.churned or not (np.isnan(supply.degree) and np.isnan(supply.rate))
    return Lubrication(
        gap=gap,
        boundary_friction=float(boundary_friction),
        supply=supply._replace(grease_film=float(np.log(variation.grease_film)), rate=still * supply.rate),
        asperities=is_on("asperities"),
        heats=is_on("inlet_heating"),
        starves=is_on("starvation") and known,
        film=variation.film,
        traction=variation.traction,
        asperity_pressure=variation.asperity_pressure,
        share_step=variation.asperity_share,
        rolling=variation.rolling,
        rolling_error=variation.rolling_error,
        heating=variation.heating,
        film_is_fitted=lubricant.film_formula == "numerical",
        rolling_is_fitted=lubricant.rolling_formula == "numerical",
        houpert=lubricant.rolling_formula == "houpert",
    )
