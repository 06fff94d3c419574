"""How much radial load, moment and inertia do to the balls beside the thrust, before any of them is solved for."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_non_negative, require_positive
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.loads.inertia import centrifugal_ratio, gyroscopic_pull, inertia_ratios, ratio
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle, Operation

# Heaviest ball of Z under a radial load Fr without clearance: 4.37 Fr/Z [Stribeck1907]: it is the load-distribution
# integral of point contacts, 1/J_r(0.5) = 4.37.
STRIBECK = 4.37
THRUST_ALONE = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadShares:
    """Each (n,), >= 0, infinite where a part has nothing to be compared with."""

    thrust: LoadedBalls | None  # the balls under the thrust alone, without inertia; None where a point has no thrust
    unequal: Array  # `load_distribution_ratio`
    waves: Array  # |e1| + e2 of `load_waves`
    centrifugal: Array  # `centrifugal_ratio` of the heaviest ball, about
    pull: Array  # `gyroscopic_pull`, likewise


def load_shares(bearing: Bearing, contact_angle: ContactAngle, operation: Operation) -> LoadShares:
    """operation : every array (n,). Raises InputError and ConvergenceError as thrust_equilibrium does."""
    axial, radial, moment = operation.axial_load, np.abs(operation.radial_load), np.abs(operation.moment)
    thrust = None
    angle, load = np.zeros_like(axial), np.abs(axial) / bearing.ball_count
    # Without any load the error of the thrust's equilibrium is the right one.
    if np.all(axial > 0) or operation.is_thrust:
        thrust = thrust_balls(bearing, contact_angle, operation, THRUST_ALONE)
        angle, load = np.max(thrust.contact_angle, axis=(0, 2)), np.max(thrust.load, axis=(0, 2))
    # Of the heaviest ball, about: the thrust may be next to nothing compared with the rest.
    load = load + STRIBECK * (radial + moment / bearing.pitch_diameter) / bearing.ball_count
    unequal = load_distribution_ratio(
        axial_load=axial, radial_load=radial, moment=moment, contact_angle=angle, pitch_diameter=bearing.pitch_diameter
    )
    centrifugal, pull = inertia_ratios(bearing, inner_speed=operation.inner_speed, contact_angle=angle, load=load)
    return LoadShares(
        thrust=thrust,
        unequal=unequal if operation.is_thrust else np.where(axial > 0, unequal, np.inf),
        waves=_waves(bearing, operation, thrust),
        centrifugal=centrifugal,
        pull=pull,
    )


def load_waves(
    bearing: Bearing,
    *,
    axial_load: ArrayLike,
    radial_load: ArrayLike,
    moment: ArrayLike,
    contact_angle: ArrayLike,
    approach: ArrayLike,
) -> tuple[Array, Array]:
    """(e1, e2) of the ball loads Q_j = Q (1 + e1 cos psi + e2 cos 2 psi) of a ring that is free to tilt.

    axial_load : Fa, N, > 0;  radial_load : Fr along x, N;  moment : M about y, N m; small beside the thrust, any sign
    contact_angle, approach : al, rad, and delta of both races, m, under the thrust alone;  all broadcast
        e1 = (2 sin al/Fa)(Fr cos al - (M/R) sin al),  R the radius of the inner groove centres
        U/A0 = (2 sin al/Fa)(Fr sin al + (M/R) cos al),  e2 = (3/8) A0 (U/A0)^2/delta
    U is how far each groove slips along its contact, in a mode that no contact resists to first order: its square
    still lifts balls, by nanometres, and so e2 goes as Fa^(-2/3) at equal loads' ratio. Good to 1 % of Q below 0.1.
    Derived here from the forces on the ring; `analytic.loads.ring` has it without the assumption of small waves.
    """
    require_positive(axial_load=axial_load, approach=approach)
    sine, cosine = np.sin(contact_angle), np.cos(contact_angle)
    across = np.asarray(moment) / (bearing.inner.bottom_radius + bearing.inner.groove_radius)  # M/R
    per_load = 2 * sine / np.asarray(axial_load)
    first = per_load * (np.asarray(radial_load) * cosine - across * sine)
    slipped = per_load * (np.asarray(radial_load) * sine + across * cosine)
    return first, 3 / 8 * bearing.groove_centre_distance * slipped**2 / np.asarray(approach)


def own_forces_of_lightest(bearing: Bearing, operation: Operation, balls: LoadedBalls) -> tuple[Array, Array, Array]:
    """(F_c, gyroscopic force M_g/r, weight), each over the load of the ball where it is largest; each (n,).

    balls : at any loads; the load is that of the race which presses less, and M_g that of a ball that rolls upright
    """
    speed = np.abs(operation.inner_speed)[:, None]
    cage_speed = speed * np.abs(balls.motion.cage_speed)
    load = balls.load.min(axis=0)
    centrifugal = centrifugal_ratio(
        ball_mass=bearing.ball_mass, pitch_diameter=bearing.pitch_diameter, cage_speed=cage_speed, load=load
    )
    gyroscopic = gyroscopic_pull(
        ball_mass=bearing.ball_mass,
        ball_radius=bearing.ball_radius,
        ball_speed=speed * np.abs(balls.motion.ball_speed),
        cage_speed=cage_speed,
        contact_angle=0.0,
        load=load,
    )
    weight = ratio(bearing.ball_mass * STANDARD_GRAVITY, over=load)
    return centrifugal.max(axis=1), gyroscopic.max(axis=1), weight.max(axis=1)


def _waves(bearing: Bearing, operation: Operation, thrust: LoadedBalls | None) -> Array:
    if operation.is_thrust or thrust is None:
        return np.full_like(operation.axial_load, 0.0 if operation.is_thrust else np.inf)
    first, second = load_waves(
        bearing,
        axial_load=operation.axial_load,
        radial_load=operation.radial_load,
        moment=operation.moment,
        contact_angle=thrust.contact_angle[0, :, 0],
        approach=thrust.contact.approach.sum(axis=0)[:, 0],
    )
    return np.abs(first) + second


def load_distribution_ratio(
    *,
    axial_load: ArrayLike,
    radial_load: ArrayLike,
    moment: ArrayLike,
    contact_angle: ArrayLike,
    pitch_diameter: ArrayLike,
) -> Array:
    """(Fr tan(al) + 2 M/d_m)/Fa: how unequal radial load and moment make balls that thrust loads alike.

    axial_load, radial_load : Fa, Fr, N;  moment : M, N m;  contact_angle : al, under the thrust, rad, 0 to pi/2
    pitch_diameter : d_m, m, > 0
    All arguments are magnitudes and broadcast; the ratio is infinite without axial load.
    """
    require_positive(pitch_diameter=pitch_diameter)
    require_non_negative(axial_load=axial_load, radial_load=radial_load, moment=moment, contact_angle=contact_angle)
    other = np.asarray(radial_load) * np.tan(contact_angle) + 2 * np.asarray(moment) / np.asarray(pitch_diameter)
    return ratio(other, over=axial_load)
