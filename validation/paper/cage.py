"""The cage of each reading of [Paper]: how it moves, and which of its numbers is a torque.

[Paper] gives neither start, clearance that can be made, nor coefficient of friction. Three numbers of a motion have
the unit of a torque:

- power of sliding in the pockets over the speed of the ring. This is the friction torque: the ring supplies it.
- sum of the magnitudes of the friction moments about the balls' centres, mu (sum N) r. It is a load on the balls and no
  loss: a whirling cage rolls on its balls, so the friction has little sliding to act over.
- mean magnitude of the moment about the bearing's axis. Its sign changes and its mean is 0. It is no loss either.
"""

from dataclasses import replace

import numpy as np

from analytic.cage.motion import CageMotion
from analytic.cage.pocket import friction_in_pocket
from analytic.cage.statistics import CageStatistics
from analytic.cage.steady import DrivenCage
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import Array, Cage, CageStart, ContactAngle, Decision, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque

DRY = load_scene("6205-dry")
CATALOG_CAGE: Cage = DRY.cage  # pyright: ignore[reportAssignmentType]
ROUGH, SMOOTH = 1e-6, 0.1e-6  # Sq, m
RPM = np.pi / 30
SLOWEST, FASTEST = 100 * RPM, 500 * RPM  # rad/s, where [Paper] prints numbers
CLEARANCE = 0.1e-3  # m, of the calibrated reading
LOADED = 0.302  # rad, contact angle under 1000 N if 0.18 rad is the free angle
LOADED_ANGLE = ContactAngle(rule="solved", free=0.18)
# Ball on pocket, Sq -> at 100 and 500 rpm. With them the friction moments about the balls' centres are the cage torque
# of [Paper]; between, the coefficient is a power of the speed.
COEFFICIENTS = {ROUGH: (0.12, 0.069), SMOOTH: (0.10, 0.051)}
HELD_BALLS: dict[str, Decision] = {"cage_dynamics": "on", "ball_dynamics": "off"}
SPAN, SPANS = 10, 8000  # time steps in a span, and spans: for the mean magnitude of an alternating moment
FREE_SEEDS, FREE_DURATION = 2, 0.05  # of balls and cage together, which take a hundred times as long; s
SEEDS, DURATION = 8, 0.1  # many short motions: the largest force of one scatters at low speed; s, after as long a start


def at_finish(scene: Scene, rms_roughness: float) -> Scene:
    """The scene with another Sq of ball and races, m."""
    return replace(scene, surface=replace(scene.surface, rms_roughness=rms_roughness))


def printed_pocket() -> Cage:
    """The catalog's cage with the pocket of table 1 of [Paper]."""
    return replace(CATALOG_CAGE, pocket_diameter=13.9e-3, pocket_depth=6.81e-3)


def loose_cage(*, clearance: float, start: CageStart, friction_coefficient: float | None) -> Cage:
    """The catalog's cage in pockets of one sphere; clearance : of the diameter, m; None: mixed lubrication."""
    diameter = DRY.bearing.ball_diameter + clearance
    return replace(
        CATALOG_CAGE,
        pocket_diameter=diameter,
        pocket_depth=diameter / 2,
        start=start,
        friction_coefficient=friction_coefficient,
        seeds=SEEDS,
        duration=DURATION,
    )


def calibrated_coefficient(*, rms_roughness: float, inner_speed: float) -> float:
    """Friction coefficient of ball on pocket in the calibrated reading; inner_speed : rad/s."""
    slow, fast = COEFFICIENTS[rms_roughness]
    power = np.log(fast / slow) / np.log(FASTEST / SLOWEST)
    return float(slow * (inner_speed / SLOWEST) ** power)


def cage_scene(reading: str, scene: Scene, *, inner_speed: float) -> Scene:
    """The scene of a reading at one speed with its cage.

    as printed : the pocket of table 1, no loss in impacts (equation 14 has none), mixed lubrication; the start is
        assumed: the cage stands still and the balls run at full speed
    calibrated : clearance, whirl and coefficients that meet the paper's numbers, balls that turn about the loaded
        contact angle (the race torque was fitted at 0.18 rad)
    physical : the catalog's cage, mixed lubrication, a start that takes a fifth of a second
    """
    if reading == "as printed":
        cage = replace(printed_pocket(), restitution=1.0, start="sudden")
    elif reading == "calibrated":
        assert scene.surface.rms_roughness is not None
        coefficient = calibrated_coefficient(rms_roughness=scene.surface.rms_roughness, inner_speed=inner_speed)
        cage = loose_cage(clearance=CLEARANCE, start="whirl", friction_coefficient=coefficient)
        scene = replace(scene, contact_angle=LOADED_ANGLE)
    else:
        cage = replace(CATALOG_CAGE, start="ramp")
    return with_moving_cage(scene, cage, inner_speed=inner_speed)


