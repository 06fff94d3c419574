"""Decides load distribution, inertia of the balls, and finite geometry of their contacts.

Thrust alone loads all balls alike, in closed form but for the angle, at speed too; radial load and moment take the
equilibrium of the ring (`analytic.loads`). Contacts are Hertz's, or corrected for their finite geometry.
"""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES
from analytic.errors import InputError, require_non_negative, require_positive
from analytic.loads.balls import LoadedBalls, LoadEffects, loaded_balls, thrust_balls
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.inertia import inertia_ratios, ratio
from analytic.loads.thrust import play_and_free_angle
from analytic.scene import Array, Operation, Scene

# Heaviest ball of Z under a radial load Fr without clearance: 4.37 Fr/Z [Stribeck1907]: it is the load-distribution
# integral of point contacts, 1/J_r(0.5) = 4.37.
STRIBECK = 4.37
# Change of the torque over how unequal the balls' loads are: below 0.7 where they are little so, 1.13 at most.
PER_DISTRIBUTION = 1.25
# Change of the torque over the centrifugal force's share of the ball load: 4/3 to 5/3 by the outer race's load alone.
# The contact angles change too: 4.0 at most (tests/analytic/effects/test_effect_bounds.py compares with measured ones).
PER_CENTRIFUGAL = 4.5
# Balls that the load leaves free are pressed on the outer race by that force alone and roll against the oil there. The
# torque follows the semi-axis, the cube root of the force: in random scenes the change was at most 8.4 cube roots of
# the share. No ball is free below a load distribution of 0.6 at constant angles (eps = 1 of the load-distribution
# integrals). Under a light moment, which changes the angles, some are from 0.25 on
# (tests/analytic/effects/test_light_loads.py).
PER_FREE_BALL, UNLOADS = 10.0, 0.15
# Centrifugal force over the ball load beyond which balls hang in the outer race and skid on the inner one. A bearing
# needs at least a hundredth of that to roll, and the equilibrium of the ring converges up to some 6000.
MOST_CENTRIFUGAL = 1000.0
# Change of the torque over (b/r)^2 by the finite geometry of contacts under thrust: 0.48 at most, of grooves, loads and
# angles drawn (tests/analytic/effects/test_effect_bounds.py compares a few).
PER_SIZE_SQUARED = 0.5
STILL = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)


def chosen_balls(
    scene: Scene, operation: Operation, ledger: Ledger, *, correction: ContactCorrection | None
) -> tuple[LoadedBalls, list[str]]:
    """The balls at each operating point, and warnings; decides load_distribution to finite_geometry.

    operation : the scene's, every array (n,)
    correction : the caller's factors on Hertz's contacts; None: those of the finite geometry, if it is on
    Raises InputError for loads that no method takes.
    """
    bearing, contact_angle = scene.bearing, scene.contact_angle
    thrust = None
    # Without any load the error of the thrust's equilibrium is the right one.
    if np.all(operation.axial_load > 0) or operation.is_thrust:
        thrust = thrust_balls(bearing, contact_angle, operation, STILL)
    effects = load_effects(scene, operation, ledger, thrust=thrust)
    if correction is not None:
        ledger.settle("finite_geometry", on=True, reason="the factors on the contacts come with the call")
        return loaded_balls(bearing, contact_angle, operation, effects, correction=correction), []
    balls = (
        thrust if effects == STILL and thrust is not None else loaded_balls(bearing, contact_angle, operation, effects)
    )
    if not takes_finite_geometry(scene, balls, ledger):
        return balls, []
    corrections = corrections_of(bearing, balls)
    if not np.any(corrections.inner.covered | corrections.outer.covered):
        share = ledger.made["finite_geometry"].share
        ledger.settle(
            "finite_geometry",
            on=False,
            share=None if share is None else np.asarray(share),
            reason="the fit of the correction does not cover these contacts: " + "; ".join(corrections.warnings),
        )
        return balls, list(corrections.warnings)
    corrected = loaded_balls(bearing, contact_angle, operation, effects, correction=corrections.correction)
    return corrected, list(corrections.warnings)


