"""The compiled rotation of a free ball; `analytic.free_ball.rotation` says what it solves.

Rates are per unit ring speed w, so slip is a length and an inertia carries w^2. One contact is a row of numbers
(`analytic.free_ball.layout`). The nodes of a quadrature lie on strips along rolling, at y = b sin(angle), where the
pressure is smooth.
"""

import numpy as np

from analytic.free_ball.layout import (
    ACROSS,
    ALONG,
    BALL_RADIUS,
    FLEXIBILITY,
    FRICTION,
    INERTIA,
    LAW_POWER,
    LOAD,
    MOST_STEPS,
    NORMAL_R,
    NORMAL_Z,
    ORBIT_RADIUS,
    POWER,
    RADIUS,
    RING,
    ROLLING,
    SPIN_POWER,
    TRANSVERSE,
    UNIT_POWER,
)
from analytic.free_ball.stress import yielding
from analytic.free_ball.strips import (
    LATERAL,
    SLIDE,
    Quadrature,
    hold_flows,
    march_strips,
    marched_strip,
    peak_pressure,
    shear_at,
    strip_closed,
    strip_state,
)
from analytic.numerics.compilation import compiled
from analytic.scene import Array

LEAST_TANGENT = 1e-14  # of the trace of the tangent
LEAST_SHARE = 1e-4  # of a Newton step
ROUND_OFF = 4 * np.finfo(np.float64).eps  # of the speeds
HARDER = 10.0  # between two stages of a ball whose Newton's method stalls
STAGES = 6
FAST = frozenset(("contract", "reassoc", "arcp", "nsz"))  # sums over the nodes may round in any order


@compiled
def _rows_of(contact: Array, ball: Array, y: float, rows: Array) -> float:
    """Write what the velocity of a ball does to the slip on a strip; returns what its ring does along the strip.

    y : of the strip across the groove, m;  rows : (3, 4) by slip along the strip, across it and by spin
    """
    n_r, n_z, size = contact[NORMAL_R], contact[NORMAL_Z], ball[BALL_RADIUS]
    depth = size - y * y / (2.0 * contact[RADIUS])
    rows[0, 2], rows[0, 3] = (-depth * n_z - y * n_r) / size, (depth * n_r - y * n_z) / size
    rows[1, 1] = -depth / size
    return contact[RING] * (ball[ORBIT_RADIUS] + depth * n_r - y * n_z)


@compiled(inline=True)
def _add(width, forces, stiffness, rows, force, tangent):
    """Add A^T f to the force and A^T S A to the tangent; A : rows, whose other fields are 0."""
    along_2, along_3, across, spin_2, spin_3 = rows[0, 2], rows[0, 3], rows[1, 1], rows[2, 2], rows[2, 3]
    force[0] += width * forces[0]
    force[1] += width * forces[1] * across
    force[2] += width * (forces[0] * along_2 + forces[2] * spin_2)
    force[3] += width * (forces[0] * along_3 + forces[2] * spin_3)
    for c in range(4):
        pulled = (0.0, 0.0, 0.0)  # column c of S A
        if c == 0:
            pulled = (stiffness[0], stiffness[3], stiffness[6])
        elif c == 1:
            pulled = (stiffness[1] * across, stiffness[4] * across, stiffness[7] * across)
        else:
            along, spin = rows[0, c], rows[2, c]
            pulled = (
                stiffness[0] * along + stiffness[2] * spin,
                stiffness[3] * along + stiffness[5] * spin,
                stiffness[6] * along + stiffness[8] * spin,
            )
        tangent[0, c] += width * pulled[0]
        tangent[1, c] += width * pulled[1] * across
        tangent[2, c] += width * (pulled[0] * along_2 + pulled[2] * spin_2)
        tangent[3, c] += width * (pulled[0] * along_3 + pulled[2] * spin_3)


