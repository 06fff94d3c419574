"""The compiled rotation of a free ball; `analytic.free_ball.rotation` says what it solves.

Rates are per unit ring speed w, so slip is a length and an inertia carries w^2. The nodes of a quadrature lie on strips
along rolling, at y = b sin(angle), where the pressure is smooth.
"""

import numpy as np

from analytic.free_ball.stress import FAST, yielding, yielding_by_own
from analytic.free_ball.strips import (
    LATERAL,
    SLIDE,
    SPIN,
    clear_strips,
    hold_flows,
    march_strips,
    marched_strip,
    peak_pressure,
    shear_at,
)
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record, Records
from analytic.scene import Array

LEAST_TANGENT = 1e-14  # of the trace of the tangent
LEAST_SHARE = 1e-4  # of a Newton step
MOST_STEPS = 100  # of Newton's method
ROUND_OFF = 4 * np.finfo(np.float64).eps  # of the speeds
HARDER = 10.0  # between two stages of a ball whose Newton's method stalls
STAGES = 6


@compiled
def _slip(contact: Record, ball: Record, velocity: Array, y: float, rows: Array) -> tuple[float, float, float]:
    """Slip along a strip, across it and by spin; writes (3, 4) of it by the velocity of the ball.

    y : of the strip across the groove, m
    """
    n_r, n_z, size = contact.normal_radial, contact.normal_axial, ball.radius
    depth, bend = size - y * y / (2.0 * contact.radius), y / contact.radius
    rows[0, 2], rows[0, 3] = (-depth * n_z - y * n_r) / size, (depth * n_r - y * n_z) / size
    rows[1, 1] = -1.0
    rows[2, 2], rows[2, 3] = (n_r - bend * n_z) / size, (n_z + bend * n_r) / size
    slide = velocity[0] + rows[0, 2] * velocity[2] + rows[0, 3] * velocity[3]
    slide -= contact.ring_rate * (ball.orbit_radius + depth * n_r - y * n_z)
    spin = rows[2, 2] * velocity[2] + rows[2, 3] * velocity[3] - contact.ring_rate * (n_z + bend * n_r)
    return slide, rows[1, 1] * velocity[1], spin


@compiled
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


@compiled
def clear(contact):
    """Begin the sums of a contact."""
    contact.along = contact.across = contact.power = contact.spin_power = contact.friction = 0.0
    contact.law_power = contact.unit_power = 0.0


@compiled(fastmath=FAST)
def _contact(contact, ball, motion, quadrature, flows, sums, scratch):
    """Add one contact to sums: forces A^T stress and their tangent; write what it does, without the law's powers.

    motion : velocity of the ball, and that of the surfaces through the contact, m per unit w, with its sign
    flows : of `hold_flows`
    """
    velocity, passing = motion
    sines, cosines, weights = quadrature.across[0], quadrature.across[1], quadrature.across[2]
    force, tangent = sums
    rows, state = scratch.rows, scratch.strips
    a, b = contact.semi_axis_rolling, contact.semi_axis_transverse
    _, _, spin_at_middle = _slip(contact, ball, velocity, 0.0, rows)
    flow = 1.0 if passing >= 0.0 else -1.0
    length = contact.flexibility * abs(passing) * a
    clear(contact)
    clear_strips(state, quadrature.strips)
    for j in range(quadrature.strips):
        state[SLIDE + j], state[LATERAL + j], state[SPIN + j] = _slip(contact, ball, velocity, b * sines[j], rows)
    march_strips(contact, (flow, length, contact.lean), quadrature, flows, state)
    for j in range(quadrature.strips):
        y = b * sines[j]
        slip = _slip(contact, ball, velocity, y, rows)
        forces, stiffness, friction = marched_strip(state, j)
        width = weights[j] * b * cosines[j]
        _add(width, forces, stiffness, rows, force, tangent)
        contact.along -= width * forces[0]
        contact.across -= width * forces[1]
        contact.power += width * (forces[0] * slip[0] + forces[1] * slip[1] + forces[2] * slip[2])
        contact.spin_power += width * (forces[2] - forces[0] * y) * spin_at_middle
        contact.friction += width * friction