def load_effects(scene: Scene, operation: Operation, ledger: Ledger, *, thrust: LoadedBalls | None) -> LoadEffects:
    """Decides load_distribution, centrifugal and gyroscopic.

    thrust : the balls under the thrust alone, without inertia; None where some point has no thrust
    Raises InputError for loads that no method takes.
    """
    bearing, axial = scene.bearing, operation.axial_load
    radial, moment = np.abs(operation.radial_load), np.abs(operation.moment)
    lacks = ENTRIES["load_distribution"].lacks(scene)
    if thrust is not None:
        angle, load = np.max(thrust.contact_angle, axis=(0, 2)), np.max(thrust.load, axis=(0, 2))
    else:
        angle, load = np.zeros_like(axial), np.abs(axial) / bearing.ball_count
    # Of the heaviest ball, about: the thrust may be next to nothing compared with the rest.
    load = load + STRIBECK * (radial + moment / bearing.pitch_diameter) / bearing.ball_count
    share = load_distribution_ratio(
        axial_load=axial, radial_load=radial, moment=moment, contact_angle=angle, pitch_diameter=bearing.pitch_diameter
    )
    share = share if operation.is_thrust else np.where(axial > 0, share, np.inf)
    distributed = ledger.decide("load_distribution", bound=PER_DISTRIBUTION * share)
    if not distributed and (thrust is None or (lacks and np.any(share > scene.tolerance))):
        raise InputError(
            f"operation.radial_load and operation.moment are up to {share.max():.3g} of what thrust does, and "
            + (lacks or "without thrust they are the whole load: leave effects.load_distribution on auto")
        )
    centrifugal_share, pull = inertia_ratios(bearing, inner_speed=operation.inner_speed, contact_angle=angle, load=load)
    rolls = scene.lubricant is not None and scene.effects.get("rolling") != "off"
    free = PER_FREE_BALL * np.cbrt(centrifugal_share) * (rolls & distributed & (share > UNLOADS))
    centrifugal = ledger.decide("centrifugal", bound=PER_CENTRIFUGAL * centrifugal_share + free)
    worst = int(np.argmax(centrifugal_share))
    if centrifugal and centrifugal_share[worst] > MOST_CENTRIFUGAL:
        raise InputError(
            f"operation.inner_speed = {operation.inner_speed[worst]:g} rad/s: the centrifugal force of a ball is "
            f"{centrifugal_share[worst]:.3g} times its load under {axial[worst]:g} N of thrust, above "
            f"{MOST_CENTRIFUGAL:g}, and it skids: raise the load or lower the speed"
        )
    # Friction that holds the moment turns the force on a free ball; a moment on the ring may bring it to any angle.
    turned = free * np.where((moment > 0) & (thrust is None), 1.0, np.sin(angle))
    gyroscopic = ledger.decide("gyroscopic", bound=pull + turned)
    return LoadEffects(load_distribution=distributed, centrifugal=centrifugal, gyroscopic=gyroscopic)


def takes_finite_geometry(scene: Scene, balls: LoadedBalls, ledger: Ledger) -> bool:
    """Decides finite_geometry, from the balls with Hertz's contacts."""
    size = np.max(balls.contact.semi_axis_y, axis=(0, 2)) / scene.bearing.ball_radius
    # Where balls are loaded unequally or by a preload, a stiffer contact changes loads and angles: no bound is known.
    preloaded = scene.contact_angle.rule == "solved" and play_and_free_angle(scene.bearing, scene.contact_angle)[0] < 0
    bounded = not preloaded and not ledger.is_on("load_distribution")
    return ledger.decide("finite_geometry", bound=PER_SIZE_SQUARED * size**2 if bounded else None)


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
