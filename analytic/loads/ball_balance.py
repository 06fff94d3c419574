"""One ball between the grooves of two rings: the force that holds the inner groove where it is.

The plane through the bearing axis and the ball has two directions: radial (outward) and axial. The vector V runs from
the centre of curvature of the outer groove to that of the inner groove. Where its length is A0 = r_gi + r_go - D, both
races just touch the ball. Where it is longer, the ball carries load.
The contact angle is measured from the radial direction and has the sign of the axial part. On the outer race it is the
angle of the vector from the outer groove's centre to the ball. On the inner race it is the angle of the vector from the
ball to the inner groove's centre.
A contact is a spring Q = K delta^1.5 of a given stiffness K along its line of centres. The elastic energy is then
convex in V, and stays convex after the ball has settled under a force of its own.
Source: [Jones1960] and [Harris2007b] section 3: the balance is that of the forces on the ball.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.newton import ConvexState, least_energy
from analytic.scene import Array, Bearing

PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps  # of the distances between ball and groove centres
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps  # of load times the distance whose rounding moves it
# Of the largest force of a ball's own: what is left where centrifugal force, weight and friction of another ball
# cancel. Such a remainder presses nothing, and would lead a ball along its race for ever.
FORCE_ROUND_OFF = 64 * np.finfo(np.float64).eps


@dataclass(frozen=True, kw_only=True, eq=False)
class BallBalance:
    """Balls that have settled between their grooves; every field has the shape of the grooves' displacement, (...)."""

    energy: Array  # elastic energy, less the work of the ball's own force, J
    force: Array  # (..., 2) its derivative by V: radial and axial force on the inner groove, N
    tangent: Array  # (..., 2, 2) its second derivative, N/m
    inner_load: Array  # Q_i, N
    outer_load: Array  # Q_o, N
    inner_angle: Array  # al_i, rad; where the inner race does not touch: that of V
    outer_angle: Array  # al_o, rad


def settled_ball(
    bearing: Bearing,
    *,
    play: float,
    radial: Array,
    axial: Array,
    inner_stiffness: Array,
    outer_stiffness: Array,
    ball_force: Array,
) -> BallBalance:
    """Balls at rest between grooves that are displaced against each other; the arrays have one shape (...).

    play : A0 less the radial distance of the groove centres of concentric rings, m; negative is preload
    radial, axial : displacement of the inner groove from concentric rings with their grooves in line, m
    inner_stiffness, outer_stiffness : K_i, K_o, N/m^1.5
    ball_force : (..., 2) radial and axial force of the ball's own (centrifugal, friction), N; without one both contacts
        have the same load and angle, and nothing is iterated
    Raises ConvergenceError if a ball under a force of its own does not settle.
    """
    distance = bearing.groove_centre_distance
    beyond = radial - play  # radial part of V less A0
    length = np.hypot(distance + beyond, axial)
    approach = (beyond * (2 * distance + beyond) + axial**2) / (length + distance)  # |V| - A0, small against both
    softness_inner, softness_outer = inner_stiffness ** (-2 / 3), outer_stiffness ** (-2 / 3)
    approach = np.maximum(approach, 0.0)
    stiffness = (softness_inner + softness_outer) ** -1.5
    load = stiffness * approach * np.sqrt(approach)
    normal = np.stack([distance + beyond, axial], axis=-1) / length[..., None]
    angle = np.arctan2(axial, distance + beyond)
    still = BallBalance(
        energy=0.4 * load * approach,
        force=load[..., None] * normal,
        tangent=contact_tangent(1.5 * stiffness * np.sqrt(approach), load / length, normal),
        inner_load=load,
        outer_load=load,
        inner_angle=angle,
        outer_angle=angle,
    )
    push = np.hypot(ball_force[..., 0], ball_force[..., 1])
    moved = push > FORCE_ROUND_OFF * np.max(push, initial=0.0)
    if not np.any(moved):
        return still
    outer_length = bearing.outer.groove_radius - bearing.ball_radius
    pushed = _pushed_balls(
        _Given(
            span=normal[moved] * length[moved][:, None],
            inner_stiffness=inner_stiffness[moved],
            outer_stiffness=outer_stiffness[moved],
            ball_force=ball_force[moved],
        ),
        start=normal[moved] * (outer_length + softness_outer[moved] * np.cbrt(load[moved]) ** 2)[:, None],
        touching=load[moved] > 0,
        lengths=(bearing.inner.groove_radius - bearing.ball_radius, outer_length),
    )
    fields = {name: value.copy() for name, value in vars(still).items()}
    for name, value in vars(pushed).items():
        fields[name][moved] = value
    return BallBalance(**fields)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Given:
    """m balls under a force of their own, and where their grooves are."""

    span: Array  # (m, 2) V, m
    inner_stiffness: Array  # (m,) K_i, N/m^1.5
    outer_stiffness: Array  # (m,) K_o
    ball_force: Array  # (m, 2) N


