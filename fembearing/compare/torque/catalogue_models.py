"""Two empirical models of friction torque from bearing catalogues: a band of values, not a reference.

They hold for an open deep-groove ball bearing of series 62, one row, without seals. Both are fits to unpublished tests,
and under pure thrust they differ by factors. They show the order of magnitude; neither checks nor validates anything.
The formulas take their printed units: mm, mm^2/s, rev/min, N and N mm.
Sources: [SKF2018], chapter on friction (an older edition has 0.15 for mu_bl), and [Palmgren1959].
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.oil.rolling import (
    inlet_shear_factor,
    per_minute,
    replenishment_factor,
    ring_diameters,
    square_millimetres,
)
from analytic.oil.viscosity import inlet_viscosity
from analytic.scene import Array, Scene, Supply

ROLLING = (3.9e-7, 1.7)  # R_1, R_2 of series 62
SLIDING = (3.23e-3, 36.5)  # S_1, S_2 of series 62
BOUNDARY_FRICTION = 0.12  # mu_bl
FILM_FRICTION = 0.05  # mu_EHL, mineral oil
PALMGREN_VISCOUS = 2.0  # f_0
PALMGREN_LOAD = (4e-4, 6e-4)  # z of f_1 = z (P_0/C_0)^0.55
# Series 62, bore to outside diameter, mm: boundary dimensions of [ISO15].
SERIES_62 = {
    10: 30,
    12: 32,
    15: 35,
    17: 40,
    20: 47,
    25: 52,
    30: 62,
    35: 72,
    40: 80,
    45: 85,
    50: 90,
    55: 100,
    60: 110,
    65: 120,
    70: 125,
    75: 130,
    80: 140,
    85: 150,
    90: 160,
    95: 170,
    100: 180,
}
SAME_SIZE = 0.05  # mm, many times what makers' tolerances are


class CatalogueCase(NamedTuple):
    """A bearing and how it runs, as both models need it; all fields broadcast."""

    bore_diameter: ArrayLike  # d, m
    outside_diameter: ArrayLike  # D > d, m
    static_rating: ArrayLike  # C_0, N, > 0
    axial_load: ArrayLike  # F_a, N, >= 0
    radial_load: ArrayLike  # F_r, N, >= 0
    ring_speed: ArrayLike  # |w|, rad/s, >= 0
    kinematic_viscosity: ArrayLike  # nu at running temperature, m^2/s, > 0


@dataclass(frozen=True, kw_only=True, eq=False)
class CatalogueBand:
    """Torques of one bearing about its axis, N m; every array has the broadcast shape of the case."""

    low: Array  # the least of the values
    high: Array  # the largest of them
    values: Mapping[str, Array]  # by name of the model


def scene_band(scene: Scene) -> CatalogueBand:
    """The band at every operating point of a scene, with the oil at its inlet temperature; arrays (n,).

    Raises InputError in one line, the reason for which there is no band: no oil, rating or ring diameter, another
    series of bearings, a moment or a thrust below 0. That the bearing is a deep-groove one is taken for granted:
    angular-contact bearings have the same boundary dimensions.
    """
    bearing, operation, oil = scene.bearing, scene.operation, scene.lubricant
    if oil is None:
        raise InputError("no lubricant is given: add a table [lubricant]")
    bore, outside, rating = bearing.bore_diameter, bearing.outside_diameter, bearing.static_load_rating
    for name, value in (("bore_diameter", bore), ("outside_diameter", outside), ("static_load_rating", rating)):
        if value is None:
            raise InputError(f"bearing.{name} is not given")
    assert bore is not None
    assert outside is not None
    assert rating is not None
    of_series = SERIES_62.get(round(1e3 * bore), 0.0)
    if max(abs(1e3 * bore - round(1e3 * bore)), abs(1e3 * outside - of_series)) > SAME_SIZE:
        raise InputError(
            f"bore {1e3 * bore:g} mm and outside diameter {1e3 * outside:g} mm are not of series 62, for which its "
            "constants are"
        )
    if np.any(operation.moment):
        raise InputError("operation.moment is not 0, and neither model knows moments")
    axial, radial = np.asarray(operation.axial_load), np.abs(operation.radial_load)
    if np.any(axial < 0):
        raise InputError(f"operation.axial_load = {axial.min():g} N is below 0")
    case = CatalogueCase(
        bore_diameter=bore,
        outside_diameter=outside,
        static_rating=rating,
        axial_load=axial,
        radial_load=radial,
        ring_speed=np.abs(operation.inner_speed),
        kinematic_viscosity=inlet_viscosity(oil).viscosity / oil.density,
    )
    return catalogue_band(case, lubrication=oil.supply)


def catalogue_band(case: CatalogueCase, *, lubrication: Supply) -> CatalogueBand:
    """Both models, Palmgren's with the least and the largest of his usual load factors."""
    values = {"SKF": skf_torque(case, lubrication=lubrication)}
    for factor in PALMGREN_LOAD:
        values[f"Palmgren, z = {factor:g}"] = palmgren_torque(case, load_factor=factor)
    values = dict(zip(values, np.broadcast_arrays(*values.values()), strict=True))
    every = np.array(list(values.values()))
    return CatalogueBand(low=every.min(axis=0), high=every.max(axis=0), values=MappingProxyType(values))


