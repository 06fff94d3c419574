"""Decides load distribution, inertia of the balls, and finite geometry of their contacts.

Thrust alone loads all balls alike, in closed form but for the angle, at speed too; radial load and moment take the
equilibrium of the ring. Contacts are Hertz's, or corrected for their finite geometry. `analytic.loads` computes all of
these; the decisions read numbers alone.
"""

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import Ledger
from analytic.effects.table import (
    ENTRIES,
    PER_CENTRIFUGAL,
    PER_DISTRIBUTION,
    PER_FREE_BALL,
    PER_SIZE_SQUARED,
    UNLOADS,
)
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, LoadEffects, loaded_balls
from analytic.loads.finite_geometry import corrected_balls
from analytic.loads.shares import THRUST_ALONE, LoadShares, load_shares
from analytic.loads.thrust import play_and_free_angle
from analytic.scene import Operation, Scene

# Centrifugal force over the ball load beyond which balls hang in the outer race and skid on the inner one. A bearing
# needs at least a hundredth of that to roll, and the equilibrium of the ring converges up to some 6000.
MOST_CENTRIFUGAL = 1000.0


def chosen_balls(
    scene: Scene, operation: Operation, ledger: Ledger, *, correction: ContactCorrection | None
) -> tuple[LoadedBalls, list[str]]:
    """The balls at each operating point, and warnings; settles load_distribution to finite_geometry.

    operation : the scene's, every array (n,)
    correction : the caller's factors on Hertz's contacts; None: those of the finite geometry, if it is on
    Raises InputError for loads that no method takes.
    """
    bearing, contact_angle = scene.bearing, scene.contact_angle
    shares = load_shares(bearing, contact_angle, operation)
    effects = _decide_load_effects(operation, shares, ledger)
    if correction is not None:
        ledger.settle("finite_geometry", on=True, reason=ENTRIES["finite_geometry"].given)
        return loaded_balls(bearing, contact_angle, operation, effects, correction=correction), []
    known = shares.thrust if effects == THRUST_ALONE else None
    balls = loaded_balls(bearing, contact_angle, operation, effects) if known is None else known
    if not _decide_finite_geometry(scene, balls, ledger):
        return balls, []
    corrected, warnings = corrected_balls(bearing, contact_angle, operation, effects, balls)
    if corrected is None:
        reason = f"{ENTRIES['finite_geometry'].idle}: {'; '.join(warnings)}"
        ledger.settle("finite_geometry", on=False, share=ledger.made["finite_geometry"].share, reason=reason)
        return balls, warnings
    return corrected, warnings


def _decide_load_effects(operation: Operation, shares: LoadShares, ledger: Ledger) -> LoadEffects:
    """load_distribution, centrifugal and gyroscopic. Raises InputError for loads that no method takes."""
    scene, unequal = ledger.scene, shares.unequal
    distributed = ledger.decide("load_distribution", bound=PER_DISTRIBUTION * unequal)
    lacks = ENTRIES["load_distribution"].lacks(scene)
    if not distributed and (shares.thrust is None or (lacks and np.any(unequal > scene.tolerance))):
        raise InputError(
            f"operation.radial_load and operation.moment are up to {unequal.max():.3g} of what thrust does, and "
            + (lacks or "without thrust they are the whole load: leave effects.load_distribution on auto")
        )
    rolls = scene.lubricant is not None and not ledger.rules_out("rolling")
    free = PER_FREE_BALL * np.cbrt(shares.centrifugal) * (rolls & distributed & (unequal > UNLOADS))
    centrifugal = ledger.decide("centrifugal", bound=PER_CENTRIFUGAL * shares.centrifugal + free)
    worst = int(np.argmax(shares.centrifugal))
    if centrifugal and shares.centrifugal[worst] > MOST_CENTRIFUGAL:
        raise InputError(
            f"operation.inner_speed = {operation.inner_speed[worst]:g} rad/s: the centrifugal force of a ball is "
            f"{shares.centrifugal[worst]:.3g} times its load under {operation.axial_load[worst]:g} N of thrust, above "
            f"{MOST_CENTRIFUGAL:g}, and it skids: raise the load or lower the speed"
        )
    # Friction that holds the moment turns the force on a free ball; a moment on the ring may bring it to any angle.
    tilted = (np.asarray(operation.moment) != 0) & (shares.thrust is None)
    turned = free * np.where(tilted, 1.0, np.sin(shares.contact_angle))
    gyroscopic = ledger.decide("gyroscopic", bound=shares.pull + turned)
    return LoadEffects(load_distribution=distributed, centrifugal=centrifugal, gyroscopic=gyroscopic)


def _decide_finite_geometry(scene: Scene, balls: LoadedBalls, ledger: Ledger) -> bool:
    """balls : with Hertz's contacts."""
    size = np.max(balls.contact.semi_axis_y, axis=(0, 2)) / scene.bearing.ball_radius
    # Where balls are loaded unequally or by a preload, a stiffer contact changes loads and angles: no bound is known.
    preloaded = scene.contact_angle.rule == "solved" and play_and_free_angle(scene.bearing, scene.contact_angle)[0] < 0
    bounded = not preloaded and not ledger.is_on("load_distribution")
    return ledger.decide("finite_geometry", bound=PER_SIZE_SQUARED * size**2 if bounded else None)
