"""How much radial load, moment and inertia do to the balls beside the thrust, before any of them is solved for."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_non_negative, require_positive
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.loads.inertia import inertia_ratios, ratio
from analytic.scene import Array, Bearing, ContactAngle, Operation

# Heaviest ball of Z under a radial load Fr without clearance: 4.37 Fr/Z [Stribeck1907]: it is the load-distribution
# integral of point contacts, 1/J_r(0.5) = 4.37.
STRIBECK = 4.37
THRUST_ALONE = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadShares:
    """Each (n,), >= 0, infinite where a part has nothing to be compared with."""

    thrust: LoadedBalls | None  # the balls under the thrust alone, without inertia; None where a point has no thrust
    contact_angle: Array  # under the thrust alone, rad; 0 without it
    unequal: Array  # `load_distribution_ratio`
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
        contact_angle=angle,
        unequal=unequal if operation.is_thrust else np.where(axial > 0, unequal, np.inf),
        centrifugal=centrifugal,
        pull=pull,
    )


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