def with_moving_cage(scene: Scene, cage: Cage, *, inner_speed: float) -> Scene:
    """The scene at one speed with a cage whose motion is computed, on balls that hold theirs; inner_speed : rad/s.

    The readings were chosen with such balls. Above a grip number of 0.9 they would slide: `ball_dynamics` is off, and
    `traction_share` shows it.
    """
    first = scene.operation.as_series().at(np.array([0]))
    operation = replace(first, inner_speed=np.array([inner_speed]))
    return replace(scene, cage=cage, operation=operation, effects={**scene.effects, **HELD_BALLS})


def cage_at(scene: Scene) -> dict[str, float]:
    """The motion of the cage of a scene with one operating point, SI; it must be computed, not its closed form."""
    found, cage = friction_torque(scene), scene.cage
    motion, driven = found.cage.motion[0], found.cage.driven[0]
    runs = np.array(motion.block_maxima).reshape(cage.seeds, -1).max(axis=1)
    races = (found.friction_coefficient.inner, found.friction_coefficient.outer)
    held = min(  # the most that one race can hold
        float(coefficient[0] * contact.load[0])
        for coefficient, contact in zip(races, (found.inner, found.outer), strict=True)
        if coefficient is not None
    )
    mu = driven.friction_coefficient
    moments = mu * motion.mean_force * driven.ball_radius
    return {
        "cage_torque": motion.torque,  # power of sliding over the speed of the ring: a loss
        # Power lost in impacts over the speed of the ring: a loss, no part of a friction torque
        "impact_torque": motion.damping_torque,
        "cage_moments": moments,  # mu (sum N) r: friction moments about the balls' centres, sum of magnitudes
        # Mean sliding speed, weighted with the force, over the speed of the balls' surface; 1 at rest
        "slip_share": motion.torque * abs(driven.ring_speed) / (moments * abs(driven.ball_speed)),
        # Mean magnitude of the balls' moment on the cage about the bearing's axis
        "cage_axial_moment": mean_axial_moment(driven, start=motion.start),
        "cage_force": motion.mean_force,  # sum of the normal forces of all pockets, mean
        "cage_max_force": float(np.median(runs)),  # largest of one ball in a run, median of the seeds and their ends
        "cage_max_force_low": float(runs.min()),
        "cage_max_force_high": float(runs.max()),
        "pocket_coefficient": mu,  # of friction of ball on pocket
        # N (1 + mu)/(2 F): the share of the races' traction F that a ball needs to push the cage with N; above 1 it
        # slides. Along the orbit both races together hold N. About the ball's own axis they also hold the pocket's
        # friction mu N, one race forward and one back. So one race has N/2 + mu N/2 and the other N/2 - mu N/2.
        "traction_share": motion.mean_force / driven.ball_count * (1 + mu) / (2 * held),
    }


def on_free_balls(scene: Scene) -> CageStatistics:
    """The motion of the cage of a scene of `with_moving_cage` with balls that the cage may brake, both together."""
    short = replace(scene.cage, seeds=FREE_SEEDS, duration=FREE_DURATION)
    part = friction_torque(replace(scene, cage=short, effects={**scene.effects, "ball_dynamics": "on"})).cage
    (motion,) = part.motion
    assert motion is not None
    return motion


def mean_axial_moment(driven: DrivenCage, *, start: CageStart) -> float:
    """Mean magnitude of the moment on the cage about the bearing's axis, N m, over spans of a quarter contact."""
    motion = CageMotion(driven, begin=start, seed=0, ramp=DURATION)
    motion.advance(DURATION)
    return float(np.mean([abs(motion.advance(SPAN * motion.step).moment) for _ in range(SPANS)]))


def mixed_coefficient(scene: Scene, cage: Cage, *, force: Array) -> Array:
    """Friction coefficient of ball on pocket by mixed lubrication, with the oil and finish of a scene, (n,).

    cage : gives the pocket;  force : of all balls on their pockets at the scene's speeds, sum, N, (n,)
    """
    bearing, angle = scene.bearing, LOADED
    motion = ball_kinematics(1.0, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    oiled = replace(scene, cage=replace(cage, friction_coefficient=None))
    surface = motion.ball_speed * scene.operation.inner_speed * bearing.ball_radius
    return friction_in_pocket(oiled, load=force / bearing.ball_count, surface_speed=surface).coefficient
