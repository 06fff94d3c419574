"""One ball between the grooves of two rings: what it takes to hold the inner groove where it is.

The plane through the bearing axis and the ball has two directions: radial (outward) and axial. V runs from the outer
groove's centre of curvature to the inner one's; it is A0 = r_gi + r_go - D long where both races just touch the ball,
and the ball carries load where it is longer. A contact angle is that of the vector from the outer groove's centre to
the ball, or from the ball to the inner groove's centre, against the radial direction, with the sign of its axial part.
A contact is a spring Q = K delta^1.5 of a held stiffness K along its line of centres. The elastic energy is then convex
in V, and so is what remains after the ball has settled under a force of its own.
Source: A. B. Jones, J. Basic Eng. 82 (1960) 309-320, and T. A. Harris and M. N. Kotzalas, Advanced Concepts of Bearing
Technology, 5th ed. (2007), section 3 (neither seen: the balance is that of the forces on the ball).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.errors import ConvergenceError
from analytic.scene import Array, Bearing

# The error that a Newton step leaves is below the step's power 1.5 (of the approach): round-off below this.
LAST_STEP = 1e-10
PLACE_ROUND_OFF = 4 * np.finfo(np.float64).eps  # of the distance between ball and groove centre
# A ball takes 4 to 10 steps; each that overshoots the least energy is halved.
MOST_STEPS = 200
LEAST_DESCENT = 1e-4  # of what the slope promises: Armijo's customary share
ENERGY_ROUND_OFF = 16 * np.finfo(np.float64).eps  # of load times the distance whose rounding moves it


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
    across = radial - play  # beyond A0
    length = np.hypot(distance + across, axial)
    approach = (across * (2 * distance + across) + axial**2) / (length + distance)  # |V| - A0, small against both
    softness_inner, softness_outer = inner_stiffness ** (-2 / 3), outer_stiffness ** (-2 / 3)
    approach = np.maximum(approach, 0.0)
    stiffness = (softness_inner + softness_outer) ** -1.5
    load = stiffness * approach * np.sqrt(approach)
    normal = np.stack([distance + across, axial], axis=-1) / length[..., None]
    angle = np.arctan2(axial, distance + across)
    still = BallBalance(
        energy=0.4 * load * approach,
        force=load[..., None] * normal,
        tangent=_spring(1.5 * stiffness * np.sqrt(approach), load / length, normal),
        inner_load=load,
        outer_load=load,
        inner_angle=angle,
        outer_angle=angle,
    )
    moved = np.any(ball_force != 0, axis=-1)
    if not np.any(moved):
        return still
    outer_length = bearing.outer.groove_radius - bearing.ball_radius
    pushed = _pushed_ball(
        span=normal[moved] * length[moved][:, None],
        start=normal[moved] * (outer_length + softness_outer[moved] * np.cbrt(load[moved]) ** 2)[:, None],
        lengths=(bearing.inner.groove_radius - bearing.ball_radius, outer_length),
        stiffnesses=(inner_stiffness[moved], outer_stiffness[moved]),
        touching=load[moved] > 0,
        ball_force=ball_force[moved],
    )
    fields = {name: value.copy() for name, value in vars(still).items()}
    for name, value in vars(pushed).items():
        fields[name][moved] = value
    return BallBalance(**fields)


def _pushed_ball(
    *,
    span: Array,
    start: Array,
    lengths: tuple[float, float],
    stiffnesses: tuple[Array, Array],
    touching: NDArray[np.bool_],
    ball_force: Array,
) -> BallBalance:
    """Balls under a force of their own, by Newton on the convex energy of the ball's place; arrays over m balls.

    span : V, (m, 2);  start : the ball from the outer groove's centre, (m, 2), if it had no force
    lengths : r_gi - r and r_go - r, m;  touching : whether that ball carries load; if not, its force leads it outward
    """
    push = np.hypot(*ball_force.T)
    sunk = (push / stiffnesses[1]) ** (2 / 3)  # into the outer race by that force alone
    led = ball_force / push[:, None] * (lengths[1] + sunk)[:, None]
    place = np.where(touching[:, None], start, led)
    least = 1e-9 * push / sunk  # N/m: keeps a step finite where no race touches
    reference = np.array([lengths[1], 0.0])

    def at(place: Array) -> tuple[Array, Array, tuple[Array, Array, Array], tuple[Array, Array, Array]]:
        inner = _contact(span - place, lengths[0], stiffnesses[0])
        outer = _contact(place, lengths[1], stiffnesses[1])
        work = np.sum(ball_force * (place - reference), axis=-1)
        return inner[3] + outer[3] - work, outer[1] - inner[1] - ball_force, inner[:3], outer[:3]

    energy, gradient, inner, outer = at(place)
    for _ in range(MOST_STEPS):
        curvature = inner[2] + outer[2] + least[:, None, None] * np.eye(2)
        step = -np.linalg.solve(curvature, gradient[..., None])[..., 0]
        step *= np.minimum(1.0, lengths[1] / np.maximum(np.hypot(*step.T), 1e-300))[:, None]
        slope = np.sum(gradient * step, axis=-1)
        rounding = ENERGY_ROUND_OFF * (inner[0] * lengths[0] + outer[0] * lengths[1])
        share = np.ones(len(step))
        while True:
            trial = at(place + share[:, None] * step)
            short = trial[0] > energy + LEAST_DESCENT * share * slope + rounding
            if not np.any(short):
                break
            share = np.where(short, share / 2, share)
        place = place + share[:, None] * step
        energy, gradient, inner, outer = trial
        approach = (outer[0] / stiffnesses[1]) ** (2 / 3)
        stopped = np.hypot(*step.T) <= LAST_STEP * np.maximum(approach, sunk)
        noise = PLACE_ROUND_OFF * lengths[1] * np.trace(inner[2] + outer[2], axis1=-2, axis2=-1)  # N
        if np.all(stopped | (np.hypot(*gradient.T) <= noise)):
            break
    else:
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=float(np.max(np.hypot(*gradient.T))),
            tolerance=float(LAST_STEP * np.max(push)),
            problem="a ball between its races",
            remedy="Check the speed and the ball's mass for a slipped unit.",
        )
    weaker = np.linalg.solve(inner[2] + outer[2], outer[2])
    toward = np.where(inner[0][:, None] > 0, span - place, span)
    return BallBalance(
        energy=energy,
        force=inner[1],
        tangent=inner[2] @ weaker,  # two springs in a row
        inner_load=inner[0],
        outer_load=outer[0],
        inner_angle=np.arctan2(toward[:, 1], toward[:, 0]),
        outer_angle=np.arctan2(place[:, 1], place[:, 0]),
    )


def _contact(vector: Array, natural_length: float, stiffness: Array) -> tuple[Array, Array, Array, Array]:
    """(load, force, tangent, energy) of a contact spring stretched to a vector, (m, 2)."""
    length = np.hypot(*vector.T)
    normal = vector / length[:, None]
    approach = np.maximum(length - natural_length, 0.0)
    root = np.sqrt(approach)
    load = stiffness * approach * root
    return (
        load,
        load[:, None] * normal,
        _spring(1.5 * stiffness * root, load / length, normal),
        0.4 * load * approach,
    )


def _spring(along: Array, across: Array, normal: Array) -> Array:
    """Tangent of a spring, N/m: its own stiffness along the normal, load over length across it."""
    outer_product = normal[..., :, None] * normal[..., None, :]
    return across[..., None, None] * np.eye(2) + (along - across)[..., None, None] * outer_product
