"""Three empirical models of friction torque from bearing catalogues: a band of values, not a reference.

They hold for open bearings of one row, without seals: deep groove ones of the series of `SKF_DEEP_GROOVE`, angular
contact ones, and thrust ball bearings. SKF's constants of angular contact bearings are those of 40 deg; spindle
bearings of 15 to 25 deg take them too, as SKF prints no others. All are fits to unpublished tests, and under pure
thrust they differ by factors. They show the order of magnitude; none checks or validates anything.
The formulas take their printed units: mm, mm^2/s, rev/min, N and N mm.
Sources: [SKF2018], chapter on friction (an older edition has 0.15 for mu_bl), with the constants of [SKF2016], those of
thrust bearings from memory; [Palmgren1959]; [ISO15312].
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.brief import Brief
from analytic.catalog.bearing_rows import series_of_size
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.loads.pair import PairEquilibrium
from analytic.oil.rolling import (
    ANGULAR_CONTACT,
    DEEP_GROOVE,
    THRUST,
    inlet_shear_factor,
    per_minute,
    replenishment_factor,
    ring_diameters,
    square_millimetres,
)
from analytic.oil.viscosity import oil_numbers
from analytic.result import PairPart, TorqueParts
from analytic.scene import Array, Bearing, Scene, Supply

SKF_DEEP_GROOVE = {  # R_1, R_2, S_1, S_2 by series
    "60": (4.1e-7, 1.7, 3.73e-3, 14.6),
    "62": (3.9e-7, 1.7, 3.23e-3, 36.5),
    "63": (3.7e-7, 1.7, 2.84e-3, 92.8),
    "64": (3.6e-7, 1.7, 2.43e-3, 198.0),
    "160": (4.3e-7, 1.7, 4.63e-3, 4.25),
    "161": (4.3e-7, 1.7, 4.63e-3, 4.25),
    "618": (4.7e-7, 1.7, 6.5e-3, 0.78),
    "619": (4.3e-7, 1.7, 4.75e-3, 3.6),
}
SKF_ANGULAR_CONTACT = (5.03e-7, 1.97, 1.9e-12, 0.013, 0.68, 1.91e-12)  # R_1, R_2, R_3, S_1, S_2, S_3 of one row
SKF_THRUST = (1.03e-6, 0.016)  # R_1, S_1 of thrust ball bearings; from memory
ANGULAR_SERIES = ("72 B", "73 B")  # of 40 deg
ANGULAR, THRUST_BALL = "angular contact", "thrust"  # in place of the series of bearings that have none
ISO_15312 = {  # f_0r, f_1r by series; its table has dimension series, 02 for 62, and no 01 for 161
    "618": (1.7, 1.0e-4),
    "619": (1.7, 1.5e-4),
    "160": (1.7, 1.5e-4),
    "60": (1.7, 1.5e-4),
    "62": (2.0, 2.0e-4),
    "63": (2.3, 2.0e-4),
    "64": (2.3, 2.0e-4),
    "72 B": (2.0, 2.5e-4),
    "73 B": (3.0, 3.5e-4),
}
BOUNDARY_FRICTION = 0.12  # mu_bl
FILM_FRICTION = 0.05  # mu_EHL, mineral oil
PALMGREN_VISCOUS = 2.0  # f_0
PALMGREN_LOAD = (4e-4, 6e-4)  # z of f_1 = z (P_0/C_0)^0.55
# f_0; that of an oil bath is in [Jungnickel2010], the others and those of thrust bearings after tables of Harris, from
# memory.
ANGULAR_VISCOUS: Mapping[Supply, float] = {"grease": 2.0, "oil_spot": 1.7, "oil_bath": 3.3, "oil_jet": 6.6}
THRUST_VISCOUS: Mapping[Supply, float] = {"grease": 5.5, "oil_spot": 0.8, "oil_bath": 1.5, "oil_jet": 3.0}
ANGULAR_LOAD, THRUST_LOAD = 1e-3, 8e-4  # z of f_1 = z (P_0/C_0)^0.33; the first in [FAG2002], the second from memory
DEEP_GROOVE_THRUST = 3.3  # of P_1
# Y_0 of P_0 = max(0.5 F_r + Y_0 F_a, F_r) by the contact angle in degrees, [ISO76], from memory but for 40 deg
STATIC_ANGLES, STATIC_AXIAL = (15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0), (0.46, 0.42, 0.38, 0.33, 0.29, 0.26, 0.22)
LEAST_ANGLE = 0.1  # rad: below, the thrust counts as in a deep groove bearing
STEEPEST = np.radians(20.0)  # unloaded angle of a deep groove bearing with a large clearance; judgement


class CatalogueCase(NamedTuple):
    """A bearing and how it runs, as the models need it; all fields but the series broadcast."""

    series: str  # of the bearing, as the catalogue names it
    bore_diameter: ArrayLike  # d, m
    outside_diameter: ArrayLike  # D > d, m
    static_rating: ArrayLike  # C_0, N, > 0
    axial_load: ArrayLike  # F_a, N, >= 0
    radial_load: ArrayLike  # F_r, N, >= 0
    ring_speed: ArrayLike  # |w|, rad/s, >= 0
    kinematic_viscosity: ArrayLike  # nu at running temperature, m^2/s, > 0
    free_angle: float = np.radians(40.0)  # alpha of an angular contact bearing, unloaded, rad

    @property
    def is_angular(self) -> bool:
        return self.series not in SKF_DEEP_GROOVE and self.series != THRUST_BALL


@dataclass(frozen=True, kw_only=True, eq=False)
class CatalogueBand(Brief):
    """Torques of one bearing about its axis, N m; every array has the broadcast shape of the case."""

    low: Array  # the least of the values
    high: Array  # the largest of them
    values: Mapping[str, Array]  # by name of the model; NaN where a model does not hold

    def sides(self, torque: Array) -> dict[str, int]:
        """At how many points a torque is outside, on either side.

        Parameters
        ----------
        torque : ndarray
            N m, of the shape of the band.

        Returns
        -------
        dict of str to int
            By "below" and "above", as far as there are such points.
        """
        found = {"below": torque < self.low, "above": torque > self.high}
        return {side: int(points.sum()) for side, points in found.items() if points.any()}


def scene_band(scene: Scene, loads: PairEquilibrium | None = None) -> CatalogueBand:
    """The band at every operating point of a scene; arrays (n,), errors as of `case_of`.

    loads : of a pair, whose band is the sum over both bearings at their own thrust and radial load; the moments with
        which the shaft holds the rings straight are left out
    """
    case, oil = case_of(scene), scene.lubricant
    assert oil is not None
    if loads is None:
        return catalogue_band(case, lubrication=oil.supply)
    each = zip(np.abs(loads.axial_load), np.abs(loads.radial_load), strict=True)
    cases = [case._replace(axial_load=thrust, radial_load=radial) for thrust, radial in each]
    values = [catalogue_band(one, lubrication=oil.supply).values for one in cases]
    return _band_of({name: np.sum([found[name] for found in values], axis=0) for name in values[0]})


def case_of(scene: Scene) -> CatalogueCase:
    """What the models need of a scene, with the oil at its inlet temperature; arrays (n,).

    Raises InputError in one line, the reason for which there is no band: no oil, rating or ring diameter, a series of
    bearings without constants, a moment or a thrust below 0.
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
    series = bearing_series(bearing)
    if np.any(operation.moment):
        raise InputError("operation.moment is not 0: no model for moments")
    if abs(operation.held_tilt) > 0:
        raise InputError("operation.tilt is not 0: no model for tilted rings")
    axial, radial = np.asarray(operation.axial_load), np.abs(operation.radial_load)
    if np.any(axial < 0):
        raise InputError(f"operation.axial_load = {axial.min():g} N is below 0")
    if np.any(axial > rating):  # their angle of the loaded contact would pass 25 deg, and turn back beyond 90 deg
        raise InputError(
            f"operation.axial_load = {axial.max():g} N exceeds the static load rating of {rating:g} N, the limit of "
            "the models"
        )
    return CatalogueCase(
        series=series,
        bore_diameter=bore,
        outside_diameter=outside,
        static_rating=rating,
        axial_load=axial,
        radial_load=radial,
        ring_speed=np.abs(operation.inner_speed),
        kinematic_viscosity=oil_numbers(oil).viscosity / oil.density,
        free_angle=_free_angle(bearing),
    )


