"""Laws of traction: Coulomb friction, or oil together with asperities.

A law gives the stress that resists sliding at one point of a contact, and the force of a contact that slides everywhere
at one speed under its mean pressure. Without sliding the stress is the limit of slow sliding. Coulomb friction and
`eyring_constant` then jump with the direction of sliding; only an integral over the contact smooths this jump.
Source: oil by [Eyring1936], with a limit as in [Bair1979] and the Eyring stress of [Arana2019], equations 12 and 13:
    tau = min(tau_E asinh(eta(p) v/(h tau_E)), Lambda p),  tau_E = 2 Lambda/alpha(p),  alpha(p) = ln(eta(p)/eta_0)/p
The source takes pressure and alpha of the whole contact, its mean and its Hertz pressure; here both are those of each
point. Traction measured with two discs at 1 GPa and 60 degC was within 0.005 of it for three oils, and within 10 % at
high speed and slip. Above some 0.6 GPa the viscosities are extrapolated, which changes little where the stress is near
its limit, as that of mineral oil, and much with PAO. Shear heating within the film is left out: it lowers the stress
where sliding is fast.
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import Finite, NotNegative, formula
from analytic.oil.law_table import FASTEST
from analytic.oil.law_table import flow_of as flow_of  # for the reference of friction
from analytic.oil.mixed import MixedContact, oil_beside
from analytic.oil.viscosity import OilNumbers, thickening_at

LEAST_THICKENING = 1e-25  # 1/Pa, of alpha: an oil that does not thicken is Newtonian up to its limit


class PointLaw(NamedTuple):
    """A law of traction in numbers: at the pressure p and the slip speed v the stress is

        boundary p + plain + min(rise eyring f(fluidity v eta/eta_0/rise), limit p), f = asinh or a user's law

    with eta/eta_0 and alpha over its secant, rise, by `thickening_at` at the pressure share p; the rise of a given
    Eyring stress is 1.
    """

    boundary: float = 0.0
    plain: float = 0.0  # Pa
    limit: float = 0.0
    eyring: float = 0.0  # Pa, at ambient pressure; 0: nothing depends on the speed
    fluidity: float = 0.0  # s/m, at ambient pressure; infinite: the oil shears at its limit
    share: float = 0.0  # of the pressure, in the oil
    alpha: float = 0.0  # 1/Pa, at ambient pressure
    bend: float = 0.0  # 1/Pa
    exponent: float = 0.0
    rises: float = 0.0  # 1: the Eyring stress follows the pressure;  0: it is given
    own: float = 0.0  # address of the table of a user's law, see `analytic.oil.law_table`; 0: Eyring's law


@compiled
def flow_under(law: PointLaw, pressure: float) -> tuple[float, float]:
    """Fluidity, s/m, and Eyring stress, Pa, of a law with oil at the pressure p, Pa."""
    if law.alpha == 0.0:
        return law.fluidity, law.eyring
    log, rise = thickening_at(law.alpha, law.bend, law.exponent, law.share * pressure)
    rise = rise if law.rises != 0.0 else 1.0
    return law.fluidity * np.exp(log) / rise, law.eyring * rise


@compiled
def thickened(law: PointLaw, pressure: float) -> PointLaw:
    """The law at the pressure p, Pa, with the oil as thick as it is there."""
    fluidity, eyring = flow_under(law, pressure)
    return PointLaw(law.boundary, law.plain, law.limit, eyring, fluidity, law.share, 0.0, 0.0, 0.0, 0.0, law.own)


@formula
def stress_and_slope(law: PointLaw, pressure: float, speed: float) -> tuple[float, float]:
    """Stress of a `PointLaw`, Pa, and its slope over the speed, Pa s/m; pressure : p, Pa;  speed : v, m/s.

    Loops choose between both functions themselves: what LLVM makes of Eyring's law then stays as quick as it was.
    """
    return eyring_stress(law, pressure, speed) if law.own == 0.0 else own_stress(law, pressure, speed)


@compiled
def eyring_stress(law: PointLaw, pressure: float, speed: float) -> tuple[float, float]:
    """`stress_and_slope` of a law without a table."""
    steady = law.boundary * pressure + law.plain
    if law.eyring == 0.0:
        return steady, 0.0
    limit = law.limit * pressure
    if law.fluidity == np.inf:
        return steady + limit, 0.0
    fluidity, eyring = flow_under(law, pressure)
    rate = fluidity * speed if speed > 0.0 else 0.0  # also of a film so thin that the fluidity overflows
    oil = eyring * np.arcsinh(rate)
    if not oil < limit:
        return steady + limit, 0.0
    return steady + oil, eyring * fluidity / np.sqrt(1.0 + rate * rate)


@compiled
def own_stress(law: PointLaw, pressure: float, speed: float) -> tuple[float, float]:
    """`stress_and_slope` of a user's law. Oil without a film shears at the limit, or at the most that the law gives."""
    steady, limit = law.boundary * pressure + law.plain, law.limit * pressure
    fluidity, eyring = flow_under(law, pressure)
    fluidity = min(fluidity, FASTEST)
    rate = min(fluidity * max(speed, 0.0), FASTEST) if law.fluidity < np.inf else FASTEST
    flow, slope = flow_of(law.own, rate)
    oil = eyring * flow
    return (steady + oil, eyring * fluidity * slope) if oil < limit else (steady + limit, 0.0)


