"""One ball between the grooves of two rings: the force that holds the inner groove where it is.

The plane through the bearing axis and the ball has two directions: radial (outward) and axial. The vector V runs from
the centre of curvature of the outer groove to that of the inner groove. Where its length is A0 = r_gi + r_go - D, both
races just touch the ball. Where it is longer, the ball carries load.
The contact angle is measured from the radial direction and has the sign of the axial part. On the outer race it is the
angle of the vector from the outer groove's centre to the ball. On the inner race it is the angle of the vector from the
ball to the inner groove's centre.
A contact is a spring Q = K delta^1.5 of a given stiffness K along its line of centres; its approach under 1 N is
K^(-2/3). The elastic energy is then convex in V, and stays convex after the ball has settled under a force of its own.
Source: [Jones1960] and [Harris2007b] section 3: the balance is that of the forces on the ball.
"""

from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.newton import MOST_STEPS, is_too_long, plane_step
from analytic.numerics.root import cube_root
from analytic.scene import Bearing

PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps  # of the distances between ball and groove centres
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps  # of load times the distance whose rounding moves it

Vector = tuple[float, float]  # radial and axial
Tangent = tuple[float, float, float]  # radial, mixed and axial second derivative of an energy, N/m


class Grooves(NamedTuple):
    """Where the centres of a bearing's grooves are, m."""

    distance: float  # A0, of the centres where both races just touch
    play: float  # A0 less the radial distance of the groove centres of concentric rings; negative is preload
    inner_length: float  # r_gi - r
    outer_length: float  # r_go - r


class BallBalance(NamedTuple):
    """A ball that has settled between its grooves."""

    energy: float  # elastic energy, less the work of the ball's own force, J
    force: Vector  # its derivative by V: force on the inner groove, N
    tangent: Tangent  # its second derivative
    inner_load: float  # Q_i, N
    outer_load: float  # Q_o, N
    inner_arm: Vector  # from the ball to the inner groove's centre, m, see `_arm_off_race`; where no race touches: V
    outer_arm: Vector  # from the outer groove's centre to the ball
    moved: Vector  # by its own force, m; 0 where a race does not touch
    left: float  # unbalanced force, N
    tolerance: float  # on it; the ball has not settled where more is left


def grooves_of(bearing: Bearing, play: float) -> Grooves:
    radius = bearing.ball_radius
    return Grooves(
        distance=float(bearing.groove_centre_distance),  # a kernel would be compiled anew for an integer
        play=float(play),
        inner_length=float(bearing.inner.groove_radius - radius),
        outer_length=float(bearing.outer.groove_radius - radius),
    )


@compiled
def gap_to_race(grooves: Grooves, inner_arm: Vector, outer_arm: Vector, loads: tuple[float, float], race: int) -> float:
    """Distance from its inner (0) or outer race (1) of a ball without load there, m.

    inner_arm, outer_arm : of the ball, as `BallBalance` has them;  loads : on both races, N
    A ball that its own force presses on the other race lies there; any other lies in the middle of its clearance.
    """
    if loads[1 - race] == 0.0:
        return (grooves.distance - np.hypot(inner_arm[0], inner_arm[1])) / 2
    arm, length = (inner_arm, grooves.inner_length) if race == 0 else (outer_arm, grooves.outer_length)
    return length - np.hypot(arm[0], arm[1])


@compiled
def contact_tangent(along: float, across: float, normal: Vector) -> Tangent:
    """Tangent of a spring with these stiffnesses along its normal and, load over length, at right angles to it, N/m."""
    more = along - across
    return across + more * normal[0] * normal[0], more * normal[0] * normal[1], across + more * normal[1] * normal[1]