@compiled(fastmath=FAST)
def _contact(contact, ball, velocity, passing, quadrature, flows, sums):
    """Add one contact to sums: forces A^T stress and their tangent; write its outcome, without the law's powers.

    passing : velocity of the surfaces through the contact, m per unit w, with its sign;  flows : of `hold_flows`
    """
    sines, cosines, weights = quadrature.across[0], quadrature.across[1], quadrature.across[2]
    force, tangent, outcome, rows = sums
    a, b = contact[ROLLING], contact[TRANSVERSE]
    peak = peak_pressure(contact)
    spin = _spin(contact, ball, velocity)
    flow = 1.0 if passing >= 0.0 else -1.0
    length = contact[FLEXIBILITY] * abs(passing) * (a if quadrature.marched else peak)
    outcome[:] = 0.0
    rows[2, 2], rows[2, 3] = contact[NORMAL_R] / ball[BALL_RADIUS], contact[NORMAL_Z] / ball[BALL_RADIUS]
    state = strip_state(sines.shape[0])
    if quadrature.marched:
        for j in range(sines.shape[0]):
            carried = _rows_of(contact, ball, b * sines[j], rows)
            state[SLIDE + j] = velocity[0] + rows[0, 2] * velocity[2] + rows[0, 3] * velocity[3] - carried
            state[LATERAL + j] = rows[1, 1] * velocity[1]
        march_strips(contact, spin, (flow, length), quadrature, flows, state)
    for j in range(sines.shape[0]):
        y = b * sines[j]
        carried = _rows_of(contact, ball, y, rows)
        slide = velocity[0] + rows[0, 2] * velocity[2] + rows[0, 3] * velocity[3] - carried
        slip = (slide, rows[1, 1] * velocity[1], spin)
        strip = (a * cosines[j], flow, peak * cosines[j], length)
        if quadrature.marched:
            forces, stiffness, friction = marched_strip(state, j)
        else:
            forces, stiffness, friction = strip_closed(contact, slip, strip, quadrature.along, flows[j])
        width = weights[j] * b * cosines[j]
        _add(width, forces, stiffness, rows, force, tangent)
        outcome[ALONG] -= width * forces[0]
        outcome[ACROSS] -= width * forces[1]
        outcome[POWER] += width * (forces[0] * slide + forces[1] * slip[1] + forces[2] * spin)
        outcome[SPIN_POWER] += width * (forces[2] - forces[0] * y) * spin
        outcome[FRICTION] += width * friction


@compiled
def _add_law_powers(contact, ball, velocity, quadrature, flows, rows, outcome):
    """Write the power of the law of traction at the slip without creep, and that of a friction coefficient of 1."""
    sines, cosines, weights = quadrature.across[0], quadrature.across[1], quadrature.across[2]
    peak, spin = peak_pressure(contact), _spin(contact, ball, velocity)
    for j in range(sines.shape[0]):
        carried = _rows_of(contact, ball, contact[TRANSVERSE] * sines[j], rows)
        slide = velocity[0] + rows[0, 2] * velocity[2] + rows[0, 3] * velocity[3] - carried
        width, half = weights[j] * contact[TRANSVERSE] * cosines[j], contact[ROLLING] * cosines[j]
        for k in range(quadrature.along.shape[1]):
            pressure = peak * cosines[j] * quadrature.along[1, k]
            across = rows[1, 1] * velocity[1] + spin * half * quadrature.along[0, k]
            size = np.sqrt(slide * slide + across * across)
            stress, _ = yielding(size, shear_at(contact, pressure, flows[j, 0, k], flows[j, 1, k]))
            area = width * half * quadrature.along[1, k] * quadrature.along[2, k]
            outcome[LAW_POWER] += area * stress * size
            outcome[UNIT_POWER] += area * pressure * size


@compiled
def _spin(contact: Array, ball: Array, velocity: Array) -> float:
    turns = contact[NORMAL_R] * velocity[2] + contact[NORMAL_Z] * velocity[3]
    return turns / ball[BALL_RADIUS] - contact[RING] * contact[NORMAL_Z]


@compiled(inline=True)
def _passing(contact, ball, velocity):
    """Mean velocity of both surfaces through the contact, m per unit w, along the orbit."""
    orbit = velocity[0] / ball[ORBIT_RADIUS]
    turns = -contact[NORMAL_Z] * velocity[2] + contact[NORMAL_R] * (velocity[3] - ball[BALL_RADIUS] * orbit)
    passes = (contact[RING] - orbit) * (ball[ORBIT_RADIUS] + ball[BALL_RADIUS] * contact[NORMAL_R])
    return (turns + passes) / 2.0


