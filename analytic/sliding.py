"""What the balls lose by sliding on their races, by the cheapest rung of `analytic.friction` that is good enough.

The first rung's error follows from how the stress depends on pressure and speed, as tau ~ p^q |v|^s about the mean of
each contact: nothing is missed on a long ellipse where q = 1 and s = 0, as with Coulomb friction. What the long ellipse
itself misses is known: beyond full spin E(m) - 1 of the moment, m = 1 - (a/b)^2, and less below.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import ellipe

from analytic.balls import LoadedBalls
from analytic.friction import RaceContact, Rung, SlipFriction, slip_friction
from analytic.race import microslip_moments
from analytic.scene import Array, SpinRule
from analytic.traction import CoulombTraction, Traction

# Measured against the last rung on 1000 contacts with oil and asperities (validation/benchmarks/friction.py --errors):
# what is missed at a stress that does not follow the pressure, where it may stop doing so within the contact (the kink
# at the limiting stress), and where it is proportional to the speed.
EVEN_STRESS, KINK, VISCOUS = 0.18, 0.17, 0.65
QUADRATURE = 1e-3  # of the last rung; its nodes leave 1e-5, its balance of spin less
SPREAD = 0.02  # relative step of the differences that give the exponents
SPIN_STIFFNESS = 0.9163  # d(M_spin/mu Q b)/d eps at eps = 0, the largest; see analytic.race


@dataclass(frozen=True, kw_only=True, eq=False)
class Sliding:
    """Torque and what goes with it; n operating points, m balls."""

    spin: Array  # (n,) N m
    conformity: Array  # (n,) N m
    coefficient: Array  # (2, n, m)
    rung: Rung
    error: Array  # (n,) bound on what the rung misses, of spin + conformity


def sliding(
    balls: LoadedBalls,
    traction: tuple[Traction, Traction],
    *,
    ring_speed: Array,
    spins: bool,
    spin_rule: SpinRule,
    beside: Array,
    allowed: Array,
) -> Sliding:
    """Of all balls at each operating point.

    traction : of inner and outer race, its numbers (n, m);  ring_speed : w, (n,), rad/s
    spins : whether balls spin at all
    beside : (n,) torque of other effects, N m;  allowed : (n,) error of the whole that is left to the rung, relative
    """
    races = [
        RaceContact(
            traction=law,
            load=balls.load[race],
            semi_axis_rolling=balls.contact.semi_axis_x[race],
            semi_axis_transverse=balls.contact.semi_axis_y[race],
            deformed_radius=balls.deformed_radius[race],
            rolling_rate=balls.rolling_rate[race],
        )
        for race, law in enumerate(traction)
    ]
    difference = np.abs(balls.motion.spin_difference) if spins else np.zeros_like(balls.motion.spin_difference)

    def on(rung: Rung) -> SlipFriction:
        return slip_friction(
            *races, ring_speed=ring_speed[:, None], spin_difference=difference, spin_rule=spin_rule, rung=rung
        )

    rung: Rung = "single_coefficient"
    found = on(rung)
    missed, weight = _missed(races, found)
    slender = _slenderness(balls)
    error = np.sum((missed + slender) * weight, axis=(0, 2))
    whole = balls.total(found.torque.spin + found.torque.conformity)
    part = np.divide(whole, whole + beside, out=np.zeros_like(whole), where=whole > 0)
    if np.any(error * part > allowed):
        error = np.sum(slender * weight, axis=(0, 2))
        rung = "along_axis"
        if np.any(error * part > allowed):
            error, rung = np.full_like(error, QUADRATURE), "over_ellipse"
        found = on(rung)
    return Sliding(
        spin=balls.total(found.torque.spin),
        conformity=balls.total(found.torque.conformity),
        coefficient=np.stack([found.inner_coefficient, found.outer_coefficient]),
        rung=rung,
        error=error,
    )


def rolling_power(balls: LoadedBalls) -> Array:
    """(2, n, m) torque of conformity without spin per N of friction force, m: 0.0806 b^2/R w_roll/w."""
    _, moment = microslip_moments(
        friction_coefficient=1.0,
        load=1.0,
        semi_axis_transverse=balls.contact.semi_axis_y,
        deformed_radius=balls.deformed_radius,
        spin_to_roll=0.0,
    )
    return moment * balls.rolling_rate


def largest_spin_rise(balls: LoadedBalls) -> Array:
    """(2, n, m) how much a race that takes all of the spin can add per N of friction force, m.

    The spin moment grows from 0 with a slope that never exceeds its first, and to no more than 3/8 mu Q b, and the
    power by slip grows with spin as the moment does: at most 0.458 eps b w_s/w, at most 3/8 b w_s/w.
    """
    spin, b = np.abs(balls.motion.spin_difference), balls.contact.semi_axis_y
    ratio = spin * balls.deformed_radius / balls.rolling_rate  # eps b, m
    return np.minimum(SPIN_STIFFNESS / 2 * ratio, 3 / 8 * b) * spin


def _missed(races: list[RaceContact], found: SlipFriction) -> tuple[Array, Array]:
    """(2, n, m) what one coefficient misses on each contact; its weight, the contact's part of the power at a point."""
    torque = found.torque
    power = np.stack(
        [
            torque.inner_spin_moment * torque.inner_spin_rate + torque.inner_rolling_moment * races[0].rolling_rate,
            torque.outer_spin_moment * torque.outer_spin_rate + torque.outer_rolling_moment * races[1].rolling_rate,
        ]
    )
    whole = np.sum(power, axis=(0, 2), keepdims=True)
    weight = np.divide(power, whole, out=np.zeros_like(power), where=whole > 0)
    slips = (found.inner_slip_speed, found.outer_slip_speed)
    return np.stack([_missed_by_one(race, slip) for race, slip in zip(races, slips, strict=True)]), weight


def _missed_by_one(race: RaceContact, slip: Array) -> Array:
    if isinstance(race.traction, CoulombTraction):
        return np.zeros_like(slip)
    pressure = np.divide(race.load, race.area, out=np.zeros_like(slip), where=np.asarray(race.area) > 0)
    up, down = 1 + SPREAD, 1 / (1 + SPREAD)

    def exponent(high: Array, low: Array) -> Array:
        both = (high > 0) & (low > 0)
        return np.log(np.divide(high, low, out=np.ones_like(high), where=both)) / (2 * np.log(up))

    stress = race.traction.stress
    follows = exponent(stress(up * pressure, slip), stress(down * pressure, slip))
    missed = EVEN_STRESS * np.maximum(1 - follows, 0.0)
    if race.traction.asks_speed:
        missed = np.maximum(missed, KINK) + VISCOUS * exponent(
            stress(pressure, up * slip), stress(pressure, down * slip)
        )
    return missed


def _slenderness(balls: LoadedBalls) -> Array:
    """(2, n, m) E(m) - 1; that of a circle where the contact is longer along rolling."""
    a, b = balls.contact.semi_axis_x, balls.contact.semi_axis_y
    ratio = np.divide(a, b, out=np.zeros_like(b), where=b > 0)
    return ellipe(1 - np.minimum(ratio, 1.0) ** 2) - 1