def bearing_series(bearing: Bearing) -> str:
    """The series by which the constants are chosen: that of the designation, else of the boundary dimensions.

    Of a bearing that is not of the catalogue the unloaded contact angle says whether it is a deep groove one; angular
    contact bearings have the same dimensions.
    Raises InputError in one line for a bearing without constants; its ring diameters must be known.
    """
    if bearing.kind == "thrust":
        return THRUST_BALL
    series = bearing.series
    if series is None and _free_angle(bearing) > STEEPEST:
        return ANGULAR
    if series is None:
        assert bearing.bore_diameter is not None
        assert bearing.outside_diameter is not None
        sizes = f"bore {1e3 * bearing.bore_diameter:g} mm and outside diameter {1e3 * bearing.outside_diameter:g} mm"
        series = series_of_size(bearing.bore_diameter, bearing.outside_diameter, bearing.width)
        if series is None:
            raise InputError(f"{sizes} fit no series of deep groove bearings with constants")
    return series


def _free_angle(bearing: Bearing) -> float:
    """The unloaded contact angle, rad."""
    if bearing.kind == "thrust":
        return np.pi / 2
    play = max(bearing.diametral_clearance, 0.0) / (2 * bearing.groove_centre_distance)
    return float(np.arccos(max(1 - play, 0.0)))


