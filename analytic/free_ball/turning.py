"""A free ball in one round of an equilibrium, compiled: how it turns at its place, and what then acts on it.

Friction moves the contact angles, and these the friction; the centrifugal force moves the loads, and these drive the
ball round. Rounds alone converge slowly, or swing for ever where the inner race hardly presses a ball: the errors of
the last two give each ball a secant [Anderson1965].
"""

from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import contact_modulus, loaded_hertz
from analytic.free_ball.kernel import turn_ball
from analytic.free_ball.rotation import MARCHED, STIFFER
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.loads.thrust_ball import in_groove
from analytic.loads.turning import ForcesOfTurning
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record, Records
from analytic.numerics.root import cube_root
from analytic.oil.traction import PointLaw
from analytic.scene import Array, Bearing

ACCURACY = 1e-10  # of the residual force, over all friction of the ball
ENOUGH = 1e-7  # likewise, where round-off of stiff surfaces leaves no better
ROUGH = 1e-2  # likewise, on coarse nodes, for a start
MOST_MIXED, LEAST_MIXED = 0.9, 0.2  # of a secant's step, and of the error that a step has to remove at least


class FreeNumbers(NamedTuple):
    """What free balls see of their bearing besides its numbers."""

    orbit: float  # radius of the circle on which the outer groove's centre of curvature lies, m
    flexibility: tuple[float, float]  # L/a of inner and outer contact along rolling, 1/Pa
    lean: float  # how much more it is across
    centrifugal: bool  # whether the force counts
    gyroscopic: bool  # whether the moment counts


class FreeNodes(NamedTuple):
    """Of the quadratures of a pass, and how far its rounds go."""

    coarse: Record  # for a start
    fine: Record
    accuracy: float  # of the residual force of this round, or of the first one, over all friction of the ball
    steady: float  # relative, of the forces on a ball from one round to the next
    scratch: Record  # of `state.SCRATCH`


@compiled
def turned(
    bearing: BearingNumbers, free: FreeNumbers, speed: float, ball: Record, contacts: Records, nodes: FreeNodes
) -> ForcesOfTurning:
    """What acts on a ball once it turns steadily at its place, from where it turned last; writes its state.

    speed : w, rad/s;  contacts : (2,) of inner and outer race
    """
    angles, velocity = angles_in_grooves(ball), ball.velocity
    orbit = orbit_at(bearing, free, ball)
    inertia = 0.4 * bearing.ball_mass
    ball.radius, ball.orbit_radius = bearing.ball_radius, orbit
    ball.inertia = inertia * speed**2 if free.gyroscopic else 0.0
    for race in range(2):
        unit, side = (ball.inner_unit, -1.0) if race == 0 else (ball.outer_unit, 1.0)
        hertz, contact = loaded_hertz(unit, ball.load[race]), contacts[race]
        contact.load = ball.load[race]
        contact.semi_axis_rolling, contact.semi_axis_transverse = hertz.semi_axis_x, hertz.semi_axis_y
        contact.radius = bearing.inner.deformed_radius if race == 0 else bearing.outer.deformed_radius
        contact.normal_radial, contact.normal_axial = side * np.cos(angles[race]), side * np.sin(angles[race])
        contact.ring_rate, contact.flexibility, contact.lean = 1.0 - race, free.flexibility[race], free.lean
    # Nothing but the cage drives a ball that one race alone touches: what it did before would stay for ever.
    if np.isnan(velocity[0]) or min(ball.load[0], ball.load[1]) == 0.0:
        roll_by_rule(bearing, angles, orbit, velocity)
    if np.isnan(ball.given[0]):  # of this pass
        turn_ball(contacts, ball, nodes.coarse, ROUGH, nodes.scratch)
    ball.residual = turn_ball(contacts, ball, nodes.fine, nodes.accuracy, nodes.scratch)
    rate = velocity[0] / orbit
    centrifugal = bearing.ball_mass * orbit * (rate * speed) ** 2 if free.centrifugal else 0.0
    _mix(ball, (centrifugal, contacts[0].across, contacts[1].across))
    moment = inertia * bearing.ball_radius * speed**2 * rate * velocity[2] if free.gyroscopic else 0.0
    return ForcesOfTurning(ball.given[0], ball.given[1], ball.given[2], moment)


@compiled
def angles_in_grooves(ball: Record) -> tuple[float, float]:
    """al_i, al_o, rad, in [-pi/2, pi/2]."""
    return in_groove(ball.angle[0]), in_groove(ball.angle[1])


@compiled
def orbit_at(bearing: BearingNumbers, free: FreeNumbers, ball: Record) -> float:
    """Radius of the ball's orbit, m."""
    outer_reach = bearing.outer.groove_radius - bearing.ball_radius
    outer_reach += ball.outer_unit.approach * cube_root(ball.load[1]) ** 2
    return free.orbit + outer_reach * np.cos(in_groove(ball.angle[1]))


