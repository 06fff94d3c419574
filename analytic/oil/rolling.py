"""Hydrodynamic rolling resistance: what it takes to squeeze the oil into a rolling contact.

Entrainment runs along x. Pressure builds up ahead of the contact and is not given back behind it, so each surface is
held back by a force that no sliding causes. Pure rolling, oil of constant viscosity, fully flooded and isothermal, a
contact that is no longer along rolling than across it, u small enough that rigid bodies resist more than elastic ones.
Source: N. Biboulet and L. Houpert, Hydrodynamic force and moment in pure rolling lubricated contacts, part 2: point
contacts, Proc. IMechE J 224 (2010) (not seen).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ellipe

from analytic.contact.hertz import hertz_contact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class RollingResistance:
    """Of one or many contacts; every field has the broadcast shape of the arguments."""

    force: Array  # f, on each of the two surfaces, against its motion, N, >= 0
    power: Array  # 2 |u| f, W, >= 0
    outside_range: NDArray[np.bool_]  # longer along rolling than across, or so fast that rigid bodies resist less


def hydrodynamic_rolling(
    *,
    curvature_x: ArrayLike,
    curvature_y: ArrayLike,
    load: ArrayLike,
    modulus: ArrayLike,
    viscosity: ArrayLike,
    entrainment_speed: ArrayLike,
) -> RollingResistance:
    """Rolling force on each surface and the power that both lose; all arguments broadcast.

    curvature_x, curvature_y : 1/R_x along entrainment and 1/R_y across it, relative, 1/m, > 0
    load : Q, N, >= 0;  modulus : E*, Pa, > 0 (the formula's E' is 2 E*)
    viscosity : eta_0 at the inlet, Pa s, > 0;  entrainment_speed : u, mean of both surfaces, m/s, any sign
    With the semi-axes a across and b along rolling, kappa = b/a, U = 2 eta_0 |u|/(E' R_x), W = Q/(E' R_x^2),
    beta = (4/pi) E(m)/(1 + R_x/R_y), m = 1 - (minor/major)^2 and M = beta^(1/4) kappa W U^(-3/4):
        f = E' R_x^2 (2 a/R_x) {[0.77 beta^(-1/3) kappa^0.12 U^(-1/12) - 1.8 beta^(-1/4)]/(1 + M/6.6)
            + 1.8 beta^(-1/4)} U^(3/4)
    M -> 0 leaves the first term alone (rigid bodies, f ~ u^(2/3)), M -> inf the last (elastic, f ~ u^(3/4)). Exactly 0
    at standstill; without load 0 too, as the width of the contact. It grows with speed and viscosity, and with load
    too unless the first term is more than four times the last: then it falls with load for a while between them.
    Raises InputError for an argument of the wrong sign, not finite, or if shapes do not broadcast.
    """
    require_positive(viscosity=viscosity)
    require_non_negative(load=load)
    require_finite(entrainment_speed=entrainment_speed)
    unloaded = hertz_contact(curvature_x=curvature_x, curvature_y=curvature_y, load=1.0, modulus=modulus)
    along, across = np.asarray(curvature_x, dtype=np.float64), np.asarray(curvature_y, dtype=np.float64)
    stiff, force = 2 * np.asarray(modulus, dtype=np.float64), np.asarray(load, dtype=np.float64)
    speed = np.abs(np.asarray(entrainment_speed, dtype=np.float64))
    slenderness = unloaded.semi_axis_x / unloaded.semi_axis_y  # kappa, the same at every load
    ellipse = ellipe(1 - np.minimum(slenderness, 1 / slenderness) ** 2)
    beta = 4 / np.pi * ellipse / (1 + across / along)
    try:
        u = 2 * np.asarray(viscosity, dtype=np.float64) * speed * along / stiff
        load_share = beta**0.25 * slenderness * force * along**2 / stiff / 6.6  # M U^(3/4)/6.6, finite at standstill
        rigid = np.divide(
            u**0.75, u**0.75 + load_share, out=np.zeros(np.broadcast(u, load_share).shape), where=u > 0
        )  # 1/(1 + M/6.6)
        rising, level = 0.77 * beta ** (-1 / 3) * slenderness**0.12 * u ** (2 / 3), 1.8 * beta**-0.25 * u**0.75
        width = 2 * unloaded.semi_axis_y * np.cbrt(force) * stiff / along
        resistance = width * (rigid * rising + (1 - rigid) * level)
    except ValueError as problem:
        raise InputError(
            "the arguments of a rolling resistance have shapes that do not fit together: give equal lengths"
        ) from problem
    return RollingResistance(
        force=resistance,
        power=2 * speed * resistance,
        outside_range=np.broadcast_to((along < across) | (rising < level), resistance.shape),
    )


def rolling_torque(resistance: RollingResistance, *, entrainment_rate: ArrayLike) -> Array:
    """Torque about the bearing axis from each contact, N m: power over ring speed, 2 f u/w.

    entrainment_rate : u/w, m, >= 0, entrainment speed per unit ring speed, the same on both races; broadcasts with the
        forces. So the torque exists at standstill, where it is 0; like every torque it opposes w
    """
    require_non_negative(entrainment_rate=entrainment_rate)
    return 2 * resistance.force * np.asarray(entrainment_rate)