def catalogue_band(case: CatalogueCase, *, lubrication: Supply) -> CatalogueBand:
    """All models; of deep groove bearings Palmgren's with the least and the largest of his usual load factors."""
    rolling, sliding = skf_parts(case, lubrication=lubrication)
    values = {"SKF": rolling + sliding}
    if case.series not in SKF_DEEP_GROOVE:
        values["Palmgren"] = palmgren_inclined_torque(case, lubrication=lubrication)
    else:
        for factor in PALMGREN_LOAD:
            values[f"Palmgren, z = {factor:g}"] = palmgren_torque(case, load_factor=factor)
    if case.series in ISO_15312:
        values["ISO 15312"] = iso_torque(case)
    return _band_of(values)


def _band_of(values: Mapping[str, Array]) -> CatalogueBand:
    """Of the values of each model, which broadcast."""
    values = dict(zip(values, np.broadcast_arrays(*values.values()), strict=True))
    every = np.array(list(values.values()))
    return CatalogueBand(low=np.nanmin(every, axis=0), high=np.nanmax(every, axis=0), values=MappingProxyType(values))


def skf_parts(case: CatalogueCase, *, lubrication: Supply) -> tuple[Array, Array]:
    """SKF's rolling and sliding torque M_rr and M_sl, N m, without seals and drag.

    With d_m = (d + D)/2 and n in rev/min:
        M_rr = phi_ish phi_rs G_rr (nu n)^0.6
        M_sl = G_sl [phi_bl mu_bl + (1 - phi_bl) mu_EHL],  phi_bl = exp(-2.6e-8 (n nu)^1.4 d_m)
    Deep groove bearings, with alpha_F = 24.6 (F_a/C_0)^0.24 degrees:
        G_rr = R_1 d_m^1.96 (F_r + R_2 F_a/sin alpha_F)^0.54
        G_sl = S_1 d_m^-0.145 (F_r^5 + S_2 d_m^1.5 F_a^4/sin alpha_F)^(1/3),  but S_1 d_m^-0.26 F_r^(5/3) if F_a = 0
    The two forms of G_sl do not meet: at F_a = 0 it jumps by d_m^0.115, 1.52 for a 6205. For F_a up to about C_0/2 and
    normal clearance.
    Angular contact bearings:
        G_rr = R_1 d_m^1.97 (F_r + R_3 d_m^4 n^2 + R_2 F_a)^0.54
        G_sl = S_1 d_m^0.26 [(F_r + S_3 d_m^4 n^2)^(4/3) + S_2 F_a^(4/3)]
    Thrust ball bearings:
        G_rr = R_1 d_m^1.83 F_a^0.54,  G_sl = S_1 d_m^0.05 F_a^(4/3)
    Raises InputError for an argument of the wrong sign or not finite, and for a bore no smaller than the outside.
    """
    load, thrust, oil, speed = _operation(case)
    mean = _mean(case)
    if case.is_angular:
        rolling, sliding = _skf_angular_contact(load, thrust, mean=mean, speed=speed)
        geometry = ANGULAR_CONTACT
    elif case.series == THRUST_BALL:
        first, sliding_first = SKF_THRUST
        rolling = first * mean**1.83 * thrust**0.54
        sliding, geometry = sliding_first * mean**0.05 * thrust ** (4 / 3), THRUST
    else:
        rolling, sliding = _skf_deep_groove(case, load, thrust, mean=mean)
        geometry = DEEP_GROOVE
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
        geometry=geometry,
    )
    boundary = np.exp(-2.6e-8 * (speed * oil) ** 1.4 * mean)
    friction = boundary * BOUNDARY_FRICTION + (1 - boundary) * FILM_FRICTION
    return rolling / 1e3, sliding * friction / 1e3  # N mm to N m


