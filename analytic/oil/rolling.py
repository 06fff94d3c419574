"""Resistance to rolling without sliding: oil that is squeezed into the contact, and loss by elastic rolling.

Oil: pressure builds up ahead of the contact and is not given back behind it, so a force holds each surface back. The
formula assumes pure rolling, oil of constant viscosity, a fully flooded and isothermal inlet, a contact that is not
longer in the direction of rolling than transverse to it, and a speed so low that rigid bodies resist more than elastic
ones. Heating and starvation of the inlet reduce it by the factors of [SKF2018].
Power over ring speed w, 2 f u/w, is the torque about the bearing axis.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.hertz import elliptic_integrals, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import InputError, require_positive
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import Finite, NotNegative, Positive, formula
from analytic.numerics.root import cube_root
from analytic.scene import Array, Supply

STARVATION: dict[Supply, float] = {"oil_bath": 3e-8, "oil_jet": 3e-8, "oil_spot": 6e-8, "grease": 6e-8}  # K_rs
PER_MINUTE, SQUARE_MILLIMETRES = 60 / (2 * np.pi), 1e6  # in a rad/s, in a m^2
DEEP_GROOVE, ANGULAR_CONTACT, THRUST = 3.1, 4.4, 3.8  # K_Z of ball bearings of one row; the last one from memory
# Loss factors of bearing steel under rolling that are in use, as no measured one was found. 0.004 to 0.01 are usual; a
# formula in [Balan2015] amounts to 0.023 and 0.028 in its two contacts.
HYSTERESIS_LOSS = (0.003, 0.025)
# Houpert's law of slow rolling: M/(Q R_x) of contacts whose friction coefficient is DRY_FRICTION. In oil it is 0.05.
SLOW_ROLLING, OILED_FRICTION, DRY_FRICTION = 0.00042, 0.05, 0.11


class RollingResistance(NamedTuple):
    """The resistance of a contact."""

    force: float  # f, on each of the two surfaces, against its motion, N, >= 0
    power: float  # 2 |u| f, that both lose, W, >= 0
    outside_range: bool  # longer in rolling than transverse, or so fast that rigid bodies resist less


class RollingGroups(NamedTuple):
    """What both formulas are made of, with the symbols of hydrodynamic_rolling."""

    stiffness: float  # E'
    radius: float  # R_x
    ellipticity: float  # R_x/R_y
    semi_axis: float  # b
    slenderness: float  # kappa
    beta: float
    load: float  # W
    speed: float  # U
    loading: float  # M; 1 at standstill, where it is infinite and there is no force
    rigid: float  # 1/(1 + M/6.6)


@compiled
def _power_three_quarters(x: float) -> float:
    root = np.sqrt(x)
    return root * np.sqrt(root)


@compiled
def rolling_groups(contact: ContactNumbers, viscosity: float, speed: float) -> RollingGroups:
    """viscosity : eta_0, Pa s;  speed : |u|, m/s"""
    rolling, transverse, stiffness = contact.curvature_rolling, contact.curvature_transverse, 2 * contact.modulus
    unit = unit_hertz(rolling, transverse, contact.modulus)
    slenderness = unit.semi_axis_x / unit.semi_axis_y  # the same at every load
    squared = min(slenderness, 1 / slenderness) ** 2
    integral_k, share = elliptic_integrals(squared)
    beta = 4 / np.pi * integral_k * (1 - (1 - squared) * share) / (1 + transverse / rolling)  # E = K - m D
    load = contact.load * rolling**2 / stiffness
    heavy = np.sqrt(np.sqrt(beta)) * slenderness * load  # M U^(3/4), finite at standstill
    relative = 2 * viscosity * speed * rolling / stiffness
    power = _power_three_quarters(relative)
    return RollingGroups(
        stiffness,
        1 / rolling,
        transverse / rolling,
        unit.semi_axis_y * cube_root(contact.load),
        slenderness,
        beta,
        load,
        relative,
        heavy / power if relative > 0.0 else 1.0,
        power / (power + heavy / 6.6) if relative > 0.0 else 0.0,
    )


@compiled
def truncation(group: RollingGroups, reach: float) -> float:
    """C of `hydrodynamic_rolling`; reach : r."""
    if reach == 0.0:  # without load
        return 1.0
    slender, log_loading = min(group.slenderness, 1.0), np.log(group.loading)
    fading = -0.39 * log_loading + 0.484 * np.exp(0.165 * log_loading) * np.log(slender)
    shorter = (0.15 + 4.72 * np.exp(fading)) / 0.85  # 1/c - 1
    weaker = np.log(shorter) + (2 - slender) * (0.0018 * group.loading + 1.33) * np.log(reach)
    return 1 / (1 + np.exp(weaker))


@formula
def hydrodynamic_rolling(contact: ContactNumbers, viscosity: Positive, entrainment_speed: Finite) -> RollingResistance:
    """Rolling force on each surface and the power that both lose.

    contact : with the load Q and the curvatures 1/R_x (rolling) and 1/R_y (transverse); its semi-axes are not used,
        because the formula takes those of Hertz. The ball's diameter D follows from deformed_radius and 1/R_y
    viscosity : eta_0 at the inlet, Pa s, > 0;  entrainment_speed : u, mean of both surfaces, m/s, any sign
    With E' = 2 E*, Hertz's semi-axes a (rolling) and b (transverse), kappa = a/b, U = 2 eta_0 |u|/(E' R_x),
    W = Q/(E' R_x^2), beta = (4/pi) E(m)/(1 + R_x/R_y), m = 1 - (minor/major)^2 and M = beta^(1/4) kappa W U^(-3/4):
        f = C E' R_x^2 (2 b/R_x) {[0.77 beta^(-1/3) kappa^0.12 U^(-1/12) - 1.8 beta^(-1/4)]/(1 + M/6.6)
            + 1.8 beta^(-1/4)} U^(3/4)
    M -> 0 leaves the first term (rigid bodies, f ~ u^(2/3)), M -> inf the last (elastic bodies, f ~ u^(3/4)). The force
    is exactly 0 at standstill, and 0 without load, like the width of the contact. It grows with speed and viscosity.
    It also grows with load, unless the first term is more than four times the last or C is well below 1: then it falls
    over some loads.
    C, 0 to 1, is what remains where the film ends at the sides of a ball that is hardly wider than the contact:
        C = 1/[1 + (1/c - 1) r^((2 - kappa) (0.0018 M + 1.33))],  r = min(2 b/D, 1)
        c = 0.85/[1 + 4.72 M^-0.39 kappa^(0.484 M^0.165)]
    It is above 0.997 in a 6205 at 1000 N. It is 1 without load. A kappa above 1 counts in it as 1.
    Source: equations 32, 35 and 36 of [Biboulet2010].
    """
    speed = abs(entrainment_speed)
    group = rolling_groups(contact, viscosity, speed)
    rising = 0.77 / cube_root(group.beta) * group.slenderness**0.12 * cube_root(group.speed) ** 2
    level = 1.8 / np.sqrt(np.sqrt(group.beta)) * _power_three_quarters(group.speed)
    width = 2 * group.semi_axis * group.stiffness * group.radius
    # The ball is convex, so 2/D is the mean curvature 1/R of both bodies and half their difference 1/R_y.
    diameter = 2 / (1 / contact.deformed_radius + contact.curvature_transverse / 2)
    cut = truncation(group, min(2 * group.semi_axis / diameter, 1.0))
    force = cut * width * (group.rigid * rising + (1 - group.rigid) * level)
    longer = contact.curvature_rolling < contact.curvature_transverse
    return RollingResistance(force, 2 * speed * force, longer or rising < level)


@formula
def houpert_rolling(
    contact: ContactNumbers, viscosity: Positive, pressure_viscosity: Positive, entrainment_speed: Finite
) -> RollingResistance:
    """The same by an older formula, whose elastic bodies have oil that thickens under pressure.

    pressure_viscosity : alpha_p, 1/Pa, > 0; the other arguments and symbols are those of hydrodynamic_rolling
    With G = alpha_p E':
        rigid bodies:   f = E' R_x^2 0.835 (R_x/R_y)^-0.358 U^0.636 W^0.364
        elastic bodies: f = E' R_x^2 1.544 beta^(1/3) kappa^-0.577 U^0.656 W^0.466 G^0.022
    They join over M as in hydrodynamic_rolling. On the inner race of a 6205 at 1000 N this is 1.36 times that one at
    100 1/min and 0.98 times at 3000 1/min.
    Source: [Houpert1987], in the notation of [Biboulet2010].
    """
    speed = abs(entrainment_speed)
    group = rolling_groups(contact, viscosity, speed)
    rigid = 0.835 * group.ellipticity**-0.358 * group.speed**0.636 * group.load**0.364
    elastic = 1.544 * cube_root(group.beta) * group.slenderness**-0.577 * group.speed**0.656 * group.load**0.466
    elastic *= (pressure_viscosity * group.stiffness) ** 0.022
    force = group.stiffness * group.radius**2 * (group.rigid * rigid + (1 - group.rigid) * elastic)
    return RollingResistance(force, 2 * speed * force, contact.curvature_rolling < contact.curvature_transverse)


@formula
def inlet_shear_factor(mean_diameter: Positive, ring_speed: NotNegative, kinematic_viscosity: Positive) -> float:
    """phi_ish = 1/[1 + 1.84e-9 (n d_m)^1.28 nu^0.64]: SKF's factor on the rolling torque for inlet heating, 0 to 1.

    mean_diameter : d_m = (d + D)/2, m, > 0;  ring_speed : rad/s, >= 0;  kinematic_viscosity : nu, m^2/s, > 0
    The formula takes n in 1/min, d_m in mm and nu in mm^2/s. Source: [SKF2018].
    """
    surface = PER_MINUTE * ring_speed * mean_diameter * 1e3  # n d_m, mm/min
    return 1 / (1 + 1.84e-9 * (surface**2 * SQUARE_MILLIMETRES * kinematic_viscosity) ** 0.64)


@formula
def replenished(rate: float, ring_speed: NotNegative, kinematic_viscosity: Positive) -> float:
    """phi_rs of `replenishment_factor`; rate : of `replenishment_rate`; the others in SI as there."""
    return np.exp(-rate * kinematic_viscosity * ring_speed)


@formula
def hysteresis_moment(contact: ContactNumbers, hysteresis_loss: NotNegative) -> float:
    """M_h = (3/16) alpha' Q a, N m: the moment that resists rolling because the bodies lose elastic energy.

    hysteresis_loss : alpha', share of the elastic energy that is lost in each cycle, >= 0
    a is the semi-axis in the direction of rolling.
    Source: equation 8 of [Paper], from [Johnson1985] p. 285.
    """
    return 3 / 16 * hysteresis_loss * contact.load * contact.semi_axis_rolling


@formula
def slow_rolling_moment(contact: ContactNumbers, friction_coefficient: NotNegative) -> float:
    """M = 0.00042 Q R_x mu/0.11, N m: the moment that resists the slow rolling of a ball on a race.

    friction_coefficient : mu, 0.05 in oil to 0.11 of dry contacts, >= 0
    1/R_x is the curvature along rolling. With mu = 0.11 and R_x = D/2 it is Snare's measured resistance of dry
    contacts, 0.00021 Q D. It is attributed to creep, which conformity counts too in part.
    Source: equation 8 of [Houpert2002].
    """
    return SLOW_ROLLING * contact.load / contact.curvature_rolling * friction_coefficient / DRY_FRICTION


@compiled
def elastic_rolling(contact: ContactNumbers, loss: float, by_houpert: bool, step: float) -> float:
    """Moment by elastic rolling by one of two laws, N m.

    loss : alpha' of the law of hysteresis;  by_houpert : the law of slow rolling counts, in oil
    step : 0: the law that counts; 1: the other one; between and beyond, powers of their ratio, up to that of dry
        contacts
    """
    hysteretic, slow = hysteresis_moment(contact, loss), slow_rolling_moment(contact, OILED_FRICTION)
    own, other = (slow, hysteretic) if by_houpert else (hysteretic, slow)
    if step == 0.0 or own == 0.0 or other == 0.0:
        return own
    return min(own * (other / own) ** step, max(own, slow_rolling_moment(contact, DRY_FRICTION)))


def replenishment_factor(
    *,
    bore_diameter: ArrayLike,
    outside_diameter: ArrayLike,
    ring_speed: ArrayLike,
    kinematic_viscosity: ArrayLike,
    supply: Supply,
    geometry: float = DEEP_GROOVE,
) -> Array:
    """phi_rs = exp(-K_rs nu n (d + D) sqrt(K_Z/[2 (D - d)])): SKF's factor on the rolling torque for starvation.

    bore_diameter, outside_diameter : d < D, m;  ring_speed : rad/s, >= 0;  kinematic_viscosity : nu, m^2/s, > 0
    supply : `oil_bath` (low level) or `oil_jet` with K_rs of 3e-8, `oil_spot` (oil-air) or `grease` with 6e-8
    geometry : K_Z, 3.1 of deep groove, 4.4 of angular contact and 3.8 of thrust ball bearings of one row
    The factor is 0 to 1. The formula takes n in 1/min, the diameters in mm and nu in mm^2/s.
    Source: [SKF2018].
    """
    rate = replenishment_rate(
        bore_diameter=bore_diameter, outside_diameter=outside_diameter, supply=supply, geometry=geometry
    )
    return replenished(rate, ring_speed, kinematic_viscosity)


def replenishment_rate(
    *, bore_diameter: ArrayLike, outside_diameter: ArrayLike, supply: Supply, geometry: float = DEEP_GROOVE
) -> Array:
    """-ln phi_rs over nu in m^2/s and the ring speed in rad/s, s^2/m^2; arguments as in `replenishment_factor`."""
    if supply not in STARVATION:
        raise InputError(f"supply must be one of {', '.join(STARVATION)}, got {supply!r}")
    bore, outside = ring_diameters(bore_diameter, outside_diameter)
    rate = STARVATION[supply] * (bore + outside) * np.sqrt(geometry / (2 * (outside - bore)))  # over nu n
    return square_millimetres(per_minute(rate))


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
    return np.asarray(speed) * PER_MINUTE


def square_millimetres(kinematic_viscosity: ArrayLike) -> Array:
    """nu, mm^2/s, from m^2/s."""
    return np.asarray(kinematic_viscosity) * SQUARE_MILLIMETRES