@compiled
def in_series(inner: Tangent, outer: Tangent) -> Tangent:
    """Tangent I (I + O)^-1 O of two contact springs with the ball between them.

    A force too small to press a ball in leaves it free: then both springs are slack, and so are two in a row.
    """
    radial, mixed, axial = inner[0] + outer[0], inner[1] + outer[1], inner[2] + outer[2]
    determinant = radial * axial - mixed * mixed
    if determinant == 0.0:
        return 0.0, 0.0, 0.0
    # (I + O)^-1 O
    rr, ra = axial * outer[0] - mixed * outer[1], axial * outer[1] - mixed * outer[2]
    ar, aa = radial * outer[1] - mixed * outer[0], radial * outer[2] - mixed * outer[1]
    return (
        (inner[0] * rr + inner[1] * ar) / determinant,
        (inner[0] * ra + inner[1] * aa) / determinant,
        (inner[1] * ra + inner[2] * aa) / determinant,
    )


class _Pushed(NamedTuple):
    """A ball under a force of its own."""

    grooves: Grooves
    span: Vector  # V, m
    softness: tuple[float, float]
    own: Vector  # N


class _Spring(NamedTuple):
    """A contact."""

    load: float  # Q, N
    force: Vector  # N
    tangent: Tangent
    energy: float  # J


class _Placed(NamedTuple):
    """A ball under a force of its own at a place, which is the vector from the outer groove's centre to the ball."""

    inner: _Spring
    outer: _Spring
    energy: float  # J
    gradient: Vector  # N
    left: float  # its larger component
    tolerance: float
    energy_rounding: float  # J


@compiled
def _contact(vector: Vector, natural_length: float, softness: float) -> _Spring:
    """A contact spring that is stretched to a vector, m."""
    length = np.sqrt(vector[0] * vector[0] + vector[1] * vector[1])
    normal = (vector[0] / length, vector[1] / length)
    approach = max(length - natural_length, 0.0)
    root = np.sqrt(approach / softness)
    load = root * root * root
    return _Spring(
        load=load,
        force=(load * normal[0], load * normal[1]),
        tangent=contact_tangent(1.5 * root / softness, load / length, normal),
        energy=0.4 * load * approach,
    )


@compiled
def _at(ball: _Pushed, place: Vector) -> _Placed:
    grooves, own = ball.grooves, ball.own
    inner = _contact((ball.span[0] - place[0], ball.span[1] - place[1]), grooves.inner_length, ball.softness[0])
    outer = _contact(place, grooves.outer_length, ball.softness[1])
    gradient = (outer.force[0] - inner.force[0] - own[0], outer.force[1] - inner.force[1] - own[1])
    work = own[0] * (place[0] - grooves.outer_length) + own[1] * place[1]
    trace = inner.tangent[0] + inner.tangent[2] + outer.tangent[0] + outer.tangent[2]
    rounded = PLACE_ROUND_OFF * (grooves.inner_length + grooves.outer_length)  # of a place
    lost = rounded / min(ball.softness[0], ball.softness[1])
    smallest = lost * np.sqrt(lost)  # a contact with a smaller load may come out as none
    return _Placed(
        inner=inner,
        outer=outer,
        energy=inner.energy + outer.energy - work,
        gradient=gradient,
        left=max(abs(gradient[0]), abs(gradient[1])),
        tolerance=rounded * trace + PLACE_ROUND_OFF * (inner.load + outer.load) + smallest,
        energy_rounding=ENERGY_ROUND_OFF * (inner.load * grooves.inner_length + outer.load * grooves.outer_length),
    )


@compiled
def _sum(inner: Tangent, outer: Tangent) -> Tangent:
    return inner[0] + outer[0], inner[1] + outer[1], inner[2] + outer[2]


@compiled
def _arm_off_race(grooves: Grooves, span: Vector, place: Vector) -> Vector:
    """From a ball on the outer race alone to the inner groove's centre, m: its length is true.

    Its direction is true where the race lets go of the ball, so that the ball's speeds do not jump there. It turns to V
    as the gap grows to r_gi - r: a race that far away says nothing about the ball.
    """
    away = (span[0] - place[0], span[1] - place[1])
    length = np.hypot(away[0], away[1])
    faces = away[0] * span[0] + away[1] * span[1] > 0.0
    share = 1.0 - length / grooves.inner_length if faces else 1.0
    turned = (away[0] + share * place[0], away[1] + share * place[1])
    scale = length / np.hypot(turned[0], turned[1])
    return turned[0] * scale, turned[1] * scale