@compiled
def _hold(contact, force, tangent):
    """Leave a ball that one race touches one freedom, its speed of rolling there, which leaves no force along rolling.

    Nothing drives it round its orbit or holds its axis: it keeps both, as the cage and its own inertia would have it.
    """
    t_r, t_z = -contact[NORMAL_Z], contact[NORMAL_R]
    moment = t_r * force[2] + t_z * force[3]
    stiffness = t_r * (t_r * tangent[2, 2] + t_z * tangent[2, 3]) + t_z * (t_r * tangent[3, 2] + t_z * tangent[3, 3])
    force[0] = force[1] = 0.0
    force[2], force[3] = moment * t_r, moment * t_z
    tangent[:] = 0.0
    for c in range(4):
        tangent[c, c] = stiffness


@compiled
def _residual(contacts, ball, velocity, passing, quadrature, flows, sums):
    """What the ball's equilibrium lacks and its tangent, into sums, with outcomes; returns the sum of all friction.

    A ball that one race alone touches only rolls on it: see `_hold`.
    """
    force, tangent, outcome, rows = sums
    force[:] = 0.0
    tangent[:] = 0.0
    for race in range(2):
        if contacts[race, LOAD] > 0.0:
            of_race = (force, tangent, outcome[race], rows)
            _contact(contacts[race], ball, velocity, passing[race], quadrature, flows[race], of_race)
        else:
            outcome[race, :] = 0.0
    gyro = ball[INERTIA] / ball[ORBIT_RADIUS]
    force[1] += gyro * velocity[0] * velocity[2]
    force[2] -= gyro * velocity[0] * velocity[1]
    tangent[1, 0] += gyro * velocity[2]
    tangent[1, 2] += gyro * velocity[0]
    tangent[2, 0] -= gyro * velocity[1]
    tangent[2, 1] -= gyro * velocity[0]
    if contacts[0, LOAD] == 0.0 or contacts[1, LOAD] == 0.0:
        _hold(contacts[0] if contacts[0, LOAD] > 0.0 else contacts[1], force, tangent)
        outcome[0, ACROSS] = outcome[1, ACROSS] = 0.0
    return outcome[0, FRICTION] + outcome[1, FRICTION]


@compiled
def _roll(contact, ball, velocity):
    """Let a ball roll on one race without slip at the contact's centre: a start for what `_hold` leaves it."""
    n_r, n_z = contact[NORMAL_R], contact[NORMAL_Z]
    slide = velocity[0] - n_z * velocity[2] + n_r * velocity[3]
    slide -= contact[RING] * (ball[ORBIT_RADIUS] + ball[BALL_RADIUS] * n_r)
    velocity[2] += n_z * slide
    velocity[3] -= n_r * slide


@compiled(inline=True)
def _solved(matrix, right):
    """The solution of a system of four by elimination with pivots; both are overwritten."""
    for column in range(4):
        best = column
        for row in range(column + 1, 4):
            if abs(matrix[row, column]) > abs(matrix[best, column]):
                best = row
        if best != column:
            for c in range(4):
                matrix[column, c], matrix[best, c] = matrix[best, c], matrix[column, c]
            right[column], right[best] = right[best], right[column]
        for row in range(column + 1, 4):
            factor = matrix[row, column] / matrix[column, column]
            right[row] -= factor * right[column]
            for c in range(column, 4):
                matrix[row, c] -= factor * matrix[column, c]
    for column in range(3, -1, -1):
        for c in range(column + 1, 4):
            right[column] -= matrix[column, c] * right[c]
        right[column] /= matrix[column, column]