@compiled
def _add_law_powers(contact, ball, velocity, quadrature, flows, rows):
    """Write the power of the law of traction at the slip without creep, and that of a friction coefficient of 1."""
    sines, cosines, weights = quadrature.across[0], quadrature.across[1], quadrature.across[2]
    peak = peak_pressure(contact)
    for j in range(quadrature.strips):
        slide, lateral, spin = _slip(contact, ball, velocity, contact.semi_axis_transverse * sines[j], rows)
        width, half = weights[j] * contact.semi_axis_transverse * cosines[j], contact.semi_axis_rolling * cosines[j]
        for k in range(quadrature.nodes):
            pressure = peak * cosines[j] * quadrature.along[1, k]
            across = lateral + spin * half * quadrature.along[0, k]
            size = np.sqrt(slide * slide + across * across)
            shear = shear_at(contact, pressure, flows[k, 0, j], flows[k, 1, j], flows[k, 2, j])
            stress, _ = yielding(size, shear) if contact.own == 0.0 else yielding_by_own(size, shear, contact.own)
            area = width * half * quadrature.along[1, k] * quadrature.along[2, k]
            contact.law_power += area * stress * size
            contact.unit_power += area * pressure * size


@compiled
def _passing(contact, ball, velocity):
    """Mean velocity of both surfaces through the contact, m per unit w, along the orbit."""
    orbit = velocity[0] / ball.orbit_radius
    turns = -contact.normal_axial * velocity[2] + contact.normal_radial * (velocity[3] - ball.radius * orbit)
    passes = (contact.ring_rate - orbit) * (ball.orbit_radius + ball.radius * contact.normal_radial)
    return (turns + passes) / 2.0


@compiled
def _hold(contact, force, tangent):
    """Leave a ball that one race touches one freedom, its speed of rolling there, which leaves no force along rolling.

    Friction neither drives it round its orbit nor holds its axis: it keeps both, which `turned` gives it.
    """
    t_r, t_z = -contact.normal_axial, contact.normal_radial
    moment = t_r * force[2] + t_z * force[3]
    stiffness = t_r * (t_r * tangent[2, 2] + t_z * tangent[2, 3]) + t_z * (t_r * tangent[3, 2] + t_z * tangent[3, 3])
    force[0] = force[1] = 0.0
    force[2], force[3] = moment * t_r, moment * t_z
    for i in range(4):
        for c in range(4):
            tangent[i, c] = stiffness if i == c else 0.0


@compiled
def _residual(contacts, ball, velocity, passing, quadrature, sums, scratch):
    """What the ball's equilibrium lacks and its tangent, into sums; returns the sum of all friction.

    A ball that one race alone touches only rolls on it: see `_hold`.
    """
    force, tangent = sums
    for i in range(4):
        force[i] = 0.0
        for c in range(4):
            tangent[i, c] = 0.0
    for race in range(2):
        if contacts[race].load > 0.0:
            motion = velocity, passing[race]
            _contact(contacts[race], ball, motion, quadrature, scratch.flows[race], sums, scratch)
        else:
            clear(contacts[race])
    gyro = ball.inertia / ball.orbit_radius
    force[1] += gyro * velocity[0] * velocity[2]
    force[2] -= gyro * velocity[0] * velocity[1]
    tangent[1, 0] += gyro * velocity[2]
    tangent[1, 2] += gyro * velocity[0]
    tangent[2, 0] -= gyro * velocity[1]
    tangent[2, 1] -= gyro * velocity[0]
    if contacts[0].load == 0.0 or contacts[1].load == 0.0:
        _hold(contacts[0] if contacts[0].load > 0.0 else contacts[1], force, tangent)
        contacts[0].across = contacts[1].across = 0.0
    return contacts[0].friction + contacts[1].friction


@compiled
def _roll(contact, ball, velocity):
    """Let a ball roll on one race without slip at the contact's centre: a start for what `_hold` leaves it."""
    n_r, n_z = contact.normal_radial, contact.normal_axial
    slide = velocity[0] - n_z * velocity[2] + n_r * velocity[3]
    slide -= contact.ring_rate * (ball.orbit_radius + ball.radius * n_r)
    velocity[2] += n_z * slide
    velocity[3] -= n_r * slide


@compiled
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
def _copy(source, target):
    """Copy four numbers."""
    for i in range(4):
        target[i] = source[i]


@compiled
def _size(vector):
    """Of four numbers."""
    return np.sqrt(vector[0] ** 2 + vector[1] ** 2 + vector[2] ** 2 + vector[3] ** 2)


@compiled
def _simplified_step(tangent, force, system, step):
    """Write Newton's step, and return its length; system : (4, 4), overwritten"""
    for i in range(4):
        step[i] = -force[i]
        for c in range(4):
            system[i, c] = tangent[i, c]
    _solved(system, step)
    return _size(step)


