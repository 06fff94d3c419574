"""Laws of traction: Coulomb friction, or oil together with asperities.

A law gives the stress that resists sliding at one point of a contact, and the force of a contact that slides everywhere
at one speed under its mean pressure. Without sliding the stress is the limit of slow sliding. Coulomb friction and
`eyring_constant` then jump with the direction of sliding; only an integral over the contact smooths this jump.
Source: oil by [Eyring1936], with a limit as in [Bair1979].
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.oil.mixed import MixedContact
from analytic.oil.viscosity import viscosity_under_pressure
from analytic.scene import Array, Lubricant

MOST_THICKENING = 600.0  # in the logarithm: such an oil is solid


@dataclass(frozen=True, kw_only=True, eq=False)
class PointLaw:
    """A law of traction in numbers, for compiled loops: at the pressure p and the slip speed v the stress is

        boundary p + plain + min(eyring asinh(fluidity v eta(share p)/eta(0)), limit p)

    with eta from `log_thickening`; the fields broadcast.
    """

    boundary: Array | float = 0.0
    plain: Array | float = 0.0  # Pa
    limit: Array | float = 0.0
    eyring: Array | float = 0.0  # Pa; 0: nothing depends on the speed
    fluidity: Array | float = 0.0  # s/m; infinite: the oil shears at its limit
    share: Array | float = 0.0  # of the pressure, in the oil
    lubricant: Lubricant | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class CoulombTraction:
    """mu times the pressure, at any speed."""

    friction_coefficient: Array | float  # mu, >= 0

    def __post_init__(self) -> None:
        require_non_negative(friction_coefficient=self.friction_coefficient)

    def stress(self, pressure: Array, speed: Array) -> Array:  # noqa: ARG002
        """mu p, Pa; the arguments broadcast with mu."""
        return np.asarray(self.friction_coefficient) * pressure

    @property
    def depends_on_speed(self) -> bool:
        return False

    @property
    def point_law(self) -> PointLaw:
        return PointLaw(boundary=self.friction_coefficient)

    def force(self, contact: EllipticContact) -> Callable[[Array], Array]:
        """mu Q, N, as a function of the speed; the contact broadcasts with mu."""
        friction = np.asarray(self.friction_coefficient) * np.asarray(contact.load)
        return lambda _: friction


@dataclass(frozen=True, kw_only=True, eq=False)
class MixedTraction:
    """Boundary friction on a share of the load, oil on the rest of load and area; the fields broadcast.

    The oil carries the share 1 - s of the pressure, which determines its viscosity and its limit.
    `mixed_traction` makes one from a mixed contact.
    """

    lubricant: Lubricant
    boundary_friction: Array | float  # mu_b, >= 0
    asperity_share: Array | float  # s, 0 to 1
    boundary_share: Array | float  # s_b, 0 to 1
    oil_area: Array | float  # share of the area where oil shears, 0 to 1
    oil_thickness: Array | float  # of the oil there, m; at 0 and below it shears at its limit

    def __post_init__(self) -> None:
        parts = {
            "asperity_share": self.asperity_share,
            "boundary_share": self.boundary_share,
            "oil_area": self.oil_area,
        }
        require_non_negative(boundary_friction=self.boundary_friction, **parts)
        for name, part in parts.items():
            if np.any(np.asarray(part) > 1):
                raise InputError(f"{name} must be at most 1, got {np.max(part):g}: it is a part of a whole")

    @property
    def depends_on_speed(self) -> bool:
        return self.lubricant.traction != "eyring_constant"

    def stress(self, pressure: Array, speed: Array) -> Array:
        """mu_b s_b p + tau A_oil/A_H, Pa; pressure p >= 0, Pa, and speed |v|, m/s, broadcast with the fields."""
        oil = _oil_shear(self.lubricant, (1 - np.asarray(self.asperity_share)) * pressure, self.oil_thickness)(speed)
        return np.asarray(self.boundary_friction) * self.boundary_share * pressure + oil * self.oil_area

    @property
    def point_law(self) -> PointLaw:
        lubricant, area = self.lubricant, np.asarray(self.oil_area)
        boundary = np.asarray(self.boundary_friction) * self.boundary_share
        if not self.depends_on_speed:
            return PointLaw(boundary=boundary, plain=lubricant.eyring_stress * area)
        thickness, share = np.asarray(self.oil_thickness), 1 - np.asarray(self.asperity_share)
        flows = viscosity_under_pressure(lubricant)(np.zeros(())) / lubricant.eyring_stress
        return PointLaw(
            boundary=boundary,
            limit=lubricant.limiting_shear * share * area,
            eyring=lubricant.eyring_stress * area,
            fluidity=np.divide(flows, thickness, out=np.full(thickness.shape, np.inf), where=thickness > 0),
            share=share,
            lubricant=lubricant,
        )

    def force(self, contact: EllipticContact) -> Callable[[Array], Array]:
        """mu_b s_b Q + tau A_oil, N, as a function of the speed |v|, m/s, with tau at the mean pressure Q/A_H.

        The contact broadcasts with the fields. It is a force because the coefficient has no limit at Q = 0.
        """
        oil_pressure = (1 - np.asarray(self.asperity_share)) * contact.mean_pressure
        shear = _oil_shear(self.lubricant, oil_pressure, self.oil_thickness)
        boundary = np.asarray(self.boundary_friction) * self.boundary_share * np.asarray(contact.load)
        wetted = self.oil_area * contact.area
        return lambda speed: boundary + shear(speed) * wetted


def mixed_traction(lubricant: Lubricant, boundary_friction: float, shared: MixedContact) -> MixedTraction:
    """The law of a mixed contact: oil shears where neither asperities touch nor its film is a molecule thick."""
    return MixedTraction(
        lubricant=lubricant,
        boundary_friction=boundary_friction,
        asperity_share=shared.asperity_share,
        boundary_share=shared.boundary_share,
        oil_area=shared.oil_area,
        oil_thickness=shared.oil_thickness,
    )


Traction = CoulombTraction | MixedTraction


def log_thickening(lubricant: Lubricant, pressure: Array) -> Array:
    """ln(eta(p)/eta(0)) of the oil at its temperature, at most MOST_THICKENING; pressure : p, Pa, >= 0."""
    viscosity = viscosity_under_pressure(lubricant)
    return np.minimum(np.log(viscosity(pressure) / viscosity(np.zeros(()))), MOST_THICKENING)


def oil_shear_stress(
    lubricant: Lubricant, *, pressure: ArrayLike, speed: ArrayLike, film_thickness: ArrayLike
) -> Array:
    """Shear stress tau of the oil between surfaces that slide past each other, Pa; the arguments broadcast.

    pressure : p, of the oil, Pa, >= 0;  speed : |v|, m/s, >= 0;  film_thickness : h, m; at 0 and below there is no film
    `eyring_constant`: tau_E at any speed, and in the limit of no sliding too.
    `eyring_sinh`: the smaller of tau_E asinh(eta(p, T) |v|/(h tau_E)), with Roelands' viscosity at the temperature of
    the inlet, and zeta p; without a film zeta p. Measurements support each expression where the other one is much
    larger. The smaller one keeps both, never falls with |v| and has only a kink. A smooth transition would assume a
    lower stress between them.
    Shear heating within the film is left out; it lowers tau where sliding is fast.
    """
    require_non_negative(pressure=pressure, speed=speed)
    try:
        return _oil_shear(lubricant, np.asarray(pressure), np.asarray(film_thickness))(np.asarray(speed))
    except ValueError as problem:
        if isinstance(problem, InputError):
            raise
        raise InputError("pressure, speed and film have shapes that do not fit: give equal lengths") from problem


def _oil_shear(lubricant: Lubricant, pressure: Array, film_thickness: ArrayLike) -> Callable[[Array], Array]:
    """oil_shear_stress as a function of the speed, which is not checked; the viscosity is computed once."""
    require_positive(eyring_stress=lubricant.eyring_stress)
    require_non_negative(limiting_shear=lubricant.limiting_shear)
    eyring = lubricant.eyring_stress
    if lubricant.traction == "eyring_constant":
        return lambda speed: np.full(np.broadcast(pressure, speed, film_thickness).shape, eyring)
    if lubricant.traction != "eyring_sinh":
        raise InputError(f'traction must be "eyring_sinh" or "eyring_constant", got {lubricant.traction!r}')
    film, limit = np.maximum(film_thickness, 0.0), lubricant.limiting_shear * pressure
    fluidity = viscosity_under_pressure(lubricant)(pressure) / eyring

    def shear(speed: Array) -> Array:
        with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # solid oil or no film: the limit holds
            rate = speed / film * fluidity
        rate = np.where(np.isnan(rate), np.where(film > 0, 0.0, np.inf), rate)
        return np.minimum(eyring * np.arcsinh(rate), limit)

    return shear