@compiled
def with_numbers(law: PointLaw, boundary: float, fluidity: float) -> PointLaw:
    """The law with another friction coefficient of its asperities, and another fluidity at ambient pressure, s/m."""
    oil = law.share, law.alpha, law.bend, law.exponent, law.rises, law.own
    return PointLaw(boundary, law.plain, law.limit, law.eyring, fluidity, *oil)


@formula
def mean_force(law: PointLaw, contact: ContactNumbers, speed: float) -> float:
    """Friction of a contact that slides everywhere at the speed |v|, m/s, under its mean pressure, N."""
    area = np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse
    if area == 0.0:
        return law.boundary * contact.load
    oil = with_numbers(law, 0.0, law.fluidity)
    return law.boundary * contact.load + area * stress_and_slope(oil, contact.load / area, speed)[0]


@compiled
def law_of_oil(oil: OilNumbers, boundary: float, share: float, area: float, thickness: float) -> PointLaw:
    """Oil on a share of the pressure and of the area; boundary : friction coefficient of the rest, over all pressure.

    thickness : of the oil, m; at 0 and below it shears at its limit
    """
    if oil.constant_stress:
        return PointLaw(boundary, oil.eyring_stress * area, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    alpha, stress, rises = max(oil.pressure_viscosity, LEAST_THICKENING), oil.eyring_stress, 0.0
    if stress == 0.0:
        stress, rises = 2.0 * oil.limiting_shear / alpha, 1.0
    limit, bend = oil.limiting_shear * share * area, oil.rise * alpha
    fluidity = oil.viscosity / stress / thickness if thickness > 0.0 and stress > 0.0 else np.inf
    return PointLaw(boundary, 0.0, limit, stress * area, fluidity, share, alpha, bend, oil.exponent, rises, oil.own)


@formula
def mixed_traction(oil: OilNumbers, boundary_friction: float, shared: MixedContact, factor: float) -> PointLaw:
    """The law of a mixed contact: boundary friction on a share of the load, oil on the rest of load and area.

    The oil shears where neither asperities touch nor its film is a molecule thick. It carries the share 1 - s of the
    pressure, which determines its viscosity and its limit.
    boundary_friction : mu_b, >= 0;  factor : on the shear stress of the oil
    """
    area, thickness = oil_beside(shared)
    boundary = boundary_friction * shared.boundary_share
    return law_of_oil(oil, boundary, 1.0 - shared.asperity_share, factor * area, thickness)


@formula
def oil_shear_stress(oil: OilNumbers, pressure: NotNegative, speed: NotNegative, film_thickness: Finite) -> float:
    """Shear stress tau of the oil between surfaces that slide past each other, Pa.

    pressure : p, of the oil, Pa, >= 0;  speed : |v|, m/s, >= 0;  film_thickness : h, m; at 0 and below there is no film
    `eyring_constant`: the given tau_E at any speed, and in the limit of no sliding too.
    `eyring_sinh`: the smaller of tau_E asinh(eta(p, T) |v|/(h tau_E)), with the viscosity at the temperature of the
    inlet, and Lambda p; without a film Lambda p. tau_E is the given one at any pressure, else 2 Lambda/alpha(p).
    Measurements support each expression where the other one is much larger. The smaller one keeps both, never falls
    with |v| and has only a kink. A smooth transition would assume a lower stress between them.
    A user's law (`analytic.oil.own_law`): the same with f in place of asinh; without a film the smaller of Lambda p
    and the most that the law gives.
    Source and range: see the module.
    """
    return stress_and_slope(law_of_oil(oil, 0.0, 1.0, 1.0, film_thickness), pressure, speed)[0]
