"""From the loads on the bearing to its loaded balls, by the cheapest rung that the scene calls for.

Thrust alone loads all balls alike, in closed form but for the angle, at speed too; radial load and moment take the
equilibrium of the ring. Contacts are Hertz's, or corrected for their finite geometry.
"""

from collections.abc import Callable

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.contact.finite_geometry import RaceCorrections, finite_geometry_factors, race_shape
from analytic.contact.geometry import RACES
from analytic.effects.bounds import centrifugal_ratio, gyroscopic_pull, load_distribution_ratio
from analytic.effects.ledger import Ledger
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls, ring_balls, thrust_balls, thrust_balls_at_speed
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.thrust import play_and_free_angle
from analytic.scene import Array, Bearing, Operation, Scene

# Heaviest ball of Z under a radial load Fr without clearance: 4.37 Fr/Z (Stribeck; R. Stribeck, ASME Trans. 29 (1907),
# not seen: it is the load-distribution integral of point contacts, 1/J_r(0.5) = 4.37).
STRIBECK = 4.37
# Change of the torque over how unequal the balls' loads are: below 0.7 where they are little so, 1.13 at most.
PER_DISTRIBUTION = 1.25
# Change of the torque over the centrifugal force's share of the ball load: 4/3 to 5/3 by the outer race's load alone,
# and the contact angles part: 4.0 at most (compared with measured shares in tests/analytic/effects/test_effects.py).
PER_CENTRIFUGAL = 4.5
# Balls that the load leaves free are pressed on the outer race by that force alone and roll against the oil there, as
# the semi-axis, the cube root of the force: 8.4 times the cube root of the share at most, of the scenes drawn. None is
# free below a load distribution of 0.6 at angles that stay (eps = 1 of the load-distribution integrals); under a light
# moment, whose angles follow, some are from 0.25 on (tests/analytic/effects/test_light_loads.py).
PER_FREE_BALL, UNLOADS = 10.0, 0.15
# Centrifugal force over the ball load beyond which balls hang in the outer race and skid on the inner; a bearing asks
# for a hundredth of that at least to roll, and the equilibrium of the ring settles to some 6000.
MOST_CENTRIFUGAL = 1000.0
# Change of the torque over (b/r)^2 by the finite geometry of contacts under thrust: 0.48 at most, of grooves, loads and
# angles drawn (tests/analytic/effects/test_effects.py compares a few).
PER_SIZE_SQUARED = 0.5


def loaded_balls(
    scene: Scene, operation: Operation, ledger: Ledger, *, correction: ContactCorrection | None
) -> tuple[LoadedBalls, list[str]]:
    """The balls at each operating point, and warnings; decides load_distribution to finite_geometry.

    operation : the scene's, every array (n,)
    correction : factors on Hertz's contacts that the caller brings; None: those of the finite geometry, if called for
    Raises InputError for loads that no rung takes.
    """
    solve = _rung(scene, operation, ledger)
    balls = solve(correction)
    if correction is not None:
        ledger.settle("finite_geometry", on=True, reason="the factors on the contacts come with the call")
        return balls, []
    size = np.max(balls.contact.semi_axis_y, axis=(0, 2)) / scene.bearing.ball_radius
    # Where balls are loaded unequally or by a preload, a stiffer contact moves loads and angles: no bound is known.
    preloaded = scene.contact_angle.rule == "solved" and play_and_free_angle(scene.bearing, scene.contact_angle)[0] < 0
    bounded = not preloaded and not ledger.is_on("load_distribution")
    if not ledger.decide("finite_geometry", bound=PER_SIZE_SQUARED * size**2 if bounded else None):
        return balls, []
    # Not iterated: corrected contacts move loads and angles by less than a hundredth, and the factors, within 0.06 of
    # 1, follow the load's power 1/3 to 2/3, so by less than 1e-4 more.
    found = corrections_of(scene.bearing, balls)
    return solve(found.correction), list(found.warnings)


def corrections_of(bearing: Bearing, balls: LoadedBalls) -> RaceCorrections:
    """For the finite geometry of both races, at their loads and angles; (n,) under thrust, else (n, m).

    A contact without load has no place on its race, and its factors are 1.
    """
    each = (..., 0) if balls.rung == "thrust" else ...  # what a solution takes an element of a factor for
    inner, outer = (
        finite_geometry_factors(
            race_shape(bearing, race, contact_angle=np.where(load > 0, angle, 0.0)[each], ball_load=load[each])
        )
        for race, angle, load in zip(RACES, np.abs(balls.contact_angle), balls.load, strict=True)
    )
    return RaceCorrections(inner=inner, outer=outer)