def _skf_deep_groove(case: CatalogueCase, load: Array, thrust: Array, *, mean: Array) -> tuple[Array, Array]:
    """G_rr and G_sl."""
    first, second, sliding_first, sliding_second = SKF_DEEP_GROOVE[case.series]
    angle = np.deg2rad(24.6 * (thrust / np.asarray(case.static_rating)) ** 0.24)
    steep = np.where(thrust > 0, np.sin(angle), 1.0)  # F_a/sin alpha_F falls to 0 with F_a
    rolling = first * mean**1.96 * (load + second * thrust / steep) ** 0.54
    sliding = sliding_first * np.where(
        thrust > 0,
        mean**-0.145 * np.cbrt(load**5 + sliding_second * mean**1.5 * thrust**4 / steep),
        mean**-0.26 * load ** (5 / 3),
    )
    return rolling, sliding


def _skf_angular_contact(load: Array, thrust: Array, *, mean: Array, speed: Array) -> tuple[Array, Array]:
    """G_rr and G_sl."""
    first, second, third, sliding_first, sliding_second, sliding_third = SKF_ANGULAR_CONTACT
    force = mean**4 * speed**2
    rolling = first * mean**1.97 * (load + third * force + second * thrust) ** 0.54
    whole = (load + sliding_third * force) ** (4 / 3) + sliding_second * thrust ** (4 / 3)
    return rolling, sliding_first * mean**0.26 * whole


def palmgren_torque(case: CatalogueCase, *, load_factor: ArrayLike) -> Array:
    """Palmgren's torque of deep groove bearings, M_0 + M_1, N m; load_factor is z, > 0, and broadcasts with the case.

    M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3 from nu n = 2000 on, below it 160e-7 f_0 d_m^3 (a jump of 0.8 %), f_0 = 2
    M_1 = z (P_0/C_0)^0.55 P_1 d_m,  P_1 = max(3.3 F_a - 0.1 F_r, F_r),  P_0 = max(0.6 F_r + 0.5 F_a, F_r)
    M_0 does not end at standstill: it is meant for bearings that turn at ordinary speed under ordinary load.
    """
    require_positive(load_factor=load_factor)
    load, thrust, oil, speed = _operation(case)
    mean = _mean(case)
    static = np.maximum(0.6 * load + 0.5 * thrust, load)
    working = np.maximum(DEEP_GROOVE_THRUST * thrust - 0.1 * load, load)
    loaded = np.asarray(load_factor) * (static / np.asarray(case.static_rating)) ** 0.55 * working * mean
    return (_viscous(PALMGREN_VISCOUS, oil * speed, mean) + loaded) / 1e3  # N mm to N m


def palmgren_inclined_torque(case: CatalogueCase, *, lubrication: Supply) -> Array:
    """Palmgren's torque of angular contact and of thrust ball bearings of one row, M_0 + M_1, N m.

    M_0 as of deep groove bearings with f_0 by the supply of oil;  M_1 = z (P_0/C_0)^0.33 P_1 d_m
    Angular contact: z = 0.001, P_1 = max(0.9 F_a cot(alpha) - 0.1 F_r, F_r), 0.9 cot(alpha) at most 3.3, that of deep
    groove bearings;  P_0 = max(0.5 F_r + Y_0 F_a, F_r).  Thrust: z = 0.0008, P_0 = P_1 = F_a.
    """
    load, thrust, oil, speed = _operation(case)
    mean = _mean(case)
    if case.is_angular:
        viscous, factor = ANGULAR_VISCOUS[lubrication], ANGULAR_LOAD
        lever = min(0.9 / np.tan(max(case.free_angle, LEAST_ANGLE)), DEEP_GROOVE_THRUST)
        working = np.maximum(lever * thrust - 0.1 * load, load)
        share = np.interp(np.degrees(case.free_angle), STATIC_ANGLES, STATIC_AXIAL)
        static = np.maximum(0.5 * load + share * thrust, load)
    else:
        viscous, factor = THRUST_VISCOUS[lubrication], THRUST_LOAD
        static = working = thrust
    loaded = factor * (static / np.asarray(case.static_rating)) ** 0.33 * working * mean
    return (_viscous(viscous, oil * speed, mean) + loaded) / 1e3


