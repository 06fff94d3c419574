"""Effects that nothing here computes: how near they are, from what was found, and a warning past the limit of each.

What is watched is told of the worst ball and operating point; decided off, whatever its size.
"""

from collections.abc import Iterator

import numpy as np

from analytic.contact.geometry import Race, shoulder_distance
from analytic.effects.ledger import Choices
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls
from analytic.loads.inertia import gyroscopic_slip_ratio
from analytic.scene import Operation, Scene
from analytic.sliding.long_ellipse import SlidingContact, sliding_number
from analytic.sliding.methods import Sliding

STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
LEAST_SLIDING = 3.0  # of the sliding number: below, elastic creep takes a good part of the slip
RACES: tuple[Race, Race] = ("inner", "outer")


def watch(
    scene: Scene, operation: Operation, balls: LoadedBalls, choices: Choices, *, slid: Sliding | None
) -> list[str]:
    """Settle every effect of `effects.WATCHED` with its number as the reason; return the warnings.

    operation : every array (n,)
    Raises InputError for a contact that has left its race.
    """
    return [
        *_watch_shoulder(scene, operation, balls, choices),
        *_watch_pressure(balls, choices),
        *_watch_creep(balls, choices, slid),
        *_gyroscopic_slip(scene, operation, balls, slid),
    ]


def _watch_shoulder(scene: Scene, operation: Operation, balls: LoadedBalls, choices: Choices) -> Iterator[str]:
    b = balls.contact.semi_axis_y
    room = np.stack(
        [
            shoulder_distance(scene.bearing, race, contact_angle=np.abs(angle))
            for race, angle in zip(RACES, balls.contact_angle, strict=True)
        ]
    )
    room = np.where(balls.load > 0, room, np.inf)
    left, nearest = np.inf, "no ball is loaded"
    for index, name in enumerate(RACES):
        point, ball = np.unravel_index(np.argmin(room[index]), room[index].shape)
        if room[index, point, ball] <= 0:
            angles = np.abs(balls.contact_angle[:, point, ball])
            # The ball's inertia parts its angles: without it the contact would be about between them.
            parted = shoulder_distance(scene.bearing, name, contact_angle=angles.mean()) > 0
            speed = f"the speed of {operation.inner_speed[point]:.5g} rad/s, whose centrifugal force moves it there"
            raise InputError(
                f"{_loads(operation, int(point))}: the contact moves to {angles[index]:.4f} rad, beyond the {name} "
                f"race's shoulder: lower {speed if parted else 'the load'}, reduce the clearance or raise "
                "shoulder_half_width"
            )
        worst = np.unravel_index(np.argmin(room[index] - b[index]), room[index].shape)
        axis, space = b[index][worst], room[index][worst]
        if space - axis < left:
            left, nearest = space - axis, f"semi-axis {axis:.4g} m of {space:.4g} m to the {name} race's shoulder"
        if axis > space:
            yield (
                f"the contact ellipse passes the {name} race's shoulder: semi-axis {axis:.4g} m, room {space:.4g} m; "
                "the true contact is cut off there and its pressure higher"
            )
    choices.settled("shoulder", on=False, reason=f"watched: {nearest}")


def _watch_pressure(balls: LoadedBalls, choices: Choices) -> Iterator[str]:
    peaks = balls.contact.peak_pressure.max(axis=(1, 2))
    share = peaks.max() / STATIC_LIMIT
    choices.settled(
        "plasticity",
        on=False,
        reason=f"watched: peak pressure {peaks.max():.4g} Pa, {share:.3g} of the static limit {STATIC_LIMIT:.2g} Pa",
    )
    for name, peak in zip(RACES, peaks, strict=True):
        if peak > STATIC_LIMIT:
            yield (
                f"peak pressure on the {name} race {peak:.4g} Pa is above the static limit {STATIC_LIMIT:.2g} Pa: the "
                "contact is no longer elastic"
            )


def _watch_creep(balls: LoadedBalls, choices: Choices, slid: Sliding | None) -> Iterator[str]:
    if slid is None:
        choices.settled("elastic_creep", on=False, reason="no effect of sliding is asked for")
        return
    least = []
    for race, loaded in enumerate(balls.load > 0):
        creep = sliding_number(
            SlidingContact(
                friction_coefficient=slid.coefficient[race],
                load=balls.load[race],
                semi_axis_rolling=balls.contact.semi_axis_x[race],
                semi_axis_transverse=balls.contact.semi_axis_y[race],
                deformed_radius=balls.deformed_radius[race],
                rolling_rate=balls.rolling_rate[race],
            ),
            entrainment_speed=balls.motion.entrainment_speed,
            curvature_rolling=balls.curvature_along[race],
        )
        least.append(float(np.min(creep, where=loaded, initial=np.inf)))
    choices.settled(
        "elastic_creep",
        on=False,
        reason=f"watched: sliding number {min(least):.3g} at least; below {LEAST_SLIDING:g} it takes part of the slip",
    )
    for name, number in zip(RACES, least, strict=True):
        if number < LEAST_SLIDING:
            yield (
                f"the sliding number of the {name} contact is {number:.3g}, below {LEAST_SLIDING:g}: elastic creep "
                "takes part of the slip, and spin and conformity come out too large"
            )


def _gyroscopic_slip(scene: Scene, operation: Operation, balls: LoadedBalls, slid: Sliding | None) -> Iterator[str]:
    """A ball that friction across the grooves cannot hold.

    Of balls that both races load, with the tolerance of the heaviest one's load or more: others lose next to nothing.
    """
    if slid is None:
        return
    speed = np.abs(operation.inner_speed)[:, None]
    ratio = gyroscopic_slip_ratio(
        ball_mass=scene.bearing.ball_mass,
        ball_radius=scene.bearing.ball_radius,
        ball_speed=speed * balls.motion.ball_speed,
        cage_speed=speed * balls.motion.cage_speed,
        contact_angle=np.minimum(np.abs(balls.contact_angle.mean(axis=0)), np.pi / 2),
        friction_force=np.sum(slid.coefficient * balls.load, axis=0),
    )
    pressed = balls.load.min(axis=0)
    ratio = np.where(pressed > scene.tolerance * pressed.max(axis=1, keepdims=True), ratio, 0.0)
    point, _ = np.unravel_index(np.argmax(ratio), ratio.shape)
    if ratio.max() > 1:
        yield (
            f"the gyroscopic moment of a ball is {ratio.max():.3g} times what friction across both grooves holds at "
            f"{operation.inner_speed[point]:.4g} rad/s: the ball turns about a third axis, for which the model has no "
            "answer; raise the load or lower the speed"
        )


def _loads(operation: Operation, point: int) -> str:
    """The loads at an operating point as the scene gives them."""
    found = f"operation.axial_load = {operation.axial_load[point]:g} N"
    for name, unit in (("radial_load", "N"), ("moment", "N m")):
        value = np.asarray(getattr(operation, name))[point]
        if value:
            found += f", operation.{name} = {value:g} {unit}"
    return found
