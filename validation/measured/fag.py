"""FAG's formula for the torque of a bearing in an oil bath, a third maker's beside those of catalogue_models."""

import numpy as np

from analytic.errors import InputError
from analytic.makers import ANGULAR_SERIES, CatalogueCase
from analytic.oil.rolling import per_minute, ring_diameters, square_millimetres
from analytic.scene import Array
from validation.study import published

LEAST_STIRRED = 2000.0  # nu n, mm2/s 1/min: below, M_0 has another form


def fag_torque(case: CatalogueCase) -> tuple[Array, Array]:
    """M_0 + M_1 with the least and with the largest of the factors printed, N m.

    M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3,  M_1 = f_1 (P_0/C_0)^x P_1 d_m,  N mm
    with d_m = (d + D)/2 in mm, nu in mm2/s, n in 1/min,
    P_1 = max(F_r, k F_a - 0.1 F_r),  P_0 = max(F_r, X_0 F_r + Y_0 F_a).  Source: [FAG2002].
    Raises InputError below nu n = 2000 mm2/s 1/min.
    """
    bore, outside = ring_diameters(case.bore_diameter, case.outside_diameter)
    mean = (bore + outside) / 2
    load, thrust = np.asarray(case.radial_load, float), np.asarray(case.axial_load, float)
    stirred = square_millimetres(case.kinematic_viscosity) * per_minute(case.ring_speed)
    if np.any(stirred < LEAST_STIRRED):
        raise InputError(f"viscosity times speed is {np.min(stirred):.3g} mm2/s 1/min: at least {LEAST_STIRRED:g}")
    factors = fag_factors(case.series)
    static = np.maximum(load, factors["static_radial"] * load + factors["static_axial"] * thrust)
    working = np.maximum(load, factors["thrust_factor"] * thrust - 0.1 * load)
    share = (static / np.asarray(case.static_rating)) ** factors["exponent"]
    low, high = (
        (
            1e-7 * factors[f"f0_{end}"] * stirred ** (2 / 3) * mean**3
            + factors[f"f1_{end}"] * share * working * mean
        )
        / 1e3
        for end in ("low", "high")
    )  # fmt: skip
    return low, high


def fag_factors(series: str) -> dict[str, float]:
    """The factors of a series of bearings, by column of fag_friction.csv."""
    kind = series if series in ANGULAR_SERIES else "deep groove"
    row = next(row for row in published("fag_friction.csv") if row["kind"] == kind)
    return {name: float(value) for name, value in row.items() if name != "kind"}
