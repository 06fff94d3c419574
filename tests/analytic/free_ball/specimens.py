"""Bearings of the published check values, and free balls under thrust with Coulomb friction."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from analytic.free_ball.rotation import MARCHED
from analytic.numerics.records import Record, copied, record_in
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.solve.model import Workspace, model_of, workspace
from analytic.solve.records import SETTLED
from analytic.solve.solution import points_of, solved
from tests.analytic.specimens import made

FINE = 1  # level of 32 strips with 23 nodes
COUNTED: dict[str, bool] = dict.fromkeys(("load_distribution", "centrifugal", "gyroscopic", "spin", "conformity"), True)
DIAMETER, PITCH, FREE_ANGLE = 11.906e-3, 60e-3, np.radians(40)


def angular_contact() -> Bearing:
    """13 balls of 11.906 mm at 40 degrees, grooves of 0.52 and 0.53 ball diameters."""
    grooves = 0.52, 0.53
    play = 2 * (sum(grooves) - 1) * DIAMETER * (1 - np.cos(FREE_ANGLE))
    return made(ball=DIAMETER, pitch=PITCH, count=13, grooves=grooves, clearance=play, shoulder=None)


class Turned(NamedTuple):
    """Balls under thrust, one of which stands for all."""

    load: Array  # (2,) N
    angle: Array  # (2,) rad
    motion: Record  # of `BallMotion`
    work: Workspace  # with the first ball and its contacts as they have settled
    torque: float  # of all balls, N m


def dry_scene(bearing: Bearing, free_angle: float | None, friction: float, *, load: Array, speed: Array) -> Scene:
    """Of a bearing under thrust; load : N;  speed : rad/s"""
    return Scene(
        bearing=bearing,
        contact_angle=ContactAngle(rule="solved", free=free_angle),
        operation=Operation(axial_load=load, inner_speed=speed),
        friction_coefficient=friction,
    )


def under_thrust(
    bearing: Bearing,
    free_angle: float | None,
    *,
    load: float,
    speed: float,
    friction: float,
    creeps: bool = True,
    as_long: bool = False,
) -> Turned:
    """With the same nodes, whatever their error; as_long : surfaces are as flexible as those of a long ellipse."""
    scene = dry_scene(bearing, free_angle, friction, load=np.array([load]), speed=np.array([speed]))
    model = model_of(scene, COUNTED | {"creep": creeps}, free=True).with_numbers(level=FINE, allowed=np.inf)
    if as_long:
        numbers = copied(model.numbers)
        numbers["free"]["flexibility"] /= MARCHED[0]
        numbers["free"]["lean"] = 1.0
        model = replace(model, numbers=record_in(numbers))
    work = workspace(model)
    found = solved(model, points_of(scene.operation, 0.0), work=work)
    point, ball = found.points[0], found.balls[0, 0]
    assert point["status"] == SETTLED
    return Turned(ball["load"], ball["angle"], ball["motion"], work, float(point["total"]))