def _rung(scene: Scene, operation: Operation, ledger: Ledger) -> Callable[[ContactCorrection | None], LoadedBalls]:
    """The way to the loaded balls that is called for, as a function of factors on Hertz's contacts."""
    bearing, axial, radial = scene.bearing, operation.axial_load, np.abs(operation.radial_load)
    moment, given = np.abs(operation.moment), scene.contact_angle.rule == "given"
    held = 'contact_angle.rule = "given" holds the angle that it would change: use "solved"' if given else None
    unequal = np.any(radial > 0) or np.any(moment > 0)
    thrust: LoadedBalls | None = None
    if np.all(axial > 0) or not unequal:  # without any load the thrust's error is the right one
        thrust = thrust_balls(bearing, scene.contact_angle, axial_load=axial)
        angle, load = np.max(thrust.contact_angle, axis=(0, 2)), np.max(thrust.load, axis=(0, 2))
    else:
        angle, load = np.zeros_like(axial), np.abs(axial) / bearing.ball_count
    # What the heaviest ball has, about: thrust may be next to nothing beside the rest.
    load = load + STRIBECK * (radial + moment / bearing.pitch_diameter) / bearing.ball_count
    share = load_distribution_ratio(
        axial_load=axial, radial_load=radial, moment=moment, contact_angle=angle, pitch_diameter=bearing.pitch_diameter
    )
    share = np.where(axial > 0, share, np.inf) if unequal else share
    distributed = ledger.decide("load_distribution", bound=PER_DISTRIBUTION * share)
    if not distributed and (thrust is None or (given and np.any(share > scene.tolerance))):
        raise InputError(
            f"operation.radial_load and operation.moment are up to {share.max():.3g} of what thrust does, and "
            + (held or "without thrust they are the whole load: leave effects.load_distribution on auto")
        )
    ratio, pull = inertia_shares(bearing, inner_speed=operation.inner_speed, contact_angle=angle, load=load)
    rolls = scene.lubricant is not None and scene.effects.get("rolling") != "off"
    free = PER_FREE_BALL * np.cbrt(ratio) * (rolls & distributed & (share > UNLOADS))
    centrifugal = ledger.decide("centrifugal", bound=PER_CENTRIFUGAL * ratio + free)
    worst = int(np.argmax(ratio))
    if centrifugal and ratio[worst] > MOST_CENTRIFUGAL:
        raise InputError(
            f"operation.inner_speed = {operation.inner_speed[worst]:g} rad/s: the centrifugal force of a ball is "
            f"{ratio[worst]:.3g} times its load under {axial[worst]:g} N of thrust, above {MOST_CENTRIFUGAL:g}, and it "
            "skids: raise the load or lower the speed"
        )
    gyroscopic = ledger.decide(
        "gyroscopic",
        bound=pull
        # Friction that holds the moment turns the force on a free ball; a moment on the ring may bring it to any angle.
        + free * np.where((moment > 0) & (thrust is None), 1.0, np.sin(angle)),
    )
    if thrust is not None and not (distributed and unequal):

        def under_thrust(correction: ContactCorrection | None) -> LoadedBalls:
            if centrifugal or gyroscopic:
                return thrust_balls_at_speed(
                    bearing,
                    scene.contact_angle,
                    axial_load=axial,
                    inner_speed=operation.inner_speed,
                    centrifugal=centrifugal,
                    gyroscopic=gyroscopic,
                    correction=correction,
                )
            if correction is None:
                return thrust
            return thrust_balls(bearing, scene.contact_angle, axial_load=axial, correction=correction)

        return under_thrust

    def of_ring(correction: ContactCorrection | None) -> LoadedBalls:
        return ring_balls(
            bearing,
            scene.contact_angle,
            correction=correction,
            axial_load=axial,
            radial_load=operation.radial_load if distributed else 0.0,
            moment=operation.moment if distributed else 0.0,
            inner_speed=operation.inner_speed,
            centrifugal=centrifugal,
            gyroscopic=gyroscopic,
        )

    return of_ring


def inertia_shares(bearing: Bearing, *, inner_speed: Array, contact_angle: Array, load: Array) -> tuple[Array, Array]:
    """(centrifugal force, pull of the gyroscopic moment) of a ball over its load, each (n,).

    inner_speed : rad/s, the outer ring stands still;  contact_angle : al, the same on both races, rad;  load : Q, N
    """
    motion = ball_kinematics(
        inner_speed=inner_speed,
        inner_angle=contact_angle,
        outer_angle=contact_angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    cage, ball = np.abs(motion.cage_speed), np.abs(motion.ball_speed)
    centrifugal = centrifugal_ratio(
        ball_mass=bearing.ball_mass, pitch_diameter=bearing.pitch_diameter, cage_speed=cage, load=load
    )
    pull = gyroscopic_pull(
        ball_mass=bearing.ball_mass,
        ball_radius=bearing.ball_radius,
        ball_speed=ball,
        cage_speed=cage,
        contact_angle=contact_angle,
        load=load,
    )
    return centrifugal, pull


def points(scene: Scene) -> Operation:
    """The scene's operation with every array (n,). Raises InputError if there is no point or shapes do not fit."""
    names = ("axial_load", "inner_speed", "radial_load", "moment")
    try:
        arrays: tuple[Array, ...] = np.broadcast_arrays(
            *(np.atleast_1d(getattr(scene.operation, name)) for name in names)
        )
    except ValueError as problem:
        raise InputError("the arrays of operation have shapes that do not fit: give equal lengths") from problem
    if arrays[0].size == 0:
        raise InputError("operation.axial_load is empty: give at least one operating point")
    return Operation(**dict(zip(names, arrays, strict=True)))