def iso_torque(case: CatalogueCase) -> Array:
    """The torque of [ISO15312], M_0 + M_1, N m; NaN where the thrust decides.

    M_0 = 1e-7 f_0r (nu n)^(2/3) d_m^3,  M_1 = f_1r P_1r d_m
    The standard has it for one load, P_1r = 0.05 C_0r, which is radial, at 70 degC. Here P_1r is F_r. A thrust with
    which P_1 of Palmgren is above F_r is outside its range.
    """
    load, thrust, oil, speed = _operation(case)
    mean = _mean(case)
    viscous, factor = ISO_15312[case.series]
    torque = (1e-7 * viscous * (oil * speed) ** (2 / 3) * mean**3 + factor * load * mean) / 1e3
    slope = 1.0 if case.is_angular else DEEP_GROOVE_THRUST
    return np.where((load > 0) & (slope * thrust - 0.1 * load <= load), torque, np.nan)


def _mean(case: CatalogueCase) -> Array:
    """d_m, mm."""
    bore, outside = ring_diameters(case.bore_diameter, case.outside_diameter)
    return (bore + outside) / 2


def _viscous(factor: float, stirred: Array, mean: Array) -> Array:
    """Palmgren's M_0, N mm; stirred : nu n."""
    return factor * mean**3 * np.where(stirred >= 2000, 1e-7 * stirred ** (2 / 3), 160e-7)


def _operation(case: CatalogueCase) -> tuple[Array, Array, Array, Array]:
    """F_r and F_a in N, nu in mm^2/s, n in rev/min."""
    require_positive(static_rating=case.static_rating, kinematic_viscosity=case.kinematic_viscosity)
    require_non_negative(axial_load=case.axial_load, radial_load=case.radial_load, ring_speed=case.ring_speed)
    load, thrust = np.asarray(case.radial_load, dtype=np.float64), np.asarray(case.axial_load, dtype=np.float64)
    return load, thrust, square_millimetres(case.kinematic_viscosity), per_minute(case.ring_speed)


WITHOUT_LOSSES = "without seals and drag"
NO_BAND = "no catalogue band: "  # how the reason begins for which there is none


@dataclass(frozen=True, kw_only=True, eq=False)
class BesideCatalogue(Brief):
    """The band of the models, or the reason for which there is none."""

    band: CatalogueBand | None  # arrays (n,), N m
    note: str  # why there is no band, or what to know of it


def beside_catalogue(scene: Scene, pair: PairPart | None = None) -> BesideCatalogue:
    """The catalogue band of a scene; pair : the two bearings of its torque, where it has an arrangement."""
    try:
        band = scene_band(scene, None if pair is None else pair.equilibrium)
    except InputError as problem:
        return BesideCatalogue(band=None, note=f"{NO_BAND}{problem}")
    kind = bearing_series(scene.bearing)
    of = f"{kind} ball bearing" if kind in (ANGULAR, THRUST_BALL) else f"bearing of series {kind}"
    is_flat = scene.bearing.kind == "radial" and kind not in (*SKF_DEEP_GROOVE, *ANGULAR_SERIES)
    both = "" if pair is None else ", summed over both"
    constants = "; SKF's constants are of 40 deg and ordinary speeds" if is_flat else ""
    note = (
        f"catalogue band: {_models(band)} for an open {of}{both}{constants}; empirical fits, "
        "an order of magnitude, not a reference"
    )
    return BesideCatalogue(band=band, note=note)


def of_open_bearing(torque: TorqueParts) -> tuple[Array, str]:
    """The torque to compare with the band, N m, and what it is without, in words; empty: it is the total.

    No model has seals, and SKF's has no drag of the oil outside the contacts. Palmgren's and that of ISO 15312 have the
    drag of an oil bath in their viscous part.
    """
    losses = [part for part in (torque.declared, torque.oil) if part is not None]
    return torque.total - sum(losses), WITHOUT_LOSSES if losses else ""


def _models(band: CatalogueBand) -> str:
    """Whose models hold at one operating point at least."""
    if np.all(np.isnan(band.values.get("ISO 15312", np.nan))):
        return "models of SKF and Palmgren"
    return "models of SKF, Palmgren and ISO 15312 (under radial load)"