@compiled
def roll_by_rule(bearing: BearingNumbers, angles: tuple[float, float], orbit: float, velocity: Array) -> None:
    """Write the velocity of a ball that rolls under outer control."""
    motion = ruled_motion(bearing, 1.0, angles[0], angles[1])
    velocity[0], velocity[1] = orbit * motion.cage_speed, 0.0
    velocity[2] = bearing.ball_radius * motion.ball_speed * np.sin(motion.pitch)
    velocity[3] = bearing.ball_radius * (motion.cage_speed - motion.ball_speed * np.cos(motion.pitch))


@compiled
def _mix(ball: Record, now: tuple[float, float, float]) -> None:
    """Write the forces on a ball for the next round; now : those that came of the last one, N."""
    given, gave, left = ball.given, ball.gave, ball.left
    product = size = error = 0.0
    for k in range(3):
        change = now[k] - given[k] - left[k]
        product += (now[k] - given[k]) * change
        size += change * change
        error += (now[k] - given[k]) ** 2
    share = min(max(product / size, -MOST_MIXED), MOST_MIXED) if size > 0.0 else 0.0  # NaN in the first two rounds
    step = 0.0
    for k in range(3):
        step += (now[k] - share * (now[k] - gave[k]) - given[k]) ** 2
    # A step far shorter than the error would pass for the end of the rounds.
    mixes = step > LEAST_MIXED**2 * error and now[0] - share * (now[0] - gave[0]) >= 0.0
    for k in range(3):
        mixed = now[k] - share * (now[k] - gave[k]) if mixes else now[k]
        left[k] = now[k] - given[k]
        given[k], gave[k] = mixed, now[k]


@compiled
def free_motion(radius: float, angles: tuple[float, float], orbit: float, velocity: Array) -> BallMotion:
    """Speeds per unit ring speed of a ball; radius : r, m;  orbit : radius of its orbit, m."""
    orbit_rate = velocity[0] / orbit
    outward, axial = velocity[2] / radius, velocity[3] / radius - orbit_rate  # relative to the orbit
    inner = _rates(radius, orbit, (-np.cos(angles[0]), -np.sin(angles[0])), (outward, axial), 1.0 - orbit_rate)
    outer = _rates(radius, orbit, (np.cos(angles[1]), np.sin(angles[1])), (outward, axial), -orbit_rate)
    return BallMotion(
        orbit - radius * np.cos(angles[0]),
        orbit + radius * np.cos(angles[1]),
        orbit_rate,
        np.sqrt((velocity[1] / radius) ** 2 + outward**2 + axial**2),
        inner[0],
        outer[0],
        inner[1],
        outer[1],
        abs(inner[2] + outer[2]),
        np.arctan2(outward, -axial),
    )


@compiled
def _rates(
    radius: float, orbit: float, normal: tuple[float, float], turns: tuple[float, float], passes: float
) -> tuple[float, float, float]:
    """Entrainment, m, rolling rate and spin on a race, per unit ring speed.

    normal : out of the ball, radial and axial;  turns : of the ball, relative to its orbit, outward and axial
    passes : rate of the race, relative to the orbit
    """
    turn = turns[1] * normal[0] - turns[0] * normal[1]
    spin = turns[0] * normal[0] + turns[1] * normal[1]
    entrainment = abs(radius * turn + passes * (orbit + radius * normal[0])) / 2
    return entrainment, abs(turn - passes * normal[0]), spin - passes * normal[1]


@compiled
def hold_law(contact: Record, law: PointLaw, speed: float) -> None:
    """Write the law of traction of a contact; speed : w, rad/s."""
    contact.boundary, contact.plain, contact.limit, contact.eyring = law.boundary, law.plain, law.limit, law.eyring
    contact.fluidity = np.inf if law.fluidity == np.inf else law.fluidity * abs(speed)
    contact.share, contact.alpha, contact.bend = law.share, law.alpha, law.bend
    contact.exponent, contact.rises, contact.own = law.exponent, law.rises, law.own


def outer_groove_centres(bearing: Bearing, numbers: BearingNumbers) -> float:
    """Radius of the circle on which the outer groove's centre of curvature lies, m.

    Where a contact angle does not fit the bottom radii, both grooves give way alike: the pitch diameter stays.
    """
    if bearing.kind == "thrust":
        return bearing.outer.bottom_radius
    at_angle = 2 * numbers.groove_centre_distance * np.sin(numbers.given_angle / 2) ** 2
    play = at_angle if np.isnan(numbers.play) else numbers.play
    return float(bearing.pitch_diameter / 2 + bearing.ball_radius - bearing.outer.groove_radius + play / 2)


def free_numbers(bearing: Bearing, *, orbit: float, creeps: bool, inertia: tuple[bool, bool]) -> FreeNumbers:
    """How the balls of a bearing turn freely.

    orbit : of `outer_groove_centres`;  creeps : whether the surfaces do
    inertia : whether centrifugal force and gyroscopic moment count
    """
    along, across = MARCHED
    softer = along if creeps else along / STIFFER
    inner, outer = (
        softer * 32 / (3 * np.pi**2 * float(contact_modulus(bearing.ball_material, groove.material)))
        for groove in (bearing.inner, bearing.outer)
    )
    return FreeNumbers(orbit, (inner, outer), across / along, bool(inertia[0]), bool(inertia[1]))