@compiled
def _pushed_ball(ball: _Pushed, middle: Vector, near: Vector, touching: bool) -> BallBalance:
    """The ball at the place of least energy.

    middle : its place without its force, m;  touching : whether it then carries load; if it does not, its force alone
    presses it on the outer race
    """
    span, own, longest = ball.span, ball.own, ball.grooves.outer_length
    if touching:
        place = (middle[0] + near[0], middle[1] + near[1])
    else:
        push = np.sqrt(own[0] * own[0] + own[1] * own[1])
        reach = longest + ball.softness[1] * cube_root(push) ** 2
        place = (reach * own[0] / push, reach * own[1] / push)
    now = _at(ball, place)
    for _ in range(MOST_STEPS):
        if now.left <= now.tolerance or np.isnan(now.energy):
            break
        step = plane_step(_sum(now.inner.tangent, now.outer.tangent), now.gradient, longest)
        promised = now.gradient[0] * step[0] + now.gradient[1] * step[1]
        share = 1.0
        origin, energy, rounding = place, now.energy, now.energy_rounding
        while True:
            place = (origin[0] + share * step[0], origin[1] + share * step[1])
            now = _at(ball, place)
            if not is_too_long(energy, now.energy, share * promised, rounding):
                break
            share /= 2
    inner, outer = now.inner, now.outer
    pressed, inner_arm = inner.load > 0.0, (span[0] - place[0], span[1] - place[1])
    if not pressed:
        inner_arm = _arm_off_race(ball.grooves, span, place) if outer.load > 0.0 else span
    settled = touching and pressed and outer.load > 0.0
    return BallBalance(
        energy=now.energy,
        force=inner.force,
        tangent=in_series(inner.tangent, outer.tangent),
        inner_load=inner.load,
        outer_load=outer.load,
        inner_arm=inner_arm,
        outer_arm=place,
        moved=(place[0] - middle[0], place[1] - middle[1]) if settled else (0.0, 0.0),
        left=now.left,
        tolerance=now.tolerance,
    )


@compiled
def settled_ball(
    grooves: Grooves, place: Vector, softness: tuple[float, float], own: Vector, near: Vector
) -> BallBalance:
    """A ball at rest between grooves that are displaced against each other.

    place : displacement of the inner groove from concentric rings with their grooves in line, m
    softness : approach of inner and outer contact under 1 N, m
    own : force of the ball's own (centrifugal, friction), N; without one both contacts have the same load and angle,
        and nothing is iterated
    near : about how far that force moves the ball, m, as `moved` has it; a start that does not change the result
    """
    beyond, axial = place[0] - grooves.play, place[1]  # radial part of V less A0
    radial, soft = grooves.distance + beyond, softness[0] + softness[1]
    length = np.sqrt(radial * radial + axial * axial)
    stretch = (beyond * (2 * grooves.distance + beyond) + axial * axial) / (length + grooves.distance)  # |V| - A0
    approach = max(stretch, 0.0)
    root = np.sqrt(approach / soft)
    load = root * root * root
    normal = (radial / length, axial / length)
    reach = grooves.outer_length + approach * softness[1] / soft
    middle = (reach * normal[0], reach * normal[1])
    if own[0] != 0.0 or own[1] != 0.0:
        return _pushed_ball(_Pushed(grooves, (radial, axial), softness, own), middle, near, load > 0.0)
    return BallBalance(
        energy=0.4 * load * approach,
        force=(load * normal[0], load * normal[1]),
        tangent=contact_tangent(1.5 * root / soft, load / length, normal),
        inner_load=load,
        outer_load=load,
        inner_arm=(radial, axial),
        outer_arm=(radial, axial),
        moved=(0.0, 0.0),
        left=0.0,
        tolerance=0.0,
    )