@dataclass(frozen=True, kw_only=True, eq=False)
class _Spring:
    """m contacts."""

    load: Array  # (m,) Q, N
    force: Array  # (m, 2) N
    tangent: Array  # (m, 2, 2) N/m
    energy: Array  # (m,) J


@dataclass(frozen=True, kw_only=True, eq=False)
class _PushedBalls(ConvexState):
    """m balls at a place, which is the vector from the outer groove's centre to the ball."""

    given: _Given
    inner: _Spring
    outer: _Spring


def _pushed_balls(
    given: _Given, *, start: Array, touching: NDArray[np.bool_], lengths: tuple[float, float]
) -> BallBalance:
    """The balls at the place of least energy.

    start : (m, 2) place of the ball without its force;  touching : (m,) whether that ball carries load; if it does not,
    its force alone presses it on the outer race
    lengths : r_gi - r and r_go - r, m
    """

    push = np.hypot(*given.ball_force.T)
    pressed_in = (push / given.outer_stiffness) ** (2 / 3)
    pressed_out = given.ball_force / push[:, None] * (lengths[1] + pressed_in)[:, None]
    balls, _ = least_energy(
        lambda place, balls: _at(place, balls.given, lengths),
        _at(np.where(touching[:, None], start, pressed_out), given, lengths),
        problem="a ball between its races",
        remedy="Check the speed and the ball's mass for a slipped unit.",
    )
    inner, outer = balls.inner, balls.outer
    toward = np.where(inner.load[:, None] > 0, given.span - balls.place, given.span)
    return BallBalance(
        energy=balls.energy,
        force=inner.force,
        tangent=in_series(inner.tangent, outer.tangent),
        inner_load=inner.load,
        outer_load=outer.load,
        inner_angle=np.arctan2(toward[:, 1], toward[:, 0]),
        outer_angle=np.arctan2(balls.place[:, 1], balls.place[:, 0]),
    )


def _at(place: Array, given: _Given, lengths: tuple[float, float]) -> _PushedBalls:
    """The balls at a place, (m, 2)."""
    inner = _contact(given.span - place, lengths[0], given.inner_stiffness)
    outer = _contact(place, lengths[1], given.outer_stiffness)
    work = np.sum(given.ball_force * (place - np.array([lengths[1], 0.0])), axis=-1)
    tangent = inner.tangent + outer.tangent
    rounded = PLACE_ROUND_OFF * sum(lengths)  # of a place; a contact with a smaller approach may come out as none
    smallest = np.maximum(given.inner_stiffness, given.outer_stiffness) * rounded**1.5
    return _PushedBalls(
        place=place,
        energy=inner.energy + outer.energy - work,
        gradient=outer.force - inner.force - given.ball_force,
        tangent=tangent,
        tolerance=rounded * np.trace(tangent, axis1=-2, axis2=-1)
        + PLACE_ROUND_OFF * (inner.load + outer.load)
        + smallest,
        energy_rounding=ENERGY_ROUND_OFF * (inner.load * lengths[0] + outer.load * lengths[1]),
        longest_step=np.full(len(place), lengths[1]),
        given=given,
        inner=inner,
        outer=outer,
    )


def _contact(vector: Array, natural_length: float, stiffness: Array) -> _Spring:
    """A contact spring that is stretched to a vector, (m, 2)."""
    length = np.hypot(*vector.T)
    normal = vector / length[:, None]
    approach = np.maximum(length - natural_length, 0.0)
    root = np.sqrt(approach)
    load = stiffness * approach * root
    return _Spring(
        load=load,
        force=load[:, None] * normal,
        tangent=contact_tangent(1.5 * stiffness * root, load / length, normal),
        energy=0.4 * load * approach,
    )


def in_series(inner: Array, outer: Array) -> Array:
    """Tangent of two contact springs with the ball between them, (..., 2, 2), N/m.

    A force too small to press a ball in leaves it free: then both springs are slack, and so are two in a row.
    """
    both = inner + outer
    slack = np.trace(both, axis1=-2, axis2=-1) == 0
    return inner @ np.linalg.solve(both + slack[..., None, None] * np.eye(2), outer)


def contact_tangent(normal_stiffness: Array, side_stiffness: Array, normal: Array) -> Array:
    """Tangent of a spring, N/m: its own stiffness along the normal, load over length at right angles to it."""
    outer_product = normal[..., :, None] * normal[..., None, :]
    return (
        side_stiffness[..., None, None] * np.eye(2)
        + (normal_stiffness - side_stiffness)[..., None, None] * outer_product
    )
