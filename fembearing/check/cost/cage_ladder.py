"""The ladder of the cage: its closed form at rest, and its motion in ever shorter steps."""

from dataclasses import replace

import numpy as np

from analytic.cage.drive import cage_drive
from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.torque import CagePart, cage_friction, cage_moves, driven_cage
from analytic.errors import InputError
from analytic.scene import Array, Scene
from analytic.torque import loaded_balls_of
from analytic.words import speed_of
from fembearing.check.cost.ladder import UntimedLadder, UntimedMethod, deviation

SEEDS, DURATION = 3, 0.02  # of each motion; s, shorter than a scene's, so that all repeats take less than half a minute
SHARES = (0.25, 0.5, 1.0, 2.0)  # of the scene's steps per contact; the last is the reference


def cage_methods(scene: Scene) -> UntimedLadder:
    """Torque of the cage at the fastest operating point, each method with the friction coefficient of the closed form.

    The motion starts from rest, as the closed form assumes, unless the scene says how its cage started. Raises
    InputError for a scene without a cage, without friction in its pockets, at standstill, or with balls that lead
    farther than the pockets leave free.
    """
    cage, bearing = scene.cage, scene.bearing
    if cage is None:
        raise InputError("the scene has no [cage]")
    if not scene.has_friction and cage.friction_coefficient is None:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    series = scene.operation.as_series()
    fastest = int(np.argmax(np.abs(series.inner_speed)))
    operation = series.at(np.array([fastest]))
    turning = float(operation.inner_speed[0])
    if turning == 0:
        raise InputError("the bearing stands still, without friction of the cage")
    resting = replace(scene, operation=operation, effects={**scene.effects, "cage": "on", "cage_dynamics": "off"})
    balls = loaded_balls_of(resting)
    drive = cage_drive(resting, balls, scene.friction_coefficient, operation.inner_speed)

    def closed_form() -> CagePart:
        return cage_friction(resting, drive, cage_moves(resting, None))

    level = driven_cage(
        bearing,
        cage,
        friction_coefficient=float(closed_form().friction_coefficient[0]),
        inner_speed=turning,
        orbit_speed=turning * float(balls["motion"]["cage_speed"].mean()),
        ball_speed=turning * float(balls["motion"]["ball_speed"].mean()),
        contact_angle=float(np.abs(balls["angle"]).mean()),
    )
    driven = replace(level, ball_lead=float(drive.grip.ball_lead[0]))
    start, duration = cage.start or "rest", min(max(DURATION, driven.crossing_time), cage.duration)
    steps = [share * cage.steps_per_contact for share in SHARES]
    longer = cage.seeds * cage.duration / (SEEDS * duration)

    def motion_in(number: int) -> UntimedMethod:
        settings = {"start": start, "seeds": SEEDS, "duration": duration, "steps_per_contact": steps[number]}
        coarser = settings | {"steps_per_contact": steps[max(number - 1, 0)]}
        return UntimedMethod(
            name=f"motion, {steps[number]:g} steps a contact",
            run=lambda: _torque(measured_motion.__wrapped__(driven, **settings)),  # not from its cache
            bound=lambda: _bound(measured_motion(driven, **settings), measured_motion(driven, **coarser)),
            may_refer=True,
        )

    return UntimedLadder(
        quantity="cage torque",
        reference=(
            f'motion in the finest steps, from "{start}", {SEEDS} seeds of {duration:.3g} s at '
            f"{speed_of(turning)}; the motion of the scene takes {longer:.3g} times as long"
        ),
        methods=(
            # No closed form bounds what this one leaves out: only the motion shows it.
            UntimedMethod(name="closed form at rest", run=lambda: closed_form().torque, bound=lambda: np.inf),
            *(motion_in(number) for number in range(len(steps))),
        ),
    )


def _torque(motion: CageStatistics) -> Array:
    return np.array([motion.torque])


def _bound(motion: CageStatistics, coarser: CageStatistics) -> float:
    """The change from twice the step, and half the interval of the mean over seeds; infinite without a coarser one."""
    if coarser is motion:
        return np.inf
    low, high = motion.torque_interval
    interval = 0.0 if high == low else (high - low) / 2 / abs(motion.torque)
    return deviation(_torque(coarser), _torque(motion)) + interval