def skf_torque(case: CatalogueCase, *, lubrication: Supply) -> Array:
    """SKF's rolling and sliding torque M_rr + M_sl, N m, without seals and drag.

    With d_m = (d + D)/2, n in rev/min, and alpha_F = 24.6 (F_a/C_0)^0.24 degrees:
        G_rr = R_1 d_m^1.96 (F_r + R_2 F_a/sin alpha_F)^0.54
        G_sl = S_1 d_m^-0.145 (F_r^5 + S_2 d_m^1.5 F_a^4/sin alpha_F)^(1/3),  but S_1 d_m^-0.26 F_r^(5/3) if F_a = 0
        M_rr = phi_ish phi_rs G_rr (nu n)^0.6
        M_sl = G_sl [phi_bl mu_bl + (1 - phi_bl) mu_EHL],  phi_bl = exp(-2.6e-8 (n nu)^1.4 d_m)
    The two forms of G_sl do not meet: at F_a = 0 it jumps by d_m^0.115, 1.52 for a 6205. For F_a up to about C_0/2 and
    normal clearance.
    Raises InputError for an argument of the wrong sign or not finite, and for a bore no smaller than the outside.
    """
    bore, outside = ring_diameters(case.bore_diameter, case.outside_diameter)
    load, thrust, oil, speed = _operation(case)
    mean = (bore + outside) / 2
    angle = np.deg2rad(24.6 * (thrust / np.asarray(case.static_rating)) ** 0.24)
    steep = np.where(thrust > 0, np.sin(angle), 1.0)  # F_a/sin alpha_F falls to 0 with F_a
    rolling = ROLLING[0] * mean**1.96 * (load + ROLLING[1] * thrust / steep) ** 0.54
    sliding = SLIDING[0] * np.where(
        thrust > 0,
        mean**-0.145 * np.cbrt(load**5 + SLIDING[1] * mean**1.5 * thrust**4 / steep),
        mean**-0.26 * load ** (5 / 3),
    )
    rolling = rolling * (oil * speed) ** 0.6
    rolling = rolling * inlet_shear_factor(
        mean_diameter=mean / 1e3, ring_speed=case.ring_speed, kinematic_viscosity=case.kinematic_viscosity
    )
    rolling = rolling * replenishment_factor(
        bore_diameter=case.bore_diameter,
        outside_diameter=case.outside_diameter,
        ring_speed=case.ring_speed,
        kinematic_viscosity=case.kinematic_viscosity,
        supply=lubrication,
    )
    boundary = np.exp(-2.6e-8 * (speed * oil) ** 1.4 * mean)
    friction = boundary * BOUNDARY_FRICTION + (1 - boundary) * FILM_FRICTION
    return (rolling + sliding * friction) / 1e3  # N mm to N m


def palmgren_torque(case: CatalogueCase, *, load_factor: ArrayLike) -> Array:
    """Palmgren's torque M_0 + M_1, N m; load_factor is z, > 0, and broadcasts with the case.

    M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3 from nu n = 2000 on, below it 160e-7 f_0 d_m^3 (a jump of 0.8 %), f_0 = 2
    M_1 = z (P_0/C_0)^0.55 P_1 d_m,  P_1 = max(3.3 F_a - 0.1 F_r, F_r),  P_0 = max(0.6 F_r + 0.5 F_a, F_r)
    M_0 does not end at standstill: it is meant for bearings that turn at ordinary speed under ordinary load.
    """
    require_positive(load_factor=load_factor)
    bore, outside = ring_diameters(case.bore_diameter, case.outside_diameter)
    load, thrust, oil, speed = _operation(case)
    mean = (bore + outside) / 2
    stirred = oil * speed
    viscous = PALMGREN_VISCOUS * mean**3 * np.where(stirred >= 2000, 1e-7 * stirred ** (2 / 3), 160e-7)
    static = np.maximum(0.6 * load + 0.5 * thrust, load)
    working = np.maximum(3.3 * thrust - 0.1 * load, load)
    loaded = np.asarray(load_factor) * (static / np.asarray(case.static_rating)) ** 0.55 * working * mean
    return (viscous + loaded) / 1e3  # N mm to N m


def _operation(case: CatalogueCase) -> tuple[Array, Array, Array, Array]:
    """F_r and F_a in N, nu in mm^2/s, n in rev/min."""
    require_positive(static_rating=case.static_rating, kinematic_viscosity=case.kinematic_viscosity)
    require_non_negative(axial_load=case.axial_load, radial_load=case.radial_load, ring_speed=case.ring_speed)
    load, thrust = np.asarray(case.radial_load, dtype=np.float64), np.asarray(case.axial_load, dtype=np.float64)
    return load, thrust, square_millimetres(case.kinematic_viscosity), per_minute(case.ring_speed)
