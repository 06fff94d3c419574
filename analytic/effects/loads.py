"""Decides load distribution, inertia of the balls, and finite geometry of their contacts.

Thrust alone loads all balls alike, in closed form but for the angle, at speed too; radial load and moment take the
equilibrium of the ring. A closed estimate of the balls' loads says when that is solved whatever the tolerance; then the
state of the balls says whether their own forces count. Contacts are Hertz's, or corrected for their finite geometry.
`analytic.loads` computes all of these; the decisions read numbers alone.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.contact.finite_geometry import RaceCorrections
from analytic.effects.ledger import Ledger
from analytic.effects.table import (
    ENTRIES,
    LARGEST_WAVES,
    PER_CENTRIFUGAL,
    PER_DISTRIBUTION,
    PRESSED,
)
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, LoadEffects, loaded_balls
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.shares import LoadShares, load_shares, own_forces_of_lightest
from analytic.scene import Array, Operation, Scene
from analytic.words import NEWTON, NEWTON_MILLIMETRE, percent_of, speed_of

# Centrifugal force over the ball load beyond which balls hang in the outer race and skid on the inner one. A bearing
# needs at least a hundredth of that to roll, and the equilibrium of the ring converges up to some 6000.
MOST_CENTRIFUGAL = 1000.0
TINIEST = 1e-300  # keeps a bearing at standstill from a division by 0


@dataclass(frozen=True, kw_only=True, eq=False)
class ChosenBalls:
    """The loaded balls, and what is known of the correction of their contacts."""

    balls: LoadedBalls
    effects: LoadEffects
    correction: ContactCorrection | None  # factors on Hertz's contacts that the loads were solved with
    warnings: tuple[str, ...] = ()
    # Factors on Hertz's contacts at the far end of what is not known outside the fit's range; None: all lie within
    farthest: ContactCorrection | None = None
    # (n,) whether the balls' weight counts and nobody knows its direction: its spread is part of the uncertainty
    any_direction: NDArray[np.bool_]

    def turning(self, balls: LoadedBalls) -> "ChosenBalls":
        """The same with balls that turn in another way."""
        return replace(self, balls=balls)


def chosen_balls(
    scene: Scene, operation: Operation, ledger: Ledger, *, correction: ContactCorrection | None
) -> ChosenBalls:
    """The balls at each operating point; settles load_distribution to finite_geometry.

    operation : the scene's, every array (n,)
    correction : the caller's factors on Hertz's contacts; None: those of the finite geometry, if it is on
    Raises InputError for loads that no method takes.
    """
    bearing, contact_angle = scene.bearing, scene.contact_angle
    if bearing.kind == "thrust":
        _require_thrust(operation)
    shares = load_shares(bearing, contact_angle, operation)
    distributed = _decide_distribution(shares, ledger)
    massless = LoadEffects(load_distribution=distributed, centrifugal=False, gyroscopic=False)
    solved = distributed and not operation.is_thrust
    if shares.thrust is not None and not solved:
        balls = shares.thrust
    else:
        balls = loaded_balls(bearing, contact_angle, operation, massless, correction=correction if solved else None)
    effects, any_direction = _decide_own_forces(operation, balls, shares, ledger, distributed=distributed)
    if correction is not None:
        ledger.settle("finite_geometry", on=True, reason=ENTRIES["finite_geometry"].given)
        balls = loaded_balls(bearing, contact_angle, operation, effects, correction=correction)
        return ChosenBalls(balls=balls, effects=effects, correction=correction, any_direction=any_direction)
    if effects != massless:
        balls = loaded_balls(bearing, contact_angle, operation, effects)
    found = corrections_of(bearing, balls)
    chosen = ChosenBalls(balls=balls, effects=effects, correction=None, any_direction=any_direction)
    if not _decide_finite_geometry(scene, found, ledger):
        return chosen
    farthest = None if np.all(found.inner.covered & found.outer.covered) else found.farthest
    chosen = replace(chosen, warnings=found.warnings, farthest=farthest)
    if not np.any(found.inner.applied + found.outer.applied):
        ledger.not_applied("finite_geometry", f"not applied: {'; '.join(found.warnings)}")
        return chosen
    corrected = loaded_balls(bearing, contact_angle, operation, effects, correction=found.correction)
    return replace(chosen, balls=corrected, correction=found.correction)


def _require_thrust(operation: Operation) -> None:
    """Raise InputError for loads that a thrust bearing does not take."""
    for name, unit in (("radial_load", NEWTON), ("moment", NEWTON_MILLIMETRE)):
        values = np.asarray(getattr(operation, name))
        if np.any(values):
            largest = unit.written(values.flat[np.argmax(np.abs(values))], "g")
            raise InputError(
                f"operation.{name} = {largest}: a thrust bearing carries axial_load alone; leave {name} out"
            )


def _decide_distribution(shares: LoadShares, ledger: Ledger) -> bool:
    """load_distribution. Raises InputError for loads that no method takes."""
    scene, unequal = ledger.scene, shares.unequal
    worst = float(np.max(shares.waves))
    distributed = ledger.decide(
        "load_distribution",
        bound=PER_DISTRIBUTION * unequal,
        demanded=f"ball loads change by {percent_of(worst)} of their mean, more than {percent_of(LARGEST_WAVES)}"
        if LARGEST_WAVES < worst < np.inf
        else None,
    )
    lacks = ENTRIES["load_distribution"].lacks(scene)
    if not distributed and (shares.thrust is None or (lacks and np.any(unequal > scene.tolerance))):
        raise InputError(
            f"operation.radial_load and operation.moment are up to {percent_of(unequal.max())} of what thrust does, "
            "and " + (lacks or "without thrust they are the whole load: leave effects.load_distribution on auto")
        )
    return distributed


def _decide_own_forces(
    operation: Operation, balls: LoadedBalls, shares: LoadShares, ledger: Ledger, *, distributed: bool
) -> tuple[LoadEffects, NDArray[np.bool_]]:
    """centrifugal, gyroscopic and weight; (n,) whether weight counts in an unknown direction.

    balls : without these. Raises InputError for balls that skid.
    """
    outward, across, weight = own_forces_of_lightest(ledger.scene.bearing, operation, balls)
    lightest = float(np.max(outward + weight))
    pressed = f"is {1 / max(lightest, TINIEST):.3g} times its own forces, below {PRESSED:g}"
    few = "a ball carries no load" if np.isinf(lightest) else f"the load of the lightest ball {pressed}"
    demanded = f"{few}: its own forces place it" if lightest * PRESSED > 1 else None
    turns = bool(np.any(operation.inner_speed))
    centrifugal = ledger.decide("centrifugal", bound=PER_CENTRIFUGAL * outward, demanded=demanded if turns else None)
    worst = int(np.argmax(shares.centrifugal))
    if ledger.scene.bearing.kind == "thrust" and shares.centrifugal[worst] * PRESSED > 1:
        raise InputError(
            f"operation.inner_speed = {speed_of(operation.inner_speed[worst])}: the centrifugal force of a ball is "
            f"{shares.centrifugal[worst]:.3g} times its load under {operation.axial_load[worst]:g} N of thrust, above "
            f"{1 / PRESSED:g}, and drives it out of the middle of its grooves, which is not modelled in a thrust "
            "bearing: raise the load or lower the speed"
        )
    if centrifugal and shares.centrifugal[worst] > MOST_CENTRIFUGAL:
        raise InputError(
            f"operation.inner_speed = {speed_of(operation.inner_speed[worst])}: the centrifugal force of a ball is "
            f"{shares.centrifugal[worst]:.3g} times its load under {operation.axial_load[worst]:g} N of thrust, above "
            f"{MOST_CENTRIFUGAL:g}, and it skids: raise the load or lower the speed"
        )
    # Under thrust alone the radial part of the friction that holds the moment moves no ball's angle to first order.
    gyroscopic = ledger.decide("gyroscopic", bound=shares.pull if balls.method == "thrust" else across)
    bound = PER_CENTRIFUGAL * weight
    weighs = ledger.decide("weight", bound=bound, demanded=demanded)
    unknown = ledger.scene.down is None and ledger.scene.contact_angle.rule == "solved"
    any_direction = np.zeros(bound.shape, dtype=bool)
    if unknown and not ledger.rules_out("weight"):
        any_direction = ~ledger.leaves_out_at(bound)
    effects = LoadEffects(
        load_distribution=distributed,
        centrifugal=centrifugal,
        gyroscopic=gyroscopic,
        down=ledger.scene.down if weighs else None,
    )
    return effects, any_direction


def _decide_finite_geometry(scene: Scene, found: RaceCorrections, ledger: Ledger) -> bool:
    """found : the correction of the balls with Hertz's contacts."""
    # Where balls are loaded unequally or by a preload, a stiffer contact changes loads and angles: no bound is known.
    preloaded = scene.contact_angle.rule == "solved" and play_and_free_angle(scene.bearing, scene.contact_angle)[0] < 0
    bounded = not preloaded and not ledger.is_on("load_distribution")
    if bounded and not ledger.rules_out("finite_geometry"):  # outside the fit's range its factors are no bound
        bounded = bool(np.all(found.inner.covered & found.outer.covered))
    return ledger.decide("finite_geometry", bound=_largest_change(found) if bounded else None)


def _largest_change(found: RaceCorrections) -> Array:
    """(n,) of the torque under thrust: sliding follows b^2 at most, the area a, and the angle the approach."""
    changes = []
    for race in (found.inner, found.outer):
        factors = race.factors
        b, a, approach = factors.semi_axis_transverse, factors.semi_axis_rolling, factors.approach
        changes.append(2 * np.abs(np.asarray(b) - 1) + np.abs(np.asarray(a) - 1) + np.abs(np.asarray(approach) - 1))
    change = np.maximum(*changes)
    return change if change.ndim < 2 else change.max(axis=-1)
