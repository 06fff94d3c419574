"""The ladder of the cage: its closed form at rest, and its motion in ever shorter steps."""

from dataclasses import replace

import numpy as np

from analytic.cage.statistics import CageStatistics, measured_motion
from analytic.cage.torque import CagePart, cage_drive, cage_friction, driven_cage
from analytic.effects.ledger import Choices
from analytic.effects.loads import loaded_balls, points
from analytic.errors import InputError
from analytic.scene import Array, Operation, Scene
from fembearing.compare.cost.ladder import Question, Way, deviation

# Of each motion, s: shorter than a scene's, so that all rungs with their repeats take less than half a minute, in steps
# as usual.
SEEDS, DURATION = 3, 0.02
SHARES = (0.25, 0.5, 1.0, 2.0)  # of the scene's steps a contact; the last is the reference


def cage_question(scene: Scene) -> Question:
    """Torque of the cage at the fastest operating point, every rung with the friction coefficient of the closed form.

    A scene that does not say how its cage started is asked for a motion from rest, which the closed form is of. Raises
    InputError for a scene without a cage, without friction in its pockets, or at standstill.
    """
    cage, bearing = scene.cage, scene.bearing
    if cage is None:
        raise InputError("the scene has no [cage]")
    if not scene.has_friction and cage.friction_coefficient is None:
        raise InputError("neither friction.coefficient nor both [lubricant] and [surface] are given")
    series = points(scene)
    fastest = int(np.argmax(np.abs(series.inner_speed)))
    operation = Operation(**{name: values[[fastest]] for name, values in vars(series).items()})
    turning = float(operation.inner_speed[0])
    if turning == 0:
        raise InputError("the bearing stands still, and its cage takes nothing")
    resting = replace(scene, operation=operation, effects={**scene.effects, "cage": "on", "cage_dynamics": "off"})
    balls, _ = loaded_balls(resting, operation, Choices(resting, 1), correction=None)

    def closed_form() -> CagePart:
        return cage_friction(resting, cage_drive(bearing, cage, balls, operation.inner_speed), moves=False)

    driven = driven_cage(
        bearing,
        cage,
        friction_coefficient=float(closed_form().friction_coefficient[0]),
        inner_speed=turning,
        orbit_speed=turning * float(balls.motion.cage_speed.mean()),
        ball_speed=turning * float(balls.motion.ball_speed.mean()),
        contact_angle=float(np.abs(balls.contact_angle).mean()),
    )
    start, duration = cage.start or "rest", min(max(DURATION, driven.crossing_time), cage.duration)
    steps = [share * cage.steps_per_contact for share in SHARES]
    longer = cage.seeds * cage.duration / (SEEDS * duration)

    def of_steps(number: int) -> Way:
        asked = {"start": start, "seeds": SEEDS, "duration": duration, "steps_per_contact": steps[number]}
        coarser = asked | {"steps_per_contact": steps[max(number - 1, 0)]}
        return Way(
            name=f"motion, {steps[number]:g} steps a contact",
            run=lambda: _torque(measured_motion.__wrapped__(driven, **asked)),  # what it keeps has no price
            bound=lambda: _of_motion(measured_motion(driven, **asked), measured_motion(driven, **coarser)),
            may_refer=True,
        )

    return Question(
        quantity="cage torque",
        reference=(
            f'motion in the finest steps, from "{start}", {SEEDS} seeds of {duration:.3g} s at '
            f"{turning:.4g} rad/s; what the scene asks takes {longer:.3g} times as long"
        ),
        ways=(
            # What it leaves out is known of no closed form: the motion shows it.
            Way(name="closed form at rest", run=lambda: closed_form().torque, bound=lambda: np.inf),
            *(of_steps(number) for number in range(len(steps))),
        ),
    )


def _torque(found: CageStatistics) -> Array:
    return np.array([found.torque])


def _of_motion(found: CageStatistics, coarser: CageStatistics) -> float:
    """What twice the step changes, and half the interval of the mean over seeds; no bound without a coarser one."""
    if coarser is found:
        return np.inf
    low, high = found.torque_interval
    interval = 0.0 if high == low else (high - low) / 2 / abs(found.torque)
    return deviation(_torque(coarser), _torque(found)) + interval
