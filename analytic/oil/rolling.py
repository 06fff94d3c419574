"""Resistance to rolling without sliding: oil that is squeezed into the contact, and elastic hysteresis.

Oil: pressure builds up ahead of the contact and is not given back behind it, so a force holds each surface back. The
formula assumes pure rolling, oil of constant viscosity, a fully flooded and isothermal inlet, a contact that is not
longer in the direction of rolling than transverse to it, and a speed so low that rigid bodies resist more than elastic
ones. Heating and starvation of the inlet reduce it by the factors of [SKF2018].
Source: [Biboulet2010].
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ellipe

from analytic.contact.hertz import hertz_contact
from analytic.contact.rolling_contact import EllipticContact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array, Supply

STARVATION: dict[Supply, float] = {"oil_bath": 3e-8, "grease": 6e-8}  # K_rs
GEOMETRY = 3.1  # K_Z, deep-groove ball bearings of one row


@dataclass(frozen=True, kw_only=True, eq=False)
class RollingResistance:
    """The resistance of one or many contacts; every field has the broadcast shape of the arguments."""

    force: Array  # f, on each of the two surfaces, against its motion, N, >= 0
    power: Array  # 2 |u| f, W, >= 0
    outside_range: NDArray[np.bool_]  # longer in rolling than transverse, or so fast that rigid bodies resist less


def hydrodynamic_rolling(
    contact: EllipticContact, *, viscosity: ArrayLike, entrainment_speed: ArrayLike
) -> RollingResistance:
    """Rolling force on each surface and the power that both lose; fields and arguments broadcast.

    contact : with the load Q and the curvatures 1/R_x (rolling) and 1/R_y (transverse); its semi-axes are not used,
        because the formula takes those of Hertz
    viscosity : eta_0 at the inlet, Pa s, > 0;  entrainment_speed : u, mean of both surfaces, m/s, any sign
    With E' = 2 E*, Hertz's semi-axes a (rolling) and b (transverse), kappa = a/b, U = 2 eta_0 |u|/(E' R_x),
    W = Q/(E' R_x^2), beta = (4/pi) E(m)/(1 + R_x/R_y), m = 1 - (minor/major)^2 and M = beta^(1/4) kappa W U^(-3/4):
        f = E' R_x^2 (2 b/R_x) {[0.77 beta^(-1/3) kappa^0.12 U^(-1/12) - 1.8 beta^(-1/4)]/(1 + M/6.6)
            + 1.8 beta^(-1/4)} U^(3/4)
    M -> 0 leaves the first term (rigid bodies, f ~ u^(2/3)), M -> inf the last (elastic bodies, f ~ u^(3/4)). The force
    is exactly 0 at standstill, and 0 without load, like the width of the contact. It grows with speed and viscosity.
    It also grows with load, unless the first term is more than four times the last: then it falls over some loads.
    Raises InputError if an argument has the wrong sign or is not finite, or if shapes do not broadcast.
    """
    require_positive(viscosity=viscosity)
    require_finite(entrainment_speed=entrainment_speed)
    rolling, transverse, load, modulus = (
        np.asarray(value, dtype=np.float64)
        for value in (contact.curvature_rolling, contact.curvature_transverse, contact.load, contact.modulus)
    )
    unit = hertz_contact(curvature_x=rolling, curvature_y=transverse, load=1.0, modulus=modulus)
    stiff = 2 * modulus  # E'
    speed = np.abs(np.asarray(entrainment_speed, dtype=np.float64))
    slenderness = unit.semi_axis_x / unit.semi_axis_y  # kappa, the same at every load
    ellipse = ellipe(1 - np.minimum(slenderness, 1 / slenderness) ** 2)
    beta = 4 / np.pi * ellipse / (1 + transverse / rolling)
    try:
        u = 2 * np.asarray(viscosity, dtype=np.float64) * speed * rolling / stiff
        load_share = beta**0.25 * slenderness * load * rolling**2 / stiff / 6.6  # M U^(3/4)/6.6, finite at standstill
        rigid = np.divide(
            u**0.75, u**0.75 + load_share, out=np.zeros(np.broadcast(u, load_share).shape), where=u > 0
        )  # 1/(1 + M/6.6)
        rising, level = 0.77 * beta ** (-1 / 3) * slenderness**0.12 * u ** (2 / 3), 1.8 * beta**-0.25 * u**0.75
        width = 2 * unit.semi_axis_y * np.cbrt(load) * stiff / rolling
        resistance = width * (rigid * rising + (1 - rigid) * level)
    except ValueError as problem:
        raise InputError(
            "the arguments of a rolling resistance have shapes that do not fit together: give equal lengths"
        ) from problem
    return RollingResistance(
        force=resistance,
        power=2 * speed * resistance,
        outside_range=np.broadcast_to((rolling < transverse) | (rising < level), resistance.shape),
    )


def rolling_torque(resistance: RollingResistance, *, entrainment_rate: ArrayLike) -> Array:
    """Torque of each contact about the bearing axis, N m: power over ring speed, 2 f u/w.

    entrainment_rate : u/w, m, >= 0, entrainment speed per unit ring speed, the same on both races; broadcasts with the
        forces
    So the torque exists at standstill, where it is 0. Like every torque it opposes w.
    """
    require_non_negative(entrainment_rate=entrainment_rate)
    return 2 * resistance.force * np.asarray(entrainment_rate)


def hysteresis_moment(contact: EllipticContact, *, hysteresis_loss: ArrayLike) -> Array:
    """M_h = (3/16) alpha' Q a, N m: the moment that resists rolling because the bodies lose elastic energy.

    hysteresis_loss : alpha', share of the elastic energy that is lost in each cycle, >= 0; broadcasts with the contact
    a is the semi-axis in the direction of rolling.
    Source: equation 8 of [Paper], from [Johnson1985] p. 285.
    """
    require_non_negative(hysteresis_loss=hysteresis_loss)
    return np.asarray(
        3 / 16 * np.asarray(hysteresis_loss) * np.asarray(contact.load) * np.asarray(contact.semi_axis_rolling)
    )


def inlet_shear_factor(*, mean_diameter: ArrayLike, ring_speed: ArrayLike, kinematic_viscosity: ArrayLike) -> Array:
    """phi_ish = 1/[1 + 1.84e-9 (n d_m)^1.28 nu^0.64]: SKF's factor on the rolling torque for inlet heating, 0 to 1.

    mean_diameter : d_m = (d + D)/2, m, > 0;  ring_speed : rad/s, >= 0;  kinematic_viscosity : nu, m^2/s, > 0
    The formula takes n in 1/min, d_m in mm and nu in mm^2/s. Source: [SKF2018].
    """
    require_positive(mean_diameter=mean_diameter, kinematic_viscosity=kinematic_viscosity)
    require_non_negative(ring_speed=ring_speed)
    surface = per_minute(ring_speed) * np.asarray(mean_diameter) * 1e3  # n d_m, mm/min
    return 1 / (1 + 1.84e-9 * surface**1.28 * square_millimetres(kinematic_viscosity) ** 0.64)


def replenishment_factor(
    *,
    bore_diameter: ArrayLike,
    outside_diameter: ArrayLike,
    ring_speed: ArrayLike,
    kinematic_viscosity: ArrayLike,
    supply: Supply,
) -> Array:
    """phi_rs = exp(-K_rs nu n (d + D) sqrt(K_Z/[2 (D - d)])): SKF's factor on the rolling torque for starvation.

    bore_diameter, outside_diameter : d < D, m;  ring_speed : rad/s, >= 0;  kinematic_viscosity : nu, m^2/s, > 0
    supply : `oil_bath` (low level; also oil jet) or `grease` (also oil-air), with K_rs of 3e-8 or 6e-8; K_Z = 3.1
    The factor is 0 to 1. The formula takes n in 1/min, the diameters in mm and nu in mm^2/s. 1 - phi_rs bounds the
    effect of leaving starvation out. Source: [SKF2018].
    """
    if supply not in STARVATION:
        raise InputError(f'supply must be "oil_bath" or "grease", got {supply!r}')
    bore, outside = ring_diameters(bore_diameter, outside_diameter)
    require_positive(kinematic_viscosity=kinematic_viscosity)
    require_non_negative(ring_speed=ring_speed)
    passing = square_millimetres(kinematic_viscosity) * per_minute(ring_speed) * (bore + outside)
    return np.exp(-STARVATION[supply] * passing * np.sqrt(GEOMETRY / (2 * (outside - bore))))


def ring_diameters(bore_diameter: ArrayLike, outside_diameter: ArrayLike) -> tuple[Array, Array]:
    """d and D in mm; raises InputError unless 0 < d < D."""
    require_positive(bore_diameter=bore_diameter, outside_diameter=outside_diameter)
    bore, outside = 1e3 * np.asarray(bore_diameter), 1e3 * np.asarray(outside_diameter)
    if not np.all(bore < outside):
        raise InputError(
            f"bore_diameter {bore_diameter!r} m must be below outside_diameter {outside_diameter!r} m: "
            "they are the bearing's own, not the races'"
        )
    return bore, outside


def per_minute(speed: ArrayLike) -> Array:
    """n, 1/min, from a speed in rad/s."""
    return np.asarray(speed) * 60 / (2 * np.pi)


def square_millimetres(kinematic_viscosity: ArrayLike) -> Array:
    """nu, mm^2/s, from m^2/s."""
    return 1e6 * np.asarray(kinematic_viscosity)