@compiled
def _newton(contacts, ball, velocity, passing, quadrature, tolerance, scratch):
    """Damped Newton's method; the velocity is overwritten. Returns the residual over all friction.

    scratch : with the flows on both races
    A step counts where the simplified Newton step from its end is shorter [Deuflhard2004]: forces along the orbit and
    moments of spin differ so much in stiffness that no norm of the residual serves both.
    """
    force, tangent, trial = scratch.force, scratch.tangent, scratch.trial
    trial_force, trial_tangent = scratch.trial_force, scratch.trial_tangent
    system, step, next_step = scratch.system, scratch.step, scratch.next_step
    here, there = (force, tangent), (trial_force, trial_tangent)
    friction = _residual(contacts, ball, velocity, passing, quadrature, here, scratch)
    if friction == 0.0:
        return 0.0
    share, left = 1.0, _size(force)
    for _ in range(MOST_STEPS):
        if left <= tolerance * friction:
            break
        held = LEAST_TANGENT * (tangent[0, 0] + tangent[1, 1] + tangent[2, 2] + tangent[3, 3])
        for c in range(4):
            tangent[c, c] += held
        length = _simplified_step(tangent, force, system, step)
        if length <= ROUND_OFF * ball.orbit_radius:  # the size of any speed per unit ring speed
            return 0.0  # no double is nearer: contacts so small that they creep by less than a rounding of the speed
        share = min(1.0, 4.0 * share)
        while True:
            for i in range(4):
                trial[i] = velocity[i] + share * step[i]
            tried = _residual(contacts, ball, trial, passing, quadrature, there, scratch)
            next_length = _simplified_step(tangent, trial_force, system, next_step)
            if next_length <= (1.0 - share / 4.0) * length or share < LEAST_SHARE:
                break
            share *= 0.5
        if share < LEAST_SHARE:
            _residual(contacts, ball, velocity, passing, quadrature, here, scratch)  # not the trial's
            break
        _copy(trial, velocity)
        _copy(trial_force, force)
        for i in range(4):
            for c in range(4):
                tangent[i, c] = trial_tangent[i, c]
        friction, left = tried, _size(force)
    return _size(force) / friction


@compiled
def turn_ball(contacts: Records, ball: Record, quadrature: Record, tolerance: float, scratch: Record) -> float:
    """Turn a ball to where no moment and no force along the orbit is left on it; returns the residual.

    contacts : (2,) of `state.CONTACT_STATE`;  ball.velocity : start, overwritten
    tolerance : on the residual, over all friction of the ball;  scratch : of `state.SCRATCH`, overwritten
    The speed of the surfaces through each contact is that of the start. Where Newton's method stalls, softer surfaces
    come first: they creep as if the speed through the contact were higher.
    """
    velocity, passing, start = scratch.velocity, scratch.passing, scratch.start
    _copy(ball.velocity, velocity)
    for race in range(2):
        passing[race] = _passing(contacts[race], ball, velocity)
        if contacts[race].load > 0.0:
            hold_flows(contacts[race], quadrature, scratch.flows[race])
    if contacts[0].load == 0.0 or contacts[1].load == 0.0:
        _roll(contacts[0] if contacts[0].load > 0.0 else contacts[1], ball, velocity)
    _copy(velocity, start)
    left, softer = np.inf, 1.0
    for stage in range(STAGES + 2):
        if stage == 1:
            _copy(start, velocity)
            softer = HARDER**STAGES
        elif stage > 1:
            softer /= HARDER
        for race in range(2):
            scratch.softer[race] = softer * passing[race]
        left = _newton(contacts, ball, velocity, scratch.softer, quadrature, tolerance, scratch)
        if stage == 0 and left <= tolerance:
            break
    _copy(velocity, ball.velocity)
    return left


@compiled
def add_law_powers(contacts: Records, ball: Record, quadrature: Record, scratch: Record) -> None:
    """Add what the law of traction loses at the slip of a ball without creep; arguments of `turn_ball`."""
    velocity, flows = scratch.velocity, scratch.flows
    _copy(ball.velocity, velocity)
    for race in range(2):
        if contacts[race].load > 0.0:
            hold_flows(contacts[race], quadrature, flows[race])
            _add_law_powers(contacts[race], ball, velocity, quadrature, flows[race], scratch.rows)