@compiled
def _newton(contacts, ball, velocity, passing, nodes, tolerance, outcome):
    """Damped Newton's method; the velocity is overwritten. Returns the residual over all friction.

    nodes : the quadrature, and its flows on both races
    A step counts where the simplified Newton step from its end is shorter [Deuflhard2004]: forces along the orbit and
    moments of spin differ so much in stiffness that no norm of the residual serves both.
    """
    quadrature, flows = nodes
    force, tangent, rows = np.zeros(4), np.zeros((4, 4)), np.zeros((3, 4))
    trial, trial_force, trial_tangent = np.zeros(4), np.zeros(4), np.zeros((4, 4))
    step, next_step = np.zeros(4), np.zeros(4)
    here, there = (force, tangent, outcome, rows), (trial_force, trial_tangent, outcome, rows)
    friction = _residual(contacts, ball, velocity, passing, quadrature, flows, here)
    if friction == 0.0:
        return 0.0
    share = 1.0
    for _ in range(MOST_STEPS):
        if np.sqrt(np.sum(force * force)) <= tolerance * friction:
            break
        held = LEAST_TANGENT * (tangent[0, 0] + tangent[1, 1] + tangent[2, 2] + tangent[3, 3])
        for c in range(4):
            tangent[c, c] += held
            step[c] = -force[c]
        _solved(tangent.copy(), step)
        length = np.sqrt(np.sum(step * step))
        if length <= ROUND_OFF * ball[ORBIT_RADIUS]:  # the size of any speed per unit ring speed
            return 0.0  # no double is nearer: contacts so small that they creep by less than a rounding of the speed
        share = min(1.0, 4.0 * share)
        while True:
            for c in range(4):
                trial[c] = velocity[c] + share * step[c]
            tried = _residual(contacts, ball, trial, passing, quadrature, flows, there)
            for c in range(4):
                next_step[c] = -trial_force[c]
            _solved(tangent.copy(), next_step)
            if np.sqrt(np.sum(next_step * next_step)) <= (1.0 - share / 4.0) * length or share < LEAST_SHARE:
                break
            share *= 0.5
        if share < LEAST_SHARE:
            _residual(contacts, ball, velocity, passing, quadrature, flows, here)  # not the trial's
            break
        for c in range(4):
            velocity[c], force[c] = trial[c], trial_force[c]
            for d in range(4):
                tangent[c, d] = trial_tangent[c, d]
        friction = tried
    return np.sqrt(np.sum(force * force)) / friction


@compiled
def turn_ball(
    contacts: Array, ball: Array, velocity: Array, quadrature: Quadrature, tolerance: float, outcome: Array
) -> float:
    """Turn a ball to where no moment and no force along the orbit is left on it; returns the residual.

    contacts : (2, CONTACT);  ball : (BALL,);  velocity : (4,) start, overwritten;  outcome : (2, OUTCOME)
    tolerance : on the residual, over all friction of the ball
    The speed of the surfaces through each contact is that of the start. Where Newton's method stalls, softer surfaces
    come first: they creep as if the speed through the contact were higher.
    """
    passing = np.zeros(2)
    flows = np.empty((2, quadrature.across.shape[1], 2, quadrature.along.shape[1]))
    for race in range(2):
        passing[race] = _passing(contacts[race], ball, velocity)
        if contacts[race, LOAD] > 0.0:
            hold_flows(contacts[race], quadrature, flows[race])
    if contacts[0, LOAD] == 0.0 or contacts[1, LOAD] == 0.0:
        _roll(contacts[0] if contacts[0, LOAD] > 0.0 else contacts[1], ball, velocity)
    start = velocity.copy()
    left = _newton(contacts, ball, velocity, passing, (quadrature, flows), tolerance, outcome)
    if left > tolerance:
        for c in range(4):
            velocity[c] = start[c]
        softer = HARDER**STAGES
        for _ in range(STAGES + 1):
            left = _newton(contacts, ball, velocity, softer * passing, (quadrature, flows), tolerance, outcome)
            softer /= HARDER
    return left


@compiled
def add_law_powers(contacts: Array, ball: Array, velocity: Array, quadrature: Quadrature, outcome: Array) -> None:
    """Add to outcomes what the law of traction loses at the slip of a ball without creep; arguments of `turn_ball`."""
    rows, flows = np.zeros((3, 4)), np.empty((quadrature.across.shape[1], 2, quadrature.along.shape[1]))
    for race in range(2):
        if contacts[race, LOAD] > 0.0:
            hold_flows(contacts[race], quadrature, flows)
            _add_law_powers(contacts[race], ball, velocity, quadrature, flows, rows, outcome[race])
